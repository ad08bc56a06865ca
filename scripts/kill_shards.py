#!/usr/bin/env python3
"""Makes a dataset by shards that run at the same time, kills some of them with SIGKILL at random instants and starts them again, and
compares the end with one run that was left alone, byte by byte.

    python3 scripts/kill_shards.py path/to/endless [SHARDS] [KILLS] [FLAG...]

Flags of `generate` that come last are added to its own, as in `8 10 --duration 10`.
"""

import os
import random
import subprocess
import sys
import tempfile
import time

from folder_bytes import folder_bytes

ARGUMENTS = ["--videos", "16", "--size", "161x91", "--fps", "10", "--seed", "3", "--cameras-per-scene", "1", "--threads", "1"]


def main() -> None:
    program = os.path.realpath(sys.argv[1])
    shards = int(sys.argv[2]) if len(sys.argv) > 2 else 8
    kills = int(sys.argv[3]) if len(sys.argv) > 3 else 10
    arguments = ARGUMENTS + (sys.argv[4:] or ["--duration", "3"])
    chance = random.Random(os.getpid())
    with tempfile.TemporaryDirectory() as work:

        def start(shard: int) -> subprocess.Popen:
            command = [program, "generate", "out", *arguments, "--shard", f"{shard}/{shards}"]
            return subprocess.Popen(command, cwd=work, stderr=subprocess.PIPE, text=True)

        running = {shard: start(shard) for shard in range(1, shards + 1)}
        killed = 0
        while running:
            time.sleep(0.2)
            for shard, process in list(running.items()):
                if process.poll() is not None:
                    _, said = process.communicate()
                    assert process.returncode == 0, f"shard {shard}: {said}"
                    del running[shard]
            if running and killed < kills and chance.random() < 0.15:
                shard = chance.choice(sorted(running))
                running[shard].kill()
                running[shard].communicate()
                killed += 1
                running[shard] = start(shard)
        subprocess.run([program, "check", "out", "--shards", str(shards)], cwd=work, check=True)
        subprocess.run([program, "generate", "whole", *arguments], cwd=work, check=True, stderr=subprocess.DEVNULL)
        by_shards, whole = folder_bytes(os.path.join(work, "out")), folder_bytes(os.path.join(work, "whole"))
        assert by_shards.keys() == whole.keys(), sorted(by_shards.keys() ^ whole.keys())
        differ = [name for name in whole if whole[name] != by_shards[name]]
        assert not differ, differ
        print(f"{shards} shards at once, {killed} killed: {len(whole)} files, as of one run")


if __name__ == "__main__":
    main()
