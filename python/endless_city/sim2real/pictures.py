"""Picture files."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PIL import Image, ImageOps

from endless_city.errors import DatasetError

if TYPE_CHECKING:
    from numpy.typing import NDArray

SUFFIXES = frozenset({".jpg", ".jpeg", ".png", ".webp", ".bmp", ".tif", ".tiff"})
"""Ends of the names of files that are pictures, in small letters."""

_EXIF_ORIENTATION = 0x0112
# Turned by 90 degrees.
_SIDEWAYS = frozenset({5, 6, 7, 8})


def is_picture(path: Path) -> bool:
    """Whether a file is a picture, by its name."""
    return path.suffix.lower() in SUFFIXES


def pictures_in(folder: Path) -> list[Path]:
    """All pictures in a folder and in those below it, by name."""
    found = (Path(root) / name for root, _, names in os.walk(folder, followlinks=True) for name in names)
    return sorted(path for path in found if is_picture(path))


def size_of(path: Path) -> tuple[int, int]:
    """Width and height of a picture as it is looked at, pixels.

    Raises:
        DatasetError: It cannot be read.
    """
    try:
        image: Image.Image = Image.open(path)
        with image:
            width, height = image.size
            return (height, width) if image.getexif().get(_EXIF_ORIENTATION) in _SIDEWAYS else (width, height)
    except (OSError, ValueError, Image.DecompressionBombError) as error:
        raise _unreadable(path, error) from error


def read_rgb(path: Path) -> NDArray[np.uint8]:
    """uint8, (H, W, 3): a picture as it is looked at, sRGB.

    Raises:
        DatasetError: It cannot be read.
    """
    try:
        image: Image.Image = Image.open(path)
        with image:
            return np.array(ImageOps.exif_transpose(image).convert("RGB"), dtype=np.uint8)
    except (OSError, ValueError, Image.DecompressionBombError) as error:
        raise _unreadable(path, error) from error


def _unreadable(path: Path, error: Exception) -> DatasetError:
    return DatasetError(f"a picture cannot be read ({error}): make it again or take it and its labels away: {path}")
