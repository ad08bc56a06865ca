"""Parts of datasets: train, val, test."""

from __future__ import annotations

import re
from collections.abc import Sequence
from typing import Optional, TypeVar

from endless_city.errors import DatasetError

SPLITS = ("train", "val", "test")

_NAMED = re.compile(r"(?<![a-z])(train|training|val|valid|validation|test|testing)(?![a-z])")

Item = TypeVar("Item")


def split_named(path: str) -> Optional[str]:
    """The part that a path names, such as `images/train/7.jpg` and `instances_val2017.json`; None if it names none."""
    for word in _NAMED.findall(path.lower()):
        return next(split for split in SPLITS if word.startswith(split))
    return None


def chosen(items: Sequence[tuple[str, Item]], split: Optional[str], path: str) -> list[Item]:
    """Those of a part, or all.

    Raises:
        DatasetError: There is no such part.
    """
    if split is None:
        return [item for _, item in items]
    kept = [item for part, item in items if part == split]
    if not kept:
        parts = sorted({part for part, _ in items if part})
        known = f"use one of {', '.join(parts)}" if parts else "it has no parts"
        raise DatasetError(f"there is no part {split!r}: {known}: {path}")
    return kept
