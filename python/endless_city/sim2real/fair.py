"""Which pictures a run may be tested on."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Union

from endless_city.errors import DatasetError
from endless_city.sim2real.labelled import CLASSES, LabelledImage, LabelledSet


@dataclass(frozen=True)
class FairTest:
    """What a run is tested on.

    - `images`: those whose camera it has never seen;
    - `classes`: those that it learns and that are labelled, places in `CLASSES`, rising;
    - `skipped`: number of other pictures.
    """

    images: Sequence[LabelledImage]
    classes: Sequence[int]
    skipped: int


def fair_tests(
    run: str, learnt: Sequence[LabelledSet], tests: Mapping[str, LabelledSet]
) -> tuple[dict[str, FairTest], list[str]]:
    """The parts of test sets that a run may be tested on, by their names, and why it may not be tested on others.

    A picture is left out if it, or another of its camera, is in a set that the run learns from.

    Raises:
        DatasetError: There is no test that it may be tested on.
    """
    fair: dict[str, FairTest] = {}
    reasons: list[str] = []
    for name, test in tests.items():
        found = _fair_test(run, learnt, name, test)
        if isinstance(found, str):
            reasons.append(found)
        else:
            fair[name] = found
    if not fair:
        raise DatasetError("; ".join(reasons))
    return fair, reasons


def _fair_test(run: str, learnt: Sequence[LabelledSet], name: str, test: LabelledSet) -> Union[FairTest, str]:
    """The part of a test set, or why there is none."""
    sources = {image.source for one in learnt for image in one.images}
    cameras = {image.camera for one in learnt for image in one.images} - {None}
    images = [image for image in test.images if image.source not in sources and image.camera not in cameras]
    if not images:
        return f"{run} is not tested on {name}: it learns from all its pictures, or from others of their cameras"
    classes = sorted(set(test.classes) & {number for one in learnt for number in one.classes})
    if not classes:
        return (
            f"{run} is not tested on {name}: it learns {_names(learnt)}, and {name} labels {_names([test])}, "
            "see --map and --classes"
        )
    scored = [number for number in classes if any(_count(image, number) for image in images)]
    if not scored:
        listed = ", ".join(CLASSES[number] for number in classes)
        return f"{run} is not tested on {name}: none of {len(images)} pictures has a box of {listed}"
    return FairTest(images, scored, len(test.images) - len(images))


def _count(image: LabelledImage, number: int) -> int:
    """Boxes of a class to find."""
    return int((image.labels.classes[~image.labels.ignored] == number).sum())


def _names(sets: Sequence[LabelledSet]) -> str:
    return ", ".join(CLASSES[number] for number in sorted({number for one in sets for number in one.classes})) or "nothing"
