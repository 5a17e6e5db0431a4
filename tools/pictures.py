#!/usr/bin/env python3
"""Draws the pictures of README.md with the gallery, without a display.

usage: pictures.py GALLERY FOLDER     GALLERY is the program carom-gallery, FOLDER gets the pictures
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

# Each scene at a moment at which it shows what it is about [frames of 1/60 s].
SCENES = {
    "planets": 240, "triggers": 150, "collisions": 90, "gravity": 270,
    "queries": 200, "character": 300, "chain-terrain": 240, "tiles": 150,
    "one-way": 170, "bullets": 140, "sleep": 160, "bridge": 260,
    "domino": 150, "newton-cradle": 118, "card-house": 60, "arch": 60,
    "mass-ratio": 45, "joints": 200, "ragdolls": 170, "car": 200,
}
SMALL = ["--no-panels", "--size", "960x540"]  # halved afterwards: the letters are then as small as the picture
LARGE = ["--size", "1440x810"]
WHOLE = {
    "gallery": ["--scene", "gravity", "--frames", "200", "--tab", "Times", "--show", "contacts", "--show", "impulses", *LARGE],
    "inside": ["--scene", "gravity", "--frames", "204", "--inside", "24", *LARGE],
}
QUALITY = 85  # of WebP: a tenth of PNG's bytes, and the colours stay


def draw(program, arguments, path, scale=1):
    """Runs the gallery without a display and writes its last frame, smaller by a factor."""
    environment = {**os.environ, "SDL_VIDEODRIVER": "offscreen"}
    with tempfile.TemporaryDirectory() as folder:
        shot = Path(folder, "shot.png")
        subprocess.run([program, *arguments, "--screenshot", shot], env=environment, stdout=subprocess.DEVNULL, check=True)
        with Image.open(shot) as picture:
            size = (picture.width // scale, picture.height // scale)
            picture.convert("RGB").resize(size, Image.Resampling.LANCZOS).save(path, quality=QUALITY, method=6)


def main():
    program, folder = sys.argv[1], Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    pictures = {name: ["--scene", name, "--frames", str(frames), *SMALL] for name, frames in SCENES.items()} | WHOLE
    total = 0
    for name, arguments in pictures.items():
        path = folder / f"{name}.webp"
        draw(program, arguments, path, 2 if name in SCENES else 1)
        total += path.stat().st_size
        print(f"{path}  {path.stat().st_size / 1000:.0f} kB", flush=True)
    print(f"{len(pictures)} pictures, {total / 1000:.0f} kB")


if __name__ == "__main__":
    main()
