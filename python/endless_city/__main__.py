"""The command `endless`: the same program as `cargo run -- ...`."""

from __future__ import annotations

import signal
import sys

from endless_city import _native


def main() -> int:
    """Runs the program with the arguments of this process and returns its exit code."""
    # Ctrl-C ends the program at once, as it does without Python; what is complete on disk stays.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _native.run_command(sys.argv)


if __name__ == "__main__":
    sys.exit(main())
