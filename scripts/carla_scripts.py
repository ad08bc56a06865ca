#!/usr/bin/env python3
"""Runs CARLA's own scripts, unchanged, against `endless serve`, and prints a table: script, result, reason.

    python3 scripts/carla_scripts.py ENDLESS PYTHONAPI [--only NAME]... [--port PORT]

PYTHONAPI is the folder of that name in CARLA's repository at 0.9.16; nothing of it is part of this project. Needs CARLA's client
and what its scripts import: `pip install carla==0.9.16 numpy pillow pygame matplotlib psutil py-cpuinfo GPUtil`. Each script has a
server of its own. Those that run until somebody stops them are stopped after some seconds, and must have said by then what shows
that they work. The exit code is 1 if a script fails that CPU servers can be asked to run.
"""

import argparse
import dataclasses
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import time

from carla_server import Server

HERE = pathlib.Path(__file__).resolve().parent


@dataclasses.dataclass
class Script:
    """One of CARLA's scripts."""

    name: str
    args: tuple = ()
    # It is stopped after so many seconds, where it does not end by itself.
    stop_s: float = 0.0
    # What it prints when it works, if that is no matter of course.
    says: str = ""
    # What it prints when it does not, other than errors.
    never: str = ""
    # A script that must have run in the same server just before.
    after: "Script | None" = None
    map: str = "Town03"
    # Why it cannot pass, whoever serves.
    cannot: str = ""
    limit_s: float = 900.0


def smoke(name, **more):
    return Script(f"test/smoke/test_{name}.py", **more)


def example(name, *args, **more):
    return Script(f"examples/{name}.py", args, **more)


def util(name, *args, **more):
    return Script(f"util/{name}.py", args, **more)


RECORDING = example("start_recording", "-n", "5", "-t", "4", "-f", "carla_scripts.log", says="spawned 5 vehicles")
NO_GEODESY = "the client of 0.9.16 has none of the classes that it tests"
SEVEN = "the client's replay_file of 0.9.16 takes other arguments than the script gives"

SCRIPTS = [
    *map(smoke, ("client", "blueprint", "world", "map", "props_loading", "snapshot", "spawnpoints", "streamming", "sync")),
    *map(smoke, ("sensor_tick_time", "lidar", "determinism", "collision_determinism", "sensor_determinism")),
    smoke("collision_sensor"),
    smoke("vehicle_physics", cannot="four of its tests drive where our Town05 has grass, kerbs and walls"),
    smoke("geoconversion", cannot=NO_GEODESY),
    example("generate_traffic", "-n", "20", "-w", "10", stop_s=20, says="spawned 20 vehicles and .. walkers", never="ERROR"),
    example("sensor_synchronization", stop_s=30, says=r"Sensor: radar02"),
    example("tutorial", says="done", limit_s=60),
    example("synchronous_mode", stop_s=20, says="done"),
    example("client_bounding_boxes", stop_s=20, says="EXIT"),
    example("lidar_to_camera", "-f", "20"),
    example("open3d_lidar", stop_s=20, says=r"(FPS.*\s+){20}"),
    example("open3d_lidar", "--semantic", stop_s=20, says=r"(FPS.*\s+){20}"),
    example("dynamic_weather", stop_s=10, says="Storm"),
    example("vehicle_physics", says="Adding a Force"),
    example("bounding_boxes", "--res", "640x360", stop_s=40, says="done"),
    RECORDING,
    example("start_replaying", "-f", "carla_scripts.log", after=RECORDING, says="Replaying", cannot=SEVEN),
    example("show_recorder_actors_blocked", "-f", "carla_scripts.log", after=RECORDING),
    util("config", "--inspect", says="weather"),
    util("config", "--list", says="Town01"),
    util("config", "--map", "Town02", "--weather", "ClearNoon", "--fps", "20", says="load map"),
    util("config", "--list-blueprints", "vehicle.*", says="vehicle.tesla.model3"),
    util("test_connection", says="connected"),
    util("performance_benchmark", "--maps", "Town02", "--ticks", "10", "--sensors", "0", "4", "--weather", "0", says="fps_mean"),
    util("check_map"),
    util("environment", "--sun", "sunset", "--weather", "rain"),
    util("extract_spawn_points", "-o", "."),
    util("check_lidar_bb", limit_s=600),
]


