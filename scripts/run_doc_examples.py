#!/usr/bin/env python3
"""Runs the Python in documents as readers would: every block marked `python` of each page, in a folder where `out` is a
dataset, and each folder of EXPORTS is there, too.

    python3 scripts/run_doc_examples.py OUT [--exports EXPORTS] PAGE...
"""

import pathlib
import re
import subprocess
import sys
import tempfile


def main() -> None:
    dataset, *pages = map(pathlib.Path, sys.argv[1:])
    exports = []
    if pages[0].name == "--exports":
        _, folder, *pages = pages
        exports = sorted(folder.resolve().iterdir())
    for page in pages:
        blocks = re.findall(r"^```python\n(.*?)^```", page.read_text(), re.MULTILINE | re.DOTALL)
        assert blocks, f"{page} has no Python"
        for number, block in enumerate(blocks, 1):
            with tempfile.TemporaryDirectory() as folder:
                (pathlib.Path(folder) / "out").symlink_to(dataset.resolve())
                for export in exports:
                    (pathlib.Path(folder) / export.name).symlink_to(export)
                run = subprocess.run([sys.executable, "-c", block], cwd=folder, capture_output=True, text=True)
            if run.returncode != 0:
                sys.exit(f"{page}: block {number} fails\n{run.stderr}")
            print(f"{page}: block {number}: {(run.stdout.splitlines() or ['no output'])[-1]}")


if __name__ == "__main__":
    main()
