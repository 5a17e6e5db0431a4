#!/usr/bin/env python3
"""Checks that code for one instruction set can't be taken for another's.

usage: isa_symbols.py OBJECT...     each as OBJECT=LANES, compiled for an instruction set with so many lanes

The linker keeps one copy of a function that several objects define, and may keep that of an object which not every machine can run. So what such an
object defines for others must have the lane type in its name. Prints each symbol that does not; status 1 when there is any.
"""
import subprocess
import sys

OWN = "passes()"  # the one function that is meant to be called from elsewhere


def strangers(listing, lanes):
    """The defined symbols of a listing of `nm` that are visible to the linker and name no lane type of that width."""
    names = (line.split(maxsplit=2) for line in listing.splitlines())
    visible = [n[2] for n in names if len(n) == 3 and n[1] in "TtWwVuDBR" and n[1] != "t"]
    marks = (f"Lanes<{lanes}>", f"LaneMask<{lanes}>", OWN)
    return [n for n in visible if not any(mark in n for mark in marks)]


def main(arguments):
    if not arguments:
        print(__doc__)
        return 2
    bad = 0
    for argument in arguments:
        path, lanes = argument.rsplit("=", 1)
        listing = subprocess.run(["nm", "--demangle", "--defined-only", path], check=True, capture_output=True, text=True).stdout
        if not listing:
            print(f"{path}: no symbols")
            bad += 1
        for name in strangers(listing, lanes):
            print(f"{path}: {name}")
            bad += 1
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
