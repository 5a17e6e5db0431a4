#!/usr/bin/env python3
"""Mutation testing: small faults are put into src/, and the tests must notice them. A fault that no test notices is a survivor: it is
equivalent to the original, or a test is missing.

    ./dev mutate                        400 mutants of all folders
    ./dev mutate solver geometry        those folders alone
    ./dev mutate --again out/mutants.json --status survived      the same mutants anew, after tests were added

It works in a copy of the project (build/mutate/), never in the source tree. All mutants are compiled into one build, in which the
environment variable CAROM_MUTANT turns one on (tools/mutants.hpp); tools/mutants.py writes the source. A mutant that does
not compile is left out and counted. Each test is run once to see how long it takes and which mutants it reaches; then
each mutant is run against the tests that reach it, the fastest first, until one fails, crashes or hangs. Tests of golden
hashes come last and are counted apart, since they notice every change and say little about it.
"""
import argparse
import json
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import mutants as mutations

ROOT = Path(__file__).resolve().parent.parent
PROGRAMS = ["unit_tests", "analytic_tests", "regression_tests", "memory_tests", "profile_tests", "fuzz_tests"]
HASHES = "determinism_tests"
#: Of the other programs, what compares with a number that some version of the engine gave.
HASH_TEST = re.compile("SameBitsEverywhere")
#: Checks and test helpers, and what the build has no part of.
LEFT_OUT = re.compile(r"_test\.|/check_state\.|/random_shapes\.|/backend_(chrome|tracy)\.")
FAILURE = re.compile(r"^\[  FAILED  \] ([\w./]+)", re.MULTILINE)
ERROR = re.compile(r"^([^\s:]+):(\d+):(?:\d+:)? (?:fatal )?error:", re.MULTILINE)
MENTION = re.compile(r"^(?:In file included from )?\s*([^\s:]+):(\d+)(?::\d+)?:.*required|^([^\s:]+):(\d+):", re.MULTILINE)
STATUSES = ["killed", "killed by hashes", "survived", "not reached"]
#: What does not compile, or compiles to the original: in a constant expression, or where the mutated expression has no meaning.
NOT_TRIED = "no mutant"


@dataclass
class Test:
    program: str
    name: str
    seconds: float = 0
    reaches: set = field(default_factory=set)


def folder_of(mutant):
    return mutant.file.split("/")[1]


