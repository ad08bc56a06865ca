#!/usr/bin/env python3
"""Checks what CARLA's own client reads of OpenDRIVE files that we wrote.

Needs the `carla` wheel (0.9.16); no server. Usage:

    python3 scripts/judge_carla_map.py MAP.xodr...

Prints a line a map; the exit status is 1 if one has a fault. A file `MAP.geojson` beside a map, exported from the same
map, says what we hold to be there; only then are heights, widths, positions and counts compared with ours. The built-in
towns:

    for town in Town01 Town02 Town03 Town04 Town05 Town06 Town07 Town10HD Ladera Altstadt; do
        endless maps export $town --opendrive $town.xodr
        endless maps export $town --geojson $town.geojson
    done
    python3 scripts/judge_carla_map.py *.xodr

The client's frame is left-handed (y south) and that of both files right-handed (y north).
"""

import collections
import json
import math
import os
import sys
import xml.etree.ElementTree as ET

import carla

# The most that a place on a lane may be off, metres: across the lane, along it (the client projects onto chords of the
# reference line, the less exactly the farther away from it), and in height.
OFF_M = 0.2
ALONG_M = 0.8
HIGH_M = 0.1
WIDTH_M = 0.02
SIDEWALK_M = 0.5
# Corners of crosswalks, against the ends of crossings: on a slope they are higher or lower.
CORNER_M = 0.1
CORNER_HIGH_M = 0.5
STEP_M = 2.0
DRIVING = carla.LaneType.Driving
SIDEWALK = carla.LaneType.Sidewalk
LIGHT = "1000001"


