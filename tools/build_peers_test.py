"""Tests what of build_peers.py needs neither a compiler nor a registry."""
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import build_peers


class BuildPeers(unittest.TestCase):
    def test_versions_are_compared_as_numbers(self):
        self.assertEqual(build_peers.version_of("rustc 1.95.0 (59807616e 2026-04-14)"), (1, 95))
        self.assertLess(build_peers.version_of("rustc 1.100.1"), (2, 0))
        self.assertGreater(build_peers.version_of("rustc 1.100.1"), build_peers.RUST_VERSIONS["box2d3"])
        self.assertIsNone(build_peers.version_of("no rustc here"))

    def test_an_old_rustc_is_refused_with_what_it_takes(self):
        old = mock.Mock(stdout="rustc 1.63.0\n")
        with mock.patch.object(build_peers.shutil, "which", return_value="/usr/bin/it"), mock.patch.object(build_peers.subprocess, "run", return_value=old):
            with self.assertRaisesRegex(build_peers.CanNot, r"1\.63.* too old: it takes 1\.95"):
                build_peers.require_rust("box2d3")

    def test_a_missing_cargo_is_named(self):
        with mock.patch.object(build_peers.shutil, "which", return_value=None):
            with self.assertRaisesRegex(build_peers.CanNot, "cargo and rustc are not installed"):
                build_peers.require_rust("rapier")

    def test_one_that_fails_does_not_stop_the_others(self):
        made = []

        def fails():
            raise build_peers.CanNot("no reason")

        peers = {"first": fails, "second": lambda: made.append("second")}
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            with mock.patch.multiple(build_peers, PEERS=peers, ROOT=root, BUILD=root / "b", BIN=root / "b" / "bin"), mock.patch("builtins.print") as said:
                self.assertEqual(build_peers.main([]), 1)
        self.assertEqual(made, ["second"])
        self.assertIn("first: NOT BUILT: no reason", [call.args[0] for call in said.call_args_list])

    def test_a_checkout_is_built_beside_what_is_named(self):
        self.assertEqual(list(build_peers.chosen(["box2d3", "--source", "somewhere"])), ["box2d3", "box2d3-source"])
        self.assertEqual(list(build_peers.chosen([])), list(build_peers.PEERS))

    def test_a_folder_without_headers_is_no_checkout(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(build_peers, "require_rust"):
            with self.assertRaisesRegex(build_peers.CanNot, "is no checkout of Box2D 3"):
                build_peers.build_box2d3_source(folder)

    def test_a_failed_command_shows_the_end_of_its_log(self):
        with tempfile.TemporaryDirectory() as folder:
            log = Path(folder) / "log"
            with mock.patch.object(build_peers, "ROOT", Path(folder)):
                with self.assertRaisesRegex(build_peers.CanNot, "sh failed, see log:\n.*\nthe reason"):
                    build_peers.run(["sh", "-c", "echo the reason; exit 3"], log)


if __name__ == "__main__":
    unittest.main()
