"""Arguments of the command."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Optional

from endless_city.errors import RecipeError
from endless_city.sim2real.class_names import NameMap, name_map
from endless_city.sim2real.labelled import CLASSES
from endless_city.sim2real.real_set import Cameras, is_synthetic

_STRIDE = 32
# Pictures of a test are larger than those of the training, in which mosaics make objects smaller.
_TEST_SCALE = 1.2

_DESCRIPTION = """\
Trains a small detector from scratch on a dataset and tests it on real pictures: average precision with intervals, tables by
class and size, a sheet of misses. A SET is a folder made by `endless generate`, a folder in YOLO's or COCO's format, or a JSON
file of COCO's; SET@train, SET@val and SET@test are parts of it.
"""


@dataclass(frozen=True)
class Run:
    """A training: its name, and the sets that it learns from."""

    name: str
    sets: tuple[str, ...]


@dataclass(frozen=True)
class Options:
    """What the command is to do; `size` and `test_size` are pixels, `classes` places in `CLASSES`."""

    runs: tuple[Run, ...]
    tests: tuple[tuple[str, str], ...]
    classes: tuple[int, ...]
    seeds: tuple[int, ...]
    iterations: int
    batch: int
    size: int
    test_size: int
    width: float
    most_images: int
    device: str
    names: NameMap
    cameras: Cameras
    out: Path


def parse(arguments: Optional[Sequence[str]]) -> Options:
    """Options of arguments, those of the process by default.

    Raises:
        RecipeError: Arguments make no sense together.
        SystemExit: They have another form; what is wrong is printed.
    """
    given = _parser().parse_intermixed_args(arguments)
    if given.size < _STRIDE:
        raise RecipeError(f"--size cannot be {given.size}: use {_STRIDE} or more")
    size = _whole(given.size)
    return Options(
        runs=_runs(given.out_sets, given.train_also, given.train),
        tests=_tests(given.test),
        classes=_classes(given.classes),
        seeds=_seeds(given.seeds),
        iterations=given.iterations,
        batch=given.batch,
        size=size,
        test_size=_whole(given.test_size or round(size * _TEST_SCALE)),
        width=given.width,
        most_images=given.max_images,
        device=given.device,
        names=name_map(given.map),
        cameras=Cameras(given.camera_regex),
        out=Path(given.out),
    )


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="python -m endless_city.sim2real", description=_DESCRIPTION)
    parser.add_argument("out_sets", nargs="*", metavar="OUT", help="datasets to learn from")
    parser.add_argument(
        "--test", action="append", required=True, metavar="[NAME=]SET", help="real pictures to test on; may be repeated"
    )
    parser.add_argument(
        "--train-also", action="append", default=[], metavar="SET", help="learn from this set, too; may be repeated"
    )
    parser.add_argument(
        "--train",
        action="append",
        default=[],
        metavar="NAME=SET[,SET...]",
        help="a training of its own, to be compared; may be repeated",
    )
    parser.add_argument("--classes", default=",".join(CLASSES), help="classes to learn and to score (default: %(default)s)")
    parser.add_argument(
        "--map",
        action="append",
        default=[],
        metavar="NAME=CLASS",
        help="what a class of real sets is: a class of --classes, rider, or ignore; may be repeated",
    )
    parser.add_argument(
        "--camera-regex",
        metavar="REGEX",
        help="finds the camera in the path of a real picture in its folder: the first group, or all that matches",
    )
    parser.add_argument("--seeds", default="0,1", help="a training for each of them (default: %(default)s)")
    parser.add_argument("--iterations", type=_positive, default=1800, help="steps of a training (default: %(default)s)")
    parser.add_argument("--batch", type=_positive, default=32, help="pictures of a step (default: %(default)s)")
    parser.add_argument("--size", type=_positive, default=640, help="sides of training pictures, pixels (default: %(default)s)")
    parser.add_argument(
        "--test-size", type=_positive, help="longer side of test pictures, pixels (default: 1.2 times --size)"
    )
    parser.add_argument(
        "--width", type=_share, default=1.0, help="channels of the detector, as a share of the usual ones (default: %(default)s)"
    )
    parser.add_argument(
        "--max-images", type=_positive, default=4000, help="pictures to learn from of a set, evenly spread (default: %(default)s)"
    )
    parser.add_argument("--device", choices=("auto", "cpu", "cuda"), default="auto", help="(default: %(default)s)")
    parser.add_argument("--out", default="sim2real", metavar="FOLDER", help="where the report goes (default: %(default)s)")
    return parser


def _positive(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text} is no whole number from 1")
    return int(text)


def _share(text: str) -> float:
    try:
        number = float(text)
    except ValueError:
        number = 0.0
    if not 0.1 <= number <= 2:
        raise argparse.ArgumentTypeError(f"{text} is no number from 0.1 to 2")
    return number


def _whole(side: int) -> int:
    """A side, rounded to whole cells of the largest stride."""
    return max(1, round(side / _STRIDE)) * _STRIDE


def _runs(sets: Sequence[str], also: Sequence[str], named: Sequence[str]) -> tuple[Run, ...]:
    runs: list[Run] = []
    if sets or also:
        if not sets:
            raise RecipeError("--train-also needs a dataset OUT to go with: name one, or use --train NAME=SET")
        runs.append(Run(_run_name([*sets, *also]), (*sets, *also)))
    for option in named:
        name, equals, listed = option.partition("=")
        parts = tuple(part for part in listed.split(",") if part)
        if not equals or not name or not parts:
            raise RecipeError(f"--train cannot be {option!r}: write NAME=SET, or NAME=SET,SET")
        runs.append(Run(name, parts))
    if not runs:
        raise RecipeError("there is nothing to learn from: name a dataset OUT, or --train NAME=SET")
    _differ([run.name for run in runs], "--train")
    return tuple(runs)


def _run_name(sets: Sequence[str]) -> str:
    kinds = {is_synthetic(one) for one in sets}
    return "mixed" if len(kinds) == 2 else "synthetic" if True in kinds else "real"


def _tests(given: Sequence[str]) -> tuple[tuple[str, str], ...]:
    """Names and sets; a set without a name has that of its folder."""
    tests: list[tuple[str, str]] = []
    for option in given:
        name, equals, path = option.partition("=")
        if not equals or Path(option).exists():
            path = option
            name = Path(option).resolve().name
        if not name or not path:
            raise RecipeError(f"--test cannot be {option!r}: write SET, or NAME=SET")
        tests.append((name, path))
    _differ([name for name, _ in tests], "--test")
    return tuple(tests)


def _differ(names: Sequence[str], option: str) -> None:
    twice = [name for place, name in enumerate(names) if name in names[:place]]
    if twice:
        raise RecipeError(f"{option} has {twice[0]!r} twice: give each a name of its own, NAME=SET")


def _classes(given: str) -> tuple[int, ...]:
    names = [name.strip() for name in given.split(",") if name.strip()]
    unknown = [name for name in names if name not in CLASSES]
    if unknown or not names:
        raise RecipeError(f"--classes cannot be {given!r}: use some of {','.join(CLASSES)}")
    return tuple(sorted({CLASSES.index(name) for name in names}))


def _seeds(given: str) -> tuple[int, ...]:
    try:
        seeds = tuple(dict.fromkeys(int(seed) for seed in given.split(",")))
    except ValueError as error:
        raise RecipeError(f"--seeds cannot be {given!r}: write whole numbers, 0,1,2") from error
    if min(seeds) < 0:
        raise RecipeError(f"--seeds cannot be {given!r}: use numbers from 0")
    return seeds
