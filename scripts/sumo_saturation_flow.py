#!/usr/bin/env python3
"""How many vehicles an hour and lane leave a light in SUMO, driven as `compare_sumo.py` has it: `python3 scripts/sumo_saturation_flow.py`.

A queue of 25 cars of 4.6 m on one lane at 50 km/h gets green, twelve times with other drivers. The flow is that of the fifth one and
all behind, as in the Highway Capacity Manual 2010, which has 1,800 to 1,900. Needs the `eclipse-sumo` wheel.
"""

import os
import statistics
import tempfile
import xml.etree.ElementTree as ET

from sumo_demand import driver
from sumo_programs import program, run

QUEUES, CARS, CAR_M, SPACE_M, LINE_M = 12, 25, 4.6, 12, 480
BEGINS = 4
NODES = """<nodes><node id="a" x="0" y="0"/><node id="b" x="500" y="0" type="traffic_light"/><node id="c" x="1000" y="0"/>
<node id="d" x="500" y="-300"/><node id="e" x="500" y="300"/></nodes>"""
EDGES = """<edges><edge id="ab" from="a" to="b" speed="13.9"/><edge id="bc" from="b" to="c" speed="13.9"/>
<edge id="db" from="d" to="b" speed="13.9"/><edge id="be" from="b" to="e" speed="13.9"/></edges>"""
CONNECTIONS = """<connections><connection from="ab" to="bc"/><connection from="db" to="be"/></connections>"""
PROGRAM = """<additional><tlLogic id="b" type="static" programID="queue" offset="0"><phase duration="40" state="rG"/>
<phase duration="90" state="Gr"/></tlLogic></additional>"""


def headway_s(folder, queue):
    """The mean time between two that cross the line."""
    file = lambda name: os.path.join(folder, name)
    root = ET.Element("routes")
    for k in range(CARS):
        number = 1000 * queue + k
        driver(root, number, CAR_M, 1.75)
        vehicle = ET.SubElement(root, "vehicle", id=str(number), type=f"t{number}", depart="0", departPos=str(LINE_M - SPACE_M * k),
                                departSpeed="0", insertionChecks="none")
        ET.SubElement(vehicle, "route", edges="ab bc")
    ET.ElementTree(root).write(file("queue.rou.xml"))
    run(program("sumo"), "-n", file("map.net.xml"), "-a", file("light.add.xml"), "-r", file("queue.rou.xml"), "--fcd-output",
        file("fcd.xml"), "--step-length", "0.1", "--end", 130, "--seed", queue, "--no-step-log")
    crossed = {}
    for step in ET.parse(file("fcd.xml")).getroot():
        for vehicle in step:
            if not vehicle.get("lane").startswith("ab"):
                crossed.setdefault(vehicle.get("id"), float(step.get("time")))
    times = sorted(crossed.values())[BEGINS - 1:]
    return (times[-1] - times[0]) / (len(times) - 1)


def main():
    with tempfile.TemporaryDirectory() as folder:
        file = lambda name: os.path.join(folder, name)
        for name, text in (("nod", NODES), ("edg", EDGES), ("con", CONNECTIONS), ("light.add", PROGRAM)):
            with open(file(f"{name}.xml"), "w") as out:
                out.write(text)
        run(program("netconvert"), "-n", file("nod.xml"), "-e", file("edg.xml"), "-x", file("con.xml"), "-o", file("map.net.xml"))
        flow = 3600 / statistics.mean(headway_s(folder, queue) for queue in range(QUEUES))
    print(f"saturation flow: {flow:.0f} vehicles an hour and lane")


if __name__ == "__main__":
    main()
