#!/usr/bin/env python3
"""Checks that every #include follows the layers: a folder may use only what lies below it, and nothing goes in a circle.

usage: check_layers.py [ROOT]     prints file:line and the broken rule; status 1 when there is any
"""
import re
import sys
from pathlib import Path

# What each folder builds on. It may use that, and whatever that builds on, and <carom/...>.
ENGINE = {
    "memory": [],
    "profile": ["memory"],
    "jobs": ["profile"],
    "math": [],
    "geometry/kernels": ["math"],
    "geometry/isa": ["geometry/kernels"],
    "geometry": ["math", "geometry/isa"],
    "broadphase": ["geometry", "memory", "jobs", "profile"],
    "dynamics": ["broadphase"],
    "solver/kernels": ["math"],
    "solver/isa": ["solver/kernels"],
    "solver/rows": ["dynamics", "solver/isa"],
    "solver/joints": ["solver/rows"],
    "solver/continuous": ["dynamics"],
    "fields/kernels": ["math"],
    "fields/isa": ["fields/kernels"],
    "fields": ["dynamics", "fields/isa"],
    "state": ["solver/joints", "solver/continuous", "fields"],
    "edit": ["state"],
    "step": ["edit"],
    "snapshot": ["step"],
    "api": ["snapshot"],
}
# Folders outside the engine: which top folders their includes may name. "include" stands for <carom/...>.
PROGRAMS = {
    "include": ["include"],
    "files": ["files"],
    "support": ["support"],
    "scene_file": ["include", "files", "support", "scene_file"],
    "scenes": ["include", "support", "scenes"],
    "lab": ["include", "files", "support", "scene_file", "scenes", "lab"],
    "cli": ["include", "files", "support", "scene_file", "scenes", "lab", "cli"],
    "gallery": ["include", "files", "support", "scene_file", "scenes", "lab", "gallery"],
    "tests": ["include", "src", "files", "support", "scene_file", "scenes", "lab", "cli", "gallery", "tests"],
}
# These may use no other library than the standard one, and the compilers' headers for SIMD.
STANDARD_ONLY = {"include", "src", "support", "scenes", "files"}
# This one deals with the operating system: POSIX too.
POSIX_TOO = {"files"}
# But for one file a library, which is built only when that library is asked for.
ADAPTERS = {"src/profile/backend_tracy.cpp": "tracy/"}
SIMD_HEADERS = {"emmintrin.h", "immintrin.h", "arm_neon.h", "wasm_simd128.h"}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def layer_of(path):
    """The layer of a file in src/: its folder, or the folder and the one below where that is a layer of its own."""
    below = "/".join(path.parts[1:3])
    return below if below in ENGINE else path.parts[1]


def builds_on(folder):
    """All engine folders below this one."""
    below = set(ENGINE[folder])
    return below.union(*(builds_on(f) for f in below))


def includes_of(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        if match := INCLUDE.match(line):
            yield number, match[1] == "<", match[2]


def resolve(root, path, is_angled, name):
    """The file of this project that an include names, relative to the root, or None when it is a library's."""
    if is_angled:
        return Path("include", name) if name.startswith("carom/") else None
    for base in (path.parent, root / "src", root):
        if (base / name).is_file():
            return (base / name).resolve().relative_to(root.resolve())
    return None


def broken_rule(source, is_angled, name, target):
    """Why `source` may not include `target`, or None when it may."""
    top = source.parts[0]
    is_test = top == "tests" or source.stem.endswith("_test")
    if target is None:
        if not is_angled:
            return f'no file "{name}" in this project; a library\'s header goes in <>'
        is_standard = re.fullmatch(r"[a-z_0-9]+", name) or name in SIMD_HEADERS
        if top in POSIX_TOO and re.fullmatch(r"(sys/)?[a-z_0-9]+\.h", name):
            return None
        if name.startswith(ADAPTERS.get(source.as_posix(), "/")):
            return None
        if top in STANDARD_ONLY and not is_standard and not is_test:
            return f"{top}/ may use no other library than the standard one"
        return None
    if target.parts[0] == "include":
        return None if is_angled else "public headers are included as <carom/...>"
    if top == "src":
        layer = layer_of(source)
        if layer not in ENGINE:
            return f"src/{layer} is not a layer; add it to the table in tools/check_layers.py"
        if target.parts[0] != "src":
            return f"src/ may include only itself and <carom/...>, not {target.parts[0]}/"
        other = layer_of(target)
        if other != layer and other not in builds_on(layer) and not (is_test and source.parts[1] == target.parts[1]):
            return f"src/{layer} may use only {', '.join(sorted(builds_on(layer))) or 'the standard library'}, not {other}"
        return None
    if target.parts[0] == "src" and is_test:
        return None
    if target.parts[0] not in PROGRAMS[top]:
        allowed = ", ".join(f + "/" for f in PROGRAMS[top])
        return f"{top}/ may include only {allowed} not {target.parts[0]}/"
    return None


def find_cycle(graph):
    """Some way from a node back to itself, as a list whose ends are equal, or None."""
    done = set()

    def visit(node, way):
        if node in way:
            return way[way.index(node):] + [node]
        if node in done:
            return None
        for following in sorted(graph.get(node, ())):
            if cycle := visit(following, way + [node]):
                return cycle
        done.add(node)
        return None

    for node in sorted(graph):
        if cycle := visit(node, []):
            return cycle
    return None


def folder_of(path):
    """The layer that a file belongs to: two levels deep in src/, else one."""
    return f"src/{layer_of(path)}" if path.parts[0] == "src" else path.parts[0]


def check(root):
    """All complaints about the tree at `root`, each as one line of text."""
    complaints = []
    files, folders = {}, {}
    for top in ["src", *PROGRAMS]:
        for path in sorted((root / top).rglob("*.[ch]pp")):
            source = path.relative_to(root)
            for number, is_angled, name in includes_of(path):
                target = resolve(root, path, is_angled, name)
                if rule := broken_rule(source, is_angled, name, target):
                    complaints.append(f"{source}:{number}: {rule}")
                if target is None:
                    continue
                files.setdefault(str(source), set()).add(str(target))
                is_test = top == "tests" or source.stem.endswith("_test")
                if folder_of(source) != folder_of(target) and not is_test:
                    folders.setdefault(folder_of(source), set()).add(folder_of(target))
    for kind, graph in (("folders", folders), ("files", files)):
        if cycle := find_cycle(graph):
            complaints.append(f"{kind} include each other in a circle: {' -> '.join(cycle)}")
    return complaints


def main():
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    complaints = check(root)
    print("\n".join(complaints) if complaints else "layers: every include follows the rules")
    return 1 if complaints else 0


if __name__ == "__main__":
    sys.exit(main())
