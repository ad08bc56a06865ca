#!/usr/bin/env python3
"""Checks a dataset independently of the program that made it: needs Pillow and NumPy only (pycocotools judges keypoints,
where it is installed).

    python3 scripts/check_dataset.py OUT

Recomputes every box from the instance images, decodes depth, projects 3D boxes by `camera.json`, decodes amodal masks,
checks counts, sizes and alignment, and compares the other layers with these: normals with the gradient of depth. What
belongs to the scene is checked in check_scene.py: maps are projected again, signals must count down to their changes.
Flow is followed to the next frame and back in check_flow.py.
"""

import json
import pathlib
import sys

import check_flow
import check_scene
import check_shadow
import numpy as np
from PIL import Image
from png16 import read_png16

FAR_PLANE_M = 1000.0
UNLABELED, SKY, PEDESTRIANS, RIDER = 0, 11, 12, 13
# Numbers of body parts: above and below elbows and wrists, left and right in turn, as COCO's keypoints 7 to 10.
JOINTS = ((10, 12), (11, 13), (12, 3), (13, 2))
CARRIED = 15
# Fields of a 3D box that differ from camera to camera.
CAMERA_S_OWN = ("center_in_camera", "rotation_in_camera", "corners")


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


def check_keypoints(line: dict, ids: np.ndarray, known: bool, where: str) -> int:
    """Number of people whose keypoints lie where they should; none, from simulators that do not know any."""
    height, width = ids.shape
    people = 0
    for o in line["objects"]:
        has = known and o["class"] in ("pedestrian", "rider")
        assert ("keypoints" in o) == has, f"{where}: keypoints of a {o['class']}"
        if "keypoints" not in o:
            continue
        x, y, v = np.array(o["keypoints"]).reshape(17, 3).T
        assert o["num_keypoints"] == (v > 0).sum(), f"{where}: num_keypoints of {o['id']}"
        assert not x[v == 0].any() and not y[v == 0].any(), f"{where}: {o['id']} has places outside"
        assert ((x >= 0) & (x <= width) & (y >= 0) & (y <= height)).all(), f"{where}: {o['id']} outside"
        for px, py in zip(x[v == 2].astype(int), y[v == 2].astype(int)):
            own = ids[max(py - 1, 0) : py + 2, max(px - 1, 0) : px + 2] == o["id"]
            assert own.any(), f"{where}: {o['id']} is seen where others are"
        people += 1
    return people


def check_with_coco(out: pathlib.Path, labels: dict, recipe: dict) -> None:
    """Where pycocotools is installed: it reads our people as `person_keypoints`, and they match themselves fully."""
    try:
        from pycocotools.coco import COCO
        from pycocotools.cocoeval import COCOeval
    except ImportError:
        print("pycocotools is not installed: not judged by COCO's own code")
        return
    width, height = (int(n) for n in recipe["size"].split("x"))
    person = {"id": 1, "name": "person", "keypoints": labels["keypoints"], "skeleton": labels["skeleton"]}
    images, annotations = [], []
    for path in sorted(out.glob("videos/*/camera_*/objects.jsonl")):
        for line in path.read_text().splitlines():
            line = json.loads(line)
            images.append({"id": len(images) + 1, "width": width, "height": height, "file_name": str(path.parent)})
            for o in line["objects"]:
                if o.get("num_keypoints", 0) > 0:
                    annotations.append(
                        {
                            "id": len(annotations) + 1,
                            "image_id": images[-1]["id"],
                            "category_id": 1,
                            "iscrowd": 0,
                            "area": o["pixels"],
                            **{key: o[key] for key in ("bbox", "keypoints", "num_keypoints")},
                        }
                    )
    truth = COCO()
    truth.dataset = {"images": images, "annotations": annotations, "categories": [person]}
    truth.createIndex()
    if annotations:
        found = truth.loadRes([{**a, "score": 1.0} for a in annotations])
        judge = COCOeval(truth, found, "keypoints")
        # As many as there are: COCO keeps the twenty best of a picture.
        judge.params.maxDets = [len(annotations)]
        judge.evaluate()
        matched = sum(int((e["dtMatches"][-1] > 0).sum()) for e in judge.evalImgs if e and e["aRng"] == [0, 1e10])
        assert matched == len(annotations), f"COCO matches {matched} of {len(annotations)} people with themselves"
    print(f"COCO's own code reads {len(annotations)} people with keypoints in {len(images)} pictures")


