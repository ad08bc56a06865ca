"""Folders in YOLO's format: `data.yaml` with names, pictures in `images`, a text file for each in `labels`.

A line is the class and the box: centre, width, height as shares of the picture's sides; or the class and a polygon, whose
bounding box is taken. A picture without a file has no objects. Parts follow from `train`, `val` and `test` in `data.yaml`, as
Ultralytics and Roboflow write them, or from folders of these names.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any, Optional, cast

# PyYAML has no types.
import yaml  # type: ignore[import-untyped, unused-ignore]  # pyright: ignore[reportMissingModuleSource]

from endless_city.errors import DatasetError
from endless_city.sim2real.class_names import NameMap
from endless_city.sim2real.labelled import CameraOf, LabelledImage, LabelledSet
from endless_city.sim2real.labelled_rows import Labeller, NamedBox
from endless_city.sim2real.pictures import is_picture, pictures_in, read_rgb, size_of
from endless_city.sim2real.splits import chosen, split_named

# Boxes may reach this far beyond the picture, as a share of its side.
_TOLERANCE = 0.02


def find_yaml(root: Path) -> Optional[Path]:
    """The file with the names of a folder, None if there is none."""
    if root.is_file():
        return root if root.suffix.lower() in (".yaml", ".yml") else None
    files = sorted([*root.glob("*.yaml"), *root.glob("*.yml")], key=lambda path: (path.stem not in ("data", "dataset"), path.name))
    return next((path for path in files if "names" in _read_yaml(path)), None)


def read_yolo(path: str, data: Path, split: Optional[str], names: NameMap, camera_of: CameraOf) -> LabelledSet:
    """Reads a folder.

    Args:
        path: As the user gave it.
        data: Its file with the names.
        split: The part to read; all by default.
        names: What its names are.
        camera_of: Cameras by names of pictures.

    Raises:
        DatasetError: There are no pictures, no labels or no such part, or a label makes no sense.
    """
    described = _read_yaml(data)
    class_names = _names(described, data)
    classes = names.labelled(class_names)
    root = data.parent
    pictures = chosen(_pictures(root, described), split, path)
    if not pictures:
        raise DatasetError(f"there are no pictures: put them into {root / 'images'}, and their labels into {root / 'labels'}")
    labeller = Labeller(names)
    images: list[LabelledImage] = []
    labelled = 0
    for picture in pictures:
        file = _label_file(picture)
        size = size_of(picture)
        labelled += file.is_file()
        boxes = _read_labels(file, class_names, size) if file.is_file() else []
        name = picture.relative_to(root).as_posix() if picture.is_relative_to(root) else picture.as_posix()
        images.append(
            LabelledImage(
                name=name,
                size=size,
                labels=labeller.labels(boxes, size, classes),
                camera=camera_of(name),
                source=str(picture.resolve()),
                read=partial(read_rgb, picture),
            )
        )
    if not labelled:
        expected = _label_file(pictures[0])
        raise DatasetError(f"none of {len(pictures)} pictures has labels: those of {pictures[0]} belong into {expected}")
    return LabelledSet(path, images, classes, labeller.notes())


def _read_yaml(path: Path) -> dict[str, Any]:
    try:
        content: Any = yaml.safe_load(path.read_text(encoding="utf-8"))
    except (OSError, UnicodeDecodeError, yaml.YAMLError) as error:
        raise DatasetError(f"a YAML file cannot be read ({' '.join(str(error).split())}): {path}") from error
    return cast("dict[str, Any]", content) if isinstance(content, dict) else {}


def _names(described: dict[str, Any], data: Path) -> list[str]:
    """Names of classes by their numbers."""
    names: Any = described.get("names")
    if isinstance(names, dict):
        by_number = cast("Mapping[Any, Any]", names)
        try:
            numbers = {int(number): str(name) for number, name in by_number.items()}
        except (TypeError, ValueError):
            numbers = {}
        names = [numbers.get(number, f"class {number}") for number in range(max(numbers, default=-1) + 1)]
    if not isinstance(names, list) or not names:
        raise DatasetError(f"there are no names of classes: write them as names: [car, person] into {data}")
    return [str(name) for name in cast("Sequence[Any]", names)]


def _pictures(root: Path, described: dict[str, Any]) -> list[tuple[str, Path]]:
    """Parts and pictures."""
    base = root / str(described.get("path") or ".")
    if not base.is_dir():
        # Written for another machine.
        base = root
    found: list[tuple[str, Path]] = []
    for split in ("train", "val", "valid", "test"):
        given: Any = described.get(split)
        places = cast("Sequence[Any]", given) if isinstance(given, list) else [given] if given else []
        for place in places:
            found += [(split_named(split) or split, picture) for picture in _at(base, root, str(place))]
    if not found:
        folder = root / "images" if (root / "images").is_dir() else root
        found = [(split_named(picture.relative_to(root).as_posix()) or "", picture) for picture in pictures_in(folder)]
    # A part that is named twice is still one.
    return list({picture.resolve(): (split, picture) for split, picture in found}.values())


def _at(base: Path, root: Path, place: str) -> list[Path]:
    """Pictures of a folder or of a list in a text file, whose paths may be Roboflow's, which begin a folder too high."""
    plain = place
    while plain.startswith("../"):
        plain = plain[3:]
    for path in (base / place, root / place, base / plain, root / plain):
        if path.is_dir():
            return pictures_in(path)
        if path.is_file() and path.suffix == ".txt":
            lines = path.read_text(encoding="utf-8").split("\n")
            listed = [path.parent / line.strip() for line in lines if line.strip()]
            return [picture for picture in listed if is_picture(picture)]
    return []


