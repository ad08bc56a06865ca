"""Pictures for training: mosaics of four, or one, at chance scales, places and flips, in chance colours.

Everything is drawn from NumPy's generator, so that it is the same on all devices.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import torch
from torch import Tensor
from torch.nn import functional

from endless_city.sim2real.assignment import Targets
from endless_city.sim2real.detector import GREY
from endless_city.sim2real.labelled import CLASSES, Labels, areas, labels_of

if TYPE_CHECKING:
    from numpy.typing import NDArray

# Scales of pictures, of one that just fits: in mosaics, and alone.
_MOSAIC_SCALES = (0.4, 1.3)
_SINGLE_SCALES = (0.5, 1.7)
_ASPECT = 0.25
# What is smaller, or of which less is left, is ignored: pixels, share.
_LEAST_SIDE = 3.0
_LEAST_LEFT = 0.25


@dataclass(frozen=True)
class Sample:
    """A picture to learn from.

    - `pixels`: uint8, (3, H, W);
    - `labels`: in its pixels;
    - `unlabelled`: classes that may be in it without boxes.
    """

    pixels: Tensor
    labels: Labels
    unlabelled: Sequence[int]


@dataclass(frozen=True)
class _Tile:
    """Where a picture goes: a part of the canvas, and the picture as it lies there, partly beyond it; pixels."""

    part: tuple[int, int, int, int]
    left: int
    top: int
    width: int
    height: int
    flipped: bool


def training_batch(
    samples: Sequence[Sample], random: np.random.Generator, *, count: int, size: int, mosaics: float, device: torch.device
) -> tuple[Tensor, Targets]:
    """Pictures (B, 3, size, size), pixels of 0 to 255, and their targets.

    Args:
        samples: What to take them from.
        random: Source of chance.
        count: B.
        size: Their sides, pixels.
        mosaics: Share of mosaics, 0 to 1.
        device: Where they are made.
    """
    canvases: list[Tensor] = []
    labels: list[Labels] = []
    for _ in range(count):
        canvas, of_canvas = _canvas(samples, random, size, random.random() < mosaics, device)
        canvases.append(canvas)
        labels.append(of_canvas)
    return _recoloured(torch.stack(canvases), random), targets_of(labels, device)


def targets_of(labels: Sequence[Labels], device: torch.device) -> Targets:
    """Labels of pictures side by side."""
    most = max(1, max(len(one) for one in labels))
    boxes = np.zeros((len(labels), most, 4), np.float32)
    classes = np.zeros((len(labels), most), np.int64)
    wanted, ignored = np.zeros((2, len(labels), most), np.bool_)
    for place, one in enumerate(labels):
        boxes[place, : len(one)] = one.boxes
        classes[place, : len(one)] = one.classes
        wanted[place, : len(one)] = ~one.ignored
        ignored[place, : len(one)] = one.ignored
    return Targets(*(_tensor(array).to(device) for array in (boxes, classes, wanted, ignored)))


def _tensor(array: NDArray[Any]) -> Tensor:
    tensor: Tensor = cast(Any, torch).from_numpy(array)
    return tensor


def _canvas(
    samples: Sequence[Sample], random: np.random.Generator, size: int, mosaic: bool, device: torch.device
) -> tuple[Tensor, Labels]:
    canvas = torch.full((3, size, size), GREY, device=device)
    parts = [(0, 0, size, size)]
    if mosaic:
        x, y = (int(value) for value in size * random.uniform(0.3, 0.7, 2))
        parts = [(0, 0, x, y), (x, 0, size, y), (0, y, x, size), (x, y, size, size)]
    rows: list[tuple[Sequence[float], int, bool]] = []
    for part in parts:
        sample = samples[int(random.integers(len(samples)))]
        tile = _tile(sample, part, random, size, _MOSAIC_SCALES if mosaic else _SINGLE_SCALES)
        _paste(canvas, sample, tile)
        rows += _rows(sample, tile)
    return canvas, labels_of(rows)


def _tile(
    sample: Sample, part: tuple[int, int, int, int], random: np.random.Generator, size: int, scales: tuple[float, float]
) -> _Tile:
    _, height, width = sample.pixels.shape
    scale = size / max(width, height) * math.exp(random.uniform(math.log(scales[0]), math.log(scales[1])))
    # The square root of width over height, beside that of the picture.
    aspect = math.exp(random.uniform(-_ASPECT, _ASPECT) / 2)
    new_width = max(1, round(width * scale * aspect))
    new_height = max(1, round(height * scale / aspect))
    left = part[0] + round(random.random() * (part[2] - part[0] - new_width))
    top = part[1] + round(random.random() * (part[3] - part[1] - new_height))
    return _Tile(part, left, top, new_width, new_height, bool(random.random() < 0.5))


def _paste(canvas: Tensor, sample: Sample, tile: _Tile) -> None:
    x0, y0 = max(tile.part[0], tile.left), max(tile.part[1], tile.top)
    x1, y1 = min(tile.part[2], tile.left + tile.width), min(tile.part[3], tile.top + tile.height)
    if x1 <= x0 or y1 <= y0:
        return
    pixels = sample.pixels.to(canvas.device)[None].float()
    pixels = resized(pixels.flip(3) if tile.flipped else pixels, tile.width, tile.height)[0]
    canvas[:, y0:y1, x0:x1] = pixels[:, y0 - tile.top : y1 - tile.top, x0 - tile.left : x1 - tile.left]


def resized(pixels: Tensor, width: int, height: int) -> Tensor:
    """Pictures (B, 3, H, W) of another size, without aliases."""
    out: Tensor = functional.interpolate(pixels, (height, width), mode="bilinear", align_corners=False, antialias=True)
    return out


def _rows(sample: Sample, tile: _Tile) -> list[tuple[Sequence[float], int, bool]]:
    """Boxes, classes, and whether they are ignored, on the canvas."""
    _, height, width = sample.pixels.shape
    boxes = np.array(sample.labels.boxes)
    if tile.flipped:
        boxes[:, [0, 2]] = width - boxes[:, [2, 0]]
    boxes *= np.array([tile.width / width, tile.height / height] * 2)
    boxes += np.array([tile.left, tile.top] * 2)
    part = np.array(tile.part, dtype=np.float64)
    kept = np.minimum(np.maximum(boxes, np.tile(part[:2], 2)), np.tile(part[2:], 2))
    sides = kept[:, 2:] - kept[:, :2]
    poor = (sides.min(1, initial=np.inf) < _LEAST_SIDE) | (areas(kept) < _LEAST_LEFT * areas(boxes))
    there = (sides > 0).all(1)
    ignored = sample.labels.ignored | poor
    rows: list[tuple[Sequence[float], int, bool]] = [
        (kept[place].tolist(), int(sample.labels.classes[place]), bool(ignored[place])) for place in np.flatnonzero(there)
    ]
    # Where a class has no boxes nothing is learnt of it.
    return rows + [(part.tolist(), number, True) for number in sample.unlabelled if number < len(CLASSES)]


def _recoloured(pixels: Tensor, random: np.random.Generator) -> Tensor:
    """With other exposure, contrast, colours, sharpness and noise."""
    count = len(pixels)

    def chance(low: float, high: float, share: float = 1.0, usual: float = 1.0) -> Tensor:
        """A number for each picture; the usual one for all but a share of them."""
        values = np.where(random.random(count) < share, random.uniform(low, high, count), usual)
        return _tensor(values.astype(np.float32)).to(pixels.device).view(-1, 1, 1, 1)

    light = (pixels / 255.0).clamp(1e-4, 1.0) ** chance(0.65, 1.5, 0.5)
    cast_of_colour = 1 + 0.08 * random.standard_normal((count, 3, 1, 1)).astype(np.float32)
    light = light * chance(0.65, 1.35) * _tensor(cast_of_colour).to(pixels.device)
    grey = (light * torch.tensor([0.299, 0.587, 0.114], device=pixels.device).view(1, 3, 1, 1)).sum(1, keepdim=True)
    light = grey + (light - grey) * chance(0.4, 1.6) * (1 - chance(1.0, 1.0, 0.1, 0.0))
    mean = light.mean((1, 2, 3), keepdim=True)
    light = mean + (light - mean) * chance(0.7, 1.3)
    light = torch.lerp(light, _blurred(light), chance(1.0, 1.0, 0.2, 0.0))
    noise = random.standard_normal((1, 3, *pixels.shape[2:]), np.float32)
    light = light + _tensor(noise).to(pixels.device) * chance(0.0, 0.06, 0.3, 0.0)
    return light.clamp(0, 1) * 255.0


def _blurred(light: Tensor) -> Tensor:
    out: Tensor = functional.avg_pool2d(light, 3, 1, 1, count_include_pad=False)
    return out
