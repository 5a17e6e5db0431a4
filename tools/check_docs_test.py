"""Small documents with one fault each, and that exactly it is reported."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import check_docs


class CheckDocsTest(unittest.TestCase):
    def complaints(self, document):
        """What the check says about a project that holds this README.md, the file src/a.hpp and a tested CMake snippet."""
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for path in ("include/carom/carom.hpp", "src/a.hpp", "tests/install/x/CMakeLists.txt"):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text("find_package(carom)\n" if path.endswith(".txt") else "#pragma once\n")
            (root / "README.md").write_text(document)
            return check_docs.Checker(root, "build").check()[0]

    def test_good_document(self):
        self.assertEqual([], self.complaints(
            "See `src/a.hpp`, `src/`, `src/*.hpp`, [it](src/a.hpp#x), [there](https://example.org).\n"
            "```cpp\n#include <cstdio>\nstd::puts(\"hello\");\n```\n\n<!-- output -->\n```text\nhello\n```\n"
            "```cmake\nfind_package(carom)\n```\n```bash\nexit 1\n```\n<!-- run -->\n```bash\nls src\n```\n"))

    def test_code_that_does_not_compile_is_named_by_its_line(self):
        found = self.complaints("text\n```cpp\nint i = 0;\nnonsense;\n```\n")
        self.assertIn("README.md:4", found[0])

    def test_code_that_fails(self):
        self.assertIn("status 3", self.complaints("```cpp\nint main() { return 3; }\n```\n")[0])

    def test_wrong_output(self):
        found = self.complaints("```cpp\n#include <cstdio>\nstd::puts(\"a\");\n```\n<!-- output -->\n```text\nb\n```\n")
        self.assertIn("README.md:7: the program prints\na\nand the document says\nb", found[0])

    def test_text_that_is_no_output_is_left_alone(self):
        self.assertEqual([], self.complaints("```cpp\nint i = 0;\n```\n```text\nb\n```\n"))

    def test_failing_command(self):
        self.assertIn("README.md:3: status 1", self.complaints("<!-- run -->\n```bash\nfalse\n```\n")[0])

    def test_untested_cmake(self):
        self.assertIn("README.md:2: no CMakeLists.txt", self.complaints("```cmake\nfind_package(box2d)\n```\n")[0])

    def test_missing_path_and_link(self):
        self.assertEqual(["README.md:2: there is no src/b.hpp", "README.md:2: there is no docs/x.md"],
                         self.complaints("\nsee `src/b.hpp` and [x](docs/x.md)\n"))


if __name__ == "__main__":
    unittest.main()
