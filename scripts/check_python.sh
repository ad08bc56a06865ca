#!/usr/bin/env bash
# Installs the Python package as its users do, into an environment of its own, and runs its tests, type checkers and stub checks.
#
#     scripts/check_python.sh [--torch] [ENVIRONMENT]
#
# With --torch also what needs PyTorch, whose wheels for CPUs are large.
set -euo pipefail
cd "$(dirname "$0")/.."
torch=no
if [ "${1:-}" = --torch ]; then torch=yes; shift; fi
environment=${1:-$(mktemp -d)/venv}
python3 -m venv "$environment"
python=$environment/bin/python
"$python" -m pip install --quiet --upgrade pip
"$python" -m pip install --quiet .
"$python" -m pip install --quiet pytest hypothesis pillow pyyaml mypy pyright
if [ "$torch" = yes ]; then
  "$python" -c "import torch, torchvision" 2>/dev/null || "$python" -m pip install --quiet torch torchvision
fi
# Away from the sources, so that the installed package is what is tested.
tests=$PWD/python/tests
package=$("$python" -c "import endless_city, pathlib; print(pathlib.Path(endless_city.__file__).parent)")
cd "$(mktemp -d)"
"$environment/bin/endless" --version
"$python" -m pytest --quiet -p no:cacheprovider "$tests"
# What needs a library that is not here is left out.
without=()
for extra in torch ray; do
  "$python" -c "import $extra" 2>/dev/null || without+=("$extra.py")
done
"$python" -c "import torch" 2>/dev/null || without+=(sim2real)
"$python" -m mypy --strict --no-incremental -p endless_city "${without[@]/#/--exclude=}"
"$python" -m mypy.stubtest endless_city._native
# It looks at nothing outside its own folder.
cp -r "$package" endless_city
(cd endless_city && rm -rf "${without[@]}")
echo '{"include": ["endless_city"], "typeCheckingMode": "strict", "pythonVersion": "3.9"}' > pyrightconfig.json
"$environment/bin/pyright" --pythonpath "$python"
