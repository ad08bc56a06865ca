"""COCO: pycocotools loads it, perfect detections of the same labels score 1, masks are the dataset's to the pixel."""

import contextlib
import io
import json
import pathlib

import numpy as np
from PIL import Image
from pycocotools.coco import COCO
from pycocotools.cocoeval import COCOeval

from .datumaro_reader import with_datumaro
from .truth import Truth, check, one_video_one_part


def quiet(function, *arguments, **named):
    with contextlib.redirect_stdout(io.StringIO()):
        return function(*arguments, **named)


def average_precision(truth: COCO, kind: str) -> float:
    """Of the labels themselves as detections."""
    entries = []
    for annotation in truth.dataset["annotations"]:
        if kind == "keypoints" and annotation["num_keypoints"] == 0:
            continue  # Nobody finds these: COCO leaves them out, too.
        entry = {key: annotation[key] for key in ("image_id", "category_id", "bbox", "segmentation", "keypoints") if key in annotation}
        entries.append(entry | {"score": 1.0})
    found = quiet(truth.loadRes, entries)
    evaluation = COCOeval(truth, found, kind)
    evaluation.params.maxDets = [1000] if kind == "keypoints" else [1, 10, 1000]
    quiet(evaluation.evaluate)
    quiet(evaluation.accumulate)
    precision = evaluation.eval["precision"][:, :, :, 0, -1]
    return float(precision[precision > -1].mean())


def detection(truth: Truth, folder: pathlib.Path, files: dict, images: dict, polygons: bool = False) -> None:
    names: dict = {}
    boxes = 0
    worst = 1.0
    for split, path in files.items():
        coco = quiet(COCO, str(path))
        names[split] = {pathlib.Path(image["file_name"]).stem for image in coco.dataset["images"]}
        ids = [annotation["id"] for annotation in coco.dataset["annotations"]]
        check(ids == list(range(1, len(ids) + 1)), "ids of annotations are not 1 to n:", path)
        for image in coco.dataset["images"]:
            frame = truth.by_name[pathlib.Path(image["file_name"]).stem]
            check((images[split] / image["file_name"]).is_file(), "no picture", image["file_name"])
            check([image["width"], image["height"]] == [truth.width, truth.height], "size of", image)
            own = {annotation["track_id"]: annotation for annotation in coco.imgToAnns[image["id"]]}
            check(set(own) == {o["id"] for o in frame.objects}, "objects of", frame.name)
            for o in frame.objects:
                annotation = own[o["id"]]
                category = coco.cats[annotation["category_id"]]["name"]
                check(category == o["class"] and annotation["bbox"] == o["bbox"], frame.name, o["id"])
                check(annotation["area"] == o["pixels"] and annotation["iscrowd"] == 0, frame.name, o["id"])
                mask, expected = coco.annToMask(annotation).astype(bool), frame.mask(o["id"])
                if polygons:
                    worst = min(worst, (mask & expected).sum() / (mask | expected).sum())
                else:
                    check((mask == expected).all(), "mask of", frame.name, o["id"])
            boxes += len(frame.objects)
        if coco.dataset["annotations"]:
            for kind in ("bbox", "segm"):
                check(average_precision(coco, kind) == 1.0, kind, "AP of", split, average_precision(coco, kind))
    check(boxes == truth.boxes, boxes, "boxes of", truth.boxes)
    check(set().union(*names.values()) == set(truth.by_name), "pictures are missing")
    one_video_one_part(names)
    # As pycocotools fills polygons, which are exact: it rounds as it goes along their edges.
    check(worst > 0.97, "IoU of a mask with its polygon", worst)
    print(f"  {boxes} boxes and masks, AP 1.0, least IoU {worst:.4f}")


def coco(truth: Truth, folder: pathlib.Path) -> None:
    splits = ["train", "val"]
    print(f"  {with_datumaro(folder, 'coco_instances', truth.boxes)}")
    files = {split: folder / f"annotations/instances_{split}.json" for split in splits}
    detection(truth, folder, files, {split: folder / "images" / split for split in splits})


