"""PyTorch: datasets of frames on the disk and of frames while they are made, with targets as torchvision's detectors want them.

    from torch.utils.data import DataLoader
    from endless_city.torch import FrameDataset, collate_detection

    loader = DataLoader(FrameDataset("out"), batch_size=4, num_workers=2, collate_fn=collate_detection)
    for images, targets in loader:
        losses = model(images, targets)

Needs `torch` and `torchvision`: `pip install endless-city[torch]`.
"""

# torchvision has no types.
# mypy: disable-error-code="import-untyped"
# pyright: reportMissingTypeStubs=false

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import Any, Callable, Optional, Union, cast

import torch
import torch.distributed
from torch.utils import data
from torchvision import tv_tensors

from endless_city import _native
from endless_city._dataset import Dataset
from endless_city._frame import CameraFrame
from endless_city._recipe import PathLike, flags, recipe_json
from endless_city._stream import stream
from endless_city.errors import RecipeError

__all__ = ["FrameDataset", "Sample", "StreamDataset", "collate_detection", "detection_target", "image_tensor"]

Sample = tuple[Any, dict[str, Any]]
"""A picture and its target."""

_Transforms = Callable[..., Any]

_OF_STREAM = ("config", "buffer", "order", "cache", "memory")
"""Arguments of `stream` that are no options of a recipe."""


def _tensor(array: Any) -> torch.Tensor:
    """NumPy's array as a tensor, of the same memory."""
    tensor: torch.Tensor = cast(Any, torch).from_numpy(array)
    return tensor


def image_tensor(frame: CameraFrame) -> tv_tensors.Image:
    """The picture: `tv_tensors.Image`, uint8, (3, H, W), sRGB."""
    return tv_tensors.Image(_tensor(frame.rgb).permute(2, 0, 1))


def detection_target(
    frame: CameraFrame, *, image_id: int = 0, masks: bool = False, min_visibility: float = 0.0
) -> dict[str, Any]:
    """The N objects of a frame as torchvision's detectors and transforms (v2) want them.

    - `boxes`: `tv_tensors.BoundingBoxes`, float32, (N, 4): left, top, right, bottom, pixels;
    - `labels`: int64, (N,): class ids plus 1, as 0 is the background;
    - `area`: float32, (N,): visible pixels; `iscrowd`: int64, (N,): 0;
    - `image_id`: int64, (): as given;
    - `masks`, if asked for: `tv_tensors.Mask`, bool, (N, H, W): visible pixels.

    Args:
        frame: A frame of one camera.
        image_id: A number of your own.
        masks: Whether to add masks; needs the layer `instance`.
        min_visibility: Leave out objects of which a smaller share can be seen, 0 to 1.
    """
    objects = frame.objects
    # What has no visibility is all there.
    seen = ~(objects.visibility < min_visibility)
    width, height = frame.size
    target: dict[str, Any] = {
        "boxes": cast(Any, tv_tensors.BoundingBoxes)(
            _tensor(objects.boxes_xyxy[seen]), format="XYXY", canvas_size=(height, width)
        ),
        "labels": _tensor(objects.class_ids[seen] + 1),
        "image_id": torch.tensor(image_id),
        "area": _tensor(objects.pixels[seen]).to(torch.float32),
        "iscrowd": torch.zeros(int(seen.sum()), dtype=torch.int64),
    }
    if masks:
        ids = _tensor(objects.ids[seen])
        target["masks"] = tv_tensors.Mask(_tensor(frame.instance)[None] == ids[:, None, None])
    return target


def collate_detection(batch: Iterable[Sample]) -> tuple[list[Any], list[dict[str, Any]]]:
    """A list of pictures and a list of targets: what torchvision's detectors take; numbers of objects differ."""
    pairs = list(batch)
    return [image for image, _ in pairs], [target for _, target in pairs]


class FrameDataset(data.Dataset[Sample]):
    """Frames on the disk, a picture and a target each; map-style: any sampler works, `DistributedSampler`, too."""

    def __init__(
        self,
        dataset: Union[str, os.PathLike[str], Dataset],
        *,
        transforms: Optional[_Transforms] = None,
        masks: bool = False,
        min_visibility: float = 0.0,
    ) -> None:
        """Of a dataset.

        Args:
            dataset: Its folder, or a `Dataset` with the cameras and videos that you choose.
            transforms: Takes a picture and a target and gives both: torchvision's v2 transforms, for example.
            masks: Whether targets have masks.
            min_visibility: Leave out objects of which a smaller share can be seen, 0 to 1.
        """
        self.dataset = dataset if isinstance(dataset, Dataset) else Dataset(dataset)
        self.transforms = transforms
        self.masks = masks
        self.min_visibility = min_visibility

    def __len__(self) -> int:
        return len(self.dataset)

    def __getitem__(self, index: int) -> Sample:
        frame = self.dataset[index]
        if self.masks:
            frame.load(["rgb", "instance"])
        return _sample(frame, index % max(len(self), 1), self.transforms, self.masks, self.min_visibility)


