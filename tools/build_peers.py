#!/usr/bin/env python3
"""Builds the laboratory's peers, lab/peers/, into build/peers/bin/. One that can't be built is named with the reason; the others are built all the same.

usage: build_peers.py [PEER...] [--source DIR]     status 1 when one of them is not built

--source DIR  a checkout of Box2D: builds it as a peer of its own, box2d3-source, beside that of the crate

Box2D 3 and Rapier are built by cargo, in the versions that lab/peers/rust/Cargo.lock names; Box2D 2.4 by CMake, against the library that is installed.
Each as fast as it gets: Box2D 3 by the newest clang and without assertions, as its own release build is, Rapier for processors with AVX2.
"""
import argparse
import os
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build" / "peers"
BIN = BUILD / "bin"
RUST = ROOT / "lab" / "peers" / "rust"
RUST_VERSIONS = {"box2d3": (1, 95), "rapier": (1, 86)}  # what their crates ask for


class CanNot(Exception):
    """Why a peer is not built."""


def run(command, log, environment=None):
    """Runs a command with its output in a log.

    @throws CanNot  with the end of the log when it fails
    """
    with open(log, "a", encoding="utf-8") as file:
        print("$", *command, file=file, flush=True)
        status = subprocess.run(command, cwd=ROOT, env=environment, stdout=file, stderr=subprocess.STDOUT, check=False).returncode
    if status != 0:
        end = "\n".join(log.read_text(encoding="utf-8", errors="replace").splitlines()[-15:])
        raise CanNot(f"{command[0]} failed, see {log.relative_to(ROOT)}:\n{end}")


def fresh_log(peer):
    log = BUILD / f"{peer}.log"
    log.write_text("", encoding="utf-8")
    return log


def has_avx2(cpuinfo=Path("/proc/cpuinfo")):
    return platform.machine() == "x86_64" and cpuinfo.exists() and "avx2" in cpuinfo.read_text(encoding="utf-8")


def newest_clang():
    names = [f"clang-{version}" for version in range(25, 18, -1)] + ["clang"]
    return next((name for name in names if shutil.which(name)), "cc")


def version_of(text):
    """(1, 95) of "rustc 1.95.0 (...)"; none when there is no version in it."""
    found = re.search(r"(\d+)\.(\d+)", text)
    return (int(found[1]), int(found[2])) if found else None


def require_rust(peer):
    """@throws CanNot  when there is no cargo, or a rustc that is too old"""
    if not (shutil.which("cargo") and shutil.which("rustc")):
        raise CanNot("cargo and rustc are not installed; install them by the system's package manager or by rustup")
    text = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=False).stdout.strip()
    need = RUST_VERSIONS[peer]
    if (version_of(text) or (0, 0)) < need:
        raise CanNot(f"{text or 'this rustc'} is too old: it takes {need[0]}.{need[1]} or newer, as rustup installs it")


def cargo(peer, features, log, variables=None):
    """Builds a crate and returns its program.

    @param variables  of the environment, beside its own
    """
    target = BUILD / "cargo"
    environment = os.environ | {
        "CARGO_TARGET_DIR": str(target),
        "CC": newest_clang(),
        "CFLAGS": "-O3 -DNDEBUG",
        "RUSTFLAGS": "-C target-cpu=x86-64-v3" if has_avx2() else "",
    } | (variables or {})
    manifest = ["--manifest-path", str(RUST / "Cargo.toml")]
    chosen = ["--no-default-features", "--features", " ".join(features)]
    run(["cargo", "build", "--release", "--locked", *manifest, "-p", f"carom-peer-{peer}", *chosen], log, environment)
    return target / "release" / f"carom-peer-{peer}"


def install(program, name):
    BIN.mkdir(parents=True, exist_ok=True)
    new = BIN / f".{name}.new"  # so that one that runs is replaced, not written into
    shutil.copy2(program, new)
    new.replace(BIN / name)


def build_box2d3():
    require_rust("box2d3")
    features = ["crate", *(["avx2"] if has_avx2() else [])]
    install(cargo("box2d3", features, fresh_log("box2d3")), "carom-peer-box2d3")


def build_box2d3_source(checkout):
    """Box2D as the checkout has it. Its headers become bindings by bindgen, which needs libclang."""
    require_rust("box2d3")
    folder = Path(checkout).resolve()
    if not (folder / "include" / "box2d" / "box2d.h").is_file():
        raise CanNot(f"{checkout} is no checkout of Box2D 3: it has no include/box2d/box2d.h")
    features = ["source", *(["avx2"] if has_avx2() else [])]
    log = fresh_log("box2d3-source")
    install(cargo("box2d3", features, log, {"BOX2D_SOURCE": str(folder)}), "carom-peer-box2d3-source")


def build_rapier():
    require_rust("rapier")
    log = fresh_log("rapier")
    for name, features in {"4": [], "8": ["simd8"], "4-parallel": ["parallel"], "8-parallel": ["simd8", "parallel"]}.items():
        install(cargo("rapier", features, log), f"carom-peer-rapier-{name}")
    install(BIN / "carom-peer-rapier-8", "carom-peer-rapier")  # which hands over to the one that is asked for


def build_box2d2():
    log = fresh_log("box2d2")
    run(["cmake", "--preset", "release"], log)
    targets = subprocess.run(["cmake", "--build", "--preset", "release", "--target", "help"], cwd=ROOT, capture_output=True, text=True, check=False)
    if "carom_peer_box2d2" not in targets.stdout:
        raise CanNot("CMake finds no box2d; install libbox2d-dev")
    run(["cmake", "--build", "--preset", "release", "--target", "carom_peer_box2d2"], log)
    install(ROOT / "build" / "release" / "bin" / "carom-peer-box2d2", "carom-peer-box2d2")


PEERS = {"box2d2": build_box2d2, "box2d3": build_box2d3, "rapier": build_rapier}


def chosen(arguments):
    """Functions that build, by the names of their peers."""
    parser = argparse.ArgumentParser(description="Builds the laboratory's peers.")
    parser.add_argument("peers", nargs="*", metavar="PEER", help=", ".join(PEERS))
    parser.add_argument("--source", metavar="DIR", help="a checkout of Box2D, built as the peer box2d3-source")
    wanted = parser.parse_args(arguments)
    unknown = [name for name in wanted.peers if name not in PEERS]
    if unknown:
        sys.exit(f"unknown peer: {unknown[0]}; there are {', '.join(PEERS)}")
    builds = {name: PEERS[name] for name in wanted.peers or PEERS}
    if wanted.source is not None:
        builds["box2d3-source"] = lambda: build_box2d3_source(wanted.source)
    return builds


def main(arguments):
    builds = chosen(arguments)
    BUILD.mkdir(parents=True, exist_ok=True)
    status = 0
    for name, build in builds.items():
        print(f"{name}: building", flush=True)
        try:
            build()
            print(f"{name}: built, {(BIN / f'carom-peer-{name}').relative_to(ROOT)}", flush=True)
        except CanNot as reason:
            print(f"{name}: NOT BUILT: {reason}", flush=True)
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
