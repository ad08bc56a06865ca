#!/usr/bin/env python3
"""Compares our reading of OpenDRIVE files with SUMO's: lanes, their length, and which lane leads to which.

Needs the `eclipse-sumo` wheel (netconvert). Usage:

    cargo build --release -p endless_road --example lanes
    python3 scripts/judge_opendrive.py --lanes target/release/examples/lanes [--exact] FILE.xodr...

Lanes outside junctions are compared by number and length, ways from lane to lane by number (SUMO makes the shapes
inside junctions anew). Lanes that simply go on in another lane count as one with it, on both sides: SUMO cuts them at
every lane section and wherever a road ends, we do not. With --exact (for files that we wrote) every figure must agree
within 1 %. Without it only the length must, and within 3 %: where a lane widens from nothing we begin it when there is
room to drive on, and SUMO where its own least width is; lanes that the file does not link are linked by neither, but
SUMO guesses some.

The exports of the built-in towns:

    for town in Town01 Town02 Town03 Town04 Town05 Town06 Town07 Town10HD; do endless maps export $town --opendrive /tmp/$town.xodr; done
    python3 scripts/judge_opendrive.py --lanes target/release/examples/lanes --exact /tmp/Town*.xodr
"""

import argparse
import collections
import os
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

Figures = collections.namedtuple("Figures", "lanes metres ways")


def find_netconvert():
    """The program beside this Python, on the path, or in the wheel."""
    beside = os.path.join(os.path.dirname(sys.executable), "netconvert")
    found = beside if os.path.exists(beside) else shutil.which("netconvert")
    if found:
        return found
    import sumo  # the wheel's package

    return os.path.join(sumo.SUMO_HOME, "bin", "netconvert")


def ours(program, path):
    """Lanes outside junctions, their metres, and pairs of such lanes joined directly or through a junction."""
    lanes = {}
    text = subprocess.run([program, path], check=True, capture_output=True, text=True).stdout
    for line in text.splitlines():
        _, lane, junction, metres, _, following = line.split("\t")
        if junction == "loop":
            continue
        lanes[lane] = (junction, float(metres), [n for n in following.split(",") if n])
    outside = {lane for lane, (junction, _, _) in lanes.items() if junction == "-"}
    straight = {(lane, n) for lane in outside for n in lanes[lane][2] if n in outside}
    ways = set()
    for lane in outside:
        todo, seen = list(lanes[lane][2]), set()
        while todo:
            at = todo.pop()
            if at in outside:
                ways.add((lane, at))
            elif at in lanes and at not in seen:
                seen.add(at)
                todo += lanes[at][2]
    return contracted(outside, sum(lanes[lane][1] for lane in outside), ways, straight)


def contracted(lanes, metres, ways, straight):
    """Figures in which lanes that go on in one other lane alone, outside junctions, are one with it."""
    out, into = collections.Counter(a for a, _ in ways), collections.Counter(b for _, b in ways)
    joints = sum(1 for a, b in straight if a != b and out[a] == 1 and into[b] == 1)
    return Figures(len(lanes) - joints, metres, len(ways) - joints)


def sumos(netconvert, path, folder):
    """The same of SUMO's network; and what it complained of as an error."""
    net = os.path.join(folder, "net.xml")
    command = [netconvert, "--opendrive-files", path, "-o", net, "--no-turnarounds", "--offset.disable-normalization",
               "--opendrive.curve-resolution", "0.5", "--opendrive.min-width", "0.1"]
    done = subprocess.run(command, capture_output=True, text=True)
    errors = [line for line in (done.stdout + done.stderr).splitlines() if line.startswith("Error")]
    if done.returncode != 0 or not os.path.exists(net):
        return None, errors or [f"netconvert ended with {done.returncode}"]
    root = ET.parse(net).getroot()
    passable = set()
    lanes, metres = 0, 0.0
    for edge in root.iter("edge"):
        if edge.get("function") is not None:
            continue
        for lane in edge.iter("lane"):
            allow, disallow = lane.get("allow"), lane.get("disallow", "")
            if (allow is not None and "passenger" not in allow.split()) or "passenger" in disallow.split():
                continue
            passable.add((edge.get("id"), lane.get("index")))
            lanes, metres = lanes + 1, metres + float(lane.get("length"))
    ways = {
        (c.get("from"), c.get("fromLane"), c.get("to"), c.get("toLane"))
        for c in root.iter("connection")
        if (c.get("from"), c.get("fromLane")) in passable and (c.get("to"), c.get("toLane")) in passable
    }
    # Nodes where one edge goes on in one other are no junctions.
    ends = {e.get("id"): (e.get("from"), e.get("to")) for e in root.iter("edge") if e.get("function") is None}
    leaving = collections.Counter(a for a, _ in ends.values())
    arriving = collections.Counter(b for _, b in ends.values())
    plain = {n for n in leaving if leaving[n] == arriving[n] == 1}
    ways = {((a, i), (b, j)) for a, i, b, j in ways}
    straight = {(a, b) for a, b in ways if ends[a[0]][1] in plain}
    # Two-way roads that go on: four edges, each leading on to the one that does not lead back.
    for node in (n for n in leaving if leaving[n] == arriving[n] == 2):
        roads = {frozenset(v) for v in ends.values() if node in v}
        if len(roads) == 2:
            straight |= {(a, b) for a, b in ways if ends[a[0]][1] == node}
    return contracted(passable, metres, ways, straight), errors


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lanes", default="target/release/examples/lanes", help="our program that lists lanes")
    parser.add_argument("--exact", action="store_true", help="every figure must agree within 1 %%")
    parser.add_argument("files", nargs="+")
    args = parser.parse_args()
    netconvert = find_netconvert()
    failed = False
    print(f"{'file':24} {'lanes':>13} {'metres':>19} {'ways':>13}   (ours / SUMO's)")
    for path in args.files:
        with tempfile.TemporaryDirectory() as folder:
            a = ours(args.lanes, path)
            b, errors = sumos(netconvert, path, folder)
        for error in errors:
            print(f"  {error}")
        if b is None or errors:
            failed = True
            if b is None:
                continue
        name = os.path.splitext(os.path.basename(path))[0]
        off = [abs(x - y) / max(y, 1) for x, y in zip(a, b)]
        good = all(x <= 0.01 for x in off) if args.exact else off[1] <= 0.03
        failed |= not good
        print(f"{name:24} {a.lanes:6} {b.lanes:6} {a.metres:9.1f} {b.metres:9.1f} {a.ways:6} {b.ways:6}"
              f"   {'agree' if good else 'DIFFER'} ({', '.join(f'{100 * x:.2f} %' for x in off)})")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
