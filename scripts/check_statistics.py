#!/usr/bin/env python3
"""Counts a dataset again, from its files and by other code, and compares with what `endless stats` wrote: needs NumPy only.

    endless stats OUT --json STATS.json
    python3 scripts/check_statistics.py OUT STATS.json

Counts, histograms, medians and extremes must be equal, means to twelve digits. A COCO file is counted by pycocotools:

    endless compare OUT --coco FILE --json COMPARISON.json
    python3 scripts/check_statistics.py --coco FILE COMPARISON.json
"""

import collections
import json
import pathlib
import sys

import numpy as np

WEATHERS = ("clear_sky", "rainy", "cloudy", "foggy", "after_rain")
TIMES = ("morning", "afternoon", "night")
compared = 0


def same(ours: object, theirs: object, what: str) -> None:
    """Stops with what differs."""
    global compared
    compared += 1
    if isinstance(ours, float) and isinstance(theirs, (int, float)):
        assert abs(ours - theirs) <= 1e-12 * max(1.0, abs(ours)), f"{what}: counted {ours}, the program says {theirs}"
    else:
        assert ours == theirs, f"{what}: counted {ours}, the program says {theirs}"


def lines(path: pathlib.Path):
    with path.open() as file:
        yield from map(json.loads, file)


def check_histogram(values: list[float], told: dict | None, what: str) -> None:
    if told is None:
        same(0, len(values), f"{what}: values of what is left out")
        return
    values, edges = np.array(values, dtype=float), np.array(told["edges"])
    same(len(values), told["values"], f"{what}: values")
    same(np.histogram(values, edges)[0].tolist(), told["counts"], f"{what}: bins")
    same(int((values < edges[0]).sum()), told["below"], f"{what}: below")
    same(int((values > edges[-1]).sum()), told["above"], f"{what}: above")
    if len(values):
        same(float(np.floor(values * 1000 + 0.5).sum() / 1000 / len(values)), told["mean"], f"{what}: mean")


def check_summary(numbers: list[int], told: dict, what: str) -> None:
    same(len(numbers), told["values"], f"{what}: values")
    if numbers:
        same([min(numbers), max(numbers)], [told["min"], told["max"]], f"{what}: extremes")
        same(float(np.median(numbers)), told["median"], f"{what}: median")
        same(float(np.mean(numbers)), told["mean"], f"{what}: mean")


def sizes(areas: list[float]) -> dict:
    areas = np.array(areas)
    small, large = int((areas < 32**2).sum()), int((areas >= 96**2).sum())
    return {"small": small, "medium": len(areas) - small - large, "large": large}


def check_boxes(boxes: list[dict], told: dict, what: str) -> None:
    """`boxes` have a bbox, the picture's size, and what else their file tells."""
    same(len(boxes), told["boxes"], f"{what}: boxes")
    same(sum(b["at_edge"] for b in boxes), told["at_edge"], f"{what}: at an edge")
    areas = [b["bbox"][2] * b["bbox"][3] for b in boxes]
    same(sizes(areas), told["sizes_by_box"], f"{what}: sizes")
    if boxes:
        same(sizes([b["pixels"] for b in boxes]), told["sizes_by_pixels"], f"{what}: sizes by pixels")
    check_histogram([float(a) ** 0.5 for a in areas], told["side_px"], f"{what}: side")
    of_picture = [100.0 * (b["bbox"][2] * b["bbox"][3] / (b["size"][0] * b["size"][1])) ** 0.5 for b in boxes]
    check_histogram(of_picture, told["side_percent"], f"{what}: side in the picture")
    check_histogram([b["bbox"][2] / b["bbox"][3] for b in boxes], told["aspect_ratio"], f"{what}: aspect ratio")
    for key in ("visibility", "truncation", "distance_m"):
        check_histogram([b[key] for b in boxes if key in b], told.get(key), f"{what}: {key}")


def check_heat_map(boxes: list[dict], told: dict, what: str) -> None:
    counts = np.zeros((told["rows"], told["columns"]), int)
    for b in boxes:
        (x, y, w, h), (width, height) = b["bbox"], b["size"]
        column = min(int((x + 0.5 * w) * told["columns"] / width), told["columns"] - 1)
        row = min(int((y + 0.5 * h) * told["rows"] / height), told["rows"] - 1)
        counts[row, column] += 1
    same(counts.ravel().tolist(), told["counts"], f"{what}: heat map")


