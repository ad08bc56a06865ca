"""Which names of classes, as real datasets have them, are which coarse class."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Optional

from endless_city.errors import RecipeError
from endless_city.sim2real.labelled import CLASSES, TWO_WHEELER

RIDER = "rider"
"""Who rides, where datasets give them a box beside that of what is ridden: the two become one two-wheeler."""

IGNORE = "ignore"
"""Neither asked for nor wrong to find."""

TARGETS: tuple[str, ...] = (*CLASSES, RIDER, IGNORE)
"""What a name can be mapped to."""

_NAMES = {
    "vehicle": (
        "vehicle, vehicles, motor vehicle, car, cars, automobile, auto, sedan, hatchback, suv, jeep, taxi, cab, pickup, "
        "pickup truck, van, vans, minivan, truck, trucks, lorry, heavy truck, light truck, big truck, small truck, "
        "large vehicle, heavy vehicle, light vehicle, hgv, lgv, semi, semi truck, trailer, bus, buses, minibus, mini bus, "
        "microbus, coach, tram, trolley bus, caravan, camper, rv, ambulance, police car, police, fire truck, firetruck, "
        "emergency vehicle, construction vehicle, tractor, rickshaw, auto rickshaw, autorickshaw, e rickshaw, tuk tuk, tuktuk, "
        "three wheeler, threewheel, cng"
    ),
    "two_wheeler": (
        "two wheeler, two wheelers, twowheeler, 2 wheeler, motorcycle, motorcycles, motorbike, motorbikes, motor bike, "
        "motor cycle, motor, moto, bike, bikes, bicycle, bicycles, cycle, cyclist, cyclists, biker, motorcyclist, "
        "motorcyclists, bicyclist, scooter, moped, e bike, ebike"
    ),
    "pedestrian": "pedestrian, pedestrians, person, persons, people, human, man, woman, child, walker, boy, girl",
    RIDER: "rider, riders",
    IGNORE: "ignore, ignored, ignored regions, ignored region, dontcare, dont care, crowd",
}

_TARGET_OF = {name: target for target, names in _NAMES.items() for name in names.split(", ")}


@dataclass(frozen=True)
class NameMap:
    """What the names of a dataset are, by the usual names and by those that the user gave."""

    given: Mapping[str, str]

    def target(self, name: str) -> Optional[str]:
        """One of `TARGETS`, or None for a name of something else."""
        plain = _plain(name)
        return self.given.get(plain, _TARGET_OF.get(plain))

    def labelled(self, names: Sequence[str]) -> tuple[int, ...]:
        """Classes of a dataset that has these names, places in `CLASSES`, rising."""
        targets = [self.target(name) for name in names]
        classes = {CLASSES.index(target) for target in targets if target in CLASSES}
        if RIDER in targets:
            classes.add(TWO_WHEELER)
        return tuple(sorted(classes))


def name_map(options: Sequence[str]) -> NameMap:
    """Of options such as `tricycle=vehicle`; they win over the usual names.

    Raises:
        RecipeError: An option has another form, or no such class.
    """
    given: dict[str, str] = {}
    for option in options:
        name, equals, target = option.rpartition("=")
        if not equals or not name or target not in TARGETS:
            raise RecipeError(f"--map cannot be {option!r}: write NAME=CLASS, where CLASS is one of {', '.join(TARGETS)}")
        given[_plain(name)] = target
    return NameMap(given)


def _plain(name: str) -> str:
    """Without capitals, hyphens and underlines."""
    return re.sub(r"[\s_\-/]+", " ", name).strip().lower()
