#!/usr/bin/env python3
"""Exports a dataset to every format and has the field's own readers judge each.

    python3 scripts/judge_exports.py ENDLESS OUT WORK [FORMAT ...]

ENDLESS is the program, OUT a dataset of at least two videos with the layers rgb and instance, WORK an empty folder. Needs numpy,
pillow, opencv-python-headless, pyyaml, pycocotools, trackeval, pykitti, pandas, nuscenes-devkit, cityscapesscripts, webdataset,
pyarrow, datasets and tfrecord; ultralytics and datumaro are asked where they are installed.
"""

import pathlib
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).parent))

from export_judges import boxes, cityscapes, coco, reid, space, tables, tracks, yolo  # noqa: E402
from export_judges.truth import Truth, check  # noqa: E402

JUDGES = {
    "coco": coco.coco, "coco_polygons": coco.coco_polygons, "coco_keypoints": coco.coco_keypoints,
    "coco_panoptic": coco.coco_panoptic, "roboflow": coco.roboflow, "yolo": yolo.yolo, "yolo_segment": yolo.yolo_segment,
    "yolo_pose": yolo.yolo_pose, "yolo_obb": yolo.yolo_obb, "mot": tracks.mot, "mots": tracks.mots,
    "kitti_object": space.kitti_object, "kitti_tracking": tracks.kitti_tracking, "kitti_raw": space.kitti_raw,
    "nuscenes": space.nuscenes, "cityscapes": cityscapes.cityscapes, "pascal_voc": boxes.pascal_voc, "ai_city": space.ai_city,
    "market1501": reid.market1501, "veri": reid.veri, "cvat": boxes.cvat, "label_studio": boxes.label_studio,
    "open_images": boxes.open_images, "webdataset": tables.webdataset, "parquet": tables.parquet,
    "huggingface": tables.huggingface, "tfrecord": tables.tfrecord,
}


def main() -> None:
    program, root, work, *wanted = sys.argv[1:]
    truth = Truth(root)
    listed = subprocess.run([program, "export", "--list"], check=True, capture_output=True, text=True).stdout
    formats = [line.split()[0] for line in listed.splitlines()]
    check(set(formats) == set(JUDGES), "formats without a judge:", set(formats) ^ set(JUDGES))
    for name in wanted or formats:
        folder = pathlib.Path(work) / name
        begin = time.perf_counter()
        subprocess.run([program, "export", root, "--format", name, "--to", str(folder)], check=True, stderr=subprocess.DEVNULL)
        print(f"{name} ({time.perf_counter() - begin:.2f} s)", flush=True)
        JUDGES[name](truth, folder)
    print(f"all is well: {len(wanted or formats)} formats")


if __name__ == "__main__":
    main()
