#!/usr/bin/env python3
"""Runs the whole of `carom lab history` on a small scene, and holds what it wrote against what must be true of its versions.

usage: history_test.py CAROM
"""
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

STEPS = 300  # allocations are counted in the second half, when the world no longer grows
RUNS = 4
VERSIONS = ["BruteForce", "QuadtreeNaive", "QuadtreeWithSet", "Quadtree", "Tree"]


class History(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.folder.cleanup)
        command = [CAROM, "lab", "history", "--size", "200", "--steps", str(STEPS), "--runs", str(RUNS), "--out", cls.folder.name]
        cls.printed = subprocess.run(command, check=True, capture_output=True, text=True, timeout=300).stdout
        cls.history = json.loads(cls.read("history.json"))
        cls.versions = {v["broad_phase"]: v for v in cls.history["versions"]}

    @classmethod
    def read(cls, name):
        return (Path(cls.folder.name) / name).read_text(encoding="utf-8")

    def test_tells_the_five_versions_in_their_order_in_every_format(self):
        self.assertEqual([v["broad_phase"] for v in self.history["versions"]], VERSIONS)
        self.assertEqual(self.read("history.txt"), self.printed)
        for text in [self.printed, self.read("history.md")]:
            words = " ".join(text.split()).replace("**", "")
            places = [words.index(f"{v['name']}: {v['what']}") for v in self.history["versions"]]
            self.assertEqual(places, sorted(places))
            for change in self.history["changes"]:
                self.assertIn(f"{change['from']} -> {change['to']}", text)
        names = [v["name"] for v in self.history["versions"]]
        self.assertEqual([(c["from"], c["to"]) for c in self.history["changes"]], list(zip(names, names[1:])))

    def test_says_where_it_comes_from(self):
        for key in ["date", "processor", "cores", "system", "compiler", "flags", "commit", "version"]:
            self.assertIn(key, self.history["origin"])
        self.assertIn(self.history["origin"]["compiler"], self.printed)

    def test_has_every_frame_of_every_run(self):
        for version in self.history["versions"]:
            self.assertEqual([len(frames) for frames in version["frames_ms"]], RUNS * [STEPS])
            for frames, frame, step in zip(version["frames_ms"], version["run_frame_ms"], version["run_step_ms"]):
                self.assertAlmostEqual(sum(frames) / STEPS, frame)
                self.assertGreater(frame, step)

    def test_gives_shares_that_fit_together(self):
        for version in self.history["versions"]:
            self.assertGreater(version["find_pairs_ms"], 0)
            self.assertGreater(version["step_ms"], version["find_pairs_ms"])
            self.assertAlmostEqual(version["step_share_of_frame"], version["step_ms"] / version["frame_ms"])
            self.assertLess(version["step_share_of_frame"], 1)
            self.assertAlmostEqual(version["find_pairs_share_of_step"], version["find_pairs_ms"] / version["step_ms"])
            self.assertGreater(version["memory_bytes"], 10_000)

    def test_tests_fewer_pairs_after_the_first_version_and_as_many_with_a_set_as_without(self):
        tested = {name: self.versions[name]["pairs_tested"] for name in VERSIONS}
        for name in VERSIONS[1:]:
            self.assertLess(tested[name], tested["BruteForce"] / 4, name)
            self.assertGreater(tested[name], 0, name)
        self.assertEqual(tested["QuadtreeWithSet"], tested["Quadtree"])

    def test_allocates_for_the_sets_alone(self):
        for name in ["BruteForce", "Quadtree", "Tree"]:
            self.assertEqual(self.versions[name]["allocations"], 0, name)
        self.assertGreater(self.versions["QuadtreeNaive"]["allocations"], 1)
        self.assertGreater(self.versions["QuadtreeWithSet"]["allocations"], 1)

    def test_tests_frames_of_one_run_and_runs(self):
        for change in self.history["changes"]:
            self.assertEqual(change["frames_of_one_run"]["degrees_of_freedom"], 2 * STEPS - 2)
            self.assertEqual(change["frames_of_runs"]["student"]["degrees_of_freedom"], 2 * RUNS - 2)
            self.assertEqual(change["steps_of_runs"]["student"]["degrees_of_freedom"], 2 * RUNS - 2)
        self.assertEqual(self.history["false_alarms"]["pairs"], len(VERSIONS) * RUNS * (RUNS - 1) // 2)


if __name__ == "__main__":
    CAROM = sys.argv.pop(1)
    unittest.main()
