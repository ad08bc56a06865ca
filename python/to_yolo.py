#!/usr/bin/env python3
"""Turns a dataset made by endless into the folders that YOLO detectors train on.

    python3 python/to_yolo.py OUT YOLO
    yolo detect train data=YOLO/data.yaml model=yolo11n.pt

Needs the files next to it only. Every fifth video is for validation (the last one, where there are fewer), so that no
scene is in both. Images are linked, not copied.
"""

import os
import pathlib
import sys

from endless_dataset import EndlessFrames


def main() -> None:
    frames = EndlessFrames(sys.argv[1])
    yolo = pathlib.Path(sys.argv[2])
    width, height = map(int, frames.recipe["size"].split("x"))
    videos = sorted({folder.parent.name for folder, _, _ in frames.items})
    held_out = set(videos[4::5] or videos[-1:])
    extension = frames.recipe["rgb_format"]
    for folder, frame, objects in frames.items:
        part = "val" if folder.parent.name in held_out else "train"
        stem = f"{folder.parent.name}_{folder.name}_{frame:06}"
        image = yolo / "images" / part / f"{stem}.{extension}"
        label = yolo / "labels" / part / f"{stem}.txt"
        for path in (image, label):
            path.parent.mkdir(parents=True, exist_ok=True)
        if not image.exists():
            os.symlink((folder / "rgb" / f"{frame:06}.{extension}").resolve(), image)
        lines = []
        for o in objects:
            x, y, w, h = o["bbox"]
            centre = ((x + w / 2) / width, (y + h / 2) / height, w / width, h / height)
            lines.append(f"{frames.classes.index(o['class'])} " + " ".join(f"{v:.6f}" for v in centre))
        label.write_text("".join(line + "\n" for line in lines))
    names = "".join(f"  {i}: {name}\n" for i, name in enumerate(frames.classes))
    (yolo / "data.yaml").write_text(f"path: {yolo.resolve()}\ntrain: images/train\nval: images/val\nnames:\n{names}")
    print(f"{len(frames)} images, {len(held_out)} of {len(videos)} videos held out")


if __name__ == "__main__":
    main()
