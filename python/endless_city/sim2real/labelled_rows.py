"""From boxes with the names of a real dataset to labels of the coarse classes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from endless_city.sim2real.class_names import IGNORE, RIDER, NameMap
from endless_city.sim2real.labelled import CLASSES, TWO_WHEELER, Labels, labels_of
from endless_city.sim2real.riders import Box, joined

# Names that a note lists before it counts the others.
_LISTED = 12


@dataclass(frozen=True)
class NamedBox:
    """A box as a real dataset has it.

    - `name`: of its class;
    - `box`: left, top, right, bottom, pixels;
    - `ignored`: whether it stands for a crowd.
    """

    name: str
    box: Box
    ignored: bool = False


@dataclass
class Labeller:
    """Makes labels of named boxes, and counts names that are no class."""

    names: NameMap
    unknown: Counter[str] = field(default_factory=lambda: Counter[str]())

    def labels(self, named: Sequence[NamedBox], size: tuple[int, int], classes: Sequence[int]) -> Labels:
        """The labels of a picture of a size, in pixels; `classes` are those that the dataset labels."""
        rows: list[tuple[Sequence[float], int, bool]] = []
        riders: list[Box] = []
        two_wheelers: list[Box] = []
        for one in named:
            target = self.names.target(one.name)
            box = _inside(one.box, size)
            if target is None:
                self.unknown[one.name] += 1
            elif box[2] <= box[0] or box[3] <= box[1]:
                # Nothing of it is in the picture.
                continue
            elif one.ignored or target == IGNORE:
                # Of a crowd, the class is known; of what is to be ignored, it is none in particular.
                of = [TWO_WHEELER] if target == RIDER else [CLASSES.index(target)] if target in CLASSES else classes
                rows += [(box, number, True) for number in of]
            elif target == RIDER:
                riders.append(box)
            elif target == CLASSES[TWO_WHEELER]:
                two_wheelers.append(box)
            else:
                rows.append((box, CLASSES.index(target), False))
        rows += [(box, TWO_WHEELER, False) for box in joined(riders, two_wheelers)]
        return labels_of(rows)

    def notes(self) -> list[str]:
        """What was left out."""
        if not self.unknown:
            return []
        common = self.unknown.most_common()
        listed = ", ".join(f"{name} ({count})" for name, count in common[:_LISTED])
        more = f" and {len(common) - _LISTED} more" if len(common) > _LISTED else ""
        return [f"boxes of other classes are left out: {listed}{more}; --map NAME=CLASS takes them in"]


def _inside(box: Box, size: tuple[int, int]) -> list[float]:
    """The part of a box that is in the picture."""
    width, height = size
    left, top, right, bottom = box
    return [max(left, 0.0), max(top, 0.0), min(right, float(width)), min(bottom, float(height))]
