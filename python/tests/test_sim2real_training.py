"""The detector of `endless_city.sim2real`, and its command from beginning to end."""

from __future__ import annotations

import importlib.util
import json
import subprocess
import sys
from pathlib import Path
from typing import Any, Optional

import numpy as np
import pytest

torch = pytest.importorskip("torch")
pytest.importorskip("torchvision")
pytest.importorskip("PIL")
pytest.importorskip("yaml")

from PIL import Image, ImageDraw  # noqa: E402

from endless_city.sim2real.__main__ import main  # noqa: E402
from endless_city.sim2real.assignment import assign  # noqa: E402
from endless_city.sim2real.augment import Sample, targets_of, training_batch  # noqa: E402
from endless_city.sim2real.box_losses import complete_iou, distribution_focal_loss, iou  # noqa: E402
from endless_city.sim2real.detector import BINS, Detector, boxes_of, cells  # noqa: E402
from endless_city.sim2real.labelled import PEDESTRIAN, TWO_WHEELER, VEHICLE, labels_of  # noqa: E402
from endless_city.sim2real.losses import detection_loss  # noqa: E402
from endless_city.sim2real.train import Progress, TrainOptions, train  # noqa: E402

CPU = torch.device("cpu")


@pytest.fixture(autouse=True)
def one_thread() -> Any:
    before = torch.get_num_threads()
    torch.set_num_threads(1)
    yield
    torch.set_num_threads(before)


def test_the_detector_has_a_cell_for_each_place() -> None:
    model = Detector()
    assert 5e6 < sum(weights.numel() for weights in model.parameters()) < 9e6
    small = Detector(0.25).eval()
    with torch.no_grad():
        distances, classes = small(torch.zeros(2, 3, 64, 96))
    centres, strides = cells(64, 96, CPU)
    count = 8 * 12 + 4 * 6 + 2 * 3
    assert distances.shape == (2, count, 4 * BINS) and classes.shape == (2, count, 3)
    assert centres.shape == (count, 2) and strides.shape == (count,)
    assert centres[0].tolist() == [4, 4] and centres[-1].tolist() == [80, 48]
    # At first there is hardly ever an object.
    assert classes.sigmoid().max() < 0.1


def test_boxes_are_so_many_strides_from_the_centre() -> None:
    centres, strides = cells(32, 32, CPU)
    logits = torch.full((1, len(centres), 4, BINS), -100.0)
    for side, distance in enumerate((0, 1, 2, 3)):
        logits[:, :, side, distance] = 100
    boxes = boxes_of(logits.flatten(2), centres, strides)
    assert boxes[0, 0].tolist() == [4, 4 - 8, 4 + 16, 4 + 24]
    assert boxes[0, -1].tolist() == [16, 16 - 32, 16 + 64, 16 + 96]


def test_losses_of_boxes() -> None:
    first = torch.tensor([[0.0, 0.0, 10.0, 10.0]])
    assert float(iou(first, torch.tensor([[5.0, 0.0, 15.0, 10.0]]))) == pytest.approx(1 / 3)
    assert float(complete_iou(first, first)) == pytest.approx(1)
    # Of boxes that do not meet, the nearer is the better.
    near, far = torch.tensor([[20.0, 0.0, 30.0, 10.0]]), torch.tensor([[80.0, 0.0, 90.0, 10.0]])
    assert float(complete_iou(first, far)) < float(complete_iou(first, near)) < 0
    logits = torch.zeros(1, 4, BINS)
    logits[:, :, 3:5] = 50
    sides = torch.full((1, 4), 3.5)
    assert float(distribution_focal_loss(logits.flatten(1), sides)) == pytest.approx(np.log(2), abs=1e-5)
    assert float(distribution_focal_loss(logits.flatten(1), sides + 4)) > 10


def test_boxes_are_learnt_by_the_cells_that_tell_them_best() -> None:
    rows = [([8, 8, 40, 40], PEDESTRIAN, False), ([50, 50, 53, 53], VEHICLE, False), ([0, 40, 20, 64], VEHICLE, True)]
    targets = targets_of([labels_of(rows), labels_of([])], CPU)
    centres, _ = cells(64, 64, CPU)
    boxes = torch.cat([centres - 12, centres + 12], 1)[None].repeat(2, 1, 1)
    scores = torch.full((2, len(centres), 3), 0.5)
    assigned = assign(scores, boxes, centres, targets)
    learnt = assigned.box[0][assigned.learns[0]]
    assert (learnt == 0).sum() == 10 and (learnt == 1).sum() >= 1 and (learnt == 2).sum() == 0
    assert not assigned.learns[1].any()
    inside = ((centres > 8) & (centres < 40)).all(1)
    assert inside[assigned.learns[0] & (assigned.box[0] == 0)].all()
    best = assigned.quality[0].max()
    assert float(best) == pytest.approx(float(iou(boxes[0], targets.boxes[0, :1]).max()))


