"""Arguments of Python as the native module takes them: a JSON object and flags."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from typing import Any, Optional, Union, cast

from endless_city.errors import RecipeError

PathLike = Union[str, "os.PathLike[str]"]


def recipe_json(recipe: Mapping[str, object]) -> str:
    """The options of a recipe as a JSON object. Paths, tuples and NumPy's numbers are taken as what they stand for."""
    try:
        return json.dumps(recipe, default=_plain, allow_nan=False)
    except (TypeError, ValueError, RecursionError) as error:
        raise RecipeError(f"the recipe has a value that is no number, word or list: {error}") from None


def _plain(value: Any) -> Any:
    if isinstance(value, os.PathLike):
        return os.fspath(cast("os.PathLike[str]", value))
    # Numbers and arrays of NumPy.
    if callable(getattr(value, "tolist", None)):
        return value.tolist()
    raise TypeError(f"{type(value).__name__} {value!r}"[:200])


def flags(
    *,
    config: Optional[PathLike] = None,
    threads: Optional[int] = None,
    shard: Optional[tuple[int, int]] = None,
    allow_other_build: bool = False,
    cache: Optional[PathLike] = None,
    memory: Optional[Union[int, str]] = None,
) -> list[str]:
    """The flags of `endless generate` that say the same."""
    told: list[str] = []
    if config is not None:
        told += ["--config", _path("config", config)]
    if threads is not None:
        told.append(f"--threads={threads}")
    if shard is not None:
        told.append(f"--shard={shard_text(shard)}")
    if allow_other_build:
        told.append("--allow-other-build")
    if cache is not None:
        told += ["--cache", _path("cache", cache)]
    if memory is not None:
        told.append(f"--memory={memory}B" if isinstance(memory, int) else f"--memory={memory}")
    return told


def shard_text(shard: Any) -> str:
    """`1/8` of `(1, 8)`."""
    if isinstance(shard, (tuple, list)):
        numbers = list(cast("tuple[Any, ...]", shard))
        if len(numbers) == 2 and all(type(number) is int for number in numbers) and 1 <= numbers[0] <= numbers[1]:
            return f"{numbers[0]}/{numbers[1]}"
    raise RecipeError(f"shard cannot be {shard!r}: write (I, N), the part I of N, from (1, N) to (N, N)")


def _path(name: str, value: Any) -> str:
    if isinstance(value, (str, os.PathLike)):
        path: Any = os.fspath(cast("os.PathLike[str]", value))
        if isinstance(path, str):
            return path
    raise RecipeError(f"{name} cannot be {value!r}: give a path")
