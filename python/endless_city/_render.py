"""One frame."""

from __future__ import annotations

import json
from typing import Any, Optional, Union

from endless_city import _native
from endless_city._frame import CameraFrame
from endless_city._recipe import flags, recipe_json
from endless_city._stream import Frame, StreamedVideo
from endless_city.errors import RecipeError


def render(
    *,
    map: Optional[str] = None,  # noqa: A002
    camera: Optional[str] = None,
    weather: Optional[str] = None,
    time: Optional[str] = None,
    size: Union[str, tuple[int, int]] = (1280, 720),
    seed: int = 0,
    at: float = 0.0,
    threads: Optional[int] = None,
    **recipe: Any,
) -> CameraFrame:
    """Makes one frame of one camera, which shows itself in a notebook.

        render(map="Town03", weather="rainy", time="night", size=(640, 360))

    Args:
        map: Name of a map; any by default. `maps()` lists them.
        camera: Name of one of its camera sites; any by default.
        weather: clear_sky, rainy, cloudy, foggy or after_rain; any by default.
        time: morning, afternoon or night; any by default.
        size: Width and height, pixels.
        seed: Seed of everything random.
        at: Seconds of traffic before the frame.
        threads: How many threads work; all cores by default.
        **recipe: Other options of the recipe, as in `generate`: `layers`, `vehicles`, `camera_look`, ...

    Raises:
        RecipeError: There is no such map, camera, weather or time, or the recipe cannot be made.
        SimulationError: The simulation failed.
    """
    seconds: Any = at
    if type(seconds) not in (int, float) or not 0.0 <= seconds <= 3600.0:
        raise RecipeError(f"at cannot be {at!r}: write seconds from 0 to 3600")
    if camera is not None and map is None:
        raise RecipeError("a camera is one of a map: name the map, too")
    words: dict[str, Any] = {"map": map, "camera": camera, "weather": weather, "time": time}
    for name, word in words.items():
        if word is not None and not isinstance(word, str):
            raise RecipeError(f"{name} cannot be {word!r}: give a word")
    fps = 10.0
    frame = round(at * fps)
    options: dict[str, Any] = {"videos": 1, "cameras_per_scene": 1, "fps": fps, "mp4": "none", **recipe}
    options.update(size=size, seed=seed, duration=(frame + 1) / fps)
    for key, word in (("maps", map), ("weathers", weather), ("times", time)):
        if word is not None:
            options[key] = [word]
    told = _native.render(recipe_json(options), flags(threads=threads), camera, frame)
    return Frame(StreamedVideo(json.loads(told["video"])), told, _native.classes()).cameras[0]
