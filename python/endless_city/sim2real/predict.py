"""What a detector finds in pictures."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, cast

import numpy as np
import torch
from torch import Tensor
from torchvision import ops  # type: ignore[import-untyped, unused-ignore]

from endless_city.sim2real.augment import resized
from endless_city.sim2real.average_precision import MOST_DETECTIONS, Detections
from endless_city.sim2real.detector import GREY, STRIDES, Detector, boxes_of, cells, normalised
from endless_city.sim2real.labelled import CLASSES, LabelledImage
from endless_city.sim2real.repeatable import repeatable
from endless_city.sim2real.sizes import input_scale

if TYPE_CHECKING:
    from numpy.typing import NDArray

_BATCH = 16
_READERS = 4
# Detections before those of the same object are dropped.
_CANDIDATES = 2000
_LEAST_SCORE = 0.003
_SAME_OBJECT = 0.6


def predict(model: Detector, images: Sequence[LabelledImage], longest: int, device: torch.device) -> list[Detections]:
    """Detections in each picture, in its own pixels.

    Args:
        model: The detector.
        images: Pictures.
        longest: Their longer side as the detector sees them, pixels.
        device: Where the detector is.

    Raises:
        DatasetError: A picture cannot be read.
    """
    found: list[Detections] = []
    with repeatable(0, device), torch.no_grad(), ThreadPoolExecutor(_READERS) as pool:
        for part in _alike(images):
            pixels = list(pool.map(_read, part))
            found += _predict(model, pixels, longest, device)
    return found


def _read(image: LabelledImage) -> NDArray[np.uint8]:
    return image.read()


def _alike(images: Sequence[LabelledImage]) -> Iterator[list[LabelledImage]]:
    """Parts of pictures of one size, in order."""
    part: list[LabelledImage] = []
    for image in images:
        if part and (len(part) == _BATCH or part[0].size != image.size):
            yield part
            part = []
        part.append(image)
    if part:
        yield part


def _predict(model: Detector, pixels: Sequence[NDArray[np.uint8]], longest: int, device: torch.device) -> list[Detections]:
    """Of pictures of one size."""
    height, width = pixels[0].shape[:2]
    scale = input_scale((width, height), longest)
    new_width, new_height = max(1, round(width * scale)), max(1, round(height * scale))
    stack: Tensor = cast(Any, torch).from_numpy(np.stack([np.transpose(one, (2, 0, 1)) for one in pixels]))
    pictures = torch.full((len(pixels), 3, _whole(new_height), _whole(new_width)), GREY, device=device)
    pictures[:, :, :new_height, :new_width] = resized(stack.to(device).float(), new_width, new_height)
    distances, classes = model(normalised(pictures).contiguous(memory_format=torch.channels_last))
    centres, strides = cells(pictures.shape[2], pictures.shape[3], device)
    boxes = boxes_of(distances, centres, strides)
    # From the detector's pixels to the picture's.
    ratios = torch.tensor([width / new_width, height / new_height] * 2, device=device)
    limits = torch.tensor([width, height] * 2, device=device)
    boxes = torch.minimum((boxes * ratios).clamp(min=0), limits)
    return [_detections(one, of_one) for one, of_one in zip(boxes, classes.sigmoid())]


def _whole(side: int) -> int:
    """A side, rounded up to whole cells of the largest stride."""
    return -(-side // STRIDES[-1]) * STRIDES[-1]


def _detections(boxes: Tensor, scores: Tensor) -> Detections:
    """Of a picture's cells: boxes (A, 4), scores (A, C)."""
    best, places = scores.flatten().topk(min(_CANDIDATES, scores.numel()))
    best, places = best[best > _LEAST_SCORE], places[best > _LEAST_SCORE]
    boxes, classes = boxes[places // len(CLASSES)], places % len(CLASSES)
    kept: Tensor = ops.batched_nms(boxes, best, classes, _SAME_OBJECT)[: MOST_DETECTIONS * len(CLASSES)]
    return Detections(
        _array(boxes[kept]).astype(np.float64), _array(best[kept]).astype(np.float64), _array(classes[kept]).astype(np.int64)
    )


def _array(tensor: Tensor) -> NDArray[Any]:
    array: NDArray[Any] = cast(Any, tensor.cpu()).numpy()
    return array
