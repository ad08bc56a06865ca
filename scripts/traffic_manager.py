#!/usr/bin/env python3
"""Runs CARLA's TrafficManager beside a CARLA server, for `endless generate --simulator carla://… --traffic-manager …`.

    python3 scripts/traffic_manager.py [--host HOST] [--port PORT] [--tm-port PORT]

A TrafficManager belongs to the map that was loaded when it was made, so each map gets one, in a process of its own. Needs
CARLA's client: `pip install carla==0.9.16`. Runs until it is stopped, or the server has been gone for a while.
"""

import argparse
import multiprocessing
import signal
import sys
import time

import carla

# Between looks at which map is loaded, seconds.
LOOK_S = 0.5


def drive(host: str, port: int, tm_port: int) -> None:
    """Is a TrafficManager for the map that is loaded now, until it is killed."""
    client = carla.Client(host, port)
    client.set_timeout(30)
    client.get_trafficmanager(tm_port)
    print(f"driving at port {tm_port}", flush=True)
    while True:
        time.sleep(LOOK_S)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=2000)
    parser.add_argument("--tm-port", type=int, default=8000)
    parser.add_argument("--patience", type=float, default=60, help="end when the server has been gone for so many seconds")
    args = parser.parse_args()
    # What ends it ends its process for the map, too.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit())
    # Forked, a process would share its parent's connection.
    processes = multiprocessing.get_context("spawn")
    driver, episode, seen = None, None, time.monotonic()
    while time.monotonic() - seen < args.patience:
        try:
            client = carla.Client(args.host, args.port)
            client.set_timeout(5)
            now = client.get_world().id
            seen = time.monotonic()
            if now != episode:
                if driver is not None:
                    driver.kill()
                    driver.join()
                driver = processes.Process(target=drive, args=(args.host, args.port, args.tm_port), daemon=True)
                driver.start()
                episode = now
        except RuntimeError as error:
            print(f"waiting for the server: {error}", flush=True)
        time.sleep(LOOK_S)


if __name__ == "__main__":
    main()
