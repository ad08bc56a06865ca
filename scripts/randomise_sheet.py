#!/usr/bin/env python3
"""Makes docs/randomise.jpg: the same scenes as they are and randomised, with their boxes drawn.

    python3 scripts/randomise_sheet.py ENDLESS SHEET.jpg

ENDLESS is the program. Needs Pillow.
"""

import json
import pathlib
import subprocess
import sys
import tempfile

from PIL import Image, ImageDraw

SCENES = [("Town03", "clear_sky", "afternoon", 2), ("Town10HD", "cloudy", "morning", 5), ("Altstadt", "clear_sky", "night", 4)]
ALL = "colours,textures,light,clutter,camera"
ROWS = [("", 0.0)] + [(part, 0.8) for part in ALL.split(",")] + [(ALL, strength) for strength in (0.3, 0.6, 1.0)]
SIZE = (384, 216)


def picture(endless: str, folder: pathlib.Path, scene: tuple, row: tuple) -> Image.Image:
    (town, weather, time, seed), (parts, strength) = scene, row
    out = folder / f"{town}_{parts}_{strength}"
    command = [endless, "generate", out, "--videos", 1, "--cameras-per-scene", 1, "--maps", town, "--weathers", weather]
    command += ["--times", time, "--seed", seed, "--size", "x".join(map(str, SIZE)), "--fps", 5, "--duration", 0.2]
    command += ["--min-pixels", 20, "--vehicles", 60, "--pedestrians", 60, "--mp4", "none"]
    command += ["--randomise", parts or "none", "--randomise-strength", strength]
    subprocess.run(list(map(str, command)), check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    camera = next(out.glob("videos/*/camera_a"))
    image = Image.open(camera / "rgb" / "000000.png").convert("RGB")
    draw = ImageDraw.Draw(image)
    for thing in json.loads((camera / "objects.jsonl").read_text().splitlines()[0])["objects"]:
        x, y, w, h = thing["bbox"]
        draw.rectangle([x, y, x + w - 1, y + h - 1], outline=(255, 60, 60))
    name = "as it is" if not parts else f"{'all' if parts == ALL else parts} {strength}"
    draw.text((5, 3), name, fill=(255, 255, 255), stroke_width=1, stroke_fill=(0, 0, 0))
    return image


def main() -> None:
    endless, path = sys.argv[1:]
    columns = 3
    tiles = []
    with tempfile.TemporaryDirectory() as folder:
        for first in range(0, len(ROWS), columns):
            for scene in SCENES:
                tiles += [picture(endless, pathlib.Path(folder), scene, row) for row in ROWS[first : first + columns]]
    (width, height), rows = SIZE, -(-len(tiles) // columns)
    sheet = Image.new("RGB", (columns * width, rows * height))
    for place, tile in enumerate(tiles):
        sheet.paste(tile, (place % columns * width, place // columns * height))
    sheet.save(path, quality=50, optimize=True)


if __name__ == "__main__":
    main()
