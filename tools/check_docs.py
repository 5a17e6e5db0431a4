#!/usr/bin/env python3
"""Checks the documents (README.md and every other .md file) against the project.

- A ```cpp block is built against the library and run. Without main() it is the body of one.
- A ```bash block after a line `<!-- run -->` is run, in the project's root.
- A ```text block after a line `<!-- output -->` is what the block before it must print.
- A ```cmake block must stand, line for line, in a CMakeLists.txt under tests/install, where it is tested.
- A path of this repository in `backticks`, and the target of a relative link, must exist.

usage: check_docs.py --build build/release     prints file:line and what is wrong; status 1 when there is anything
"""
import argparse
import os
import re
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path

TOP_FOLDERS = "include|src|files|support|scene_file|scenes|lab|cli|gallery|tests|docs|cmake|tools|\\.ci"
REPOSITORY_PATH = re.compile(rf"`((?:{TOP_FOLDERS})/[\w./*+-]*)`")
RELATIVE_LINK = re.compile(r"\]\((?!\w+:|#)([^)#\s]+)")
COMPILE_FLAGS = ["-std=c++20", "-O1", "-ffp-contract=off"]


@dataclass
class Block:
    language: str
    line: int  # of its first line of text
    text: str
    marker: str  # the comment before it: "run", "output" or nothing
    follows: bool  # nothing but its marker stands between it and the block before


def parse(document):
    """The fenced blocks of a document, and its other lines as (number, line)."""
    blocks, prose = [], []
    inside, between, marker = None, True, ""
    for number, line in enumerate(document.splitlines(), start=1):
        fence = re.match(r"^```(\w*)", line)
        if inside is None and fence:
            inside = Block(fence[1], number + 1, "", marker, follows=not between)
        elif inside is not None and line.startswith("```"):
            blocks.append(inside)
            inside, between, marker = None, False, ""
        elif inside is not None:
            inside.text += line + "\n"
        else:
            prose.append((number, line))
            if comment := re.match(r"^<!-- (\w+) -->$", line):
                marker = comment[1]
            elif line.strip():
                between, marker = True, ""
    return blocks, prose


def whole_program(block, name):
    """A block's text as a program; the compiler's messages will name the document's lines."""
    if re.search(r"\bint main\(", block.text):
        return f'#line {block.line} "{name}"\n{block.text}'
    lines = block.text.splitlines()
    includes = [line for line in lines if line.startswith("#include")]
    body = ["" if line.startswith("#include") else line for line in lines]
    return "\n".join(["#include <carom/carom.hpp>", *includes, "int main()", "{", f'#line {block.line} "{name}"', *body, "}", ""])


class Checker:
    def __init__(self, root, build):
        self.root = root
        self.build = root / build
        libraries = [self.build / "lib" / f"lib{name}.a" for name in ("carom_lab", "carom_scenes", "carom_scene_file", "carom_files", "carom")]
        self.libraries = [str(library) for library in libraries if library.exists()]
        self.tested_cmake = [f.read_text() for f in sorted((root / "tests/install").rglob("CMakeLists.txt"))]

    def run(self, command, folder):
        """What a command prints, and what is wrong with it or None."""
        result = subprocess.run(command, cwd=folder, capture_output=True, text=True, timeout=300, check=False)
        failure = f"status {result.returncode}\n{result.stdout}{result.stderr}" if result.returncode else None
        return result.stdout, failure

    def run_cpp(self, block, name):
        with tempfile.TemporaryDirectory() as folder:
            source = Path(folder, "block.cpp")
            source.write_text(whole_program(block, name))
            includes = [f"-I{self.root / 'include'}", f"-I{self.root}"]
            program = str(Path(folder, "block"))
            command = [os.environ.get("CXX", "c++"), *COMPILE_FLAGS, *includes, str(source), "-o", program, *self.libraries]
            output, failure = self.run(command, folder)
            return (output, failure) if failure else self.run([program], folder)

    def check_block(self, block, following, name):
        """What is wrong with a block, as a list of complaints."""
        output = failure = None
        if block.language == "cpp":
            output, failure = self.run_cpp(block, name)
        elif block.language == "bash" and block.marker == "run":
            output, failure = self.run(["bash", "-euo", "pipefail", "-c", block.text], self.root)
        elif block.language == "cmake" and not any(block.text in tested for tested in self.tested_cmake):
            failure = "no CMakeLists.txt under tests/install holds these lines"
        if failure:
            return [f"{name}:{block.line}: {failure}"]
        if output is not None and following and following.marker == "output" and following.follows:
            if output.rstrip() != following.text.rstrip():
                return [f"{name}:{following.line}: the program prints\n{output.rstrip()}\nand the document says\n{following.text.rstrip()}"]
        return []

    def check_paths(self, prose, path):
        name = path.relative_to(self.root)
        complaints = []
        for number, line in prose:
            missing = [p for p in REPOSITORY_PATH.findall(line) if not any(self.root.glob(p.rstrip("/")))]
            missing += [p for p in RELATIVE_LINK.findall(line) if not (path.parent / p).exists()]
            complaints += [f"{name}:{number}: there is no {p}" for p in missing]
        return complaints

    def check(self):
        """All complaints, and how many blocks there are."""
        complaints, jobs = [], []
        for path in sorted(self.root.rglob("*.md")):
            name = path.relative_to(self.root)
            if name.parts[0] in ("build", "out") or (name.parts[0].startswith(".") and name.parts[0] != ".ci"):
                continue
            blocks, prose = parse(path.read_text(encoding="utf-8"))
            complaints += self.check_paths(prose, path)
            jobs += [(block, following, name) for block, following in zip(blocks, [*blocks[1:], None])]
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            for found in pool.map(lambda job: self.check_block(*job), jobs):
                complaints += found
        return complaints, len(jobs)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--build", required=True, help="a build folder, relative to the project's root")
    complaints, count = Checker(Path(__file__).resolve().parent.parent, arguments.parse_args().build).check()
    print("\n".join(complaints) if complaints else f"documents: {count} blocks and all paths hold")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
