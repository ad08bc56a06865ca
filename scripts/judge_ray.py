#!/usr/bin/env python3
"""Makes a dataset on a cluster of Ray's that loses a machine, and compares it with that of one machine.

    pip install "ray[data]" .
    python3 scripts/judge_ray.py [--videos 6]

The cluster is real (`ray.cluster_utils.Cluster`): a head and two more raylets on this machine. One of them is killed when the
first videos are there. The bytes must be those of a run without Ray, and so must the rows of `endless_city.ray.dataset`.
"""

import argparse
import hashlib
import json
import pathlib
import signal
import subprocess
import sys
import tempfile
import threading
import time

import numpy as np
import ray
from ray.cluster_utils import Cluster

import endless_city
import endless_city.ray
from endless_city.errors import RecipeError

RECIPE = {"size": "160x90", "fps": 5, "duration": 1.0, "maps": ["Town01", "Town02"], "seed": 7, "min_pixels": 10}


def digests(folder: pathlib.Path) -> dict[str, str]:
    files = (path for path in sorted(folder.rglob("*")) if path.is_file())
    return {str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}


def judge_generate(cluster: Cluster, victim: object, recipe: dict, alone: pathlib.Path, out: pathlib.Path) -> None:
    lost = threading.Event()

    def lose_a_machine() -> None:
        # In the middle: something is complete, and not all.
        while len(list(out.glob("videos/*/scene.json"))) < 1:
            time.sleep(0.05)
        cluster.remove_node(victim, allow_graceful=False)
        lost.set()

    threading.Thread(target=lose_a_machine, daemon=True).start()
    endless_city.ray.generate(recipe, out, shards=recipe["videos"], retries=8)
    assert lost.is_set(), "it was done before a machine was lost"
    expected, found = digests(alone), digests(out)
    different = sorted(name for name in expected.keys() | found.keys() if expected.get(name) != found.get(name))
    assert not different, f"not as on one machine: {different[:5]}"
    print(f"generate: {len(found)} files as on one machine, although one of two was lost")


def judge_dataset(recipe: dict, alone: pathlib.Path) -> None:
    there = endless_city.Dataset(alone)
    expected = {(frame.video, frame.camera.name, frame.frame): frame for frame in there}
    rows = endless_city.ray.dataset(recipe, shards=3)
    assert {"video", "camera", "frame", "rgb", "depth", "boxes", "objects"} <= set(rows.schema().names), rows.schema()
    seen = 0
    for row in rows.iter_rows():
        frame = expected.pop((row["video"], row["camera"], row["frame"]))
        for layer in ["rgb", "depth", "instance"]:
            assert np.array_equal(row[layer], getattr(frame, layer)), (frame, layer)
        folder = alone / "videos" / row["video"] / row["camera"]
        line = (folder / "objects.jsonl").read_text().splitlines()[row["frame"]]
        assert row["objects"] == line and len(row["boxes"]) == len(json.loads(line)["objects"])
        seen += 1
    assert not expected, f"{len(expected)} frames are missing"
    print(f"dataset: {seen} rows as on the disk")


def judge_errors(recipe: dict, folder: pathlib.Path) -> None:
    try:
        endless_city.ray.generate({**recipe, "weathers": ["hail"]}, folder / "refused", shards=1, progress=False)
    except RecipeError as error:
        print(f"errors: {error}")
    else:
        raise AssertionError("a recipe that cannot be was made")


def judge_interrupt(address: str, recipe: dict, folder: pathlib.Path) -> None:
    # Programs that a shell runs in its background ignore it.
    program = (
        "import signal; signal.signal(signal.SIGINT, signal.default_int_handler);"
        f"import ray, endless_city.ray as r; ray.init(address={address!r}); r.generate({recipe!r}, {str(folder)!r})"
    )
    run = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    while not list(folder.glob("videos/*/builds.json")):
        assert run.poll() is None, run.stderr.read()
        time.sleep(0.05)
    run.send_signal(signal.SIGINT)
    begin = time.monotonic()
    _, said = run.communicate(timeout=60)
    assert run.returncode != 0 and "KeyboardInterrupt" in said, said
    print(f"Ctrl-C: ended after {time.monotonic() - begin:.1f} s")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--videos", type=int, default=6)
    recipe = {**RECIPE, "videos": parser.parse_args().videos}
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        endless_city.generate(folder / "alone", progress=False, **recipe)
        # The head has no room for tasks, so that none of them is where the driver is.
        cluster = Cluster(initialize_head=True, head_node_args={"num_cpus": 0, "include_dashboard": False})
        machines = [cluster.add_node(num_cpus=1) for _ in range(2)]
        ray.init(address=cluster.address, log_to_driver=False)
        try:
            judge_errors(recipe, folder)
            judge_generate(cluster, machines[1], recipe, folder / "alone", folder / "out")
            judge_dataset(recipe, folder / "alone")
            judge_interrupt(cluster.address, recipe, folder / "interrupted")
        finally:
            ray.shutdown()
            cluster.shutdown()


if __name__ == "__main__":
    main()
