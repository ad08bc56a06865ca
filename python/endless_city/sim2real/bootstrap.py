"""Intervals by the bootstrap (Efron 1979): the test is repeated with cameras, or pictures, that are drawn again and again.

Pictures of one camera are alike, so that cameras are what must be drawn: an interval over pictures tells nothing of other cameras.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Optional

import numpy as np

from endless_city.sim2real.labelled import LabelledImage

if TYPE_CHECKING:
    from numpy.typing import NDArray

DRAWS = 1000
_SEED = 0


@dataclass(frozen=True)
class Groups:
    """What is drawn.

    - `of_image`: int64, (I,): the group of each picture, from 0;
    - `count`: number of groups;
    - `kind`: "cameras" or "pictures".
    """

    of_image: NDArray[np.int64]
    count: int
    kind: str

    def weights(self, draws: int = DRAWS) -> NDArray[np.float64]:
        """float64, (draws, I): how often each picture is drawn, of as many groups as there are, drawn with replacement.

        They are the same at each call, so that all that is compared has the same draws.
        """
        random = np.random.default_rng(_SEED)
        drawn = random.integers(self.count, size=(draws, self.count))
        times = np.stack([np.bincount(row, minlength=self.count) for row in drawn])
        return times[:, self.of_image].astype(np.float64)


def groups(images: Sequence[LabelledImage]) -> Groups:
    """Cameras, if they are known and there are two or more; else pictures."""
    cameras: list[Optional[str]] = [image.camera for image in images]
    names = sorted({camera for camera in cameras if camera is not None})
    if None in cameras or len(names) < 2:
        return Groups(np.arange(len(images)), len(images), "pictures")
    place = {name: number for number, name in enumerate(names)}
    return Groups(np.array([place[camera] for camera in cameras if camera is not None]), len(names), "cameras")


@dataclass(frozen=True)
class Estimate:
    """A figure of several seeds.

    - `mean`: over the seeds;
    - `low`, `high`: the interval of the mean that holds 95 % of the bootstrap's draws;
    - `seeds`: the figure of each.
    """

    mean: float
    low: float
    high: float
    seeds: Sequence[float]

    @property
    def spread(self) -> float:
        """From the least seed to the largest."""
        return max(self.seeds) - min(self.seeds)


def estimate(
    figures: Sequence[Callable[[Optional[NDArray[np.float64]]], float]], weights: NDArray[np.float64]
) -> tuple[Estimate, NDArray[np.float64]]:
    """A figure with its interval, and its value at each draw.

    Args:
        figures: One of each seed; takes weights of pictures.
        weights: float64, (draws, I), as of `Groups.weights`.
    """
    seeds = [figure(None) for figure in figures]
    drawn = np.array([[figure(row) for figure in figures] for row in weights]).mean(1)
    return summary(seeds, drawn), drawn


def summary(seeds: Sequence[float], drawn: NDArray[np.float64]) -> Estimate:
    """An estimate of figures of seeds and of draws, of which those without anything to find are left out."""
    known = drawn[~np.isnan(drawn)]
    low, high = np.percentile(known, [2.5, 97.5]) if len(known) else (float("nan"), float("nan"))
    return Estimate(float(np.mean(seeds)), float(low), float(high), list(seeds))
