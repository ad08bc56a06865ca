"""Sensors of a rig, streamed and read from the disk."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import endless_city
from endless_city import CameraFrame, Dataset, Frame

from conftest import RECIPE


def on_a_car(name: str, kind: str, **more: Any) -> dict[str, Any]:
    mount = {"on": "vehicle", "class": "car", "at": [0.5, 0.0, 1.9]}
    return {"name": name, "type": kind, "mount": mount, **more}


SIZE = "160x90"
RIG: dict[str, Any] = {
    **RECIPE,
    "videos": 1,
    "size": (96, 54),
    "fps": 10,
    "duration": 0.4,
    "layers": ["rgb", "depth", "instance"],
    "cameras_per_scene": 1,
    "sensor": [
        on_a_car("front", "camera", size=SIZE, fov=90, layers=["rgb", "depth", "instance"], rate=5),
        on_a_car("events", "event_camera", size=SIZE, fov=90),
        on_a_car("velodyne", "lidar", preset="vlp_16", formats=["kitti", "ply"]),
        on_a_car("radar", "radar"),
        on_a_car("imu", "imu"),
        on_a_car("gnss", "gnss"),
        on_a_car("collisions", "collision"),
        on_a_car("lanes", "lane_invasion"),
    ],
}
PLY = np.dtype(
    [(name, "<f4") for name in ("x", "y", "z", "intensity", "time")]
    + [("ring", "<u2"), ("id", "<u2"), ("tag", "u1"), ("moving", "u1")]
)


@pytest.fixture(scope="module")
def rig(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of the video with all sensors."""
    folder = tmp_path_factory.mktemp("rig") / "out"
    endless_city.generate(folder, progress=False, **RIG)
    return folder / "videos" / Dataset(folder).videos[0]


@pytest.fixture(scope="module")
def streamed() -> list[Frame]:
    with endless_city.stream(**RIG) as frames:
        return list(frames)


def readings(streamed: list[Frame], name: str) -> dict[int, Any]:
    """What a sensor measured, by frame."""
    found = {frame.frame: sensor.measurement for frame in streamed for sensor in frame.sensors if sensor.name == name}
    assert found, name
    return found


def lines(path: Path) -> list[dict[str, Any]]:
    return [json.loads(line) for line in path.read_text().splitlines()]


def test_points_of_a_lidar_are_those_of_its_files(rig: Path, streamed: list[Frame]) -> None:
    for frame, sweep in readings(streamed, "velodyne").items():
        _, _, body = (rig / f"velodyne/ply/{frame:06}.ply").read_bytes().partition(b"end_header\n")
        points = np.frombuffer(body, PLY)
        assert len(points) > 1000
        assert sweep["points_m"].shape == (len(points), 3) and sweep["points_m"].dtype == np.float32
        assert np.array_equal(sweep["points_m"], np.stack([points["x"], points["y"], points["z"]], 1))
        columns = {"intensity": "intensity", "time_s": "time", "channel": "ring"}
        columns.update({"ids": "id", "classes": "tag", "moving": "moving"})
        for ours, theirs in columns.items():
            assert np.array_equal(sweep[ours], points[theirs]), ours


def test_detections_of_a_radar_are_those_of_its_files(rig: Path, streamed: list[Frame]) -> None:
    for frame, scan in readings(streamed, "radar").items():
        path = rig / f"radar/scans/{frame:06}.csv"
        rows = np.genfromtxt(path, delimiter=",", names=True, ndmin=1)
        assert len(rows) > 10 and scan.keys() == {*rows.dtype.names, "classes", "ids"} - {"tag", "id"}
        for name, tolerance in (("depth_m", 1e-3), ("azimuth_rad", 1e-4), ("altitude_rad", 1e-4)):
            assert scan[name].dtype == np.float32 and np.allclose(scan[name], rows[name], rtol=0, atol=tolerance), name
        assert np.allclose(scan["velocity_mps"], rows["velocity_mps"], atol=1e-3)
        assert np.allclose(scan["power_db"], rows["power_db"], atol=0.1)
        assert np.array_equal(scan["classes"], rows["tag"]) and np.array_equal(scan["ids"], rows["id"])


def test_events_are_those_of_their_files(rig: Path, streamed: list[Frame]) -> None:
    total = 0
    for frame, events in readings(streamed, "events").items():
        stored = np.load(rig / f"events/events/{frame:06}.npy")
        total += len(stored)
        for ours, theirs in {"t_us": "t", "x": "x", "y": "y", "polarity": "pol"}.items():
            assert np.array_equal(events[ours], stored[theirs]), ours
    assert total > 100


def test_records_are_those_of_their_files(rig: Path, streamed: list[Frame]) -> None:
    for name in ("imu", "gnss"):
        told = [record for records in readings(streamed, name).values() for record in records]
        assert told == lines(rig / name / f"{name}.jsonl")
    for name, file in (("collisions", "collisions.jsonl"), ("lanes", "lane_invasions.jsonl")):
        told = [record for records in readings(streamed, name).values() for record in records]
        assert told == lines(rig / name / file)


def test_poses_are_those_of_their_files(rig: Path, streamed: list[Frame]) -> None:
    for name in ("front", "velodyne", "imu"):
        told = [sensor.pose for frame in streamed for sensor in frame.sensors if sensor.name == name]
        stored = lines(rig / name / "poses.jsonl")
        assert [pose["frame"] for pose in told] == sorted({pose["frame"] for pose in told})
        assert all(pose in stored for pose in told)


def test_a_camera_that_is_carried_is_one_of_the_dataset(rig: Path, streamed: list[Frame]) -> None:
    dataset = Dataset(rig.parent.parent)
    assert {frame.camera.name for frame in dataset} == {"camera_a", "front"}
    assert len(Dataset(rig.parent.parent, cameras="front")) == 2
    of = {(frame.camera.name, frame.frame): frame for frame in dataset}
    views = readings(streamed, "front")
    assert list(views) == [0, 2]
    for frame, view in views.items():
        assert isinstance(view, CameraFrame) and view.size == (160, 90)
        stored = of["front", frame]
        assert view.objects.line == stored.objects.line and view.layers == stored.layers == ("rgb", "depth", "instance")
        for name, array in view.load().items():
            assert np.array_equal(array, stored.load()[name]), name
        ours, theirs = view.world_from_camera, stored.world_from_camera
        assert ours is not None and theirs is not None and np.array_equal(ours, theirs)
    first, last = (of["front", frame].world_from_camera for frame in (0, 2))
    assert first is not None and last is not None and not np.array_equal(first, last)
