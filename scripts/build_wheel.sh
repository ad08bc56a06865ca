#!/usr/bin/env bash
# Builds the wheel that is published: manylinux2014 (glibc 2.17), one for CPython 3.9 and all later ones (abi3).
#
#     scripts/build_wheel.sh [FOLDER]
#
# Zig, which comes as a wheel, links with symbols of that old glibc; `auditwheel` inside of maturin refuses newer ones.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=${1:-dist}
environment=$(mktemp -d)
trap 'rm -rf "$environment"' EXIT
python3 -m venv "$environment"
"$environment/bin/pip" install --quiet "maturin[zig]>=1.8,<2" abi3audit
PATH=$environment/bin:$PATH maturin build --zig --compatibility manylinux2014 --out "$folder"
"$environment/bin/abi3audit" --strict --verbose "$folder"/endless_city-*-abi3-manylinux*.whl
