"""One frame of one camera."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Optional, Protocol

from endless_city import _native
from endless_city._camera import Camera
from endless_city._objects import Objects
from endless_city.errors import DatasetError, RecipeError

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray


LAYERS: tuple[str, ...] = (
    "rgb",
    "depth",
    "instance",
    "semantic",
    "panoptic",
    "normals",
    "albedo",
    "shadow",
    "body_parts",
    "flow",
    "flow_backward",
)
"""All layers that a dataset may have."""


class FrameSource(Protocol):
    """Where the images and labels of a camera frame come from."""

    def arrays(self, layers: list[str]) -> dict[str, NDArray[Any]]:
        """Decodes layers."""
        ...

    def objects(self) -> Objects:
        """Reads labels."""
        ...

    def pose(self) -> Optional[list[list[float]]]:
        """Where a camera that moves is."""
        ...


class CameraFrame:
    """What one camera sees at one instant: images, objects, calibration.

    Images are decoded when they are first asked for, and kept. All of one frame have the same height H and width W, and agree
    pixel by pixel. A layer that is not stored raises `DatasetError`.
    """

    __slots__ = ("_arrays", "_camera", "_frame", "_layers", "_objects", "_source", "_time_s", "_video")

    def __init__(
        self,
        source: FrameSource,
        *,
        video: str,
        camera: Camera,
        frame: int,
        time_s: float,
        layers: Iterable[str],
    ) -> None:
        self._source = source
        self._video = video
        self._camera = camera
        self._frame = frame
        self._time_s = time_s
        self._layers = tuple(layers)
        self._arrays: dict[str, NDArray[Any]] = {}
        self._objects: Optional[Objects] = None

    def __repr__(self) -> str:
        return f"<CameraFrame {self._video}/{self._camera.name} {self._frame}: {', '.join(self._layers)}>"

    def __reduce__(self) -> tuple[Any, ...]:
        # All of it travels: the files need not be where it arrives.
        self.load()
        pose = self._source.pose() if self._camera.world_from_camera is None else None
        source = Loaded(self._arrays, self.objects, pose)
        return _restored, (source, self._video, self._camera, self._frame, self._time_s, self._layers)

    @property
    def video(self) -> str:
        """Name of the video."""
        return self._video

    @property
    def camera(self) -> Camera:
        """The camera: intrinsics, lens, pose."""
        return self._camera

    @property
    def frame(self) -> int:
        """Number of the frame in its video, from 0."""
        return self._frame

    @property
    def time_s(self) -> float:
        """Seconds since frame 0."""
        return self._time_s

    @property
    def layers(self) -> tuple[str, ...]:
        """Layers that there are."""
        return self._layers

    @property
    def size(self) -> tuple[int, int]:
        """Width and height, pixels."""
        return self._camera.size

    @property
    def objects(self) -> Objects:
        """The annotated objects."""
        if self._objects is None:
            self._objects = self._source.objects()
        return self._objects

    @property
    def world_from_camera(self) -> Optional[NDArray[np.float64]]:
        """float64, (4, 4): where the camera is at this instant: from its frame (x right, y down, z forward) to the world."""
        import numpy as np

        if self._camera.world_from_camera is not None:
            return self._camera.world_from_camera
        pose = self._source.pose()
        return None if pose is None else np.array(pose, dtype=np.float64)

    def load(self, layers: Optional[Iterable[str]] = None) -> Mapping[str, NDArray[Any]]:
        """Decodes layers side by side, all by default; arrays by their names, as the properties have them.

        Raises:
            DatasetError: A layer is not stored, or its file cannot be read.
        """
        wanted = list(self._layers if layers is None else layers)
        for layer in wanted:
            self._check(layer)
        missing = [layer for layer in wanted if layer not in self._arrays]
        if missing:
            self._arrays.update(self._source.arrays(missing))
        return {name: array for name, array in self._arrays.items() if _layer_of(name) in wanted}

    def _check(self, layer: str) -> None:
        if layer not in self._layers:
            if layer not in LAYERS:
                raise RecipeError(f"there is no layer {layer!r}: use some of {', '.join(LAYERS)}")
            had = ", ".join(self._layers) or "none"
            raise DatasetError(f"the layer {layer} is not stored, only {had}: name it in layers when you generate")

    def _array(self, name: str) -> Any:
        array = self._arrays.get(name)
        if array is None:
            layer = _layer_of(name)
            self._check(layer)
            self._arrays.update(self._source.arrays([layer]))
            array = self._arrays[name]
        return array

    @property
    def rgb(self) -> NDArray[np.uint8]:
        """uint8, (H, W, 3): what the camera sees, sRGB."""
        return self._array("rgb")  # type: ignore[no-any-return]

    @property
    def depth(self) -> NDArray[np.float32]:
        """float32, (H, W): metres along the optical axis (of lenses other than perspective: distance); 1000 for the sky."""
        return self._array("depth")  # type: ignore[no-any-return]

    @property
    def instance(self) -> NDArray[np.int32]:
        """int32, (H, W): ids of objects, as in `objects.ids`; 0 for stuff."""
        return self._array("instance")  # type: ignore[no-any-return]

    @property
    def classes(self) -> NDArray[np.uint8]:
        """uint8, (H, W): class tags, CARLA's; of the instance, semantic or panoptic layer. `endless_city.tags()` names them."""
        if "instance" in self._layers:
            return self._array("classes")  # type: ignore[no-any-return]
        if "panoptic" in self._layers and "semantic" not in self._layers:
            return (self._array("panoptic") >> 16).astype("uint8")  # type: ignore[no-any-return]
        return self._array("semantic")  # type: ignore[no-any-return]

    @property
    def semantic(self) -> NDArray[np.uint8]:
        """uint8, (H, W): class tags of the semantic layer."""
        return self._array("semantic")  # type: ignore[no-any-return]

    @property
    def panoptic(self) -> NDArray[np.int32]:
        """int32, (H, W): COCO's segments: id + 65536 × class tag, the id 0 for stuff."""
        return self._array("panoptic")  # type: ignore[no-any-return]

    @property
    def normals(self) -> NDArray[np.float32]:
        """float32, (H, W, 3): unit normals, x right, y down, z forward; 0, 0, 0 for the sky."""
        return self._array("normals")  # type: ignore[no-any-return]

    @property
    def albedo(self) -> NDArray[np.uint8]:
        """uint8, (H, W, 3): colours without light, sRGB; black for the sky."""
        return self._array("albedo")  # type: ignore[no-any-return]

    @property
    def shadow(self) -> NDArray[np.uint8]:
        """uint8, (H, W): share of the sun's disc that is hidden: 0 in the light, 255 in the shadow."""
        return self._array("shadow")  # type: ignore[no-any-return]

    @property
    def body_parts(self) -> NDArray[np.uint8]:
        """uint8, (H, W): parts of people and riders, 1 to 14 as DensePose numbers them, 15 what they carry, 0 else."""
        return self._array("body_parts")  # type: ignore[no-any-return]

    @property
    def flow(self) -> NDArray[np.float32]:
        """float32, (H, W, 2): where each pixel's point is in the next frame, pixels to the right and down; 0 where unknown."""
        return self._array("flow")  # type: ignore[no-any-return]

    @property
    def flow_target(self) -> NDArray[np.uint8]:
        """uint8, (H, W): what the next frame shows there: 0 unknown, 1 the point itself, 2 something before it, 3 outside."""
        return self._array("flow_target")  # type: ignore[no-any-return]

    @property
    def flow_backward(self) -> NDArray[np.float32]:
        """float32, (H, W, 2): the same to the frame before, pixels."""
        return self._array("flow_backward")  # type: ignore[no-any-return]

    @property
    def flow_backward_target(self) -> NDArray[np.uint8]:
        """uint8, (H, W): what the frame before shows there, as `flow_target`."""
        return self._array("flow_backward_target")  # type: ignore[no-any-return]

    def png(self) -> Optional[bytes]:
        """The picture as a PNG; None if the layer `rgb` is not stored."""
        return _native.encode_png(self.rgb) if "rgb" in self._layers else None

    def _repr_png_(self) -> Optional[bytes]:
        """What notebooks show."""
        return self.png()


def _layer_of(name: str) -> str:
    """The layer that an array belongs to."""
    return "instance" if name == "classes" else name.removesuffix("_target")


class Loaded:
    """Arrays and labels that are in memory."""

    __slots__ = ("_arrays", "_objects", "_pose")

    def __init__(self, arrays: dict[str, NDArray[Any]], objects: Objects, pose: Optional[list[list[float]]]) -> None:
        self._arrays = arrays
        self._objects = objects
        self._pose = pose

    def arrays(self, layers: list[str]) -> dict[str, NDArray[Any]]:
        """Those of some layers."""
        return {name: array for name, array in self._arrays.items() if _layer_of(name) in layers}

    def objects(self) -> Objects:
        """The labels."""
        return self._objects

    def pose(self) -> Optional[list[list[float]]]:
        """Where a camera that moves is."""
        return self._pose


def _restored(
    source: Loaded, video: str, camera: Camera, frame: int, time_s: float, layers: tuple[str, ...]
) -> CameraFrame:
    return CameraFrame(source, video=video, camera=camera, frame=frame, time_s=time_s, layers=layers)