def check_looks(videos: list[list[str]], told: dict, what: str) -> None:
    """`videos` has the looks of the objects that are seen in each."""
    in_videos = collections.Counter(look for looks in videos for look in set(looks))
    twins = sum(n for looks in videos for n in collections.Counter(looks).values() if n > 1)
    same(sum(map(len, videos)), told["objects"], f"{what}: objects")
    same(len(in_videos), told["distinct"], f"{what}: looks")
    same(twins, told["twins_within_videos"], f"{what}: twins")
    same(sum(n > 1 for n in in_videos.values()), told["in_several_videos"], f"{what}: in several videos")
    by_videos = collections.Counter(str(n) for n in in_videos.values())
    same(dict(by_videos), told["looks_by_videos"], f"{what}: by videos")


def gaps_of(frames: list[int]) -> list[int]:
    return [b - a - 1 for a, b in zip(frames, frames[1:]) if b - a > 1]


class Dataset:
    """All that is counted of one."""

    def __init__(self, root: pathlib.Path) -> None:
        self.manifest = json.loads((root / "dataset.json").read_text())
        rig = [s["name"] for s in self.manifest["recipe"].get("sensor", []) if s.get("type") == "camera"]
        self.boxes, self.boxes_in_frames, self.filmed = [], [], collections.Counter()
        self.tracks, self.sizes, self.views = [], collections.Counter(), collections.defaultdict(list)
        self.view_frames, self.seen, self.looks = collections.Counter(), [], collections.defaultdict(list)
        self.happened, self.staged, self.people, self.vehicles = (collections.Counter() for _ in range(4))
        self.ages, self.sequences = [], 0
        self.videos = [v for v in self.manifest["videos"] if v["state"] == "complete"]
        for video in self.videos:
            self.add_video(root / "videos" / video["name"], video, rig)

    def add_video(self, folder: pathlib.Path, video: dict, rig: list[str]) -> None:
        scene = json.loads((folder / "scene.json").read_text())
        self.staged.update(i["kind"] for i in scene.get("incidents", []))
        conditions = {}
        if (folder / "frames.jsonl").exists():
            for line in lines(folder / "frames.jsonl"):
                conditions[line["frame"]] = (line["weather"]["name"], line["light"]["time_of_day"])
                self.happened.update(event["kind"] for event in line["events"])
        objects: dict[int, dict] = {}
        cameras = [(f"camera_{chr(97 + i)}", name) for i, name in enumerate(video["cameras"])]
        for camera, name in cameras + [(name, name) for name in rig]:
            self.add_camera(folder / camera, f"{video['map']}/{name}", video, conditions, objects)
        self.seen.extend((o["class"], len(o["cameras"])) for o in objects.values())
        self.add_actors(folder / "actors.json", objects)

    def add_camera(self, folder: pathlib.Path, view: str, video: dict, conditions: dict, objects: dict) -> None:
        camera = json.loads((folder / "camera.json").read_text())
        size = (camera["size"]["width"], camera["size"]["height"])
        tracks: dict[int, list[int]] = collections.defaultdict(list)
        self.sequences += 1
        for number, line in enumerate(lines(folder / "objects.jsonl")):
            condition = conditions.get(line["frame"], (video["weather"], video["time_of_day"]))
            self.boxes_in_frames.append(len(line["objects"]))
            for what in (condition, condition[0], condition[1], ("map", video["map"])):
                self.filmed[what] += 1
                self.filmed[(what, "boxes")] += len(line["objects"])
            self.sizes[f"{size[0]}x{size[1]}"] += 1
            self.view_frames[view] += 1
            for o in line["objects"]:
                box = {**o, "at_edge": o["truncated"], "size": size}
                self.boxes.append(box)
                self.views[view].append(box)
                tracks[o["id"]].append(number)
                seen = objects.setdefault(o["id"], {**o, "cameras": set(), "boxes": collections.Counter()})
                seen["cameras"].add(folder.name)
                seen["boxes"][condition[1]] += 1
        for i, frames in tracks.items():
            self.tracks.append((objects[i]["class"], objects[i]["parked"], frames, camera["fps"]))

    def add_actors(self, path: pathlib.Path, objects: dict) -> None:
        if not path.exists():
            return
        looks = collections.defaultdict(list)
        for actor in json.loads(path.read_text()):
            if actor["id"] not in objects:
                continue
            o, boxes = objects[actor["id"]], objects[actor["id"]]["boxes"]
            group = {"pedestrian": "people", "rider": "riders"}.get(o["class"])
            group = group or ("parked_vehicles" if o["parked"] else "vehicles")
            if "reid" in actor:
                looks[group].append(actor["reid"])
            if person := actor.get("person"):
                looks["persons"].append(person["identity"])
                self.ages.append(person["age_years"])
                for key in (("tone", person["skin_tone"]), ("age", person["age_group"]), ("sex", person["sex"])):
                    self.people[(*key, "objects")] += 1
                    self.people[(*key, "boxes")] += boxes.total()
                for time, number in boxes.items():
                    self.people[("tone", person["skin_tone"], time)] += number
            for key, word in actor.get("vehicle", {}).items():
                if key in ("color", "model", "subclass"):
                    name = word["name"] if key == "color" else word
                    self.vehicles[(key, name, "objects")] += 1
                    self.vehicles[(key, name, "boxes")] += boxes.total()
        for group in ("people", "riders", "vehicles", "parked_vehicles", "persons"):
            self.looks[group].append(looks[group])

    def check(self, told: dict) -> None:
        self.check_totals(told)
        check_boxes(self.boxes, told["boxes"], "all")
        check_heat_map(self.boxes, told["heat_map"], "all")
        for name, of_class in told["classes"].items():
            check_boxes([b for b in self.boxes if b["class"] == name], of_class, name)
        self.check_scenes(told["world"]["scenes"])
        self.check_tracks(told["world"])
        self.check_motion(told["world"]["motion"])
        self.check_people(told["world"])

    def check_totals(self, told: dict) -> None:
        totals, (row,) = told["totals"], told["datasets"]
        same(len(self.videos), totals["videos"], "videos")
        same(len(self.videos), row["videos"], "Table 2: videos")
        same(self.sequences, totals["sequences"], "cameras of videos")
        same(len(self.boxes_in_frames), totals["camera_frames"], "camera frames")
        same(len(self.boxes_in_frames), row["camera_frames"], "Table 2: camera frames")
        same(len(self.boxes), row["boxes"], "Table 2: boxes")
        same(sum(sum(v["boxes"]) for v in self.videos) if not self.rig() else len(self.boxes), row["boxes"], "manifest: boxes")
        same(sum(v["frames"] for v in self.videos), totals["instants"], "instants")
        same(dict(self.sizes), totals["sizes"], "sizes of pictures")
        same(self.boxes_in_frames.count(0), totals["empty_frames"], "empty frames")
        check_summary(self.boxes_in_frames, totals["boxes_per_frame"], "boxes a frame")

    def rig(self) -> bool:
        return bool(self.manifest["recipe"].get("sensor"))

    def check_scenes(self, told: dict) -> None:
        for key, field in (("maps", "map"), ("weathers", "weather"), ("times", "time_of_day")):
            counted = collections.Counter(v[field] for v in self.videos)
            same(dict(counted), {name: f["videos"] for name, f in told[key].items() if f["videos"]}, f"{key}: videos")
            for name, of in told[key].items():
                what = ("map", name) if key == "maps" else name
                numbers = [self.filmed[what], self.filmed[(what, "boxes")]]
                same(numbers, [of["camera_frames"], of["boxes"]], f"{key}: {name}")
        same([f"{w}_{t}" for w in WEATHERS for t in TIMES], list(told["conditions"]), "fifteen conditions")
        for w in WEATHERS:
            for t in TIMES:
                videos = sum((v["weather"], v["time_of_day"]) == (w, t) for v in self.videos)
                both = told["conditions"][f"{w}_{t}"]
                numbers = [videos, self.filmed[(w, t)], self.filmed[((w, t), "boxes")]]
                same(numbers, [both["videos"], both["camera_frames"], both["boxes"]], f"{w} {t}")
        same(dict(self.view_frames), {name: v["camera_frames"] for name, v in told["views"].items()}, "views")
        for name, view in told["views"].items():
            check_heat_map(self.views[name], view["heat_map"], name)
        same(dict(self.staged), told["events"]["staged"], "staged events")
        same(dict(self.happened), told["events"]["happened"], "events")

    def check_tracks(self, world: dict) -> None:
        for name in {name for name, _ in self.seen}:
            cameras = [n for other, n in self.seen if other == name]
            counted = {"seen": len(cameras), "seen_by_several_cameras": sum(n > 1 for n in cameras)}
            same(counted, world["objects"][name], f"objects: {name}")
        for name, told in world["tracks"].items():
            own = [(frames, fps) for other, parked, frames, fps in self.tracks if other == name and not parked]
            same(len(own), told["tracks"], f"tracks: {name}")
            parked = sum(parked for other, parked, _, _ in self.tracks if other == name)
            same(parked, told["parked_tracks"], f"tracks of parked: {name}")
            check_summary([len(frames) for frames, _ in own], told["frames_seen"], f"frames seen: {name}")
            check_histogram([len(frames) / fps for frames, fps in own], told["seconds_seen"], f"seconds seen: {name}")
            gaps = [gaps_of(frames) for frames, _ in own]
            same(sum(bool(g) for g in gaps), told["tracks_with_gaps"], f"tracks with gaps: {name}")
            check_summary([g for of_track in gaps for g in of_track], told["gap_frames"], f"gaps: {name}")

    def check_motion(self, told: dict) -> None:
        vehicles = [b for b in self.boxes if b["class"] not in ("rider", "pedestrian")]
        people = [b for b in self.boxes if b["class"] == "pedestrian"]
        for name, boxes in (("vehicles", vehicles), ("people", people)):
            parked = [b["parked"] or b.get("parking") == "parked" for b in boxes]
            speeds = [b["speed_mps"] for b, stands in zip(boxes, parked) if not stands]
            counted = [sum(parked), sum(s < 0.1 for s in speeds), sum(s >= 0.1 for s in speeds)]
            of = told[name]
            same(counted, [of["parked"], of["standing"], of["moving"]], f"motion of {name}")
            check_histogram([s for s in speeds if s >= 0.1], of["speed_mps"], f"speeds of {name}")

    def check_people(self, world: dict) -> None:
        told = world["people"]
        same(len(self.ages), told["all"]["objects"], "people")
        check_histogram(self.ages, told["age_years"], "ages")
        same([str(tone) for tone in range(1, 11)], list(told["skin_tone"]), "ten skin tones")
        for what, key in (("tone", "skin_tone"), ("age", "age_group"), ("sex", "sex")):
            for word, of in told[key].items():
                name = int(word) if what == "tone" else word
                counted = {unit: self.people[(what, name, unit)] for unit in ("objects", "boxes")}
                same(counted, of, f"{key} {word}")
        for time, of in told["boxes_by_time_and_skin_tone"].items():
            for tone, boxes in of.items():
                same(self.people[("tone", int(tone), time)], boxes, f"skin tone {tone}, {time}")
        told_vehicles = {
            (key, name, unit): number
            for key, words in world["vehicles"].items()
            for name, of in words.items()
            for unit, number in of.items()
        }
        same(dict(self.vehicles), told_vehicles, "vehicles")
        for group, videos in self.looks.items():
            check_looks(videos, world["looks"][group], f"looks of {group}")


