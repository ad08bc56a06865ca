# Programs of others: CARLA's client, a browser, clusters.

# CARLA's own client, on our maps and against our server.
carla_client() {
  local town
  for town in Town02 Ladera; do
    "$program" maps export "$town" --opendrive "$work/$town.xodr"
    "$program" maps export "$town" --geojson "$work/$town.geojson"
  done
  "$python" scripts/judge_carla_map.py "$work/Town02.xodr" "$work/Ladera.xodr"
  "$python" scripts/judge_carla.py "$program" --map Town02 --frames 120 --size 96x54
  "$python" scripts/judge_carla_client.py "$program"
}

# The page of endless view.
browser() {
  "$program" generate "$work/look" --videos 2 --size 320x180 --fps 5 --duration 2 --min-pixels 10 --maps Town01,Town03 \
    --events collision --layers rgb,depth,instance,flow
  PLAYWRIGHT="$work/browser" node scripts/judge_view.mjs "$program" "$work/look"
}

# Shards, and what clusters are given.
shards() {
  python3 scripts/kill_shards.py "$program" 8 6
  printf 'videos = 8\nsize = "64x36"\n# "small"\n' >"$work/recipe.toml"
  "$program" cluster kubernetes "$work/recipe.toml" --out paper --claim datasets --shards 8 --image endless:1 |
    "$python" scripts/check_manifest.py "$work/recipe.toml" 8
  if has_slurm; then scripts/judge_slurm.sh "$program" "$work/slurm"; fi
}
