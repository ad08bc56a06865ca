"""`generate`: a recipe in, a dataset out."""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import Any, Optional, Union

from endless_city import _native
from endless_city._progress import Bar
from endless_city._recipe import PathLike, flags, recipe_json


@dataclass(frozen=True)
class Generated:
    """What a call of `generate` made; nothing where the dataset was complete."""

    videos: int
    """Videos that were recorded or completed."""
    camera_frames: int
    """Frames of all their cameras, and measurements of other sensors."""
    bytes: int
    """Bytes of all their files."""
    seconds: float
    """Wall time, seconds."""


def generate(
    out: PathLike,
    *,
    config: Optional[PathLike] = None,
    threads: Optional[int] = None,
    shard: Optional[tuple[int, int]] = None,
    progress: bool = True,
    allow_other_build: bool = False,
    cache: Optional[PathLike] = None,
    memory: Optional[Union[int, str]] = None,
    **recipe: Any,
) -> Generated:
    """Makes the dataset of a recipe in the folder `out`, or resumes it: the same as `endless generate`.

    The bytes depend on the recipe alone, not on threads, cache or memory. Ctrl-C raises `KeyboardInterrupt` at once; what
    is complete stays, and the same call goes on.

        generate("out", videos=2, maps=["Town03"], size=(640, 360), fps=10, duration=1.0)

    Args:
        out: Folder of the dataset; it is created if it does not exist.
        config: A recipe in a TOML file; options that are given here win over it.
        threads: How many threads work; all cores by default.
        shard: `(I, N)`: make the part I of N alone, I from 1 to N.
        progress: Whether to show a bar on stderr.
        allow_other_build: Resume what another build of endless began.
        cache: Folder that keeps what bakes of the same camera share, for later runs.
        memory: Most memory for that, bytes or as in "4GiB"; 1 GiB by default.
        **recipe: Options of the recipe by the keys of TOML recipes; `endless_city.options()` lists them. A list of one
            word may be that word, and a size a pair of numbers (width, height), pixels.

    Raises:
        RecipeError: The recipe cannot be made; the message says what can.
        DatasetError: The folder holds something else, another build began it, or the disk is full.
        SimulationError: The simulation failed.
    """
    told = flags(
        config=config, threads=threads, shard=shard, allow_other_build=allow_other_build, cache=cache, memory=memory
    )
    bar = Bar() if progress else None
    try:
        made = _native.generate(os.fspath(out), recipe_json(recipe), told, bar.update if bar else None)
    finally:
        if bar:
            bar.close()
    return Generated(*made)
