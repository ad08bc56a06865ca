"""Folders of datasets of any kind: which it is, and who its cameras are."""

from __future__ import annotations

import json
import re
from pathlib import Path
from typing import Any, Optional

from endless_city.errors import DatasetError, RecipeError
from endless_city.sim2real.class_names import NameMap
from endless_city.sim2real.coco import find_json, read_coco
from endless_city.sim2real.labelled import LabelledSet, thinned
from endless_city.sim2real.splits import SPLITS
from endless_city.sim2real.synthetic_set import read_synthetic
from endless_city.sim2real.yolo import find_yaml, read_yolo


class Cameras:
    """Cameras of real pictures by a regular expression that their names match."""

    def __init__(self, expression: Optional[str] = None) -> None:
        """Of an expression; its first group, if it has one, names the camera.

        Raises:
            RecipeError: It is no regular expression.
        """
        try:
            self._expression = None if expression is None else re.compile(expression)
        except re.error as error:
            raise RecipeError(f"--camera-regex cannot be {expression!r}: {error}") from error

    def __call__(self, name: str) -> Optional[str]:
        """The camera of a picture, by its path in its folder; None where the expression finds nothing."""
        found = None if self._expression is None else self._expression.search(name)
        if found is None:
            return None
        return found.group(1) if found.re.groups and found.group(1) is not None else found.group(0)


def read_set(given: str, names: NameMap, cameras: Cameras, most: Optional[int] = None) -> LabelledSet:
    """Reads a dataset of `endless generate`, a folder in YOLO's or COCO's format, or a JSON file of COCO's.

    Args:
        given: Its path, and `@train`, `@val` or `@test` for a part of it.
        names: What the names of a real set are.
        cameras: Cameras of a real set.
        most: How many pictures at most, spread evenly.

    Raises:
        DatasetError: It is none of these, or is broken.
    """
    path, split = _parted(given)
    root = Path(path)
    if not root.exists():
        raise DatasetError(f"there is no such file or folder: {path}")
    if is_synthetic(path):
        return read_synthetic(path, split, most)
    data = find_yaml(root)
    if data is not None:
        return _checked(read_yolo(given, data, split, names, cameras), most)
    files = find_json(root)
    if files:
        return _checked(read_coco(given, files, split, names, cameras), most)
    raise DatasetError(
        "it is no dataset of `endless generate` and no folder in YOLO's format (data.yaml with names, images, labels) or "
        f"COCO's (a JSON file with images, annotations, categories): {path}"
    )


def is_synthetic(given: str) -> bool:
    """Whether a path is a dataset of `endless generate`."""
    try:
        content: Any = json.loads((Path(_parted(given)[0]) / "dataset.json").read_bytes())
        return bool(content["tool"] == "endless")
    except (OSError, ValueError, KeyError, TypeError):
        return False


def _parted(given: str) -> tuple[str, Optional[str]]:
    """The path, and the part of it that is asked for."""
    path, at, split = given.rpartition("@")
    return (path, split) if at and split in SPLITS and not Path(given).exists() else (given, None)


def _checked(found: LabelledSet, most: Optional[int]) -> LabelledSet:
    """At most so many of its pictures, whose cameras are known for all or for none.

    Raises:
        DatasetError: No class of ours is labelled, or some cameras are known and others are not.
    """
    if not found.classes:
        raise DatasetError(
            f"none of its classes is a vehicle, a two-wheeler or a pedestrian: say which are with --map NAME=CLASS: {found.path}"
        )
    unknown = [image.name for image in found.images if image.camera is None]
    if unknown and len(unknown) < len(found.images):
        raise DatasetError(
            f"--camera-regex finds no camera in the name {unknown[0]}, as in {len(unknown)} of {len(found.images)}: {found.path}"
        )
    return found if most is None else thinned(found, most)
