"""The command `python -m endless_city.sim2real`."""

from __future__ import annotations

import importlib.util
import sys
from collections.abc import Sequence
from typing import Optional

from endless_city.errors import EndlessError, RecipeError

_FAILED, _MISUSED, _STOPPED = 1, 2, 130


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command and returns its exit code: 1 for a set or a training that fails, 2 for arguments that make no sense or a
    missing library.

    Args:
        arguments: Those of the process by default.
    """
    missing = _missing()
    if missing:
        print(missing, file=sys.stderr)
        return _MISUSED
    try:
        _run(arguments)
    except RecipeError as error:
        print(f"error: {error}", file=sys.stderr)
        return _MISUSED
    except EndlessError as error:
        print(f"error: {error}", file=sys.stderr)
        return _FAILED
    except KeyboardInterrupt:
        return _STOPPED
    return 0


def _missing() -> Optional[str]:
    """What to say if libraries are missing."""
    if any(importlib.util.find_spec(name) is None for name in ("torch", "torchvision")):
        return (
            "error: PyTorch or torchvision is missing: pip install endless-city[torch], "
            "or endless-city[sim2real] for all that this command needs"
        )
    if any(importlib.util.find_spec(name) is None for name in ("PIL", "yaml")):
        return "error: Pillow or PyYAML is missing: pip install endless-city[sim2real]"
    return None


def _run(arguments: Optional[Sequence[str]]) -> None:
    # They need the libraries.
    from endless_city.sim2real.arguments import parse
    from endless_city.sim2real.misses import draw_sheet
    from endless_city.sim2real.runs import run_all

    options = parse(arguments)
    try:
        options.out.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise RecipeError(f"--out cannot be {options.out}: {error.strerror}") from error
    finished = run_all(options)
    finished.report.write(options.out)
    draw_sheet(finished.tested, options.out / "misses.png")
    print(finished.report.text())
    print(f"\n{options.out / 'report.md'}, {options.out / 'report.json'}, {options.out / 'misses.png'}")


if __name__ == "__main__":
    sys.exit(main())
