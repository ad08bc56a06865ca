# Datasets, judged by programs that are not ours. `$program` is the one that the tests were compiled with, `$python` has the judges.

small_dataset() {
  local coco=crates/endless_statistics/tests/data/instances.json
  local layers=rgb,depth,instance,semantic,panoptic,normals,albedo,shadow,body_parts,flow,flow_backward
  "$program" generate "$work/out" --videos 2 --size 321x181 --fps 5 --duration 1 --min-pixels 10 --amodal-masks \
    --vehicles 100 --pedestrians 100 --focus 0 --layers $layers
  "$program" check "$work/out"
  "$python" scripts/check_dataset.py "$work/out"
  "$program" stats "$work/out" --json "$work/stats.json"
  "$python" scripts/check_statistics.py "$work/out" "$work/stats.json"
  "$program" compare "$work/out" --coco "$coco" --json "$work/compared.json"
  "$python" scripts/check_statistics.py --coco "$coco" "$work/compared.json"
  "$python" scripts/run_doc_examples.py "$work/out" docs/objects.md docs/scene.md docs/randomise.md
  "$program" bench --size 97x55 --duration 0.4
  # docs/variety.md: towns and cameras of each video's own.
  "$program" generate "$work/streets" --preset surveillance --videos 2 --size 161x91 --fps 4 --duration 0.5
  "$program" check "$work/streets"
  "$python" scripts/check_dataset.py "$work/streets"
  "$python" scripts/measure_variety.py "$work/streets"
  "$program" maps preview Random17 --out "$work/random17.png"
}

# Read as their pages and KITTI's readers do.
sensors_of_rigs() {
  "$program" generate "$work/every" --rig rigs/every_sensor.toml --videos 1 --size 161x91 --fps 10 --duration 1 --cameras-per-scene 1
  "$program" check "$work/every"
  "$python" scripts/check_dataset.py "$work/every"
  "$python" scripts/run_doc_examples.py "$work/every" docs/rigs.md docs/lidar.md docs/radar.md docs/imu.md docs/gnss.md \
    docs/event_camera.md docs/vehicle_events.md
  "$program" generate "$work/lenses" --rig rigs/lenses.toml --cameras-per-scene 0 --videos 1 --maps Town02 --fps 5 --duration 1 \
    --min-pixels 10 --layers rgb,depth,instance,semantic,panoptic,normals,albedo,body_parts
  "$program" check "$work/lenses"
  "$python" scripts/check_dataset.py "$work/lenses"
  "$python" scripts/run_doc_examples.py "$work/lenses" docs/lenses.md
  sed 's/"1242x375"/"414x125"/' rigs/kitti.toml >"$work/kitti.toml"
  "$program" generate "$work/kitti" --rig "$work/kitti.toml" --cameras-per-scene 0 --videos 1 --maps Town03 --fps 10 --duration 0.4 --seed 1
  "$python" python/to_kitti_raw.py "$work/kitti" "$work/kitti_layout" --deskew
  "$python" scripts/check_kitti.py "$work/kitti" "$work/kitti_layout"
  "$python" scripts/check_ply.py "$work/every"
}

# Opened by the tools that they are for.
exports() {
  "$program" generate "$work/exported" --videos 3 --maps Town01,Town03 --size 640x360 --fps 5 --duration 1 --vehicles 60 --pedestrians 80 \
    --min-pixels 20
  "$python" scripts/judge_exports.py "$program" "$work/exported" "$work/exports"
  PYTHONPATH="$PWD/python" "$python" scripts/run_doc_examples.py "$work/exported" --exports "$work/exports" docs/export/*.md
  # docs/python.md trains so.
  YOLO_CONFIG_DIR="$work" "$work/venv/bin/yolo" detect train data="$work/exports/yolo/data.yaml" model=yolo11n.yaml imgsz=160 epochs=1 \
    workers=0 plots=False project="$work/yolo"
  "$python" python/to_rerun.py "$work/exported" "$work/rerun" --video 0
  "$work/venv/bin/rerun" rrd verify "$work"/rerun/*.rrd
  "$python" scripts/judge_card.py "$work/exported" --endless "$program"
  "$program" bench --export "$work/exported"
}