def check_coco(path: str, comparison: dict) -> None:
    """The classes and sizes of the last side, as pycocotools has them."""
    from pycocotools.coco import COCO

    coco = COCO(path)
    word = {"person": "pedestrian"}
    names = {c["id"]: c["name"] for c in coco.loadCats(coco.getCatIds())}
    ours = ("car", "van", "truck", "bus", "motorcycle", "bicycle", "rider", "pedestrian")
    boxes = collections.Counter()
    sizes = collections.Counter()
    for a in coco.loadAnns(coco.getAnnIds(iscrowd=False)):
        name = word.get(names[a["category_id"]], names[a["category_id"]])
        if name in ours and a["bbox"][2] > 0 and a["bbox"][3] > 0:
            boxes[name] += 1
            area = a["bbox"][2] * a["bbox"][3]
            sizes["small" if area < 32**2 else "medium" if area < 96**2 else "large"] += 1
    numbers = {row["name"]: row["values"][-1] for row in comparison["numbers"]}
    same(float(len(coco.getImgIds())), numbers["camera frames"], "pictures")
    same(float(boxes.total()), numbers["boxes"], "boxes")
    shares = {table["key"]: dict(zip(table["labels"], table["shares"][-1])) for table in comparison["distributions"]}
    for key, counted in (("classes", boxes), ("sizes", sizes)):
        for label, share in shares[key].items():
            same(counted[label] / boxes.total(), share, f"{key}: {label}")


def main() -> None:
    if sys.argv[1] == "--coco":
        check_coco(sys.argv[2], json.loads(pathlib.Path(sys.argv[3]).read_text()))
    else:
        told = json.loads(pathlib.Path(sys.argv[2]).read_text())
        Dataset(pathlib.Path(sys.argv[1])).check(told)
    print(f"{compared} figures are as counted")


main()
