"""Real sets, average precision and intervals of `endless_city.sim2real`; what needs PyTorch is in `test_sim2real_training.py`."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any, Optional

import numpy as np
import pytest

pytest.importorskip("PIL")
pytest.importorskip("yaml")

from PIL import Image  # noqa: E402

from endless_city import Dataset, DatasetError, RecipeError  # noqa: E402
from endless_city.sim2real.arguments import parse  # noqa: E402
from endless_city.sim2real.average_precision import Curve, Detections, outcome  # noqa: E402
from endless_city.sim2real.bootstrap import estimate, groups  # noqa: E402
from endless_city.sim2real.class_names import name_map  # noqa: E402
from endless_city.sim2real.fair import fair_tests  # noqa: E402
from endless_city.sim2real.labelled import (  # noqa: E402
    PEDESTRIAN,
    TWO_WHEELER,
    VEHICLE,
    LabelledImage,
    LabelledSet,
    Labels,
    labels_of,
    restricted,
)
from endless_city.sim2real.misses import RunOnTest, draw_sheet, judged  # noqa: E402
from endless_city.sim2real.real_set import Cameras, read_set  # noqa: E402
from endless_city.sim2real.riders import joined  # noqa: E402
from endless_city.sim2real.scores import score  # noqa: E402
from endless_city.sim2real.sizes import SIZES, sizes  # noqa: E402
from endless_city.sim2real.splits import split_named  # noqa: E402
from endless_city.sim2real.synthetic_set import synthetic_labels  # noqa: E402

USUAL = name_map([])


def read(path: Path | str, *, maps: tuple[str, ...] = (), regex: Optional[str] = None) -> LabelledSet:
    return read_set(str(path), name_map(maps), Cameras(regex))


def detections(*rows: tuple[list[float], float, int]) -> Detections:
    return Detections(
        np.array([row[0] for row in rows], dtype=float).reshape(-1, 4),
        np.array([row[1] for row in rows], dtype=float),
        np.array([row[2] for row in rows], dtype=int),
    )


def labelled(labels: Labels, *, name: str = "a", camera: Optional[str] = None) -> LabelledImage:
    return LabelledImage(name, (100, 100), labels, camera, name, lambda: np.zeros((100, 100, 3), np.uint8))


# Names.


@pytest.mark.parametrize(
    ("name", "target"),
    [
        ("Car", "vehicle"),
        ("pickup_truck", "vehicle"),
        ("auto-rickshaw", "vehicle"),
        ("Motorbike", "two_wheeler"),
        ("two-wheeler", "two_wheeler"),
        ("person", "pedestrian"),
        ("rider", "rider"),
        ("DontCare", "ignore"),
        ("dog", None),
        ("scary", None),
    ],
)
def test_usual_names_are_known(name: str, target: Optional[str]) -> None:
    assert USUAL.target(name) == target


def test_names_can_be_mapped() -> None:
    names = name_map(["Cargo Tricycle=two_wheeler", "car=ignore"])
    assert names.target("cargo_tricycle") == "two_wheeler"
    assert names.target("CAR") == "ignore"
    assert names.labelled(["car", "rider"]) == (TWO_WHEELER,)


@pytest.mark.parametrize("option", ["car", "car=plane", "=vehicle"])
def test_maps_that_make_no_sense(option: str) -> None:
    with pytest.raises(RecipeError, match="NAME=CLASS"):
        name_map([option])


# Riders.


def test_a_rider_and_what_is_ridden_are_one_box() -> None:
    records: list[dict[str, Any]] = [
        {"id": 1, "class": "motorcycle", "bbox": [10, 30, 20, 20], "pixels": 200, "rider_id": 2},
        {"id": 2, "class": "rider", "bbox": [12, 10, 10, 30], "pixels": 150, "vehicle_id": 1},
        {"id": 3, "class": "bicycle", "bbox": [60, 60, 20, 20], "pixels": 200},
        {"id": 4, "class": "rider", "bbox": [80, 10, 10, 30], "pixels": 150, "vehicle_id": 9},
        {"id": 5, "class": "pedestrian", "bbox": [0, 0, 5, 12], "pixels": 40},
    ]
    labels = synthetic_labels(records)
    assert labels.boxes.tolist() == [[10, 10, 30, 50], [60, 60, 80, 80], [80, 10, 90, 40], [0, 0, 5, 12]]
    assert labels.classes.tolist() == [TWO_WHEELER, TWO_WHEELER, TWO_WHEELER, PEDESTRIAN]
    assert not labels.ignored.any()


def test_what_nobody_would_label_is_ignored() -> None:
    records: list[dict[str, Any]] = [
        {"id": 1, "class": "car", "bbox": [0, 0, 7, 7], "pixels": 49},
        {"id": 2, "class": "car", "bbox": [0, 0, 8, 3], "pixels": 24},
        {"id": 3, "class": "van", "bbox": [0, 0, 100, 10], "pixels": 119},
        {"id": 4, "class": "van", "bbox": [0, 0, 100, 10], "pixels": 120},
        # Neither alone fills enough of the union.
        {"id": 5, "class": "bicycle", "bbox": [0, 0, 20, 50], "pixels": 60, "rider_id": 6},
        {"id": 6, "class": "rider", "bbox": [0, 0, 20, 50], "pixels": 60, "vehicle_id": 5},
    ]
    assert synthetic_labels(records).ignored.tolist() == [True, False, True, False, False]


def test_riders_of_real_sets_join_what_they_overlap() -> None:
    two_wheelers = [[10.0, 30.0, 30.0, 50.0], [60.0, 30.0, 80.0, 50.0]]
    rider, passenger, alone = [12.0, 10.0, 22.0, 40.0], [18.0, 12.0, 28.0, 40.0], [90.0, 10.0, 99.0, 40.0]
    assert joined([rider, passenger, alone], two_wheelers) == [[10, 10, 30, 50], [60, 30, 80, 50], alone]
    assert joined([rider], []) == [rider]


def test_frames_of_a_dataset_are_labelled_pictures(out: Path) -> None:
    whole = read(out)
    assert len(whole.images) == 16 and whole.classes == (VEHICLE, TWO_WHEELER, PEDESTRIAN)
    assert len(whole.cameras or []) == 4
    frame = Dataset(out)[5]
    image = whole.images[5]
    assert image.size == (161, 91) and (image.read() == frame.rgb).all()
    assert image.camera == f"{frame.video}/{frame.camera.name}"
    motor = [name in ("car", "van", "truck", "bus") for name in frame.objects.names]
    boxes = {tuple(box) for box in frame.objects.boxes_xyxy[motor]}
    assert {tuple(box) for box in image.labels.boxes[image.labels.classes == VEHICLE]} == boxes
    assert len(read_set(str(out), USUAL, Cameras(), most=5).images) == 5
    parts = [read(f"{out}@{part}") for part in ("train", "val")]
    assert not {image.source for image in parts[0].images} & {image.source for image in parts[1].images}


# YOLO.


def yolo(folder: Path, names: str = "names: [car, person, dog]\n", label: str = "0 0.5 0.5 0.2 0.4\n") -> Path:
    for part in ("images", "labels"):
        (folder / part).mkdir(parents=True)
    for name in ("cam1_a", "cam2_b"):
        Image.new("RGB", (100, 50)).save(folder / "images" / f"{name}.png")
    (folder / "labels" / "cam1_a.txt").write_text(label)
    (folder / "data.yaml").write_text(names)
    return folder


def test_yolo_boxes_and_polygons(tmp_path: Path) -> None:
    label = "0 0.5 0.5 0.2 0.4\n\n1 0.1 0.2 0.3 0.2 0.3 0.6\n2 0.5 0.5 0.1 0.1\n0 0.995 0.5 0.02 0.2\n"
    whole = read(yolo(tmp_path, label=label), regex=r"(cam\d)_")
    first, second = whole.images
    assert first.size == (100, 50) and first.camera == "cam1" and whole.cameras == ["cam1", "cam2"]
    # The last one reaches beyond the picture.
    assert np.allclose(first.labels.boxes, [[40, 15, 60, 35], [10, 10, 30, 30], [98.5, 20, 100, 30]])
    assert first.labels.classes.tolist() == [VEHICLE, PEDESTRIAN, VEHICLE]
    assert len(second.labels) == 0
    assert whole.classes == (VEHICLE, PEDESTRIAN)
    assert "dog (1)" in whole.notes[0]
    assert first.read().shape == (50, 100, 3)


def test_yolo_parts(tmp_path: Path) -> None:
    for part in ("train", "valid"):
        (tmp_path / part / "images").mkdir(parents=True)
        (tmp_path / part / "labels").mkdir()
        Image.new("RGB", (10, 10)).save(tmp_path / part / "images" / f"{part}.jpg")
        (tmp_path / part / "labels" / f"{part}.txt").write_text("0 0.5 0.5 1 1\n")
    # As Roboflow writes it.
    (tmp_path / "data.yaml").write_text("train: ../train/images\nval: ../valid/images\nnames: {0: bus}\n")
    assert len(read(tmp_path).images) == 2
    assert [image.name for image in read(f"{tmp_path}@val").images] == ["valid/images/valid.jpg"]
    with pytest.raises(DatasetError, match="no part 'test': use one of train, val"):
        read(f"{tmp_path}@test")


@pytest.mark.parametrize(
    ("names", "label", "message"),
    [
        ("names: [car]\n", "1 0.5 0.5 0.1 0.1\n", "class 1, but names has 0 to 0.*cam1_a.txt:1"),
        ("names: [car]\n", "0 0.5 0.5 0.1\n", "has 4 numbers"),
        ("names: [car]\n", "0 50 20 10 10\n", "no shares"),
        ("names: [car]\n", "0 nan 0.5 0.1 0.1\n", "no shares"),
        ("names: [car]\n", "\n0 0.5 a 0.1 0.1\n", "no numbers.*cam1_a.txt:2"),
        ("names: [dog]\n", "0 0.5 0.5 0.1 0.1\n", "--map"),
        ("names: []\n", "0 0.5 0.5 0.1 0.1\n", "no names of classes"),
        ("names: [car\n", "0 0.5 0.5 0.1 0.1\n", "YAML file cannot be read"),
    ],
)
def test_broken_yolo(tmp_path: Path, names: str, label: str, message: str) -> None:
    with pytest.raises(DatasetError, match=message):
        read(yolo(tmp_path, names, label))


def test_yolo_without_pictures_or_labels(tmp_path: Path) -> None:
    folder = yolo(tmp_path)
    (folder / "images" / "cam2_b.png").write_bytes(b"no picture")
    with pytest.raises(DatasetError, match="cannot be read.*cam2_b.png"):
        read(folder)
    (folder / "images" / "cam2_b.png").unlink()
    (folder / "labels" / "cam1_a.txt").unlink()
    with pytest.raises(DatasetError, match="none of 1 pictures has labels"):
        read(folder)
    (folder / "images" / "cam1_a.png").unlink()
    with pytest.raises(DatasetError, match="no pictures"):
        read(folder)


# COCO.


def coco(folder: Path, **changed: Any) -> Path:
    (folder / "annotations").mkdir(parents=True)
    (folder / "val2017").mkdir()
    Image.new("RGB", (100, 50)).save(folder / "val2017" / "1.jpg")
    content = {
        "images": [{"id": 7, "file_name": "1.jpg", "width": 100, "height": 50}],
        "categories": [{"id": 3, "name": "car"}, {"id": 4, "name": "bicycle"}, {"id": 5, "name": "rider"}],
        "annotations": [
            {"image_id": 7, "category_id": 3, "bbox": [10, 10, 20, 20]},
            {"image_id": 7, "category_id": 3, "bbox": [50, 10, 40, 20], "iscrowd": 1},
            {"image_id": 7, "category_id": 4, "bbox": [0, 30, 10, 10]},
            {"image_id": 7, "category_id": 5, "bbox": [0, 20, 10, 15]},
        ],
        **changed,
    }
    (folder / "annotations" / "instances_val2017.json").write_text(json.dumps(content))
    return folder


def test_coco_folders_and_files(tmp_path: Path) -> None:
    folder = coco(tmp_path)
    (folder / "annotations" / "captions_val2017.json").write_text((folder / "annotations" / "instances_val2017.json").read_text())
    for path in (folder, folder / "annotations" / "instances_val2017.json", f"{folder}@val"):
        whole = read(path)
        labels = whole.images[0].labels
        assert whole.classes == (VEHICLE, TWO_WHEELER)
        assert labels.boxes.tolist() == [[10, 10, 30, 30], [50, 10, 90, 30], [0, 20, 10, 40]]
        assert labels.ignored.tolist() == [False, True, False]


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"images": [{"id": 7, "file_name": "2.jpg"}]}, "no picture 2.jpg"),
        ({"images": [{"id": 7, "file_name": "1.jpg", "width": 50, "height": 50}]}, "is 100x50, but its labels are for 50x50"),
        ({"images": [{"id": 8, "file_name": "1.jpg"}]}, "4 annotations are of pictures"),
        ({"images": [{"id": 8}]}, "no id or no file_name"),
        ({"annotations": [{"image_id": 7, "category_id": 9, "bbox": [1, 1, 2, 2]}]}, "annotation 0 of"),
        ({"annotations": [{"image_id": 7, "category_id": 3, "bbox": [1, 1, 2]}]}, "annotation 0 of"),
        ({"annotations": [{"image_id": 7, "category_id": 3}]}, "annotation 0 of"),
        ({"annotations": [{"image_id": 7, "category_id": [3], "bbox": [1, 1, 2, 2]}]}, "annotation 0 of"),
        ({"annotations": [{"image_id": 7, "category_id": 3, "bbox": [1, 1, float("nan"), 2]}]}, "annotation 0 of"),
        ({"categories": [{"id": 3}]}, "category has no id or no name"),
        ({"images": [], "annotations": []}, "no pictures"),
    ],
)
def test_broken_coco(tmp_path: Path, changed: dict[str, Any], message: str) -> None:
    with pytest.raises(DatasetError, match=message):
        read(coco(tmp_path, **changed))


def test_files_that_are_no_set(tmp_path: Path) -> None:
    with pytest.raises(DatasetError, match="no such file or folder"):
        read(tmp_path / "nowhere")
    with pytest.raises(DatasetError, match="no folder in YOLO's format"):
        read(tmp_path)
    (tmp_path / "list.json").write_text("[]")
    with pytest.raises(DatasetError, match="none of COCO's"):
        read(tmp_path / "list.json")
    (tmp_path / "half.json").write_text("{")
    with pytest.raises(DatasetError, match="JSON file cannot be read"):
        read(tmp_path / "half.json")


def test_cameras_are_known_for_all_pictures_or_for_none(tmp_path: Path) -> None:
    folder = yolo(tmp_path)
    assert read(folder, regex="nothing").cameras is None
    assert read(folder, regex=r"cam\d").cameras == ["cam1", "cam2"]
    with pytest.raises(DatasetError, match="no camera in the name images/cam2_b.png"):
        read(folder, regex="cam1")
    with pytest.raises(RecipeError, match="--camera-regex"):
        Cameras("(")


@pytest.mark.parametrize(
    ("path", "split"),
    [
        ("images/train/1.jpg", "train"),
        ("instances_val2017", "val"),
        ("valid/_annotations.coco", "val"),
        ("testing/1", "test"),
        ("trainer/constrain", None),
        ("images/1", None),
    ],
)
def test_parts_are_named_by_paths(path: str, split: Optional[str]) -> None:
    assert split_named(path) == split


# Average precision.


def test_average_precision_by_hand() -> None:
    # Right, wrong, right, of two objects: precision 1 up to half of them, 2/3 up to all.
    curve = Curve(np.array([0.9, 0.8, 0.7]), np.array([0, 0, 0]), np.array([0, 2]))
    assert curve.average_precision(np.array([2.0])) == pytest.approx((51 * 1 + 50 * 2 / 3) / 101)
    # A third that is never found.
    assert curve.average_precision(np.array([3.0])) == pytest.approx((34 * 1 + 33 * 2 / 3) / 101)
    assert math.isnan(curve.average_precision(np.array([0.0])))
    assert Curve(np.zeros(0), np.zeros(0, int), np.zeros(0, int)).average_precision(np.array([1.0])) == 0


def test_weights_are_repeated_pictures() -> None:
    random = np.random.default_rng(1)
    labels, found = scene(random, 6)
    weights = np.array([0, 1, 2, 1, 0, 3])
    repeated = [place for place, times in enumerate(weights) for _ in range(times)]
    weighted = outcome(labels, found, VEHICLE)
    explicit = outcome([labels[place] for place in repeated], [found[place] for place in repeated], VEHICLE)
    assert weighted.ap50(weights.astype(float)) == pytest.approx(explicit.ap50())
    assert weighted.ap50_95(weights.astype(float)) == pytest.approx(explicit.ap50_95())


def test_each_object_is_found_once_and_crowds_by_many() -> None:
    labels = labels_of([([0, 0, 10, 10], VEHICLE, False), ([50, 0, 90, 40], VEHICLE, True)])
    found = detections(
        ([0, 0, 10, 10], 0.9, VEHICLE),
        ([0, 0, 10, 9], 0.8, VEHICLE),
        ([50, 0, 60, 10], 0.7, VEHICLE),
        ([70, 0, 80, 10], 0.6, VEHICLE),
        ([0, 0, 10, 10], 0.95, PEDESTRIAN),
    )
    result = outcome([labels], [found], VEHICLE)
    assert result.objects.tolist() == [1] and result.ap50() == 1
    assert result.curves[0].scores.tolist() == [0.9, 0.8] and result.curves[0].true.tolist() == [0]
    assert result.found_scores[0][0] == 0.9 and math.isnan(result.found_scores[0][1])
    assert result.recall(0.5) == 1 and result.recall(0.95) == 0


def test_the_score_with_one_false_detection() -> None:
    curve = Curve(np.array([0.9, 0.8, 0.7, 0.7, 0.6]), np.zeros(5, int), np.array([0, 2]))
    assert curve.score_at_false(0) == 0.9
    # The next false one has the score of a true one.
    assert curve.score_at_false(1) == 0.8
    assert curve.score_at_false(2) == 0.7
    assert curve.score_at_false(3) == 0
    assert Curve(np.array([0.9]), np.zeros(1, int), np.zeros(0, int)).score_at_false(0) > 1


def scene(random: np.random.Generator, pictures: int) -> tuple[list[Labels], list[Detections]]:
    """Objects and detections near them and elsewhere; some objects stand for crowds."""
    labels: list[Labels] = []
    found: list[Detections] = []
    for _ in range(pictures):
        corners = random.uniform(0, 300, (8, 2))
        boxes = np.concatenate([corners, corners + random.uniform(5, 150, (8, 2))], 1)
        labels.append(Labels(boxes, random.integers(0, 2, 8), random.random(8) < 0.15))
        near = boxes[random.integers(0, 8, 12)] + random.normal(0, 6, (12, 4))
        elsewhere = random.uniform(0, 200, (5, 2))
        far = np.concatenate([elsewhere, elsewhere + random.uniform(5, 120, (5, 2))], 1)
        both = np.concatenate([near, far])
        both[:, 2:] = np.maximum(both[:, 2:], both[:, :2] + 1)
        found.append(Detections(both, random.random(17), random.integers(0, 2, 17)))
    return labels, found


def test_average_precision_is_that_of_pycocotools() -> None:
    coco_module = pytest.importorskip("pycocotools.coco")
    evaluation = pytest.importorskip("pycocotools.cocoeval")
    labels, found = scene(np.random.default_rng(0), 20)
    truth = coco_module.COCO()
    rows = [
        {
            "id": 100 * image + place + 1,
            "image_id": image,
            "category_id": int(one.classes[place]),
            "bbox": xywh(one.boxes[place]),
            "area": float(np.prod(one.boxes[place][2:] - one.boxes[place][:2])),
            "iscrowd": int(one.ignored[place]),
        }
        for image, one in enumerate(labels)
        for place in range(len(one))
    ]
    truth.dataset = {"images": [{"id": image} for image in range(20)], "categories": [{"id": 0}, {"id": 1}], "annotations": rows}
    truth.createIndex()
    given = [
        {"image_id": image, "category_id": int(number), "bbox": xywh(box), "score": float(confidence)}
        for image, one in enumerate(found)
        for box, confidence, number in zip(one.boxes, one.scores, one.classes)
    ]
    judge = evaluation.COCOeval(truth, truth.loadRes(given), "bbox")
    judge.evaluate()
    judge.accumulate()
    # Thresholds, recalls, classes, areas, numbers of detections.
    precision = judge.eval["precision"]
    small, large = 32.0**2, 96.0**2
    limits = {0: (0, 1e10), 1: (0, small), 2: (small, large), 3: (large, 1e10)}
    for number in range(2):
        for area, (low, high) in limits.items():
            inside = [
                (between(one.boxes, low, high), between(two.of_class(number).boxes, low, high))
                for one, two in zip(labels, found)
            ]
            result = outcome(labels, found, number, inside=inside)
            expected = precision[:, :, number, area, 2].mean(1)
            ours = [curve.average_precision(result.objects) for curve in result.curves]
            assert ours == pytest.approx(expected.tolist(), abs=1e-9)
        assert outcome(labels, found, number).ap50_95() == pytest.approx(precision[:, :, number, 0, 2].mean(), abs=1e-9)


def xywh(box: Any) -> list[float]:
    return [float(box[0]), float(box[1]), float(box[2] - box[0]), float(box[3] - box[1])]


def between(boxes: Any, low: float, high: float) -> Any:
    area = np.prod(boxes[:, 2:] - boxes[:, :2], axis=1)
    return (area >= low) & (area <= high)


def test_sizes_are_those_that_the_detector_sees() -> None:
    boxes = np.array([[0, 0, 15, 15], [0, 0, 16, 4], [0, 0, 32, 32], [0, 0, 96, 96], [0, 0, 96, 95]], dtype=float)
    assert [SIZES[place] for place in sizes(boxes, 1.0)] == ["tiny", "small", "medium", "large", "medium"]
    assert [SIZES[place] for place in sizes(boxes, 0.5)] == ["tiny", "tiny", "small", "medium", "medium"]
    assert len(sizes(np.zeros((0, 4)), 1.0)) == 0


# Intervals.


def test_cameras_are_drawn_whole() -> None:
    images = [labelled(labels_of([]), name=str(place), camera=f"camera {place % 3}") for place in range(12)]
    drawn = groups(images)
    assert (drawn.kind, drawn.count) == ("cameras", 3)
    weights = drawn.weights(50)
    assert weights.shape == (50, 12) and (weights.sum(1) == 12).all()
    assert all((weights[:, place] == weights[:, place % 3]).all() for place in range(12))
    assert (weights == drawn.weights(50)).all()
    one_camera = [labelled(labels_of([]), name=str(place), camera="a") for place in range(4)]
    assert groups(one_camera).kind == "pictures" and groups(one_camera).count == 4
    assert groups([labelled(labels_of([])), labelled(labels_of([]), name="b", camera="a")]).kind == "pictures"


def test_intervals_hold_the_mean_and_narrow_with_more_pictures() -> None:
    widths: list[float] = []
    for pictures in (10, 160):
        labels, found = scene(np.random.default_rng(2), pictures)
        images = [labelled(one, name=str(place)) for place, one in enumerate(labels)]
        result = outcome(labels, found, VEHICLE)
        value, drawn = estimate([result.ap50, result.ap50], groups(images).weights(200))
        assert value.low < value.mean < value.high and len(drawn) == 200
        assert value.spread == 0 and value.mean == result.ap50()
        widths.append(value.high - value.low)
    assert widths[1] < widths[0] / 2


def test_an_interval_over_cameras_is_wider_where_they_differ() -> None:
    seen, unseen = detections(([0, 0, 10, 10], 0.9, VEHICLE)), detections()
    truth = labels_of([([0, 0, 10, 10], VEHICLE, False)])
    images = [labelled(truth, name=str(place), camera="good" if place < 20 else "bad") for place in range(40)]
    found = [seen if place < 20 else unseen for place in range(40)]
    unknown = [labelled(truth, name=str(place)) for place in range(40)]
    over_cameras = score("run", "test", images, [found], [VEHICLE], longest=100, draws=200)
    over_pictures = score("run", "test", unknown, [found], [VEHICLE], longest=100, draws=200)
    assert (over_cameras.drawn, over_pictures.drawn) == ("cameras", "pictures")
    assert (over_cameras.mean_ap50.low, over_cameras.mean_ap50.high) == (0, 1)
    assert 0.2 < over_pictures.mean_ap50.low < 0.5 < over_pictures.mean_ap50.high < 0.8


def test_scores_are_by_class_and_size() -> None:
    truth = labels_of([([0, 0, 10, 10], VEHICLE, False), ([20, 20, 60, 80], VEHICLE, False), ([0, 50, 5, 62], PEDESTRIAN, False)])
    found = detections(([0, 0, 10, 10], 0.9, VEHICLE), ([70, 70, 90, 90], 0.8, VEHICLE))
    result = score("run", "test", [labelled(truth)], [[found], [found]], [VEHICLE, TWO_WHEELER, PEDESTRIAN], longest=100, draws=20)
    assert [(row.name, row.boxes, row.recall) for row in result.classes] == [("vehicle", 2, 0.5), ("pedestrian", 1, 0)]
    assert [(row.name, row.size, row.boxes, row.recall) for row in result.sizes] == [
        ("vehicle", "tiny", 1, 1),
        ("vehicle", "medium", 1, 0),
        ("pedestrian", "tiny", 1, 0),
    ]
    assert result.mean_ap50.seeds == [pytest.approx((51 / 101) / 2)] * 2


# What runs are tested on.


def test_pictures_of_cameras_that_were_learnt_from_are_not_tested() -> None:
    truth = labels_of([([0, 0, 10, 10], VEHICLE, False)])
    learnt = LabelledSet("learnt", [labelled(truth, name="1", camera="a"), labelled(truth, name="2")], (VEHICLE,))
    images = [labelled(truth, name="3", camera="a"), labelled(truth, name="2"), labelled(truth, name="4", camera="b")]
    fair, reasons = fair_tests("run", [learnt], {"own": learnt, "other": LabelledSet("other", images, (VEHICLE, PEDESTRIAN))})
    assert [image.name for image in fair["other"].images] == ["4"]
    assert (fair["other"].skipped, fair["other"].classes) == (2, [VEHICLE])
    assert "own" not in fair and "learns from all its pictures" in reasons[0]
    with pytest.raises(DatasetError, match="learns from all its pictures"):
        fair_tests("run", [learnt], {"own": learnt})
    people = LabelledSet("people", [labelled(truth, name="5")], (PEDESTRIAN,))
    with pytest.raises(DatasetError, match="it learns vehicle, and people labels pedestrian"):
        fair_tests("run", [learnt], {"people": people})
    assert len(restricted(learnt, [PEDESTRIAN]).images[0].labels) == 0


def test_the_sheet_shows_what_was_false_and_missed(tmp_path: Path) -> None:
    truth = labels_of([([0, 0, 10, 10], VEHICLE, False), ([50, 50, 90, 90], VEHICLE, False), ([20, 0, 30, 10], VEHICLE, True)])
    found = detections(
        ([0, 0, 10, 10], 0.9, VEHICLE),
        ([60, 0, 80, 20], 0.8, VEHICLE),
        ([20, 0, 30, 10], 0.7, VEHICLE),
        ([70, 0, 80, 20], 0.1, VEHICLE),
    )
    tested = RunOnTest("run", "test", [labelled(truth)], [found], {VEHICLE: 0.5})
    result = judged(tested)
    assert [(miss.title, miss.box.tolist()) for miss in result.false] == [("false vehicle 0.80", [60, 0, 80, 20])]
    assert [(miss.title, miss.box.tolist()) for miss in result.missed] == [("missed vehicle", [50, 50, 90, 90])]
    assert [box.tolist() for box in result.found[0]] == [[0, 0, 10, 10]]
    draw_sheet([tested, tested], tmp_path / "misses.png")
    with Image.open(tmp_path / "misses.png") as sheet:
        colours = {colour for _, colour in sheet.convert("RGB").getcolors(1 << 20) or []}
    assert {(255, 140, 0), (235, 0, 235), (0, 200, 80)} <= colours


# Arguments.


def test_arguments(out: Path) -> None:
    tests = ["--test", "a=b", "--test", "c"]
    options = parse([str(out), *tests, "--train", "real=x,y", "--classes", "pedestrian,vehicle", "--size", "500"])
    assert [(run.name, run.sets) for run in options.runs] == [("synthetic", (str(out),)), ("real", ("x", "y"))]
    assert options.tests == (("a", "b"), ("c", "c"))
    assert options.classes == (VEHICLE, PEDESTRIAN)
    assert (options.size, options.test_size, options.seeds) == (512, 608, (0, 1))
    assert parse([str(out), "--train-also", "x", "--test", "a"]).runs[0].name == "mixed"
    assert parse(["--test", "a", "x", "--seeds", "3", "y"]).runs[0].sets == ("x", "y")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--test", "a"], "nothing to learn from"),
        (["x", "--test", "a", "--test", "b/a"], "--test has 'a' twice"),
        (["--train", "x", "--test", "a"], "NAME=SET"),
        (["--train-also", "x", "--test", "a"], "needs a dataset OUT"),
        (["x", "--test", "a", "--classes", "plane"], "--classes cannot be"),
        (["x", "--test", "a", "--seeds", "one"], "--seeds cannot be"),
        (["x", "--test", "a", "--seeds", "-1"], "--seeds cannot be"),
        (["x", "--test", "a", "--size", "8"], "--size cannot be"),
    ],
)
def test_arguments_that_make_no_sense(arguments: list[str], message: str) -> None:
    with pytest.raises(RecipeError, match=message):
        parse(arguments)
