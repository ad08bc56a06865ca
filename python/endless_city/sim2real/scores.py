"""How well a run does on a test set: by class, by size, with intervals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional

import numpy as np

from endless_city.sim2real.average_precision import Detections, Outcome, outcome
from endless_city.sim2real.bootstrap import DRAWS, Estimate, estimate, groups, summary
from endless_city.sim2real.labelled import CLASSES, LabelledImage
from endless_city.sim2real.sizes import SIZES, input_scale, sizes

if TYPE_CHECKING:
    from numpy.typing import NDArray

FALSE_PER_IMAGE = 1.0
"""Recall is told at the confidence at which a class has so many false detections a picture."""


@dataclass(frozen=True)
class ClassScore:
    """Of a class.

    - `boxes`: how many there are to find;
    - `recall`: share of them that is found at IoU 0.5 with `FALSE_PER_IMAGE`, mean over seeds;
    - `least_scores`: the confidence at which this is, of each seed.
    """

    name: str
    boxes: int
    ap50: Estimate
    ap50_95: Estimate
    recall: float
    least_scores: Sequence[float]


@dataclass(frozen=True)
class SizeScore:
    """Of the boxes of a class that have a size; means over seeds. `recall` is at the confidence of all sizes of the class."""

    name: str
    size: str
    boxes: int
    ap50: float
    ap50_95: float
    recall: float


@dataclass(frozen=True)
class RunScore:
    """Of a run on a test set.

    - `images`: pictures that were tested; `skipped`: those that were not, as the run was trained on them or on their camera;
    - `cameras`: how many took them, None if that is not known;
    - `drawn`: what the bootstrap draws, "cameras" or "pictures";
    - `mean_ap50`, `mean_ap50_95`: over the classes.
    """

    run: str
    test: str
    images: int
    skipped: int
    cameras: Optional[int]
    drawn: str
    classes: Sequence[ClassScore]
    sizes: Sequence[SizeScore]
    mean_ap50: Estimate
    mean_ap50_95: Estimate


def score(
    run: str,
    test: str,
    images: Sequence[LabelledImage],
    detections: Sequence[Sequence[Detections]],
    classes: Sequence[int],
    *,
    longest: int,
    skipped: int = 0,
    draws: int = DRAWS,
) -> RunScore:
    """Scores a run.

    Args:
        run: Its name.
        test: Name of the test set.
        images: Pictures that were tested.
        detections: For each seed, those of each picture.
        classes: Classes to score, places in `CLASSES`; those without a box are left out, one at least has some.
        longest: The longer side of pictures as the detector saw them, pixels.
        skipped: Pictures of the set that were not tested.
        draws: Draws of the bootstrap.
    """
    drawn_from = groups(images)
    weights = drawn_from.weights(draws)
    labels = [image.labels for image in images]
    by_class: list[ClassScore] = []
    by_size: list[SizeScore] = []
    drawn50: list[NDArray[np.float64]] = []
    drawn50_95: list[NDArray[np.float64]] = []
    for number in classes:
        outcomes = [outcome(labels, of_seed, number) for of_seed in detections]
        boxes = int(outcomes[0].objects.sum())
        if not boxes:
            continue
        ap50, at50 = estimate([one.ap50 for one in outcomes], weights)
        ap50_95, at50_95 = estimate([one.ap50_95 for one in outcomes], weights)
        drawn50.append(at50)
        drawn50_95.append(at50_95)
        least = [one.curves[0].score_at_false(FALSE_PER_IMAGE * len(images)) for one in outcomes]
        recall = float(np.mean([one.recall(at) for one, at in zip(outcomes, least)]))
        by_class.append(ClassScore(CLASSES[number], boxes, ap50, ap50_95, recall, least))
        by_size += _by_size(images, detections, number, least, longest)
    cameras = None if any(image.camera is None for image in images) else len({image.camera for image in images})
    return RunScore(
        run=run,
        test=test,
        images=len(images),
        skipped=skipped,
        cameras=cameras,
        drawn=drawn_from.kind,
        classes=by_class,
        sizes=by_size,
        mean_ap50=_mean([one.ap50 for one in by_class], drawn50),
        mean_ap50_95=_mean([one.ap50_95 for one in by_class], drawn50_95),
    )


def _mean(estimates: Sequence[Estimate], drawn: Sequence[NDArray[np.float64]]) -> Estimate:
    """Over the classes; a draw without any box of one of them has the mean of the others."""
    seeds = [float(np.mean(values)) for values in zip(*(one.seeds for one in estimates))]
    rows = np.stack(drawn)
    known = ~np.isnan(rows)
    count = known.sum(0)
    means = np.where(count > 0, np.where(known, rows, 0.0).sum(0) / count.clip(1), np.nan)
    return summary(seeds, means)


def _by_size(
    images: Sequence[LabelledImage],
    detections: Sequence[Sequence[Detections]],
    number: int,
    least: Sequence[float],
    longest: int,
) -> list[SizeScore]:
    scales = [input_scale(image.size, longest) for image in images]
    truths = [sizes(image.labels.boxes, scale) for image, scale in zip(images, scales)]
    rows: list[SizeScore] = []
    for place, name in enumerate(SIZES):
        outcomes: list[Outcome] = []
        for of_seed in detections:
            inside = [
                (truth == place, sizes(one.of_class(number).boxes, scale) == place)
                for truth, one, scale in zip(truths, of_seed, scales)
            ]
            outcomes.append(outcome([image.labels for image in images], of_seed, number, inside=inside))
        boxes = int(outcomes[0].objects.sum())
        if boxes:
            ap50 = float(np.mean([one.ap50() for one in outcomes]))
            ap50_95 = float(np.mean([one.ap50_95() for one in outcomes]))
            recall = float(np.mean([one.recall(at) for one, at in zip(outcomes, least)]))
            rows.append(SizeScore(CLASSES[number], name, boxes, ap50, ap50_95, recall))
    return rows
