"""Crops for re-identification, read as torchreid's and fastreid's readers of Market-1501 and VeRi-776 do."""

import pathlib
import re
import xml.etree.ElementTree as xml

import numpy as np
from PIL import Image

from .truth import Truth, check


def crops(folder: pathlib.Path, pattern: str) -> list:
    found = []
    for path in sorted(folder.glob("*.jpg")):
        found.append((path, *map(int, re.search(pattern, path.name).groups())))
    return found


def disjoint(train, query, gallery) -> None:
    check(train and query and gallery, "a folder is empty:", len(train), len(query), len(gallery))
    learnt, asked, shown = ({row[1] for row in rows} for rows in (train, query, gallery))
    check(not learnt & (asked | shown), "identities that are learnt and tested:", learnt & (asked | shown))


def looks(truth: Truth, classes) -> dict:
    """Number of a look, from 1 on, as videos and ids come."""
    numbers: dict = {}
    for video in truth.videos:
        for _, actor in sorted(truth.actors(video["name"]).items()):
            if actor["class"] in classes and "reid" in actor:
                numbers.setdefault(actor["reid"], len(numbers) + 1)
    return numbers


def market1501(truth: Truth, folder: pathlib.Path) -> None:
    pattern = r"([-\d]+)_c(\d)"  # torchreid.data.datasets.image.market1501
    train, query, gallery = (crops(folder / name, pattern) for name in ("bounding_box_train", "query", "bounding_box_test"))
    disjoint(train, query, gallery)
    numbers = looks(truth, {"pedestrian"})
    frames = {(int(f.video["video"]), f.camera, f.number): f for f in truth.frames}
    for path, identity, camera in train + query + gallery:
        check(0 <= identity <= 1501 and 1 <= camera <= 6, "Market-1501 has no such number:", path.name)
        session, number = map(int, re.search(r"s(\d+)_(\d+)_", path.name).groups())
        frame = frames[session - 1, f"camera_{chr(ord('a') + camera - 1)}", number]
        actors = truth.actors(frame.video["name"])
        own = [o for o in frame.objects if numbers.get(actors[o["id"]].get("reid")) == identity and o["class"] == "pedestrian"]
        check(own and Image.open(path).size in [tuple(o["bbox"][2:]) for o in own], "crop", path.name)
    print(f"  {len(train)} crops to learn, {len(query)} to ask, {len(gallery)} to find")


def veri(truth: Truth, folder: pathlib.Path) -> None:
    pattern = r"([-\d]+)_c(\d\d\d)"  # fastreid/data/datasets/veri.py
    train, query, gallery = (crops(folder / f"image_{name}", pattern) for name in ("train", "query", "test"))
    disjoint(train, query, gallery)
    for name, rows in (("train", train), ("query", query), ("test", gallery)):
        listed = (folder / f"name_{name}.txt").read_text().split()
        check(sorted(listed) == [row[0].name for row in rows], "names of", name)
        items = xml.parse(folder / f"{name}_label.xml").getroot().iter("Item")
        told = {item.get("imageName"): (int(item.get("vehicleID")), int(item.get("cameraID")[1:])) for item in items}
        check(told == {path.name: (identity, camera) for path, identity, camera in rows}, "labels of", name)
    brightness = np.mean([np.asarray(Image.open(row[0])).mean() for row in train[:20]])
    check(brightness > 1, "crops are black")
    print(f"  {len(train)} crops to learn, {len(query)} to ask, {len(gallery)} to find")
