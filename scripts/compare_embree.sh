#!/usr/bin/env bash
# Traces the same rays with ENDLESS and with Intel Embree 3, on two threads, and compares rates and hits: primary rays,
# rays to the sun, diffuse rays as a bake sends them, and rays that each go their own way.
#
#   scripts/compare_embree.sh [TOWN …]            # default: Town03
#   EMBREE_FLAGS="--fast --flat" scripts/compare_embree.sh Town01
#
# Needs a C++ compiler and Embree 3 with its headers (Debian: libembree-dev). EMBREE_FLAGS go to scripts/embree/trace.cpp,
# which says what they mean. WORK keeps the files of the comparison, about 200 MB a town.
set -euo pipefail
cd "$(dirname "$0")/.."

towns=("$@")
[ ${#towns[@]} -gt 0 ] || towns=(Town03)
work=${WORK:-$(mktemp -d)}
[ -n "${WORK:-}" ] || trap 'rm -rf "$work"' EXIT

"${CXX:-c++}" -std=c++17 -O3 -march=x86-64-v3 -Wall -Wextra scripts/embree/trace.cpp -o "$work/trace" -lembree3 -pthread
cargo run --release -p endless_city --example ray_rates -- "${towns[@]}" --export "$work"
for town in "${towns[@]}"; do
    echo "== $town"
    # shellcheck disable=SC2086 # several flags
    "$work/trace" "$work/$town.scene" "$work/$town.rays" ${EMBREE_FLAGS:-}
done
