# Steps that run beside others. What a step says is printed as a whole when it is waited for.

declare -A running
logs=$(mktemp -d)

# start NAME: runs the function of that name.
start() {
  # A process group of its own, which can be ended as a whole.
  set -m
  (
    begin=$SECONDS
    "$1"
    echo "($1: $((SECONDS - begin)) s)"
  ) >"$logs/$1" 2>&1 </dev/null &
  running[$1]=$!
  set +m
}

# finish NAME...: waits for each, and fails where one failed.
finish() {
  local name code
  for name; do
    code=0
    wait "${running[$name]}" || code=$?
    unset "running[$name]"
    step "$name"
    cat "$logs/$name"
    if [ "$code" != 0 ]; then
      echo "FAILED: $name" >&2
      exit "$code"
    fi
  done
}

end_all() {
  local name
  for name in "${!running[@]}"; do kill -- "-${running[$name]}" 2>/dev/null || true; done
  rm -rf "$logs"
}
