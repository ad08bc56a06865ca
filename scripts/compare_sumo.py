#!/usr/bin/env python3
"""Drives the demand of our traffic in SUMO, on the same network, and compares travel times and safety indicators.

Needs the `eclipse-sumo` wheel, `sumolib` and `pandas`. Usage:

    cargo build --release -p endless
    python3 scripts/compare_sumo.py target/release/endless Town05 --vehicles 100 --seconds 300 --seeds 4

Both see one network, our OpenDRIVE export as netconvert reads it, with our signal programs, our stop and give-way signs and our
rules of who goes first where there are none. Demand: where each of our vehicles
is when the time begins, with its speed, length and lane, and every edge that it drives in twice the time: so streets stay as full
as ours. SUMO drives each along the same edges from the same place. Its car-following model (Krauss) and junctions are its own;
vehicles are ours: speed factors from 0.88 to 1.12, headways from 0.75 to 1.4 s, the acceleration and braking of drivers in the
mean, bends taken at 2 m/s2 sideways, the speeds that lorries, buses and bicycles reach, and the smallest gaps taken after 25 s before those with priority, where SUMO's own figures
would be 2.6, 4.5 and 5.5 m/s2 and 180 s. SUMO knows bends in junctions alone: each road's lanes have the mean speed with which its bends
let one through. Those on two wheels have no
models in the comparison: they are simulated with the others by us, and driven as short cars by SUMO.

Printed: mean time to where each of ours is when the time ends, ours and SUMO's, and five of the surrogate safety measures of
SUMO's SSM device, computed by the same code from both trajectories (twice a second, on lanes outside junctions): of each vehicle
the most critical value that it meets, and of these the median.

    TTC     time to collision with the vehicle ahead, seconds: its lowest
    DRAC    deceleration rate to avoid a crash, m/s2: its highest
    TGAP    time gap to the vehicle ahead, seconds: its lowest
    BR      braking, m/s2: its highest
    PET     time from when one vehicle leaves a place of its lane until the next one comes to it, seconds: its lowest

Exits with 1 if the mean time differs by more than 15 %, or a measure by more than a factor of three.
"""

import argparse
import collections
import math
import os
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

from sumo_network import BEND_MPS2, give_way_as_signed, slow_down_in_bends, write_programs

STEP_S = 0.5
NEAR_M = 4.0
# After waiting for so long our drivers take the smallest gaps that they ever take before those with priority.
IMPATIENT_S = 25
# What those reach that are slower than limits, m/s.
MOST_MPS = {"bicycle": 4.8, "truck": 23.0, "bus": 22.0}


def program(name):
    beside = os.path.join(os.path.dirname(sys.executable), name)
    if os.path.exists(beside):
        return beside
    import sumo

    return os.path.join(sumo.SUMO_HOME, "bin", name)


def run(*command):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{command[0]} failed:\n{done.stdout}\n{done.stderr}")
    return done


class Network:
    """SUMO's edges, and which of their lanes is which of ours."""

    def __init__(self, net_file):
        import sumolib

        self.net = sumolib.net.readNet(net_file, withInternal=False)
        self.lanes = collections.defaultdict(list)
        for element in ET.parse(net_file).getroot().iter("lane"):
            for param in element.iter("param"):
                if param.get("key") == "origId":
                    for name in param.get("value").split():
                        self.lanes[name].append(element.get("id"))

    def place(self, name, x, y):
        """The lane of SUMO's that runs there as one of ours, and how far along it is."""
        import sumolib

        best = None
        for lane_id in self.lanes.get(name, []):
            if lane_id.startswith(":"):
                continue
            lane = self.net.getLane(lane_id)
            along, aside = sumolib.geomhelper.polygonOffsetAndDistanceToPoint((x, y), lane.getShape(), perpendicular=False)
            scale = lane.getLength() / max(sumolib.geomhelper.polyLength(lane.getShape()), 0.1)
            if aside < NEAR_M and (best is None or aside < best[0]):
                best = (aside, lane, min(along * scale, lane.getLength()))
        return best and best[1:]

    def route(self, edges):
        """The same edges, with those between that connect them; None if nothing does."""
        whole = [edges[0]]
        for edge in edges[1:]:
            if edge is whole[-1]:
                continue
            way = self.net.getShortestPath(whole[-1], edge, vClass="passenger")[0]
            if way is None or len(way) > 6:
                return None
            whole += way[1:]
        return whole


