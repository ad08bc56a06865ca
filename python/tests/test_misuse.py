"""Whatever is given: exceptions, and nothing worse."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import endless_city
from endless_city import EndlessError, _native
from endless_city._recipe import flags, recipe_json

KEYS = sorted({option.name for option in endless_city.options()} - {"simulator"})

anything: st.SearchStrategy[Any] = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=12)
    | st.binary(max_size=4)
    | st.just(np.float32(2.5))
    | st.just(np.arange(3))
    | st.just(Path("nowhere"))
    | st.just(object()),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=4), inner, max_size=2),
    max_leaves=5,
)

quick = settings(max_examples=150, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
# What is asked for at last does not exist, so that nothing is ever made.
NEVER = {"maps": ["Atlantis"]}


@quick
@given(st.dictionaries(st.sampled_from(KEYS) | st.text(max_size=8), anything, max_size=4))
def test_recipes(recipe: dict[str, Any]) -> None:
    with pytest.raises((EndlessError, TypeError)):
        next(endless_city.stream(**{**recipe, **NEVER}) if _named(recipe) else endless_city.stream(**NEVER))


def _named(recipe: dict[str, Any]) -> bool:
    """Whether its keys are none of the function's own arguments."""
    return not recipe.keys() & {"config", "start", "threads", "buffer", "order", "cache", "memory", "shard"}


@quick
@given(anything, anything, anything, anything, anything)
def test_arguments(threads: Any, start: Any, buffer: Any, memory: Any, config: Any) -> None:
    with pytest.raises((EndlessError, TypeError)):
        next(
            endless_city.stream(
                threads=threads, start=start, buffer=buffer, memory=memory, config=config, **NEVER
            )
        )


@quick
@given(anything, anything, anything, anything)
def test_render(map: Any, camera: Any, at: Any, size: Any) -> None:
    with pytest.raises((EndlessError, TypeError)):
        endless_city.render(map=map, camera=camera, at=at, size=size, vehicles="none")


@quick
@given(anything)
def test_shards(shard: Any) -> None:
    if shard is not None:
        with pytest.raises((EndlessError, TypeError)):
            flags(shard=shard)
            endless_city.generate("nowhere", shard=shard, progress=False, **NEVER)


@quick
@given(anything, anything, anything, anything)
def test_datasets(out: Path, layers: Any, cameras: Any, videos: Any, index: Any) -> None:
    try:
        endless_city.Dataset(out, layers=layers, cameras=cameras, videos=videos)[index]
    except (EndlessError, TypeError, IndexError, ValueError):
        pass


@quick
@given(anything, anything, anything)
def test_the_native_reader(out: Path, camera: Any, frame: Any, layers: Any) -> None:
    reader = _native.DatasetReader(str(out), None, None)
    for call in (
        lambda: reader.load(camera, frame, layers),
        lambda: reader.load(0, frame, layers),
        lambda: reader.objects(camera, frame),
        lambda: reader.objects(0, frame),
        lambda: reader.moving_pose(camera, frame),
        lambda: reader.place(frame),
        lambda: reader.camera_json(camera),
    ):
        try:
            call()
        except (EndlessError, TypeError, IndexError, ValueError, OverflowError):
            pass


@quick
@given(anything)
def test_pictures(value: Any) -> None:
    with pytest.raises((EndlessError, TypeError, ValueError)):
        _native.encode_png(value)


def test_pictures_of_odd_shapes() -> None:
    for shape in ((0, 0, 3), (2, 2, 4), (2, 0, 3), (20_000, 1, 3)):
        with pytest.raises(EndlessError):
            _native.encode_png(np.zeros(shape, np.uint8))
    strided = np.zeros((8, 8, 3), np.uint8)[::-2, ::3]
    assert _native.encode_png(strided).startswith(b"\x89PNG")


def test_messages_say_what_to_do() -> None:
    for recipe, said in (
        ({"vidoes": 3}, "no option 'vidoes': use some of .*videos"),
        ({"videos": "three"}, "videos: .*Number of videos"),
        ({"size": (0, 5)}, "write WIDTHxHEIGHT"),
        ({"fps": float("nan")}, "no number"),
        ({"weathers": "hail"}, "use one of|unknown weather"),
    ):
        with pytest.raises(endless_city.RecipeError, match=said):
            next(endless_city.stream(**recipe))
    assert issubclass(endless_city.RecipeError, ValueError)
    assert recipe_json({"a": np.int64(3), "b": Path("x"), "c": (1, 2)}) == '{"a": 3, "b": "x", "c": [1, 2]}'
