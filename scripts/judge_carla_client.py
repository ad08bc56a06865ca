#!/usr/bin/env python3
"""Judges what `endless generate --simulator carla://…` makes of `endless serve`, and what it leaves there.

    python3 scripts/judge_carla_client.py path/to/endless

Needs the official client (`pip install carla==0.9.16 numpy pillow`). Two datasets: vehicles are driven by our traffic, then by
the official client's TrafficManager. Each must pass `endless check` and check_dataset.py; vehicles must have moved; nobody
whom it spawned may be left, and the server must have its settings back.
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

import carla

from carla_server import Server
from ports import free_port
from judge_carla import check

SCRIPTS = pathlib.Path(__file__).resolve().parent
MAP = "Town02"
RECIPE = ["--maps", MAP, "--videos", "1", "--size", "160x96", "--fps", "10", "--duration", "3", "--vehicles", "60",
          "--pedestrians", "10", "--min-pixels", "10", "--times", "morning"]


def run(*command):
    code = subprocess.run([str(part) for part in command]).returncode
    check(code == 0, f"{' '.join(str(part) for part in command)} ended with {code}")


def longest_way_m(out):
    """How far the vehicle came that moved most, between its first and its last frame in one camera."""
    ways = [0.0]
    for path in out.glob("videos/*/camera_*/objects.jsonl"):
        places = {}
        for line in map(json.loads, path.read_text().splitlines()):
            for o in line["objects"]:
                if o["class"] not in ("pedestrian", "rider") and not o.get("parked"):
                    places.setdefault(o["id"], []).append(o["position"])
        ways += [math.dist(way[0], way[-1]) for way in places.values()]
    return max(ways)


def is_as_before(port, settings):
    client = carla.Client("127.0.0.1", port)
    client.set_timeout(60)
    world = client.get_world()
    world.wait_for_tick()
    left = [actor.type_id for actor in world.get_actors() if actor.type_id.split(".")[0] in ("vehicle", "walker", "sensor")]
    check(not left, f"left behind: {left}")
    check(world.get_settings() == settings, "the server has other settings than before")


def main():
    endless = sys.argv[1]
    with tempfile.TemporaryDirectory() as work, Server(endless, MAP) as server:
        client = carla.Client("127.0.0.1", server.port)
        client.set_timeout(60)
        settings = client.get_world().get_settings()
        del client
        simulator = ["--simulator", f"carla://127.0.0.1:{server.port}"]
        for name, flags in (("own", []), ("managed", ["--traffic-manager", f"127.0.0.1:{free_port()}"])):
            manager = None
            if flags:
                port = flags[1].split(":")[1]
                script = [sys.executable, str(SCRIPTS / "traffic_manager.py"), "--port", str(server.port), "--tm-port", port]
                manager = subprocess.Popen(script)
            try:
                out = pathlib.Path(work) / name
                run(endless, "generate", out, *simulator, *flags, *RECIPE)
            finally:
                if manager is not None:
                    manager.terminate()
                    manager.wait()
            run(endless, "check", out)
            run(sys.executable, SCRIPTS / "check_dataset.py", out)
            way = longest_way_m(out)
            check(way > 2, f"{name}: no vehicle moved more than {way:.1f} m")
            is_as_before(server.port, settings)
            print(f"{name} traffic: the dataset is sound, a vehicle came {way:.0f} m, and nobody is left")


if __name__ == "__main__":
    main()
