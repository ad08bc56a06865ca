"""MOTChallenge, MOTS and KITTI's tracking: TrackEval finds the truth against itself perfect."""

import configparser
import contextlib
import io
import pathlib
import shutil

import numpy as np
import trackeval
from pycocotools import mask as masks

from .truth import Truth, check, one_video_one_part


def perfect(dataset, kinds) -> None:
    """All of TrackEval's own measures at 1."""
    evaluator = trackeval.Evaluator({
        "PRINT_RESULTS": False, "PRINT_CONFIG": False, "TIME_PROGRESS": False, "OUTPUT_SUMMARY": False, "OUTPUT_DETAILED": False,
        "PLOT_CURVES": False, "BREAK_ON_ERROR": True, "USE_PARALLEL": False, "OUTPUT_EMPTY_CLASSES": False,
        "RETURN_ON_ERROR": False, "LOG_ON_ERROR": None,
    })
    quiet = {"PRINT_CONFIG": False, "THRESHOLD": 0.5}
    with contextlib.redirect_stdout(io.StringIO()):
        measures = [trackeval.metrics.HOTA(), trackeval.metrics.CLEAR(quiet), trackeval.metrics.Identity(quiet)]
        results, _ = evaluator.evaluate([dataset], measures)
    of_all = results[dataset.get_name()]["self"]["COMBINED_SEQ"]
    for kind in kinds:
        found = of_all[kind]
        hota, identity = found["HOTA"]["HOTA"].mean(), found["Identity"]["IDF1"]
        check(hota > 0.9999 and identity == 1.0, kind, "HOTA", hota, "IDF1", identity)


def seqinfo(truth: Truth, sequence: pathlib.Path) -> None:
    info = configparser.ConfigParser()
    info.read(sequence / "seqinfo.ini")
    info = info["Sequence"]
    pictures = sorted((sequence / "img1").iterdir())
    check(info["name"] == sequence.name and int(info["seqLength"]) == len(pictures), "seqinfo of", sequence)
    check(float(info["frameRate"]) == truth.fps and int(info["imWidth"]) == truth.width, "seqinfo of", sequence)
    check([p.name for p in pictures] == [f"{i + 1:06}{info['imExt']}" for i in range(len(pictures))], "pictures of", sequence)


def sequences(truth: Truth, folder: pathlib.Path):
    parts = {}
    for split in ("train", "val"):
        names = (folder / f"seqmaps/{split}.txt").read_text().split()[1:]
        check(names == sorted(path.name for path in (folder / split).iterdir()), "sequences of", split)
        parts[split] = names
        for name in names:
            yield split, folder / split / name
    one_video_one_part(parts)
    check(sum(map(len, parts.values())) == len({(f.video["name"], f.camera) for f in truth.frames}), "sequences are missing")


def mot(truth: Truth, folder: pathlib.Path) -> None:
    count, people = 0, 0
    trackers = folder.parent / "mot_trackers"
    shutil.rmtree(trackers, ignore_errors=True)
    for split, sequence in sequences(truth, folder):
        seqinfo(truth, sequence)
        rows = [line.split(",") for line in (sequence / "gt/gt.txt").read_text().splitlines()]
        expected = [(f, o) for f in truth.frames if f.name.startswith(sequence.name + "_") for o in f.objects]
        check(len(rows) == len(expected), "lines of", sequence, len(rows), len(expected))
        results = []
        for row, (frame, o) in zip(rows, expected):
            x, y, w, h = o["bbox"]
            check(list(map(int, row[:7])) == [frame.number + 1, o["id"], x + 1, y + 1, w, h, 1], sequence, row)
            check(float(row[8]) == o["visibility"], "visibility of", sequence, row)
            if row[7] == "1":
                results.append(",".join(row[:6] + ["1", "-1", "-1", "-1"]))
        people += len(results)
        path = trackers / f"{split}/self/data/{sequence.name}.txt"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("\n".join(results) + "\n" if results else "")
        count += len(rows)
    for split in ("train", "val"):
        evaluate("MotChallenge2DBox", folder, trackers, split, "pedestrian")
    print(f"  {count} boxes; {people} of people: HOTA 100, IDF1 100")


