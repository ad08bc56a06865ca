"""The critical headway of drivers who wait at stop signs: the shortest time between two with priority in which half of them would go."""

import collections

# Who is this near to the line waits there, metres.
AT_LINE_M = 6.0
# So many drivers tell something.
ENOUGH = 30


def headways(samples, network, signs):
    """Of all who enter junctions from stop signs where others have priority, by their turn ("l", "r"): the headway that each took, and
    the longest that each let pass. Of samples (time, vehicle, lane, place of the front, ...) on lanes outside junctions. Those who turn
    left look at all who go straight on or left, those who turn right at those who go straight on to where they want."""
    ways = collections.defaultdict(list)
    for time, vehicle, lane, s, *_ in sorted(samples, key=lambda sample: sample[0]):
        ways[vehicle].append((time, lane, s))
    # Who enters a junction: when, from which lane, to which edge, and since when they were at the line.
    entries = collections.defaultdict(list)
    for way in ways.values():
        since = None
        for (time, lane, s), (_, onto, _) in zip(way, way[1:]):
            at_line = network.net.getLane(lane).getLength() - s < AT_LINE_M
            since = (time if since is None else since) if at_line else None
            edge, next_edge = (name.rsplit("_", 1)[0] for name in (lane, onto))
            if edge != next_edge:
                entries[network.net.getEdge(edge).getToNode().getID()].append((time, lane, next_edge, time if since is None else since))
                since = None

    def turn(lane, next_edge):
        connections = network.net.getLane(lane).getEdge().getOutgoing().get(network.net.getEdge(next_edge), [])
        return connections[0].getDirection() if connections else None

    found = {"l": ([], []), "r": ([], [])}
    for there in entries.values():
        passing = [(time, turn(lane, onto), onto) for time, lane, onto, _ in there if signs[lane] == "free"]
        if not passing:
            continue
        for time, lane, onto, since in there:
            mine = turn(lane, onto)
            if signs[lane] != "stop" or mine not in found:
                continue
            minded = sorted(at for at, theirs, to in passing
                            if theirs in ("s", "l") and mine == "l" or theirs == "s" and to == onto)
            before, after = [since] + [at for at in minded if since < at < time], [at for at in minded if at >= time]
            taken, passed = found[mine]
            if after:
                taken.append(after[0] - before[-1])
            if len(before) > 1:
                passed.append(max(b - a for a, b in zip(before, before[1:])))
    return found


def critical(taken, passed):
    """As Raff and Hart (1950): as many take a shorter one as let a longer one pass. Seconds; None if too few are known."""
    if min(len(taken), len(passed)) < ENOUGH:
        return None
    share = lambda of: sum(of) / len(of)
    imbalance = lambda t: abs(share([h < t for h in taken]) - share([h > t for h in passed]))
    return min((0.1 * k for k in range(10, 300)), key=imbalance)
