"""Runs one of CARLA's scripts, unchanged, against the server of a given port, and ends it as a person at the keyboard would.

    python scripts/carla_launch.py PORT SECONDS SCRIPT.py [ARGS...]
    python scripts/carla_launch.py PORT SECONDS TEST_FOLDER smoke.test_name

Scripts name port 2000, or one of their own: clients that they make are given PORT. After SECONDS, if that is not 0, the script
gets a KeyboardInterrupt. Used by `carla_scripts.py`.
"""

import os
import runpy
import signal
import sys
import unittest

import carla

PORT, SECONDS = int(sys.argv[1]), float(sys.argv[2])
CARLAS_CLIENT = carla.Client


class Client(CARLAS_CLIENT):
    """CARLA's client, of our server whatever port the script names."""

    def __init__(self, host="127.0.0.1", port=PORT, worker_threads=0):
        super().__init__("127.0.0.1", PORT, worker_threads)


def interrupt(*_):
    raise KeyboardInterrupt


def main():
    carla.Client = Client
    sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "carla_stand_ins"))
    if SECONDS:
        signal.signal(signal.SIGALRM, interrupt)
        signal.setitimer(signal.ITIMER_REAL, SECONDS)
    where, sys.argv = sys.argv[3], sys.argv[3:]
    if os.path.isdir(where):
        sys.path.insert(0, where)
        sys.argv = sys.argv[1:]
        unittest.main(module=None, argv=["unittest", *sys.argv])
    else:
        sys.path.insert(0, os.path.dirname(os.path.abspath(where)))
        runpy.run_path(where, run_name="__main__")


if __name__ == "__main__":
    main()
