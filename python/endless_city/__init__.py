"""ENDLESS: endless annotated urban datasets seen by surveillance cameras.

    import endless_city

    endless_city.generate("out", videos=2, size=(640, 360))   # a dataset on the disk
    endless_city.Dataset("out")[0].rgb                        # its frames as NumPy's arrays
    for frame in endless_city.stream(videos=2):               # frames while they are made
        ...
    endless_city.render(map="Town03", weather="rainy")        # one frame

`endless_city.torch` feeds PyTorch. Lengths are metres, times seconds, angles radians, places in pictures pixels from the
top-left corner. Errors are `endless_city.EndlessError`, and say what to do.
"""

from __future__ import annotations

from endless_city import _native
from endless_city._camera import Camera
from endless_city._catalogue import Asset, Map, Option, assets, classes, maps, options, tags
from endless_city._dataset import Dataset
from endless_city._frame import LAYERS, CameraFrame
from endless_city._generate import Generated, generate
from endless_city._objects import ObjectRecord, Objects
from endless_city._render import render
from endless_city._stream import Frame, SensorReading, Stream, StreamedVideo, stream
from endless_city.errors import DatasetError, EndlessError, RecipeError, SimulationError

__all__ = [
    "LAYERS",
    "Asset",
    "Camera",
    "CameraFrame",
    "Dataset",
    "DatasetError",
    "EndlessError",
    "Frame",
    "Generated",
    "Map",
    "ObjectRecord",
    "Objects",
    "Option",
    "RecipeError",
    "SensorReading",
    "SimulationError",
    "Stream",
    "StreamedVideo",
    "__version__",
    "assets",
    "classes",
    "generate",
    "maps",
    "options",
    "render",
    "stream",
    "tags",
]

__version__: str = _native.version().split(" ", 1)[0]
