#!/usr/bin/env python3
"""Checks that without a profiler the macros of <carom/profile.hpp> leave no instruction: a function that uses all of them gives the same
assembly as one that uses none, optimised or not.

usage: macros_leave_nothing.py INCLUDE COMPILER...     INCLUDE is the folder of the public headers; status 1 when something is left
"""
import subprocess
import sys

PROGRAM = """#include <carom/profile.hpp>
#ifdef CAROM_PROFILER_ON
#error this test is for engines without a profiler
#endif
int work(int value);
int function(int value, const void* pointer, unsigned long bytes)
{
    (void)pointer;
    (void)bytes;
    %s
    return work(value) + 1;
}
"""
MACROS = (
    'CAROM_THREAD("main"); CAROM_ZONE("zone"); CAROM_PLOT("plot", work(value)); CAROM_ALLOCATED(pointer, bytes, "pool");'
    ' CAROM_FREED(pointer, "pool"); CAROM_FRAME;'
)


def assembly(compiler, include, level, body):
    command = [*compiler, "-std=c++20", level, "-Wall", "-Wextra", "-Wpedantic", "-Werror", f"-I{include}", "-S", "-x", "c++", "-", "-o", "-"]
    return subprocess.run(command, input=PROGRAM % body, capture_output=True, text=True, check=True).stdout


def main():
    include, *compiler = sys.argv[1:]
    for level in ("-O0", "-O2"):
        without, with_macros = (assembly(compiler, include, level, body) for body in ("", MACROS))
        if "work" not in without:
            sys.exit("the compiler's output is not what this test knows")
        if without != with_macros:
            sys.exit(f"at {level} the macros leave something:\n{with_macros}\nwithout them:\n{without}")
    print("the macros leave nothing")


if __name__ == "__main__":
    main()
