#!/usr/bin/env python3
"""The laboratory from end to end: the program measures engines on scenes, and reports on them.

usage: lab_test.py CAROM [unittest's options]

The peers here are scripts that step with Carom itself, so the test knows what must come out.
"""
import json
import os
import signal
import stat
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

CAROM = ""


class LabTest(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.peers = self.folder / "peers"
        self.peers.mkdir()
        self.out = self.folder / "out"

    def tearDown(self):
        self.temporary.cleanup()

    def peer(self, name, script):
        """A peer of that name which is a script of the shell; it sees the scene as $1 and the result to write as $7."""
        file = self.peers / f"carom-peer-{name}"
        file.write_text(f"#!/bin/sh\n{script}\n", encoding="utf-8")
        file.chmod(file.stat().st_mode | stat.S_IXUSR)

    def lab(self, *arguments, status=0):
        done = subprocess.run([CAROM, "lab", *map(str, arguments)], capture_output=True, text=True, timeout=300, check=False)
        self.assertEqual(done.returncode, status, done.stderr)
        return done.stdout if status == 0 else done.stderr

    def measure(self, scenes, *more, engines="carom,box2d3,rapier,box2d2"):
        return self.lab("run", "quick", "--scenes", scenes, "--engines", engines, "--runs", 4, "--peers", self.peers, "--out", self.out, *more)

    def engines(self, case):
        return {engine["engine"]: engine for engine in case["engines"]}


class Run(LabTest):
    def test_every_engine_gets_the_same_work_and_a_place_in_the_report(self):
        self.peer("box2d3", f'exec {CAROM} lab step "$@"')
        self.peer("rapier", 'echo "has no boxes" >&2; exit 3')
        text = self.measure("stack_20", "--threads", "1,2")
        report = json.loads(self.lab("report", self.out, "--json"))
        self.assertEqual([(case["scene"], case["threads"]) for case in report["cases"]], [("stack_20", 1), ("stack_20", 2)])
        for case in report["cases"]:
            engines = self.engines(case)
            self.assertEqual({name: engine["outcome"] for name, engine in engines.items()},
                             {"carom": "done", "box2d3": "done", "rapier": "can't", "box2d2": "missing"})
            self.assertGreater(engines["carom"]["median_ms"], 0)
            self.assertEqual(engines["carom"]["quality"], engines["box2d3"]["quality"], "the same steps are judged alike")
            self.assertLess(engines["carom"]["quality"]["drift_m"], 0.1)
            low, high = engines["box2d3"]["interval"]
            self.assertLessEqual(low, engines["box2d3"]["speed_ratio"])
            self.assertLessEqual(engines["box2d3"]["speed_ratio"], high)
        self.assertEqual([(mean["suite"], mean["engine"]) for mean in report["geometric_means"]], [("all", "box2d3")] * 2)
        for words in ("has no boxes", "./dev peers", "box2d3"):
            self.assertIn(words, text)
            self.assertIn(words, (self.out / "report.md").read_text(encoding="utf-8"))
            self.assertIn(words, (self.out / "report.html").read_text(encoding="utf-8"))

    def test_rays_events_and_shots_are_measured(self):
        self.measure("rays_1000,spawn_destroy,shots", engines="carom")
        rays, spawn, shots = (self.engines(case)["carom"] for case in json.loads(self.lab("report", self.out, "--json"))["cases"])
        self.assertGreater(rays["ray_ms"], 0)
        self.assertGreater(rays["ray_hits"], 100)
        self.assertGreater(rays["median_ms"], rays["ray_ms"])
        self.assertGreater(spawn["event_ms"], 0)
        self.assertEqual(spawn["ray_ms"], 0)
        self.assertEqual(shots["quality"]["tunnelled"], 0, "Carom lets nothing through")
        self.assertNotIn("tunnelled", rays["quality"], "it is known from every step only")

    def test_instruction_sets_are_compared_and_give_the_same_bits(self):
        text = self.lab("compare", "--simd", "scalar,best", "--scenes", "stack_20", "--runs", 4, "--out", self.out)
        self.assertIn("scalar is faster by", text)
        self.assertIn("Engines: scalar 0.1.0, scalar; best 0.1.0, ", text)
        [case] = json.loads(self.lab("report", self.out, "--base", "scalar", "--json"))["cases"]
        engines = self.engines(case)
        self.assertEqual(engines["scalar"]["quality"], engines["best"]["quality"])

    def test_a_slower_engine_is_found(self):
        # Gives every step twice the time that it took.
        self.peer("box2d3", f'{CAROM} lab step "$@" && sed -i -E \'s/"step_ms":\\[[^]]*\\]/"step_ms":[\'"$(seq -s, 301 600)"\']/\' "$7"')
        self.measure("stack_20", engines="carom,box2d3")
        engine = self.engines(json.loads(self.lab("report", self.out, "--json"))["cases"][0])["box2d3"]
        self.assertEqual(engine["outcome"], "done", engine.get("reason"))
        self.assertEqual(engine["verdict"], "slower")
        self.assertGreater(engine["interval"][0], 100)

    def test_what_is_interrupted_keeps_the_scenes_that_are_done(self):
        self.peer("box2d3", f'case "$1" in *tumbler*) sleep 60;; esac; exec {CAROM} lab step "$@"')
        running = subprocess.Popen([CAROM, "lab", "run", "quick", "--scenes", "stack_20,tumbler", "--engines", "carom,box2d3", "--runs", "4",
                                    "--peers", self.peers, "--out", self.out], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        deadline = time.monotonic() + 120
        while not (self.out / "results.json").exists() and time.monotonic() < deadline:
            time.sleep(0.05)
        time.sleep(0.5)  # into the scene that takes long
        started = time.monotonic()
        running.send_signal(signal.SIGINT)
        _, errors = running.communicate(timeout=90)
        self.assertLess(time.monotonic() - started, 30, "it waits for nobody")
        self.assertNotEqual(running.returncode, 0)
        self.assertIn("interrupted", errors)
        report = json.loads(self.lab("report", self.out, "--json"))
        self.assertEqual([case["scene"] for case in report["cases"]], ["stack_20"])


    def test_one_run_at_a_time_has_a_folder(self):
        self.peer("box2d3", "touch started; sleep 60")
        waiting = subprocess.Popen([CAROM, "lab", "run", "quick", "--scenes", "stack_20", "--engines", "box2d3", "--runs", "4", "--peers", self.peers,
                                    "--out", self.out], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            deadline = time.monotonic() + 60
            while not (self.folder / "started").exists() and time.monotonic() < deadline:
                time.sleep(0.05)
            for command in (["run", "quick", "--scenes", "stack_20"], ["selfcheck"], ["history"], ["compare", CAROM, CAROM]):
                with self.subTest(command):
                    errors = self.lab(*command, "--out", self.out, status=2)
                    self.assertIn(f"another run (process {waiting.pid}) writes its results there", errors)
                    self.assertIn(str(self.out), errors)
        finally:
            waiting.kill()
            waiting.wait()
        self.peer("box2d3", f'exec {CAROM} lab step "$@"')
        self.measure("stack_20", engines="box2d3")  # a killed run locks nobody out
        self.assertEqual([path.name for path in self.out.iterdir() if path.name.startswith(".")], [], "and what it left is gone")

    def test_a_scene_that_no_engine_finished_is_a_failure(self):
        self.peer("box2d3", f'case "$1" in *tumbler*) echo "out of wood" >&2; exit 1;; esac; exec {CAROM} lab step "$@"')
        arguments = ["run", "quick", "--scenes", "stack_20,tumbler", "--engines", "box2d3", "--runs", "4", "--peers", self.peers, "--out", self.out]
        errors = self.lab(*arguments, status=1)
        self.assertIn("no engine finished tumbler, box2d3: exit status 1: out of wood", errors)
        self.assertIn("out of wood", (self.out / "report.md").read_text(encoding="utf-8"), "the report is written all the same")
        self.assertIn("no engine finished any scene", self.lab("run", "quick", "--scenes", "stack_20", "--engines", "rapier", "--runs", "4",
                                                               "--peers", self.peers, "--out", self.folder / "none", status=1))

    def test_a_result_of_another_scene_is_refused(self):
        self.peer("box2d3", f'{CAROM} lab step "$@" && sed -i \'s/"scene":"[^"]*"/"scene":"other.json"/\' "$7"')
        text = self.measure("stack_20", engines="carom,box2d3")
        self.assertIn('its result is of the scene "other.json"', text)

    def test_resuming_keeps_what_is_finished_and_says_so(self):
        self.peer("box2d3", f'echo "$1" >> {self.folder}/ran; case "$1" in *tumbler*) test -e {self.folder}/go || kill -INT $PPID;; esac; '
                            f'exec {CAROM} lab step "$@"')
        arguments = ["lab", "run", "quick", "--scenes", "stack_20,tumbler", "--engines", "box2d3", "--runs", "4", "--peers", self.peers,
                     "--out", self.out]

        def run(*more):
            (self.folder / "ran").write_text("", encoding="utf-8")
            done = subprocess.run([CAROM, *map(str, arguments), *more], capture_output=True, text=True, timeout=300, check=False)
            return done, (self.folder / "ran").read_text(encoding="utf-8").count("\n")

        done, _ = run("--resume")
        self.assertIn("--resume: nothing is kept: there are no results", done.stderr)
        self.assertNotEqual(done.returncode, 0)
        (self.folder / "go").touch()
        done, ran = run("--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("--resume: kept 1 of 2: stack_20", done.stderr)
        self.assertEqual(ran, 4, "the scene that was not finished, four times")
        report = json.loads(self.lab("report", self.out, "--json"))
        self.assertEqual([case["scene"] for case in report["cases"]], ["stack_20", "tumbler"])
        done, ran = run("--resume")
        self.assertIn("kept 2 of 2", done.stderr)
        self.assertEqual(ran, 0)

        arguments[arguments.index("4")] = "5"
        before = (self.out / "results.json").read_text(encoding="utf-8")
        done, ran = run("--resume")
        self.assertIn('--resume: nothing is kept: the number of runs was "4" and is "5"', done.stderr)
        self.assertEqual(ran, 10)
        self.assertEqual((self.out / "results.previous.json").read_text(encoding="utf-8"), before)


class SelfCheck(LabTest):
    def test_what_is_planted_is_found(self):
        # Large enough to be found on a busy machine; whether equals show a difference there is for the statistics' own tests.
        done = subprocess.run([CAROM, "lab", "selfcheck", "--scene", "stack_20", "--tries", "1", "--runs", "6", "--slowdown", "9",
                               "--out", self.out], capture_output=True, text=True, timeout=300, check=False)
        self.assertIn("A slowdown of 900% was found", done.stdout, done.stderr)
        self.assertIn("of 1 tries", (self.out / "selfcheck.txt").read_text(encoding="utf-8"))


class Compare(LabTest):
    def test_two_programs_and_then_their_folders(self):
        text = self.lab("compare", CAROM, CAROM, "--scenes", "stack_20", "--runs", 4, "--out", self.out)
        self.assertIn("stack_20", text)
        engines = self.engines(json.loads(self.lab("report", self.out, "--base", "A", "--json"))["cases"][0])
        self.assertEqual(set(engines), {"A", "B"})
        self.assertIn("no difference", self.lab("compare", self.out, self.out))

    def test_a_program_that_is_none_is_told(self):
        broken = self.folder / "broken"
        broken.write_text("#!/bin/sh\nexit 1\n", encoding="utf-8")
        broken.chmod(0o755)
        text = self.lab("compare", CAROM, broken, "--scenes", "stack_20", "--runs", 4, "--out", self.out)
        self.assertIn("exit status 1", text)


if __name__ == "__main__":
    CAROM = os.path.abspath(sys.argv.pop(1))
    unittest.main()
