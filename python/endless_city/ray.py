"""Datasets and training data made by a Ray cluster (``pip install "endless-city[ray]"``).

A recipe is cut into shards, which share no work: a task of Ray makes each, on whatever machine there is room. What comes out
does not depend on how many shards, tasks or machines there are, nor on how often a task is begun again.
"""

from __future__ import annotations

import json
import os
import time
from typing import TYPE_CHECKING, Any, Dict, Iterator, Mapping, Optional, Union

import numpy as np

import endless_city
from endless_city import CameraFrame
from endless_city.errors import DatasetError

try:
    import ray
except ImportError as error:
    raise ImportError('endless_city.ray needs Ray: pip install "ray[data]"') from error

if TYPE_CHECKING:
    import ray.data

__all__ = ["dataset", "generate"]

Recipe = Union[str, "os.PathLike[str]", Mapping[str, Any]]

# Seconds after which a shard is begun again whose folder a lost task still holds.
_PATIENCE = 2.0


def generate(
    recipe: Recipe,
    out: Union[str, "os.PathLike[str]"],
    *,
    shards: Optional[int] = None,
    cpus: int = 1,
    retries: int = 8,
    progress: bool = True,
) -> None:
    """Makes the dataset of a recipe in a folder that all machines of the cluster share, or in an object store.

    Ends when every video is complete. What is there already is not made again. A task whose machine is lost is begun again
    elsewhere and goes on where it was. Ctrl-C cancels all tasks; the same call resumes them.

    Args:
        recipe: Options of the recipe, as of :func:`endless_city.generate`, or a TOML file that all machines can read.
        out: The folder, or ``s3://``, ``gs://``, ``az://``.
        shards: Number of tasks; where it is not given, two for each that can run at once, and at most one a video.
        cpus: Cores, and threads, of each task.
        retries: How often a task is begun again.
        progress: Print a line for each shard that is complete.

    Raises:
        endless_city.errors.RecipeError: The recipe cannot be.
        endless_city.errors.DatasetError: The folder cannot be used.
        ray.exceptions.RayError: A task was lost more often than ``retries``.
    """
    _connect()
    place = os.fspath(out)
    if "://" not in place:
        place = os.path.abspath(place)
    options = _options(recipe)
    count = shards or _usual_shards(options, cpus)
    task = ray.remote(num_cpus=cpus, max_retries=retries, retry_exceptions=[DatasetError])(_make_shard)
    waiting = {}
    for number in range(1, count + 1):
        named = task.options(name=f"endless shard {number} of {count}")
        waiting[named.remote(options, place, number, count, cpus)] = number
    begin = time.monotonic()
    try:
        while waiting:
            done, _ = ray.wait(list(waiting), num_returns=1)
            for task_done in done:
                ray.get(task_done)
                number = waiting.pop(task_done)
                if progress:
                    complete = count - len(waiting)
                    seconds = time.monotonic() - begin
                    print(f"shard {number} is complete: {complete} of {count} in {seconds:.1f} s", flush=True)
    except ray.exceptions.RayTaskError as failure:
        raise failure.cause from None
    finally:
        # Nothing is lost with a process that is killed.
        for task_waiting in waiting:
            ray.cancel(task_waiting, force=True)


def dataset(recipe: Recipe, *, shards: Optional[int] = None, cpus: int = 1) -> "ray.data.Dataset":
    """Frames of a recipe as a dataset of Ray, made while it is read: nothing is written.

    A row is a frame of one camera: ``video``, ``camera``, ``frame``, ``time_s``; the arrays of its layers by their names, as
    :class:`endless_city.CameraFrame` has them; of its N objects ``ids`` (N,), ``labels`` (N,), which are places in
    ``endless_city.classes()``, ``boxes`` (N, 4), x, y, width and height in pixels; and ``objects``, the line of ``objects.jsonl``
    with all that is known of them.
    Rows come in no order unless ``ray.data.DataContext`` preserves it; those of a shard come in the order of its frames.

    Args:
        recipe: Options of the recipe, as of :func:`endless_city.stream`, or a TOML file that all machines can read.
        shards: Number of read tasks; where it is not given, two for each that can run at once, and at most one a video.
        cpus: Cores, and threads, of each task.
    """
    import ray.data

    _connect()
    options = _options(recipe)
    count = shards or _usual_shards(options, cpus)

    def frames(batch: Dict[str, np.ndarray]) -> Iterator[Dict[str, Any]]:
        for number in batch["id"]:
            yield from _rows(options, int(number) + 1, count, cpus)

    return ray.data.range(count, override_num_blocks=count).map_batches(frames, batch_size=1, num_cpus=cpus)


def _rows(options: Dict[str, Any], number: int, count: int, cpus: int) -> Iterator[Dict[str, Any]]:
    """The frames of a shard, as batches of one row."""
    with endless_city.stream(shard=(number, count), threads=cpus, **options) as frames:
        for frame in frames:
            of_rig = [sensor.measurement for sensor in frame.sensors]
            for view in [*frame.cameras, *of_rig]:
                if isinstance(view, CameraFrame):
                    yield {name: _batch_of_one(value) for name, value in _row(view).items()}


def _row(view: CameraFrame) -> Dict[str, Any]:
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


def _batch_of_one(value: Any) -> np.ndarray:
    if not isinstance(value, np.ndarray):
        return np.array([value])
    # Objects of a frame are more or fewer than those of the next.
    batch = np.empty(1, dtype=object)
    batch[0] = value
    return batch


def _connect() -> None:
    if not ray.is_initialized():
        ray.init()


def _options(recipe: Recipe) -> Dict[str, Any]:
    if isinstance(recipe, (str, os.PathLike)):
        return {"config": os.path.abspath(recipe)}
    return dict(recipe)


def _usual_shards(options: Dict[str, Any], cpus: int) -> int:
    at_once = int(ray.cluster_resources().get("CPU", 1)) // cpus
    return max(1, min(2 * at_once, int(options.get("videos", 2 * at_once))))


def _make_shard(options: Dict[str, Any], out: str, number: int, count: int, cpus: int) -> None:
    try:
        endless_city.generate(out, threads=cpus, shard=(number, count), progress=False, **options)
    except DatasetError:
        # A task that was lost may still hold the folder.
        time.sleep(_PATIENCE)
        raise
