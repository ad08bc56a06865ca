"""Our traffic as demand for SUMO: where each of our vehicles comes from, the edges it drives along, and where it stops."""

import collections
import itertools
import math
import xml.etree.ElementTree as ET

NEAR_M = 4.0
# The time headways that drivers keep, seconds: in SUMO queues leave a light with 1,850 vehicles an hour and lane, of 1,800 to 1,900 in
# the Highway Capacity Manual and 1,835 of ours (sumo_saturation_flow.py); with those of our own drivers, 0.75 to 1.4 s, it were 2,145.
HEADWAYS_S = (0.98, 1.82)
# Drivers give way as those of the Highway Capacity Manual do only with SUMO's greatest impatience (compare_sumo.py).
IMPATIENCE = 1
# What those reach that are slower than limits, m/s.
MOST_MPS = {"bicycle": 4.8, "truck": 23.0, "bus": 22.0}
# Slower than this somebody stands, m/s; who stands for so long, seconds, with no junction and nobody else who stands so near ahead,
# metres, does so of their own accord.
STANDS_MPS, LEAST_STOP_S, ALONE_M = 0.1, 8.0, 15.0
# A stop so near beyond where one begins can't be made, metres.
BRAKES_M = 40.0

# Where one of ours is: in SUMO's terms, `pos` in metres along the lane.
Place = collections.namedtuple("Place", "time lane pos speed")
Stop = collections.namedtuple("Stop", "time lane pos seconds parked")
# From `begin` to `end`, along `edges`, of which `last` is the one in which it ends.
Trip = collections.namedtuple("Trip", "begin end edges last vehicle")


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
                places.append(Place(time, *found, speed))
        trips[vehicle] = (own, places)
    return rows, trips


def stops(trips):
    """Where each of ours parks beside its road, and where it stands on a lane with nobody ahead, as buses at stops do and those who
    deliver."""
    standing = collections.defaultdict(list)
    for _, places in trips.values():
        for place in places:
            if place.speed < STANDS_MPS:
                standing[(place.time, place.lane.getID())].append(place.pos)

    def alone(place):
        beyond = [pos for pos in standing[(place.time, place.lane.getID())] if place.pos < pos < place.pos + ALONE_M]
        return place.speed < STANDS_MPS and not beyond and place.pos + ALONE_M < place.lane.getLength()

    found = {}
    for vehicle, (own, places) in trips.items():
        stood = list(own["time"][own["speed"] < STANDS_MPS])
        mine = []
        for before, after in zip(places, places[1:]):
            away_s = after.time - before.time
            if away_s >= LEAST_STOP_S and before.lane.getEdge() is after.lane.getEdge() and any(before.time < t < after.time for t in stood):
                mine.append(Stop(before.time, before.lane, after.pos, away_s, True))
        for still, run in itertools.groupby(places, alone):
            run = list(run)
            if still:
                mine.append(Stop(run[0].time, run[0].lane, run[0].pos, run[-1].time - run[0].time, False))
        found[vehicle] = joined(stop for stop in mine if stop.seconds >= LEAST_STOP_S)
    return found


def joined(stops):
    """Who parks may stand on the lane before and after: one stop."""
    found = []
    for stop in sorted(stops, key=lambda stop: stop.time):
        last = found[-1] if found else None
        if last and stop.lane is last.lane and stop.time < last.time + last.seconds + LEAST_STOP_S:
            ends = max(last.time + last.seconds, stop.time + stop.seconds)
            found[-1] = Stop(last.time, last.lane, max(last.pos, stop.pos), ends - last.time, last.parked or stop.parked)
        else:
            found.append(stop)
    return found


def share(vehicle, salt):
    """A number from 0 to 1 that looks random."""
    return ((vehicle * 2654435761 + salt * 40503) % 99991) / 99991


def driver(root, number, length_m, accel_mps2):
    """Adds a type of vehicle for one driver: IDM's speed factors, acceleration and comfortable braking of ours."""
    between = lambda low, high, salt: f"{low + (high - low) * share(number, salt):.3f}"
    return ET.SubElement(root, "vType", id=f"t{number}", length=f"{length_m:.2f}", minGap="2.5", speedFactor=between(0.88, 1.12, 1),
                         tau=between(*HEADWAYS_S, 2), accel=str(accel_mps2), decel="1.95", emergencyDecel="7.5",
                         carFollowModel="Krauss", impatience=str(IMPATIENCE))


def trip(own, places, network, seconds):
    """What one of ours drives: from where it first is on a road outside junctions to where it is after these seconds, and as many more.
    None if it parks for most of the time, or drives where SUMO has no way."""
    within = [place for place in places if place.time <= seconds]
    if len(within) < 2 or within[0].time > 0.2 * seconds or within[-1].time < 0.8 * seconds:
        return None
    edges = network.route([place.lane.getEdge() for place in within])
    whole = network.route([place.lane.getEdge() for place in places])
    if not edges or not whole or whole[: len(edges)] != edges:
        return None
    return Trip(within[0], within[-1], whole, len(edges) - 1, own.iloc[0])


def write_demand(trips, network, seconds, out_file):
    """Writes what each vehicle drives and where it stops, and gives the trips."""
    root = ET.Element("routes")
    kept = {str(vehicle): found for vehicle, ours in trips.items() if (found := trip(*ours, network, seconds))}
    halts = stops(trips)
    # Two cannot depart at one place: SUMO puts in those further ahead first.
    for vehicle in sorted(kept, key=lambda v: (kept[v].begin.time, kept[v].begin.lane.getID(), -kept[v].begin.pos)):
        begin, _, edges, _, first = kept[vehicle]
        number, heavy = int(vehicle), first["class"] in ("bus", "truck")
        kind = driver(root, number, float(first["length"]), 1.1 if heavy else 1.75)
        kind.set("vClass", {"bus": "bus", "truck": "truck"}.get(first["class"], "passenger"))
        most_mps = MOST_MPS.get(first["class"])
        if most_mps:
            kind.set("maxSpeed", str(most_mps))
        starts_mps = min(begin.speed, 0.85 * begin.lane.getSpeed(), 0.85 * (most_mps or math.inf))
        element = ET.SubElement(root, "vehicle", id=vehicle, type=f"t{vehicle}", depart=f"{begin.time:.1f}",
                                departLane=begin.lane.getID().rsplit("_", 1)[1], departPos=f"{begin.pos:.2f}",
                                departSpeed=f"{starts_mps:.2f}", insertionChecks="none" if begin.time == 0 else "collision")
        ET.SubElement(element, "route", edges=" ".join(edge.getID() for edge in edges))
        for stop in halts[number]:
            if stop.time > begin.time + 5 or stop.lane is not begin.lane or stop.pos > begin.pos + BRAKES_M:
                ET.SubElement(element, "stop", lane=stop.lane.getID(), endPos=f"{max(stop.pos, 1):.2f}", duration=f"{stop.seconds:.1f}",
                              parking="true" if stop.parked else "false")
    ET.ElementTree(root).write(out_file)
    return kept
