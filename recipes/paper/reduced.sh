#!/bin/sh
# The six minisets a hundredth as large: a tenth of the videos, each a tenth as long.
#
#     sh recipes/paper/reduced.sh OUT [ENDLESS [FLAG...]]
set -eu
out=$1
endless=${2:-endless}
shift $(($# < 2 ? $# : 2))
while read -r miniset videos duration; do
    "$endless" generate --config "$(dirname "$0")/miniset_$miniset.toml" \
        --videos "$videos" --duration "$duration" "$@" "$out/miniset_$miniset" </dev/null
done <<'END'
1 2 2.56
2 10 2.52
3 3 2.5
4 4 2.67
5 3 2.6
6 2 2.88
END