def read_ours(csv_file, network):
    import pandas

    rows = pandas.read_csv(csv_file)
    rows = rows[(rows["class"] != "pedestrian")]
    trips = {}
    for vehicle, own in rows.groupby("id"):
        front = 0.5 * own["length"]
        xs, ys = own["x"] + front * own["yaw"].map(math.cos), own["y"] + front * own["yaw"].map(math.sin)
        names = own["road"].astype("Int64").astype(str) + "_" + own["road_lane"].astype("Int64").astype(str)
        places = []
        for time, x, y, name, speed in zip(own["time"], xs, ys, names, own["speed"]):
            found = network.place(name, x, y)
            if found:
                places.append((time, found[0], found[1], speed))
        trips[vehicle] = (own, places)
    return rows, trips


Trip = collections.namedtuple("Trip", "begin end edges last vehicle")


def share(vehicle, salt):
    """A number from 0 to 1 that looks random."""
    return ((vehicle * 2654435761 + salt * 40503) % 99991) / 99991


def write_demand(trips, network, seconds, out_file):
    """What each vehicle drives; its trip ends where it is after these seconds."""
    root = ET.Element("routes")
    kept = {}
    for vehicle, (own, places) in trips.items():
        within = [place for place in places if place[0] <= seconds]
        if len(within) < 2 or within[0][0] > STEP_S or within[-1][0] < 0.8 * seconds:
            continue
        edges = network.route([place[1].getEdge() for place in within])
        whole = network.route([place[1].getEdge() for place in places])
        if edges and whole and whole[: len(edges)] == edges:
            kept[str(vehicle)] = Trip(within[0], within[-1], whole, len(edges) - 1, own.iloc[0])
    # Two cannot depart at one place: SUMO puts in those further ahead first.
    for vehicle in sorted(kept, key=lambda v: (kept[v].begin[1].getID(), -kept[v].begin[2])):
        begin, _, edges, _, first = kept[vehicle]
        number, heavy = int(vehicle), first["class"] in ("bus", "truck")
        kind = ET.SubElement(root, "vType", id=f"t{vehicle}", length=f"{first['length']:.2f}", minGap="2.5",
                             speedFactor=f"{0.88 + 0.24 * share(number, 1):.3f}", tau=f"{0.75 + 0.65 * share(number, 2):.3f}",
                             accel="1.1" if heavy else "1.75", decel="1.95", emergencyDecel="7.5", carFollowModel="Krauss")
        kind.set("vClass", {"bus": "bus", "truck": "truck"}.get(first["class"], "passenger"))
        most_mps = MOST_MPS.get(first["class"])
        if most_mps:
            kind.set("maxSpeed", str(most_mps))
        starts_mps = min(begin[3], 0.85 * begin[1].getSpeed(), 0.85 * (most_mps or math.inf))
        element = ET.SubElement(root, "vehicle", id=vehicle, type=f"t{vehicle}", depart="0",
                                departLane=begin[1].getID().rsplit("_", 1)[1], departPos=f"{begin[2]:.2f}",
                                departSpeed=f"{starts_mps:.2f}", insertionChecks="none")
        ET.SubElement(element, "route", edges=" ".join(edge.getID() for edge in edges))
    ET.ElementTree(root).write(out_file)
    return kept


