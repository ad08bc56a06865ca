"""Random access to a dataset on the disk."""

from __future__ import annotations

import json
import operator
import os
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Optional, Union, cast, overload

from endless_city import _native
from endless_city._camera import Camera, camera_of
from endless_city._frame import LAYERS, CameraFrame
from endless_city._objects import Objects
from endless_city.errors import RecipeError

if TYPE_CHECKING:
    from numpy.typing import NDArray


class Dataset(Sequence[CameraFrame]):
    """The camera frames of all complete videos of a dataset: by video, by camera, by time.

        dataset = Dataset("out")
        frame = dataset[0]
        frame.rgb, frame.depth, frame.objects.boxes

    It can be pickled, and used after a fork. Images are read when a frame is asked for them; a frame's layers are decoded side
    by side, without the interpreter's lock.
    """

    def __init__(
        self,
        root: Union[str, os.PathLike[str]],
        *,
        layers: Optional[Iterable[str]] = None,
        cameras: Optional[Iterable[str]] = None,
        videos: Optional[Iterable[str]] = None,
    ) -> None:
        """Opens the dataset in a folder.

        Args:
            root: Its folder.
            layers: The layers that frames offer; all that are stored by default.
            cameras: The cameras: `camera_a`, or names of sensors of the rig; all by default.
            videos: Names of the videos; all that are complete by default.

        Raises:
            DatasetError: There is no dataset, or it has no such camera or video.
            RecipeError: There is no such layer.
        """
        self._root = os.fspath(root)
        self._chosen = (_words("layers", layers), _words("cameras", cameras), _words("videos", videos))
        unknown = [layer for layer in self._chosen[0] or () if layer not in LAYERS]
        if unknown:
            raise RecipeError(f"there is no layer {unknown[0]!r}: use some of {', '.join(LAYERS)}")
        self._reader = _native.DatasetReader(self._root, self._chosen[2], self._chosen[1])
        self._rows = self._reader.cameras()
        self._cameras: dict[int, Camera] = {}
        self._classes = self._reader.classes()
        self._recipe: dict[str, Any] = json.loads(self._reader.recipe())

    def __reduce__(self) -> tuple[Any, ...]:
        return _reopen, (self._root, *self._chosen)

    def __repr__(self) -> str:
        return f"<Dataset {self._root}: {len(self)} camera frames>"

    def __len__(self) -> int:
        return len(self._reader)

    @overload
    def __getitem__(self, index: int) -> CameraFrame: ...

    @overload
    def __getitem__(self, index: slice) -> list[CameraFrame]: ...

    def __getitem__(self, index: Union[int, slice]) -> Union[CameraFrame, list[CameraFrame]]:
        if isinstance(index, slice):
            return [self[place] for place in range(*index.indices(len(self)))]
        place = operator.index(index)
        if not -len(self) <= place < len(self):
            raise IndexError(f"frame {place} of {len(self)}")
        number, frame = self._reader.place(place % len(self))
        video, _, stored, _, _ = self._rows[number]
        camera = self._camera(number)
        wanted = self._chosen[0]
        layers = [layer for layer in stored if wanted is None or layer in wanted]
        source = _Stored(self._reader, number, frame, self._classes)
        time_s = frame / self._recipe["fps"]
        return CameraFrame(source, video=video, camera=camera, frame=frame, time_s=time_s, layers=layers)

    def __iter__(self) -> Iterator[CameraFrame]:
        return (self[place] for place in range(len(self)))

    def load(self, index: int, layers: Optional[Iterable[str]] = None) -> CameraFrame:
        """A frame whose layers are decoded already, all by default."""
        frame = self[index]
        frame.load(layers)
        return frame

    def split(
        self, shares: Optional[Union[str, Mapping[str, float]]] = None, *, by: str = "video"
    ) -> dict[str, Dataset]:
        """Parts for training, validation and test, no scene in two of them: those of `endless export`, by their names.

            parts = dataset.split({"train": 0.8, "val": 0.1, "test": 0.1}, by="map")
            parts["train"][0]

        Parts follow from the dataset's seed and all of its videos. Those of a dataset of chosen videos have the chosen ones.

        Args:
            shares: The share of each part; they add up to 1. By default 0.8 `train` and 0.2 `val`, or all `train` where there is
                one group of videos only. May be written as in `endless export --split`: "train=0.8,val=0.2".
            by: What stays together: each `video`, all of a `camera`, of a `map`, or of a `condition` (weather and time of day).

        Raises:
            RecipeError: Shares do not add up to 1, or there are fewer groups of videos than parts.
            DatasetError: No video is complete.
        """
        layers, cameras, videos = self._chosen
        text = shares if shares is None or isinstance(shares, str) else _shares(shares)
        parts = _native.split(self._root, text, by)
        return {
            name: Dataset(
                self._root,
                layers=layers,
                cameras=cameras,
                videos=[video for video in own if videos is None or video in videos],
            )
            for name, own in parts
        }

    @property
    def root(self) -> str:
        """The folder."""
        return self._root

    @property
    def recipe(self) -> dict[str, Any]:
        """The resolved recipe."""
        return self._recipe

    @property
    def classes(self) -> list[str]:
        """Names of the classes of objects, by `objects.class_ids`."""
        return list(self._classes)

    @property
    def videos(self) -> list[str]:
        """Names of the videos."""
        return list(dict.fromkeys(row[0] for row in self._rows))

    @property
    def layers(self) -> tuple[str, ...]:
        """Layers that all cameras have."""
        wanted = self._chosen[0]
        return tuple(
            layer
            for layer in LAYERS
            if self._rows and all(layer in row[2] for row in self._rows) and (wanted is None or layer in wanted)
        )

    def _camera(self, number: int) -> Camera:
        camera = self._cameras.get(number)
        if camera is None:
            camera = camera_of(self._rows[number][1], self._reader.camera_json(number))
            self._cameras[number] = camera
        return camera


def _reopen(
    root: str, layers: Optional[list[str]], cameras: Optional[list[str]], videos: Optional[list[str]]
) -> Dataset:
    return Dataset(root, layers=layers, cameras=cameras, videos=videos)


def _shares(shares: Any) -> str:
    if not isinstance(shares, Mapping):
        raise RecipeError(f"shares cannot be {shares!r}: give the share of each part by its name")
    given = cast("Mapping[str, float]", shares)
    return ",".join(f"{name}={share}" for name, share in given.items())


def _words(name: str, words: Any) -> Optional[list[str]]:
    if words is None:
        return None
    given: list[Any] = [words] if isinstance(words, str) else list(words)
    for word in given:
        if not isinstance(word, str):
            raise RecipeError(f"{name} cannot have {word!r}: give words")
    return given


class _Stored:
    """A camera frame on the disk."""

    __slots__ = ("_camera", "_frame", "_names", "_reader")

    def __init__(self, reader: _native.DatasetReader, camera: int, frame: int, names: list[str]) -> None:
        self._reader = reader
        self._camera = camera
        self._frame = frame
        self._names = names

    def arrays(self, layers: list[str]) -> dict[str, NDArray[Any]]:
        return self._reader.load(self._camera, self._frame, layers)

    def objects(self) -> Objects:
        columns, line = self._reader.objects(self._camera, self._frame)
        return Objects(columns, line, self._names)

    def pose(self) -> Optional[list[list[float]]]:
        return self._reader.moving_pose(self._camera, self._frame)
