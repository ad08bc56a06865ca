"""Average precision as COCO has it (Lin et al. 2014; `COCOeval` of pycocotools).

Detections of a picture, the most confident first, each take the free box of their class with which their IoU (intersection over
union) is largest, if it reaches a threshold. Precision is interpolated at 101 recalls and averaged; AP50 is of the threshold 0.5,
AP50:95 the mean over 0.5, 0.55, ..., 0.95. At most 100 detections of a class count in a picture.

Pictures can have weights: what a bootstrap draws twice counts twice.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional

import numpy as np

from endless_city.sim2real.labelled import Labels, areas, overlaps

if TYPE_CHECKING:
    from numpy.typing import NDArray

IOU_THRESHOLDS: NDArray[np.float64] = np.linspace(0.5, 0.95, 10)
RECALLS: NDArray[np.float64] = np.linspace(0.0, 1.0, 101)

MOST_DETECTIONS = 100
"""Detections of a class that count in a picture."""


@dataclass(frozen=True)
class Detections:
    """The D detections of a picture, the most confident first.

    - `boxes`: float64, (D, 4): left, top, right, bottom, pixels;
    - `scores`: float64, (D,): confidence, 0 to 1;
    - `classes`: int64, (D,): places in `CLASSES`.
    """

    boxes: NDArray[np.float64]
    scores: NDArray[np.float64]
    classes: NDArray[np.int64]

    def __len__(self) -> int:
        return len(self.scores)

    def of_class(self, number: int) -> Detections:
        """Those of a class that count."""
        places = np.flatnonzero(self.classes == number)
        places = places[np.argsort(-self.scores[places], kind="stable")][:MOST_DETECTIONS]
        return Detections(self.boxes[places], self.scores[places], self.classes[places])


@dataclass(frozen=True)
class Matched:
    """How D detections of a picture, of one class, meet its G boxes at T thresholds.

    - `found`: int64, (T, D): the box that each takes, -1 if none;
    - `ignored`: bool, (T, D): whether it counts neither as true nor as false.
    """

    found: NDArray[np.int64]
    ignored: NDArray[np.bool_]


def match(
    detected: NDArray[np.float64],
    boxes: NDArray[np.float64],
    crowds: NDArray[np.bool_],
    outside: NDArray[np.bool_],
    detected_outside: NDArray[np.bool_],
) -> Matched:
    """Matches detections with boxes.

    Args:
        detected: (D, 4): boxes of detections, the most confident first.
        boxes: (G, 4): boxes of objects.
        crowds: (G,): whether a box is ignored and may be taken by many; IoU is then the share of the detection in it.
        outside: (G,): whether a box is not of the size that is asked for; who takes it is ignored.
        detected_outside: (D,): whether a detection is not of that size; it is ignored if it takes no box.
    """
    thresholds = np.minimum(IOU_THRESHOLDS, 1 - 1e-10)
    count = len(thresholds)
    found = np.full((count, len(detected)), -1, dtype=np.int64)
    ignored = np.zeros((count, len(detected)), dtype=np.bool_)
    if len(boxes) and len(detected):
        shared = overlaps(detected, boxes)
        whole = np.where(crowds, areas(detected)[:, None], areas(detected)[:, None] + areas(boxes) - shared)
        iou = shared / whole.clip(1e-12)
        free = np.ones((count, len(boxes)), dtype=np.bool_)
        wanted = ~(crowds | outside)
        rows = np.arange(count)
        for place in np.flatnonzero(iou.max(1) >= thresholds[0]):
            taken = np.zeros(count, dtype=np.bool_)
            # What is asked for comes first, whatever the IoU with others.
            for kind in (wanted, ~wanted):
                values = np.where(free & kind, iou[place], -1.0)
                # The last of equals, as pycocotools takes it.
                best = values.shape[1] - 1 - values[:, ::-1].argmax(1)
                takes = ~taken & (values[rows, best] >= thresholds)
                found[takes, place] = best[takes]
                ignored[takes, place] = kind is not wanted
                free[rows[takes], best[takes]] = crowds[best[takes]]
                taken |= takes
    ignored |= (found < 0) & detected_outside
    return Matched(found, ignored)


@dataclass(frozen=True)
class Curve:
    """The D detections that count at a threshold, of all pictures, the most confident first.

    - `scores`: float64, (D,);
    - `images`: int64, (D,): places of their pictures;
    - `true`: int64, (P,): places of those that are true.
    """

    scores: NDArray[np.float64]
    images: NDArray[np.int64]
    true: NDArray[np.int64]

    def average_precision(self, objects: NDArray[np.float64], weights: Optional[NDArray[np.float64]] = None) -> float:
        """Average precision, 0 to 1; NaN if there is nothing to find.

        Args:
            objects: (I,): boxes to find in each picture.
            weights: (I,): how often each picture counts; once by default.
        """
        of_image = np.ones(len(objects)) if weights is None else weights
        total = float(objects @ of_image)
        if total <= 0:
            return float("nan")
        if not len(self.true):
            return 0.0
        # What comes after the last that is true changes nothing.
        weight = of_image[self.images[: self.true[-1] + 1]]
        seen = np.cumsum(weight)[self.true]
        right = np.cumsum(weight[self.true])
        precision = np.divide(right, seen, out=np.zeros_like(right), where=seen > 0)
        best_from_here = np.maximum.accumulate(precision[::-1])[::-1]
        places = np.searchsorted(right / total, RECALLS, side="left")
        return float(np.where(places < len(right), best_from_here[np.minimum(places, len(right) - 1)], 0.0).mean())

    def score_at_false(self, false: float) -> float:
        """The least score at which there are at most so many false detections; more than 1 if none is confident enough."""
        wrong = np.ones(len(self.scores), dtype=np.int64)
        wrong[self.true] = 0
        # Of equal scores either all count or none.
        count = int(np.searchsorted(np.cumsum(wrong), false, side="right"))
        if count == len(self.scores):
            return 0.0
        more = self.scores[:count][self.scores[:count] > self.scores[count]]
        return float(more[-1]) if len(more) else 2.0


@dataclass(frozen=True)
class Outcome:
    """What a detector does with a class in I pictures.

    - `curves`: one for each of `IOU_THRESHOLDS`;
    - `objects`: float64, (I,): boxes to find in each picture;
    - `found_scores`: for each picture float64, (G,): the score with which each box is found at IoU 0.5, 0 if it is not, NaN if it
      is not asked for; G are the boxes of the class.
    """

    curves: Sequence[Curve]
    objects: NDArray[np.float64]
    found_scores: Sequence[NDArray[np.float64]]

    def ap50(self, weights: Optional[NDArray[np.float64]] = None) -> float:
        """AP at IoU 0.5."""
        return self.curves[0].average_precision(self.objects, weights)

    def ap50_95(self, weights: Optional[NDArray[np.float64]] = None) -> float:
        """Mean of AP over all thresholds."""
        return float(np.mean([curve.average_precision(self.objects, weights) for curve in self.curves]))

    def recall(self, least_score: float) -> float:
        """Share of boxes that are found with at least a score; NaN if there are none."""
        scores = np.concatenate([*self.found_scores, np.zeros(0)])
        asked = scores[~np.isnan(scores)]
        return float((asked >= max(least_score, 1e-12)).mean()) if len(asked) else float("nan")


def outcome(
    labels: Sequence[Labels],
    detections: Sequence[Detections],
    number: int,
    *,
    inside: Optional[Sequence[tuple[NDArray[np.bool_], NDArray[np.bool_]]]] = None,
) -> Outcome:
    """What is found of a class.

    Args:
        labels: Those of each picture.
        detections: Those of each picture.
        number: The class, a place in `CLASSES`.
        inside: For each picture, which of its boxes and which of its detections, in the order of `labels` and of
            `Detections.of_class`, are of the size that is asked for; all by default.
    """
    gathered: list[list[tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.bool_]]]] = [[] for _ in IOU_THRESHOLDS]
    objects = np.zeros(len(labels))
    found_scores: list[NDArray[np.float64]] = []
    for image, (truth, given) in enumerate(zip(labels, detections)):
        of_class = truth.classes == number
        detected = given.of_class(number)
        boxes, crowds = truth.boxes[of_class], truth.ignored[of_class]
        if inside is None:
            outside, detected_outside = np.zeros(len(boxes), np.bool_), np.zeros(len(detected), np.bool_)
        else:
            outside, detected_outside = ~inside[image][0][of_class], ~inside[image][1]
        matched = match(detected.boxes, boxes, crowds, outside, detected_outside)
        asked = ~(crowds | outside)
        objects[image] = asked.sum()
        scores = np.where(asked, 0.0, np.nan)
        hit = (matched.found[0] >= 0) & ~matched.ignored[0]
        scores[matched.found[0][hit]] = detected.scores[hit]
        found_scores.append(scores)
        for rows, found, ignored in zip(gathered, matched.found, matched.ignored):
            counts = ~ignored
            rows.append((detected.scores[counts], np.full(int(counts.sum()), image), found[counts] >= 0))
    return Outcome([_curve(rows) for rows in gathered], objects, found_scores)


def _curve(rows: Sequence[tuple[NDArray[np.float64], NDArray[np.int64], NDArray[np.bool_]]]) -> Curve:
    if not rows:
        return Curve(np.zeros(0), np.zeros(0, np.int64), np.zeros(0, np.int64))
    scores, images, true = (np.concatenate(column) for column in zip(*rows))
    order = np.argsort(-scores, kind="stable")
    return Curve(scores[order], images[order], np.flatnonzero(true[order]))
