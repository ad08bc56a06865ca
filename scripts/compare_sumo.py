#!/usr/bin/env python3
"""Drives the demand of our traffic in SUMO, on the same network, and compares travel times and safety indicators.

Needs the `eclipse-sumo` wheel, `sumolib` and `pandas`. Usage:

    cargo build --release -p endless
    python3 scripts/compare_sumo.py target/release/endless Town05 --vehicles 100 --seconds 300 --seed 0 --seeds 4

Both see one network, our OpenDRIVE export as netconvert reads it, with our signal programs, our stop and give-way signs and our
rules of who goes first where there are none. Demand: where each of our vehicles is when the time begins (those inside junctions
and those who park: where and when they come onto a road), with its speed, length and lane, every edge that it drives along in
twice the time, so that streets stay as full as ours, and where it stops of its own accord. SUMO drives each along the same edges
from the same place. Its car-following model (Krauss) and junctions are its own; vehicles are ours: speed factors from 0.88 to 1.12,
headways with which queues leave lights as ours do, the acceleration and braking of drivers in the mean (SUMO's own would be 2.6
and 4.5 m/s2), bends taken at 2 m/s2 sideways, and the speeds that lorries, buses and bicycles reach. SUMO knows bends in junctions
alone: each road's lanes have the mean speed with which its bends let one through. Those on two wheels are driven as short cars.

Who waits at a stop sign takes the headways of the Highway Capacity Manual 2010 as nearly as SUMO can: 7.1 s to turn left, 6.2 s to
turn right. With SUMO's own figures nobody turns left before those with priority in less than about 15 s, and Town01's drivers
take half as long again; with the greatest `impatience` it is 7.0 to 8.6 s (four towns, 60 and 100 vehicles).

Printed: mean time to where each of ours is when the time ends, ours and SUMO's; five surrogate safety measures, computed by the same
code from both trajectories (twice a second, on lanes outside junctions); and the critical headways at stop signs, where enough wait.

Exits with 1 if the mean time differs by more than 15 %, a measure by more than a factor of three, or SUMO's traffic comes to stand.
"""

import argparse
import collections
import os
import sys
import tempfile
import xml.etree.ElementTree as ET

import critical_headway
from sumo_demand import Network, read_ours, write_demand
from sumo_network import BEND_MPS2, give_way_as_signed, signs, slow_down_in_bends, write_programs
from sumo_programs import program, run
from surrogate_safety import surrogate_safety

STEP_S = 0.5
# Where fewer come to their end in three times the time, traffic stands and travel times tell nothing.
COME_THROUGH = 0.9


def read_theirs(fcd_file, stops_file, kept):
    """Samples of SUMO's vehicles on lanes outside junctions, and when each has come to where its trip ends. Those who park beside
    a lane are not on it."""
    parked = collections.defaultdict(list)
    for stop in ET.parse(stops_file).getroot():
        if stop.get("parking") == "1":
            parked[stop.get("id")].append((float(stop.get("started")), float(stop.get("ended"))))
    samples, arrived, progress = [], {}, collections.Counter()
    for step in ET.parse(fcd_file).getroot():
        time = float(step.get("time"))
        for vehicle in step:
            name, lane, pos = vehicle.get("id"), vehicle.get("lane"), float(vehicle.get("pos"))
            if lane.startswith(":") or any(begin <= time <= end for begin, end in parked[name]):
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
            if name not in arrived and (ahead > trip.last or (ahead == trip.last and pos >= trip.end.pos)):
                arrived[name] = time
    return samples, arrived


Comparison = collections.namedtuple("Comparison", "ours_s theirs_s vehicles come_through measures headways")


def files(folder):
    """The files of a folder, which is made."""
    os.makedirs(folder, exist_ok=True)
    return lambda name: os.path.join(folder, name)


def make_network(args, file):
    """SUMO's network of the map, with our signal programs beside it, and the signs on it."""
    for kind, name in (("--opendrive", "map.xodr"), ("--geojson", "map.geojson")):
        run(args.endless, "maps", "export", args.map, kind, file(name))
    run(program("netconvert"), "--opendrive-files", file("map.xodr"), "--output.original-names", "--junctions.endpoint-shape",
        "--offset.disable-normalization", "--junctions.limit-turn-speed", str(BEND_MPS2), "-o", file("map.net.xml"))
    slow_down_in_bends(file("map.net.xml"))
    signed = signs(file("map.net.xml"), file("map.geojson"))
    give_way_as_signed(file("map.net.xml"), signed)
    write_programs(file("map.net.xml"), file("map.geojson"), file("programs.add.xml"))
    return Network(file("map.net.xml")), signed


