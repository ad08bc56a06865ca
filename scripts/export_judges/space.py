"""Formats with boxes in space: KITTI's object benchmark and raw data, nuScenes, AI City."""

import contextlib
import csv
import io
import json
import pathlib

import numpy as np

from .truth import Truth, check, one_video_one_part

KINDS = {"car": "Car", "van": "Van", "truck": "Truck", "bus": "Misc", "motorcycle": "Misc", "pedestrian": "Pedestrian", "rider": "Misc"}


def matrix(text: str, rows: int) -> np.ndarray:
    return np.array(text.split(), float).reshape(rows, -1)


def kitti_corners(height, width, length, location, rotation_y) -> np.ndarray:
    """As KITTI's devkit makes them (`computeBox3D.m`): eight corners, the level camera's frame."""
    c, s = np.cos(rotation_y), np.sin(rotation_y)
    turn = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    x = np.array([1, 1, -1, -1, 1, 1, -1, -1]) * length / 2
    y = np.array([0, 0, 0, 0, -1, -1, -1, -1]) * height
    z = np.array([1, -1, -1, 1, 1, -1, -1, 1]) * width / 2
    return turn @ np.stack([x, y, z]) + np.array(location)[:, None]


def upright(rotation) -> bool:
    """Whether a box leans by less than a degree: KITTI's turn about one axis."""
    w, x, y, z = rotation
    return 1 - 2 * (x * x + y * y) > np.cos(np.radians(0.5))


def kitti_object(truth: Truth, folder: pathlib.Path) -> None:
    listed = {row["name"]: row for row in csv.DictReader((folder / "frames.csv").open())}
    parts = {}
    for split in ("train", "val"):
        numbers = (folder / f"ImageSets/{split}.txt").read_text().split()
        parts[split] = [f"{listed[n]['video']}_{listed[n]['camera']}_{int(listed[n]['frame']):06}" for n in numbers]
    one_video_one_part(parts)
    check(sum(map(len, parts.values())) == len(truth.frames) == len(listed), "pictures are missing")
    count, compared, worst = 0, 0, 0.0
    for number, row in listed.items():
        frame = truth.by_name[f"{row['video']}_{row['camera']}_{int(row['frame']):06}"]
        check((folder / f"training/image_2/{number}.png").is_file(), "no picture", number)
        calibration = dict(line.split(": ", 1) for line in (folder / f"training/calib/{number}.txt").read_text().splitlines())
        projection = matrix(calibration["P2"], 3)
        check(set(calibration) == {"P0", "P1", "P2", "P3", "R0_rect", "Tr_velo_to_cam", "Tr_imu_to_velo"}, "calibration", number)
        lines = [line.split() for line in (folder / f"training/label_2/{number}.txt").read_text().splitlines()]
        ridden = {o["id"] for o in frame.objects if "with_rider" in o}
        expected = [o for o in frame.objects if o.get("vehicle_id") not in ridden]
        check(len(lines) == len(expected), "labels of", number, len(lines), len(expected))
        for line, o in zip(lines, expected):
            check(len(line) == 15, "fields", line)
            both = o.get("with_rider")
            kind = "Cyclist" if o["class"] == "bicycle" and both else KINDS.get(o["class"], "Misc")
            check(line[0] == kind or (line[0], o.get("action")) == ("Person_sitting", "sitting"), line[0], o["class"])
            x, y, w, h = (both or o)["bbox"]
            check(list(map(float, line[4:8])) == [x, y, x + w - 1, y + h - 1], "box of", number, o["id"])
            truncated, occluded, alpha, rotation_y = float(line[1]), int(line[2]), float(line[3]), float(line[14])
            check(abs(truncated - o["truncation"]) < 0.006 and occluded in (0, 1, 2), line)
            box = (both or o).get("box3d") or o["box3d"]
            height, width, length = map(float, line[8:11])
            check(np.allclose([length, width, height], box["size"], atol=1e-3), "size of", number, o["id"])
            location = np.array(line[11:14], float)
            expected_alpha = rotation_y - np.arctan2(location[0], location[2])
            check(abs((alpha - expected_alpha + np.pi) % (2 * np.pi) - np.pi) < 1e-4, "alpha of", number, o["id"])
            count += 1
            if upright(box["rotation"]) and all(box["corners"]) and o["distance_m"] > 5:
                homogeneous = projection @ np.vstack([kitti_corners(height, width, length, location, rotation_y), np.ones(8)])
                pixels = (homogeneous[:2] / homogeneous[2]).T
                # The same eight corners in another order.
                apart = np.linalg.norm(pixels[:, None] - np.array(box["corners"])[None], axis=2).min(axis=1)
                # A pixel is so many metres at a corner's own depth: those beside the camera may be much nearer than the middle.
                worst = max(worst, (apart * homogeneous[2] / projection[0, 0]).max())
                compared += 1
    # Metres on the object: what a lean of half a degree moves at the top, and a lens that bends.
    check(compared > 0 and worst < 0.25, "corners are off by", worst, "m")
    print(f"  {count} objects; corners of {compared} within {100 * worst:.1f} cm")


