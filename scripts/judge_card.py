#!/usr/bin/env python3
"""Reads a dataset's cards as catalogues do, and compares what they say with its files.

    pip install mlcroissant huggingface_hub datasets pillow
    python3 scripts/judge_card.py OUT [--endless target/release/endless]

`croissant.json` by mlcroissant: valid, and every record of every set can be read. `README.md` by huggingface_hub and datasets:
its front matter is valid and its configurations load. With the program, the card's recipe plans the same dataset.
"""

import argparse
import itertools
import json
import os
import pathlib
import re
import subprocess
import tempfile
import tomllib

os.environ["HF_HUB_OFFLINE"] = os.environ["HF_DATASETS_OFFLINE"] = "1"

import datasets
import mlcroissant
from huggingface_hub import DatasetCard

# Pictures are decoded one by one: of each layer so many.
IMAGES = 20


def judge_croissant(out: pathlib.Path, manifest: dict) -> None:
    dataset = mlcroissant.Dataset(jsonld=out / "croissant.json")
    assert not dataset.metadata.ctx.issues.errors
    complete = [video for video in manifest["videos"] if video["state"] == "complete"]
    sets = {record_set.id for record_set in dataset.metadata.record_sets}
    assert sets >= {"videos", "frames", *manifest["recipe"]["layers"]}, sets

    videos = list(dataset.records("videos"))
    told = [(record["videos/video"], record["videos/map"].decode()) for record in videos]
    assert told == [(video["video"], video["map"]) for video in complete], told

    frames = list(dataset.records("frames"))
    for record in frames:
        folder = out / "videos" / record["frames/video"].decode() / record["frames/camera"].decode()
        line = json.loads((folder / "objects.jsonl").read_text().splitlines()[record["frames/frame"]])
        # pandas rounds the last digit of some numbers.
        assert abs(line["time_s"] - record["frames/time_s"]) < 1e-9
        # What is empty has one record of nothing.
        objects = [o for o in record["frames/objects"] if o["frames/objects/id"] is not None]
        for told, there in itertools.zip_longest(objects, line["objects"]):
            assert told["frames/objects/id"] == there["id"] and told["frames/objects/bbox"] == there["bbox"]
            assert told["frames/objects/class"].decode() == there["class"]
            assert told["frames/objects/pixels"] == there["pixels"]
    boxes = sum(len(json.loads(line)["objects"]) for path in out.glob("videos/*/*/objects.jsonl") for line in path.open())
    print(f"croissant.json: {len(videos)} videos, {len(frames)} frames, {boxes} objects read")

    for layer in manifest["recipe"]["layers"]:
        for record in itertools.islice(dataset.records(layer), IMAGES):
            assert "x".join(map(str, record[f"{layer}/image"].size)) == manifest["recipe"]["size"]
            name = f"{record[f'{layer}/frame']:06}.*"
            folder = out / "videos" / record[f"{layer}/video"].decode() / record[f"{layer}/camera"].decode() / layer
            assert len(list(folder.glob(name))) == 1, folder / name
    print(f"croissant.json: pictures of {', '.join(manifest['recipe']['layers'])} read")


def judge_readme(out: pathlib.Path, manifest: dict) -> None:
    card = DatasetCard.load(out / "README.md")
    data = card.data.to_dict()
    for key in ["pretty_name", "license", "task_categories", "size_categories", "tags"]:
        assert data[key], key
    configs = datasets.utils.metadata.MetadataConfigs.from_dataset_card_data(card.data)
    with tempfile.TemporaryDirectory() as cache:
        for config in configs:
            rows = datasets.load_dataset(str(out), config, split="train", cache_dir=cache)
            there = list(out.glob(data["configs"][0]["data_files"]))
            assert len(rows) == len(there), (len(rows), len(there))
            assert "x".join(map(str, rows[0]["image"].size)) == manifest["recipe"]["size"]
            print(f"README.md: configuration {config}: {len(rows)} rows of {', '.join(rows.features)}")


def judge_recipe(out: pathlib.Path, manifest: dict, endless: str | None) -> None:
    text = re.search(r"```toml\n(.*?)```", (out / "README.md").read_text(), re.DOTALL)[1]
    recipe = tomllib.loads(text)
    for key, value in recipe.items():
        assert key in ("cameras", "density") or manifest["recipe"].get(key, value) == value, key
    if endless is None:
        return
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        (folder / "recipe.toml").write_text(text)
        command = [endless, "generate", "--config", folder / "recipe.toml", "--plan-only", folder / "again"]
        subprocess.run(command, check=True, capture_output=True)
        again = json.loads((folder / "again/dataset.json").read_text())
        assert again["recipe"] == manifest["recipe"]
        for scene in sorted((out / "scenes").iterdir()):
            assert (folder / "again/scenes" / scene.name).read_bytes() == scene.read_bytes(), scene
    print("README.md: its recipe plans the same scenes")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--endless")
    arguments = parser.parse_args()
    manifest = json.loads((arguments.out / "dataset.json").read_text())
    judge_croissant(arguments.out, manifest)
    judge_readme(arguments.out, manifest)
    judge_recipe(arguments.out, manifest, arguments.endless)


if __name__ == "__main__":
    main()