class StreamDataset(data.IterableDataset[Sample]):
    """Frames while they are made, a picture and a target each, frame by frame and camera by camera.

    Each worker of a `DataLoader`, in each process of `torch.distributed`, makes a part of the videos of its own: ask for at least
    as many videos as there are workers in all.
    """

    def __init__(
        self,
        *,
        transforms: Optional[_Transforms] = None,
        masks: bool = False,
        min_visibility: float = 0.0,
        config: Optional[PathLike] = None,
        threads: Optional[int] = None,
        buffer: int = 4,
        order: str = "map",
        even: Optional[bool] = None,
        seed: int = 0,
        **recipe: Any,
    ) -> None:
        """Of a recipe.

        Args:
            transforms: Takes a picture and a target and gives both.
            masks: Whether targets have masks.
            min_visibility: Leave out objects of which a smaller share can be seen, 0 to 1.
            config: A recipe in a TOML file; options that are given here win over it.
            threads: How many threads each worker has; its share of all cores by default.
            buffer: How many frames may wait.
            order: As in `endless_city.stream`.
            even: Whether each worker ends after as many frames as the one with the fewest has, so that processes that wait for one
                another at each step, as DistributedDataParallel does, have as many. By default where there are
                several processes of `torch.distributed`.
            seed: Seed of the first epoch.
            **recipe: Options of the recipe, as in `endless_city.generate`.
        """
        self.transforms = transforms
        self.masks = masks
        self.min_visibility = min_visibility
        self.threads = threads
        self.even = even
        self.seed = seed
        self.epoch = 0
        self._rank = (0, 1)
        self._options: dict[str, Any] = {"config": config, "buffer": buffer, "order": order, **recipe}

    def set_epoch(self, epoch: int) -> None:
        """Other videos from now on: those of the seed plus `epoch`. Call it before each epoch, before workers start."""
        self.epoch = epoch

    def __getstate__(self) -> dict[str, Any]:
        # A worker that is no fork does not know of which process it is one.
        return {**self.__dict__, "_rank": _rank_now() or self._rank}

    def __iter__(self) -> Iterator[Sample]:
        worker = data.get_worker_info()
        place, workers = (0, 1) if worker is None else (worker.id, worker.num_workers)
        rank, processes = _rank_now() or self._rank
        part, parts = rank * workers + place, processes * workers
        even = processes > 1 if self.even is None else self.even
        threads = self.threads or max((os.cpu_count() or 1) // workers, 1)
        samples = self._samples((part + 1, parts), threads)
        return islice(samples, self._least(parts)) if even else samples

    def _samples(self, shard: tuple[int, int], threads: int) -> Iterator[Sample]:
        with stream(shard=shard, threads=threads, seed=self.seed + self.epoch, **self._options) as frames:
            for frame in frames:
                for camera, view in enumerate(frame.cameras):
                    image_id = frame.index * len(frame.cameras) + camera
                    yield _sample(view, image_id, self.transforms, self.masks, self.min_visibility)

    def _least(self, parts: int) -> int:
        """Frames of the part with the fewest."""
        recipe = {key: value for key, value in self._options.items() if key not in _OF_STREAM}
        recipe_text = recipe_json({**recipe, "seed": self.seed + self.epoch})
        frames = _native.camera_frames_of_shards(recipe_text, flags(config=self._options["config"]), parts)
        if not min(frames):
            having = sum(1 for count in frames if count)
            raise RecipeError(
                f"{parts} workers in all need a part of the videos each, and {having} of them have one: ask for more videos, "
                "for fewer workers, or for even=False"
            )
        return min(frames)


def _rank_now() -> Optional[tuple[int, int]]:
    """The number of this process in `torch.distributed`, and how many there are."""
    if torch.distributed.is_available() and torch.distributed.is_initialized():
        return torch.distributed.get_rank(), torch.distributed.get_world_size()
    return None


def _sample(
    frame: CameraFrame, image_id: int, transforms: Optional[_Transforms], masks: bool, min_visibility: float
) -> Sample:
    image = image_tensor(frame)
    target = detection_target(frame, image_id=image_id, masks=masks, min_visibility=min_visibility)
    return (image, target) if transforms is None else transforms(image, target)