def kitti_raw(truth: Truth, folder: pathlib.Path) -> None:
    import pykitti

    pictures = 0
    for split in ("train", "val"):
        for place in sorted((folder / split).iterdir()):
            drive = pykitti.raw(str(place), "2026_01_01", place.name)
            frame = truth.frames[pictures_before(truth, int(place.name))]
            check(len(drive.cam2_files) == len(drive.timestamps) or len(drive.cam2_files) > 0, "pictures of", place)
            record = frame.record
            check(np.allclose(drive.calib.K_cam2, record["intrinsics_matrix"]), "intrinsics of", place)
            # A point ten metres ahead of the level sensor is where the camera's own pose has it.
            world = np.array(record["world_from_camera"])
            ahead = world[:2, 2] / np.linalg.norm(world[:2, 2])
            point = world[:3, 3] + 10 * np.array([*ahead, 0])
            own = np.linalg.inv(world) @ [*point, 1]
            theirs = drive.calib.T_cam2_velo @ [10, 0, 0, 1]
            check(np.allclose(own, theirs, atol=1e-4), "sensor of", place, own, theirs)
            pictures += len(drive.cam2_files)
    check(pictures == len(truth.frames), "pictures are missing")
    print(f"  {pictures} pictures")


def pictures_before(truth: Truth, sequence: int) -> int:
    """Place of a sequence's first frame."""
    starts = [i for i, f in enumerate(truth.frames) if i == 0 or (f.video, f.camera) != (truth.frames[i - 1].video, truth.frames[i - 1].camera)]
    return starts[sequence]


