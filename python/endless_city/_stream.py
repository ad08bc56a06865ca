"""Frames while they are made."""

from __future__ import annotations

import json
import logging
import operator
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Optional, Union

from endless_city import _native
from endless_city._camera import Camera
from endless_city._frame import CameraFrame, Loaded
from endless_city._objects import Objects
from endless_city._recipe import PathLike, flags, recipe_json
from endless_city.errors import RecipeError

if TYPE_CHECKING:
    from types import TracebackType

    from numpy.typing import NDArray

_LOG = logging.getLogger("endless_city")


class StreamedVideo:
    """What stays the same in all frames of a video that is streamed."""

    __slots__ = ("_record",)

    def __init__(self, record: dict[str, Any]) -> None:
        self._record = record

    @property
    def name(self) -> str:
        """The name that its folder would have."""
        return str(self._record["name"])

    @property
    def settings(self) -> dict[str, Any]:
        """Its settings: map, weather, time of day, cameras, as in `scenes/0000.json`."""
        settings: dict[str, Any] = self._record["settings"]
        return settings

    @property
    def actors(self) -> Optional[list[dict[str, Any]]]:
        """What stays the same of every object, as in `actors.json`; None if the simulator does not know."""
        actors: Optional[list[dict[str, Any]]] = self._record["actors"]
        return actors

    @property
    def record(self) -> dict[str, Any]:
        """All that is known of it."""
        return self._record

    def __repr__(self) -> str:
        return f"<StreamedVideo {self.name}>"


class SensorReading:
    """What a sensor of the rig measured at one instant."""

    __slots__ = ("_measurement", "_name", "_pose")

    def __init__(self, name: str, pose: bytes, measurement: Union[CameraFrame, dict[str, Any], list[Any]]) -> None:
        self._name = name
        self._pose = pose
        self._measurement = measurement

    @property
    def name(self) -> str:
        """Its name in the rig."""
        return self._name

    @property
    def pose(self) -> dict[str, Any]:
        """Where it is, as in `poses.jsonl`."""
        pose: dict[str, Any] = json.loads(self._pose)
        return pose

    @property
    def measurement(self) -> Union[CameraFrame, dict[str, NDArray[Any]], list[dict[str, Any]]]:
        """A `CameraFrame` of a camera.

        Of a LiDAR, a radar and an event camera columns of N rows, by their names: `points_m` float32 (N, 3), `intensity`;
        `depth_m`, `azimuth_rad`, `altitude_rad`, `velocity_mps`; `t_us`, `x`, `y`, `polarity`; with `classes` and `ids` of
        what was hit. Of all others a list of records as in their files.
        """
        return self._measurement

    def __repr__(self) -> str:
        return f"<SensorReading {self._name}>"


class Frame:
    """One instant of a scene, as all its cameras and sensors see it."""

    __slots__ = ("_cameras", "_frame", "_index", "_scene", "_sensors", "_time_s", "_video")

    def __init__(self, video: StreamedVideo, told: dict[str, Any], classes: list[str]) -> None:
        self._video = video
        self._index = int(told["index"])
        self._frame = int(told["frame"])
        self._time_s = float(told["time_s"])
        self._scene: Optional[bytes] = told["scene"]
        cameras = video.record["cameras"]
        self._cameras = [
            self._camera_frame(camera, record, None, classes) for camera, record in zip(told["cameras"], cameras)
        ]
        names = [sensor["name"] for sensor in video.record["sensors"]]
        self._sensors: list[SensorReading] = []
        for name, pose, measurement in told["sensors"]:
            if isinstance(measurement, bytes):
                measurement = json.loads(measurement)
            elif "arrays" in measurement:
                record = video.record["sensor_cameras"][names.index(name)]
                place = json.loads(pose).get("world_from_camera")
                measurement = self._camera_frame(measurement, record, place, classes)
            self._sensors.append(SensorReading(name, pose, measurement))

    def _camera_frame(
        self, told: dict[str, Any], record: dict[str, Any], pose: Optional[list[list[float]]], classes: list[str]
    ) -> CameraFrame:
        camera = Camera(told["name"], record)
        arrays = told["arrays"]
        source = Loaded(arrays, Objects(told["objects"], told["line"], classes), pose)
        layers = [name for name in arrays if name != "classes" and not name.endswith("_target")]
        return CameraFrame(
            source, video=self._video.name, camera=camera, frame=self._frame, time_s=self._time_s, layers=layers
        )

    @property
    def index(self) -> int:
        """Its place in the stream, from 0: `stream(start=index)` begins with it."""
        return self._index

    @property
    def video(self) -> StreamedVideo:
        """Its video."""
        return self._video

    @property
    def frame(self) -> int:
        """Its number in the video, from 0."""
        return self._frame

    @property
    def time_s(self) -> float:
        """Seconds since frame 0 of the video."""
        return self._time_s

    @property
    def scene(self) -> Optional[dict[str, Any]]:
        """Weather, sun, signals and counts, as a line of `frames.jsonl`; None if the simulator does not tell."""
        scene: Optional[dict[str, Any]] = None if self._scene is None else json.loads(self._scene)
        return scene

    @property
    def cameras(self) -> list[CameraFrame]:
        """One a camera of the scene."""
        return self._cameras

    @property
    def sensors(self) -> list[SensorReading]:
        """Those sensors of the rig that measured at this frame."""
        return self._sensors

    def _repr_png_(self) -> Optional[bytes]:
        """The picture of the first camera, which notebooks show."""
        return self._cameras[0].png() if self._cameras else None

    def __repr__(self) -> str:
        return f"<Frame {self._index}: {self._video.name} {self._frame}, {len(self._cameras)} cameras>"


