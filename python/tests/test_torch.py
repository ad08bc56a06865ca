"""PyTorch's datasets and torchvision's targets."""

from __future__ import annotations

import multiprocessing
from datetime import timedelta
from pathlib import Path
from typing import Any

import pytest

torch = pytest.importorskip("torch")
pytest.importorskip("torchvision")

from torch.utils.data import DataLoader  # noqa: E402
from torchvision import tv_tensors  # noqa: E402
from torchvision.transforms import v2  # noqa: E402

from conftest import RECIPE  # noqa: E402
from endless_city import Dataset, RecipeError  # noqa: E402
from endless_city.torch import FrameDataset, StreamDataset, collate_detection, detection_target  # noqa: E402

STREAMED = {**RECIPE, "layers": ["rgb", "instance"]}


def test_targets_are_those_of_torchvision(out: Path) -> None:
    for index, frame in enumerate(Dataset(out)):
        target = detection_target(frame, image_id=index, masks=True)
        count = len(frame.objects)
        assert isinstance(target["boxes"], tv_tensors.BoundingBoxes) and target["boxes"].shape == (count, 4)
        assert target["boxes"].canvas_size == (91, 161)
        assert target["labels"].dtype == torch.int64 and (target["labels"] >= 1).all()
        assert target["masks"].shape == (count, 91, 161)
        assert (target["masks"].sum((1, 2)) == target["area"]).all()
        assert int(target["image_id"]) == index and not target["iscrowd"].any()
        some = detection_target(frame, min_visibility=0.9)
        assert len(some["labels"]) == int((frame.objects.visibility >= 0.9).sum())


@pytest.mark.parametrize("workers", [0, 2])
def test_frames_go_through_a_loader_and_transforms(out: Path, workers: int) -> None:
    transforms = v2.Compose([v2.RandomHorizontalFlip(1.0), v2.ToDtype(torch.float32, scale=True)])
    dataset = FrameDataset(out, transforms=transforms, masks=True)
    loader = DataLoader(dataset, batch_size=3, num_workers=workers, collate_fn=collate_detection)
    batches = list(loader)
    assert sum(len(images) for images, _ in batches) == len(dataset) == 16
    image, target = batches[0][0][0], batches[0][1][0]
    frame = Dataset(out)[0]
    assert image.dtype == torch.float32 and image.shape == (3, 91, 161)
    assert torch.equal(target["boxes"][:, 0], 161 - torch.from_numpy(frame.objects.boxes_xyxy[:, 2]))


@pytest.mark.parametrize("workers", [0, 2, 3])
def test_workers_of_a_stream_share_the_videos(out: Path, workers: int) -> None:
    loader = DataLoader(StreamDataset(**STREAMED), batch_size=None, num_workers=workers)
    sums = sorted(int(image.to(torch.int64).sum()) for image, _ in loader)
    assert sums == sorted(int(frame.rgb.astype("int64").sum()) for frame in Dataset(out))


def of_rank(rank: int, processes: int, workers: int, meeting: str, told: Any) -> None:
    """A process of a training on several: tells the sums of its pictures."""
    torch.distributed.init_process_group(
        "gloo", init_method=f"file://{meeting}", rank=rank, world_size=processes, timeout=timedelta(seconds=120)
    )
    loader = DataLoader(StreamDataset(**STREAMED), batch_size=None, num_workers=workers)
    told.put((rank, [int(image.to(torch.int64).sum()) for image, _ in loader]))
    torch.distributed.barrier()
    torch.distributed.destroy_process_group()


@pytest.mark.skipif(not torch.distributed.is_available(), reason="this PyTorch is not distributed")
@pytest.mark.parametrize("workers", [0, 1])
def test_ranks_of_a_stream_share_the_videos(out: Path, tmp_path: Path, workers: int) -> None:
    context = multiprocessing.get_context("spawn")
    told = context.Queue()
    arguments = (2, workers, str(tmp_path / "meeting"), told)
    processes = [context.Process(target=of_rank, args=(rank, *arguments)) for rank in range(2)]
    for process in processes:
        process.start()
    sums = dict(told.get(timeout=300) for _ in processes)
    for process in processes:
        process.join(60)
        assert process.exitcode == 0
    videos = [[int(f.rgb.astype("int64").sum()) for f in Dataset(out, videos=[name])] for name in Dataset(out).videos]
    assert sorted(sorted(of) for of in sums.values()) == sorted(sorted(of) for of in videos)


def test_even_parts_end_with_the_shortest() -> None:
    three = {**STREAMED, "videos": 3, "size": (64, 36), "duration": 0.4}
    counts = []
    for even in (False, True):
        loader = DataLoader(StreamDataset(**three, even=even), batch_size=None, num_workers=2)
        counts.append(sum(1 for _ in loader))
    assert counts == [12, 8]
    with pytest.raises(RecipeError, match="2 workers in all .* 1 of them"):
        list(DataLoader(StreamDataset(**{**three, "videos": 1}, even=True), batch_size=None, num_workers=2))


def test_an_epoch_has_other_videos() -> None:
    dataset = StreamDataset(**{**STREAMED, "videos": 1, "duration": 0.2, "seed": 0})
    first = next(iter(dataset))[0]
    dataset.set_epoch(1)
    assert not torch.equal(first, next(iter(dataset))[0])
    dataset.set_epoch(0)
    assert torch.equal(first, next(iter(dataset))[0])
