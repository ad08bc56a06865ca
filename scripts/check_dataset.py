#!/usr/bin/env python3
"""Checks a dataset independently of the program that made it: needs Pillow and NumPy only.

    python3 scripts/check_dataset.py OUT

Recomputes every box from the instance images, decodes depth, and checks counts, sizes and alignment.
"""

import json
import pathlib
import sys

import numpy as np
from PIL import Image

FAR_PLANE_M = 1000.0
SKY = 11


def boxes_of(ids: np.ndarray, tags: np.ndarray, min_pixels: int) -> dict[int, tuple[list[int], int, int]]:
    """Box [x, y, w, h], number of pixels and tag of every id with enough pixels."""
    found = {}
    for i in np.unique(ids[ids > 0]):
        ys, xs = np.nonzero(ids == i)
        assert len(set(tags[ys, xs].tolist())) == 1, f"object {i} has pixels of several tags"
        if len(xs) >= min_pixels:
            box = [xs.min(), ys.min(), xs.max() - xs.min() + 1, ys.max() - ys.min() + 1]
            found[int(i)] = ([int(v) for v in box], len(xs), int(tags[ys[0], xs[0]]))
    return found


def load(path: pathlib.Path, size: tuple[int, int]) -> np.ndarray:
    with Image.open(path) as image:
        assert image.mode == "RGB" and image.size == size, f"{path}: {image.mode} {image.size}"
        return np.asarray(image).astype(np.int64)


def check_camera(camera: pathlib.Path, recipe: dict, frames: int, tag_of_class: dict[str, int]) -> int:
    """Number of boxes that were compared."""
    record = json.loads((camera / "camera.json").read_text())
    size = (record["size"]["width"], record["size"]["height"])
    assert f"{size[0]}x{size[1]}" == recipe["size"], f"{camera}: size {size}"
    lines = [json.loads(line) for line in (camera / "objects.jsonl").read_text().splitlines()]
    assert [line["frame"] for line in lines] == list(range(frames)), f"{camera}: lines of objects.jsonl"
    compared = 0
    for layer in recipe["layers"]:
        extension = recipe["rgb_format"] if layer == "rgb" else "png"
        names = sorted(p.name for p in (camera / layer).iterdir())
        assert names == [f"{f:06}.{extension}" for f in range(frames)], f"{camera / layer}: names"
    for line in lines:
        frame = line["frame"]
        assert abs(line["time_s"] - frame / recipe["fps"]) < 1e-6, f"{camera}: time of frame {frame}"
        if "rgb" in recipe["layers"]:
            load(camera / "rgb" / f"{frame:06}.{recipe['rgb_format']}", size)
        depth = None
        if "depth" in recipe["layers"]:
            r, g, b = np.moveaxis(load(camera / "depth" / f"{frame:06}.png", size), 2, 0)
            depth = FAR_PLANE_M * (r + 256 * g + 65536 * b) / (256**3 - 1)
        if "instance" not in recipe["layers"]:
            continue
        tags, low, high = np.moveaxis(load(camera / "instance" / f"{frame:06}.png", size), 2, 0)
        ids = low + 256 * high
        written = {o["id"]: (o["bbox"], o["pixels"], tag_of_class[o["class"]]) for o in line["objects"]}
        assert written == boxes_of(ids, tags, recipe["min_pixels"]), f"{camera}: boxes of frame {frame}"
        compared += len(written)
        if depth is not None:
            assert (depth[tags == SKY] == FAR_PLANE_M).all(), f"{camera}: sky nearer than the far plane, frame {frame}"
            assert (depth[ids > 0] < FAR_PLANE_M).all(), f"{camera}: object on the far plane, frame {frame}"
            assert (depth > 0).all(), f"{camera}: zero depth, frame {frame}"
    return compared


def main() -> None:
    out = pathlib.Path(sys.argv[1])
    dataset = json.loads((out / "dataset.json").read_text())
    recipe = dataset["recipe"]
    frames = round(recipe["fps"] * recipe["duration"])
    tag_of_class = {c["name"]: c["tag"] for c in dataset["labels"]["classes"]}
    assert len(dataset["videos"]) == recipe["videos"], "number of videos"
    compared = 0
    for video in dataset["videos"]:
        assert video["state"] == "complete", f"{video['name']} is not complete"
        folder = out / "videos" / video["name"]
        class_of_id: dict[int, str] = {}
        for number, camera in enumerate(("camera_a", "camera_b")):
            boxes = check_camera(folder / camera, recipe, frames, tag_of_class)
            if "instance" in recipe["layers"]:
                assert boxes == video["boxes"][number], f"{folder / camera}: number of boxes"
            compared += boxes
            for line in (folder / camera / "objects.jsonl").read_text().splitlines():
                for o in json.loads(line)["objects"]:
                    same = class_of_id.setdefault(o["id"], o["class"])
                    assert same == o["class"], f"{folder}: object {o['id']} is {same} and {o['class']}"
    print(f"all is well: {len(dataset['videos'])} videos, {compared} boxes recomputed")


if __name__ == "__main__":
    main()
