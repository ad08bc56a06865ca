"""Optical flow, judged by images alone: called by check_dataset.py."""

import json
import pathlib
import sys

import numpy as np
from PIL import Image
from png16 import read_png16

UNKNOWN, VISIBLE, HIDDEN, OUTSIDE = range(4)
STEP_PX = 1 / 64
# Who covers less of a picture is nothing but edge, pixels.
LEAST_PX = 16


def decoded(path: pathlib.Path) -> tuple[np.ndarray, np.ndarray]:
    """Flow in pixels, (H, W, 2), and what is seen where it leads, (H, W)."""
    stored = read_png16(path).astype(int)
    kind = stored[..., 2]
    assert (kind <= OUTSIDE).all(), f"{path}: blue {kind.max()}"
    assert not stored[kind == UNKNOWN].any(), f"{path}: unknown flow that is not 0, 0, 0"
    return (stored[..., :2] - 2**15) / 64, kind


def centres(shape: tuple[int, int]) -> np.ndarray:
    """(H, W, 2): x and y of the centre of each pixel."""
    y, x = np.mgrid[: shape[0], : shape[1]] + 0.5
    return np.stack([x, y], axis=2)


class Agreement:
    """Pixels of all cameras that agree, of how many."""

    def __init__(self) -> None:
        self.agreeing: dict[str, list[int]] = {}

    def add(self, what: str, agree: np.ndarray) -> None:
        counts = self.agreeing.setdefault(what, [0, 0])
        counts[0] += int(agree.sum())
        counts[1] += agree.size

    def check(self) -> None:
        """Some may be astray at the edges of objects, where a point is seen between pixels: more of them in small pictures."""
        for what, (agree, count) in self.agreeing.items():
            print(f"flow: {agree} of {count} pixels {what}")
            assert agree >= 0.998 * count - 5, f"flow: {count - agree} of {count} pixels do not {what}"


def compare(agreement: Agreement, path: pathlib.Path, path_back: pathlib.Path | None, now: np.ndarray, then) -> None:
    """A flow image, and the one that leads back from the frame where it leads; the instance images of both frames."""
    flow, kind = decoded(path)
    if then is None:
        assert (kind == UNKNOWN).all(), f"{path}: there is no frame where it could lead"
        return
    # Where a lens shows nothing, at tag 0, there is no flow.
    shown = np.ones(kind.shape, dtype=bool) if now is None else now[..., 0] > 0
    assert (kind[shown] != UNKNOWN).mean() > 0.99, f"{path}: unknown flow"
    height, width = kind.shape
    place = centres(kind.shape) + flow
    lens = json.loads((path.parent.parent / "camera.json").read_text())["lens"]
    if lens["model"] == "equirectangular" and lens["horizontal_fov_rad"] > 6.28:
        place[..., 0] %= width
    edge = np.minimum(place, [width, height] - place).min(axis=2)
    assert (edge[kind == OUTSIDE] <= STEP_PX).all(), f"{path}: leads into the picture"
    assert (edge[(kind == VISIBLE) | (kind == HIDDEN)] >= -STEP_PX).all(), f"{path}: leads out of the picture"
    if now is None:
        return
    same_there = (now == then).all(axis=2)
    stands = (now[..., 1:] == 0).all(axis=2) & shown
    assert not flow[stands].any(), f"{path}: stuff that moves"
    assert not same_there[stands & (kind == HIDDEN)].any(), f"{path}: stuff is hidden and seen"
    assert same_there[stands & (kind == VISIBLE)].all(), f"{path}: stuff is seen and not there"
    ids = now[..., 1] * 256 + now[..., 2]
    large = np.bincount(ids.ravel())[ids] >= LEAST_PX
    moves = (kind == VISIBLE) & flow.any(axis=2) & large
    corner = np.floor(place - 0.5).astype(int)
    four = [
        np.clip(corner + step, 0, [width - 1, height - 1])[moves].T for step in ([0, 0], [1, 0], [0, 1], [1, 1])
    ]
    own = now[moves]
    near = [(then[y, x] == own).all(axis=1) for x, y in four]
    agreement.add("lead to a place beside which the same object is", np.any(near, axis=0))
    if path_back is None:
        return
    back, kind_back = decoded(path_back)
    # On one piece of one object the flow back is interpolated.
    backs = np.array([back[y, x] for x, y in four])
    whole = np.all(near, axis=0) & np.all([kind_back[y, x] > 0 for x, y in four], axis=0)
    whole &= (np.linalg.norm(backs - backs[0], axis=2) < 0.15).all(axis=0)
    share = (place - 0.5 - corner)[moves]
    weights = [(1 - share[:, :1]) * (1 - share[:, 1:]), share[:, :1] * (1 - share[:, 1:])]
    weights += [(1 - share[:, :1]) * share[:, 1:], share[:, :1] * share[:, 1:]]
    miss = np.linalg.norm(flow[moves] + sum(w * b for w, b in zip(weights, backs)), axis=1)
    agreement.add("come back to within 0.1 pixels", miss[whole] < 0.1)


def check_camera(agreement: Agreement, camera: pathlib.Path, recipe: dict, frames: int) -> None:
    """Compares the flow of all frames of a camera with the frames where it leads."""

    def instance(frame: int) -> np.ndarray | None:
        if "instance" not in recipe["layers"]:
            return None
        with Image.open(camera / "instance" / f"{frame:06}.png") as image:
            return np.asarray(image).astype(int)

    for layer, twin, step in (("flow", "flow_backward", 1), ("flow_backward", "flow", -1)):
        if layer not in recipe["layers"]:
            continue
        for frame in range(frames):
            path, other = camera / layer / f"{frame:06}.png", frame + step
            if not 0 <= other < frames:
                compare(agreement, path, None, None, None)
                continue
            back = camera / twin / f"{other:06}.png" if twin in recipe["layers"] else None
            now, then = instance(frame), instance(other)
            compare(agreement, path, back, now, then if now is not None else np.zeros(0))


def main() -> None:
    out = pathlib.Path(sys.argv[1])
    recipe = json.loads((out / "dataset.json").read_text())["recipe"]
    agreement = Agreement()
    for camera in sorted(out.glob("videos/*/camera_*")):
        check_camera(agreement, camera, recipe, round(recipe["fps"] * recipe["duration"]))
    agreement.check()


if __name__ == "__main__":
    main()
