"""Datasets of `endless generate` with the boxes that people would draw."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, cast

from endless_city._dataset import Dataset
from endless_city.errors import DatasetError
from endless_city.sim2real.labelled import (
    CLASSES,
    PEDESTRIAN,
    TWO_WHEELER,
    VEHICLE,
    LabelledImage,
    LabelledSet,
    Labels,
    evenly,
    labels_of,
)
from endless_city.sim2real.riders import union

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

CLASS_OF: Mapping[str, int] = {
    "car": VEHICLE,
    "van": VEHICLE,
    "truck": VEHICLE,
    "bus": VEHICLE,
    "motorcycle": TWO_WHEELER,
    "bicycle": TWO_WHEELER,
    "rider": TWO_WHEELER,
    "pedestrian": PEDESTRIAN,
}
"""Coarse classes of those of a dataset."""

LEAST_SIDE = 8.0
"""Nobody labels what is smaller: the longer side of a box, pixels."""

LEAST_SHARE = 0.12
"""Nobody labels what is hidden more: visible pixels over those of the box."""


def read_synthetic(path: str, split: Optional[str] = None, most: Optional[int] = None) -> LabelledSet:
    """The camera frames of a dataset. Its cameras are those of each video.

    Args:
        path: Its folder.
        split: A part of `Dataset.split`, `train` or `val`; all by default.
        most: How many frames at most, spread evenly.

    Raises:
        DatasetError: There is no dataset, no complete video, no such part or no layer `rgb`.
    """
    dataset = Dataset(path, layers=["rgb"])
    if split is not None:
        parts = dataset.split()
        if split not in parts:
            raise DatasetError(f"there is no part {split!r}, only {', '.join(parts)}: {path}")
        dataset = parts[split]
    if not len(dataset):
        raise DatasetError(f"it has no complete video: let `endless generate` end: {path}")
    if "rgb" not in dataset.layers:
        raise DatasetError(f"it has no pictures: generate it with the layer rgb: {path}")
    places = evenly(len(dataset), most)
    return LabelledSet(path, [_image(dataset, place) for place in places], tuple(range(len(CLASSES))))


def _image(dataset: Dataset, place: int) -> LabelledImage:
    frame = dataset[place]
    camera = f"{frame.video}/{frame.camera.name}"
    name = f"{camera}/{frame.frame:06}"
    return LabelledImage(
        name=name,
        size=frame.size,
        labels=synthetic_labels(cast("list[dict[str, Any]]", frame.objects.records)),
        camera=camera,
        source=f"{dataset.root}:{name}",
        read=_reader(dataset, place),
    )


def _reader(dataset: Dataset, place: int) -> Callable[[], NDArray[np.uint8]]:
    return lambda: dataset[place].rgb


def synthetic_labels(records: Sequence[Mapping[str, Any]]) -> Labels:
    """Labels of the objects of a frame.

    A two-wheeler and its rider are one box, their union. What nobody would label (`LEAST_SIDE`, `LEAST_SHARE`) is ignored.
    """
    by_id = {record["id"]: record for record in records}
    rows: list[tuple[Sequence[float], int, bool]] = []
    for record in records:
        if record["class"] == "rider" and record.get("vehicle_id") in by_id:
            # In the box of what is ridden.
            continue
        box, pixels = _corners(record), record["pixels"]
        rider = by_id.get(record.get("rider_id"))
        if rider is not None:
            box, pixels = union(box, _corners(rider)), pixels + rider["pixels"]
        rows.append((box, CLASS_OF[record["class"]], _unlabelled(box, pixels)))
    return labels_of(rows)


def _corners(record: Mapping[str, Any]) -> list[float]:
    left, top, width, height = record["bbox"]
    return [left, top, left + width, top + height]


def _unlabelled(box: Sequence[float], pixels: int) -> bool:
    width, height = box[2] - box[0], box[3] - box[1]
    return max(width, height) < LEAST_SIDE or pixels < LEAST_SHARE * width * height