def _label_file(picture: Path) -> Path:
    """The labels of a picture: the last folder `images` of its path becomes `labels`; else they lie beside it."""
    parts = list(picture.parts)
    for place in range(len(parts) - 2, -1, -1):
        if parts[place] == "images":
            parts[place] = "labels"
            break
    return Path(*parts).with_suffix(".txt")


def _read_labels(file: Path, class_names: Sequence[str], size: tuple[int, int]) -> list[NamedBox]:
    boxes: list[NamedBox] = []
    try:
        lines = file.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise DatasetError(f"labels cannot be read ({error}): {file}") from error
    for number, line in enumerate(lines, 1):
        words = line.split()
        if words:
            boxes.append(_read_line(words, class_names, size, f"{file}:{number}"))
    return boxes


def _read_line(words: Sequence[str], class_names: Sequence[str], size: tuple[int, int], where: str) -> NamedBox:
    try:
        number, *numbers = [float(word) for word in words]
    except ValueError as error:
        raise DatasetError(f"a label has words that are no numbers: {where}") from error
    if not 0 <= number < len(class_names) or number != int(number):
        raise DatasetError(f"a label has the class {words[0]}, but names has 0 to {len(class_names) - 1}: {where}")
    if len(numbers) != 4 and (len(numbers) < 6 or len(numbers) % 2):
        raise DatasetError(f"a label has {len(words)} numbers: a class and a box have 5, a class and a polygon 7, 9, ...: {where}")
    if not all(-_TOLERANCE <= value <= 1 + _TOLERANCE for value in numbers):
        raise DatasetError(f"a label has numbers that are no shares of the picture's sides, 0 to 1: {where}")
    if len(numbers) == 4:
        x, y, width, height = numbers
        left, top, right, bottom = x - width / 2, y - height / 2, x + width / 2, y + height / 2
    else:
        left, top, right, bottom = min(numbers[::2]), min(numbers[1::2]), max(numbers[::2]), max(numbers[1::2])
    box = [left * size[0], top * size[1], right * size[0], bottom * size[1]]
    return NamedBox(class_names[int(number)], box)
