"""A small anchor-free detector of one stage.

A backbone of cross-stage partial blocks (Wang et al. 2020), a pyramid of three levels with strides of 8, 16 and 32 pixels whose
features go down and up again (Liu et al. 2018), and a head for boxes and one for classes at each level. Every cell tells how far
the four sides of a box are from its centre, each as a distribution over `BINS` distances (Li et al. 2020). Of width 1 it has 8.2
million parameters.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import torch
from torch import Tensor, nn
from torch.nn import functional

from endless_city.sim2real.labelled import CLASSES

STRIDES: tuple[int, ...] = (8, 16, 32)
BINS = 16
"""Distances of a side that the head tells apart: 0 to 15 strides."""

GREY = 114.0
"""What fills a picture's surroundings, of 0 to 255; the detector's 0."""

# How much less likely a distance is than the one before, at first: the logarithm.
_NEAR = 0.4

_CHANNELS = (32, 64, 128, 256, 384)


def normalised(pixels: Tensor) -> Tensor:
    """What the detector takes, of pixels of 0 to 255."""
    return (pixels - GREY) / 255.0


class Convolution(nn.Module):
    """With normalisation and SiLU."""

    def __init__(self, inputs: int, outputs: int, kernel: int = 1, stride: int = 1) -> None:
        super().__init__()
        self.convolution = nn.Conv2d(inputs, outputs, kernel, stride, kernel // 2, bias=False)
        self.norm = nn.BatchNorm2d(outputs, eps=1e-3, momentum=0.03)

    def forward(self, features: Tensor) -> Tensor:
        """(B, C, H, W) to (B, C', H', W')."""
        out: Tensor = self.norm(self.convolution(features))
        return functional.silu(out, inplace=True)


class Bottleneck(nn.Module):
    """Two convolutions, beside which the features may pass."""

    def __init__(self, channels: int, residual: bool) -> None:
        super().__init__()
        self.first = Convolution(channels, channels, 3)
        self.second = Convolution(channels, channels, 3)
        self.residual = residual

    def forward(self, features: Tensor) -> Tensor:
        """(B, C, H, W) to the same shape."""
        out: Tensor = self.second(self.first(features))
        return features + out if self.residual else out


class PartialStage(nn.Module):
    """Half of the channels go through bottlenecks; what comes out of each is joined with the other half."""

    def __init__(self, inputs: int, outputs: int, blocks: int = 1, residual: bool = False) -> None:
        super().__init__()
        half = outputs // 2
        self.enter = Convolution(inputs, 2 * half)
        self.blocks = nn.ModuleList(Bottleneck(half, residual) for _ in range(blocks))
        self.leave = Convolution((2 + blocks) * half, outputs)

    def forward(self, features: Tensor) -> Tensor:
        """(B, C, H, W) to (B, C', H, W)."""
        entered: Tensor = self.enter(features)
        parts = list(entered.chunk(2, 1))
        for block in self.blocks:
            parts.append(block(parts[-1]))
        out: Tensor = self.leave(torch.cat(parts, 1))
        return out


class WidePooling(nn.Module):
    """Maxima over ever wider windows, 5, 9 and 13 cells, beside the features themselves (He et al. 2015)."""

    def __init__(self, channels: int) -> None:
        super().__init__()
        self.enter = Convolution(channels, channels // 2)
        self.leave = Convolution(4 * (channels // 2), channels)

    def forward(self, features: Tensor) -> Tensor:
        """(B, C, H, W) to the same shape."""
        entered: Tensor = self.enter(features)
        parts = [entered]
        for _ in range(3):
            parts.append(_maximum_along(_maximum_along(parts[-1], 2), 3))
        out: Tensor = self.leave(torch.cat(parts, 1))
        return out


def _maximum_along(features: Tensor, axis: int, reach: int = 2) -> Tensor:
    """Maxima of windows along an axis; unlike those of max_pool2d, its gradients are the same at each run on a GPU."""
    out = features
    length = features.shape[axis]
    for shift in range(1, min(reach, length - 1) + 1):
        ahead = torch.cat([features.narrow(axis, shift, length - shift), features.narrow(axis, length - shift, shift)], axis)
        behind = torch.cat([features.narrow(axis, 0, shift), features.narrow(axis, 0, length - shift)], axis)
        out = torch.maximum(out, torch.maximum(ahead, behind))
    return out


def _doubled(features: Tensor) -> Tensor:
    """Twice as wide and high, each cell four times; unlike those of interpolate, its gradients are the same at each run."""
    batch, channels, height, width = features.shape
    wide = features[:, :, :, None, :, None].expand(batch, channels, height, 2, width, 2)
    return wide.reshape(batch, channels, 2 * height, 2 * width)


class Detector(nn.Module):
    """Boxes and classes of pictures whose sides are multiples of 32 pixels."""

    def __init__(self, width: float = 1.0) -> None:
        """With new weights.

        Args:
            width: How many channels there are, as a share of the usual ones.
        """
        super().__init__()
        c1, c2, c3, c4, c5 = (max(8, int(channels * width) // 8 * 8) for channels in _CHANNELS)
        self.stem = nn.Sequential(Convolution(3, c1, 3, 2), Convolution(c1, c2, 3, 2), PartialStage(c2, c2, 1, True))
        self.stage8 = nn.Sequential(Convolution(c2, c3, 3, 2), PartialStage(c3, c3, 2, True))
        self.stage16 = nn.Sequential(Convolution(c3, c4, 3, 2), PartialStage(c4, c4, 2, True))
        self.stage32 = nn.Sequential(Convolution(c4, c5, 3, 2), PartialStage(c5, c5, 1, True), WidePooling(c5))
        self.down16, self.down8 = PartialStage(c5 + c4, c4), PartialStage(c4 + c3, c3)
        self.halve8, self.up16 = Convolution(c3, c3, 3, 2), PartialStage(c3 + c4, c4)
        self.halve16, self.up32 = Convolution(c4, c4, 3, 2), PartialStage(c4 + c5, c5)
        levels = (c3, c4, c5)
        self.box_heads = nn.ModuleList(_head(c, max(16, int(64 * width)), 4 * BINS) for c in levels)
        self.class_heads = nn.ModuleList(_head(c, max(16, int(96 * width)), len(CLASSES)) for c in levels)
        self._begin()

    def _begin(self) -> None:
        """First weights: every cell tells a box of some strides, and that there is hardly ever an object."""
        for module in self.modules():
            if isinstance(module, nn.Conv2d):
                nn.init.kaiming_normal_(module.weight, nonlinearity="relu")
        # Near distances are more likely than far ones.
        near = -_NEAR * torch.arange(BINS).repeat(4)
        for boxes, classes, stride in zip(self.box_heads, self.class_heads, STRIDES):
            _begin_last(boxes, near)
            # About five cells of a picture of 640 pixels have one.
            _begin_last(classes, torch.full((len(CLASSES),), math.log(5 / len(CLASSES) / (640 / stride) ** 2)))

    def forward(self, pictures: Tensor) -> tuple[Tensor, Tensor]:
        """Of pictures (B, 3, H, W), as of `normalised`: logits of distances (B, A, 4 * BINS) and of classes (B, A, C).

        The A cells are those of `cells`.
        """
        at8: Tensor = self.stage8(self.stem(pictures))
        at16: Tensor = self.stage16(at8)
        at32: Tensor = self.stage32(at16)
        down16: Tensor = self.down16(torch.cat([_doubled(at32), at16], 1))
        out8: Tensor = self.down8(torch.cat([_doubled(down16), at8], 1))
        out16: Tensor = self.up16(torch.cat([self.halve8(out8), down16], 1))
        out32: Tensor = self.up32(torch.cat([self.halve16(out16), at32], 1))
        levels = (out8, out16, out32)
        return _flat(self.box_heads, levels), _flat(self.class_heads, levels)


def _head(inputs: int, channels: int, outputs: int) -> nn.Sequential:
    return nn.Sequential(Convolution(inputs, channels, 3), Convolution(channels, channels, 3), nn.Conv2d(channels, outputs, 1))


def _begin_last(head: nn.Module, bias: Tensor) -> None:
    """First weights of the last convolution of a head."""
    last = list(head.children())[-1]
    assert isinstance(last, nn.Conv2d) and last.bias is not None
    nn.init.normal_(last.weight, std=0.01)
    with torch.no_grad():
        last.bias.copy_(bias)


def _flat(heads: nn.ModuleList, levels: Sequence[Tensor]) -> Tensor:
    """What heads say of the cells of all levels, (B, A, outputs)."""
    parts: list[Tensor] = [head(features) for head, features in zip(heads, levels)]
    return torch.cat([part.flatten(2) for part in parts], 2).transpose(1, 2)


def cells(height: int, width: int, device: torch.device) -> tuple[Tensor, Tensor]:
    """Centres (A, 2), x and y in pixels, and strides (A,) of the cells of a picture, by level, row and column."""
    centres: list[Tensor] = []
    strides: list[Tensor] = []
    for stride in STRIDES:
        y, x = torch.meshgrid(
            torch.arange(height // stride, device=device) + 0.5,
            torch.arange(width // stride, device=device) + 0.5,
            indexing="ij",
        )
        of_level = torch.stack([x, y], -1).flatten(0, 1) * stride
        centres.append(of_level)
        strides.append(torch.full((len(of_level),), float(stride), device=device))
    return torch.cat(centres), torch.cat(strides)


def boxes_of(distances: Tensor, centres: Tensor, strides: Tensor) -> Tensor:
    """Boxes (B, A, 4), left, top, right, bottom in pixels, of logits of distances (B, A, 4 * BINS)."""
    shares = distances.reshape(*distances.shape[:-1], 4, BINS).softmax(-1)
    bins = torch.arange(BINS, device=distances.device, dtype=distances.dtype)
    sides = (shares * bins).sum(-1) * strides[:, None]
    return torch.cat([centres - sides[..., :2], centres + sides[..., 2:]], -1)
