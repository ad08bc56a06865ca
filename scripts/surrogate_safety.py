"""Five of the surrogate safety measures of SUMO's SSM device: of each vehicle the most critical value that it meets, and of these the
median.

    TTC     time to collision with the vehicle ahead, seconds: its lowest
    DRAC    deceleration rate to avoid a crash, m/s2: its highest
    TGAP    time gap to the vehicle ahead, seconds: its lowest
    BR      braking, m/s2: its highest
    PET     time from when one vehicle leaves a place of its lane until the next one comes to it, seconds: its lowest
"""

import collections
import math


def median(values):
    values = sorted(values)
    return values[len(values) // 2] if values else math.nan


def surrogate_safety(samples, step_s):
    """Of samples (time, vehicle, lane, place of the front, speed, length) on lanes outside junctions, one every `step_s` seconds: the
    median of each measure."""
    on_lane = collections.defaultdict(list)
    speeds = collections.defaultdict(dict)
    for time, vehicle, lane, s, speed, length in samples:
        on_lane[(round(time / step_s), lane)].append((s, vehicle, speed, length))
        speeds[vehicle][round(time / step_s)] = speed
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
                note("BR, m/s2", vehicle, (v - own[k + 1]) / step_s, 1)
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
