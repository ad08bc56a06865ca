#!/usr/bin/env python3
"""What Python costs beside the program: the same recipe by `endless generate`, by `generate` and by `stream`, in turn.

    python3 scripts/bench_python_overhead.py PROGRAM [--rounds N] [--duration S]

The best round of each counts, by processor time, which other programs disturb less, and by the clock. A stream writes nothing, so that
it is no slower than what it is compared with unless Python holds it up. What importing the package takes is told as well, beyond the
start of Python.
"""

import argparse
import os
import subprocess
import sys
import tempfile
import time

RECIPE = {"videos": 1, "maps": "Town01", "size": "1280x720", "fps": 30, "duration": 1.0, "mp4": "none"}

GENERATE = "import endless_city, sys; endless_city.generate(sys.argv[1], progress=False, **{recipe})"
STREAM = """
import endless_city
with endless_city.stream(**{recipe}) as frames:
    for frame in frames:
        for view in frame.cameras:
            view.rgb, view.depth, view.instance, view.objects.boxes
"""


IMPORT = "import time; start = time.perf_counter(); import endless_city; print(time.perf_counter() - start)"


def import_s():
    """The shortest of some, by the clock: other programs only add to it."""
    again = [subprocess.run([sys.executable, "-c", IMPORT], check=True, capture_output=True) for _ in range(10)]
    return min(float(run.stdout) for run in again)


def run(command):
    """Seconds of processor time and by the clock."""
    before, start = os.times(), time.perf_counter()
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    after = os.times()
    used = after.children_user + after.children_system - before.children_user - before.children_system
    return used, time.perf_counter() - start


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--duration", type=float, default=1.0)
    args = parser.parse_args()
    recipe = {**RECIPE, "duration": args.duration}
    flags = [f"--{key}={value}" for key, value in recipe.items()]
    ways = {
        "endless generate": lambda out: [args.program, "generate", out, *flags],
        "generate": lambda out: [sys.executable, "-c", GENERATE.format(recipe=recipe), out],
        "stream": lambda out: [sys.executable, "-c", STREAM.format(recipe=recipe)],
    }
    times = {name: [] for name in ways}
    for _ in range(args.rounds):
        for name, command in ways.items():
            with tempfile.TemporaryDirectory() as folder:
                times[name].append(run(command(os.path.join(folder, "out"))))
    best = {name: [min(round_[k] for round_ in of) for k in (0, 1)] for name, of in times.items()}
    for name, (used, clock) in best.items():
        of = [100 * (a / b - 1) for a, b in zip((used, clock), best["endless generate"])]
        print(f"{name:<17} {used:6.2f} s of processor time ({of[0]:+.1f} %), {clock:6.2f} s by the clock ({of[1]:+.1f} %)")
    print(f"{'import':<17} {1000 * import_s():6.0f} ms by the clock")


if __name__ == "__main__":
    main()
