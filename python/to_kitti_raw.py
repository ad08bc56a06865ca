#!/usr/bin/env python3
"""Lays a dataset made with rigs/kitti.toml out as KITTI's raw data and as SemanticKITTI, for the readers of either.

    python3 python/to_kitti_raw.py OUT KITTI [--deskew] [--copy]
    python3 -c "import pykitti; print(len(pykitti.raw('KITTI/raw', '2026_01_01', '0001').velo_files))"

Needs NumPy. A video is a drive, and a sequence; frames at which all sensors measured are numbered from 0. Files are linked,
not copied, unless `--copy` is given. With `--deskew` the points of a sweep are moved to where they would have been measured at
the instant of the image, as in KITTI's odometry data; otherwise they are as the scanner delivers them.

Camera 0 and 1 are where 2 and 3 are; there is no picture of them. Latitudes and longitudes of oxts are such that KITTI's own
conversion, which counts on a sphere, leads back to the poses; `gnss.jsonl` has those on WGS 84.
"""

import argparse
import datetime
import json
import math
import os
import pathlib
import shutil

import numpy as np

DATE = "2026_01_01"
NOON = datetime.datetime(2026, 1, 1, 12)
EARTH_M = 6378137.0
# Accuracies in metres and m/s; 4 is a full solution of the RT3003's, 10 satellites.
OXTS_END = "0.01 0.01 4 10 4 4 4"


def lines(path: pathlib.Path) -> dict:
    return {line["frame"]: line for line in map(json.loads, path.read_text().splitlines())}


def rotation(quaternion) -> np.ndarray:
    w, x, y, z = quaternion
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def pose(line) -> np.ndarray:
    """The 4x4 matrix from a sensor's body frame, or from a camera's (x right, y down, z ahead), to the world."""
    if "world_from_camera" in line:
        return np.array(line["world_from_camera"])
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation(line["quaternion"]), line["position"]
    return matrix


def row(numbers) -> str:
    return " ".join(f"{number:.12e}" for number in np.ravel(numbers))


def stamps(path: pathlib.Path, times) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    text = ((NOON + datetime.timedelta(seconds=t)).strftime("%Y-%m-%d %H:%M:%S.%f") + "000\n" for t in times)
    path.write_text("".join(text))


class Place:
    """Puts files where readers look for them."""

    def __init__(self, copy: bool) -> None:
        self.copy = copy

    def __call__(self, source: pathlib.Path, target: pathlib.Path) -> None:
        target.parent.mkdir(parents=True, exist_ok=True)
        target.unlink(missing_ok=True)
        if self.copy:
            shutil.copyfile(source, target)
        else:
            os.symlink(source.resolve(), target)


def deskewed(path: pathlib.Path, begin: np.ndarray, end: np.ndarray) -> np.ndarray:
    """A sweep as if all of it had been measured at its end. The head turns once, clockwise from behind."""
    points = np.fromfile(path, np.float32).reshape(-1, 4)
    share = 0.5 - np.arctan2(points[:, 1], points[:, 0]) / (2 * np.pi)
    # Of the small turn between the two, a share of its vector.
    turn = begin[:3, :3].T @ end[:3, :3]
    vector = 0.5 * np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
    turned = points[:, :3] + np.cross((share - 1)[:, None] * vector, points[:, :3])
    moved = end[:3, :3].T @ (begin[:3, 3] - end[:3, 3])
    points[:, :3] = turned + (1 - share)[:, None] * moved
    return points


