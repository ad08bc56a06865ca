#!/usr/bin/env python3
"""Compares our reading of OpenDRIVE files with SUMO's: lanes, their length, and which lane leads to which.

Needs the `eclipse-sumo` wheel (netconvert). Usage:

    cargo build --release -p endless_road --example lanes
    python3 scripts/judge_opendrive.py --lanes target/release/examples/lanes [--exact] FILE.xodr...

Lanes outside junctions are compared by number and length, ways from lane to lane by number (SUMO makes the shapes
inside junctions anew). Both readings are counted by one rule: a lane whose only successor has no other predecessor is
one lane with it, because the two readers cut lanes at different places (SUMO at every lane section, wherever a road
ends and where two roads meet at a corner; we where the file has a junction).

With --exact (for files that we wrote) each of the three figures must agree within 1 %, and so must the graphs
themselves: every lane of SUMO's is laid on the lane of ours that runs there, and then no more than 1 % of SUMO's ways
may be none of ours, or of ours none of SUMO's. Without it only the length must agree, within 3 %: where a lane widens
from nothing we begin it when there is room to drive on, and SUMO where its own least width is; lanes that the file does
not link are linked by neither, but SUMO guesses some.

SUMO is asked to end lanes where the file's roads end (--junctions.endpoint-shape): by default it cuts them back until no
two edges of a junction overlap, which shortens a motorway by 30 m at every ramp.

The built-in towns:

    cargo run --release -p endless_town --example export_opendrive -- FOLDER
    python3 scripts/judge_opendrive.py --lanes target/release/examples/lanes --exact FOLDER/*.xodr
"""

import argparse
import bisect
import collections
import math
import os
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

Figures = collections.namedtuple("Figures", "lanes metres ways")
# Lanes outside junctions by id, each its points; pairs of them, directly or through a junction.
Graph = collections.namedtuple("Graph", "lanes metres ways")

# Lanes of both readings run together if this near to each other, metres, and at this angle, radians.
NEAR_M = 1.0
ASLANT = 0.5


def find_netconvert():
    """The program beside this Python, on the path, or in the wheel."""
    beside = os.path.join(os.path.dirname(sys.executable), "netconvert")
    found = beside if os.path.exists(beside) else shutil.which("netconvert")
    if found:
        return found
    import sumo  # the wheel's package

    return os.path.join(sumo.SUMO_HOME, "bin", "netconvert")


def points(text):
    return [tuple(float(x) for x in point.split(",")[:2]) for point in text.split()]


def ours(program, path):
    """The lanes as we read them."""
    lanes = {}
    text = subprocess.run([program, path], check=True, capture_output=True, text=True).stdout
    for line in text.splitlines():
        _, lane, junction, metres, _, following, shape = line.split("\t")
        if junction == "loop":
            continue
        lanes[lane] = (junction, float(metres), [n for n in following.split(",") if n], shape)
    outside = {lane: points(of[3]) for lane, of in lanes.items() if of[0] == "-"}
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
    return Graph(outside, sum(lanes[lane][1] for lane in outside), ways)


def sumos(netconvert, path, folder):
    """The lanes as SUMO reads them; and what it complained of as an error."""
    net = os.path.join(folder, "net.xml")
    command = [netconvert, "--opendrive-files", path, "-o", net, "--no-turnarounds", "--offset.disable-normalization",
               "--opendrive.curve-resolution", "0.5", "--opendrive.min-width", "0.1",
               "--junctions.endpoint-shape"]
    done = subprocess.run(command, capture_output=True, text=True)
    errors = [line for line in (done.stdout + done.stderr).splitlines() if line.startswith("Error")]
    if done.returncode != 0 or not os.path.exists(net):
        return None, errors or [f"netconvert ended with {done.returncode}"]
    root = ET.parse(net).getroot()
    lanes, metres = {}, 0.0
    for edge in root.iter("edge"):
        if edge.get("function") is not None:
            continue
        for lane in edge.iter("lane"):
            allow, disallow = lane.get("allow"), lane.get("disallow", "")
            if (allow is not None and "passenger" not in allow.split()) or "passenger" in disallow.split():
                continue
            lanes[(edge.get("id"), lane.get("index"))] = points(lane.get("shape"))
            metres += float(lane.get("length"))
    ways = {((c.get("from"), c.get("fromLane")), (c.get("to"), c.get("toLane"))) for c in root.iter("connection")}
    return Graph(lanes, metres, {(a, b) for a, b in ways if a in lanes and b in lanes}), errors


def figures(graph):
    """Figures in which lanes that go on in one other lane alone are one with it."""
    out, into = collections.Counter(a for a, _ in graph.ways), collections.Counter(b for _, b in graph.ways)
    joints = sum(1 for a, b in graph.ways if a != b and out[a] == 1 and into[b] == 1)
    return Figures(len(graph.lanes) - joints, graph.metres, len(graph.ways) - joints)


