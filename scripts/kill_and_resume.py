#!/usr/bin/env python3
"""Kills `endless generate` with SIGKILL at random instants, resumes it each time, and compares the end with a run that
was left alone, byte by byte.

    python3 scripts/kill_and_resume.py path/to/endless [KILLS] [FLAG...]

Flags of `generate` that come last are added to or override its own, as in `20 --rig rigs/every_sensor.toml --duration 10`.
"""
import filecmp
import os
import random
import subprocess
import sys
import tempfile
import time

ARGUMENTS = ["--videos", "2", "--size", "161x91", "--fps", "10", "--duration", "30", "--seed", "3", "--min-pixels", "10"]
# Flow asks for the frames beside those that are missing, and a change for the key frames around them.
LAYERS = "rgb,depth,instance,semantic,panoptic,normals,albedo,shadow,body_parts,flow,flow_backward"
ARGUMENTS += ["--layers", LAYERS, "--amodal-masks", "--changing", "both"]


def files(root):
    return sorted(os.path.relpath(os.path.join(d, f), root) for d, _, names in os.walk(root) for f in names)


def overridden(arguments, more):
    """The flags of both, those of the latter where both have one."""
    kept, skip = [], False
    for argument in arguments:
        if argument.startswith("--"):
            skip = argument in more
        if not skip:
            kept.append(argument)
    return kept + more


def main():
    endless, kills = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 20
    arguments = overridden(ARGUMENTS, sys.argv[3:])
    with tempfile.TemporaryDirectory() as work:
        whole, killed = os.path.join(work, "whole"), os.path.join(work, "killed")
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
        begin = time.monotonic()
        subprocess.run([endless, "generate", whole, *arguments], check=True, **quiet)
        length = time.monotonic() - begin
        dice, done = random.Random(1), 0
        for kill in range(kills):
            process = subprocess.Popen([endless, "generate", killed, *arguments], **quiet)
            if kill % 2 == 0:
                # While towns are loaded and cameras baked, most often.
                time.sleep(dice.uniform(0.02, length * 0.25))
            else:
                # While frames are written: every run gets a little further.
                count = len(files(killed)) + dice.randint(1, max(1, 3 * len(files(whole)) // (2 * kills)))
                while process.poll() is None and len(files(killed)) < count:
                    time.sleep(0.01)
                time.sleep(dice.uniform(0.0, 0.05))
            process.kill()
            done += process.wait() != 0
            print(f"kill {kill + 1}: {len(files(killed))} files", flush=True)
        subprocess.run([endless, "generate", killed, *arguments], check=True, **quiet)
        subprocess.run([endless, "check", killed], check=True, **quiet)
        left, right = files(whole), files(killed)
        assert left == right, f"files differ: {sorted(set(left) ^ set(right))[:5]}"
        _, differ, broken = filecmp.cmpfiles(whole, killed, left, shallow=False)
        assert not differ and not broken, f"bytes differ: {(differ + broken)[:5]}"
        print(f"{done} of {kills} runs were killed before their end; {len(left)} files are the same, byte by byte")


if __name__ == "__main__":
    main()
