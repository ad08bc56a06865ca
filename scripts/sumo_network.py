"""Makes of SUMO's network, which netconvert has read from our OpenDRIVE export, one with our signal programs, signs and bends."""

import bisect
import collections
import json
import math
import xml.etree.ElementTree as ET

# Sideways acceleration in bends, and that with which drivers slow down before them and speed up behind, m/s2.
BEND_MPS2 = 2.0
SLOWS_DOWN_MPS2, SPEEDS_UP_MPS2 = 1.3, 1.75
# Bends are measured over so many metres to both sides of a place.
BEND_M = 8.0

LETTER = {"green": "G", "yellow": "y", "red": "r", "red_yellow": "u"}


def shown(cycle, time_s):
    time_s %= sum(phase["seconds"] for phase in cycle)
    for phase in cycle:
        if time_s < phase["seconds"]:
            return phase["aspect"]
        time_s -= phase["seconds"]
    return cycle[-1]["aspect"]


def write_programs(net_file, geojson_file, out_file):
    """Our signal programs for SUMO's traffic lights: which of our groups a link obeys is in the signal's id."""
    features = json.load(open(geojson_file))["features"]
    cycles = {f["properties"]["signal"]: f["properties"]["cycle"] for f in features if f["properties"]["kind"] == "signal"}
    root = ET.Element("additional")
    net = ET.parse(net_file).getroot()
    for logic in net.iter("tlLogic"):
        states = [phase.get("state") for phase in logic.iter("phase")]
        groups = {}
        for param in logic.iter("param"):
            key = param.get("key")
            if key.startswith("linkSignalID:"):
                groups[int(key.split(":")[1])] = int(param.get("value").split("_")[0])
        links = len(states[0])
        # Where SUMO has a link yield within its green (permitted turns), it does so here.
        yields = [any(state[i] == "g" for state in states) for i in range(links)]
        own = [cycles.get(groups.get(i)) for i in range(links)]
        known = [cycle for cycle in own if cycle]
        if not known:
            continue
        whole = sum(phase["seconds"] for phase in known[0])
        changes = {0.0}
        for cycle in known:
            at = 0.0
            for phase in cycle:
                at += phase["seconds"]
                changes.add(round(at, 3))
        times = sorted(t for t in changes if t < whole - 1e-6) + [whole]
        element = ET.SubElement(root, "tlLogic", id=logic.get("id"), type="static", programID="ours", offset="0")
        for begin, end in zip(times, times[1:]):
            state = ""
            for i in range(links):
                letter = "O" if own[i] is None else LETTER[shown(own[i], 0.5 * (begin + end))]
                state += "g" if letter == "G" and yields[i] else letter
            ET.SubElement(element, "phase", duration=f"{end - begin:.3f}", state=state)
    ET.ElementTree(root).write(out_file)


def mean_speed_through_bends(shape, limit):
    """The mean speed of who drives along a lane at a limit, m/s, and goes through its bends at the usual acceleration sideways."""
    along = [0.0]
    for a, b in zip(shape, shape[1:]):
        along.append(along[-1] + math.dist(a, b))

    def at(s):
        k = max(1, min(len(shape) - 1, bisect.bisect(along, s)))
        u = (s - along[k - 1]) / max(along[k] - along[k - 1], 1e-9)
        return [a + u * (b - a) for a, b in zip(shape[k - 1], shape[k])]

    stations = max(int(along[-1] // 2), 1)
    step = along[-1] / stations
    speeds = []
    for k in range(stations + 1):
        middle = min(max(k * step, BEND_M), along[-1] - BEND_M)
        if along[-1] < 2 * BEND_M:
            speeds.append(limit)
            continue
        a, b, c = at(middle - BEND_M), at(middle), at(middle + BEND_M)
        # Of the circle through three points.
        area = abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]))
        curvature = 2 * area / max(math.dist(a, b) * math.dist(b, c) * math.dist(a, c), 1e-9)
        speeds.append(min(limit, math.sqrt(BEND_MPS2 / max(curvature, 1e-9))))
    for k in range(1, len(speeds)):
        speeds[k] = min(speeds[k], math.sqrt(speeds[k - 1] ** 2 + 2 * SPEEDS_UP_MPS2 * step))
    for k in reversed(range(len(speeds) - 1)):
        speeds[k] = min(speeds[k], math.sqrt(speeds[k + 1] ** 2 + 2 * SLOWS_DOWN_MPS2 * step))
    return len(speeds) / sum(1 / max(speed, 0.1) for speed in speeds)