class Judge:
    """The faults of one map."""

    def __init__(self, path):
        self.faults = collections.OrderedDict()
        self.figures = collections.OrderedDict()
        self.name = os.path.splitext(os.path.basename(path))[0]
        with open(path, encoding="utf-8") as file:
            text = file.read()
        self.xml = ET.fromstring(text)
        self.map = carla.Map(self.name, text)
        beside = os.path.splitext(path)[0] + ".geojson"
        self.ours = None
        if os.path.exists(beside):
            with open(beside, encoding="utf-8") as file:
                features = json.load(file)["features"]
            self.ours = collections.defaultdict(list)
            for feature in features:
                self.ours[feature["properties"]["kind"]].append(feature)

    def expect(self, holds, what):
        if not holds:
            self.faults[what] = self.faults.get(what, 0) + 1

    def most(self, what, value, limit):
        self.figures[what] = max(self.figures.get(what, 0.0), value)
        self.expect(value <= limit, f"{what} over {limit}")

    # What needs the file alone.

    def roads(self):
        waypoints = [w for w in self.map.generate_waypoints(STEP_M) if w.lane_type == DRIVING]
        self.figures["waypoints"] = len(waypoints)
        self.figures["dead ends"] = sum(1 for w in waypoints if not w.next(STEP_M))
        junctions = {}
        for waypoint in (w for w in waypoints if w.is_junction):
            if waypoint.junction_id not in junctions:
                junctions[waypoint.junction_id] = waypoint.get_junction()
            self.expect(junctions[waypoint.junction_id].id == waypoint.junction_id, "junction of another id")
        for junction in junctions.values():
            extent = junction.bounding_box.extent
            self.expect(0.0 < extent.x < 500.0 and 0.0 < extent.y < 500.0, "junction without a box")
            self.expect(len(junction.get_waypoints(DRIVING)) > 0, "junction without ways")
        self.figures["junctions"] = len(junctions)
        topology = self.map.get_topology()
        self.figures["ways"] = len(topology)
        for begin, end in topology:
            place = end.transform.location
            distances = [w.transform.location.distance(place) for w in begin.next_until_lane_end(STEP_M)[-1:]]
            self.expect(all(d < STEP_M + 0.1 for d in distances), "way that jumps")
        earth = self.map.transform_to_geolocation(carla.Location(10.0, 20.0, 1.0))
        self.expect(all(map(math.isfinite, (earth.latitude, earth.longitude))), "no place on Earth")

    def speeds(self):
        for lane in self.xml.iterfind("road/lanes/laneSection/*/lane[@type='driving']"):
            speed = lane.find("speed")
            self.expect(speed is not None and float(speed.get("max")) > 0.0, "lane without a speed limit")

    def signals(self):
        written = {signal.get("id"): signal for signal in self.xml.iterfind("road/signals/signal")}
        landmarks = self.map.get_all_landmarks()
        self.figures["signs"] = sum(1 for mark in landmarks if mark.type != LIGHT)
        self.expect(sorted(mark.id for mark in landmarks) == sorted(written), "signals differ from the file's")
        controlled = {c.get("signalId"): c for c in self.xml.iterfind("controller/control")}
        lights = self.map.get_all_landmarks_of_type(LIGHT)
        self.figures["lights"] = len(lights)
        for light in lights:
            self.expect(light.id in controlled, "light without a controller")
            self.expect(light.is_dynamic, "light that does not change")
            group = {mark.id for mark in self.map.get_landmark_group(light)}
            self.expect(light.id in group, "light outside its own group")
            for first, last in light.get_lane_validities():
                for lane in range(min(first, last), max(first, last) + 1):
                    before = self.map.get_waypoint_xodr(light.road_id, lane, max(0.0, light.s - 3.0))
                    seen = before.get_landmarks_of_type(10.0, LIGHT) if before else []
                    self.expect(light.id in {mark.id for mark in seen}, "light that its lane does not see")
        used = {c.get("id") for c in self.xml.iterfind("junction/controller")}
        there = {c.get("id") for c in self.xml.iterfind("controller")}
        self.expect(there <= used, "controller of no junction")

    # What is compared with ours.

    def lanes(self):
        lanes = {f["properties"]["id"]: f for f in self.ours["lane"]}
        ways = sum(len(f["properties"]["successors"]) for f in lanes.values())
        self.expect(ways == self.figures["ways"], f"ways: {self.figures['ways']}, ours {ways}")
        junctions = {f["properties"]["junction"] for f in lanes.values()} - {None}
        self.expect(len(junctions) == self.figures["junctions"], f"junctions: ours {len(junctions)}")
        ends = sum(1 for f in lanes.values() if not f["properties"]["successors"])
        self.expect(ends > 0 or self.figures["dead ends"] == 0, "dead ends that are none of ours")
        for lane in lanes.values():
            points = lane["geometry"]["coordinates"]
            for a, b in zip(points, points[1:]):
                x, y, z = (0.5 * (u + v) for u, v in zip(a, b))
                place = carla.Location(x, -y, z)
                waypoint = self.map.get_waypoint(place, project_to_road=True, lane_type=DRIVING)
                there, yaw = waypoint.transform.location, math.radians(waypoint.transform.rotation.yaw)
                dx, dy = there.x - place.x, there.y - place.y
                self.most("off m", abs(dy * math.cos(yaw) - dx * math.sin(yaw)), OFF_M)
                self.most("along m", abs(dx * math.cos(yaw) + dy * math.sin(yaw)), ALONG_M)
                self.most("height m", abs(there.z - z), HIGH_M)
                if lane["properties"]["junction"] is None:
                    self.most("width m", abs(waypoint.lane_width - lane["properties"]["width_m"]), WIDTH_M)

    def sidewalks(self):
        for edge in self.ours["sidewalk"]:
            a, b = edge["geometry"]["coordinates"]
            x, y, z = (0.5 * (u + v) for u, v in zip(a, b))
            waypoint = self.map.get_waypoint(carla.Location(x, -y, z), project_to_road=True, lane_type=SIDEWALK)
            self.expect(waypoint is not None, "no sidewalk")
            if waypoint is not None:
                there = waypoint.transform.location
                self.most("sidewalk off m", math.hypot(there.x - x, there.y + y), SIDEWALK_M)

    def crosswalks(self):
        corners = self.map.get_crosswalks()
        polygons, at = [], 0
        while at < len(corners):
            end = next((i for i in range(at + 1, len(corners)) if corners[i].distance(corners[at]) < 1e-3), None)
            if end is None:
                self.expect(False, "crosswalk that is not closed")
                return
            polygons.append(corners[at:end])
            at = end + 1
        self.figures["crosswalks"] = len(polygons)
        self.expect(bool(polygons), "no crosswalks")
        self.expect(all(len(polygon) == 4 for polygon in polygons), "crosswalk without four corners")
        if self.ours is None:
            return
        self.expect(len(polygons) == len(self.ours["crossing"]), "not as many crosswalks as ours")
        for crossing in self.ours["crossing"]:
            a, b = crossing["geometry"]["coordinates"]
            length = math.hypot(b[0] - a[0], b[1] - a[1])
            half = 0.5 * crossing["properties"]["width_m"] / length
            across = (-(b[1] - a[1]) * half, (b[0] - a[0]) * half)
            for end in (a, b):
                for side in (-1.0, 1.0):
                    x, y = end[0] + side * across[0], end[1] + side * across[1]
                    near = min(corners, key=lambda c: math.hypot(c.x - x, c.y + y) + 0.1 * abs(c.z - end[2]))
                    self.most("corner off m", math.hypot(near.x - x, near.y + y), 2 * OFF_M)
                    self.most("corner height m", abs(near.z - end[2]), CORNER_HIGH_M)

    def run(self):
        self.roads()
        self.speeds()
        self.signals()
        self.crosswalks()
        if self.ours is not None:
            self.lanes()
            self.sidewalks()
        figures = ", ".join(
            f"{what} {value:.3f}" if isinstance(value, float) else f"{what} {value}"
            for what, value in self.figures.items()
        )
        faults = "; ".join(f"{what} ({times}x)" for what, times in self.faults.items())
        print(f"{self.name}: {'FAULT: ' + faults if faults else 'good'}: {figures}", flush=True)
        return not faults


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    good = [Judge(path).run() for path in sys.argv[1:]]
    sys.exit(0 if all(good) else 1)


if __name__ == "__main__":
    main()
