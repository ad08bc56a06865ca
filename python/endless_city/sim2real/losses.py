"""What training makes small: wrong classes, wrong boxes, wrong distances."""

from __future__ import annotations

import torch
from torch import Tensor
from torch.nn import functional

from endless_city.sim2real.assignment import Assignment, Targets, assign
from endless_city.sim2real.detector import boxes_of
from endless_city.sim2real.box_losses import complete_iou, distribution_focal_loss

_CLASS_WEIGHT = 0.5
_BOX_WEIGHT = 7.5
_DISTANCE_WEIGHT = 1.5


def detection_loss(distances: Tensor, classes: Tensor, centres: Tensor, strides: Tensor, targets: Targets) -> Tensor:
    """The loss, (), of logits of distances (B, A, 4 * BINS) and of classes (B, A, C) of cells."""
    distances, classes = distances.float(), classes.float()
    boxes = boxes_of(distances, centres, strides)
    assigned = assign(classes.detach().sigmoid(), boxes.detach(), centres, targets)
    answers = _answers(classes, targets, assigned)
    whole = answers.sum().clamp(min=1)
    wrong = functional.binary_cross_entropy_with_logits(classes, answers, reduction="none")
    class_loss = (wrong * (_counts(centres, targets, classes) | (answers > 0))).sum() / whole
    learns = assigned.learns
    right = targets.boxes.gather(1, assigned.box[..., None].expand(-1, -1, 4))[learns]
    quality = assigned.quality[learns]
    box_loss = ((1 - complete_iou(boxes[learns], right)) * quality).sum() / whole
    centre = centres.expand(len(boxes), -1, -1)[learns]
    stride = strides.expand(len(boxes), -1)[learns]
    sides = torch.cat([centre - right[:, :2], right[:, 2:] - centre], -1) / stride[:, None]
    distance_loss = (distribution_focal_loss(distances[learns], sides) * quality).sum() / whole
    return _CLASS_WEIGHT * class_loss + _BOX_WEIGHT * box_loss + _DISTANCE_WEIGHT * distance_loss


def _answers(classes: Tensor, targets: Targets, assigned: Assignment) -> Tensor:
    """(B, A, C): what cells are to answer, 0 to 1."""
    of_cell = targets.classes.gather(1, assigned.box)
    quality = assigned.quality * assigned.learns
    return torch.zeros_like(classes).scatter(2, of_cell[..., None], quality[..., None])


def _counts(centres: Tensor, targets: Targets, classes: Tensor) -> Tensor:
    """bool, (B, A, C): whether the answer of a cell counts: not in what is ignored of its class."""
    first, last = targets.boxes[:, :, None, :2], targets.boxes[:, :, None, 2:]
    inside = ((centres >= first) & (centres < last)).all(-1) & targets.ignored[..., None]
    of_class = [(inside & (targets.classes == number)[..., None]).any(1) for number in range(classes.shape[-1])]
    return ~torch.stack(of_class, -1)
