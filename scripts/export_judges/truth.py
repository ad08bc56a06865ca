"""The dataset as its files tell it, read without the program."""

import dataclasses
import functools
import json
import pathlib

import numpy as np
from PIL import Image


@dataclasses.dataclass
class Frame:
    """A frame of a camera."""

    video: dict
    camera: str
    folder: pathlib.Path
    number: int
    time_s: float
    objects: list
    extension: str

    @property
    def name(self) -> str:
        return f"{self.video['name']}_{self.camera}_{self.number:06}"

    @property
    def rgb(self) -> np.ndarray:
        return np.asarray(Image.open(self.folder / f"rgb/{self.number:06}.{self.extension}"))

    @functools.cached_property
    def instance(self) -> np.ndarray:
        """(2, H, W): class tag, object id."""
        r, g, b = np.moveaxis(np.asarray(Image.open(self.folder / f"instance/{self.number:06}.png")).astype(int), -1, 0)
        return np.stack([r, g + 256 * b])

    def mask(self, number: int) -> np.ndarray:
        return self.instance[1] == number

    @functools.cached_property
    def record(self) -> dict:
        return json.loads((self.folder / "camera.json").read_text())


class Truth:
    """All frames of the complete videos, in the dataset's order."""

    def __init__(self, root: str) -> None:
        self.root = pathlib.Path(root)
        self.manifest = json.loads((self.root / "dataset.json").read_text())
        recipe = self.manifest["recipe"]
        self.width, self.height = map(int, recipe["size"].split("x"))
        self.fps = recipe["fps"]
        self.classes = [entry["name"] for entry in self.manifest["labels"]["classes"]]
        self.videos = [video for video in self.manifest["videos"] if video["state"] == "complete"]
        self.frames: list[Frame] = []
        for video in self.videos:
            for number in range(len(video["cameras"])):
                camera = f"camera_{chr(ord('a') + number)}"
                folder = self.root / "videos" / video["name"] / camera
                for line in map(json.loads, (folder / "objects.jsonl").read_text().splitlines()):
                    frame = Frame(video, camera, folder, line["frame"], line["time_s"], line["objects"], recipe["rgb_format"])
                    self.frames.append(frame)
        self.by_name = {frame.name: frame for frame in self.frames}

    def actors(self, video: str) -> dict:
        path = self.root / "videos" / video / "actors.json"
        return {actor["id"]: actor for actor in json.loads(path.read_text())}

    @property
    def boxes(self) -> int:
        return sum(len(frame.objects) for frame in self.frames)


def check(holds: bool, *what) -> None:
    """Like assert, which optimisation takes away."""
    if not holds:
        raise SystemExit("error: " + " ".join(str(part) for part in what))


def one_video_one_part(parts: dict) -> None:
    """No scene is in two parts; `parts` has the frames' names of each."""
    videos = {part: {name.rsplit("_camera_", 1)[0] for name in names} for part, names in parts.items()}
    seen: set = set()
    for part, names in videos.items():
        check(not (names & seen), "videos in two parts:", part, names & seen)
        seen |= names
