"""Pictures with boxes of three coarse classes, whatever they come from."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Callable, Optional

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import NDArray

CLASSES: tuple[str, ...] = ("vehicle", "two_wheeler", "pedestrian")
"""Names of the coarse classes; a class is a place in it."""

VEHICLE, TWO_WHEELER, PEDESTRIAN = range(3)


CameraOf = Callable[[str], Optional[str]]
"""The camera of a picture of a name, None if it is not known."""


@dataclass(frozen=True)
class Labels:
    """The N boxes of a picture.

    - `boxes`: float64, (N, 4): left, top, right, bottom, pixels;
    - `classes`: int64, (N,): places in `CLASSES`;
    - `ignored`: bool, (N,): whether it is neither asked for nor wrong to find, such as COCO's crowds.
    """

    boxes: NDArray[np.float64]
    classes: NDArray[np.int64]
    ignored: NDArray[np.bool_]

    def __len__(self) -> int:
        return len(self.classes)


@dataclass(frozen=True)
class LabelledImage:
    """A picture and its labels.

    - `name`: tells it from others of its set;
    - `size`: width and height, pixels;
    - `camera`: who took it, None if nobody knows;
    - `source`: tells it from all other pictures: the path of its file, for example;
    - `read`: gives its pixels, uint8, (H, W, 3), sRGB.
    """

    name: str
    size: tuple[int, int]
    labels: Labels
    camera: Optional[str]
    source: str
    read: Callable[[], NDArray[np.uint8]]


@dataclass(frozen=True)
class LabelledSet:
    """Pictures of which all objects of some classes have boxes.

    - `path`: as the user gave it;
    - `classes`: the classes that are labelled, places in `CLASSES`, rising;
    - `notes`: what the user should know, a sentence each.
    """

    path: str
    images: Sequence[LabelledImage]
    classes: tuple[int, ...]
    notes: Sequence[str] = field(default_factory=tuple)

    @property
    def cameras(self) -> Optional[list[str]]:
        """Names of its cameras, None if they are not known."""
        names = {image.camera for image in self.images}
        return None if None in names else sorted(name for name in names if name is not None)


def restricted(whole: LabelledSet, classes: Sequence[int]) -> LabelledSet:
    """A set with some classes alone, as if others were not labelled."""
    if set(whole.classes) <= set(classes):
        return whole
    images = [replace(image, labels=_of_classes(image.labels, classes)) for image in whole.images]
    return replace(whole, images=images, classes=tuple(number for number in whole.classes if number in classes))


def _of_classes(labels: Labels, classes: Sequence[int]) -> Labels:
    kept = np.isin(labels.classes, list(classes))
    return Labels(labels.boxes[kept], labels.classes[kept], labels.ignored[kept])


def evenly(count: int, most: Optional[int]) -> list[int]:
    """Places of at most `most` of `count` things, evenly spread."""
    if most is None or count <= most:
        return list(range(count))
    return [place * count // most for place in range(most)]


def thinned(whole: LabelledSet, most: int) -> LabelledSet:
    """A set of at most so many pictures, evenly spread."""
    places = evenly(len(whole.images), most)
    return replace(whole, images=[whole.images[place] for place in places])


def labels_of(rows: Sequence[tuple[Sequence[float], int, bool]]) -> Labels:
    """The labels of rows of a box (left, top, right, bottom, pixels), a class, and whether it is ignored."""
    return Labels(
        np.reshape(np.array([row[0] for row in rows], dtype=np.float64), (-1, 4)),
        np.array([row[1] for row in rows], dtype=np.int64),
        np.array([row[2] for row in rows], dtype=np.bool_),
    )


def overlaps(first: NDArray[np.float64], second: NDArray[np.float64]) -> NDArray[np.float64]:
    """(N, M): areas that N boxes share with M others, (N, 4) and (M, 4): left, top, right, bottom."""
    corners = np.minimum(first[:, None, 2:], second[None, :, 2:]) - np.maximum(first[:, None, :2], second[None, :, :2])
    shared: NDArray[np.float64] = corners.clip(0).prod(2)
    return shared


def areas(boxes: NDArray[np.float64]) -> NDArray[np.float64]:
    """(N,): areas of boxes."""
    sizes: NDArray[np.float64] = (boxes[:, 2:] - boxes[:, :2]).prod(1)
    return sizes