def test_what_is_ignored_teaches_nothing() -> None:
    centres, strides = cells(64, 64, CPU)
    distances = torch.zeros(1, len(centres), 4 * BINS)
    sure = torch.full((1, len(centres), 3), -20.0)
    sure[..., VEHICLE] = 20

    def loss(rows: list[Any]) -> float:
        return float(detection_loss(distances, sure, centres, strides, targets_of([labels_of(rows)], CPU)))

    assert loss([]) > 100
    assert loss([([0, 0, 64, 64], VEHICLE, True)]) == pytest.approx(0, abs=1e-3)
    # That of another class does not help.
    assert loss([([0, 0, 64, 64], PEDESTRIAN, True)]) == loss([])


def square(left: int, top: int, side: int) -> Sample:
    pixels = torch.zeros(3, 96, 128, dtype=torch.uint8)
    pixels[:, top : top + side, left : left + side] = 255
    labels = labels_of([([left, top, left + side, top + side], VEHICLE, False)])
    return Sample(pixels, labels, [TWO_WHEELER])


@pytest.mark.parametrize("mosaics", [0.0, 1.0])
def test_boxes_stay_on_their_objects(mosaics: float) -> None:
    random = np.random.default_rng(0)
    samples = [square(40, 30, 24), square(10, 10, 40)]
    pixels, targets = training_batch(samples, random, count=12, size=96, mosaics=mosaics, device=CPU)
    assert pixels.shape == (12, 3, 96, 96) and 0 <= float(pixels.min()) and float(pixels.max()) <= 255
    checked = 0
    for picture, boxes, wanted in zip(pixels, targets.boxes, targets.wanted):
        light = picture.mean(0)
        for left, top, right, bottom in boxes[wanted].round().int().tolist():
            if right - left > 8 and bottom - top > 8:
                inside = light[top + 3 : bottom - 3, left + 3 : right - 3].mean()
                above, below = light[max(top - 4, 0) : max(top - 2, 0), left:right], light[bottom + 2 : bottom + 4, left:right]
                border = torch.cat([above.flatten(), below.flatten()])
                checked += 1
                assert not len(border) or inside > border.mean()
    assert checked > 8
    # Of two-wheelers nothing is known anywhere, nor of what is cut to pieces.
    unknown = targets.ignored & (targets.classes == TWO_WHEELER)
    assert (unknown.sum(1) == (4 if mosaics else 1)).all()


def test_a_seed_gives_the_same_detector() -> None:
    samples = [square(40, 30, 24), square(10, 10, 40)]
    options = TrainOptions(iterations=2, batch=2, size=64, width=0.1, device=CPU)
    told: list[Progress] = []
    state = torch.random.get_rng_state()
    first, again, other = (train(samples, options, seed, told.append).state_dict() for seed in (1, 1, 2))
    assert all(torch.equal(first[name], again[name]) for name in first)
    assert not all(torch.equal(first[name], other[name]) for name in first)
    assert told[-1].iteration == 2 and told[-1].seconds_left == 0
    # Chance elsewhere is left alone.
    assert torch.equal(state, torch.random.get_rng_state()) and not torch.are_deterministic_algorithms_enabled()


def toy(folder: Path, pictures: int, seed: int, names: str = "names: [car]\n") -> str:
    """Bright rectangles on a dark ground, in YOLO's format."""
    random = np.random.default_rng(seed)
    (folder / "images").mkdir(parents=True)
    (folder / "labels").mkdir()
    for number in range(pictures):
        picture = Image.fromarray(random.integers(40, 90, (96, 96, 3)).astype(np.uint8))
        width, height = random.integers(28, 44, 2)
        left, top = random.integers(0, 96 - width), random.integers(0, 96 - height)
        corners = (int(left), int(top), int(left + width - 1), int(top + height - 1))
        ImageDraw.Draw(picture).rectangle(corners, fill=(230, 60, 40))
        name = f"{folder.name}{number % 4}_{number}"
        picture.save(folder / "images" / f"{name}.png")
        box = (left + width / 2, top + height / 2, width, height)
        (folder / "labels" / f"{name}.txt").write_text(" ".join(["0", *(f"{value / 96:.6f}" for value in box)]) + "\n")
    (folder / "data.yaml").write_text(names)
    return str(folder)


SMALL = ["--size", "96", "--test-size", "96", "--width", "0.25", "--seeds", "0", "--device", "cpu"]


