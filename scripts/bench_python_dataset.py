#!/usr/bin/env python3
"""How fast `endless_city.Dataset` reads pictures, instances and labels, beside Pillow, NumPy and json.

    python3 scripts/bench_python_dataset.py OUT [--frames N] [--rounds N]

Both read the same frames in turn, several rounds, and give the same arrays; the best round of each counts. OUT is a dataset with
the layers rgb and instance.
"""

import argparse
import json
import pathlib
import time

import numpy as np
from PIL import Image

from endless_city import Dataset


class Plain:
    """The same with Pillow, NumPy and json, as one would write it."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        manifest = json.loads((self.root / "dataset.json").read_text())
        self.format = manifest["recipe"]["rgb_format"]
        self.lines = {}

    def read(self, video, camera, frame):
        folder = self.root / "videos" / video / camera
        if folder not in self.lines:
            self.lines[folder] = (folder / "objects.jsonl").read_text().splitlines()
        with Image.open(folder / "rgb" / f"{frame:06}.{self.format}") as image:
            rgb = np.asarray(image)
        with Image.open(folder / "instance" / f"{frame:06}.png") as image:
            coded = np.asarray(image)
        ids = coded[..., 1].astype(np.int32) + 256 * coded[..., 2].astype(np.int32)
        objects = json.loads(self.lines[folder][frame])["objects"]
        boxes = np.array([o["bbox"] for o in objects], np.float32).reshape(-1, 4)
        return rgb, ids, np.ascontiguousarray(coded[..., 0]), boxes


def ours(frame):
    frame.load(["rgb", "instance"])
    return frame.rgb, frame.instance, frame.classes, frame.objects.boxes


def best(rounds, read, frames):
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        for frame in frames:
            read(frame)
        times.append(time.perf_counter() - start)
    return min(times) / len(frames)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out")
    parser.add_argument("--frames", type=int, default=60)
    parser.add_argument("--rounds", type=int, default=5)
    args = parser.parse_args()
    dataset, plain = Dataset(args.out), Plain(args.out)
    places = np.linspace(0, len(dataset) - 1, min(args.frames, len(dataset))).astype(int)

    def read_plain(place):
        frame = dataset[place]
        return plain.read(frame.video, frame.camera.name, frame.frame)

    for place in places:
        for a, b in zip(ours(dataset[place]), read_plain(place)):
            assert a.dtype == b.dtype and np.array_equal(a, b)
    # In turn, so that what else the machine does meets both.
    spans = [(best(1, lambda p: ours(dataset[p]), places), best(1, read_plain, places)) for _ in range(args.rounds)]
    mine, theirs = (min(span[i] for span in spans) for i in (0, 1))
    width, height = dataset[0].size
    print(
        f"{width}x{height}, rgb + instance + labels: {1e3 * mine:.2f} ms a frame, "
        f"Pillow {Image.__version__ if hasattr(Image, '__version__') else ''} + NumPy {1e3 * theirs:.2f} ms: "
        f"{theirs / mine:.2f} times as fast"
    )


if __name__ == "__main__":
    main()
