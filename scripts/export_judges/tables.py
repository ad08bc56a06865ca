"""Formats that are streamed or read as tables: WebDataset, Parquet, Hugging Face, TFRecord."""

import contextlib
import io
import json
import pathlib

import numpy as np
from PIL import Image

from .truth import Truth, check, one_video_one_part


def webdataset(truth: Truth, folder: pathlib.Path) -> None:
    import webdataset as wds

    parts, layers = {}, truth.manifest["recipe"]["layers"]
    for line in (folder / "shards.txt").read_text().splitlines():
        shards, count, _ = line.split()
        split = shards.split("-")[0]
        names = []
        for sample in wds.WebDataset(str(folder / shards), shardshuffle=False, empty_check=False):
            frame = truth.by_name[sample["__key__"]]
            names.append(frame.name)
            labels = json.loads(sample["json"])
            check([o["id"] for o in labels["objects"]] == [o["id"] for o in frame.objects], "objects of", frame.name)
            for own, o in zip(labels["objects"], frame.objects):
                check(all(own[key] == value for key, value in o.items()), "fields of", frame.name, o["id"])
            for layer in layers:
                ending = frame.extension if layer == "rgb" else "png"
                path = frame.folder / layer / f"{frame.number:06}.{ending}"
                check(sample[f"{layer}.{ending}"] == path.read_bytes(), layer, "of", frame.name)
        check(len(names) == int(count), "samples of", split)
        parts[split] = names
    one_video_one_part(parts)
    check(sum(map(len, parts.values())) == len(truth.frames), "samples are missing")
    print(f"  {len(truth.frames)} samples, {len(layers)} layers each, to the byte")


def parquet(truth: Truth, folder: pathlib.Path) -> None:
    import pyarrow.dataset

    from pycocotools import mask as masks

    frames = pyarrow.dataset.dataset(str(folder / "frames"), partitioning="hive").to_table().to_pylist()
    objects = pyarrow.dataset.dataset(str(folder / "objects"), partitioning="hive").to_table().to_pylist()
    parts: dict = {}
    for row in frames:
        parts.setdefault(row["split"], []).append(f"{row['video']}_{row['camera']}_{row['frame']:06}")
        check((truth.root / row["rgb"]).is_file(), "no picture", row["rgb"])
    one_video_one_part(parts)
    check(sorted(sum(parts.values(), [])) == sorted(truth.by_name), "frames are missing")
    expected = {(f.name, o["id"]): (f, o) for f in truth.frames for o in f.objects}
    for row in objects:
        frame, o = expected.pop((f"{row['video']}_{row['camera']}_{row['frame']:06}", row["id"]))
        check([row[f"bbox_{side}"] for side in "xywh"] == o["bbox"] and row["class"] == o["class"], frame.name, o["id"])
        for key in ("pixels", "visibility", "truncation", "truncated", "parked", "yaw_rad", "position", "keypoints", "skin_tone",
                    "velocity_mps", "speed_mps", "distance_m", "action", "lane", "rider_id", "vehicle_id", "amodal_bbox"):
            check(row[key] == o.get(key), key, "of", frame.name, o["id"], row[key], o.get(key))
        for key in ("center", "size", "rotation"):
            check(row[f"box3d_{key}"] == o["box3d"][key], key, "of", frame.name, o["id"])
        if row["mask"] is not None:
            mask = masks.decode({"size": [truth.height, truth.width], "counts": row["mask"].encode()})
            check((mask.astype(bool) == frame.mask(o["id"])).all(), "mask of", frame.name, o["id"])
    check(not expected, len(expected), "objects are missing")
    print(f"  {len(frames)} frames, {len(objects)} objects, every field equal")


def huggingface(truth: Truth, folder: pathlib.Path) -> None:
    import datasets

    datasets.disable_progress_bars()
    card = (folder / "README.md").read_text()
    check(card.startswith("---\n") and "object-detection" in card, "the card")
    with contextlib.redirect_stdout(io.StringIO()):
        loaded = datasets.load_dataset("imagefolder", data_dir=str(folder / "data"), cache_dir=str(folder.parent / "hf_cache"))
    parts, count = {}, 0
    names = {"validation": "val"}
    for split, rows in loaded.items():
        parts[names.get(split, split)] = []
        for row in rows:
            frame = truth.by_name[f"{row['video']}_{row['camera']}_{row['frame']:06}"]
            parts[names.get(split, split)].append(frame.name)
            check(row["image"].size == (truth.width, truth.height), "size of", frame.name)
            objects = row["objects"]
            check(objects["bbox"] == [o["bbox"] for o in frame.objects], "boxes of", frame.name)
            check([truth.classes[c] for c in objects["categories"]] == [o["class"] for o in frame.objects], frame.name)
            check(objects["visibility"] == [o["visibility"] for o in frame.objects], "visibility of", frame.name)
            count += len(frame.objects)
        check(np.array_equal(np.asarray(rows[0]["image"].convert("RGB")), truth.by_name[parts[names.get(split, split)][0]].rgb), "a picture")
    one_video_one_part(parts)
    check(count == truth.boxes, count, "boxes")
    print(f"  {count} boxes in {sorted(loaded)}")


def tfrecord(truth: Truth, folder: pathlib.Path) -> None:
    from tfrecord.reader import tfrecord_loader

    numbers = {}
    for item in (folder / "label_map.pbtxt").read_text().split("item")[1:]:
        words = item.replace('"', "").split()
        numbers[words[words.index("name:") + 1]] = int(words[words.index("id:") + 1])
    parts: dict = {}
    for path in sorted(folder.glob("*.tfrecord")):
        for record in tfrecord_loader(str(path), None):
            frame = truth.by_name[bytes(record["image/source_id"]).decode()]
            parts.setdefault(path.name.split("-")[0], []).append(frame.name)
            encoded = bytes(record["image/encoded"])
            check(np.array_equal(np.asarray(Image.open(io.BytesIO(encoded))), frame.rgb), "picture of", frame.name)
            if not frame.objects:
                continue
            edges = np.stack([np.atleast_1d(record[f"image/object/bbox/{edge}"]) for edge in ("xmin", "ymin", "xmax", "ymax")], 1)
            boxes = np.array([o["bbox"] for o in frame.objects], float)
            boxes[:, 2:] += boxes[:, :2]
            check(np.abs(edges * ([truth.width, truth.height] * 2) - boxes).max() < 1e-6 * 4 * truth.width, "boxes of", frame.name)
            labels = np.atleast_1d(record["image/object/class/label"]).tolist()
            check(labels == [numbers[o["class"]] for o in frame.objects], "classes of", frame.name)
            tracks = np.atleast_1d(record["image/object/track_id"]).tolist()
            check(tracks == [o["id"] for o in frame.objects], "tracks of", frame.name)
    one_video_one_part(parts)
    check(sum(map(len, parts.values())) == len(truth.frames), "pictures are missing")
    print(f"  {len(truth.frames)} records")
