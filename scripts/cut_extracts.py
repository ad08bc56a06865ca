#!/usr/bin/env python3
"""Cuts rectangles at random from OpenStreetMap files, as somebody does who wants a few streets of a city.

    scripts/cut_extracts.py FILE.osm... --out FOLDER [--count 20] [--seed 0] [--least 150] [--most 600] [--ways cut]

Rectangles have sides of 150 to 600 m and hold at least one drivable way. Ways with a node inside are whole, as OpenStreetMap's
own export and `osmium extract` give them; with `--ways cut` they end at the rectangle: of each, the parts inside and the first
node beyond. Standard library only.
"""

import argparse
import math
import pathlib
import random
import sys
import xml.etree.ElementTree as ElementTree

DRIVABLE = {
    "motorway", "trunk", "primary", "secondary", "tertiary", "unclassified", "residential", "living_street",
    "motorway_link", "trunk_link", "primary_link", "secondary_link", "tertiary_link",
}  # fmt: skip
METRES_A_DEGREE = 111_320.0


def tags(element):
    return {tag.get("k"): tag.get("v") for tag in element.iter("tag")}


def parts_inside(refs, inside):
    """The parts of a way whose nodes are inside, each with the node before and after it."""
    parts, part = [], []
    for before, ref, after in zip([None, *refs], refs, [*refs[1:], None]):
        if ref in inside or before in inside or after in inside:
            part.append(ref)
        elif part:
            parts.append(part)
            part = []
    return [part for part in [*parts, part] if len(part) > 1]


def cut(root, rectangle, whole):
    """A rectangle (west, south, east, north) of a file, with whole ways or cut ones; None without a drivable way."""
    west, south, east, north = rectangle
    nodes = {node.get("id"): node for node in root.iter("node")}
    inside = {
        ref
        for ref, node in nodes.items()
        if west <= float(node.get("lon")) <= east and south <= float(node.get("lat")) <= north
    }
    ways, used, drivable = [], set(), 0
    for way in root.iter("way"):
        refs = [nd.get("ref") for nd in way.iter("nd") if nd.get("ref") in nodes]
        parts = [refs] if whole and not inside.isdisjoint(refs) else [] if whole else parts_inside(refs, inside)
        for number, part in enumerate(parts):
            copy = ElementTree.Element("way", dict(way.attrib))
            if number:
                copy.set("id", f"{int(way.get('id')) + 1_000_000_000_000 * number}")
            for ref in part:
                ElementTree.SubElement(copy, "nd", ref=ref)
            copy.extend(way.iter("tag"))
            ways.append(copy)
            used.update(part)
            drivable += tags(way).get("highway") in DRIVABLE
    if not drivable:
        return None
    kept = {way.get("id") for way in ways}
    out = ElementTree.Element("osm", version="0.6", generator="cut_extracts")
    ElementTree.SubElement(out, "bounds", minlat=str(south), minlon=str(west), maxlat=str(north), maxlon=str(east))
    out.extend(node for ref, node in nodes.items() if ref in used or ref in inside)
    out.extend(ways)
    for relation in root.iter("relation"):
        ways_of_it = [m.get("ref") for m in relation.iter("member") if m.get("type") == "way"]
        if ways_of_it and all(ref in kept for ref in ways_of_it):
            out.append(relation)
    return out


def draw(random_numbers, root, least_m, most_m):
    """A rectangle around a node of a road."""
    nodes = {node.get("id"): node for node in root.iter("node")}
    roads = [way for way in root.iter("way") if tags(way).get("highway") in DRIVABLE]
    refs_of = [[nd.get("ref") for nd in way.iter("nd") if nd.get("ref") in nodes] for way in roads]
    # A file may name ways whose nodes it lacks.
    refs = random_numbers.choice([refs for refs in refs_of if refs])
    node = nodes[random_numbers.choice(refs)]
    lon, lat = float(node.get("lon")), float(node.get("lat"))
    height = random_numbers.uniform(least_m, most_m) / METRES_A_DEGREE
    width = random_numbers.uniform(least_m, most_m) / (METRES_A_DEGREE * math.cos(math.radians(lat)))
    west = lon - width * random_numbers.random()
    south = lat - height * random_numbers.random()
    return west, south, west + width, south + height


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("--count", type=int, default=20)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--least", type=float, default=150.0)
    parser.add_argument("--most", type=float, default=600.0)
    parser.add_argument("--ways", choices=["whole", "cut"], default="whole")
    arguments = parser.parse_args()
    roots = [(file, ElementTree.parse(file).getroot()) for file in arguments.files]
    roots = [(file, root) for file, root in roots if any(tags(way).get("highway") in DRIVABLE for way in root.iter("way"))]
    if not roots:
        sys.exit("no roads in these files")
    arguments.out.mkdir(parents=True, exist_ok=True)
    random_numbers = random.Random(arguments.seed)
    made = 0
    while made < arguments.count:
        file, root = roots[made % len(roots)]
        extract = cut(root, draw(random_numbers, root, arguments.least, arguments.most), arguments.ways == "whole")
        if extract is not None:
            name = arguments.out / f"{file.stem}_{made:02}.osm"
            ElementTree.ElementTree(extract).write(name, encoding="utf-8", xml_declaration=True)
            made += 1
    print(f"{made} extracts in {arguments.out}")


if __name__ == "__main__":
    main()
