"""PyTorch's datasets and torchvision's targets."""

from __future__ import annotations

from pathlib import Path

import pytest

torch = pytest.importorskip("torch")
pytest.importorskip("torchvision")

from torch.utils.data import DataLoader  # noqa: E402
from torchvision import tv_tensors  # noqa: E402
from torchvision.transforms import v2  # noqa: E402

from conftest import RECIPE  # noqa: E402
from endless_city import Dataset  # noqa: E402
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


def test_an_epoch_has_other_videos() -> None:
    dataset = StreamDataset(**{**STREAMED, "videos": 1, "duration": 0.2, "seed": 0})
    first = next(iter(dataset))[0]
    dataset.set_epoch(1)
    assert not torch.equal(first, next(iter(dataset))[0])
    dataset.set_epoch(0)
    assert torch.equal(first, next(iter(dataset))[0])
