"""Frames on the disk."""

from __future__ import annotations

import json
import multiprocessing
import os
import pickle
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

import endless_city
from endless_city import Dataset, DatasetError, RecipeError


def png(out: Path, frame: endless_city.CameraFrame, layer: str) -> np.ndarray:
    """What another reader makes of a file of 8 bits a channel."""
    path = out / "videos" / frame.video / frame.camera.name / layer / f"{frame.frame:06}.png"
    with Image.open(path) as image:
        return np.asarray(image).astype(np.int64)


def test_every_layer_is_what_its_file_says(out: Path) -> None:
    dataset = Dataset(out)
    assert len(dataset) == 16 and dataset.layers == endless_city.LAYERS
    for frame in dataset:
        height, width = 91, 161
        assert frame.size == (width, height)
        assert (frame.rgb == png(out, frame, "rgb")).all() and frame.rgb.dtype == np.uint8
        assert (frame.albedo == png(out, frame, "albedo")).all()
        r, g, b = np.moveaxis(png(out, frame, "depth"), 2, 0)
        metres = (1000.0 * (r + 256 * g + 65536 * b) / (256**3 - 1)).astype(np.float32)
        assert np.allclose(frame.depth, metres, rtol=1e-6) and frame.depth.dtype == np.float32
        r, g, b = np.moveaxis(png(out, frame, "instance"), 2, 0)
        assert (frame.classes == r).all() and (frame.instance == g + 256 * b).all()
        assert frame.instance.dtype == np.int32 and frame.classes.dtype == np.uint8
        assert (frame.semantic == r).all()
        r, g, b = np.moveaxis(png(out, frame, "panoptic"), 2, 0)
        assert (frame.panoptic == r + 256 * g + 65536 * b).all()
        assert (frame.shadow == png(out, frame, "shadow")[..., 0]).all()
        assert (frame.body_parts == png(out, frame, "body_parts")[..., 0]).all()
        lengths = np.linalg.norm(frame.normals, axis=2)
        sky = frame.classes == endless_city.tags().index("Sky")
        assert np.allclose(lengths[~sky], 1, atol=1e-3) and (lengths[sky] == 0).all()
        for flow, target in ((frame.flow, frame.flow_target), (frame.flow_backward, frame.flow_backward_target)):
            assert flow.shape == (height, width, 2) and flow.dtype == np.float32
            assert target.max() <= 3 and (flow[target == 0] == 0).all()
        for array in frame.load().values():
            assert array.flags.c_contiguous and array.flags.writeable


def test_objects_are_those_of_the_file(out: Path) -> None:
    dataset = Dataset(out)
    seen = 0
    for frame in dataset:
        path = out / "videos" / frame.video / frame.camera.name / "objects.jsonl"
        line = path.read_bytes().splitlines()[frame.frame]
        objects = frame.objects
        assert objects.line == line and objects.records == json.loads(line)["objects"]
        assert json.loads(line)["frame"] == frame.frame and json.loads(line)["time_s"] == pytest.approx(frame.time_s)
        for place, record in enumerate(objects.records):
            assert objects.ids[place] == record["id"] and objects.names[place] == record["class"]
            assert objects.boxes[place].tolist() == record["bbox"]
            assert objects.pixels[place] == record["pixels"] == (frame.instance == record["id"]).sum()
            assert objects.visibility[place] == pytest.approx(record["visibility"], abs=1e-6)
            assert objects.positions_m[place].tolist() == record["position"]
            assert objects.keypoints[place].ravel() == pytest.approx(record.get("keypoints", [0] * 51), abs=1e-3)
        corners = objects.boxes_xyxy
        assert (corners[:, 2] <= 161).all() and (corners[:, 3] <= 91).all()
        seen += len(objects)
    assert seen > 50


def test_cameras_are_told(out: Path) -> None:
    frame = Dataset(out)[0]
    assert frame.camera.intrinsics.shape == (3, 3) and frame.camera.size == (161, 91)
    pose = frame.world_from_camera
    assert pose is not None and np.allclose(pose[:3, :3] @ pose[:3, :3].T, np.eye(3), atol=1e-5)
    assert frame.camera.lens_model in ("pinhole", "opencv") and frame.camera.site is not None


def test_places_are_those_of_a_sequence(out: Path) -> None:
    dataset = Dataset(out)
    assert dataset[-1].frame == dataset[15].frame == 3
    assert [frame.frame for frame in dataset[2:6]] == [2, 3, 0, 1]
    assert dataset[np.int64(3)].frame == 3
    for wrong in (16, -17, 10**30):
        with pytest.raises(IndexError):
            dataset[wrong]
    with pytest.raises(TypeError):
        dataset["a"]  # type: ignore[call-overload]


