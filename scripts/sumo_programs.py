"""SUMO's programs, of the `eclipse-sumo` wheel."""

import os
import subprocess
import sys


def program(name):
    beside = os.path.join(os.path.dirname(sys.executable), name)
    if os.path.exists(beside):
        return beside
    import sumo

    return os.path.join(sumo.SUMO_HOME, "bin", name)


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{done.stdout}\n{done.stderr}")
    return done
