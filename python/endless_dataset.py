"""Reads a dataset made by endless: needs Pillow and NumPy; PyTorch only to feed a training.

    from endless_dataset import EndlessFrames
    frames = EndlessFrames("out")
    image, depth, instance, objects = frames[0]

It has `__len__` and `__getitem__`, so `torch.utils.data.DataLoader` takes it as it is (pass a `collate_fn`, as the
number of objects differs from frame to frame).
"""

import json
import pathlib
import struct
import zlib

import numpy as np
from PIL import Image


def read_png16(path):
    """uint16, (H, W, 3), of a 16-bit RGB PNG of the dataset; Pillow would keep eight bits.

    Understands what endless writes: rows filtered by their left pixel or by the row above.
    """
    data, at, packed = pathlib.Path(path).read_bytes(), 8, []
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at : at + 8])
        body, at = data[at + 8 : at + 8 + size], at + 12 + size
        if kind == b"IHDR":
            width, height, depth, color = struct.unpack(">IIBB", body[:10])
            assert (depth, color) == (16, 2), f"{path} is no 16-bit RGB image"
        elif kind == b"IDAT":
            packed.append(body)
    rows = np.frombuffer(zlib.decompress(b"".join(packed)), np.uint8).reshape(height, 1 + 6 * width)
    image = np.zeros((height, width, 6), np.uint8)
    for y, row in enumerate(rows):
        assert row[0] in (1, 2), f"{path}: filter {row[0]}"
        pixels = row[1:].reshape(width, 6)
        image[y] = np.cumsum(pixels, axis=0, dtype=np.uint8) if row[0] == 1 else pixels + image[y - 1]
    return image.view(">u2").astype(np.uint16)


class EndlessFrames:
    """All frames of all cameras.

    Each item is a tuple of
    - image: uint8, (H, W, 3), sRGB;
    - depth: float32, (H, W), metres along the optical axis, 1000 for the sky;
    - instance: int32, (2, H, W), class tag and object id (0 for stuff);
    - objects: list of dicts as in `objects.jsonl`; `bbox` is [x, y, w, h] in pixels.
    A layer that the dataset does not have is None.
    """

    def __init__(self, root):
        self.root = pathlib.Path(root)
        dataset = json.loads((self.root / "dataset.json").read_text())
        self.recipe = dataset["recipe"]
        self.classes = [c["name"] for c in dataset["labels"]["classes"]]
        self.items = []
        for video in dataset["videos"]:
            if video["state"] != "complete":
                continue
            for folder in sorted((self.root / "videos" / video["name"]).glob("camera_*")):
                for line in (folder / "objects.jsonl").read_text().splitlines():
                    line = json.loads(line)
                    self.items.append((folder, line["frame"], line["objects"]))

    def __len__(self):
        return len(self.items)

    def _load(self, folder, layer, frame):
        if layer not in self.recipe["layers"]:
            return None
        extension = self.recipe["rgb_format"] if layer == "rgb" else "png"
        with Image.open(folder / layer / f"{frame:06}.{extension}") as image:
            return np.asarray(image)

    def __getitem__(self, index):
        folder, frame, objects = self.items[index]
        image, depth, instance = (self._load(folder, layer, frame) for layer in ("rgb", "depth", "instance"))
        if depth is not None:
            value = depth.astype(np.float64) @ np.array([1.0, 256.0, 65536.0])
            depth = (1000.0 * value / (256**3 - 1)).astype(np.float32)
        if instance is not None:
            instance = instance.astype(np.int32)
            instance = np.stack([instance[..., 0], instance[..., 1] + 256 * instance[..., 2]])
        return image, depth, instance, objects
