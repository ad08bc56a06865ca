"""Training a detector from scratch."""

from __future__ import annotations

import copy
import math
import time
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from functools import partial
from typing import Any, Callable, cast

import numpy as np
import torch
from torch import Tensor, nn

from endless_city.errors import EndlessError
from endless_city.sim2real.augment import Sample, resized, training_batch
from endless_city.sim2real.detector import Detector, cells, normalised
from endless_city.sim2real.labelled import CLASSES, LabelledImage, LabelledSet, Labels
from endless_city.sim2real.losses import detection_loss
from endless_city.sim2real.repeatable import repeatable

_LEARNING_RATE = 2e-3
_WEIGHT_DECAY = 0.03
_LAST_RATE = 0.01
_WARM_UP = 150
_MOSAICS = 0.8
# The last part of the training sees whole pictures.
_WITHOUT_MOSAICS = 0.15
_LARGEST_GRADIENT = 10.0
_AVERAGE = 0.999
# Iterations before the time is forecast: the first take longer.
_FORECAST_AFTER = 4
_READERS = 4
# Pictures lie on the GPU if they take no more of its free memory.
_SHARE_OF_MEMORY = 0.4


@dataclass(frozen=True)
class TrainOptions:
    """How to train.

    - `iterations`, `batch`: steps, and pictures of each;
    - `size`: sides of training pictures, pixels, a multiple of 32;
    - `width`: of the detector;
    - `device`: where it is trained.
    """

    iterations: int
    batch: int
    size: int
    width: float
    device: torch.device


@dataclass(frozen=True)
class Progress:
    """How far a training is.

    - `iteration`: steps that are done;
    - `loss`: of the last of them;
    - `seconds_left`: until its end.
    """

    iteration: int
    loss: float
    seconds_left: float


def load_samples(sets: Sequence[LabelledSet], longest: int, device: torch.device) -> list[Sample]:
    """Pictures of sets in memory, none longer than `longest` pixels.

    Raises:
        DatasetError: A picture cannot be read.
    """
    jobs = [(image, one.classes) for one in sets for image in one.images]
    with ThreadPoolExecutor(_READERS) as pool:
        samples = list(pool.map(partial(_sample, longest=longest), *zip(*jobs)))
    if device.type == "cuda":
        free, _ = torch.cuda.mem_get_info(device)
        if sum(sample.pixels.numel() for sample in samples) < _SHARE_OF_MEMORY * free:
            samples = [Sample(sample.pixels.to(device), sample.labels, sample.unlabelled) for sample in samples]
    return samples


def _sample(image: LabelledImage, classes: Sequence[int], *, longest: int) -> Sample:
    pixels: Tensor = cast(Any, torch).from_numpy(np.ascontiguousarray(np.transpose(image.read(), (2, 0, 1))))
    height, width = pixels.shape[1:]
    scale = min(1.0, longest / max(width, height))
    if scale < 1:
        small = resized(pixels[None].float(), max(1, round(width * scale)), max(1, round(height * scale)))[0]
        pixels = small.round().clamp(0, 255).to(torch.uint8)
    ratios = np.array([pixels.shape[2] / width, pixels.shape[1] / height] * 2)
    labels = Labels(image.labels.boxes * ratios, image.labels.classes, image.labels.ignored)
    return Sample(pixels, labels, [number for number in range(len(CLASSES)) if number not in classes])


def train(samples: Sequence[Sample], options: TrainOptions, seed: int, told: Callable[[Progress], None]) -> Detector:
    """A detector that learnt from samples: the moving average of its weights.

    The same samples, options and seed give the same detector on the same machine.

    Args:
        samples: What to learn from.
        options: How.
        seed: Of first weights and of all chance.
        told: Hears of progress: once the time can be forecast, and twenty times in all.

    Raises:
        EndlessError: The loss is not finite any more.
    """
    with repeatable(seed, options.device):
        return _train(samples, options, np.random.default_rng(seed), told)