def middle(line):
    """The place half way along, and the direction there."""
    lengths = [math.dist(a, b) for a, b in zip(line, line[1:])]
    ends = [sum(lengths[: k + 1]) for k in range(len(lengths))]
    k = min(bisect.bisect_left(ends, ends[-1] / 2), len(ends) - 1)
    (ax, ay), (bx, by) = line[k], line[k + 1]
    u = 1 - (ends[k] - ends[-1] / 2) / max(lengths[k], 1e-9)
    return (ax + u * (bx - ax), ay + u * (by - ay)), math.atan2(by - ay, bx - ax)


class Places:
    """Pieces of lanes by where they are."""

    CELL_M = 10.0

    def __init__(self, lanes):
        self.cells = collections.defaultdict(list)
        for name, line in lanes.items():
            for a, b in zip(line, line[1:]):
                steps = int(math.dist(a, b) / self.CELL_M) + 1
                for k in range(steps + 1):
                    self.cells[self.cell(a[0] + (b[0] - a[0]) * k / steps, a[1] + (b[1] - a[1]) * k / steps)].append((name, a, b))

    def cell(self, x, y):
        return int(x // self.CELL_M), int(y // self.CELL_M)

    def lane_at(self, place, heading):
        """The nearest lane that runs through a place in a direction."""
        i, j = self.cell(*place)
        best = (NEAR_M, None)
        for name, a, b in (piece for di in (-1, 0, 1) for dj in (-1, 0, 1) for piece in self.cells.get((i + di, j + dj), ())):
            along = (b[0] - a[0], b[1] - a[1])
            turned = math.remainder(math.atan2(along[1], along[0]) - heading, 2 * math.pi)
            square = along[0] ** 2 + along[1] ** 2
            if abs(turned) > ASLANT or square == 0:
                continue
            u = ((place[0] - a[0]) * along[0] + (place[1] - a[1]) * along[1]) / square
            u = min(max(u, 0.0), 1.0)
            best = min(best, (math.dist(place, (a[0] + u * along[0], a[1] + u * along[1])), name), key=lambda x: x[0])
        return best[1]


def apart(our, sumo):
    """Lanes of SUMO's that run on none of ours, ways of SUMO's that we lack, and ways of ours that SUMO lacks."""
    places = Places(our.lanes)
    on = {name: places.lane_at(*middle(line)) for name, line in sumo.lanes.items()}
    strays = [name for name, ours in on.items() if ours is None]
    theirs = {(on[a], on[b]) for a, b in sumo.ways if on[a] and on[b] and on[a] != on[b]}
    mine = {(a, b) for a, b in our.ways if a != b}
    return strays, theirs - mine, mine - theirs


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lanes", default="target/release/examples/lanes", help="our program that lists lanes")
    parser.add_argument("--exact", action="store_true", help="every figure must agree within 1 %%, and so must the graphs")
    parser.add_argument("--verbose", action="store_true", help="tell which lanes and ways differ")
    parser.add_argument("files", nargs="+")
    args = parser.parse_args()
    netconvert = find_netconvert()
    failed = False
    print(f"{'file':24} {'lanes':>13} {'metres':>19} {'ways':>13}   (ours / SUMO's)")
    for path in args.files:
        with tempfile.TemporaryDirectory() as folder:
            our = ours(args.lanes, path)
            sumo, errors = sumos(netconvert, path, folder)
        for error in errors:
            print(f"  {error}")
        if sumo is None or errors:
            failed = True
            if sumo is None:
                continue
        a, b = figures(our), figures(sumo)
        name = os.path.splitext(os.path.basename(path))[0]
        off = [abs(x - y) / max(y, 1) for x, y in zip(a, b)]
        strays, lacking, extra = apart(our, sumo)
        off_graph = [len(strays) / max(len(sumo.lanes), 1), len(lacking | extra) / max(len(our.ways), 1)]
        good = all(x <= 0.01 for x in off + off_graph) if args.exact else off[1] <= 0.03
        failed |= not good
        print(f"{name:24} {a.lanes:6} {b.lanes:6} {a.metres:9.1f} {b.metres:9.1f} {a.ways:6} {b.ways:6}"
              f"   {'agree' if good else 'DIFFER'} ({', '.join(f'{100 * x:.2f} %' for x in off)};"
              f" {len(strays)} lanes astray, {len(lacking)} ways only SUMO's, {len(extra)} only ours)")
        if args.verbose:
            for edge, lane in strays:
                print(f"    SUMO's lane {edge}_{lane} at {middle(sumo.lanes[(edge, lane)])} is none of ours")
            for what, ways in (("only SUMO's", lacking), ("only ours", extra)):
                for x, y in sorted(ways):
                    print(f"    {what}: from lane {x}, {our.lanes[x][-1]}, to lane {y}, {our.lanes[y][0]}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
