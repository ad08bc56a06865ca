#!/usr/bin/env python3
"""Times `endless generate --simulator carla://…` against plain `endless generate`, of one scene on one machine.

    python3 scripts/bench_carla_client.py path/to/endless [--map Town03] [--pairs 5] [--duration 5]

First the client records a video of a map from two of its cameras. Then plain `endless generate` films with the same cameras what
was seen to move (`--traffic`), and the client records again, in turn. Prints the camera frames a second of each while recording,
their medians and the median ratio. Loading and baking are left out on both sides.
"""

import argparse
import csv
import json
import math
import pathlib
import re
import shutil
import statistics
import subprocess
import tempfile

from carla_server import Server


def generate(program, out, *flags):
    """Camera frames a second while it recorded."""
    command = [program, "generate", out, *flags]
    said = subprocess.run(list(map(str, command)), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=True)
    rate = re.search(r"\(([\d.]+) camera frames a second while recording\)", said.stdout)
    return float(rate[1]) if rate else None


def cameras(plan, town):
    """Those of a planned scene, as a list that a recipe takes."""
    scene = json.loads((plan / "scenes" / "0000.json").read_text())
    degrees = {"yaw": "yaw_rad", "down": "down_tilt_rad", "fov": "horizontal_fov_rad"}
    angles = [{name: math.degrees(camera[field]) for name, field in degrees.items()} for camera in scene["cameras"]]
    places = [{"map": town, "name": camera["name"], "position": camera["position"]} for camera in scene["cameras"]]
    return {"cameras": [{**place, **angle} for place, angle in zip(places, angles)]}


def tracks(dataset):
    """Who moves in a dataset's first video: lines of a file of tracks. Riders move with what they ride."""
    seen = {}
    for path in dataset.glob("videos/*/camera_*/objects.jsonl"):
        for line in map(json.loads, path.read_text().splitlines()):
            for o in line["objects"]:
                if not o.get("parked") and o["class"] != "rider":
                    length = o["box3d"]["size"][0]
                    seen[line["time_s"], o["id"]] = [line["time_s"], o["id"], o["class"], *o["position"], o["yaw_rad"], length]
    return [seen[key] for key in sorted(seen)]


def moving_pixels(dataset):
    """Of a picture, on average."""
    lines = [json.loads(line) for path in dataset.glob("videos/*/camera_*/objects.jsonl") for line in path.open()]
    return sum(o["pixels"] for line in lines for o in line["objects"] if not o.get("parked")) / len(lines)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--map", default="Town03")
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--duration", type=float, default=5)
    args = parser.parse_args()
    recipe = ["--maps", args.map, "--videos", "1", "--weathers", "clear_sky", "--times", "afternoon"]
    with tempfile.TemporaryDirectory() as work, Server(args.program, args.map) as server:
        work = pathlib.Path(work)
        generate(args.program, work / "plan", *recipe, "--plan-only")
        (work / "cameras.json").write_text(json.dumps(cameras(work / "plan", args.map)))
        recipe += ["--cameras", work / "cameras.json", "--duration", args.duration]
        carla = ["--simulator", f"carla://127.0.0.1:{server.port}"]
        generate(args.program, work / "first", *recipe, *carla)
        with open(work / "tracks.csv", "w", newline="") as file:
            csv.writer(file).writerows([["time", "id", "class", "x", "y", "z", "yaw", "length"], *tracks(work / "first")])
        ways = {"built in": ["--traffic", work / "tracks.csv", "--traffic-begin", "0"], "carla": carla}
        rates = {name: [] for name in ways}
        for pair in range(args.pairs):
            for name, flags in ways.items():
                out = work / f"{pair} {name}"
                rates[name].append(generate(args.program, out, *recipe, *flags))
                if pair == 0:
                    print(f"{name}: {moving_pixels(out):.0f} pixels of a picture show what moves", flush=True)
                shutil.rmtree(out)
            print("  ".join(f"{name}: {rates[name][-1]:.1f}" for name in ways), flush=True)
        for name, of_way in rates.items():
            print(f"camera frames a second, {name}: {statistics.median(of_way):.1f}")
        ratios = [client / own for client, own in zip(rates["carla"], rates["built in"])]
        print(f"ratio: {statistics.median(ratios):.2f}")


if __name__ == "__main__":
    main()