def _train(
    samples: Sequence[Sample], options: TrainOptions, random: np.random.Generator, told: Callable[[Progress], None]
) -> Detector:
    device, iterations = options.device, options.iterations
    model = Detector(options.width).to(device).train()
    cast(Any, model).to(memory_format=torch.channels_last)
    average = copy.deepcopy(model).eval()
    optimiser = _optimiser(model, device)
    precision = _precision(device)
    # Half floats, unlike bfloat16, need their gradients scaled.
    scaler = _scaler(enabled=precision == torch.float16)
    centres, strides = cells(options.size, options.size, device)
    every = max(1, iterations // 20)
    begun = time.monotonic()
    for iteration in range(iterations):
        rate = _rate(iteration, iterations)
        for group in optimiser.param_groups:
            group["lr"] = rate
        mosaics = _MOSAICS if iteration < (1 - _WITHOUT_MOSAICS) * iterations else 0.0
        pixels, targets = training_batch(
            samples, random, count=options.batch, size=options.size, mosaics=mosaics, device=device
        )
        pictures = normalised(pixels).contiguous(memory_format=torch.channels_last)
        with torch.autocast(device.type, dtype=precision, enabled=precision != torch.float32):
            answers: tuple[Tensor, Tensor] = model(pictures)
        loss = detection_loss(*answers, centres, strides, targets)
        optimiser.zero_grad(set_to_none=True)
        scaler.scale(loss).backward()
        scaler.unscale_(optimiser)
        nn.utils.clip_grad_norm_(model.parameters(), _LARGEST_GRADIENT)
        scaler.step(optimiser)
        scaler.update()
        _follow(average, model, iteration, iterations)
        done = iteration + 1
        if done in (_FORECAST_AFTER, iterations) or done % every == 0:
            value = float(loss.detach())
            if not math.isfinite(value):
                raise EndlessError(f"training failed after {done} iterations, its loss is {value}: use other --seeds")
            told(Progress(done, value, (time.monotonic() - begun) / done * (iterations - done)))
    return average


def _optimiser(model: nn.Module, device: torch.device) -> torch.optim.AdamW:
    matrices = [weights for weights in model.parameters() if weights.ndim > 1]
    others = [weights for weights in model.parameters() if weights.ndim <= 1]
    groups: list[dict[str, Any]] = [
        {"params": matrices, "weight_decay": _WEIGHT_DECAY},
        {"params": others, "weight_decay": 0.0},
    ]
    return torch.optim.AdamW(groups, lr=_LEARNING_RATE, fused=device.type == "cuda")


def _scaler(*, enabled: bool) -> Any:
    """What scales losses; PyTorch has moved it."""
    kind: Any = getattr(torch.amp, "GradScaler", None) or cast(Any, torch.cuda.amp).GradScaler
    return kind(enabled=enabled)


def _precision(device: torch.device) -> torch.dtype:
    """What the detector computes with: GPUs in 16 bits."""
    if device.type != "cuda":
        return torch.float32
    return torch.bfloat16 if torch.cuda.get_device_capability(device) >= (8, 0) else torch.float16


def _rate(iteration: int, iterations: int) -> float:
    """The learning rate: it rises, then falls as a cosine."""
    warm = min(1.0, (iteration + 1) / min(_WARM_UP, iterations // 5 + 1))
    falling = _LAST_RATE + (1 - _LAST_RATE) * (1 + math.cos(math.pi * iteration / iterations)) / 2
    return _LEARNING_RATE * warm * falling


def _follow(average: nn.Module, model: nn.Module, iteration: int, iterations: int) -> None:
    """Moves the average towards the weights, fast at first."""
    share = 1 - _AVERAGE * (1 - math.exp(-(iteration + 1) / max(20.0, iterations / 10)))
    with torch.no_grad():
        for mean, weights in zip(average.state_dict().values(), model.state_dict().values()):
            if mean.is_floating_point():
                mean.lerp_(weights, share)
            else:
                mean.copy_(weights)