class Copy:
    """The project in build/mutate/tree. Files that are the same keep their time, so that what was built stays."""

    def __init__(self, root, place):
        self.root, self.tree, self.build = root, place, place / "build/release"

    def refresh(self):
        listed = subprocess.run(["git", "-C", str(self.root), "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                                check=True, capture_output=True).stdout.decode().split("\0")
        files = {name for name in listed if name and (self.root / name).is_file()}
        for old in self.tree.rglob("*") if self.tree.exists() else []:
            name = str(old.relative_to(self.tree))
            if old.is_file() and not name.startswith(("build/", "src/mutants.hpp")) and name not in files:
                old.unlink()
        for name in files:
            if not name.startswith("src/") or "_test" in name:
                self.write(name, (self.root / name).read_bytes())
        self.write("src/mutants.hpp", (self.root / "tools/mutants.hpp").read_bytes())
        options = "\ntarget_compile_options(carom PRIVATE -w -Wno-error -Wno-narrowing -fpermissive -O1)\n"
        self.write("src/CMakeLists.txt", (self.root / "src/CMakeLists.txt").read_bytes() + options.encode())

    def write(self, name, content):
        path = self.tree / name
        if path.is_file() and path.read_bytes() == content:
            return
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)

    def write_mutants(self, sources, found):
        by_file = {}
        for mutant in found:
            by_file.setdefault(mutant.file, []).append(mutant)
        for name, source in sources.items():
            text = source
            if name in by_file:
                text = mutations.written(source, by_file[name], "mutants.hpp", name.endswith(".hpp"))
            self.write(name, text.encode())

    def make(self, targets):
        if not (self.build / "build.ninja").is_file():
            subprocess.run(["cmake", "--preset", "release", "-DCAROM_BUILD_GALLERY=OFF"], cwd=self.tree, check=True,
                           stdout=subprocess.DEVNULL)
        return subprocess.run(["cmake", "--build", str(self.build), "--target", *targets, "--", "-k", "0"], cwd=self.tree,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")


def read_sources(root):
    return {str(path.relative_to(root)): path.read_text() for path in sorted((root / "src").rglob("*"))
            if path.suffix in (".cpp", ".hpp") and "_test" not in path.name}


def choose(sources, options):
    """The mutants to try, numbered from 1."""
    choice = random.Random(options.seed)
    found = []
    for name, source in sources.items():
        if not LEFT_OUT.search(name) and (not options.folders or name.split("/")[1] in options.folders):
            found += mutations.Finder(name, source, choice).find()
    possible = len(found)
    if options.again:
        wanted = {entry["key"] for entry in json.loads(Path(options.again).read_text())["mutants"]
                  if not options.status or entry["status"] in options.status}
        found = unlimited(sources, wanted)
    else:
        found = mutations.sample(found, options.mutants, choice, folder_of)
    for number, mutant in enumerate(found, 1):
        mutant.number = number
    choice.shuffle(found)
    return found, possible


def unlimited(sources, wanted):
    """The mutants with these keys, whatever the seed chose for their place."""
    found = {}
    for seed in range(40):
        for name, source in sources.items():
            if any(key.startswith(name + "|") for key in wanted - found.keys()):
                for mutant in mutations.Finder(name, source, random.Random(seed)).find():
                    if mutant.key() in wanted:
                        found.setdefault(mutant.key(), mutant)
    for key in sorted(wanted - found.keys()):
        print(f"no longer in the source: {key}", file=sys.stderr)
    return list(found.values())


def blamed(output, found, build, tree):
    """The mutants on the lines that a compiler's errors name; without any, on those that it mentions as the way there."""
    def at(pattern):
        lines = set()
        for match in pattern.finditer(output):
            path, line = match.group(1) or match.group(3), match.group(2) or match.group(4)
            lines.add((os.path.relpath((build / path).resolve(), tree.resolve()), int(line)))
        return [mutant for mutant in found if any((mutant.file, mutant.line + offset) in lines for offset in (0, 1))]
    return at(ERROR) or at(MENTION)


def build_all(copy, sources, found, targets):
    """Builds, and leaves out what does not compile. @return the mutants that are in, and those that are not"""
    left, rejected = list(found), []
    for _ in range(12):
        copy.write_mutants(sources, left)
        result = copy.make(targets)
        if result.returncode == 0:
            return left, rejected
        bad = blamed(result.stdout, left, copy.build, copy.tree)
        if not bad:
            raise SystemExit(result.stdout[-5000:] + "\nThe copy does not build, and no mutant is to blame.")
        numbers = {mutant.number for mutant in bad}
        print(f"{len(bad)} mutants do not compile and are left out", flush=True)
        rejected += bad
        left = [mutant for mutant in left if mutant.number not in numbers]
    raise SystemExit("The copy still does not build.")


def limit_memory():
    os.nice(15)
    resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


class Tests:
    def __init__(self, copy, slowest):
        self.copy, self.slowest = copy, slowest
        self.scratch = copy.tree.parent / "reached"
        self.failing = []
        self.possible = set()

    def run(self, program, names, mutant, timeout, more=None):
        """@return the status of the program (None when it hung) and its output"""
        filters = self.scratch / f"filter-{os.getpid()}-{mutant}-{time.monotonic_ns()}"
        filters.write_text("--gtest_filter=" + ":".join(names) + "\n")
        command = [str(self.copy.build / "bin" / program), f"--gtest_flagfile={filters}", "--gtest_fail_fast", "--gtest_brief=1"]
        process = subprocess.Popen(command, cwd=self.scratch, env=os.environ | {"CAROM_MUTANT": str(mutant)} | (more or {}),
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT, preexec_fn=limit_memory, start_new_session=True)
        try:
            output = process.communicate(timeout=timeout)[0]
            return process.returncode, output.decode(errors="replace")
        except subprocess.TimeoutExpired:
            os.killpg(process.pid, 9)
            process.communicate()
            return None, ""
        finally:
            filters.unlink()

    def list(self, program):
        text = subprocess.run([str(self.copy.build / "bin" / program), "--gtest_list_tests", "--gtest_filter=-*Slow*"], check=True,
                              capture_output=True, text=True).stdout
        suite = ""
        for line in text.splitlines():
            name = line.split("#")[0].strip()
            if line.startswith(" "):
                yield Test(program, suite + name)
            elif name.endswith("."):
                suite = name

    def measure(self, program, jobs):
        """Each test alone: its time, and what it reaches. What fails without a mutant, or takes too long, is left out."""
        self.scratch.mkdir(parents=True, exist_ok=True)
        with ThreadPoolExecutor(jobs) as pool:
            return [test for test in pool.map(self._measure, list(self.list(program))) if test]

    def _measure(self, test):
        path = self.scratch / f"reached-{abs(hash((test.program, test.name)))}"
        path.unlink(missing_ok=True)
        start = time.monotonic()
        status, _ = self.run(test.program, [test.name], -1, 6 * self.slowest, {"CAROM_MUTANT_REACHED": str(path)})
        test.seconds = time.monotonic() - start
        if status is None:
            return None
        if status != 0:
            self.failing.append(test.name)
            return None
        for line in path.read_text().splitlines() if path.exists() else []:
            number, is_reached = line.split()
            self.possible.add(int(number))
            if is_reached == "1":
                test.reaches.add(int(number))
        path.unlink(missing_ok=True)
        return test if test.seconds <= self.slowest else None

    def batches(self, tests, budget):
        """Tests of one program to run together: at first little, then more and more; in all no longer than the budget."""
        most, used, batch, spent = 0.3, 0.0, {}, 0.0
        for test in sorted(tests, key=lambda test: test.seconds):
            if spent + test.seconds > budget:
                break
            spent += test.seconds
            used += test.seconds
            batch.setdefault(test.program, []).append(test)
            if used > most:
                yield from batch.items()
                most, used, batch = 4 * most, 0.0, {}
        yield from batch.items()

    def killer(self, mutant, tests, budget):
        """What notices the mutant: a test's name, `crash` or `time`; nothing when none does."""
        for program, batch in self.batches(tests, budget):
            expected = sum(test.seconds for test in batch)
            status, output = self.run(program, [test.name for test in batch], mutant.number, 20 + 10 * expected)
            if status is None:
                return f"time ({program})"
            if status != 0:
                failed = FAILURE.search(output)
                return failed.group(1) if failed else f"crash ({program})"
        return None


def judge(mutant, behaviour, hashes, tests, options):
    entry = {"key": mutant.key(), "number": mutant.number, "file": mutant.file, "line": mutant.line, "folder": folder_of(mutant),
             "kind": mutant.kind, "text": mutant.text, "source": mutant.source, "killer": None}
    if mutant.number not in tests.possible:
        return entry | {"status": NOT_TRIED}
    reached = [[test for test in part if mutant.number in test.reaches] for part in (behaviour, hashes)]
    entry["tests"] = len(reached[0])
    if not any(reached):
        return entry | {"status": "not reached"}
    for part, status in zip(reached, ("killed", "killed by hashes")):
        entry["killer"] = tests.killer(mutant, part, options.budget)
        if entry["killer"]:
            return entry | {"status": status}
    return entry | {"status": "survived"}


def table(entries):
    entries = [entry for entry in entries if entry["status"] != NOT_TRIED]
    folders = sorted({entry["folder"] for entry in entries})
    lines = ["| folder | tried | " + " | ".join(STATUSES) + " |", "|---|" + "---:|" * (1 + len(STATUSES))]
    for folder in [*folders, "all"]:
        mine = [entry for entry in entries if folder in (entry["folder"], "all")]
        counts = [sum(entry["status"] == status for entry in mine) for status in STATUSES]
        lines.append(f"| {folder} | {len(mine)} | " + " | ".join(map(str, counts)) + " |")
    return "\n".join(lines)


def survivors(entries):
    lines = []
    for entry in sorted(entries, key=lambda entry: (entry["file"], entry["line"])):
        if entry["status"] in ("survived", "not reached", "killed by hashes"):
            lines.append(f"{entry['file']}:{entry['line']}: {entry['kind']}: {entry['text']} ({entry['status']})\n    {entry['source']}")
    return "\n".join(lines)


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="*", help="folders of src/; all when none is given")
    parser.add_argument("--mutants", type=int, default=400, help="how many to choose")
    parser.add_argument("--seed", type=int, default=1, help="of the choice")
    parser.add_argument("--jobs", type=int, default=2, help="programs at once")
    parser.add_argument("--slowest", type=float, default=5, help="leave out tests that take longer [s]")
    parser.add_argument("--budget", type=float, default=120, help="of tests for one mutant, fastest first [s]")
    parser.add_argument("--minutes", type=float, default=1e6, help="stop then; what was not tried is not counted")
    parser.add_argument("--json", type=Path, default=ROOT / "out/mutants.json", help="where the results go")
    parser.add_argument("--again", help="results whose mutants to try anew")
    parser.add_argument("--status", action="append", help="with --again: those with this status alone; may be given several times")
    return parser.parse_args(arguments)


def main():
    options = parse_arguments(sys.argv[1:])
    end = time.monotonic() + 60 * options.minutes
    sources = read_sources(ROOT)
    unknown = set(options.folders) - {name.split("/")[1] for name in sources}
    if unknown:
        raise SystemExit(f"src/ has no folder {', '.join(sorted(unknown))}")
    found, possible = choose(sources, options)
    print(f"{len(found)} mutants of {possible} possible ones; building them", flush=True)
    copy = Copy(ROOT, ROOT / "build/mutate/tree")
    copy.refresh()
    built, rejected = build_all(copy, sources, found, [*PROGRAMS, HASHES])

    tests = Tests(copy, options.slowest)
    print("running each test once", flush=True)
    behaviour = [test for program in PROGRAMS for test in tests.measure(program, options.jobs)]
    hashes = tests.measure(HASHES, options.jobs) + [test for test in behaviour if HASH_TEST.search(test.name)]
    behaviour = [test for test in behaviour if not HASH_TEST.search(test.name)]
    print(f"{len(behaviour)} tests of behaviour ({sum(test.seconds for test in behaviour):.0f} s), {len(hashes)} of hashes", flush=True)
    for name in tests.failing:
        print(f"left out, since it fails without a mutant: {name}", flush=True)

    entries = [{"key": mutant.key(), "file": mutant.file, "line": mutant.line, "folder": folder_of(mutant), "kind": mutant.kind,
                "text": mutant.text, "source": mutant.source, "status": NOT_TRIED} for mutant in rejected]

    def judged(mutant):
        if time.monotonic() > end:
            return None
        entry = judge(mutant, behaviour, hashes, tests, options)
        print(f"{entry['status']}: {mutant.file}:{mutant.line} {mutant.kind} {mutant.text} [{entry['killer'] or ''}]", flush=True)
        return entry

    with ThreadPoolExecutor(options.jobs) as pool:
        entries += [entry for entry in pool.map(judged, built) if entry]
    options.json.parent.mkdir(parents=True, exist_ok=True)
    options.json.write_text(json.dumps({"seed": options.seed, "possible": possible, "mutants": entries}, indent=1) + "\n")
    shutil.rmtree(tests.scratch, ignore_errors=True)
    left_out = sum(entry["status"] == NOT_TRIED for entry in entries)
    print(survivors(entries), table(entries), f"{left_out} are no mutants: they do not compile, or can't differ from the original",
          f"written: {options.json}", sep="\n\n")


if __name__ == "__main__":
    main()
