"""One small dataset for all tests."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import endless_city

RECIPE: dict[str, Any] = {
    "videos": 2,
    "maps": ["Town01"],
    "size": (161, 91),
    "fps": 5,
    "duration": 0.8,
    "min_pixels": 10,
    "vehicles": 20,
    "layers": list(endless_city.LAYERS),
    "mp4": [],
    "seed": 3,
}


@pytest.fixture(scope="session")
def out(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("dataset") / "out"
    made = endless_city.generate(folder, progress=False, **RECIPE)
    assert (made.videos, made.camera_frames) == (2, 16)
    assert made.bytes > 0 and made.seconds > 0
    return folder
