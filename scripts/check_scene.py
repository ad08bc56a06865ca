"""Checks frames.jsonl, map.json and the ground plane of a video by camera.json alone; see check_dataset.py."""

import json
import math
import pathlib

import numpy as np

MOST_OFF_PX = 0.1
ROUNDING_S = 2e-6
SHORTEST_PHASE_S = 0.5


def fisheye(lens: dict, x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """OpenCV's fisheye, in focal lengths."""
    r = np.hypot(x, y)
    theta = np.arctan2(r, z)
    bent = theta * (1 + sum(k * theta ** (2 * i + 2) for i, k in enumerate(lens["distortion"])))
    return np.stack([x, y], axis=1) * (bent / np.maximum(r, 1e-12))[:, None]


def equirectangular(_lens: dict, x: np.ndarray, y: np.ndarray, z: np.ndarray) -> np.ndarray:
    """Longitude and latitude."""
    return np.stack([np.arctan2(x, z), np.arctan2(y, np.hypot(x, z))], axis=1)


def orthographic(_lens: dict, x: np.ndarray, y: np.ndarray, _z: np.ndarray) -> np.ndarray:
    """Metres."""
    return np.stack([x, y], axis=1)


def project(record: dict, world: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Pixels (n, 2) through the lens, and depths (n), of places in the world (n, 3)."""
    pose = np.array(record["world_from_camera"])
    x, y, depth = ((world - pose[:3, 3]) @ pose[:3, :3]).T
    k, lens = np.array(record["intrinsics_matrix"]), record["lens"]
    other = {"opencv_fisheye": fisheye, "equirectangular": equirectangular, "orthographic": orthographic}.get(lens.get("model"))
    if other:
        places = other(lens, x, y, depth) * [k[0, 0], k[1, 1]] + k[:2, 2]
        return places, np.sqrt(x * x + y * y + depth * depth) if lens.get("depth") == "distance" else depth
    k1, k2, p1, p2, k3 = record["lens"]["distortion"]
    assert p1 == p2 == k3 == 0.0
    straight = np.stack([x / depth, y / depth], axis=1)
    r2 = (straight**2).sum(axis=1, keepdims=True)
    bent = straight * (1.0 + r2 * (k1 + k2 * r2))
    return bent * [k[0, 0], k[1, 1]] + k[:2, 2], depth


def check_ground(record: dict, where: str) -> None:
    """The homography maps the ground to the same pixels as the matrices do, and its inverse takes them back."""
    plane = record["ground_plane"]
    pose = np.array(record["world_from_camera"])
    there = np.array([[pose[0, 3] + d * pose[0, 2] + dx, pose[1, 3] + d * pose[1, 2], plane["z_m"]] for d in (15, 30) for dx in (0, 4)])
    pinhole = {**record, "lens": {"distortion": [0.0] * 5}}
    pixels, depth = project(pinhole, there)
    ground = np.concatenate([there[:, :2], np.ones((len(there), 1))], axis=1)
    image = ground @ np.array(plane["homography"]).T
    assert np.allclose(image[:, 2], depth, atol=1e-4), f"{where}: depth by the homography"
    assert np.abs(image[:, :2] / image[:, 2:] - pixels).max() < MOST_OFF_PX, f"{where}: homography"
    back = image @ np.array(plane["inverse"]).T
    assert np.abs(back[:, :2] / back[:, 2:] - there[:, :2]).max() < 1e-3, f"{where}: inverse homography"


def lines_of(seen: dict) -> list[tuple[str, dict]]:
    """Every line of a map with a name for messages."""
    lanes = [(f"lane {lane['id']}", line) for lane in seen["lanes"] for of in ("center", "left", "right") for line in lane[of]]
    paint = [(f"{kind} {p['id']}", line) for kind in ("marks", "stop_lines") for p in seen[kind] for line in p["pieces"]]
    return lanes + paint


def outline_px(record: dict, outline: np.ndarray, far_m: float) -> np.ndarray:
    """Dense places along a closed outline as far as it lies before the camera, pixels."""
    closed = np.concatenate([outline, outline[:1]])
    share = np.linspace(0.0, 1.0, 400)[:, None]
    dense = np.concatenate([a + share * (b - a) for a, b in zip(closed[:-1], closed[1:])])
    pixels, depth = project(record, dense)
    return pixels[(depth > 0.9) & (depth < far_m + 0.1)]


def on_a_cut(record: dict, image: np.ndarray) -> np.ndarray:
    """Whether places lie where a lens ends or an outline is cut: at the image circle, or in the plane through the seam."""
    from_middle = (image - [record["intrinsics"]["cx"], record["intrinsics"]["cy"]]) / record["intrinsics"]["fx"]
    lens = record["lens"]
    if lens["model"] == "opencv_fisheye":
        rim = fisheye(lens, *(np.array([v]) for v in (np.sin(lens["max_angle_rad"]), 0.0, np.cos(lens["max_angle_rad"]))))[0, 0]
        return np.linalg.norm(from_middle, axis=1) > rim - 2e-3
    if lens["model"] == "equirectangular":
        return np.abs(from_middle[:, 0]) < 1e-3
    return np.zeros(len(image), dtype=bool)


def check_map(camera: pathlib.Path) -> int:
    """Number of places of a camera's map that lie where they are projected."""
    record = json.loads((camera / "camera.json").read_text())
    seen = json.loads((camera / "map.json").read_text())
    if "ground_plane" in record:
        check_ground(record, str(camera))
    else:
        assert record["lens"]["model"] not in ("pinhole", "opencv"), f"{camera}: no ground plane"
    # Where the left and right edges of the picture meet, both are right.
    round_px = 2 * np.pi * record["intrinsics"]["fx"] if record["lens"]["model"] == "equirectangular" else np.inf
    size = np.array([record["size"]["width"], record["size"]["height"]])
    places = 0
    for name, line in lines_of(seen):
        pixels, depth = project(record, np.array(line["world"]))
        image = np.array(line["image"])
        assert image.shape == pixels.shape and (depth > 0).all() and (depth < seen["far_m"] + 0.01).all(), f"{camera}: {name}"
        off = np.abs(image - pixels)
        off[:, 0] = np.minimum(off[:, 0], np.abs(round_px - off[:, 0]))
        assert off.max() < MOST_OFF_PX, f"{camera}: {name} lies elsewhere"
        assert (image >= 0).all() and (image <= size).all(), f"{camera}: {name} outside"
        places += len(image)
    for kind in ("crosswalks", "sidewalks"):
        for area in seen[kind]:
            image = np.array(area["image"])
            edge = outline_px(record, np.array(area["world"]), seen["far_m"])
            assert (image >= 0).all() and (image <= size).all(), f"{camera}: {kind} {area['id']} outside"
            depth_cut = np.array([project(record, np.array(area["world"]))[1].max() > seen["far_m"]])
            inner = image[((image > 0.02) & (image < size - 0.02)).all(axis=1)]
            inner = inner[~on_a_cut(record, inner)]
            off = [np.linalg.norm(edge - corner, axis=1).min() for corner in inner] if len(edge) else []
            # Where the far end cuts an area, its corners lie on no edge of the world.
            assert depth_cut.any() or max(off, default=0.0) < 2.0, f"{camera}: {kind} {area['id']} lies elsewhere"
            places += len(image)
    for kind in ("signals", "signs"):
        for thing in seen[kind]:
            pixels, _ = project(record, np.array([thing["position"]]))
            x, y, w, h = thing["bbox"]
            inside = (pixels[0] >= [x - 0.1, y - 0.1]).all() and (pixels[0] <= [x + w + 0.1, y + h + 0.1]).all()
            assert w > 0 and h > 0 and (inside or thing["truncated"]), f"{camera}: {kind} {thing['id']}"
            places += 1
    return places


def check_frames(folder: pathlib.Path, recipe: dict) -> dict[int, int]:
    """Number of changes of each signal group, each in the very frame that the countdown before announced."""
    lines = [json.loads(line) for line in (folder / "frames.jsonl").read_text().splitlines()]
    assert [line["frame"] for line in lines] == list(range(round(recipe["fps"] * recipe["duration"]))), f"{folder}: frames"
    changes: dict[int, int] = {}
    for line in lines:
        sun = line["light"]["sun"]
        a, h = sun["azimuth_rad"], sun["altitude_rad"]
        direction = [math.cos(a) * math.cos(h), math.sin(a) * math.cos(h), math.sin(h)]
        assert np.allclose(direction, sun["direction"], atol=1e-5) and sun["up"] == (h > 0), f"{folder}: sun"
    for before, after in zip(lines, lines[1:]):
        passed = after["time_s"] - before["time_s"]
        for b, a in zip(before["signals"], after["signals"], strict=True):
            assert a["id"] == b["id"]
            if "next" not in b:
                assert a == b, f"{folder}: signal {a['id']} in frame {after['frame']}"
                continue
            left = b["remaining_s"] - passed
            changes[a["id"]] = changes.get(a["id"], 0) + (a["aspect"] != b["aspect"])
            counts = a["aspect"] == b["aspect"] and abs(a["remaining_s"] - left) < ROUNDING_S
            changed = a["aspect"] == b["next"] or passed > SHORTEST_PHASE_S
            right = counts if left > ROUNDING_S else changed if left < -ROUNDING_S else counts or changed
            assert right, f"{folder}: signal {a['id']} in frame {after['frame']}"
    return changes


def check_video(folder: pathlib.Path, recipe: dict) -> int:
    """Number of places of the maps of a video's cameras; 0 where the simulator knew of none."""
    if (folder / "frames.jsonl").is_file():
        groups = set()
        for camera in folder.glob("camera_*"):
            if (camera / "map.json").is_file():
                groups |= {s["group"] for s in json.loads((camera / "map.json").read_text())["signals"]}
        known = {s["id"] for s in json.loads((folder / "frames.jsonl").read_text().splitlines()[0])["signals"]}
        assert groups <= known, f"{folder}: heads of unknown signal groups"
        check_frames(folder, recipe)
    return sum(check_map(camera) for camera in sorted(folder.glob("camera_*")) if (camera / "map.json").is_file())
