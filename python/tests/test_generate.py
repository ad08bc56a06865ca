"""Making datasets, frames and streams."""

from __future__ import annotations

import filecmp
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import endless_city
from endless_city import DatasetError, EndlessError, RecipeError

from conftest import RECIPE

SMALL = {**RECIPE, "layers": ["rgb", "instance"], "videos": 1}


def files(folder: Path) -> dict[str, Path]:
    found = {str(path.relative_to(folder)): path for path in folder.rglob("*") if path.is_file()}
    return {name: path for name, path in found.items() if path.name != ".lock"}


def assert_same(one: Path, other: Path) -> None:
    assert files(one).keys() == files(other).keys()
    assert all(filecmp.cmp(path, files(other)[name], shallow=False) for name, path in files(one).items())


def test_a_complete_dataset_is_left_alone(out: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert endless_city.generate(out, **RECIPE).videos == 0
    with pytest.raises(DatasetError, match="another recipe"):
        endless_city.generate(out, **{**RECIPE, "seed": 4})
    assert "Traceback" not in capsys.readouterr().err


def test_the_program_makes_the_same(out: Path, tmp_path: Path) -> None:
    options = [f"--{key.replace('_', '-')}={text(value)}" for key, value in RECIPE.items()]
    program = [sys.executable, "-m", "endless_city", "generate", str(tmp_path / "out"), *options]
    subprocess.run(program, check=True, capture_output=True)
    assert_same(out, tmp_path / "out")
    subprocess.run([sys.executable, "-m", "endless_city", "check", str(out)], check=True, capture_output=True)


def text(value: object) -> str:
    if isinstance(value, tuple):
        return "x".join(map(str, value))
    return (",".join(value) or "none") if isinstance(value, list) else str(value)


def test_the_program_has_its_exit_codes() -> None:
    program = [sys.executable, "-m", "endless_city"]
    assert subprocess.run([*program, "--version"], capture_output=True).stdout.startswith(b"endless ")
    wrong = subprocess.run([*program, "generate"], capture_output=True, text=True)
    assert wrong.returncode == 2 and len(wrong.stderr.splitlines()) == 1


def test_a_bar_is_shown(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    endless_city.generate(tmp_path / "out", **{**SMALL, "duration": 0.2})
    said = capsys.readouterr().err
    assert "loading Town01" in said and "2/2 camera frames" in said
    endless_city.generate(tmp_path / "quiet", progress=False, **{**SMALL, "duration": 0.2})
    assert capsys.readouterr().err == ""


def test_a_file_of_options_is_read(tmp_path: Path) -> None:
    config = tmp_path / "recipe.toml"
    config.write_text('videos = 1\nmaps = ["Town01"]\nsize = "64x48"\nfps = 5\nduration = 0.4\n')
    endless_city.generate(tmp_path / "out", config=config, progress=False, duration=0.2)
    recipe = endless_city.Dataset(tmp_path / "out").recipe
    assert (recipe["size"], recipe["duration"]) == ("64x48", 0.2)


CHILD = """
import signal, sys, endless_city
# Programs that a shell runs in its background ignore it.
signal.signal(signal.SIGINT, signal.default_int_handler)
print("ready", flush=True)
try:
    endless_city.generate(sys.argv[1], videos=2, maps="Town01", size=(320, 180), fps=10, duration=60, mp4="none", seed=1)
except KeyboardInterrupt:
    sys.exit(77)
"""


@pytest.mark.skipif(os.name != "posix", reason="signals of POSIX")
@pytest.mark.parametrize("wanted", ["", "videos/*/builds.json", "videos/*/camera_a/rgb/000002.png"])
def test_ctrl_c_stops_in_every_stage_of_the_work(tmp_path: Path, wanted: str) -> None:
    out = tmp_path / "out"
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.DEVNULL}
    child = subprocess.Popen([sys.executable, "-c", CHILD, str(out)], **pipes)
    assert child.stdout is not None and child.stdout.readline() == b"ready\n"
    while wanted and not list(out.glob(wanted)):
        assert child.poll() is None
        time.sleep(0.01)
    child.send_signal(signal.SIGINT)
    # It is caught where the work is called, so that it is raised there and not by the interpreter's end.
    assert child.wait(60) in ((77,) if wanted else (77, -signal.SIGINT, 1, 130))


def test_a_stopped_call_is_resumed(tmp_path: Path) -> None:
    recipe = {**SMALL, "duration": 2.0}
    whole, stopped = tmp_path / "whole", tmp_path / "stopped"
    endless_city.generate(whole, progress=False, **recipe)

    class Stop(Exception):
        pass

    def stop(lines: list[str], done: int, total: int) -> None:
        if done >= 6:
            raise Stop

    from endless_city._recipe import recipe_json

    with pytest.raises(Stop):
        endless_city._native.generate(str(stopped), recipe_json(recipe), [], stop)
    assert endless_city.generate(stopped, progress=False, **recipe).videos == 1
    assert_same(whole, stopped)


def test_one_frame_is_that_of_a_video() -> None:
    frame = endless_city.render(map="Town01", weather="rainy", time="night", size=(96, 54), seed=5)
    assert frame.rgb.shape == (54, 96, 3) and frame.depth.shape == (54, 96)
    camera = frame.camera.site
    again = endless_city.render(map="Town01", camera=camera, weather="rainy", time="night", size=(96, 54), seed=5)
    assert again.camera.site == camera and frame.video == "0000_Town01_rainy_night"
    shown = frame._repr_png_()
    assert shown is not None and shown.startswith(b"\x89PNG")
    for wrong in ({"map": "Atlantis"}, {"map": "Town01", "camera": "none"}, {"weather": "hail"}, {"time": "noon"}):
        with pytest.raises(RecipeError, match="use one of"):
            endless_city.render(size=(96, 54), **wrong)


def test_streamed_frames_are_those_of_the_dataset(out: Path) -> None:
    dataset = endless_city.Dataset(out)
    of = {(frame.video, frame.camera.name, frame.frame): frame for frame in dataset}
    with endless_city.stream(**RECIPE, threads=2) as frames:
        streamed = list(frames)
    assert [frame.index for frame in streamed] == list(range(8))
    for frame in streamed:
        for view in frame.cameras:
            stored = of.pop((view.video, view.camera.name, view.frame))
            assert view.objects.line == stored.objects.line
            assert view.layers == stored.layers == endless_city.LAYERS
            assert view.camera.record == stored.camera.record
            ours, theirs = view.load(), stored.load()
            assert ours.keys() == theirs.keys()
            for name, array in ours.items():
                assert array.dtype == theirs[name].dtype and np.array_equal(array, theirs[name]), name
            for name in ("ids", "class_ids", "boxes", "visibility", "keypoints", "positions_m"):
                column = getattr(stored.objects, name)
                assert np.array_equal(getattr(view.objects, name), column, equal_nan=True)
        assert frame.scene is not None and frame.scene["frame"] == frame.frame
    assert not of


def test_a_stream_goes_on_where_it_is_told(out: Path) -> None:
    with endless_city.stream(**SMALL, start=2) as frames:
        first = next(frames)
        assert (first.index, first.frame) == (2, 2)
        assert [frame.index for frame in frames] == [3]
    with endless_city.stream(**SMALL, start=99) as frames:
        assert list(frames) == []


def test_a_stream_is_stopped() -> None:
    frames = endless_city.stream(**{**SMALL, "duration": 100.0}, buffer=1)
    next(frames)
    start = time.monotonic()
    frames.close()
    frames.close()
    assert list(frames) == [] and time.monotonic() - start < 1
    forgotten = endless_city.stream(**{**SMALL, "duration": 100.0})
    next(forgotten)
    del forgotten


def test_a_stream_does_not_survive_a_fork() -> None:
    if not hasattr(os, "fork"):
        pytest.skip("this system has no fork")
    with endless_city.stream(**SMALL) as frames:
        next(frames)
        child = os.fork()
        if child == 0:
            try:
                next(frames)
            except EndlessError:
                os._exit(0)
            os._exit(1)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0


def test_errors_of_a_stream_are_raised() -> None:
    with pytest.raises(RecipeError, match="use one of"):
        next(endless_city.stream(maps="Atlantis"))
    for wrong in ({"start": -1}, {"buffer": 0}, {"order": "chance"}, {"threads": 0}, {"memory": "much"}):
        with pytest.raises(RecipeError):
            endless_city.stream(**wrong)


def test_the_catalogue_is_told() -> None:
    towns = endless_city.maps()
    assert "Town01" in {town.name for town in towns} and all(town.cameras for town in towns if not town.imported)
    assert {asset.kind for asset in endless_city.assets()} >= {"car", "pedestrian", "plant", "furniture"}
    assert {option.name for option in endless_city.options()} >= {"videos", "maps", "size", "seed"}
    assert endless_city.classes()[0] == "car" and endless_city.tags()[12] == "Pedestrians"
    assert towns[0].preview().ndim == 3
