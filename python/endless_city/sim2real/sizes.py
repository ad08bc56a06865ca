"""Sizes of objects as the detector sees them: COCO's, and tiny."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from endless_city.sim2real.labelled import areas

if TYPE_CHECKING:
    from numpy.typing import NDArray

SIZES: tuple[str, ...] = ("tiny", "small", "medium", "large")
"""Longer side under 16 pixels; else area under 32², under 96², and larger."""

TINY_SIDE = 16.0
SMALL_AREA = 32.0**2
MEDIUM_AREA = 96.0**2


def sizes(boxes: NDArray[np.float64], scale: float) -> NDArray[np.int64]:
    """int64, (N,): places in `SIZES`.

    Args:
        boxes: (N, 4): left, top, right, bottom, pixels of the picture.
        scale: The detector's pixels over the picture's.
    """
    seen = boxes * scale
    longer = (seen[:, 2:] - seen[:, :2]).max(1, initial=0.0)
    area = areas(seen)
    by_area = 1 + (area >= SMALL_AREA).astype(np.int64) + (area >= MEDIUM_AREA)
    return np.where(longer < TINY_SIDE, 0, by_area).astype(np.int64)


def input_scale(size: tuple[int, int], longest: int) -> float:
    """The detector's pixels over those of a picture of a width and height, whose longer side becomes `longest`."""
    return longest / max(size)
