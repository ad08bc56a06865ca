#!/usr/bin/env python3
"""Films what SUMO simulates on a town of ours, and compares where everybody is in the labels with where SUMO has them.

    cargo build --release -p endless
    python3 scripts/judge_clone.py target/release/endless [--town Town03] [--keep FOLDER]

Needs the `eclipse-sumo` wheel. The town is exported as OpenDRIVE, netconvert makes a net of it, randomTrips.py trips of cars,
trucks, buses, motorcycles, bicycles and people, and sumo writes FCD ten times a second. Eight cameras film three seconds at 15
frames a second, so that two frames in three lie between time steps.
"""

import argparse
import collections
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ET

LIMIT_M = 0.05
FPS, SECONDS, STEP_S, BEGIN_S = 15, 3, 0.1, 60
# SUMO's vehicle class, and seconds between two of it.
TRIPS = [("passenger", 1.0), ("truck", 9.0), ("bus", 12.0), ("motorcycle", 8.0), ("bicycle", 6.0), ("pedestrian", 2.0)]


def sumo_home() -> pathlib.Path:
    import sumo  # the wheel's package

    return pathlib.Path(sumo.SUMO_HOME)


def run(*command, **more) -> None:
    done = subprocess.run(list(map(str, command)), capture_output=True, text=True, **more)
    if done.returncode != 0:
        sys.exit(f"{command[0]} ended with {done.returncode}\n{done.stdout[-2000:]}{done.stderr[-2000:]}")


def simulate(endless: pathlib.Path, town: str, work: pathlib.Path):
    """The FCD file, and where the map's origin is in it."""
    home = sumo_home()
    environment = {**os.environ, "SUMO_HOME": str(home)}
    run(endless, "maps", "export", town, "--opendrive", work / "town.xodr")
    run(home / "bin/netconvert", "--opendrive-files", work / "town.xodr", "-o", work / "town.net.xml",
        "--opendrive.import-all-lanes", "true", "--crossings.guess", "true", env=environment)
    offset = ET.parse(work / "town.net.xml").getroot().find("location").get("netOffset")
    routes = []
    for name, period in TRIPS:
        trips = work / f"{name}.trips.xml"
        kind = ["--pedestrians"] if name == "pedestrian" else ["--vehicle-class", name, "--prefix", name]
        run(sys.executable, home / "tools/randomTrips.py", "-n", work / "town.net.xml", "-o", trips, "-r", work / f"{name}.rou.xml",
            "-e", BEGIN_S + 10, "-p", period, "--seed", 7, *kind, env=environment)
        routes.append(str(trips))
    run(home / "bin/sumo", "-n", work / "town.net.xml", "-r", ",".join(routes), "--step-length", STEP_S, "--fcd-output", work / "fcd.xml",
        "-e", BEGIN_S + SECONDS + 2, "--ignore-route-errors", "--no-step-log", "--no-warnings", "--seed", 7, env=environment)
    return work / "fcd.xml", tuple(map(float, offset.split(",")))


def read_fcd(path, offset):
    """By time step, in tenths of a second: place and kind of each id."""
    steps = {}
    for _, step in ET.iterparse(path):
        if step.tag != "timestep":
            continue
        time_s = float(step.get("time"))
        if BEGIN_S - 1 < time_s < BEGIN_S + SECONDS + 1:
            steps[round(time_s * 10)] = {
                actor.get("id"): (float(actor.get("x")) - offset[0], float(actor.get("y")) - offset[1], actor.tag)
                for actor in step if actor.tag in ("vehicle", "person")}
        step.clear()
    return steps


def told(steps, name, time_s):
    """Where the file has somebody: on a straight line between time steps."""
    step = math.floor(time_s * 10 + 1e-6)
    share = time_s * 10 - step
    begin, end = steps[step].get(name), steps[step + 1].get(name)
    if abs(share) < 1e-6:
        return begin and begin[:2]
    return begin and end and tuple(a + (b - a) * share for a, b in zip(begin[:2], end[:2]))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("endless", type=pathlib.Path)
    parser.add_argument("--town", default="Town03")
    parser.add_argument("--keep", type=pathlib.Path, help="leave all files in this folder")
    args = parser.parse_args()
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        work = args.keep or pathlib.Path(folder)
        work.mkdir(parents=True, exist_ok=True)
        fcd, offset = simulate(args.endless.resolve(), args.town, work)
        steps = read_fcd(fcd, offset)
        out = work / "out"
        run(args.endless.resolve(), "generate", out, "--maps", args.town, "--traffic", fcd, "--traffic-offset", "{},{}".format(*offset),
            "--traffic-begin", BEGIN_S, "--fps", FPS, "--duration", SECONDS, "--videos", 1, "--size", "640x360", "--cameras-per-scene", 8,
            "--min-pixels", 1, "--mp4", "none", "--weathers", "cloudy", "--times", "afternoon")
        video = next((out / "videos").iterdir())
        actors = {actor["id"]: actor for actor in json.loads((video / "actors.json").read_text())}
        off, tracks, absent = collections.defaultdict(list), collections.defaultdict(set), []
        for file in sorted(video.glob("camera_*/objects.jsonl")):
            for line in map(json.loads, file.read_text().splitlines()):
                for seen in line["objects"]:
                    actor = actors[seen["id"]]
                    if actor.get("track") is None or actor.get("vehicle_id") is not None:
                        continue
                    place = told(steps, actor["track"], BEGIN_S + line["frame"] / FPS)
                    if place is None:
                        absent.append((actor["track"], line["frame"]))
                        continue
                    # FCD tells of a vehicle's front bumper, and of a person's middle.
                    half = 0.5 * actor["vehicle"]["size"][0] if actor.get("vehicle") else 0.0
                    x, y = seen["position"][:2]
                    front = (x + half * math.cos(seen["yaw_rad"]), y + half * math.sin(seen["yaw_rad"]))
                    off[seen["class"]].append(math.dist(front, place))
                    tracks[seen["class"]].add(actor["track"])
    for name in sorted(off):
        print(f"{name:12} {len(off[name]):6} boxes of {len(tracks[name]):3} tracks, at most {100 * max(off[name]):.2f} cm off")
    everything = [x for of in off.values() for x in of]
    print(f"{args.town}: {len(everything)} boxes of {sum(map(len, tracks.values()))} tracks, at most {100 * max(everything):.2f} cm off, in "
          f"{time.monotonic() - start:.0f} s")
    assert not absent, f"not in the file at these frames: {absent[:5]}"
    assert len(everything) > 300 and max(everything) < LIMIT_M


if __name__ == "__main__":
    main()