def read_theirs(fcd_file, kept):
    """Samples of SUMO's vehicles on lanes outside junctions, and when each has come to where its trip ends."""
    samples, arrived, progress = [], {}, collections.Counter()
    for step in ET.parse(fcd_file).getroot():
        time = float(step.get("time"))
        for vehicle in step:
            name, lane, pos = vehicle.get("id"), vehicle.get("lane"), float(vehicle.get("pos"))
            if lane.startswith(":"):
                continue
            trip = kept[name]
            samples.append((time, name, lane, pos, float(vehicle.get("speed")), float(trip.vehicle["length"])))
            edge = lane.rsplit("_", 1)[0]
            ahead = progress[name]
            while ahead < len(trip.edges) and trip.edges[ahead].getID() != edge:
                ahead += 1
            if ahead == len(trip.edges):
                continue
            progress[name] = ahead
            if name not in arrived and (ahead > trip.last or (ahead == trip.last and pos >= trip.end[2])):
                arrived[name] = time
    return samples, arrived


def median(values):
    values = sorted(values)
    return values[len(values) // 2] if values else math.nan


def safety_measures(samples):
    """Of samples (time, vehicle, lane, place of the front, speed, length) on lanes outside junctions."""
    on_lane = collections.defaultdict(list)
    speeds = collections.defaultdict(dict)
    for time, vehicle, lane, s, speed, length in samples:
        on_lane[(round(time / STEP_S), lane)].append((s, vehicle, speed, length))
        speeds[vehicle][round(time / STEP_S)] = speed
    worst = {name: {} for name in ("TTC, s", "DRAC, m/s2", "TGAP, s", "BR, m/s2", "PET, s")}

    def note(name, vehicle, value, sign):
        known = worst[name].get(vehicle)
        if known is None or sign * value > sign * known:
            worst[name][vehicle] = value

    for row in on_lane.values():
        row.sort()
        for (s, vehicle, v, _), (front, _, lead, length) in zip(row, row[1:]):
            gap = front - length - s
            if gap <= 0.1 or gap > 60 or v < 1:
                continue
            note("TGAP, s", vehicle, gap / v, -1)
            if v > lead:
                note("TTC, s", vehicle, gap / (v - lead), -1)
                note("DRAC, m/s2", vehicle, (v - lead) ** 2 / (2 * gap), 1)
    for vehicle, own in speeds.items():
        for k, v in own.items():
            if k + 1 in own:
                note("BR, m/s2", vehicle, (v - own[k + 1]) / STEP_S, 1)
    # When gates every 20 m of a lane are left, and when the next one comes to them.
    gates = collections.defaultdict(list)
    before = {}
    for time, vehicle, lane, s, speed, length in sorted(samples):
        last = before.get(vehicle)
        before[vehicle] = (lane, s, time)
        if last and last[0] == lane:
            for gate in range(int(last[1] // 20) + 1, int(s // 20) + 1):
                at = last[2] + (gate * 20 - last[1]) / max(s - last[1], 1e-6) * (time - last[2])
                gates[(lane, gate)].append((at, at + length / max(speed, 0.3), vehicle))
    for passed in gates.values():
        passed.sort()
        for (_, leaves, _), (enters, _, vehicle) in zip(passed, passed[1:]):
            if enters > leaves:
                note("PET, s", vehicle, enters - leaves, -1)
    return {name: median(list(of.values())) for name, of in worst.items()}


def compare(args, seed, folder):
    """With one seed: our mean time and SUMO's, seconds, the number of vehicles of which they are, and both medians of each measure."""
    os.makedirs(folder, exist_ok=True)
    file = lambda name: os.path.join(folder, name)
    for kind, name in (("--opendrive", "map.xodr"), ("--geojson", "map.geojson")):
        run(args.endless, "maps", "export", args.map, kind, file(name))
    run(program("netconvert"), "--opendrive-files", file("map.xodr"), "--output.original-names", "--junctions.endpoint-shape",
        "--offset.disable-normalization", "--junctions.limit-turn-speed", str(BEND_MPS2), "-o", file("map.net.xml"))
    slow_down_in_bends(file("map.net.xml"))
    give_way_as_signed(file("map.net.xml"), file("map.geojson"))
    run(args.endless, "simulate", args.map, "--seconds", 2 * args.seconds, "--vehicles", args.vehicles, "--pedestrians", 0,
        "--seed", seed, "--fps", round(1 / STEP_S), "--out", file("ours.csv"))
    write_programs(file("map.net.xml"), file("map.geojson"), file("programs.add.xml"))
    network = Network(file("map.net.xml"))
    rows, trips = read_ours(file("ours.csv"), network)
    kept = write_demand(trips, network, args.seconds, file("demand.rou.xml"))
    run(program("sumo"), "-n", file("map.net.xml"), "-a", file("programs.add.xml"), "-r", file("demand.rou.xml"),
        "--fcd-output", file("sumo.fcd.xml"), "--step-length", "0.1", "--device.fcd.period", STEP_S, "--end", args.seconds * 3,
        "--time-to-teleport", "-1", "--time-to-impatience", IMPATIENT_S, "--seed", seed, "--collision.action", "warn", "--no-step-log")
    theirs, arrived = read_theirs(file("sumo.fcd.xml"), kept)
    both = [v for v in kept if v in arrived]
    ours_s = sum(kept[v].end[0] - kept[v].begin[0] for v in both) / max(len(both), 1)
    theirs_s = sum(arrived[v] for v in both) / max(len(both), 1)
    print(f"{args.map}, seed {seed}: of {rows['id'].nunique()} vehicles, {len(kept)} have a way that is one of SUMO's, {len(both)} come to its end there")
    print(f"mean travel time: ours {ours_s:.1f} s, SUMO's {theirs_s:.1f} s, {100 * (ours_s / theirs_s - 1):+.1f} %")
    within = lambda samples: [sample for sample in samples if sample[0] <= args.seconds]
    ours = []
    for vehicle, trip in kept.items():
        own, places = trips[int(vehicle)]
        ours += [(t, vehicle, lane.getID(), s, v, float(trip.vehicle["length"])) for t, lane, s, v in places]
    ours, theirs = safety_measures(within(ours)), safety_measures(within(theirs))
    for name in ours:
        print(f"{name:12} ours {ours[name]:6.2f}   SUMO's {theirs[name]:6.2f}")
    return ours_s, theirs_s, len(both), [(ours[name], theirs[name]) for name in ours]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("endless", help="the program")
    parser.add_argument("map", help="a town or a map file")
    parser.add_argument("--vehicles", type=int, default=100)
    parser.add_argument("--seconds", type=float, default=300)
    parser.add_argument("--seed", type=int, default=1, help="the first seed")
    parser.add_argument("--seeds", type=int, default=1, help="how many, from the first on: times are the mean of all")
    parser.add_argument("--keep", help="a folder for all files, with one in it for each seed")
    args = parser.parse_args()
    folder = args.keep or tempfile.mkdtemp()
    found = [compare(args, seed, os.path.join(folder, str(seed))) for seed in range(args.seed, args.seed + args.seeds)]
    number = sum(vehicles for _, _, vehicles, _ in found)
    ours_s, theirs_s = (sum(of[k] * of[2] for of in found) / max(number, 1) for k in (0, 1))
    if args.seeds > 1:
        print(f"of all {args.seeds} seeds: ours {ours_s:.1f} s, SUMO's {theirs_s:.1f} s, {100 * (ours_s / theirs_s - 1):+.1f} %")
    alike = abs(ours_s / theirs_s - 1) <= 0.15
    alike &= all(1 / 3 <= ours / theirs <= 3 for *_, measures in found for ours, theirs in measures)
    sys.exit(0 if alike else 1)


if __name__ == "__main__":
    main()