def points(lane):
    """The middle of a lane of SUMO's."""
    return [tuple(map(float, point.split(",")[:2])) for point in lane.get("shape").split()]


def slow_down_in_bends(net_file):
    """Gives the lanes of roads with bends the speed that these allow."""
    tree = ET.parse(net_file)
    for edge in tree.getroot().iter("edge"):
        if edge.get("function") == "internal":
            continue
        for lane in edge.iter("lane"):
            lane.set("speed", f"{mean_speed_through_bends(points(lane), float(lane.get('speed'))):.2f}")
    tree.write(net_file)


def signs(net_file, geojson_file):
    """What our map has at the end of each of SUMO's lanes: "free", "yield", "stop" or "signal"."""
    features = json.load(open(geojson_file))["features"]
    ends = [(f["geometry"]["coordinates"][-1], f["properties"]["end"]) for f in features
            if f["properties"]["kind"] == "lane" and f["properties"]["junction"] is None]
    found = {}
    for lane in ET.parse(net_file).getroot().iter("lane"):
        distance, sign = min((math.dist(points(lane)[-1], end[:2]), sign) for end, sign in ends)
        found[lane.get("id")] = sign if distance < 1.0 else "free"
    return found


def give_way_as_signed(net_file, signed):
    """Who gives way at junctions without lights, as our map has it: netconvert guesses from the widths of roads and knows no stop
    signs. Signs (`signs`) come first, then who turns back waits, and who turns left for those who come towards them; then the right goes
    before the left (`gives_way` of endless_road). Junctions where all must stop stay as they are: SUMO lets one in after the other
    there, and of 87 vehicles of Town07 33 never come to their end, the others in 541 s instead of 300."""
    tree = ET.parse(net_file)
    root = tree.getroot()
    shapes = {lane.get("id"): points(lane) for lane in root.iter("lane")}

    # Of each connection the lane inside the junction by whose place SUMO numbers it: the last, where one waits in the middle.
    onwards = {c.get("from") + "_" + c.get("fromLane"): c.get("via") for c in root.iter("connection") if c.get("from").startswith(":")}
    links = collections.defaultdict(dict)
    for connection in root.iter("connection"):
        via = connection.get("via")
        if connection.get("from").startswith(":") or via is None:
            continue
        links[via[1:].rsplit("_", 2)[0]][onwards.get(via) or via] = connection

    def gives_way(a, b):
        """Of two links, each sign, turn, heading and number."""
        rank = lambda link: {"yield": 1, "stop": 2}.get(link[0], 0)
        if rank(a) != rank(b):
            return rank(a) > rank(b)
        angle = math.degrees(math.remainder(b[2] - a[2], 2 * math.pi))
        oncoming = abs(angle) > 135
        if (a[1] == "t") != (b[1] == "t"):
            return a[1] == "t"
        left = lambda link: link[1] in ("l", "L", "t")
        if oncoming and left(a) != left(b):
            return left(a)
        if not oncoming and abs(angle) > 30:
            return angle > 0
        return a[3] > b[3]

    for junction in root.iter("junction"):
        if junction.get("type") not in ("priority", "right_before_left", "allway_stop", "priority_stop"):
            continue
        inside = junction.get("intLanes").split()
        requests = {int(request.get("index")): request for request in junction.iter("request")}
        known = {}
        for place, name in enumerate(inside):
            connection = links[junction.get("id")].get(name)
            if connection is not None and place in requests:
                lane = connection.get("from") + "_" + connection.get("fromLane")
                (x0, y0), (x1, y1) = shapes[lane][-2:]
                known[place] = (signed[lane], connection.get("dir"), math.atan2(y1 - y0, x1 - x0), place, connection)
        if all(link[0] == "stop" for link in known.values()):
            continue
        for place, link in known.items():
            # Their digits are counted from the last.
            foes, response = requests[place].get("foes"), list(requests[place].get("response"))
            for other, foe in known.items():
                if foes[-1 - other] == "1":
                    response[-1 - other] = str(int(gives_way(link, foe)))
            requests[place].set("response", "".join(response))
            waits = "1" in response
            link[4].set("state", "s" if link[0] == "stop" else "m" if waits else "M")
    tree.write(net_file)
