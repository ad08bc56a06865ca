"""Datasets and training data made by a Ray cluster.

A recipe is cut into shards, and a task of Ray makes each, on whatever machine there is room. What comes out does not depend on
how many shards, tasks or machines there are, nor on how often a task is begun again. `endless-city` must be installed on each
machine: `pip install "endless-city[ray]"`.
"""

from __future__ import annotations

import importlib
import os
import time
from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np

import endless_city
from endless_city import CameraFrame
from endless_city.errors import DatasetError

try:
    # What it says of its types differs from version to version.
    ray: Any = importlib.import_module("ray")
except ImportError as error:
    raise ImportError('endless_city.ray needs Ray: pip install "ray[data]"') from error

if TYPE_CHECKING:
    from numpy.typing import NDArray
    from ray.data import Dataset as RayDataset  # type: ignore[import-not-found, unused-ignore]

__all__ = ["dataset", "generate"]

Recipe = Union[str, "os.PathLike[str]", Mapping[str, Any]]

# Seconds after which a shard is begun again that a lost task still holds.
_PATIENCE = 2.0


def generate(
    recipe: Recipe,
    out: Union[str, os.PathLike[str]],
    *,
    shards: Optional[int] = None,
    cpus: int = 1,
    retries: int = 8,
    progress: bool = True,
) -> None:
    """Makes the dataset of a recipe in a folder that all machines share, or resumes it.

    Ends when every video is complete. A task whose machine is lost is begun again elsewhere and goes on where it was. Ctrl-C
    cancels all tasks; the same call goes on.

        generate({"videos": 100, "size": "640x360"}, "/shared/out")

    Args:
        recipe: Options of the recipe, as of `endless_city.generate`, or a TOML file that all machines can read.
        out: The folder, or an object store that the package can write (`s3://`, `gs://`, `az://`).
        shards: Number of tasks; two for each that can run at once by default, and at most one a video.
        cpus: Cores of each task, and its threads.
        retries: How often a task is begun again.
        progress: Whether to print a line for each shard that is complete.

    Raises:
        RecipeError: The recipe cannot be made.
        DatasetError: The folder cannot be used.
        SimulationError: The simulation failed.
        ray.exceptions.RayError: A task was lost more often than `retries`.
    """
    _connect()
    place = os.fspath(out)
    if "://" not in place:
        place = os.path.abspath(place)
    options = _options(recipe)
    count = shards or _usual_shards(options, cpus)
    task = ray.remote(num_cpus=cpus, max_retries=retries, retry_exceptions=[DatasetError])(_make_shard)
    waiting: dict[Any, int] = {}
    for number in range(1, count + 1):
        named = task.options(name=f"endless shard {number} of {count}")
        waiting[named.remote(options, place, number, count, cpus)] = number
    begin = time.monotonic()
    try:
        while waiting:
            done, _ = ray.wait(list(waiting), num_returns=1)
            for reference in done:
                ray.get(reference)
                number = waiting.pop(reference)
                if progress:
                    seconds = time.monotonic() - begin
                    print(f"shard {number} is complete: {count - len(waiting)} of {count} in {seconds:.1f} s", flush=True)
    except ray.exceptions.RayTaskError as failure:
        raise failure.cause from None
    finally:
        # Nothing is lost with a process that is killed.
        for reference in waiting:
            ray.cancel(reference, force=True)


def dataset(recipe: Recipe, *, shards: Optional[int] = None, cpus: int = 1) -> RayDataset:
    """The frames of a recipe as a dataset of Ray, made while it is read; nothing is written.

    A row is a frame of one camera: `video`, `camera`, `frame`, `time_s`; the arrays of its layers by their names, as
    `endless_city.CameraFrame` has them; of its N objects `ids` int32 (N,), `labels` int64 (N,), which are places in
    `endless_city.classes()`, `boxes` float32 (N, 4), x, y, width and height in pixels; and `objects`, the line of `objects.jsonl`
    with all that is known of them. Rows of a shard come in the order of its frames; shards come as they are made, unless
    `ray.data.DataContext` preserves their order.

        for batch in dataset({"videos": 100}).iter_torch_batches(batch_size=8):
            ...

    Args:
        recipe: Options of the recipe, as of `endless_city.stream`, or a TOML file that all machines can read.
        shards: Number of tasks that read; two for each that can run at once by default, and at most one a video.
        cpus: Cores of each task, and its threads.

    Raises:
        RecipeError: The recipe cannot be made; raised, in Ray's own exception, when it is read.
    """
    data: Any = importlib.import_module("ray.data")
    _connect()
    options = _options(recipe)
    count = shards or _usual_shards(options, cpus)

    def frames(batch: dict[str, NDArray[Any]]) -> Iterator[dict[str, NDArray[Any]]]:
        for number in batch["id"]:
            yield from _rows(options, int(number) + 1, count, cpus)

    made: RayDataset = data.range(count, override_num_blocks=count).map_batches(frames, batch_size=1, num_cpus=cpus)
    return made


def _connect() -> None:
    if not ray.is_initialized():
        ray.init()


def _options(recipe: Recipe) -> dict[str, Any]:
    if isinstance(recipe, (str, os.PathLike)):
        return {"config": os.path.abspath(recipe)}
    return dict(recipe)


def _usual_shards(options: dict[str, Any], cpus: int) -> int:
    at_once = int(ray.cluster_resources().get("CPU", 1)) // cpus
    return max(1, min(2 * at_once, int(options.get("videos", 2 * at_once))))


def _make_shard(options: dict[str, Any], out: str, number: int, count: int, cpus: int) -> None:
    try:
        endless_city.generate(out, threads=cpus, shard=(number, count), progress=False, **options)
    except DatasetError:
        # A task that was lost may hold the shard until its process has ended.
        time.sleep(_PATIENCE)
        raise


def _rows(options: dict[str, Any], number: int, count: int, cpus: int) -> Iterator[dict[str, NDArray[Any]]]:
    """The frames of a shard, as batches of one row."""
    with endless_city.stream(shard=(number, count), threads=cpus, **options) as frames:
        for frame in frames:
            of_rig = [sensor.measurement for sensor in frame.sensors]
            for view in [*frame.cameras, *of_rig]:
                if isinstance(view, CameraFrame):
                    yield {name: _batch_of_one(value) for name, value in _row(view).items()}


def _row(view: CameraFrame) -> dict[str, Any]:
    objects = view.objects
    return {
        "video": view.video,
        "camera": view.camera.name,
        "frame": view.frame,
        "time_s": view.time_s,
        **view.load(),
        "ids": objects.ids,
        "labels": objects.class_ids,
        "boxes": objects.boxes,
        "objects": objects.line.decode(),
    }


def _batch_of_one(value: Any) -> NDArray[Any]:
    if not isinstance(value, np.ndarray):
        return np.array([value])
    # A frame has more or fewer objects than the next.
    batch = np.empty(1, dtype=object)
    batch[0] = value
    return batch
