#!/usr/bin/env python3
"""Kills a CARLA server at random instants while `endless generate` records from it, and starts it again each time: the run must
complete. Then stops a second run by Ctrl-C: the server must be left as it was.

    python3 scripts/kill_carla_server.py path/to/endless [KILLS]
"""

import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import time

from ports import wait_until_it_listens

PORT = 27300
FRAMES, VIDEOS = 60, 6
RECIPE = ["--maps", "Town02", "--videos", str(VIDEOS), "--fps", "10", "--duration", str(FRAMES / 10), "--size", "320x180"]


def serve(endless: str) -> subprocess.Popen:
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    return subprocess.Popen([endless, "serve", "--map", "Town02", "--port", str(PORT)], **quiet)


def generate(endless: str, out: pathlib.Path) -> subprocess.Popen:
    flags = ["--simulator", f"carla://127.0.0.1:{PORT}", "--frame-timeout", "20", *RECIPE]
    return subprocess.Popen([endless, "generate", str(out), *flags], stderr=subprocess.PIPE, text=True)


def images(out: pathlib.Path) -> int:
    return sum(1 for _ in out.glob("videos/*/camera_*/rgb/*.png"))


def main() -> None:
    endless, kills = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 10
    dice = random.Random(1)
    with tempfile.TemporaryDirectory() as work:
        out = pathlib.Path(work) / "killed"
        server = serve(endless)
        wait_until_it_listens(server, PORT)
        run = generate(endless, out)
        done = 0
        while done < kills and run.poll() is None:
            # Anywhere from loading the map to the last frames.
            time.sleep(dice.uniform(0.1, 4.0))
            server.kill()
            server.wait()
            done += 1
            time.sleep(dice.uniform(0.0, 1.0))
            server = serve(endless)
        said = run.stderr.read()
        code = run.wait()
        assert code == 0, f"the run ended with {code}: {said[-2000:]}"
        assert done == kills, f"the run was over after {done} kills"
        assert images(out) == VIDEOS * 2 * FRAMES, f"{images(out)} images"
        subprocess.run([endless, "check", str(out)], check=True)
        print(f"{done} kills: the dataset is complete")

        wait_until_it_listens(server, PORT)
        stopped = pathlib.Path(work) / "stopped"
        run = generate(endless, stopped)
        while images(stopped) == 0 and run.poll() is None:
            time.sleep(0.02)
        run.send_signal(signal.SIGINT)
        said = run.stderr.read()
        assert run.wait() == 130 and "the same command goes on" in said, said[-500:]
        run = generate(endless, stopped)
        run.stderr.read()
        assert run.wait() == 0, "the same command goes on"
        subprocess.run([endless, "check", str(stopped)], check=True)
        print("stopped by Ctrl-C with exit code 130, and completed by the same command")
        server.kill()


if __name__ == "__main__":
    main()
