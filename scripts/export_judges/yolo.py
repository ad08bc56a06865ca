"""YOLO: every line is the label that it was; where Ultralytics is installed, its own check of the dataset reads it."""

import pathlib

import cv2
import numpy as np
import yaml

from .truth import Truth, check, one_video_one_part

FLIP = [0, 2, 1, 4, 3, 6, 5, 8, 7, 10, 9, 12, 11, 14, 13, 16, 15]


def lines(truth: Truth, folder: pathlib.Path, poses: bool = False):
    """The objects of each frame with their lines."""
    data = yaml.safe_load((folder / "data.yaml").read_text())
    parts = {}
    for split in ("train", "val"):
        images = sorted((folder / data[split]).iterdir())
        parts[split] = [image.stem for image in images]
        for image in images:
            frame = truth.by_name[image.stem]
            rows = [line.split() for line in (folder / "labels" / split / f"{image.stem}.txt").read_text().splitlines()]
            objects = [o for o in frame.objects if not poses or "keypoints" in o]
            check(len(rows) == len(objects), "lines of", frame.name, len(rows), len(objects))
            for row, o in zip(rows, objects):
                check(data["names"][int(row[0])] == o["class"], "class of", frame.name, o["id"])
                yield frame, o, np.array(row[1:], float)
    check(sum(map(len, parts.values())) == len(truth.frames), "pictures are missing")
    one_video_one_part(parts)


def same_box(truth: Truth, frame, o, numbers) -> None:
    x, y, w, h = numbers * np.array([truth.width, truth.height] * 2)
    difference = np.abs(np.array([x - w / 2, y - h / 2, w, h]) - o["bbox"]).max()
    check(difference < 2e-6 * truth.width, "box of", frame.name, o["id"], difference)


def ultralytics_check(folder: pathlib.Path) -> str:
    try:
        from ultralytics.data.utils import check_det_dataset
    except ImportError:
        return "Ultralytics is not installed"
    data = check_det_dataset(str(folder / "data.yaml"), autodownload=False)
    check(data["nc"] > 0, "no classes")
    return f"Ultralytics' check: {data['nc']} classes"


def yolo(truth: Truth, folder: pathlib.Path) -> None:
    count = 0
    for frame, o, numbers in lines(truth, folder):
        same_box(truth, frame, o, numbers)
        count += 1
    check(count == truth.boxes, count, "boxes")
    print(f"  {count} boxes; {ultralytics_check(folder)}")


def yolo_segment(truth: Truth, folder: pathlib.Path) -> None:
    count, worst = 0, 1.0
    for frame, o, numbers in lines(truth, folder):
        corners = numbers.reshape(-1, 2) * [truth.width, truth.height]
        check(np.abs(corners - corners.round()).max() < 1e-2, "corners are not corners of pixels", frame.name)
        # Filled by the even-odd rule over the centres of pixels, which OpenCV does in sixteenths of a pixel.
        size = (truth.height, truth.width)
        x, y, w, h = o["bbox"]
        ours = even_odd(corners.round() - [x, y], w, h)
        expected = frame.mask(o["id"])[y:y + h, x:x + w]
        check((ours == expected).all(), "polygon of", frame.name, o["id"], (ours != expected).sum())
        filled = np.zeros(size, np.uint8)
        cv2.fillPoly(filled, [corners.round().astype(np.int32)], 1)
        worst = min(worst, (filled[y:y + h, x:x + w].astype(bool) & expected).sum() / expected.sum())
        count += 1
    print(f"  {count} polygons, exact; least share of a mask that OpenCV fills {worst:.3f}; {ultralytics_check(folder)}")


def even_odd(corners: np.ndarray, width: int, height: int) -> np.ndarray:
    """Pixels whose centres lie inside; upright edges alone are crossed on the way to the left."""
    crossings = np.zeros((height, width + 1), int)
    following = np.roll(corners, -1, axis=0)
    inside = np.zeros((height, width), bool)
    xs = np.arange(width) + 0.5
    for y in range(height):
        level = y + 0.5
        cross = (corners[:, 1] > level) != (following[:, 1] > level)
        a, b = corners[cross], following[cross]
        at = a[:, 0] + (level - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
        inside[y] = (at[None, :] < xs[:, None]).sum(axis=1) % 2 == 1
    del crossings
    return inside


def yolo_pose(truth: Truth, folder: pathlib.Path) -> None:
    data = yaml.safe_load((folder / "data.yaml").read_text())
    check(data["kpt_shape"] == [17, 3] and data["flip_idx"] == FLIP, "shape or mirroring of keypoints")
    count = 0
    for frame, o, numbers in lines(truth, folder, poses=True):
        same_box(truth, frame, o, numbers[:4])
        points = numbers[4:].reshape(17, 3) * [truth.width, truth.height, 1]
        difference = np.abs(points - np.array(o["keypoints"]).reshape(17, 3)).max()
        check(difference < 2e-6 * truth.width, "keypoints of", frame.name, o["id"], difference)
        count += 1
    print(f"  {count} people; {ultralytics_check(folder)}")


def yolo_obb(truth: Truth, folder: pathlib.Path) -> None:
    count = 0
    for frame, o, numbers in lines(truth, folder):
        corners = numbers.reshape(4, 2) * [truth.width, truth.height]
        ys, xs = np.nonzero(frame.mask(o["id"]))
        pixels = np.concatenate([np.stack([xs + dx, ys + dy], 1) for dx in (0, 1) for dy in (0, 1)]).astype(float)
        (_, _), (w, h), _ = cv2.minAreaRect(pixels.astype(np.float32))
        sides = np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1)
        check(abs(sides[0] * sides[1] - w * h) < 0.02 * w * h + 0.1, "area of", frame.name, o["id"], sides, w, h)
        for a, b in zip(corners, np.roll(corners, -1, axis=0)):
            edge = (b - a) / np.linalg.norm(b - a)
            side = (pixels - a) @ [-edge[1], edge[0]]
            check(side.min() > -1e-2 or side.max() < 1e-2, "it does not hold", frame.name, o["id"])
        count += 1
    print(f"  {count} oriented boxes, the smallest; {ultralytics_check(folder)}")