def coco_polygons(truth: Truth, folder: pathlib.Path) -> None:
    splits = ["train", "val"]
    files = {split: folder / f"annotations/instances_{split}.json" for split in splits}
    detection(truth, folder, files, {split: folder / "images" / split for split in splits}, polygons=True)


def roboflow(truth: Truth, folder: pathlib.Path) -> None:
    files = {split: folder / split / "_annotations.coco.json" for split in ("train", "valid")}
    detection(truth, folder, files, {split: folder / split for split in files}, polygons=True)


def coco_keypoints(truth: Truth, folder: pathlib.Path) -> None:
    people = 0
    for split in ("train", "val"):
        coco = quiet(COCO, str(folder / f"annotations/person_keypoints_{split}.json"))
        check(coco.cats[1]["keypoints"] == truth.manifest["labels"]["keypoints"], "names of keypoints")
        for image in coco.dataset["images"]:
            frame = truth.by_name[pathlib.Path(image["file_name"]).stem]
            own = {annotation["track_id"]: annotation for annotation in coco.imgToAnns[image["id"]]}
            expected = {o["id"]: o for o in frame.objects if "keypoints" in o}
            check(set(own) == set(expected), "people of", frame.name)
            for number, o in expected.items():
                check(own[number]["keypoints"] == o["keypoints"], "keypoints of", frame.name, number)
                check(own[number]["num_keypoints"] == o["num_keypoints"], "their number", frame.name, number)
            people += len(expected)
        if coco.dataset["annotations"]:
            check(average_precision(coco, "keypoints") == 1.0, "keypoint AP of", split)
    print(f"  {people} people, OKS AP 1.0")


def coco_panoptic(truth: Truth, folder: pathlib.Path) -> None:
    """As panopticapi's evaluation reads it: id = R + 256 G + 65536 B, every segment told, areas equal."""
    segments = 0
    for split in ("train", "val"):
        document = json.loads((folder / f"annotations/panoptic_{split}.json").read_text())
        names = {image["id"]: image["file_name"] for image in document["images"]}
        categories = {category["id"]: category for category in document["categories"]}
        check(len(names) == len(document["annotations"]), "an annotation a picture")
        for annotation in document["annotations"]:
            frame = truth.by_name[pathlib.Path(names[annotation["image_id"]]).stem]
            rgb = np.asarray(Image.open(folder / f"annotations/panoptic_{split}" / annotation["file_name"])).astype(np.uint32)
            ids = rgb[..., 0] + 256 * rgb[..., 1] + 65536 * rgb[..., 2]
            told = {segment["id"]: segment for segment in annotation["segments_info"]}
            labels, areas = np.unique(ids, return_counts=True)
            shown = {int(label): int(area) for label, area in zip(labels, areas) if label}
            check(set(told) == set(shown), "segments of", frame.name)
            tag, instance = frame.instance
            labelled = {o["id"]: o for o in frame.objects}
            for number, segment in told.items():
                check(segment["area"] == shown[number], "area of", frame.name, number)
                ys, xs = np.nonzero(ids == number)
                box = [xs.min(), ys.min(), np.ptp(xs) + 1, np.ptp(ys) + 1]
                check([int(v) for v in box] == segment["bbox"], "box of", frame.name, number)
                category = categories[segment["category_id"]]
                if category["isthing"]:
                    check(category["name"] == labelled[number & 0xFFFF]["class"], frame.name, number)
                    check((ids == number).sum() == labelled[number & 0xFFFF]["pixels"], frame.name, number)
            void = ids == 0
            unlabelled = (instance > 0) & ~np.isin(instance, list(labelled))
            check((void == (unlabelled | ((tag == 0) & (instance == 0)))).all(), "void of", frame.name)
            segments += len(told)
    print(f"  {segments} segments; {with_datumaro(folder, 'coco_panoptic', segments)}")
