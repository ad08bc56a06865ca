"""Cameras: what projects points of the world into their pictures."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any, Optional

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


class Camera:
    """A camera of a video: the content of its `camera.json`."""

    __slots__ = ("_name", "_record")

    def __init__(self, name: str, record: dict[str, Any]) -> None:
        self._name = name
        self._record = record

    def __repr__(self) -> str:
        return f"<Camera {self._name}: {self.size[0]}x{self.size[1]}, {self.lens_model}>"

    @property
    def name(self) -> str:
        """Its folder: `camera_a`, or the name of a sensor of the rig."""
        return self._name

    @property
    def record(self) -> dict[str, Any]:
        """All of `camera.json`."""
        return self._record

    @property
    def size(self) -> tuple[int, int]:
        """Width and height, pixels."""
        size = self._record["size"]
        return int(size["width"]), int(size["height"])

    @property
    def fps(self) -> float:
        """Frames a second."""
        return float(self._record["fps"])

    @property
    def intrinsics(self) -> NDArray[np.float64]:
        """float64, (3, 3): the camera matrix K, pixels; the centre of pixel (i, j) is at (i + 0.5, j + 0.5)."""
        import numpy as np

        return np.array(self._record["intrinsics_matrix"], dtype=np.float64)

    @property
    def lens_model(self) -> str:
        """`pinhole`, `opencv`, `opencv_fisheye`, `equirectangular` or `orthographic`."""
        return str(self._record["lens"]["model"])

    @property
    def distortion(self) -> NDArray[np.float64]:
        """float64, (5,), (4,) or (0,): OpenCV's D of the lens model."""
        import numpy as np

        return np.array(self._record["lens"]["distortion"], dtype=np.float64)

    @property
    def world_from_camera(self) -> Optional[NDArray[np.float64]]:
        """float64, (4, 4): takes points of the camera's frame (x right, y down, z forward) to the world, metres.

        None of a camera that moves: each of its frames tells where it is.
        """
        import numpy as np

        pose = self._record.get("world_from_camera")
        return None if pose is None else np.array(pose, dtype=np.float64)

    @property
    def site(self) -> Optional[str]:
        """Name of its place on the map; None of a camera that moves."""
        site = self._record.get("site")
        return None if site is None else str(site["name"])


def camera_of(name: str, text: bytes) -> Camera:
    """The camera of a `camera.json`."""
    return Camera(name, json.loads(text))
