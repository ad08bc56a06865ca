"""Which cells learn which box: task-aligned assignment (Feng et al. 2021).

A box is learnt by the cells in it that already tell it best: those with the largest score^0.5 * IoU^6, ten at most. What a cell is
to answer for its class follows from how well it does, so that confidence comes to tell how good a box is.
"""

from __future__ import annotations

from dataclasses import dataclass

import torch
from torch import Tensor

from endless_city.sim2real.box_losses import iou

_CELLS = 10
# Smaller boxes reach as far as one of this side, so that the centre of a cell is in each.
_LEAST_SIDE = 9.0


@dataclass(frozen=True)
class Targets:
    """Boxes of B pictures, up to M each.

    - `boxes`: (B, M, 4): left, top, right, bottom, pixels;
    - `classes`: (B, M): places in `CLASSES`;
    - `wanted`: bool, (B, M): what is to be learnt;
    - `ignored`: bool, (B, M): where the class may be answered as one likes. What is neither is none.
    """

    boxes: Tensor
    classes: Tensor
    wanted: Tensor
    ignored: Tensor


@dataclass(frozen=True)
class Assignment:
    """What the A cells of B pictures learn.

    - `box`: (B, A): places of boxes;
    - `learns`: bool, (B, A): whether it learns its box;
    - `quality`: (B, A): what it is to answer for the box's class, 0 to 1; 0 where it learns none.
    """

    box: Tensor
    learns: Tensor
    quality: Tensor


def assign(scores: Tensor, boxes: Tensor, centres: Tensor, targets: Targets) -> Assignment:
    """Assigns boxes to cells; nothing flows back through it.

    Args:
        scores: (B, A, C): what cells answer, 0 to 1.
        boxes: (B, A, 4): their boxes.
        centres: (A, 2): their centres, pixels.
        targets: What there is.
    """
    with torch.no_grad():
        inside = _inside(centres, targets)
        overlap = iou(targets.boxes[:, :, None], boxes[:, None]) * inside
        of_class = scores.transpose(1, 2).gather(1, targets.classes[..., None].expand(-1, -1, len(centres)))
        fit = of_class.sqrt() * overlap**6
        best = fit.topk(min(_CELLS, len(centres)), -1).indices
        candidate = torch.zeros_like(inside).scatter(-1, best, True) & inside
        # Of several boxes a cell learns the one that it tells best.
        box = torch.where(candidate, overlap, torch.full_like(overlap, -1.0)).argmax(1)
        numbers = torch.arange(inside.shape[1], device=box.device)
        kept = candidate & (numbers[None, :, None] == box[:, None])
        fit = fit * kept
        # The best cell of a box answers its IoU, the others less.
        top_overlap = (overlap * kept).amax(-1, keepdim=True)
        quality = fit * top_overlap / fit.amax(-1, keepdim=True).clamp(min=1e-12)
        return Assignment(box, kept.any(1), quality.amax(1))


def _inside(centres: Tensor, targets: Targets) -> Tensor:
    """bool, (B, M, A): whether the centre of a cell is in a box that is to be learnt."""
    middle = (targets.boxes[..., :2] + targets.boxes[..., 2:]) / 2
    reach = (targets.boxes[..., 2:] - targets.boxes[..., :2]).clamp(min=_LEAST_SIDE) / 2
    near = (centres[None, None] - middle[:, :, None]).abs() < reach[:, :, None]
    return near.all(-1) & targets.wanted[..., None]
