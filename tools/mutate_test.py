"""Mutants of small sources: which are found, and that each changes what the compiled program does and nothing else does."""
import os
import random
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import mutants
import mutate


def found(source, seed=1):
    return mutants.Finder("src/part/file.cpp", source, random.Random(seed)).find()


def texts(source):
    return [mutant.text for mutant in found(source)]


class FindsTest(unittest.TestCase):
    def test_operators(self):
        self.assertIn("== -> !=", texts("bool f(int a) { return a == 3; }"))
        self.assertIn("+ -> -", texts("int f(int a) { return a + b; }"))
        self.assertIn("&& -> ||", texts("bool f() { return a && b; }"))
        self.assertIn("!x -> x", texts("bool f() { return !a; }"))
        self.assertIn("-x -> x", texts("int f() { return -a; }"))
        self.assertIn("std::min -> std::max", texts("int f() { return std::min(a, b); }"))
        self.assertIn("+= -> -=", texts("void f() { a += b; }"))

    def test_statements_and_conditions(self):
        self.assertIn("g(a); -> (nothing)", texts("void f() { g(a); }"))
        self.assertIn("a.b[2] = c; -> (nothing)", texts("void f() { a.b[2] = c; }"))
        self.assertIn("continue; -> (nothing)", texts("void f() { for (;;) continue; }"))
        self.assertIn("if (x) -> if (!x)", texts("void f() { if (a) g(); }"))

    def test_named_constants(self):
        self.assertEqual(["tuned constant"], [mutant.kind for mutant in found("constexpr float slop = 0.005f;")])

    def test_what_is_no_code_of_a_run_is_left_alone(self):
        for source in ("// a == b\n", "#define A a + b\n", 'const char* s = "a && b";\n', "static_assert(a == b);\n",
                       "void f() { assert(a < b); }\n", "template <int N = 3>\nstruct A;\n", "std::vector<std::vector<int>> v;\n",
                       "enum class E { A = 1 };\n", "int f(A&& a, const B& b, C* c);\n", "A(const A&) = delete;\n"):
            self.assertEqual([], texts(source), source)

    def test_a_declaration_is_no_statement(self):
        self.assertNotIn("statement", [mutant.kind for mutant in found("void f() { const int a = b; int c(d); A e; }")])

    def test_a_mutant_keeps_its_name_when_lines_come_above_it(self):
        source = "bool f(int a) { return a == 3; }\n"
        self.assertEqual([mutant.key() for mutant in found(source)], [mutant.key() for mutant in found("\n\n" + source)])

    def test_the_sample_is_the_same_for_a_seed_and_leaves_out_no_folder(self):
        all_found = found("bool f(int a) { return a == 3; }\n" * 50)
        few = mutants.Finder("src/few/file.cpp", "int g(int a) { return a + 1; }\n").find()
        samples = [mutants.sample(all_found + few, 20, random.Random(4), mutate.folder_of) for _ in range(2)]
        self.assertEqual(*samples)
        self.assertEqual({"part", "few"}, {mutate.folder_of(mutant) for mutant in samples[0]})


PROGRAM = """
#include <cstdlib>
#include <cstdio>
namespace {
constexpr float limit = 2.0f;
int calls = 0;
void call() { ++calls; }
struct Vec { float x, y; };
Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
bool both(bool a, bool b, bool c) { return a && b || c; }
constexpr int next(int a) { return a + 1; }
int larger(int a, int b) { return std::max(a, b); }
bool below(float a) { if (a < limit) call(); else return false; return !(a >= limit); }
}
int main() {
    static_assert(next(1) == 2);
    int sum = 0;
    for (int i = 0; i < 3; ++i) sum += next(i);
    const Vec v = Vec{1, 2} + Vec{3, 5};
    std::printf("%d %d%d%d%d %d %d%d %g %g\\n", sum, both(true, true, false), both(true, false, false), both(false, true, true),
                both(false, false, false), larger(3, -4), below(2), below(1), v.x, v.y);
    return calls;
}
"""


@unittest.skipUnless(shutil.which("g++"), "needs g++")
class RunsTest(unittest.TestCase):
    def test_each_mutant_changes_the_program_when_it_is_on_and_none_when_all_are_off(self):
        source = PROGRAM.replace("#include <cstdlib>", "#include <algorithm>\n#include <cstdlib>")
        all_found = found(source)
        for number, mutant in enumerate(all_found, 1):
            mutant.number = number
        with tempfile.TemporaryDirectory() as folder:
            place = Path(folder)
            shutil.copy(Path(__file__).parent / "mutants.hpp", place)
            original = self.build(place, "original", source)
            mutated = self.build(place, "mutated", mutants.written(source, all_found, "mutants.hpp"))
            expected = self.run_with(original, 0)
            self.assertEqual(expected, self.run_with(mutated, 0))
            same = [mutant.text for mutant in all_found if self.run_with(mutated, mutant.number) == expected]
            # Some are equal: a bound that this program does not come to, or a number that nothing depends on.
            self.assertLessEqual(len(same), len(all_found) // 5, same)
            reached = place / "reached"
            self.run_with(mutated, -1, CAROM_MUTANT_REACHED=str(reached))
            lines = [line.split() for line in reached.read_text().splitlines()]
            self.assertGreater(len([number for number, is_reached in lines if is_reached == "1"]), len(all_found) * 3 // 4)

    def build(self, place, name, source):
        (place / f"{name}.cpp").write_text(source)
        subprocess.run(["g++", "-std=c++20", "-w", "-fpermissive", "-o", str(place / name), str(place / f"{name}.cpp")], check=True)
        return place / name

    def run_with(self, program, number, **more):
        done = subprocess.run([str(program)], env=os.environ | {"CAROM_MUTANT": str(number)} | more, capture_output=True, timeout=20)
        return done.returncode, done.stdout


class JudgesTest(unittest.TestCase):
    def test_tests_run_fastest_first_and_within_the_budget(self):
        tests = mutate.Tests(mutate.Copy(Path("."), Path(".")), 5)
        some = [mutate.Test("slow", "c", 3), mutate.Test("fast", "a", 0.1), mutate.Test("fast", "b", 0.3), mutate.Test("slow", "d", 9)]
        batches = [(program, [test.name for test in batch]) for program, batch in tests.batches(some, 5)]
        self.assertEqual([("fast", ["a", "b"]), ("slow", ["c"])], batches)

    def test_a_compilers_message_names_the_mutants_of_its_line(self):
        source = "int a = b;\nbool f(int a) { return a == 3; }\n"
        message = "../../src/part/file.cpp:2:25: error: no\n"
        blamed = mutate.blamed(message, found(source), Path("/x/build/release"), Path("/x"))
        self.assertEqual(len(found(source)), len(blamed))
        self.assertEqual([], mutate.blamed("../../src/part/file.cpp:5:1: error: no\n", found(source), Path("/x/build/release"), Path("/x")))

    def test_the_table_counts_by_folder(self):
        entries = [{"folder": "a", "status": "killed"}, {"folder": "a", "status": "survived"}, {"folder": "b", "status": "not reached"},
                   {"folder": "b", "status": mutate.NOT_TRIED}]
        self.assertIn("| a | 2 | 1 | 0 | 1 | 0 |", mutate.table(entries))
        self.assertIn("| all | 3 | 1 | 0 | 1 | 1 |", mutate.table(entries))


if __name__ == "__main__":
    unittest.main()
