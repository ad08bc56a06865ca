"""The same figures at each run on the same machine."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from typing import Any, cast

import torch


@contextmanager
def repeatable(seed: int, device: torch.device) -> Generator[None, None, None]:
    """PyTorch's own chance begins with the seed, and its algorithms give the same at each run; all as before afterwards."""
    backend: Any = torch.backends.cudnn
    chance: Any = cast(Any, torch.random)
    before = torch.are_deterministic_algorithms_enabled(), torch.is_deterministic_algorithms_warn_only_enabled()
    cudnn_before = backend.deterministic, backend.benchmark
    devices = [device.index or 0] if device.type == "cuda" else []
    with chance.fork_rng(devices):
        chance.manual_seed(seed)
        torch.use_deterministic_algorithms(True, warn_only=True)
        backend.deterministic, backend.benchmark = True, False
        try:
            yield
        finally:
            torch.use_deterministic_algorithms(before[0], warn_only=before[1])
            backend.deterministic, backend.benchmark = cudnn_before
