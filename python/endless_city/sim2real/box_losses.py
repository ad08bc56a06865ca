"""How boxes differ: IoU, complete IoU, distances as distributions."""

from __future__ import annotations

import math

import torch
from torch import Tensor
from torch.nn import functional

from endless_city.sim2real.detector import BINS

_LITTLE = 1e-7


def iou(first: Tensor, second: Tensor) -> Tensor:
    """Intersection over union of boxes (..., 4): left, top, right, bottom; shapes are broadcast."""
    shared = (torch.minimum(first[..., 2:], second[..., 2:]) - torch.maximum(first[..., :2], second[..., :2])).clamp(min=0)
    intersection = shared.prod(-1)
    areas = (first[..., 2:] - first[..., :2]).prod(-1) + (second[..., 2:] - second[..., :2]).prod(-1)
    return intersection / (areas - intersection + _LITTLE)


def complete_iou(first: Tensor, second: Tensor) -> Tensor:
    """IoU less what centres and aspects differ (Zheng et al. 2020), (N,), of boxes (N, 4)."""
    overlap = iou(first, second)
    hull = torch.maximum(first[:, 2:], second[:, 2:]) - torch.minimum(first[:, :2], second[:, :2])
    apart = (first[:, :2] + first[:, 2:] - second[:, :2] - second[:, 2:]) / 2
    aspects = _aspect(second) - _aspect(first)
    aspect = 4 / math.pi**2 * aspects**2
    weight = (aspect / (aspect - overlap + 1 + _LITTLE)).detach()
    return overlap - (apart**2).sum(-1) / ((hull**2).sum(-1) + _LITTLE) - weight * aspect


def _aspect(boxes: Tensor) -> Tensor:
    width, height = (boxes[:, 2:] - boxes[:, :2]).unbind(-1)
    return torch.atan(width / (height + _LITTLE))


def distribution_focal_loss(logits: Tensor, sides: Tensor) -> Tensor:
    """(N,): cross entropy with the two distances next to the right one (Li et al. 2020), mean of the four sides.

    Args:
        logits: (N, 4 * BINS): of distances.
        sides: (N, 4): the right distances, strides; those that are too far count as the farthest.
    """
    right = sides.clamp(0, BINS - 1.01)
    below = right.long()
    share_above = right - below
    flat = logits.reshape(-1, BINS)
    at_below = functional.cross_entropy(flat, below.flatten(), reduction="none").view(-1, 4)
    at_above = functional.cross_entropy(flat, below.flatten() + 1, reduction="none").view(-1, 4)
    return (at_below * (1 - share_above) + at_above * share_above).mean(-1)