class Stream(Iterator[Frame]):
    """An iterator of frames. Close it, leave its `with`, or forget it, and no more are made."""

    def __init__(self, native: _native.FrameStream) -> None:
        self._native = native
        self._video: Optional[StreamedVideo] = None
        self._classes = _native.classes()

    def __iter__(self) -> Stream:
        return self

    def __next__(self) -> Frame:
        told = self._native.next()
        if told is None:
            raise StopIteration
        if told["video"] is not None:
            self._video = StreamedVideo(json.loads(told["video"]))
            for line in self._native.news():
                _LOG.log(logging.WARNING if line.startswith("warning") else logging.INFO, "%s", line)
        assert self._video is not None
        return Frame(self._video, told, self._classes)

    def close(self) -> None:
        """Stops. It may be called again."""
        self._native.close()

    def __enter__(self) -> Stream:
        return self

    def __exit__(
        self,
        kind: Optional[type[BaseException]],
        error: Optional[BaseException],
        traceback: Optional[TracebackType],
    ) -> None:
        self.close()


def stream(
    *,
    config: Optional[PathLike] = None,
    start: int = 0,
    shard: Optional[tuple[int, int]] = None,
    threads: Optional[int] = None,
    buffer: int = 4,
    order: str = "map",
    cache: Optional[PathLike] = None,
    memory: Optional[Union[int, str]] = None,
    **recipe: Any,
) -> Stream:
    """Makes the frames of a recipe and hands them over in order, without writing them.

    Frames are those of `generate` with the same recipe, to the byte, whatever the threads. While you work with one, the next
    are made; memory is bounded by `buffer`.

        for frame in stream(videos=10, maps="Town03", size=(640, 360), seed=7):
            for view in frame.cameras:
                view.rgb, view.depth, view.objects.boxes

    Args:
        config: A recipe in a TOML file; options that are given here win over it.
        start: The first frame, counted over all videos of the stream: `frame.index` of the last one plus 1 goes on.
        shard: `(I, N)`: the videos of part I of N alone, I from 1 to N; the same as those of `generate`.
        threads: How many threads work; all cores by default.
        buffer: How many frames may wait for you, 1 to 1024.
        order: `map`: the videos of a map one after the other, so that each is loaded once; `video`: as they are numbered,
            which mixes maps, and loads them again and again.
        cache: Folder that keeps what bakes of the same camera share.
        memory: Most memory for that, bytes or as in "4GiB"; 1 GiB by default.
        **recipe: Options of the recipe, as in `generate`.

    Raises:
        RecipeError: The recipe cannot be made: here what can be seen at once, otherwise at the first frame.
        SimulationError: The simulation failed; raised by the iterator.
    """
    if order not in ("map", "video"):
        raise RecipeError(f"order cannot be {order!r}: use map or video")
    first, waiting = _whole("start", start, 0, 2**63), _whole("buffer", buffer, 1, 1024)
    told = flags(config=config, threads=threads, shard=shard, cache=cache, memory=memory)
    return Stream(_native.FrameStream(recipe_json(recipe), told, first, order == "video", waiting))


def _whole(name: str, value: object, least: int, most: int) -> int:
    try:
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        number = least - 1
    if not least <= number <= most:
        raise RecipeError(f"{name} cannot be {value!r}: write a whole number from {least} to {most}")
    return number