def evaluate(kind: str, folder: pathlib.Path, trackers: pathlib.Path, split: str, judged: str) -> None:
    names = (folder / f"seqmaps/{split}.txt").read_text().split()[1:]
    lengths = {}
    for name in names:
        info = configparser.ConfigParser()
        info.read(folder / split / name / "seqinfo.ini")
        lengths[name] = int(info["Sequence"]["seqLength"])
    configuration = {
        "GT_FOLDER": str(folder / split), "TRACKERS_FOLDER": str(trackers / split), "TRACKERS_TO_EVAL": ["self"],
        "OUTPUT_FOLDER": str(trackers / "results"), "CLASSES_TO_EVAL": [judged], "SKIP_SPLIT_FOL": True, "SEQ_INFO": lengths,
        "PRINT_CONFIG": False, "TRACKER_SUB_FOLDER": "data",
    }
    with contextlib.redirect_stdout(io.StringIO()):
        dataset = getattr(trackeval.datasets, kind)(configuration)
    perfect(dataset, [judged])


def mots(truth: Truth, folder: pathlib.Path) -> None:
    count = 0
    trackers = folder.parent / "mots_trackers"
    shutil.rmtree(trackers, ignore_errors=True)
    numbers = {"car": 1, "van": 1, "pedestrian": 2}
    for split, sequence in sequences(truth, folder):
        seqinfo(truth, sequence)
        text = (sequence / "gt/gt.txt").read_text()
        rows = [line.split(" ") for line in text.splitlines()]
        expected = [(f, o) for f in truth.frames if f.name.startswith(sequence.name + "_") for o in f.objects]
        check(len(rows) == len(expected), "lines of", sequence)
        ids: dict = {}
        for row, (frame, o) in zip(rows, expected):
            kind = numbers.get(o["class"], 10)
            check(int(row[0]) == frame.number + 1 and int(row[2]) == kind, sequence, row[:3])
            check(ids.setdefault(o["id"], row[1]) == row[1] and int(row[1]) // 1000 == kind, "track of", sequence, row[:3])
            mask = masks.decode({"size": [int(row[3]), int(row[4])], "counts": row[5].encode()})
            check((mask.astype(bool) == frame.mask(o["id"])).all(), "mask of", sequence, row[:3])
        check(len(set(ids.values())) == len(ids), "two tracks have one id:", sequence)
        path = trackers / f"{split}/self/data/{sequence.name}.txt"
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text("".join(line + "\n" for line in text.splitlines() if line.split(" ")[2] == "2"))
        count += len(rows)
    for split in ("train", "val"):
        evaluate("MOTSChallenge", folder, trackers, split, "pedestrian")
    print(f"  {count} masks; people: HOTA 100, IDF1 100")


def kitti_tracking(truth: Truth, folder: pathlib.Path) -> None:
    """2D boxes by TrackEval; boxes in space are judged with the object benchmark's, which are the same."""
    trackers = folder.parent / "kitti_trackers"
    shutil.rmtree(trackers, ignore_errors=True)
    labels = sorted((folder / "training/label_02").iterdir())
    rows = 0
    for path in labels:
        target = trackers / "self/data" / path.name
        target.parent.mkdir(parents=True, exist_ok=True)
        own = path.read_text().splitlines()
        check(all(len(line.split()) == 17 for line in own), "fields of", path)
        target.write_text("".join(line + " 1.0\n" for line in own))
        rows += len(own)
    lengths = {p.stem: len(list((folder / "training/image_02" / p.stem).iterdir())) for p in labels}
    check(sum(lengths.values()) == len(truth.frames), "pictures are missing")
    with contextlib.redirect_stdout(io.StringIO()):
        for split in ("train", "val"):
            configuration = {
                "GT_FOLDER": str(folder / "training"), "TRACKERS_FOLDER": str(trackers), "OUTPUT_FOLDER": str(trackers / "results"),
                "TRACKERS_TO_EVAL": ["self"], "SPLIT_TO_EVAL": split, "PRINT_CONFIG": False, "CLASSES_TO_EVAL": ["car", "pedestrian"],
            }
            dataset = trackeval.datasets.Kitti2DBox(configuration)
            perfect(dataset, ["car", "pedestrian"])
    print(f"  {rows} boxes; cars and people: HOTA 100, IDF1 100")
