#!/usr/bin/env python3
"""Makes docs/changing.jpg: dusk, dawn, fog that lifts, rain that sets in, a row each.

    python3 scripts/changing_sheet.py ENDLESS SHEET.jpg

ENDLESS is the program. Needs Pillow.
"""

import pathlib
import subprocess
import sys
import tempfile

from PIL import Image

ROWS = [
    ("Town03", "clear_sky", "afternoon", "time", 5),
    ("Town10HD", "cloudy", "night", "time", 6),
    ("Town02", "foggy,clear_sky", "morning", "weather", 2),
    ("Town10HD", "clear_sky,rainy", "afternoon", "weather", 5),
]
COLUMNS = 5
SIZE = (320, 180)


def row(endless: str, out: pathlib.Path, town: str, weathers: str, time: str, changing: str, seed: int) -> list:
    where = ["--maps", town, "--weathers", weathers, "--times", time, "--changing", changing, "--seed", str(seed)]
    how = ["--videos", "1", "--cameras-per-scene", "1", "--size", "640x360", "--fps", "8", "--layers", "rgb"]
    subprocess.run([endless, "generate", str(out), *where, *how], check=True, stdout=subprocess.DEVNULL)
    frames = sorted(out.glob("videos/*/camera_a/rgb/*.png"))
    chosen = [frames[round(i * (len(frames) - 1) / (COLUMNS - 1))] for i in range(COLUMNS)]
    return [Image.open(path).convert("RGB").resize(SIZE, Image.Resampling.LANCZOS) for path in chosen]


def main() -> None:
    endless, sheet = sys.argv[1:]
    picture = Image.new("RGB", (SIZE[0] * COLUMNS, SIZE[1] * len(ROWS)))
    with tempfile.TemporaryDirectory() as folder:
        for y, scene in enumerate(ROWS):
            for x, frame in enumerate(row(endless, pathlib.Path(folder) / str(y), *scene)):
                picture.paste(frame, (x * SIZE[0], y * SIZE[1]))
    picture.save(sheet, quality=80)


if __name__ == "__main__":
    main()
