#!/usr/bin/env bash
# Tests a wheel (scripts/build_wheel.sh) on CPython 3.9 to 3.13, each in the distribution that brought it, with its own glibc.
# As root, on Debian with `debootstrap`.
#
#     scripts/judge_wheel.sh WHEEL WORK
#
# WORK keeps the systems, 300 MB each.
set -euo pipefail
cd "$(dirname "$0")/.."
wheel=$(realpath "$1")
work=$(realpath "$2")
certificates=${SSL_CERT_FILE:-/etc/ssl/certs/ca-certificates.crt}

# Makes the system of a release, unless it is there.
system() { # NAME MIRROR COMPONENTS
  local root=$work/$1 scripts=/usr/share/debootstrap/scripts
  [ -x "$root/usr/bin/python3" ] && return
  # Ubuntu's releases share one script, and old versions of the tool do not know the latest.
  [ -e "$scripts/$1" ] || ln -s gutsy "$scripts/$1"
  debootstrap --no-check-gpg --variant=minbase --components="$3" --include=python3,python3-venv,ca-certificates \
    "$1" "$root" "$2" >"$work/$1.log"
}

# Installs the wheel in it, and runs the tests.
judge() { # NAME VERSION
  local root=$work/$1
  rm -rf "$root/judge"
  mkdir -p "$root/judge"
  cp -r "$wheel" python/tests "$root/judge"
  # As this machine: it may trust a proxy of its own.
  cp "$certificates" "$root/etc/ssl/certs/ca-certificates.crt"
  cp /etc/resolv.conf /etc/hosts "$root/etc/"
  unshare --mount bash -euo pipefail -s -- "$root" "$2" <<'INSIDE'
root=$1 version=$2
mount --bind /proc "$root/proc"
mount --bind /dev "$root/dev"
inside() { chroot "$root" /usr/bin/env -C /judge PIP_CERT=/etc/ssl/certs/ca-certificates.crt TMPDIR=/judge PYTHONDONTWRITEBYTECODE=1 "$@" </dev/null; }
inside python3 -c "import sys; assert '%d.%d' % sys.version_info[:2] == '$version', sys.version"
inside python3 -m venv environment
inside environment/bin/pip install --quiet --upgrade pip
inside bash -c "environment/bin/pip install --quiet *.whl pytest hypothesis pillow pyyaml"
inside environment/bin/endless --version
inside environment/bin/python -m pytest --quiet -p no:cacheprovider tests
INSIDE
  printf 'CPython %s in %s: well\n' "$2" "$1"
}

debian=http://deb.debian.org/debian
ubuntu=http://archive.ubuntu.com/ubuntu
mkdir -p "$work"
while read -r -u 3 name version mirror components; do
  system "$name" "$mirror" "$components"
  judge "$name" "$version"
done 3<<END
bullseye 3.9  $debian main
jammy    3.10 $ubuntu main,universe
bookworm 3.11 $debian main
noble    3.12 $ubuntu main,universe
trixie   3.13 $debian main
END