def launch(python, port, api, script, work):
    """Runs it; gives its exit code and all that it said."""
    path = api / script.name
    what = [api / "test", f"smoke.{path.stem}"] if script.name.startswith("test/") else [path, *script.args]
    command = [python, HERE / "carla_launch.py", str(port), str(script.stop_s), *what]
    env = {**os.environ, "SDL_VIDEODRIVER": "dummy", "SDL_AUDIODRIVER": "dummy", "MPLBACKEND": "Agg", "PYTHONUNBUFFERED": "1", "PYTHONFAULTHANDLER": "1"}
    run = subprocess.Popen(
        list(map(str, command)), cwd=work, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, errors="replace"
    )
    try:
        said, _ = run.communicate(timeout=script.limit_s)
    except subprocess.TimeoutExpired:
        run.send_signal(signal.SIGKILL)
        said, _ = run.communicate()
        return 124, said
    return run.returncode, said


def fault(script, code, said):
    """Why it failed; nothing if it passed."""
    if code == 124:
        return f"does not end within {script.limit_s:.0f} s"
    if code == -signal.SIGABRT and script.stop_s and "already destroyed" in said:
        # Stopped, it takes its vehicles away while the client's TrafficManager still looks at them.
        said, code = said[: said.index("terminate called")], 0
    errors = [line.strip() for line in said.splitlines() if re.match(r"\S*(Error|Exception|Empty)\b", line.strip())]
    if script.name.startswith("test/"):
        ran = re.search(r"Ran (\d+) tests?", said)
        if code == 0 and ran and int(ran[1]) > 0:
            return ""
        tests = re.findall(r"^(?:FAIL|ERROR): (\w+)", said, re.M)
        return f"of {ran[1] if ran else '?'} tests fail: {', '.join(tests)}: {errors[:1]}"
    interrupted = "KeyboardInterrupt" in said and script.stop_s > 0
    if errors:
        return errors[-1]
    if code != 0 and not interrupted:
        return f"exit code {code}: {said[-200:]}"
    if script.never and re.search(script.never, said):
        return f"says {re.search(script.never, said)[0]!r}"
    if script.says and not re.search(script.says, said, re.I):
        return f"does not say {script.says!r}"
    return ""


def run(script, args):
    """Runs it in a server of its own; gives the result, the reason and how long it took."""
    with tempfile.TemporaryDirectory() as work, open(args.log or os.devnull, "a", encoding="utf-8") as log:
        with Server(args.endless, script.map, args.port, ["--recordings", work], log):
            began = time.monotonic()
            if script.after:
                launch(sys.executable, args.port, args.api, script.after, work)
            code, said = launch(sys.executable, args.port, args.api, script, work)
            took_s = time.monotonic() - began
        log.write(f"==== {script.name} {' '.join(script.args)}: exit code {code}\n{said}\n")
    why = fault(script, code, said)
    if not why:
        return "passes", "", took_s
    return ("no", script.cannot, took_s) if script.cannot else ("FAILS", why, took_s)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("endless")
    parser.add_argument("api", type=lambda folder: pathlib.Path(folder).resolve())
    parser.add_argument("--only", action="append", default=[], help="those whose name holds this")
    parser.add_argument("--port", type=int, default=27400)
    parser.add_argument("--log", help="file to which all that scripts and servers say is added")
    args = parser.parse_args()
    failed = 0
    print("| script | result | |\n|---|---|---|", flush=True)
    for script in SCRIPTS:
        if args.only and not any(name in script.name for name in args.only):
            continue
        result, why, took_s = run(script, args)
        failed += result == "FAILS"
        title = " ".join([script.name, *script.args])
        print(f"| {title} | {result} ({took_s:.0f} s) | {why[:300]} |", flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