def nuscenes(truth: Truth, folder: pathlib.Path) -> None:
    from nuscenes.nuscenes import NuScenes
    from nuscenes.utils.geometry_utils import BoxVisibility

    with contextlib.redirect_stdout(io.StringIO()):
        tables = NuScenes(version="v1.0-endless", dataroot=str(folder), verbose=False)
    check(len(tables.scene) == len(truth.videos), "scenes are missing")
    check(len(tables.sample_data) == len(truth.frames), "pictures are missing")
    parts = json.loads((folder / "v1.0-endless/splits.json").read_text())
    check(sorted(sum(parts.values(), [])) == sorted(scene["name"] for scene in tables.scene), "splits")
    count, worst = 0, 0.0
    for sample in tables.sample:
        for channel, token in sample["data"].items():
            path, boxes, intrinsics = tables.get_sample_data(token, box_vis_level=BoxVisibility.NONE)
            frame = truth.by_name[pathlib.Path(path).stem]
            check(pathlib.Path(path).is_file(), "no picture", path)
            check(np.allclose(intrinsics, frame.record["intrinsics_matrix"]), "intrinsics of", frame.name)
            # The devkit has moved the boxes into the camera's frame: the middles are ours.
            found = np.array([box.center for box in boxes]).reshape(-1, 3)
            ridden = {o["id"] for o in frame.objects if "with_rider" in o}
            for o in frame.objects:
                if o.get("vehicle_id") in ridden:
                    continue
                own = (o.get("with_rider") or {}).get("box3d") or o["box3d"]
                apart = np.linalg.norm(found - own["center_in_camera"], axis=1)
                nearest = int(apart.argmin())
                worst = max(worst, apart[nearest])
                length, width, height = own["size"]
                check(np.allclose(boxes[nearest].wlh, [width, length, height]), "size of", frame.name, o["id"])
                count += 1
    check(worst < 0.02, "boxes are off by", worst, "m")
    for instance in tables.instance:
        token, chain = instance["first_annotation_token"], 0
        while token:
            annotation = tables.get("sample_annotation", token)
            check(annotation["instance_token"] == instance["token"], "a chain of annotations leaves its object")
            token, chain = annotation["next"], chain + 1
        check(chain == instance["nbr_annotations"], "annotations of", instance["token"])
    velocity = [tables.box_velocity(a["token"]) for a in tables.sample_annotation[:50]]
    check(np.isfinite(np.array(velocity)).any(), "no velocities")
    print(f"  {count} boxes within {1000 * worst:.1f} mm, {len(tables.instance)} tracks")


def ai_city(truth: Truth, folder: pathlib.Path) -> None:
    classes = [line.split(" ", 1)[1] for line in (folder / "classes.txt").read_text().splitlines()]
    lines, boxes, worst = 0, 0, 0.0
    parts = {}
    for split in ("train", "val"):
        evaluated = [line.split() for line in (folder / f"ground_truth_{split}.txt").read_text().splitlines()]
        check(all(len(row) == 11 for row in evaluated), "fields of the evaluation's lines")
        lines += len(evaluated)
        scenes = sorted((folder / split).iterdir())
        parts[split] = [f"{scene.name}_camera_a" for scene in scenes]
        for scene in scenes:
            sensors = {s["id"]: s for s in json.loads((scene / "calibration.json").read_text())["sensors"]}
            entries = json.loads((scene / "ground_truth.json").read_text())
            own = [row for row in evaluated if int(row[0]) == int(scene.name[:4])]
            check(len(own) == sum(map(len, entries.values())), "lines of", scene)
            for row in own:
                check(row[2] in {str(e["object id"]) for e in entries[row[3]]} and 0 <= int(row[1]) < len(classes), row)
            for name, sensor in sensors.items():
                projection = np.array(sensor["cameraMatrix"])
                for frame in (f for f in truth.frames if f.video["name"] == scene.name and f.camera == name):
                    seen = {e["object id"]: e for e in entries.get(str(frame.number), [])}
                    for o in frame.objects:
                        x, y, w, h = o["bbox"]
                        entry = seen[o["id"]]
                        check(entry["2d bounding box visible"][name] == [x, y, x + w, y + h], frame.name, o["id"])
                        check(entry["object type"] == o["class"], frame.name, o["id"])
                        if all(o["box3d"]["corners"]) and frame.record["lens"]["model"] == "pinhole":
                            at = projection @ [*entry["3d location"], 1]
                            middle = np.mean(o["box3d"]["corners"], axis=0)
                            worst = max(worst, np.linalg.norm(at[:2] / at[2] - middle) * o["distance_m"] / 1000)
                        boxes += 1
                gt = (scene / name / "gt/gt.txt").read_text().splitlines()
                own = [o for f in truth.frames if f.video["name"] == scene.name and f.camera == name for o in f.objects]
                check(len(gt) == len(own), "lines of gt.txt in", scene, name)
    one_video_one_part(parts)
    check(boxes == truth.boxes and lines > 0, boxes, "boxes")
    print(f"  {boxes} boxes of cameras, {lines} of objects in the world")
