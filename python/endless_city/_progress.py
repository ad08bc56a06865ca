"""A bar of progress on stderr; plain lines where that is no terminal."""

from __future__ import annotations

import sys
import time


class Bar:
    """Shows how many camera frames are made."""

    _WIDTH = 30

    def __init__(self) -> None:
        self._start = time.monotonic()
        self._shown = -1
        self._terminal = sys.stderr.isatty()

    def update(self, lines: list[str], done: int, total: int) -> None:
        """Prints what was said, and how far it is."""
        for line in lines:
            self._print(line)
        # In tenths where lines stay, else at every frame.
        step = done if self._terminal else 10 * done // max(total, 1)
        if step == self._shown or total == 0 or done == 0:
            return
        self._shown = step
        seconds = time.monotonic() - self._start
        rate = done / max(seconds, 1e-9)
        left = (total - done) / max(rate, 1e-9)
        told = f"{done}/{total} camera frames, {rate:.1f}/s, {left:.0f} s left"
        if self._terminal:
            full = self._WIDTH * done // total
            sys.stderr.write(f"\r\x1b[K[{'#' * full}{'-' * (self._WIDTH - full)}] {told}")
            sys.stderr.flush()
        else:
            self._print(told)

    def close(self) -> None:
        """Leaves the line of the bar."""
        if self._terminal and self._shown >= 0:
            sys.stderr.write("\r\x1b[K")
            sys.stderr.flush()

    def _print(self, line: str) -> None:
        start = "\r\x1b[K" if self._terminal else ""
        sys.stderr.write(f"{start}[{time.monotonic() - self._start:7.1f} s] {line}\n")
        sys.stderr.flush()