def rotation_matrix(w: float, x: float, y: float, z: float) -> np.ndarray:
    """Of a unit quaternion."""
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def radius_of(lens: dict, theta: np.ndarray) -> np.ndarray:
    """Where a fisheye shows an angle from the optical axis, focal lengths from the middle."""
    return theta * (1 + sum(k * theta ** (2 * i + 2) for i, k in enumerate(lens["distortion"])))


def project(record: dict, world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pixels, through the lens, and depths of points in the world, by `camera.json` alone."""
    pose = np.array(record["world_from_camera"])
    x, y, z = ((world - pose[:3, 3]) @ pose[:3, :3]).T
    k, lens = record["intrinsics"], record["lens"]
    r, distance = np.hypot(x, y), np.sqrt(x * x + y * y + z * z)
    depth = distance if lens.get("depth") == "distance" else z
    if lens["model"] == "opencv_fisheye":
        theta = np.arctan2(r, z)
        bent = radius_of(lens, theta) / np.maximum(r, 1e-12)
        p = np.stack([x * bent, y * bent], axis=-1)
        depth = np.where(theta <= lens["max_angle_rad"] + 1e-5, depth, -1)
    elif lens["model"] == "equirectangular":
        p = np.stack([np.arctan2(x, z), np.arctan2(y, np.hypot(x, z))], axis=-1)
    elif lens["model"] == "orthographic":
        p = np.stack([x, y], axis=-1)
    else:
        u, v = x / z, y / z
        k1, k2 = lens["distortion"][:2]
        bend = 1 + (u * u + v * v) * (k1 + k2 * (u * u + v * v))
        p = np.stack([u * bend, v * bend], axis=-1)
    return p * [k["fx"], k["fy"]] + [k["cx"], k["cy"]], depth


def corners_of(box: dict) -> np.ndarray:
    """Corners of a 3D box in the world: the lower four from the front left one, against the clock, then the upper."""
    signs = np.array([[x, y, z] for z in (-1, 1) for x, y in ((1, 1), (-1, 1), (-1, -1), (1, -1))])
    return np.array(box["center"]) + (signs * np.array(box["size"]) / 2) @ rotation_matrix(*box["rotation"]).T


def mask_of(counts: str, height: int, width: int) -> np.ndarray:
    """COCO's compressed run lengths, column by column."""
    runs, i = [], 0
    while i < len(counts):
        value, shift, more = 0, 0, True
        while more:
            bits = ord(counts[i]) - 48
            value |= (bits & 0x1F) << shift
            shift, more, i = shift + 5, bool(bits & 0x20), i + 1
        if bits & 0x10:
            value -= 1 << shift
        runs.append(value + (runs[-2] if len(runs) > 2 else 0))
    inside = np.repeat(np.arange(len(runs)) % 2 == 1, runs)
    return inside.reshape(width, height).T


def check_shapes(line: dict, record: dict, ids: np.ndarray, tags: np.ndarray, depth, where: str) -> None:
    """Boxes in space, amodal boxes, what hides objects: from the images and `camera.json` alone."""
    height, width = ids.shape
    for o in line["objects"]:
        who = f"{where}: object {o['id']}"
        if "box3d" in o:
            box = o["box3d"]
            pixels, z = project(record, corners_of(box))
            for written, exact, ahead in zip(box["corners"], pixels, z):
                assert (written is None) or ahead > 0, f"{who}: a corner behind the camera"
                if written is not None and (np.abs(exact) < 2 * width).all():
                    off = np.abs(np.array(written) - exact)
                    if record["lens"]["model"] == "equirectangular":
                        off[0] = min(off[0], abs(2 * np.pi * record["intrinsics"]["fx"] - off[0]))
                    assert off.max() < 0.5, f"{who}: corners"
            pose = np.array(record["world_from_camera"])
            before = (np.array(box["center"]) - pose[:3, 3]) @ pose[:3, :3]
            assert np.abs(before - box["center_in_camera"]).max() < 2e-3, f"{who}: center_in_camera"
            assert abs(np.linalg.norm(before) - o["distance_m"]) < 2e-3, f"{who}: distance"
            turned = pose[:3, :3].T @ rotation_matrix(*box["rotation"])
            assert np.abs(turned - rotation_matrix(*box["rotation_in_camera"])).max() < 1e-3, f"{who}: rotation"
            if depth is not None:
                radial = record["lens"].get("depth") == "distance"
                reach = np.linalg.norm(box["size"]) / 2 if radial else np.abs(turned[2]) @ np.array(box["size"]) / 2
                own = depth[ids == o["id"]]
                middle = np.linalg.norm(before) if radial else before[2]
                assert np.abs(own - middle).max() <= reach + 0.02, f"{who}: pixels nearer or farther than its box"
        if "amodal_bbox" not in o:
            continue
        x, y, w, h = o["bbox"]
        cx, cy, cw, ch = o["amodal_bbox_clipped"]
        ax, ay, aw, ah = o["amodal_bbox"]
        assert cx <= x and cy <= y and cx + cw >= x + w and cy + ch >= y + h, f"{who}: visible outside amodal"
        assert ax <= cx and ay <= cy and ax + aw >= cx + cw and ay + ah >= cy + ch, f"{who}: clipped outside whole"
        assert o["pixels"] + sum(q["pixels"] for q in o["occluders"]) == o["amodal_pixels"], f"{who}: sums"
        assert abs(o["visibility"] - o["pixels"] / o["amodal_pixels"]) < 1e-3, f"{who}: visibility"
        assert abs(o["truncation"] - (1 - cw * ch / (aw * ah))) < 1e-3, f"{who}: truncation"
        # Where straight lines bend, what a box holds may reach beyond its corners.
        if "box3d" in o and all(o["box3d"]["corners"]) and record["lens"]["model"] in ("pinhole", "opencv", "orthographic"):
            low, high = np.min(o["box3d"]["corners"], axis=0), np.max(o["box3d"]["corners"], axis=0)
            first, last = np.array([ax, ay]) + 0.5, np.array([ax + aw, ay + ah]) - 0.5
            assert (low <= first + 1).all() and (high >= last - 1).all(), f"{who}: amodal box leaves the 3D box"
        if "amodal_mask" in o:
            mask = mask_of(o["amodal_mask"], height, width)
            assert mask.sum() == o["amodal_pixels"] and mask[ids == o["id"]].all(), f"{who}: amodal mask"
            rows, columns = np.nonzero(mask)
            tight = [columns.min(), rows.min(), np.ptp(columns) + 1, np.ptp(rows) + 1]
            assert tight == o["amodal_bbox_clipped"], f"{who}: amodal mask and box"
            hiding = mask & (ids != o["id"])
            takers: dict[tuple[int, int], int] = {}
            for taker in zip(ids[hiding].tolist(), tags[hiding].tolist()):
                takers[taker] = takers.get(taker, 0) + 1
            assert takers == {(q["id"], q["tag"]): q["pixels"] for q in o["occluders"]}, f"{who}: occluders"
        else:
            for q in o["occluders"]:
                there = (ids == q["id"]) & (tags == q["tag"])
                assert there[cy : cy + ch, cx : cx + cw].sum() >= q["pixels"], f"{who}: occluder {q['id']}"


def load(path: pathlib.Path, size: tuple[int, int]) -> np.ndarray:
    with Image.open(path) as image:
        assert image.mode == "RGB" and image.size == size, f"{path}: {image.mode} {image.size}"
        return np.asarray(image).astype(np.int64)


def rays_of(record: dict) -> np.ndarray:
    """(H, W, 3): through the centre of each pixel, camera frame, of depth 1; 0 where the lens shows nothing. Of parallel rays
    all are alike."""
    k, lens = record["intrinsics"], record["lens"]
    width, height = record["size"]["width"], record["size"]["height"]
    x = (np.arange(width) + 0.5 - k["cx"]) / k["fx"]
    y = (np.arange(height) + 0.5 - k["cy"]) / k["fy"]
    bent = np.stack(np.meshgrid(x, y), axis=2)
    if lens["model"] == "orthographic":
        return np.broadcast_to(np.array([0.0, 0.0, 1.0]), (height, width, 3))
    if lens["model"] == "equirectangular":
        shown = (abs(bent) <= [np.pi, np.pi / 2]).all(axis=2, keepdims=True)
        (lon, lat) = np.moveaxis(bent, 2, 0)
        return shown * np.stack([np.sin(lon) * np.cos(lat), np.sin(lat), np.cos(lon) * np.cos(lat)], axis=2)
    if lens["model"] == "opencv_fisheye":
        radius = np.linalg.norm(bent, axis=2, keepdims=True)
        table = np.linspace(0, lens["max_angle_rad"], 100_000)
        theta = np.interp(radius, radius_of(lens, table), table)
        shown = radius <= radius_of(lens, np.array(lens["max_angle_rad"]))
        return shown * np.concatenate([bent / np.maximum(radius, 1e-12) * np.sin(theta), np.cos(theta)], axis=2)
    k1, k2 = lens["distortion"][:2]
    straight = bent.copy()
    for _ in range(20):
        r2 = (straight**2).sum(axis=2, keepdims=True)
        straight = bent / (1 + r2 * (k1 + k2 * r2))
    return np.concatenate([straight, np.ones((height, width, 1))], axis=2)


def starts_of(record: dict) -> np.ndarray:
    """(H, W, 3): where the rays through the centres of pixels start, camera frame: parallel ones beside each other."""
    k, (width, height) = record["intrinsics"], (record["size"]["width"], record["size"]["height"])
    starts = np.zeros((height, width, 3))
    if record["lens"]["model"] == "orthographic":
        starts[..., 0] = (np.arange(width) + 0.5 - k["cx"]) / k["fx"]
        starts[..., 1] = ((np.arange(height) + 0.5 - k["cy"]) / k["fy"])[:, None]
    return starts


def check_normals(stored: np.ndarray, depth: np.ndarray, tags: np.ndarray, rays: tuple[np.ndarray, np.ndarray], where: str) -> np.ndarray:
    """Angles, in degrees, between normals and the gradient of depth on planes."""
    rays, starts = rays
    known = stored.any(axis=2)
    assert (known == ((tags != SKY) & (tags != UNLABELED))).all(), f"{where}: normals of the sky"
    normal = 2.0 * stored / 65535 - 1
    length = np.linalg.norm(normal[known], axis=1)
    assert (abs(length - 1) < 1e-4).all(), f"{where}: normals of length {length.min()} to {length.max()}"
    assert ((normal * rays).sum(axis=2)[known] < 1e-3).all(), f"{where}: normals that look away"
    # Planes: within three pixels, all have the same normal and lie evenly.
    points = starts + rays * depth[..., None]
    pixel_m = starts[0, 1, 0] - starts[0, 0, 0]
    far = 3
    middle = (slice(far, -far), slice(far, -far))
    plane = known & (depth < 60)
    plane = plane[middle]
    for dy in range(-far, far + 1):
        for dx in range(-far, far + 1):
            there = (slice(far + dy, stored.shape[0] - far + dy), slice(far + dx, stored.shape[1] - far + dx))
            same = (abs(stored[there].astype(int) - stored[middle]) <= 1).all(axis=2)
            plane &= same & (tags[there] == tags[middle])
            if dx == 0 or dy == 0:
                back = (slice(far - dy, stored.shape[0] - far - dy), slice(far - dx, stored.shape[1] - far - dx))
                # On a plane the inverse of depth is linear in the picture (but for the bend of the lens): no step lies between.
                # Of parallel rays depth itself is.
                if pixel_m > 0:
                    plane &= abs(depth[there] + depth[back] - 2 * depth[middle]) < 5e-4 * 2 * far * pixel_m
                else:
                    uneven = abs(1 / depth[there] + 1 / depth[back] - 2 / depth[middle])
                    plane &= uneven * depth[middle] < 5e-4
    right = points[far:-far, 2 * far :] - points[far:-far, : -2 * far]
    down = points[2 * far :, far:-far] - points[: -2 * far, far:-far]
    gradient, normal = np.cross(down, right)[plane], normal[middle][plane]
    sine = np.linalg.norm(np.cross(gradient, normal), axis=1)
    return np.degrees(np.arctan2(sine, (gradient * normal).sum(axis=1)))


def check_joints(line: dict, ids: np.ndarray, parts: np.ndarray, joints: list[bool]) -> None:
    """Adds whether each elbow and wrist that is seen has one of its two parts beside it; people of a few pixels have no arms."""
    for o in (o for o in line["objects"] if o["bbox"][3] >= 30):
        for (x, y, v), own in zip(np.array(o.get("keypoints", [])).reshape(-1, 3)[7:11], JOINTS):
            if v == 2:
                reach = 1 + o["bbox"][3] // 60
                there = (slice(max(int(y) - reach, 0), int(y) + reach + 1), slice(max(int(x) - reach, 0), int(x) + reach + 1))
                joints.append(bool(np.isin(parts[there][ids[there] == o["id"]], own).any()))


def check_layers(
    camera: pathlib.Path, recipe: dict, frame: int, known: dict, rays: tuple[np.ndarray, np.ndarray], joints: list[bool]
) -> list[np.ndarray]:
    """What the other layers say of a frame; angles of normals to the gradient of depth."""
    tags, ids, depth = known["tags"], known["ids"], known["depth"]
    size = (tags.shape[1], tags.shape[0])
    name, where = f"{frame:06}.png", f"{camera}: frame {frame}"
    if "semantic" in recipe["layers"]:
        semantic = load(camera / "semantic" / name, size)
        assert (semantic[..., 0] == tags).all() and not semantic[..., 1:].any(), f"{where}: semantic"
    if "panoptic" in recipe["layers"]:
        segment = load(camera / "panoptic" / name, size) @ np.array([1, 256, 65536])
        assert (segment == ids + 65536 * tags).all(), f"{where}: panoptic"
    if "albedo" in recipe["layers"]:
        albedo = load(camera / "albedo" / name, size)
        assert not albedo[(tags == SKY) | (tags == UNLABELED)].any(), f"{where}: albedo of the sky"
    if "body_parts" in recipe["layers"]:
        parts = load(camera / "body_parts" / name, size)
        assert parts.max() <= CARRIED and not parts[..., 1:].any(), f"{where}: body parts"
        assert ((parts[..., 0] > 0) == ((tags == PEDESTRIANS) | (tags == RIDER))).all(), f"{where}: parts of nobody"
        check_joints(known["line"], ids, parts[..., 0], joints)
    if "normals" in recipe["layers"] and depth is not None:
        return [check_normals(read_png16(camera / "normals" / name), depth, tags, rays, where)]
    return []


def sensor_cameras(folder: pathlib.Path, recipe: dict) -> list[tuple[pathlib.Path, dict, range]]:
    """The cameras of a video's rig, with what they have of their own in place of the recipe's, and their frames."""
    found = []
    for sensor in recipe.get("sensor", []):
        if sensor["type"] == "camera":
            own = {key: sensor[key] for key in ("size", "layers") if key in sensor}
            every = round(recipe["fps"] / sensor.get("rate", recipe["fps"]))
            found.append((folder / sensor["name"], {**recipe, **own}, range(0, round(recipe["fps"] * recipe["duration"]), every)))
    return found


def check_camera(camera: pathlib.Path, recipe: dict, frames: range, tag_of_class: dict[str, int]) -> int:
    """Number of boxes that were compared."""
    record = json.loads((camera / "camera.json").read_text())
    poses = {}
    if (camera / "poses.jsonl").is_file():
        lines = [json.loads(line) for line in (camera / "poses.jsonl").read_text().splitlines()]
        poses = {line["frame"]: {key: line[key] for key in ("world_from_camera", "intrinsics")} for line in lines}
        assert list(poses) == list(frames), f"{camera}: lines of poses.jsonl"
    size = (record["size"]["width"], record["size"]["height"])
    assert f"{size[0]}x{size[1]}" == recipe["size"], f"{camera}: size {size}"
    lines = [json.loads(line) for line in (camera / "objects.jsonl").read_text().splitlines()]
    assert [line["frame"] for line in lines] == list(frames), f"{camera}: lines of objects.jsonl"
    compared = 0
    angles, joints = [], []
    for layer in recipe["layers"]:
        extension = recipe["rgb_format"] if layer == "rgb" else "png"
        names = sorted(p.name for p in (camera / layer).iterdir())
        assert names == [f"{f:06}.{extension}" for f in frames], f"{camera / layer}: names"
    for line in lines:
        frame = line["frame"]
        record |= poses.get(frame, {})
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
        check_keypoints(line, ids, recipe["simulator"] == "builtin", f"{camera}: frame {frame}")
        check_shapes(line, record, ids, tags, depth, f"{camera}: frame {frame}")
        if depth is not None:
            nothing = (tags == SKY) | (tags == UNLABELED)
            assert (depth[nothing] == FAR_PLANE_M).all(), f"{camera}: sky nearer than the far plane, frame {frame}"
            assert (depth[ids > 0] < FAR_PLANE_M).all(), f"{camera}: object on the far plane, frame {frame}"
            assert (depth > 0).all(), f"{camera}: zero depth, frame {frame}"
        rays = (rays_of(record), starts_of(record)) if "normals" in recipe["layers"] else None
        angles += check_layers(camera, recipe, frame, {"tags": tags, "ids": ids, "depth": depth, "line": line}, rays, joints)
    assert np.sum(np.array(joints) == 0) <= 0.05 * len(joints) + 3, f"{camera}: joints away from their parts"
    if angles:
        angles = np.concatenate(angles)
        within = (angles < 0.5).mean() if len(angles) else 1.0
        print(f"{camera.name}: {len(angles)} normals on planes, {within:.3%} within 0.5 degrees of the gradient of depth")
        assert within > 0.99, f"{camera}: normals and depth disagree"
    return compared


def check_actors(folder: pathlib.Path, scene: dict, seen: dict[int, dict], schema: dict) -> int:
    """Number of objects that `actors.json` describes: all that are seen, as `objects.jsonl` says, in known words."""
    if "actors" not in scene:
        return 0
    actors = json.loads((folder / "actors.json").read_text())
    by_id = {a["id"]: a for a in actors}
    assert [a["id"] for a in actors] == sorted(by_id), f"{folder}: actors.json is not sorted by id, or has one twice"
    assert len(actors) == scene["actors"], f"{folder}: number of actors"
    for i, o in seen.items():
        for key in ("class", "parked", "rider_id", "vehicle_id"):
            assert by_id[i].get(key) == o.get(key), f"{folder}: {key} of object {i} in actors.json and objects.jsonl"
        tone = by_id[i].get("person", o).get("skin_tone")
        assert tone == o.get("skin_tone"), f"{folder}: skin of object {i}"
    counts = {kind: sum(a["class"] == kind for a in actors) for kind in ("pedestrian", "rider")}
    assert counts["pedestrian"] == scene["spawned"]["pedestrians"], f"{folder}: number of pedestrians"
    assert sum(a["parked"] for a in actors) == scene["spawned"]["parked"], f"{folder}: number of parked vehicles"
    described = {f["name"] for f in schema["fields"]}
    for a in actors:
        who = f"{folder}: object {a['id']}"
        for key, value in a.items():
            nested = isinstance(value, dict) and key in ("person", "vehicle", "occupants")
            names = {f"{key}.{k}" for k in value} if nested else {key}
            assert names <= described, f"{who}: {names - described} are not described in dataset.json"
        human = a["class"] in ("pedestrian", "rider")
        assert not ("person" in a and not human) and not ("vehicle" in a and human), f"{who} is described as another"
        if "occupants" in a:
            assert not human and a["occupants"]["driver"] == (not a["parked"]), f"{who}: driver"
            assert not (a["parked"] and a["occupants"]["passengers"]), f"{who}: passengers"
        if "vehicle_id" in a:
            assert by_id[a["vehicle_id"]]["rider_id"] == a["id"], f"{who}: rider"
        if "rider_id" in a:
            assert by_id[a["rider_id"]]["vehicle_id"] == a["id"], f"{who}: ridden"
        if "reid" in a:
            assert len(a["reid"]) == 16 and int(a["reid"], 16) >= 0, f"{who}: reid"
        for color in colors_of(a):
            assert color["name"] in schema["colors"], f"{who}: {color}"
            assert len(color["rgb"]) == 3 and all(0 <= c <= 255 for c in color["rgb"]), f"{who}: {color}"
    return len(actors)


def colors_of(value) -> list[dict]:
    """All named colours within a value."""
    if isinstance(value, list):
        return [color for item in value for color in colors_of(item)]
    if not isinstance(value, dict):
        return []
    own = [value] if set(value) == {"name", "rgb"} else []
    return own + colors_of(list(value.values()))


def looks_agree(looks: dict[str, list]) -> int:
    """Number of looks; objects with one `reid` have the same attributes in all videos, others differ."""
    for reid, described in looks.items():
        assert all(d == described[0] for d in described), f"reid {reid} is of different looks"
    return len(looks)


def main() -> None:
    out = pathlib.Path(sys.argv[1])
    dataset = json.loads((out / "dataset.json").read_text())
    recipe = dataset["recipe"]
    frames = round(recipe["fps"] * recipe["duration"])
    tag_of_class = {c["name"]: c["tag"] for c in dataset["labels"]["classes"]}
    assert len(dataset["videos"]) == recipe["videos"], "number of videos"
    compared, described, places = 0, 0, 0
    judged: list[str] = []
    flow, darker = check_flow.Agreement(), []
    looks: dict[str, list] = {}
    for video in dataset["videos"]:
        assert video["state"] == "complete", f"{video['name']} is not complete"
        folder = out / "videos" / video["name"]
        class_of_id: dict[int, str] = {}
        seen: dict[int, dict] = {}
        place_of: dict[tuple[int, int], tuple] = {}
        cameras = sorted(p.name for p in folder.glob("camera_*"))
        assert cameras == [f"camera_{c}" for c in "abcdefgh"[: recipe["cameras_per_scene"]]], f"{folder}: cameras"
        assert len(video["cameras"]) == len(video["boxes"]) == len(cameras), f"{folder}: cameras in dataset.json"
        places += check_scene.check_video(folder, recipe)
        own = [(folder / camera, recipe, range(frames)) for camera in cameras]
        for number, (camera, has, at) in enumerate(own + sensor_cameras(folder, recipe)):
            boxes = check_camera(camera, has, at, tag_of_class)
            if number < len(own):
                if "instance" in recipe["layers"]:
                    assert boxes == video["boxes"][number], f"{camera}: number of boxes"
                check_flow.check_camera(flow, camera, recipe, frames)
                darker += check_shadow.check_camera(camera, recipe)
            else:
                judged.append(f"{camera.name} ({boxes} boxes)")
            compared += boxes
            for line in (camera / "objects.jsonl").read_text().splitlines():
                line = json.loads(line)
                for o in line["objects"]:
                    place = (o["position"], {**o.get("box3d", {}), **dict.fromkeys(CAMERA_S_OWN)})
                    other = place_of.setdefault((line["frame"], o["id"]), place)
                    assert other == place, f"{folder}: object {o['id']} is in two places in frame {line['frame']}"
                    seen.setdefault(o["id"], o)
                    same = class_of_id.setdefault(o["id"], o["class"])
                    assert same == o["class"], f"{folder}: object {o['id']} is {same} and {o['class']}"
        scene = json.loads((folder / "scene.json").read_text())
        described += check_actors(folder, scene, seen, dataset["labels"].get("actors", {}))
        for actor in json.loads((folder / "actors.json").read_text()) if "actors" in scene else []:
            look = {key: actor[key] for key in ("class", "person", "vehicle") if key in actor}
            looks.setdefault(actor.get("reid", f"{folder} {actor['id']}"), []).append(look)
    flow.check()
    check_shadow.check(darker)
    print(f"{described} objects of {looks_agree(looks)} looks")
    if judged:
        print("cameras of rigs:", ", ".join(judged))
    check_with_coco(out, dataset["labels"], recipe)
    print(f"all is well: {len(dataset['videos'])} videos, {compared} boxes recomputed, {places} places of maps projected")


if __name__ == "__main__":
    main()
