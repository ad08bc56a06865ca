#!/usr/bin/env python3
"""Writes videos of a dataset as recordings for Rerun's viewer: pictures, depth, classes, boxes, keypoints, boxes in space and tracks.

    python3 python/to_rerun.py OUT RERUN [--video N] [--stride N]
    rerun RERUN/0000_Town03_rainy_night.rrd

Needs NumPy, Pillow and rerun-sdk. A recording a video: `world` has the cameras, and the boxes of all that any of them sees; below each
camera is what it shows. Timelines are `frame` and `time`. World: metres, x east, y north, z up.
"""

import argparse
import json
import pathlib

import numpy as np
import rerun as rr
from PIL import Image

TRAIL_FRAMES = 60


def lines(path: pathlib.Path) -> list:
    return list(map(json.loads, path.read_text().splitlines()))


def log_camera(entity: str, record: dict, pose=None) -> None:
    """Where a camera is and how it projects."""
    matrix = np.array(pose or record["world_from_camera"])
    rr.log(entity, rr.Transform3D(translation=matrix[:3, 3], mat3x3=matrix[:3, :3]))
    size = [record["size"]["width"], record["size"]["height"]]
    pinhole = rr.Pinhole(image_from_camera=record["intrinsics_matrix"], resolution=size, camera_xyz=rr.ViewCoordinates.RDF)
    rr.log(f"{entity}/image", pinhole, static=pose is None)


def log_images(entity: str, camera: pathlib.Path, frame: int) -> None:
    for ending in ("png", "jpg"):
        path = camera / "rgb" / f"{frame:06}.{ending}"
        if path.exists():
            rr.log(f"{entity}/image/rgb", rr.EncodedImage(path=path))
    path = camera / "depth" / f"{frame:06}.png"
    if path.exists():
        depth = np.asarray(Image.open(path)).astype(np.float32) @ np.array([1, 256, 65536], np.float32)
        rr.log(f"{entity}/image/depth", rr.DepthImage(depth * np.float32(1000 / (256**3 - 1)), meter=1.0))
    path = camera / "instance" / f"{frame:06}.png"
    if path.exists():
        rr.log(f"{entity}/image/classes", rr.SegmentationImage(np.asarray(Image.open(path))[..., 0]))


def log_labels(entity: str, objects: list, tags: dict) -> None:
    boxes = np.array([o["bbox"] for o in objects], float).reshape(-1, 4)
    names = [f"{o['class']} {o['id']}" for o in objects]
    classes = [tags[o["class"]] for o in objects]
    rr.log(f"{entity}/image/boxes", rr.Boxes2D(mins=boxes[:, :2], sizes=boxes[:, 2:], labels=names, class_ids=classes))
    people = [np.array(o["keypoints"]).reshape(-1, 3) for o in objects if "keypoints" in o]
    points = [person[person[:, 2] > 0, :2] for person in people]
    rr.log(f"{entity}/image/keypoints", rr.Points2D(np.concatenate(points) if points else np.zeros((0, 2)), radii=1.5))


def log_world(objects: dict, trails: dict, tags: dict) -> None:
    seen = [o for o in objects.values() if "box3d" in o]
    boxes = [o["box3d"] for o in seen]
    turned = np.array([b["rotation"] for b in boxes]).reshape(-1, 4)[:, [1, 2, 3, 0]]
    rr.log("world/boxes", rr.Boxes3D(
        centers=np.array([b["center"] for b in boxes]).reshape(-1, 3), sizes=np.array([b["size"] for b in boxes]).reshape(-1, 3),
        quaternions=turned, labels=[f"{o['class']} {o['id']}" for o in seen], class_ids=[tags[o["class"]] for o in seen]))
    for number, o in objects.items():
        trails[number] = (trails.get(number, []) + [o["position"]])[-TRAIL_FRAMES:]
    for number in set(trails) - set(objects):
        del trails[number]
    rr.log("world/tracks", rr.LineStrips3D([trail for trail in trails.values() if len(trail) > 1]))


def write_video(video: pathlib.Path, target: pathlib.Path, labels: dict, stride: int) -> int:
    rr.init("endless", recording_id=video.name, spawn=False)
    rr.save(target)
    rr.log("world", rr.ViewCoordinates.RIGHT_HAND_Z_UP, static=True)
    rr.log("/", rr.AnnotationContext([(tag["value"], tag["name"], tag["color"]) for tag in labels["tags"]]), static=True)
    tags = {entry["name"]: entry["tag"] for entry in labels["classes"]}
    cameras = {path.parent.name: path.parent for path in sorted(video.glob("*/camera.json"))}
    records = {name: json.loads((camera / "camera.json").read_text()) for name, camera in cameras.items()}
    poses = {name: {line["frame"]: line["world_from_camera"] for line in lines(camera / "poses.jsonl")}
             for name, camera in cameras.items() if (camera / "poses.jsonl").exists()}
    for name, record in records.items():
        if "world_from_camera" in record:
            log_camera(f"world/{name}", record)
    told = {name: {line["frame"]: line for line in lines(camera / "objects.jsonl")} for name, camera in cameras.items()}
    frames = sorted(set().union(*told.values()))[::stride]
    trails: dict = {}
    for frame in frames:
        here = {name: told[name][frame] for name in cameras if frame in told[name]}
        rr.set_time("frame", sequence=frame)
        rr.set_time("time", duration=next(iter(here.values()))["time_s"])
        objects = {}
        for name, line in here.items():
            if name in poses and frame in poses[name]:
                log_camera(f"world/{name}", records[name], poses[name][frame])
            log_images(f"world/{name}", cameras[name], frame)
            log_labels(f"world/{name}", line["objects"], tags)
            objects |= {o["id"]: o for o in line["objects"]}
        log_world(objects, trails, tags)
        counts = {kind: sum(o["class"] == kind for o in objects.values()) for kind in tags}
        for kind, count in counts.items():
            rr.log(f"counts/{kind}", rr.Scalars(count))
    rr.disconnect()
    return len(frames)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("rerun", type=pathlib.Path)
    parser.add_argument("--video", type=int, help="only the video of this number")
    parser.add_argument("--stride", type=int, default=1, help="of the frames take every so many")
    asked = parser.parse_args()
    manifest = json.loads((asked.out / "dataset.json").read_text())
    asked.rerun.mkdir(parents=True, exist_ok=True)
    for entry in manifest["videos"]:
        if entry["state"] != "complete" or asked.video not in (None, entry["video"]):
            continue
        target = asked.rerun / f"{entry['name']}.rrd"
        half = target.with_suffix(".tmp")
        frames = write_video(asked.out / "videos" / entry["name"], half, manifest["labels"], max(asked.stride, 1))
        half.replace(target)
        print(f"{target}: {frames} frames, {target.stat().st_size / 1e6:.1f} MB")


if __name__ == "__main__":
    main()