def test_a_part_can_be_chosen(out: Path) -> None:
    dataset = Dataset(out, layers=["rgb"], cameras="camera_b")
    assert len(dataset) == 8 and {frame.camera.name for frame in dataset} == {"camera_b"}
    assert dataset.layers == ("rgb",)
    with pytest.raises(DatasetError, match="depth is not stored, only rgb"):
        dataset[0].depth  # noqa: B018
    name = Dataset(out).videos[1]
    assert Dataset(out, videos=[name]).videos == [name]
    for wrong in ({"layers": ["rbg"]}, {"layers": [3]}):
        with pytest.raises(RecipeError):
            Dataset(out, **wrong)
    for wrong in ({"cameras": ["camera_z"]}, {"videos": ["none"]}):
        with pytest.raises(DatasetError, match="use some of"):
            Dataset(out, **wrong)


def test_it_is_divided_as_exports_are(out: Path, tmp_path: Path) -> None:
    whole = Dataset(out, layers=["rgb"])
    parts = whole.split({"train": 0.5, "val": 0.5})
    assert list(parts) == ["train", "val"] and all(len(part) == 8 for part in parts.values())
    assert {part.layers for part in parts.values()} == {("rgb",)}
    assert sorted(parts["train"].videos + parts["val"].videos) == sorted(whole.videos)
    program = [sys.executable, "-m", "endless_city", "export", str(out), "--format", "coco", "--to", str(tmp_path / "coco")]
    subprocess.run([*program, "--split", "train=0.5,val=0.5"], check=True, capture_output=True)
    told = json.loads((tmp_path / "coco/annotations/instances_val.json").read_text())
    assert {image["file_name"].partition("_camera_")[0] for image in told["images"]} == set(parts["val"].videos)
    assert list(whole.split(by="map")) == ["train"]
    chosen = Dataset(out, videos=parts["val"].videos).split("train=0.5,val=0.5")
    assert (len(chosen["train"]), len(chosen["val"])) == (0, 8)
    for wrong in ({"shares": {"a": 0.7, "b": 0.7}}, {"shares": {"a": 0.5, "b": 0.5}, "by": "map"}, {"by": "frame"}):
        with pytest.raises(RecipeError):
            whole.split(**wrong)
    with pytest.raises(RecipeError, match="by its name"):
        whole.split([0.5, 0.5])  # type: ignore[arg-type]


def test_what_is_no_dataset_is_refused(tmp_path: Path, out: Path) -> None:
    with pytest.raises(DatasetError, match="dataset.json"):
        Dataset(tmp_path)
    damaged = tmp_path / "damaged"
    shutil.copytree(out, damaged)
    frame = Dataset(damaged)[0]
    path = damaged / "videos" / frame.video / frame.camera.name / "rgb" / "000000.png"
    path.write_bytes(path.read_bytes()[:-20])
    with pytest.raises(DatasetError, match="000000.png"):
        frame.rgb  # noqa: B018
    path.unlink()
    with pytest.raises(DatasetError, match="cannot read"):
        frame.load(["depth", "rgb"])


def test_it_can_be_pickled(out: Path) -> None:
    dataset = pickle.loads(pickle.dumps(Dataset(out, cameras=["camera_a"])))
    assert len(dataset) == 8 and dataset[3].rgb.shape == (91, 161, 3)
    frame = pickle.loads(pickle.dumps(dataset[3]))
    assert (frame.rgb == dataset[3].rgb).all() and frame.objects.line == dataset[3].objects.line


def sums(dataset: Dataset, index: int) -> int:
    return int(sum(array.astype(np.float64).sum() for array in dataset[index].load().values()))


@pytest.mark.parametrize("method", [m for m in ("fork", "spawn") if m in multiprocessing.get_all_start_methods()])
def test_workers_read_the_same(out: Path, method: str) -> None:
    dataset = Dataset(out)
    expected = [sums(dataset, index) for index in range(4)]
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.starmap(sums, [(dataset, index) for index in range(4)]) == expected


def test_a_forked_process_reads_what_its_parent_opened(out: Path) -> None:
    if not hasattr(os, "fork"):
        pytest.skip("this system has no fork")
    dataset = Dataset(out)
    expected = sums(dataset, 1)
    child = os.fork()
    if child == 0:
        os._exit(0 if sums(dataset, 1) == expected else 1)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0


def test_the_picture_shows_itself(out: Path) -> None:
    shown = Dataset(out)[0]._repr_png_()
    assert shown is not None and shown.startswith(b"\x89PNG")
