"""How different the videos of datasets are: layouts of colours and of edges, camera poses.

    python3 scripts/measure_variety.py OUT [OUT ...]

A picture's colour layout is the mean colour, in CIE Lab, of each cell of an 8 x 8 grid (as MPEG-7 has it, without the
transform): 192 numbers. Two pictures are as far apart as the root of the mean squared difference of these.

Its layout of edges is a histogram of the gradient's eight directions in each of these cells (Dalal and Triggs, "Histograms of
Oriented Gradients for Human Detection", CVPR 2005), each picture's of unit length: it tells what stands where, whatever the light. The
distance is that of the two vectors, 0 to 1.41.

For each dataset and both layouts, of the first frame of every camera: the mean distance of cameras of different videos, the mean
distance to the nearest one, both also among videos of the same weather and time of day alone; and how many cameras of different
videos have the same pose.

Needs NumPy and Pillow.
"""

import argparse
import json
import sys
from pathlib import Path

import numpy as np
from PIL import Image

GRID = 8
# Pixels of a cell's side, and directions, for edges.
CELL = 24
DIRECTIONS = 8


def color_layout(path: Path) -> np.ndarray:
    """Mean CIE Lab of each cell, (GRID * GRID * 3,)."""
    with Image.open(path) as image:
        cells = np.asarray(image.convert("RGB").resize((GRID, GRID), Image.Resampling.BOX), np.float64) / 255
    linear = np.where(cells <= 0.04045, cells / 12.92, ((cells + 0.055) / 1.055) ** 2.4)
    xyz = linear @ np.array([[0.4124, 0.2126, 0.0193], [0.3576, 0.7152, 0.1192], [0.1805, 0.0722, 0.9505]])
    t = xyz / np.array([0.9505, 1.0, 1.089])
    f = np.where(t > 0.008856, np.cbrt(t), 7.787 * t + 16 / 116)
    lab = np.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], axis=-1)
    return lab.reshape(-1)


def edge_layout(path: Path) -> np.ndarray:
    """Square roots of the shares of gradients by direction in each cell, (GRID * GRID * DIRECTIONS,), of length 1."""
    side = GRID * CELL
    with Image.open(path) as image:
        grey = np.asarray(image.convert("L").resize((side, side), Image.Resampling.BOX), np.float64)
    along_y, along_x = np.gradient(grey)
    # Dark to bright and bright to dark are one direction.
    direction = (np.arctan2(along_y, along_x) % np.pi / np.pi * DIRECTIONS).astype(int) % DIRECTIONS
    strength = np.hypot(along_x, along_y)
    layout = np.zeros((GRID, GRID, DIRECTIONS))
    y, x = np.indices(grey.shape) // CELL
    np.add.at(layout, (y, x, direction), strength)
    return np.sqrt(layout / max(layout.sum(), 1e-9)).reshape(-1)


def cameras(out: Path):
    """Of each camera of each complete video: number of the video, weather and time, pose, layouts of colours and of edges."""
    for video in sorted((out / "videos").iterdir()):
        if not (video / "scene.json").exists():
            continue
        scene = json.loads((video / "scene.json").read_text())
        scene = scene.get("settings", scene)
        for camera, site in zip(sorted(video.glob("camera_*")), scene["cameras"]):
            pose = (scene["map"], *site["position"], site["yaw_rad"], site["down_tilt_rad"], site["horizontal_fov_rad"])
            frame = sorted((camera / "rgb").iterdir())[0]
            yield scene["video"], (scene["weather"], scene["time_of_day"]), pose, color_layout(frame), edge_layout(frame)


def color_distances(layouts: np.ndarray) -> np.ndarray:
    """Of each picture to each."""
    return np.stack([np.sqrt(np.mean((layouts - layout) ** 2, axis=-1)) for layout in layouts])


def edge_distances(layouts: np.ndarray) -> np.ndarray:
    """Of each picture to each."""
    return np.sqrt(np.maximum(2.0 - 2.0 * (layouts @ layouts.T), 0.0))


def distances(videos: np.ndarray, apart: np.ndarray, among: np.ndarray) -> tuple[float, float]:
    """Mean distance of all pairs that count, and of each camera and the nearest that counts."""
    counts = (videos[:, None] != videos[None]) & among
    nearest = np.where(counts, apart, np.inf).min(axis=1)
    return float(apart[counts].mean()), float(nearest[np.isfinite(nearest)].mean())


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", nargs="+", type=Path)
    print(f"{'dataset':20} {'cameras':>7} {'poses':>6} {'layout':7} all: mean nearest   same weather and time: mean nearest")
    for out in parser.parse_args().out:
        found = list(cameras(out))
        if len({video for video, *_ in found}) < 2:
            print(f"{out} has fewer than two complete videos", file=sys.stderr)
            return 1
        videos = np.array([video for video, *_ in found])
        conditions = np.array(["/".join(condition) for _, condition, *_ in found])
        poses = len({pose for _, _, pose, _, _ in found})
        colors, edges = (np.stack([camera[place] for camera in found]) for place in (3, 4))
        every = np.ones((len(found), len(found)), bool)
        for name, apart in (("colours", color_distances(colors)), ("edges", edge_distances(edges))):
            everywhere = distances(videos, apart, every)
            alike = distances(videos, apart, conditions[:, None] == conditions[None])
            figures = f"{everywhere[0]:9.3f} {everywhere[1]:7.3f}   {alike[0]:27.3f} {alike[1]:7.3f}"
            print(f"{out.name:20} {len(found):7} {poses:6} {name:7} {figures}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