def test_a_detector_that_learns_beats_chance(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    learnt, tested = toy(tmp_path / "learnt", 24, 0), toy(tmp_path / "tested", 16, 1)
    arguments = ["--train", f"toy={learnt}", "--test", tested, "--camera-regex", r"(\w+)_\d+\.png"]
    assert main([*arguments, "--iterations", "150", "--batch", "8", *SMALL, "--out", str(tmp_path / "report")]) == 0
    report = json.loads((tmp_path / "report" / "report.json").read_text())
    (result,) = report["scores"]
    assert [result[key] for key in ("run", "test", "images", "cameras", "drawn")] == ["toy", "tested", 16, 4, "cameras"]
    (vehicle,) = result["classes"]
    # Without learning it is 0; of three seeds the least had 0.33.
    assert vehicle["ap50"]["mean"] > 0.15
    assert vehicle["ap50"]["low"] <= vehicle["ap50"]["mean"] <= vehicle["ap50"]["high"]
    assert sum(row["boxes"] for row in result["sizes"]) == vehicle["boxes"] == 16
    assert any("4 cameras are few" in warning for warning in report["warnings"])
    printed = capsys.readouterr()
    assert "AP50:95" in printed.out and "150/150 iterations" in printed.err
    page = (tmp_path / "report" / "report.md").read_text()
    assert f"{vehicle['ap50']['mean']:.3f}" in printed.out and f"{vehicle['ap50']['mean']:.3f}" in page
    with Image.open(tmp_path / "report" / "misses.png") as sheet:
        assert sheet.size[0] > 1000


def test_runs_of_synthetic_real_and_both(out: Path, tmp_path: Path) -> None:
    real, other = toy(tmp_path / "real", 4, 0), toy(tmp_path / "other", 4, 1)
    arguments = [str(out), "--train", f"real={real}", "--train", f"both={out},{real}", "--test", f"own={real}", "--test", other]
    quick = ["--iterations", "2", "--batch", "2", "--size", "32", "--width", "0.1", "--seeds", "0,1", "--device", "cpu"]
    assert main([*arguments, *quick, "--out", str(tmp_path / "report")]) == 0
    report = json.loads((tmp_path / "report" / "report.json").read_text())
    # Who learns from a set is not tested on it.
    assert [(row["run"], row["test"]) for row in report["scores"]] == [
        ("synthetic", "own"),
        ("synthetic", "other"),
        ("real", "other"),
        ("both", "other"),
    ]
    assert all(len(row["mean_ap50"]["seeds"]) == 2 for row in report["scores"])
    assert any("real is not tested on own" in warning for warning in report["warnings"])
    assert [len(one["boxes"]) for one in report["sets"]] == [3, 1, 1]


def failing(arguments: list[str], capsys: pytest.CaptureFixture[str], code: int) -> str:
    assert main(arguments) == code
    told = capsys.readouterr()
    assert not told.out and "Traceback" not in told.err
    return told.err.splitlines()[-1]


def test_exit_codes(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    good = toy(tmp_path / "good", 2, 0)
    dogs = toy(tmp_path / "dogs", 2, 0, "names: [dog]\n")
    people = toy(tmp_path / "people", 2, 0, "names: [person]\n")
    empty = tmp_path / "empty"
    empty.mkdir()
    out = ["--out", str(tmp_path / "report")]
    assert "no such file or folder" in failing(["nowhere", "--test", good, *out], capsys, 1)
    assert "no folder in YOLO's format" in failing(["--train", f"a={empty}", "--test", good, *out], capsys, 1)
    assert "--map NAME=CLASS" in failing(["--train", f"a={good}", "--test", dogs, *out], capsys, 1)
    assert "a learns" not in failing(["--train", f"a={good}", "--test", good, *out], capsys, 1)
    assert "learns vehicle, and people labels pedestrian" in failing(["--train", f"a={good}", "--test", people, *out], capsys, 1)
    assert "no box of pedestrian" in failing(["--train", f"a={good}", "--test", good, "--classes", "pedestrian", *out], capsys, 1)
    assert "nothing to learn from" in failing(["--test", good, *out], capsys, 2)
    (tmp_path / "file").write_text("")
    assert "--out cannot be" in failing(["--train", f"a={good}", "--test", good, "--out", str(tmp_path / "file")], capsys, 2)
    if not torch.cuda.is_available():
        assert "finds no GPU" in failing(["--train", f"a={good}", "--test", people, "--device", "cuda", *out], capsys, 2)
    for wrong in (["--iterations", "0"], ["--batch", "some"], ["--width", "wide"], ["--device", "tpu"]):
        with pytest.raises(SystemExit) as stopped:
            main([*wrong, "--test", good])
        assert stopped.value.code == 2


@pytest.mark.parametrize(
    ("library", "extra"), [("torch", "torch"), ("torchvision", "torch"), ("PIL", "sim2real"), ("yaml", "sim2real")]
)
def test_missing_libraries_are_named(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str], library: str, extra: str
) -> None:
    find = importlib.util.find_spec

    def without(name: str, package: Optional[str] = None) -> Any:
        return None if name == library else find(name, package)

    monkeypatch.setattr(importlib.util, "find_spec", without)
    assert f"pip install endless-city[{extra}]" in failing(["out", "--test", "real"], capsys, 2)


def test_the_module_is_a_command() -> None:
    run = subprocess.run([sys.executable, "-m", "endless_city.sim2real", "--help"], capture_output=True, text=True, timeout=120)
    assert run.returncode == 0 and "--camera-regex" in run.stdout