def drive_in_sumo(args, seed, map_file, file, kept):
    """SUMO's samples of our vehicles, and when each has come to where its trip ends."""
    run(program("sumo"), "-n", map_file("map.net.xml"), "-a", map_file("programs.add.xml"), "-r", file("demand.rou.xml"),
        "--fcd-output", file("sumo.fcd.xml"), "--stop-output", file("stops.xml"), "--step-length", "0.1", "--device.fcd.period", STEP_S,
        "--end", args.seconds * 3, "--time-to-teleport", "-1", "--seed", seed, "--collision.action", "warn", "--no-step-log")
    return read_theirs(file("sumo.fcd.xml"), file("stops.xml"), kept)


def compare(args, seed, folder, network, signed):
    """With one seed: mean times, ours and SUMO's, seconds, of how many vehicles they are, whether nearly all came to their end, both's
    medians of each measure, and both's headways at stop signs."""
    map_file, file = files(folder), files(os.path.join(folder, str(seed)))
    run(args.endless, "simulate", args.map, "--seconds", 2 * args.seconds, "--vehicles", args.vehicles, "--pedestrians", 0,
        "--seed", seed, "--fps", round(1 / STEP_S), "--out", file("ours.csv"))
    rows, trips = read_ours(file("ours.csv"), network)
    kept = write_demand(trips, network, args.seconds, file("demand.rou.xml"))
    theirs, arrived = drive_in_sumo(args, seed, map_file, file, kept)
    both = [v for v in kept if v in arrived]
    come_through = len(both) >= COME_THROUGH * len(kept)
    ours_s = sum(kept[v].end.time - kept[v].begin.time for v in both) / max(len(both), 1)
    theirs_s = sum(arrived[v] - kept[v].begin.time for v in both) / max(len(both), 1)
    print(f"{args.map}, seed {seed}: of {rows['id'].nunique()} vehicles, {len(kept)} have a way that is one of SUMO's, {len(both)} come to its end there")
    if not come_through:
        print("SUMO's traffic has come to stand: try fewer vehicles")
    print(f"mean travel time: ours {ours_s:.1f} s, SUMO's {theirs_s:.1f} s, {100 * (ours_s / theirs_s - 1):+.1f} %")
    ours = []
    for vehicle, trip in kept.items():
        _, places = trips[int(vehicle)]
        ours += [(p.time, vehicle, p.lane.getID(), p.pos, p.speed, float(trip.vehicle["length"])) for p in places]
    ours, theirs = ([sample for sample in samples if sample[0] <= args.seconds] for samples in (ours, theirs))
    measures = [surrogate_safety(samples, STEP_S) for samples in (ours, theirs)]
    for name in measures[0]:
        print(f"{name:12} ours {measures[0][name]:6.2f}   SUMO's {measures[1][name]:6.2f}")
    headways = [critical_headway.headways(samples, network, signed) for samples in (ours, theirs)]
    return Comparison(ours_s, theirs_s, len(both), come_through, [(of, measures[1][name]) for name, of in measures[0].items()], headways)


def tell_headways(found):
    """The critical headways at stop signs, of ours and SUMO's of all seeds, if enough drivers waited there."""
    for turn, name, published_s in (("l", "left", 7.1), ("r", "right", 6.2)):
        all_of = lambda k, of: sum((headways[k][turn][of] for headways in found), [])
        ours, theirs = (critical_headway.critical(all_of(k, 0), all_of(k, 1)) for k in (0, 1))
        if ours and theirs:
            print(f"critical headway to turn {name}, s: ours {ours:.1f}, SUMO's {theirs:.1f}, Highway Capacity Manual's {published_s}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("endless", help="the program")
    parser.add_argument("map", help="a town or a map file")
    parser.add_argument("--vehicles", type=int, default=100)
    parser.add_argument("--seconds", type=float, default=300)
    parser.add_argument("--seed", type=int, default=1, help="the first seed")
    parser.add_argument("--seeds", type=int, default=1, help="how many, from the first on: times are the mean of all")
    parser.add_argument("--keep", help="a folder for all files: the network, and in it a folder for each seed")
    args = parser.parse_args()
    folder = args.keep or tempfile.mkdtemp()
    network, signed = make_network(args, files(folder))
    found = [compare(args, seed, folder, network, signed) for seed in range(args.seed, args.seed + args.seeds)]
    number = max(sum(of.vehicles for of in found), 1)
    ours_s, theirs_s = sum(of.ours_s * of.vehicles for of in found) / number, sum(of.theirs_s * of.vehicles for of in found) / number
    if args.seeds > 1:
        print(f"of all {args.seeds} seeds: ours {ours_s:.1f} s, SUMO's {theirs_s:.1f} s, {100 * (ours_s / theirs_s - 1):+.1f} %")
    tell_headways([of.headways for of in found])
    alike = abs(ours_s / theirs_s - 1) <= 0.15 and all(of.come_through for of in found)
    alike &= all(1 / 3 <= ours / theirs <= 3 for of in found for ours, theirs in of.measures)
    sys.exit(0 if alike else 1)


if __name__ == "__main__":
    main()
