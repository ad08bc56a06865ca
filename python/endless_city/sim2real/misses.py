"""A sheet of what a detector took for something and of what it missed.

Two rows for each run and test set: the most confident false detections, and the largest objects that were missed, at the
confidence with one false detection a picture; of each camera, or of each picture where cameras are not known, two at most.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Callable

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from endless_city.sim2real.average_precision import Detections, match
from endless_city.sim2real.labelled import CLASSES, LabelledImage, areas

if TYPE_CHECKING:
    from numpy.typing import NDArray

MISSED = (255, 140, 0)
FALSE = (235, 0, 235)
FOUND = (0, 200, 80)

_COLUMNS = 6
_OF_A_CAMERA = 2
_CELL = 230
_TEXT = 16
_GAP = 6
# What is shown around a box, of its longer side; at least this many pixels.
_AROUND = 3.0
_LEAST_SHOWN = 96


@dataclass(frozen=True)
class RunOnTest:
    """A run with one seed on a test set.

    - `detections`: those of each picture;
    - `least_scores`: the confidence from which detections count, by class.
    """

    run: str
    test: str
    images: Sequence[LabelledImage]
    detections: Sequence[Detections]
    least_scores: Mapping[int, float]


@dataclass(frozen=True)
class Miss:
    """A box to show.

    - `image`: place of its picture;
    - `box`: left, top, right, bottom, pixels;
    - `title`: what it is;
    - `weight`: which of them come first: the largest.
    """

    image: int
    box: NDArray[np.float64]
    title: str
    weight: float


@dataclass(frozen=True)
class Judged:
    """All that is right and wrong in the pictures of a test; `found` are boxes of objects, by picture."""

    false: Sequence[Miss]
    missed: Sequence[Miss]
    found: Mapping[int, Sequence[NDArray[np.float64]]]


def judged(tested: RunOnTest) -> Judged:
    """What is false, missed and found at IoU 0.5."""
    false: list[Miss] = []
    missed: list[Miss] = []
    found: dict[int, list[NDArray[np.float64]]] = {}
    for image, (one, given) in enumerate(zip(tested.images, tested.detections)):
        for number, least in tested.least_scores.items():
            of_class = given.of_class(number)
            counts = of_class.scores >= least
            detected, scores = of_class.boxes[counts], of_class.scores[counts]
            labelled = one.labels.classes == number
            boxes, crowds = one.labels.boxes[labelled], one.labels.ignored[labelled]
            nothing = np.zeros(len(boxes), np.bool_)
            matched = match(detected, boxes, crowds, nothing, np.zeros(len(detected), np.bool_))
            takes = matched.found[0]
            false += [
                Miss(image, detected[place], f"false {CLASSES[number]} {scores[place]:.2f}", float(scores[place]))
                for place in np.flatnonzero(takes < 0)
            ]
            taken = np.isin(np.arange(len(boxes)), takes)
            found.setdefault(image, []).extend(boxes[taken & ~crowds])
            share = 1 / (one.size[0] * one.size[1])
            missed += [
                Miss(image, boxes[place], f"missed {CLASSES[number]}", float(areas(boxes[[place]])[0] * share))
                for place in np.flatnonzero(~taken & ~crowds)
            ]
    return Judged(_first(false), _first(missed), found)


def _first(misses: Sequence[Miss]) -> list[Miss]:
    return sorted(misses, key=lambda miss: -miss.weight)


def draw_sheet(tests: Sequence[RunOnTest], path: Path) -> None:
    """Draws the sheet as a PNG.

    Raises:
        DatasetError: A picture cannot be read.
    """
    rows: list[Image.Image] = []
    for tested in tests:
        result = judged(tested)
        title = f"{tested.run} on {tested.test}: "
        for kind, misses, colour in (("false", result.false, FALSE), ("missed", result.missed, MISSED)):
            rows.append(_caption(f"{title}{len(misses)} {kind}, {_legend(kind)}", colour))
            rows.append(_row(tested, result, _chosen(tested, misses), colour))
    width = _COLUMNS * (_CELL + _GAP) + _GAP
    sheet = Image.new("RGB", (width, sum(row.height for row in rows)), (24, 24, 24))
    top = 0
    for row in rows:
        sheet.paste(row, (0, top))
        top += row.height
    sheet.save(path)


def _legend(kind: str) -> str:
    first = "the most confident" if kind == "false" else "the largest"
    return f"{first} (magenta: false, orange: missed, green: found)"


def _chosen(tested: RunOnTest, misses: Sequence[Miss]) -> list[Miss]:
    """The first, no more of a camera than others have room beside."""
    shown: Counter[str] = Counter()
    kept: list[Miss] = []
    for miss in misses:
        image = tested.images[miss.image]
        camera = image.camera or image.source
        if shown[camera] < _OF_A_CAMERA and len(kept) < _COLUMNS:
            shown[camera] += 1
            kept.append(miss)
    return kept


def _caption(text: str, colour: tuple[int, int, int]) -> Image.Image:
    strip = Image.new("RGB", (_COLUMNS * (_CELL + _GAP) + _GAP, _TEXT + 2 * _GAP), (24, 24, 24))
    ImageDraw.Draw(strip).text((_GAP, _GAP), _plain(text), fill=colour, font=ImageFont.load_default())
    return strip


def _plain(text: str) -> str:
    """What the font has; names of folders may have other letters."""
    return text.encode("latin-1", "replace").decode("latin-1")


def _row(tested: RunOnTest, result: Judged, misses: Sequence[Miss], colour: tuple[int, int, int]) -> Image.Image:
    strip = Image.new("RGB", (_COLUMNS * (_CELL + _GAP) + _GAP, _CELL + _TEXT + _GAP), (24, 24, 24))
    draw = ImageDraw.Draw(strip)
    for column, miss in enumerate(misses):
        left = _GAP + column * (_CELL + _GAP)
        strip.paste(_crop(tested.images[miss.image], result, miss, colour), (left, 0))
        draw.text((left, _CELL + 2), _plain(miss.title), fill=(255, 255, 255), font=ImageFont.load_default())
    return strip


def _crop(image: LabelledImage, result: Judged, miss: Miss, colour: tuple[int, int, int]) -> Image.Image:
    """What is around a box, with all boxes there."""
    centre = (miss.box[:2] + miss.box[2:]) / 2
    side = max(_AROUND * float((miss.box[2:] - miss.box[:2]).max()), _LEAST_SHOWN)
    # No further beyond the picture than it must be.
    corner = np.minimum(np.maximum(centre - side / 2, 0.0), np.maximum(np.array(image.size) - side, 0.0))
    scale = _CELL / side
    picture = Image.fromarray(image.read())
    window = (float(corner[0]), float(corner[1]), float(corner[0] + side), float(corner[1] + side))
    crop = picture.transform((_CELL, _CELL), Image.Transform.EXTENT, window, Image.Resampling.BILINEAR, fillcolor=(60, 60, 60))
    draw = ImageDraw.Draw(crop)

    def outline(box: NDArray[np.float64], of: tuple[int, int, int], width: int) -> None:
        x0, y0, x1, y1 = (float(value) for value in (box - np.tile(corner, 2)) * scale)
        draw.rectangle((x0, y0, max(x1, x0), max(y1, y0)), outline=of, width=width)

    kinds: list[tuple[Callable[[], list[NDArray[np.float64]]], tuple[int, int, int]]] = [
        (lambda: list(result.found.get(miss.image, [])), FOUND),
        (lambda: [one.box for one in result.missed if one.image == miss.image], MISSED),
        (lambda: [one.box for one in result.false if one.image == miss.image], FALSE),
    ]
    for boxes, of in kinds:
        for box in boxes():
            outline(box, of, 1)
    outline(miss.box, colour, 3)
    return crop
