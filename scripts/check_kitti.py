#!/usr/bin/env python3
"""Reads what python/to_kitti_raw.py --deskew made of a dataset with pykitti, as users of KITTI do, and compares it with the
dataset.

    python3 scripts/check_kitti.py OUT KITTI

Needs pykitti (with pandas and opencv-python-headless, which it imports), NumPy and Pillow.
"""

import json
import pathlib
import sys

import numpy as np
import pykitti
from PIL import Image

# Points whose neighbouring pixels differ in depth by more than this lie at edges.
FLAT = 0.05
# A point may lie so far before or behind what the pixels around it show: three standard deviations of its noise and more.
NOISE_M = 0.1
# SemanticKITTI's class of what is not there.
OUTLIER = 1


def lines(path):
    return {line["frame"]: line for line in map(json.loads, path.read_text().splitlines())}


def depth_at(path):
    rgb = np.asarray(Image.open(path)).astype(np.float64)
    return 1000.0 * (rgb @ [1, 256, 65536]) / (256**3 - 1)


def agreement(scan, camera_from_velo, intrinsics, depth):
    """How many points lie inside the picture away from edges, and how many of these on what it shows."""
    at = scan[:, :3] @ camera_from_velo[:3, :3].T + camera_from_velo[:3, 3]
    at = at[at[:, 2] > 1.0]
    pixels = at @ intrinsics.T
    x, y = (np.floor(pixels[:, i] / pixels[:, 2]).astype(int) for i in (0, 1))
    height, width = depth.shape
    inside = (x > 0) & (x < width - 1) & (y > 0) & (y < height - 1)
    x, y, z = x[inside], y[inside], at[inside, 2]
    around = np.stack([depth[y + dy, x + dx] for dy in (-1, 0, 1) for dx in (-1, 0, 1)])
    low, high = around.min(0), around.max(0)
    # What is farther is hidden from the camera, which stands elsewhere.
    asked = (high - low < FLAT * low) & (z < 1.15 * high)
    good = (z > low - NOISE_M) & (z < high + NOISE_M)
    return asked.sum(), (asked & good).sum()


def check_drive(video, number, kitti):
    raw = pykitti.raw(str(kitti / "raw"), "2026_01_01", f"{number + 1:04}")
    odometry = pykitti.odometry(str(kitti), f"{number:02}")
    poses = {name: lines(video / name / "poses.jsonl") for name in ("image_02", "velodyne", "imu")}
    frames = sorted(set.intersection(*(set(of) for of in poses.values())))
    assert len(frames) == len(raw) == len(odometry) == len(raw.velo_files) == len(raw.cam2_files) == len(raw.oxts), frames
    assert raw.calib.b_rgb > 0.5 and abs(raw.calib.b_rgb - odometry.calib.b_rgb) < 1e-9
    assert np.allclose(raw.calib.T_cam2_velo, odometry.calib.T_cam2_velo)
    asked, good, worst_m, worst_deg, points = 0, 0, 0.0, 0.0, 0
    first = np.array(poses["imu"][frames[0]]["position"])
    for i, frame in enumerate(frames):
        scan, image = raw.get_velo(i), raw.get_cam2(i)
        labels = np.fromfile(kitti / f"sequences/{number:02}/labels/{i:06}.label", np.uint32)
        assert len(labels) == len(scan) == len(odometry.get_velo(i)) > 1000
        points += len(scan)
        depth = depth_at(video / f"image_02/depth/{frame:06}.png")
        assert depth.shape == image.size[::-1] == raw.get_cam3(i).size[::-1]
        # Rain and fog are no surfaces.
        found = agreement(scan[labels & 0xFFFF != OUTLIER], raw.calib.T_cam2_velo, raw.calib.K_cam2, depth)
        asked, good = asked + found[0], good + found[1]

        line, imu = poses["imu"][frame], raw.oxts[i].T_w_imu
        worst_m = max(worst_m, np.linalg.norm(imu[:3, 3] - (np.array(line["position"]) - first)))
        w, x, y, z = line["quaternion"]
        ahead = [1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)]
        up = [2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)]
        for mine, axis in ((ahead, 0), (up, 2)):
            worst_deg = max(worst_deg, np.degrees(np.arccos(np.clip(imu[:3, axis] @ mine, -1, 1))))
        # The way from frame to frame by odometry is that of the IMU, seen from camera 0.
        seen = odometry.calib.T_cam0_velo @ raw.calib.T_velo_imu
        by_oxts = seen @ np.linalg.inv(raw.oxts[0].T_w_imu) @ imu @ np.linalg.inv(seen)
        assert np.abs(by_oxts - odometry.poses[i]).max() < 0.01
    driven = np.linalg.norm(raw.oxts[-1].T_w_imu[:3, 3])
    speeds = [np.hypot(o.packet.ve, o.packet.vn) for o in raw.oxts]
    assert all(abs(speed - abs(o.packet.vf)) < 0.2 + 0.05 * speed for speed, o in zip(speeds, raw.oxts)), "vf"
    forces = [(np.array(o.packet[11:14]), np.array(o.packet[14:17])) for o in raw.oxts]
    assert all(abs(np.linalg.norm(body) - np.linalg.norm(level)) < 1e-6 and level[2] > 0 for body, level in forces), "af, al, au"
    print(f"drive {number + 1}: {len(frames)} frames, {driven:.1f} m; {points} points; {100 * good / asked:.2f} % of {asked} lie on "
          f"what image_02 shows; poses at most {1000 * worst_m:.2f} mm and {worst_deg:.4f} degrees off")
    assert good > 0.99 * asked > 1000 and worst_m < 0.01 and worst_deg < 0.01


def main():
    out, kitti = map(pathlib.Path, sys.argv[1:3])
    for number, video in enumerate(sorted((out / "videos").iterdir())):
        check_drive(video, number, kitti)


if __name__ == "__main__":
    main()
