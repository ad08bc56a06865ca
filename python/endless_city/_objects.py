"""The annotated objects of a camera frame."""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, Optional, TypedDict, cast

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


# A keyword of Python.
_Class = TypedDict("_Class", {"class": str}, total=False)


class ObjectRecord(_Class, total=False):
    """One object as a line of `objects.jsonl` has it; `docs/objects.md` tells of all fields and of which are always there."""

    id: int
    bbox: list[int]
    pixels: int
    truncated: bool
    parked: bool
    position: list[float]
    vehicle_id: int
    rider_id: int
    skin_tone: int
    keypoints: list[float]
    num_keypoints: int
    foot_kpts: list[float]
    keypoints_3d: list[list[float]]
    foot_kpts_3d: list[list[float]]
    yaw_rad: float
    speed_mps: float
    velocity_mps: list[float]
    lights: list[str]
    stopped: bool
    steer_rad: float
    action: str
    lane: int
    road: int
    road_lane: int
    box3d: dict[str, Any]
    distance_m: float
    image_velocity_pxps: Optional[list[float]]
    amodal_bbox: list[int]
    amodal_bbox_clipped: list[int]
    amodal_pixels: int
    visibility: float
    truncation: float
    occluders: list[dict[str, int]]
    amodal_mask: str
    with_rider: dict[str, Any]


class Objects:
    """The N annotated objects of a camera frame as columns, by ascending id.

    What an object does not have is NaN in columns of floats. `records` has all fields of each.
    """

    __slots__ = ("_columns", "_line", "_names")

    def __init__(self, columns: dict[str, NDArray[Any]], line: bytes, names: Sequence[str]) -> None:
        self._columns = columns
        self._line = line
        self._names = tuple(names)

    def __len__(self) -> int:
        return len(self.ids)

    def __repr__(self) -> str:
        return f"<Objects: {len(self)}>"

    @property
    def ids(self) -> NDArray[np.int32]:
        """int32, (N,): the track; the same object has the same id in all cameras and frames of a video."""
        return self._columns["ids"]

    @property
    def class_ids(self) -> NDArray[np.int64]:
        """int64, (N,): places in the dataset's `classes`, from 0."""
        return self._columns["class_ids"]

    @property
    def names(self) -> list[str]:
        """N names of classes."""
        return [self._names[number] for number in self.class_ids]

    @property
    def boxes(self) -> NDArray[np.float32]:
        """float32, (N, 4): x, y, width, height in pixels from the top-left corner, tight around the visible pixels."""
        return self._columns["boxes"]

    @property
    def boxes_xyxy(self) -> NDArray[np.float32]:
        """float32, (N, 4): the same boxes by their corners: left, top, right, bottom. The corner lies beyond the last pixel."""
        import numpy as np

        corners: NDArray[np.float32] = np.array(self.boxes)
        corners[:, 2:] += corners[:, :2]
        return corners

    @property
    def amodal_boxes(self) -> NDArray[np.float32]:
        """float32, (N, 4): x, y, width, height of what each would show if nothing hid it, also beyond the picture, pixels."""
        return self._columns["amodal_boxes"]

    @property
    def visibility(self) -> NDArray[np.float32]:
        """float32, (N,): visible pixels over those it would show if nothing hid it, 0 to 1."""
        return self._columns["visibility"]

    @property
    def pixels(self) -> NDArray[np.int64]:
        """int64, (N,): number of visible pixels."""
        return self._columns["pixels"]

    @property
    def truncated(self) -> NDArray[np.bool_]:
        """bool, (N,): whether the box touches the edge of the picture."""
        return self._columns["truncated"]

    @property
    def parked(self) -> NDArray[np.bool_]:
        """bool, (N,): whether it is parked for the whole video."""
        return self._columns["parked"]

    @property
    def positions_m(self) -> NDArray[np.float64]:
        """float64, (N, 3): the point on the ground under its middle; world, x east, y north, z up, metres."""
        return self._columns["positions_m"]

    @property
    def velocities_mps(self) -> NDArray[np.float64]:
        """float64, (N, 3): velocity in the world, m/s."""
        return self._columns["velocities_mps"]

    @property
    def yaw_rad(self) -> NDArray[np.float64]:
        """float64, (N,): heading, counter-clockwise from east, radians."""
        return self._columns["yaw_rad"]

    @property
    def keypoints(self) -> NDArray[np.float32]:
        """float32, (N, 17, 3): COCO's keypoints: x, y in pixels, and 0 not in the picture, 1 hidden, 2 visible.

        All 0 for objects that are neither people nor riders.
        """
        return self._columns["keypoints"]

    @property
    def records(self) -> list[ObjectRecord]:
        """N dictionaries with all fields, as in `objects.jsonl`."""
        return cast("list[ObjectRecord]", json.loads(self._line)["objects"])

    @property
    def line(self) -> bytes:
        """The frame's line of `objects.jsonl`, as it stands there, without its end."""
        return self._line
