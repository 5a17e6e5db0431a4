"""Plants includes that break a rule, each in a small tree of its own, and sees that exactly they are reported."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import check_layers


class CheckLayersTest(unittest.TestCase):
    def complaints(self, files):
        """What the check says about a tree of {path: text}."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for path, text in files.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text)
            return check_layers.check(root)

    def test_good_tree(self):
        self.assertEqual([], self.complaints({
            "include/carom/math.hpp": "#include <cmath>\n",
            "include/carom/carom.hpp": "#include <carom/math.hpp>\n",
            "src/math/lanes.hpp": "#include <immintrin.h>\n",
            "src/geometry/hull.hpp": '#include "math/lanes.hpp"\n#include <carom/math.hpp>\n',
            "src/solver/rows/a.cpp": '#include "geometry/hull.hpp"\n',
            "src/geometry/hull_test.cpp": '#include "geometry/hull.hpp"\n#include <gtest/gtest.h>\n',
            "scenes/pile.hpp": "#include <carom/carom.hpp>\n",
            "lab/run.hpp": '#include "scenes/pile.hpp"\n',
            "cli/main.cpp": '#include "lab/run.hpp"\n#include <CLI/CLI.hpp>\n',
            "tests/fuzz/hull.cpp": '#include "geometry/hull.hpp"\n',
        }))

    def test_lower_layer_must_not_use_a_higher_one(self):
        found = self.complaints({"src/geometry/a.hpp": "", "src/math/b.hpp": '#include <cmath>\n#include "geometry/a.hpp"\n'})
        self.assertEqual(1, len(found))
        self.assertIn("src/math/b.hpp:2: src/math may use only the standard library, not geometry", found[0])

    def test_neighbours_must_not_use_each_other(self):
        found = self.complaints({"src/fields/a.hpp": "", "src/solver/rows/b.cpp": '#include "fields/a.hpp"\n'})
        self.assertIn("src/solver/rows/b.cpp:1: ", found[0])

    def test_include_relative_to_the_file_is_seen(self):
        found = self.complaints({"src/geometry/a.hpp": "", "src/math/b.hpp": '#include "../geometry/a.hpp"\n'})
        self.assertIn("src/math/b.hpp:1: ", found[0])

    def test_unknown_engine_folder(self):
        found = self.complaints({"src/misc/a.hpp": "", "src/misc/b.cpp": '#include "misc/a.hpp"\n'})
        self.assertIn("src/misc is not a layer", found[0])

    def test_private_header_stays_in_the_engine(self):
        tree = {"src/world/a.hpp": ""}
        for user in ("include/carom/x.hpp", "scenes/x.cpp", "lab/x.cpp", "cli/x.cpp"):
            with self.subTest(user):
                self.assertIn(f"{user}:1: ", self.complaints({**tree, user: '#include "world/a.hpp"\n'})[0])

    def test_scenes_must_not_use_the_laboratory(self):
        found = self.complaints({"lab/a.hpp": "", "scenes/b.cpp": '#include "lab/a.hpp"\n'})
        self.assertIn("scenes/b.cpp:1: ", found[0])

    def test_files_stand_below_the_programs_and_beside_the_engine(self):
        self.assertEqual([], self.complaints({"files/a.hpp": "", **{f"{user}/b.cpp": '#include "files/a.hpp"\n' for user in ("lab", "cli", "gallery")}}))
        for user in ("src/world", "scenes"):
            with self.subTest(user):
                self.assertIn(f"{user}/b.cpp:1: ", self.complaints({"files/a.hpp": "", f"{user}/b.cpp": '#include "files/a.hpp"\n'})[0])
        self.assertEqual(1, len(self.complaints({"scenes/a.hpp": "", "files/b.cpp": '#include "scenes/a.hpp"\n'})))

    def test_engine_uses_no_library(self):
        found = self.complaints({"src/world/a.cpp": "#include <boost/math.hpp>\n"})
        self.assertIn("src/world/a.cpp:1: ", found[0])

    def test_only_the_adapter_of_a_library_knows_it(self):
        include = "#include <tracy/TracyC.h>\n"
        self.assertEqual([], self.complaints({"src/profile/backend_tracy.cpp": include}))
        self.assertEqual(1, len(self.complaints({"src/profile/backend_chrome.cpp": include})))
        self.assertEqual(1, len(self.complaints({"src/profile/backend_tracy.cpp": "#include <gtest/gtest.h>\n"})))

    def test_missing_file(self):
        self.assertIn("no file", self.complaints({"src/world/a.cpp": '#include "world/b.hpp"\n'})[0])

    def test_circle_of_files(self):
        found = self.complaints({"src/math/a.hpp": '#include "math/b.hpp"\n', "src/math/b.hpp": '#include "math/a.hpp"\n'})
        self.assertEqual(["files include each other in a circle: src/math/a.hpp -> src/math/b.hpp -> src/math/a.hpp"], found)

    def test_circle_of_folders(self):
        found = self.complaints({
            "src/math/a.hpp": '#include "geometry/b.hpp"\n', "src/math/c.hpp": "",
            "src/geometry/b.hpp": "", "src/geometry/d.hpp": '#include "math/c.hpp"\n',
        })
        self.assertIn("folders include each other in a circle: src/geometry -> src/math -> src/geometry", found)


if __name__ == "__main__":
    unittest.main()
