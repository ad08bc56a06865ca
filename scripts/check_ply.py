#!/usr/bin/env python3
"""Reads the sweeps of a dataset from PLY with `plyfile`, and compares them with those in KITTI's files beside them.

    python3 scripts/check_ply.py OUT
"""

import pathlib
import sys

import numpy as np
from plyfile import PlyData


def main() -> None:
    count = points = 0
    for path in sorted(pathlib.Path(sys.argv[1]).glob("videos/*/*/ply/*.ply")):
        vertices = PlyData.read(path)["vertex"].data
        sensor, stem = path.parent.parent, path.stem
        plain = np.fromfile(sensor / f"points/{stem}.bin", np.float32).reshape(-1, 4)
        labels = np.fromfile(sensor / f"labels/{stem}.label", np.uint32)
        assert np.array_equal(np.stack([vertices[name] for name in ("x", "y", "z", "intensity")], 1), plain), path
        assert np.array_equal(vertices["id"], labels >> 16) and (np.diff(vertices["time"]) >= 0).all(), path
        count, points = count + 1, points + len(vertices)
    assert points > 1000, "no points"
    print(f"{count} sweeps of {points} points are the same in both formats")


if __name__ == "__main__":
    main()
