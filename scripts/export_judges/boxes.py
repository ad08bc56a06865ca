"""Formats of boxes in files of text: Pascal VOC, CVAT, Open Images, Label Studio."""

import csv
import json
import pathlib
import xml.etree.ElementTree as xml

import numpy as np

from .datumaro_reader import with_datumaro
from .truth import Truth, check, one_video_one_part


def pascal_voc(truth: Truth, folder: pathlib.Path) -> None:
    parts = {split: (folder / f"ImageSets/Main/{split}.txt").read_text().split() for split in ("train", "val")}
    one_video_one_part(parts)
    check(sorted(sum(parts.values(), [])) == sorted(truth.by_name), "pictures are missing")
    count = 0
    for name, frame in truth.by_name.items():
        root = xml.parse(folder / f"Annotations/{name}.xml").getroot()
        check((folder / "JPEGImages" / root.findtext("filename")).is_file(), "no picture", name)
        check([int(root.findtext(f"size/{side}")) for side in ("width", "height", "depth")] == [truth.width, truth.height, 3], name)
        for entry, o in zip(root.findall("object"), frame.objects, strict=True):
            x, y, w, h = o["bbox"]
            box = [int(entry.findtext(f"bndbox/{edge}")) for edge in ("xmin", "ymin", "xmax", "ymax")]
            check(box == [x + 1, y + 1, x + w, y + h] and entry.findtext("name") == o["class"], name, o["id"])
            count += 1
    print(f"  {count} boxes; {with_datumaro(folder, 'voc', count)}")


def cvat(truth: Truth, folder: pathlib.Path) -> None:
    parts, count, notes = {}, 0, []
    for split in ("train", "val"):
        root = xml.parse(folder / split / "annotations.xml").getroot()
        check(root.findtext("version") == "1.1", "version")
        labels = [label.findtext("name") for label in root.findall("meta/task/labels/label")]
        check(labels == truth.classes, "labels", labels)
        parts[split] = []
        own = 0
        for image in root.findall("image"):
            frame = truth.by_name[pathlib.Path(image.get("name")).stem]
            parts[split].append(frame.name)
            check((folder / split / "images" / image.get("name")).is_file(), "no picture", frame.name)
            for box, o in zip(image.findall("box"), frame.objects, strict=True):
                x, y, w, h = o["bbox"]
                corners = [float(box.get(edge)) for edge in ("xtl", "ytl", "xbr", "ybr")]
                check(corners == [x, y, x + w, y + h] and box.get("label") == o["class"], frame.name, o["id"])
                attributes = {a.get("name"): a.text for a in box.findall("attribute")}
                check(attributes["track_id"] == str(o["id"]), frame.name, o["id"])
                own += 1
        notes.append(with_datumaro(folder / split, "cvat", own))
        count += own
    one_video_one_part(parts)
    check(count == truth.boxes, count, "boxes")
    print(f"  {count} boxes; {notes[0]}")


def open_images(truth: Truth, folder: pathlib.Path) -> None:
    names = dict(csv.reader((folder / "class-descriptions-boxable.csv").open()))
    known = {"car": "Car", "van": "Van", "truck": "Truck", "bus": "Bus", "motorcycle": "Motorcycle", "bicycle": "Bicycle"}
    parts, count = {}, 0
    for split in ("train", "val"):
        pictures = [path.stem for path in (folder / split).iterdir()]
        parts[split] = pictures
        rows: dict = {name: [] for name in pictures}
        for row in csv.DictReader((folder / f"{split}-annotations-bbox.csv").open()):
            rows[row["ImageID"]].append(row)
        for name in pictures:
            for row, o in zip(rows[name], truth.by_name[name].objects, strict=True):
                x, y, w, h = o["bbox"]
                edges = [float(row[key]) for key in ("XMin", "YMin", "XMax", "YMax")] * np.array([truth.width, truth.height] * 2)
                check(np.abs(edges - [x, y, x + w, y + h]).max() < 1e-6 * truth.width, name, o["id"], edges)
                check(names[row["LabelName"]] == known.get(o["class"], "Person"), name, o["id"])
                count += 1
    one_video_one_part(parts)
    check(count == truth.boxes, count, "boxes")
    print(f"  {count} boxes")


def label_studio(truth: Truth, folder: pathlib.Path) -> None:
    config = xml.parse(folder / "config.xml").getroot()
    check([label.get("value") for label in config.iter("Label")] == truth.classes, "labels")
    parts, count = {}, 0
    for split in ("train", "val"):
        tasks = json.loads((folder / f"{split}.json").read_text())
        parts[split] = []
        for task in tasks:
            below = task["data"]["image"].removeprefix("/data/local-files/?d=")
            check((folder / below).is_file(), "no picture", below)
            frame = truth.by_name[pathlib.Path(below).stem]
            parts[split].append(frame.name)
            for result, o in zip(task["annotations"][0]["result"], frame.objects, strict=True):
                value = result["value"]
                box = [value["x"], value["y"], value["width"], value["height"]] * np.array([truth.width, truth.height] * 2) / 100
                check(np.abs(box - o["bbox"]).max() < 1e-6 and value["rectanglelabels"] == [o["class"]], frame.name, o["id"])
                count += 1
    one_video_one_part(parts)
    check(count == truth.boxes, count, "boxes")
    print(f"  {count} boxes")
