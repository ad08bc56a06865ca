#!/usr/bin/env python3
"""Imports every map file of some folders, draws it, films five seconds of it and checks the dataset.

    cargo build --release
    scripts/try_maps.py FOLDER... [--endless target/release/endless] [--out maps_tried]

A line a file: how long each step took, and what failed. Ends with 1 if anything did. Standard library only.
"""

import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import time

FILM = (
    "--videos 1 --duration 5 --vehicles 30 --pedestrians 20 --size 320x180 --fps 10 --weathers cloudy"
    " --times afternoon --mp4 none"
).split()
SUFFIXES = (".xodr", ".osm", ".osm.pbf")


def run(step, command, environment):
    """Seconds that a command took, and what it said if it failed."""
    start = time.monotonic()
    done = subprocess.run(command, env=environment, capture_output=True, text=True)
    seconds = time.monotonic() - start
    failed = None if done.returncode == 0 else f"{step} ended with {done.returncode}: {done.stderr.strip()}"
    return seconds, failed


def try_map(endless, file, out, environment):
    """Takes one file through all steps; returns what failed, or None."""
    name = "m_" + "".join(c if c.isalnum() else "_" for c in file.name.split(".")[0])
    dataset = out / name
    steps = [
        ("import", ["maps", "import", str(file), "--name", name]),
        ("preview", ["maps", "preview", name, "--out", str(out / f"{name}.png")]),
        ("generate", ["generate", str(dataset), "--maps", name, *FILM]),
        ("check", ["check", str(dataset)]),
    ]
    times = []
    for step, arguments in steps:
        seconds, failed = run(step, [endless, *arguments], environment)
        times.append(f"{step} {seconds:.2f} s")
        if failed:
            break
    print(f"{file.name:<32} {'FAILED' if failed else 'ok':<7}", ", ".join(times), flush=True)
    if failed:
        print("    " + failed.replace("\n", "\n    "), flush=True)
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--endless", default="target/release/endless")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("maps_tried"))
    arguments = parser.parse_args()
    files = sorted(f for folder in arguments.folders for f in folder.iterdir() if f.name.endswith(SUFFIXES))
    if not files:
        sys.exit("no map files there")
    shutil.rmtree(arguments.out, ignore_errors=True)
    arguments.out.mkdir(parents=True)
    environment = {**os.environ, "ENDLESS_MAPS": str((arguments.out / "store").resolve())}
    failed = [f for f in files if try_map(arguments.endless, f, arguments.out, environment)]
    print(f"{len(files) - len(failed)} of {len(files)} went through")
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
