"""The layer of shadows, judged by other images and `frames.jsonl`: called by check_dataset.py."""

import json
import pathlib

import numpy as np
from PIL import Image
from png16 import read_png16

ROADS, VEGETATION, SKY = 1, 9, 11
SHADED = 255


def pixels(path: pathlib.Path) -> np.ndarray:
    with Image.open(path) as image:
        return np.asarray(image).astype(int)


def brightness(path: pathlib.Path) -> np.ndarray:
    """Mean of the channels, as if light added up: 0 to 1."""
    return ((pixels(path) / 255) ** 2.2).mean(axis=2)


def check_camera(camera: pathlib.Path, recipe: dict) -> list[float]:
    """How much darker roads are in the shadow than in the light: of each frame with a clear view of both."""
    if "shadow" not in recipe["layers"]:
        return []
    record = json.loads((camera / "camera.json").read_text())
    darker = []
    for line in (camera.parent / "frames.jsonl").read_text().splitlines():
        line = json.loads(line)
        name, sun = f"{line['frame']:06}.png", line["light"]["sun"]
        path = camera / "shadow" / name
        stored = pixels(path)
        shadow = stored[..., 0]
        assert (stored == shadow[..., None]).all(), f"{path} is not grey"
        if sun["direct_share"] == 0:
            assert not shadow.any(), f"{path}: shadows without a sun"
            continue
        tags = pixels(camera / "instance" / name)[..., 0] if "instance" in recipe["layers"] else np.zeros_like(shadow)
        assert not shadow[tags == SKY].any(), f"{path}: shadows in the sky"
        if "normals" in recipe["layers"] and "instance" in recipe["layers"]:
            stored = read_png16(camera / "normals" / name)
            to_sun = np.array(record["world_from_camera"])[:3, :3].T @ np.array(sun["direction"])
            away = (2.0 * stored / 65535 - 1) @ to_sun < -0.1
            away &= stored.any(axis=2) & (tags != VEGETATION)
            # All samples of a pixel tell its shadow where it lies on one smooth piece, which may bend between triangles.
            assert (shadow[away] != SHADED).sum() <= 0.01 * away.sum() + 3, f"{path}: light from behind"
            assert shadow[away].all(), f"{path}: full light from behind"
        if "rgb" in recipe["layers"] and recipe["rgb_format"] == "png":
            light = brightness(camera / "rgb" / name)
            dark, lit = light[(tags == ROADS) & (shadow == SHADED)], light[(tags == ROADS) & (shadow == 0)]
            if min(len(dark), len(lit)) > 500 and sun["direct_share"] > 0.5:
                darker.append(float(np.median(dark) / np.median(lit)))
    return darker


def check(darker: list[float]) -> None:
    if darker:
        print(f"shadow: roads in it have {np.median(darker):.0%} of the light beside it, in {len(darker)} pictures")
        assert np.median(darker) < 0.8 and max(darker) < 1.0, "shadow: roads are as bright in it as beside it"
