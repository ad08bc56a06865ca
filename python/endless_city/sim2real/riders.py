"""Riders and what they ride as one box."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from endless_city.sim2real.labelled import areas, overlaps

if TYPE_CHECKING:
    from numpy.typing import NDArray

# A rider sits on what is ridden: the boxes share at least this much of the smaller one.
_SHARED = 0.2

Box = Sequence[float]
"""Left, top, right, bottom, pixels."""


def union(first: Box, second: Box) -> list[float]:
    """The smallest box around two."""
    return [
        min(first[0], second[0]),
        min(first[1], second[1]),
        max(first[2], second[2]),
        max(first[3], second[3]),
    ]


def joined(riders: Sequence[Box], two_wheelers: Sequence[Box]) -> list[list[float]]:
    """Two-wheelers with those who ride them, and riders of whom no two-wheeler is labelled.

    Each rider belongs to the two-wheeler whose box shares most with the rider's; one may carry several.
    """
    boxes = [list(box) for box in two_wheelers]
    alone: list[list[float]] = []
    for rider in riders:
        place = _ridden(_array([rider]), _array(two_wheelers)) if two_wheelers else -1
        if place < 0:
            alone.append(list(rider))
        else:
            boxes[place] = union(boxes[place], rider)
    return boxes + alone


def _array(boxes: Sequence[Box]) -> NDArray[np.float64]:
    return np.reshape(np.array([list(box) for box in boxes], dtype=np.float64), (-1, 4))


def _ridden(rider: NDArray[np.float64], two_wheelers: NDArray[np.float64]) -> int:
    """The place of the two-wheeler that somebody rides, -1 if there is none."""
    smaller = np.minimum(areas(rider), areas(two_wheelers)).clip(1e-9)
    shares = overlaps(rider, two_wheelers)[0] / smaller
    best = int(shares.argmax())
    return best if shares[best] >= _SHARED else -1
