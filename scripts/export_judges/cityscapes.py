"""Cityscapes: its own labels, and its own evaluation of the truth against itself."""

import contextlib
import csv
import io
import pathlib

import numpy as np
from PIL import Image

from .truth import Truth, check, one_video_one_part

OURS = {"car": 26, "van": 26, "truck": 27, "bus": 28, "motorcycle": 32, "bicycle": 33, "rider": 25, "pedestrian": 24}


def cityscapes(truth: Truth, folder: pathlib.Path) -> None:
    from cityscapesscripts.evaluation import evalPixelLevelSemanticLabeling as semantic
    from cityscapesscripts.helpers.labels import id2label, name2label

    check(name2label["person"].id == 24 and id2label[26].name == "car", "labels")
    listed = {row["name"]: row for row in csv.DictReader((folder / "frames.csv").open())}
    parts, objects, truths = {}, 0, []
    for split in ("train", "val"):
        parts[split] = []
        for path in sorted((folder / "gtFine" / split).glob("*/*_labelIds.png")):
            name = path.name.removesuffix("_gtFine_labelIds.png")
            row = listed[name]
            frame = truth.by_name[f"{row['video']}_{row['camera']}_{int(row['frame']):06}"]
            parts[split].append(frame.name)
            city = path.parent.name
            check((folder / "leftImg8bit" / split / city / f"{name}_leftImg8bit.png").is_file(), "no picture", name)
            image = lambda kind: np.asarray(Image.open(path.with_name(f"{name}_gtFine_{kind}.png")))  # noqa: E731
            labels, trained, instances, colors = map(image, ("labelIds", "labelTrainIds", "instanceIds", "color"))
            check(labels.dtype == np.uint8 and instances.max() >= 24, "depths of", name)
            check((np.where(instances >= 1000, instances // 1000, instances) == labels).all(), "instances of", name)
            for number in np.unique(labels):
                label = id2label[int(number)]
                expected = 255 if label.trainId in (-1, 255) else label.trainId
                check((trained[labels == number] == expected).all(), "trainIds of", name, label.name)
                check((colors[labels == number] == label.color).all(), "colours of", name, label.name)
            for o in frame.objects:
                mask = frame.mask(o["id"])
                values = np.unique(instances[mask])
                check(len(values) == 1 and values[0] // 1000 == OURS[o["class"]], "object of", name, o["id"], values)
                check((instances == values[0]).sum() == mask.sum(), "two objects are one in", name)
                objects += 1
            truths.append(str(path))
    one_video_one_part(parts)
    check(len(truths) == len(truth.frames), "pictures are missing")
    semantic.args.quiet = True
    semantic.args.JSONOutput = False
    semantic.args.evalInstLevelScore = False
    with contextlib.redirect_stdout(io.StringIO()):
        result = semantic.evaluateImgLists(truths, truths, semantic.args)
    check(abs(result["averageScoreClasses"] - 1) < 1e-9, "IoU of the truth with itself", result["averageScoreClasses"])
    print(f"  {len(truths)} pictures, {objects} objects, IoU of classes 1.0")
