#!/usr/bin/env python3
"""Runs ScenarioRunner's own scenarios, unchanged, against `endless serve`, and prints a table: scenario, result, reason.

    python3 scripts/carla_scenarios.py ENDLESS SCENARIO_RUNNER AGENTS [--only TYPE]... [--port PORT]

SCENARIO_RUNNER is a checkout of carla-simulator/scenario_runner at 0.9.16 and AGENTS the folder in which CARLA's repository has
`agents` (`PythonAPI/carla`); needs what the former's requirements.txt names. Its examples begin at places of CARLA's towns, whose
streets are not those of ours: here each begins at a place of our town that its type can mean, and `carla_hero.py` drives. A
scenario passes if it runs to its end and ScenarioRunner writes down its verdict; what the hero does is not the server's matter.
"""

import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

import carla

from carla_server import Server

HERE = pathlib.Path(__file__).resolve().parent
# Metres before a junction at which each type begins.
BEFORE_M = {
    "FollowLeadingVehicle": (60, 150),
    "FollowLeadingVehicleWithObstacle": (60, 150),
    "ControlLoss": (60, 150),
    "OtherLeadingVehicle": (60, 150),
    "StationaryObjectCrossing": (60, 150),
    "DynamicObjectCrossing": (60, 150),
    "VehicleTurningRight": (30, 60),
    "VehicleTurningLeft": (30, 60),
    "OppositeVehicleRunningRedLight": (30, 60),
    "SignalizedJunctionLeftTurn": (30, 60),
    "SignalizedJunctionRightTurn": (30, 60),
}


def to_junction(waypoint, most=160.0):
    """Metres along the lane until the next junction."""
    gone = 0.0
    while gone < most:
        following = waypoint.next(2.0)
        if not following:
            return None
        waypoint, gone = following[0], gone + 2.0
        if waypoint.is_junction:
            return gone
    return None


def place(roads, world, kind):
    """Where a scenario of this type may begin."""
    low, high = BEFORE_M[kind]
    lights = world.get_actors().filter("traffic.traffic_light")
    for point in roads.get_spawn_points():
        waypoint = roads.get_waypoint(point.location)
        gone = to_junction(waypoint)
        if gone is None or not low <= gone <= high:
            continue
        end = waypoint.next(gone)[0].transform.location
        signalised = any(light.get_location().distance(end) < 30 for light in lights)
        two_lanes = waypoint.get_left_lane() is not None and waypoint.get_left_lane().lane_id * waypoint.lane_id > 0
        if ("Light" in kind or "Signalized" in kind) and not signalised:
            continue
        if kind == "OtherLeadingVehicle" and not two_lanes:
            continue
        return point
    return None


def config(point, kind, town):
    place, yaw = point.location, point.rotation.yaw
    ego = f'<ego_vehicle x="{place.x:.3f}" y="{place.y:.3f}" z="{place.z:.3f}" yaw="{yaw:.3f}" model="vehicle.lincoln.mkz_2017"/>'
    return f'<?xml version="1.0"?><scenarios><scenario name="{kind}_here" type="{kind}" town="{town}">{ego}</scenario></scenarios>'


def run(kind, args, work):
    """The result and the reason."""
    with open(args.log or os.devnull, "a", encoding="utf-8") as log:
        with Server(args.endless, args.map, args.port, ["--recordings", work], log):
            client = carla.Client("127.0.0.1", args.port)
            client.set_timeout(60.0)
            world = client.get_world()
            point = place(world.get_map(), world, kind)
            if point is None:
                return "no", f"{args.map} has no place for it"
            file = pathlib.Path(work) / f"{kind}.xml"
            file.write_text(config(point, kind, args.map), encoding="utf-8")
            env = {**os.environ, "SCENARIO_RUNNER_ROOT": str(args.runner), "PYTHONUNBUFFERED": "1"}
            env["PYTHONPATH"] = os.pathsep.join([str(args.runner), str(args.agents)])
            command = [sys.executable, args.runner / "scenario_runner.py", "--port", args.port, "--timeout", 30, "--sync"]
            command += ["--scenario", f"{kind}_here", "--configFile", file, "--output", "--reloadWorld"]
            command += ["--trafficManagerPort", args.port + 100]
            hero = subprocess.Popen([sys.executable, HERE / "carla_hero.py", str(args.port)])
            try:
                ran = subprocess.run(list(map(str, command)), env=env, cwd=work, text=True, errors="replace",
                                     stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=args.limit)
            except subprocess.TimeoutExpired as late:
                log.write(str(late.stdout))
                return "FAILS", f"does not end within {args.limit} s"
            finally:
                hero.kill()
                hero.wait()
            log.write(f"==== {kind}: exit code {ran.returncode}\n{ran.stdout}\n")
    verdict = re.search(r"Results of Scenario: \w+ -+ (\w+)", ran.stdout)
    errors = [line for line in ran.stdout.splitlines() if re.match(r"\S*(Error|Exception)\b", line)]
    if verdict is None:
        return "FAILS", (errors or ran.stdout.splitlines()[-1:] or ["says nothing"])[-1]
    criteria = re.findall(r"│\s*(\w+)[^│]*│\s*FAILURE", ran.stdout)
    return "passes", f"verdict on the hero: {' '.join([verdict[1], *criteria])}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("endless")
    parser.add_argument("runner", type=lambda folder: pathlib.Path(folder).resolve())
    parser.add_argument("agents", type=lambda folder: pathlib.Path(folder).resolve())
    parser.add_argument("--only", action="append", default=[])
    parser.add_argument("--map", default="Town03")
    parser.add_argument("--port", type=int, default=27500)
    parser.add_argument("--limit", type=float, default=300.0, help="seconds that a scenario may take")
    parser.add_argument("--log", help="file to which all that is said is added")
    args = parser.parse_args()
    failed = 0
    print("| scenario | result | |\n|---|---|---|", flush=True)
    with tempfile.TemporaryDirectory() as work:
        for kind in BEFORE_M:
            if args.only and kind not in args.only:
                continue
            result, why = run(kind, args, work)
            failed += result == "FAILS"
            print(f"| {kind} | {result} | {why} |", flush=True)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