def oxts(at: np.ndarray, line, imu, origin, scale: float) -> str:
    """The 30 values of a packet."""
    turn = at[:3, :3]
    yaw = math.atan2(turn[1, 0], turn[0, 0])
    pitch = math.asin(max(-1.0, min(1.0, -turn[2, 0])))
    roll = math.atan2(turn[2, 1], turn[2, 2])
    degrees = 180 / math.pi
    lon = (origin[0] + at[0, 3]) / (scale * EARTH_M) * degrees
    lat = 2 * math.atan(math.exp((origin[1] + at[1, 3]) / (scale * EARTH_M))) * degrees - 90
    # Forward, left and up: level, along the heading.
    level = np.array([[math.cos(yaw), math.sin(yaw), 0], [-math.sin(yaw), math.cos(yaw), 0], [0, 0, 1]])
    velocity = np.array(line["velocity_mps"])
    force, rate = np.array(imu["accelerometer_mps2"]), np.array(imu["gyroscope_radps"])
    values = [lat, lon, origin[2] + at[2, 3], roll, pitch, yaw, velocity[1], velocity[0], *(level @ velocity), *force,
              *(level @ turn @ force), *rate, *(level @ turn @ rate)]
    return " ".join(f"{value:.13f}" for value in values) + f" {OXTS_END}\n"


def calibration(first: dict) -> dict:
    """What stays the same: matrices between the sensors, of a frame's poses."""
    cameras = [first["image_02"], first["image_03"]]
    projections = []
    for camera in cameras:
        at = np.linalg.inv(pose(cameras[0])) @ pose(camera)
        assert np.abs(at[:3, :3] - np.eye(3)).max() < 1e-5 and np.abs(at[1:3, 3]).max() < 1e-4, "cameras are not parallel"
        lens = camera["intrinsics"]
        matrix = np.array([[lens["fx"], 0, lens["cx"], 0], [0, lens["fy"], lens["cy"], 0], [0, 0, 1, 0.0]])
        matrix[0, 3] = -matrix[0, 0] * at[0, 3]
        projections.append(matrix)
    return {"P": projections, "velo_to_cam": np.linalg.inv(pose(cameras[0])) @ pose(first["velodyne"]),
            "imu_to_velo": np.linalg.inv(pose(first["velodyne"])) @ pose(first["imu"])}


def write_raw_calibration(folder: pathlib.Path, calib: dict, size: str) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    time = f"calib_time: {NOON:%d-%b-%Y %H:%M:%S}\n"
    for name in ("velo_to_cam", "imu_to_velo"):
        text = f"{time}R: {row(calib[name][:3, :3])}\nT: {row(calib[name][:3, 3])}\n"
        if name == "velo_to_cam":
            text += "delta_f: 0 0\ndelta_c: 0 0\n"
        (folder / f"calib_{name}.txt").write_text(text)
    text = f"{time}corner_dist: 0\n"
    width, height = map(int, size.split("x"))
    for number in range(4):
        matrix = calib["P"][number % 2]
        across = [-matrix[0, 3] / matrix[0, 0], 0, 0]
        for key, values in (("S", [width, height]), ("K", matrix[:, :3]), ("D", np.zeros(5)), ("R", np.eye(3)),
                            ("T", -np.array(across)), ("S_rect", [width, height]), ("R_rect", np.eye(3)),
                            ("P_rect", matrix)):
            text += f"{key}_{number:02}: {row(values)}\n"
    (folder / "calib_cam_to_cam.txt").write_text(text)


