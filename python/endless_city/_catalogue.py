"""What there is to make datasets of."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Optional

from endless_city import _native

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class _Picture:
    """Something that notebooks show."""

    def preview(self) -> NDArray[np.uint8]:
        """uint8, (H, W, 3): its picture, sRGB."""
        raise NotImplementedError

    def _repr_png_(self) -> bytes:
        return _native.encode_png(self.preview())


@dataclass(frozen=True)
class Map(_Picture):
    """A map: a built-in town, or one that was imported."""

    name: str
    """Its name in recipes."""
    summary: str
    """One sentence on its character."""
    area_km2: float
    """Area that its roads span, km²."""
    lanes: int
    """Lanes for driving outside junctions."""
    lane_km: float
    """Kilometres of these lanes."""
    cameras: list[str]
    """Names of its camera sites."""
    features: list[str]
    """What it has: signals, crossings, slopes, fast roads."""
    imported: bool
    """Whether it was imported with `endless maps import`."""

    def preview(self) -> NDArray[np.uint8]:
        """uint8, (H, W, 3): the map from above with the view of each of its cameras, sRGB."""
        return _native.map_preview(self.name)


@dataclass(frozen=True)
class Asset(_Picture):
    """A kind of vehicle, person, building, plant or street furniture."""

    name: str
    """Its name."""
    kind: str
    """The class of its annotations, or `furniture`, `plant`, `building`."""
    length_m: tuple[float, float]
    """Shortest and longest, metres."""
    width_m: tuple[float, float]
    """Narrowest and widest, metres."""
    height_m: tuple[float, float]
    """Lowest and highest, metres."""
    triangles: int
    """Of the variant with the most."""
    variants: Optional[int]
    """How many different ones there are; None for any number."""

    def preview(self, variant: int = 0) -> NDArray[np.uint8]:
        """uint8, (H, W, 3): a variant from all sides, sRGB."""
        return _native.asset_preview(self.name, variant)


@dataclass(frozen=True)
class Option:
    """An option of a recipe."""

    name: str
    """Its key, as in `generate(name=...)`."""
    help: str
    """What it means."""
    default: Any
    """What holds where it is not given; None if that depends, as the help says."""
    schema: dict[str, Any]
    """What it can be, as JSON Schema."""


def maps() -> list[Map]:
    """All maps with their size, lanes, cameras and features. It takes some seconds: every town is built."""
    return [Map(**row) for row in json.loads(_native.maps())]


def assets() -> list[Asset]:
    """Everything in the catalogue: vehicles, people, buildings, plants, street furniture."""
    spans = ("length_m", "width_m", "height_m")
    rows: list[dict[str, Any]] = json.loads(_native.assets())
    for row in rows:
        row.update({key: tuple(row[key]) for key in spans})
    return [Asset(**row) for row in rows]


def options() -> list[Option]:
    """All options of a recipe."""
    properties: dict[str, dict[str, Any]] = json.loads(_native.options())["properties"]
    return [
        Option(name, schema["description"], schema.get("default"), schema) for name, schema in properties.items()
    ]


def classes() -> list[str]:
    """Names of the classes of objects, by `Objects.class_ids`."""
    return _native.classes()


def tags() -> list[str]:
    """Names of the class tags of pixels, by the values of `CameraFrame.classes`: CARLA's."""
    return _native.tags()
