#!/usr/bin/env python3
"""Runs every scene without a window, draws each into an animation and a still, and prints a table of what ran.

usage: demo.py CAROM OUT     CAROM is the program, OUT the folder for the pictures; status 1 when a scene fails
"""
import json
import subprocess
import sys
from pathlib import Path

STEPS = 600  # ten seconds at 60 Hz
ROW = "{:<24} {:>6} {:>7} {:>9} {:>13}  {:<16}  {}"


def carom(program, *arguments):
    """Runs the program and returns the JSON that it prints."""
    result = subprocess.run([program, *arguments, "--json"], stdout=subprocess.PIPE, text=True, check=True)
    return json.loads(result.stdout)


def main():
    program, out = sys.argv[1], Path(sys.argv[2])
    out.mkdir(parents=True, exist_ok=True)
    print(ROW.format("scene", "steps", "bodies", "contacts", "mean step ms", "hash", "files"), flush=True)
    failed = []
    for scene in carom(program, "scenes"):
        name = scene["name"]
        animation, still = out / f"{name}.mp4", out / f"{name}.png"
        try:
            run = carom(program, "run", name, "--steps", str(STEPS), "--animation", str(animation), "--still", str(still))
            empty = [str(f) for f in (animation, still) if not f.is_file() or f.stat().st_size == 0]
            if empty:
                raise RuntimeError(f"wrote no {' and no '.join(empty)}")
        except (subprocess.CalledProcessError, RuntimeError) as error:
            print(f"{name}: FAILED: {error}", flush=True)
            failed.append(name)
            continue
        mean = f"{run['step_ms']['mean']:.3f}"
        print(ROW.format(name, run["steps"], run["bodies"], run["contacts"], mean, run["hash"], f"{animation} {still}"), flush=True)
    if failed:
        sys.exit(f"{len(failed)} failed: {', '.join(failed)}")


if __name__ == "__main__":
    main()