def convert(video: pathlib.Path, number: int, root: pathlib.Path, args) -> int:
    recipe = json.loads((video.parent.parent / "dataset.json").read_text())["recipe"]
    spec = {sensor["name"]: sensor for sensor in recipe["sensor"]}
    names = ("image_02", "image_03", "velodyne", "imu")
    poses = {name: lines(video / name / "poses.jsonl") for name in names}
    imu, gnss = lines(video / "imu/imu.jsonl"), lines(video / "gnss/gnss.jsonl")
    frames = sorted(set.intersection(*(set(of) for of in poses.values()), set(gnss)))
    extension, place = recipe["rgb_format"], Place(args.copy)
    calib = calibration({name: of[frames[0]] for name, of in poses.items()})
    size = spec["image_02"].get("size") or recipe["size"]
    write_raw_calibration(root / "raw" / DATE, calib, size)

    drive = root / "raw" / DATE / f"{DATE}_drive_{number + 1:04}_sync"
    sequence = root / "sequences" / f"{number:02}"
    begin, place_on_earth = pose(poses["imu"][frames[0]])[:3, 3], gnss[frames[0]]
    scale = math.cos(math.radians(place_on_earth["latitude_deg"]))
    on_map = [math.radians(place_on_earth["longitude_deg"]),
              math.log(math.tan(math.pi / 4 + math.radians(place_on_earth["latitude_deg"]) / 2))]
    origin = np.array([*(scale * EARTH_M * np.array(on_map)), place_on_earth["altitude_m"]]) - begin
    sweep_s = 1 / (spec["velodyne"].get("rate") or recipe["fps"])
    first_camera, sequence_poses = np.linalg.inv(pose(poses["image_02"][frames[0]])), ""
    for index, frame in enumerate(frames):
        for name, folder in (("image_02", "image_2"), ("image_03", "image_3")):
            image = video / name / "rgb" / f"{frame:06}.{extension}"
            place(image, drive / name / "data" / f"{index:010}.{extension}")
            place(image, sequence / folder / f"{index:06}.{extension}")
        sweep = video / "velodyne/points" / f"{frame:06}.bin"
        targets = [drive / "velodyne_points/data" / f"{index:010}.bin", sequence / "velodyne" / f"{index:06}.bin"]
        if args.deskew:
            line = poses["velodyne"][frame]
            end = pose(line)
            # As the sensor moved: its velocities are those since the frame before.
            start = end.copy()
            start[:3, 3] -= np.array(line["velocity_mps"]) * sweep_s
            x, y, z = -np.array(line["angular_velocity_radps"]) * sweep_s
            start[:3, :3] = (np.eye(3) + np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])) @ end[:3, :3]
            for target in targets:
                target.parent.mkdir(parents=True, exist_ok=True)
                target.unlink(missing_ok=True)
                deskewed(sweep, start, end).tofile(target)
        else:
            for target in targets:
                place(sweep, target)
        place(video / "velodyne/labels" / f"{frame:06}.label", sequence / "labels" / f"{index:06}.label")
        packet = drive / "oxts/data" / f"{index:010}.txt"
        packet.parent.mkdir(parents=True, exist_ok=True)
        packet.write_text(oxts(pose(poses["imu"][frame]), poses["imu"][frame], imu[frame], origin, scale))
        sequence_poses += row((first_camera @ pose(poses["image_02"][frame]))[:3]) + "\n"

    times = [poses["image_02"][frame]["time_s"] for frame in frames]
    for name in ("image_02", "image_03", "oxts"):
        stamps(drive / name / "timestamps.txt", times)
    # The scanner looks ahead in the middle of a sweep.
    for name, before_s in (("timestamps_start", sweep_s), ("timestamps", 0.5 * sweep_s), ("timestamps_end", 0.0)):
        stamps(drive / "velodyne_points" / f"{name}.txt", [t - before_s for t in times])
    (sequence / "times.txt").write_text("".join(f"{t - times[0]:.6e}\n" for t in times))
    text = "".join(f"P{i}: {row(calib['P'][i % 2])}\n" for i in range(4)) + f"Tr: {row(calib['velo_to_cam'][:3])}\n"
    (sequence / "calib.txt").write_text(text)
    # SemanticKITTI has them beside the scans, KITTI's odometry data in a folder of their own.
    for target in (sequence / "poses.txt", root / "poses" / f"{number:02}.txt"):
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(sequence_poses)
    return len(frames)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path, help="the dataset")
    parser.add_argument("kitti", type=pathlib.Path, help="the folder to make")
    parser.add_argument("--deskew", action="store_true", help="undo the scanner's own motion within a sweep")
    parser.add_argument("--copy", action="store_true", help="copy files instead of linking them")
    args = parser.parse_args()
    videos = sorted(path for path in (args.out / "videos").iterdir() if (path / "scene.json").exists())
    frames = sum(convert(video, number, args.kitti, args) for number, video in enumerate(videos))
    print(f"{len(videos)} drives, {frames} frames")


if __name__ == "__main__":
    main()
