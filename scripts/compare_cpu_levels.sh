#!/usr/bin/env bash
# Builds the program for several levels of x86-64 and compares the bytes of a tiny dataset, made with each that this
# processor can run; tries on an emulated old processor (qemu-user, if it is there) that a build for a newer one says so.
# usage: scripts/compare_cpu_levels.sh [PROFILE=release] [LEVEL...]
set -euo pipefail
cd "$(dirname "$0")/.."

profile=${1:-release}
shift || true
levels=("$@")
[ ${#levels[@]} -gt 0 ] || levels=(x86-64 x86-64-v2 x86-64-v3 x86-64-v4)
recipe=(--videos 2 --maps Town02,Town01 --weathers rainy --times night,morning --size 97x55 --fps 5 --duration 0.4
  --vehicles 20 --pedestrians 10 --min-pixels 5 --mp4 rgb,depth,instance --camera-look cctv)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
folder=$profile
[ "$profile" = dev ] && folder=debug

digests() {
  (cd "$1" && find . -type f | LC_ALL=C sort | xargs sha256sum)
}

binary() {
  echo "target/cpu/$1/$folder/endless"
}

reference=
for level in "${levels[@]}"; do
  RUSTFLAGS=-Ctarget-cpu=$level cargo build --quiet --profile "$profile" --package endless --target-dir "target/cpu/$level"
  if ! "$(binary "$level")" --version > /dev/null 2> "$work/said"; then
    echo "$level: not run here: $(cat "$work/said")"
    continue
  fi
  for format in png jpg; do
    "$(binary "$level")" generate "$work/$level/$format" "${recipe[@]}" --rgb-format "$format" 2> "$work/said"
  done
  digests "$work/$level" > "$work/$level.digests"
  if [ -z "$reference" ]; then
    reference=$level
    echo "$level: $(wc -l < "$work/$level.digests") files"
  elif diff "$work/$reference.digests" "$work/$level.digests"; then
    echo "$level: the same bytes as $reference"
  else
    echo "$level: other bytes than $reference" >&2
    exit 1
  fi
done

command -v qemu-x86_64 > /dev/null || { echo "no qemu-x86_64: the old processor is left out"; exit 0; }
for level in "${levels[@]}"; do
  case $level in x86-64 | x86-64-v2) continue ;; esac
  code=0
  qemu-x86_64 -cpu Nehalem "$(binary "$level")" --version > "$work/out" 2> "$work/said" || code=$?
  if [ "$code" = 1 ] && [ "$(wc -l < "$work/said")" = 1 ] && grep -q '^error: this build of endless needs' "$work/said"; then
    echo "$level on an old processor: $(cat "$work/said")"
  else
    echo "$level on an old processor: exit code $code: $(cat "$work/said")" >&2
    exit 1
  fi
done
