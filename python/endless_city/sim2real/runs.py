"""All trainings and tests of the command."""

from __future__ import annotations

import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Optional

import torch

from endless_city import __version__
from endless_city.errors import DatasetError, EndlessError, RecipeError
from endless_city.sim2real.arguments import Options, Run
from endless_city.sim2real.average_precision import Detections
from endless_city.sim2real.detector import Detector
from endless_city.sim2real.fair import FairTest, fair_tests
from endless_city.sim2real.labelled import CLASSES, LabelledSet, restricted
from endless_city.sim2real.misses import RunOnTest
from endless_city.sim2real.predict import predict
from endless_city.sim2real.real_set import read_set
from endless_city.sim2real.report import Report, SetLine
from endless_city.sim2real.scores import RunScore, score
from endless_city.sim2real.train import Progress, TrainOptions, load_samples, train

# With fewer cameras the bootstrap itself is unsure.
_FEW_CAMERAS = 10


@dataclass(frozen=True)
class Finished:
    """What there is to tell and to draw."""

    report: Report
    tested: Sequence[RunOnTest]


def run_all(options: Options) -> Finished:
    """Reads sets, trains every run with every seed, tests and scores; tells on stderr how far it is.

    Raises:
        EndlessError: A set cannot be read, nothing is left to test on, or a training failed.
    """
    device = _device(options.device)
    tests = {name: _read(options, path, None) for name, path in options.tests}
    paths = dict.fromkeys(path for run in options.runs for path in run.sets)
    learnt = {path: _read(options, path, options.most_images) for path in paths}
    # Whatever cannot be done is told before hours of training.
    fair: dict[str, dict[str, FairTest]] = {}
    warnings = _few_cameras(tests)
    for run in options.runs:
        fair[run.name], reasons = fair_tests(run.name, [learnt[path] for path in run.sets], tests)
        warnings += reasons
    scores: list[RunScore] = []
    tested: list[RunOnTest] = []
    seconds: dict[str, float] = {}
    for run in options.runs:
        begun = time.monotonic()
        found = _train_and_test(options, run, [learnt[path] for path in run.sets], fair[run.name], device)
        seconds[run.name] = time.monotonic() - begun
        for name, part in fair[run.name].items():
            detections = [of_seed[name] for of_seed in found]
            result = score(
                run.name, name, part.images, detections, part.classes, longest=options.test_size, skipped=part.skipped
            )
            scores.append(result)
            least = {CLASSES.index(row.name): row.least_scores[0] for row in result.classes}
            tested.append(RunOnTest(run.name, name, part.images, detections[0], least))
    lines = [SetLine.of(path, one) for path, one in {**learnt, **{path: tests[name] for name, path in options.tests}}.items()]
    report = Report(_settings(options, device), lines, scores, warnings + _skipped(scores), seconds)
    return Finished(report, tested)


def _say(text: str) -> None:
    print(text, file=sys.stderr, flush=True)


def _device(name: str) -> torch.device:
    there = torch.cuda.is_available()
    if name == "cuda" and not there:
        raise RecipeError("--device cuda: PyTorch finds no GPU here: use --device cpu, or a PyTorch built for your GPU")
    return torch.device("cuda" if there and name != "cpu" else "cpu")


def _read(options: Options, path: str, most: Optional[int]) -> LabelledSet:
    found = restricted(read_set(path, options.names, options.cameras, most), options.classes)
    boxes = sum(int((~image.labels.ignored).sum()) for image in found.images)
    if not boxes:
        raise DatasetError(
            f"no box of {_listed(options.classes)} is in {len(found.images)} pictures: check labels, --map and --classes: {path}"
        )
    for note in found.notes:
        _say(f"{path}: {note}")
    _say(f"{path}: {len(found.images)} pictures, {boxes} boxes of {_listed(found.classes)}")
    return found


def _listed(classes: Sequence[int]) -> str:
    return ", ".join(CLASSES[number] for number in classes)


def _train_and_test(
    options: Options,
    run: Run,
    sets: Sequence[LabelledSet],
    fair: Mapping[str, FairTest],
    device: torch.device,
) -> list[dict[str, list[Detections]]]:
    """For each seed, detections in pictures of each test set."""
    samples = load_samples(sets, max(options.size, options.test_size), device)
    how = TrainOptions(options.iterations, options.batch, options.size, options.width, device)
    found: list[dict[str, list[Detections]]] = []
    for seed in options.seeds:
        told = _Teller(f"{run.name}, seed {seed}", options, device)
        try:
            model = train(samples, how, seed, told)
            found.append({name: predict(model, part.images, options.test_size, device) for name, part in fair.items()})
        except torch.cuda.OutOfMemoryError as error:
            raise EndlessError("the GPU has too little memory: use a smaller --batch, --size or --width") from error
    return found


class _Teller:
    """Tells how far a training is, and at first how long it takes."""

    def __init__(self, what: str, options: Options, device: torch.device) -> None:
        self._what = what
        self._options = options
        self._on_cpu = device.type == "cpu"
        self._first = True

    def __call__(self, progress: Progress) -> None:
        total = self._options.iterations
        _say(
            f"{self._what}: {progress.iteration}/{total} iterations, loss {progress.loss:.2f}, "
            f"{_duration(progress.seconds_left)} left"
        )
        if self._first and self._on_cpu and progress.seconds_left > 300:
            trainings = len(self._options.runs) * len(self._options.seeds)
            _say(
                f"each of {trainings} trainings takes about {_duration(progress.seconds_left)} on this CPU: "
                "a GPU takes minutes; --size 416, --width 0.5, --batch 16 and fewer --iterations take less, and find less"
            )
        self._first = False


def _duration(seconds: float) -> str:
    if seconds < 90:
        return f"{seconds:.0f} s"
    return f"{seconds / 60:.0f} min" if seconds < 5400 else f"{seconds / 3600:.1f} h"


def _settings(options: Options, device: torch.device) -> dict[str, Any]:
    name = torch.cuda.get_device_name(device) if device.type == "cuda" else "cpu"
    return {
        "endless_city": __version__,
        "torch": torch.__version__,
        "device": name,
        "parameters": sum(weights.numel() for weights in Detector(options.width).parameters()),
        "runs": {run.name: list(run.sets) for run in options.runs},
        "tests": dict(options.tests),
        "classes": [CLASSES[number] for number in options.classes],
        "seeds": list(options.seeds),
        "iterations": options.iterations,
        "batch": options.batch,
        "size": options.size,
        "test_size": options.test_size,
        "width": options.width,
        "max_images": options.most_images,
    }


def _few_cameras(tests: Mapping[str, LabelledSet]) -> list[str]:
    """What intervals do not tell."""
    warnings: list[str] = []
    for name, test in tests.items():
        cameras = test.cameras
        if cameras is None:
            warnings.append(f"{name}: cameras are not known, intervals are over pictures and too narrow; see --camera-regex")
        elif len(cameras) == 1:
            warnings.append(f"{name}: one camera took all; intervals are over pictures and tell nothing of other cameras")
        elif len(cameras) < _FEW_CAMERAS:
            warnings.append(f"{name}: {len(cameras)} cameras are few, other cameras may well score beyond the interval")
    return warnings


def _skipped(scores: Sequence[RunScore]) -> list[str]:
    skipped = [f"{one.run} on {one.test} ({one.skipped})" for one in scores if one.skipped]
    return [f"pictures that a run learnt from, or of their cameras, were not tested: {', '.join(skipped)}"] if skipped else []
