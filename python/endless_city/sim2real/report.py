"""Tables of scores for the terminal, for `report.md`, and all figures for `report.json`."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Optional, cast

from endless_city.sim2real.bootstrap import Estimate
from endless_city.sim2real.labelled import CLASSES, LabelledSet
from endless_city.sim2real.scores import ClassScore, RunScore

_CLASS_HEAD = ("run", "test", "class", "boxes", "AP50", "95 %", "seeds", "AP50:95", "95 %", "seeds", "recall")
_SIZE_HEAD = ("run", "test", "class", "size", "boxes", "AP50", "AP50:95", "recall")


@dataclass(frozen=True)
class SetLine:
    """What is in a set.

    - `boxes`: of each class that is labelled, by its name;
    - `ignored`: boxes that count for nothing;
    - `cameras`: how many there are, None if that is not known.
    """

    path: str
    images: int
    cameras: Optional[int]
    boxes: Mapping[str, int]
    ignored: int
    notes: Sequence[str]

    @classmethod
    def of(cls, path: str, whole: LabelledSet) -> SetLine:
        """Counts a set."""
        wanted = [image.labels.classes[~image.labels.ignored] for image in whole.images]
        boxes = {CLASSES[number]: sum(int((of_image == number).sum()) for of_image in wanted) for number in whole.classes}
        ignored = sum(int(image.labels.ignored.sum()) for image in whole.images)
        cameras = whole.cameras
        return cls(path, len(whole.images), None if cameras is None else len(cameras), boxes, ignored, list(whole.notes))


@dataclass(frozen=True)
class Report:
    """All that came out.

    - `settings`: how it was trained;
    - `warnings`: sentences;
    - `seconds`: of each run, with all seeds and tests.
    """

    settings: Mapping[str, Any]
    sets: Sequence[SetLine]
    scores: Sequence[RunScore]
    warnings: Sequence[str]
    seconds: Mapping[str, float]

    def text(self) -> str:
        """Tables for a terminal."""
        notes = "\n".join(self._notes())
        return "\n\n".join([_aligned(_CLASS_HEAD, self._class_rows()), _aligned(_SIZE_HEAD, self._size_rows()), notes])

    def markdown(self) -> str:
        """A page."""
        settings = self.settings
        sets = [
            (one.path, str(one.images), _or_unknown(one.cameras), ", ".join(f"{name} {n}" for name, n in one.boxes.items()))
            for one in self.sets
        ]
        parts = [
            "# From synthetic to real",
            f"A detector of {settings['parameters'] / 1e6:.1f} million parameters, trained from scratch for "
            f"{settings['iterations']} iterations of {settings['batch']} pictures at {settings['size']} pixels, tested at "
            f"{settings['test_size']}; seeds {', '.join(map(str, settings['seeds']))}; {settings['device']}.",
            "## Classes",
            _piped(_CLASS_HEAD, self._class_rows()),
            "## Sizes",
            _piped(_SIZE_HEAD, self._size_rows()),
            "## Sets",
            _piped(("set", "pictures", "cameras", "boxes"), sets),
            "## Notes",
            "\n".join(f"- {note}" for note in self._notes()),
            "![What the first seed missed, and what it took for something](misses.png)",
        ]
        return "\n\n".join(parts) + "\n"

    def json(self) -> str:
        """All figures; null where there is none."""
        content = {
            "settings": dict(self.settings),
            "sets": [asdict(one) for one in self.sets],
            "scores": [asdict(one) for one in self.scores],
            "warnings": list(self.warnings),
            "seconds": dict(self.seconds),
        }
        return json.dumps(_finite(content), indent=2) + "\n"

    def write(self, folder: Path) -> None:
        """Writes `report.md` and `report.json`."""
        (folder / "report.md").write_text(self.markdown(), encoding="utf-8")
        (folder / "report.json").write_text(self.json(), encoding="utf-8")

    def _class_rows(self) -> list[Sequence[str]]:
        rows: list[Sequence[str]] = []
        for one in self.scores:
            rows += [(one.run, one.test, *_class_cells(of_class)) for of_class in one.classes]
            if len(one.classes) > 1:
                mean = (*_estimate_cells(one.mean_ap50), *_estimate_cells(one.mean_ap50_95), "")
                rows.append((one.run, one.test, "mean", "", *mean))
        return rows

    def _size_rows(self) -> list[Sequence[str]]:
        return [
            (one.run, one.test, row.name, row.size, str(row.boxes), *map(_figure, (row.ap50, row.ap50_95, row.recall)))
            for one in self.scores
            for row in one.sizes
        ]

    def _drawn(self) -> str:
        """What the bootstrap draws: `cameras (gate, yard), pictures (roof)`."""
        tests: dict[str, dict[str, None]] = {}
        for one in self.scores:
            tests.setdefault(one.drawn, {})[one.test] = None
        return ", ".join(f"{kind} ({', '.join(names)})" for kind, names in sorted(tests.items()))

    def _notes(self) -> list[str]:
        return [
            f"95 %: interval of the mean over seeds, by a bootstrap over {self._drawn()}; seeds: each of them.",
            "recall: share that is found at IoU 0.5 with one false detection of the class a picture.",
            "Sizes as the detector sees them: tiny, longer side under 16 pixels; else small under 32², medium under 96², large.",
            *self.warnings,
            *(f"{one.path}: {note}" for one in self.sets for note in one.notes),
        ]


def _class_cells(row: ClassScore) -> Sequence[str]:
    return (row.name, str(row.boxes), *_estimate_cells(row.ap50), *_estimate_cells(row.ap50_95), _figure(row.recall))


def _estimate_cells(value: Estimate) -> Sequence[str]:
    seeds = " ".join(_figure(seed) for seed in value.seeds)
    return _figure(value.mean), f"{_figure(value.low)} to {_figure(value.high)}", seeds


def _figure(value: float) -> str:
    return "-" if math.isnan(value) else f"{value:.3f}"


def _or_unknown(count: Optional[int]) -> str:
    return "not known" if count is None else str(count)


def _aligned(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table whose columns are as wide as they must be."""
    table = [head, *rows]
    widths = [max(len(row[column]) for row in table) for column in range(len(head))]
    return "\n".join("  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in table)


def _piped(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A table of Markdown."""
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join(f"| {' | '.join(cell.replace('|', chr(92) + '|') for cell in line)} |" for line in lines)


def _finite(value: Any) -> Any:
    """The same with None for what is no number, which JSON does not have."""
    if isinstance(value, dict):
        return {key: _finite(one) for key, one in cast("dict[str, Any]", value).items()}
    if isinstance(value, (list, tuple)):
        return [_finite(one) for one in cast("list[Any]", value)]
    return None if isinstance(value, float) and not math.isfinite(value) else value
