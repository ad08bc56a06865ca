"""Folders in COCO's format: a JSON file of pictures, boxes and categories, beside the pictures or above them.

Of several JSON files each may have a part: `annotations/instances_train2017.json` and `instances_val2017.json`. Where there are
some called `instances_...`, others, with captions or keypoints, are not looked at.
"""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any, Optional, cast

from endless_city.errors import DatasetError
from endless_city.sim2real.class_names import NameMap
from endless_city.sim2real.labelled import CameraOf, LabelledImage, LabelledSet
from endless_city.sim2real.labelled_rows import Labeller, NamedBox
from endless_city.sim2real.pictures import is_picture, read_rgb, size_of
from endless_city.sim2real.splits import chosen, split_named

_KEYS = ("images", "annotations", "categories")


def find_json(root: Path) -> list[Path]:
    """The files with labels of a folder, or the file itself; none if there is none."""
    if root.is_file():
        return [root] if root.suffix.lower() == ".json" else []
    found = sorted({path for pattern in ("*.json", "*/*.json") for path in root.glob(pattern) if _is_coco(path)})
    instances = [path for path in found if path.stem.startswith("instances")]
    return instances or found


def read_coco(path: str, files: list[Path], split: Optional[str], names: NameMap, camera_of: CameraOf) -> LabelledSet:
    """Reads pictures and boxes.

    Args:
        path: As the user gave it.
        files: Its JSON files.
        split: The part to read; all by default.
        names: What its names are.
        camera_of: Cameras by names of pictures.

    Raises:
        DatasetError: A file is none of COCO's, pictures are not found, there is no such part, or a picture has two files.
    """
    parted = [(split_named(f"{file.parent.name}/{file.stem}") or "", file) for file in files]
    labeller = Labeller(names)
    images: list[LabelledImage] = []
    classes: set[int] = set()
    labelled_in: dict[str, Path] = {}
    for file in chosen(parted, split, path):
        content = _read_json(file)
        of_file = names.labelled([name for _, name in _categories(content, file)])
        classes.update(of_file)
        for image in _images(content, file, labeller, of_file, camera_of):
            other = labelled_in.setdefault(image.source, file)
            if other != file:
                raise DatasetError(f"{image.name} is labelled in {other.name} and in {file.name}: give the path of one of them")
            images.append(image)
    if not images:
        raise DatasetError(f"it has no pictures: {path}")
    return LabelledSet(path, images, tuple(sorted(classes)), labeller.notes())


def _is_coco(path: Path) -> bool:
    """Whether a file has COCO's keys, without reading all of a large one."""
    try:
        with path.open("rb") as file:
            head = file.read(1)
            size = os.fstat(file.fileno()).st_size
        if head != b"{":
            return False
        # Labels of many pictures may be hundreds of megabytes; their keys stand anywhere.
        content: Any = json.loads(path.read_bytes()) if size < 10_000_000 else dict.fromkeys(_KEYS)
    except (OSError, ValueError):
        return False
    return isinstance(content, dict) and all(key in content for key in _KEYS)


def _read_json(file: Path) -> dict[str, Any]:
    try:
        content: Any = json.loads(file.read_bytes())
    except (OSError, ValueError) as error:
        raise DatasetError(f"a JSON file cannot be read ({error}): {file}") from error
    if not isinstance(content, dict):
        raise DatasetError(f"a JSON file is none of COCO's, it has no object at its top: {file}")
    described = cast("dict[str, Any]", content)
    missing = [key for key in _KEYS if not isinstance(described.get(key), list)]
    if missing:
        raise DatasetError(f"a JSON file is none of COCO's, it has no list {', '.join(missing)}: {file}")
    return described


def _categories(content: dict[str, Any], file: Path) -> list[tuple[str, str]]:
    try:
        return [(str(category["id"]), str(category["name"])) for category in content["categories"]]
    except (KeyError, TypeError) as error:
        raise DatasetError(f"a category has no id or no name: {file}") from error


def _images(
    content: dict[str, Any], file: Path, labeller: Labeller, classes: tuple[int, ...], camera_of: CameraOf
) -> Iterator[LabelledImage]:
    name_of = dict(_categories(content, file))
    boxes_of: dict[str, list[NamedBox]] = {}
    for number, annotation in enumerate(content["annotations"]):
        image, box = _box(annotation, name_of, f"annotation {number} of {file}")
        boxes_of.setdefault(image, []).append(box)
    find = _Finder(file)
    for number, described in enumerate(content["images"]):
        try:
            key, name = str(described["id"]), str(described["file_name"])
        except (KeyError, TypeError) as error:
            raise DatasetError(f"picture {number} has no id or no file_name: {file}") from error
        picture = find(name)
        size = size_of(picture)
        told = (described.get("width", size[0]), described.get("height", size[1]))
        if told != size:
            raise DatasetError(f"{name} is {size[0]}x{size[1]}, but its labels are for {told[0]}x{told[1]} pixels: {file}")
        yield LabelledImage(
            name=name,
            size=size,
            labels=labeller.labels(boxes_of.pop(key, []), size, classes),
            camera=camera_of(name),
            source=str(picture.resolve()),
            read=partial(read_rgb, picture),
        )
    if boxes_of:
        raise DatasetError(f"{sum(map(len, boxes_of.values()))} annotations are of pictures that are not in its list: {file}")


def _box(annotation: Any, name_of: dict[str, str], where: str) -> tuple[str, NamedBox]:
    """The picture of an annotation, and its box."""
    try:
        name = name_of[str(annotation["category_id"])]
        left, top, width, height = (_finite(value) for value in annotation["bbox"])
        crowd = bool(annotation.get("iscrowd", 0))
        return str(annotation["image_id"]), NamedBox(name, [left, top, left + width, top + height], crowd)
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        raise DatasetError(f"it has no image_id, no known category_id or no bbox of four numbers: {where}") from error


def _finite(value: Any) -> float:
    """A number that is one.

    Raises:
        ValueError: It is infinite or none.
    """
    number = float(value)
    if not math.isfinite(number):
        raise ValueError(value)
    return number


class _Finder:
    """Finds pictures by the names that a JSON file has for them."""

    def __init__(self, file: Path) -> None:
        self._file = file
        part = file.stem.split("_", 1)[-1]
        above = file.parent.parent
        self._folders = [
            file.parent,
            file.parent / "images",
            above,
            above / "images",
            above / part,
            above / "images" / part,
            above / (split_named(file.stem) or part),
            above / "images" / (split_named(file.stem) or part),
        ]
        self._by_name: Optional[dict[str, list[Path]]] = None

    def __call__(self, name: str) -> Path:
        for folder in self._folders:
            if (folder / name).is_file():
                return folder / name
        found = self._anywhere().get(Path(name).name, [])
        if len(found) == 1:
            return found[0]
        if found:
            raise DatasetError(f"{name} may be {found[0]} or {found[1]}: write its path into file_name: {self._file}")
        expected = self._file.parent / "images"
        raise DatasetError(f"there is no picture {name}: put the pictures beside the JSON file or into {expected}")

    def _anywhere(self) -> dict[str, list[Path]]:
        """All pictures below the folder of the JSON file, and beside it if that has the labels alone."""
        if self._by_name is None:
            folder = self._file.parent
            top = folder.parent if folder.name in ("annotations", "labels") else folder
            self._by_name = {}
            for root, _, names in os.walk(top, followlinks=True):
                for name in names:
                    if is_picture(Path(name)):
                        self._by_name.setdefault(name, []).append(Path(root) / name)
        return self._by_name
