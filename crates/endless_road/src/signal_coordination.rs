//! Signals along a road that work together: one cycle for all of a neighbourhood, and offsets with which who was let go at one signal
//! comes to the next one while it is green.
//!
//! What is sought are the offsets that let the most vehicles arrive on green, weighted by how well a platoon holds together until
//! then (Robertson 1969, "TRANSYT: a traffic network study tool", RRL report LR 253), by changing one junction after the other until
//! none gets better, as TRANSYT does.
//!
//! A short piece between two signals holds few vehicles. Who is let into it while its own signal is red fills it up, and all others wait
//! for the next cycle; if all the time at which they have green is like that, the road before them carries next to nothing. So what
//! passes counts by its logarithm, as in proportional fairness (Kelly 1997, "Charging and rate control for elastic traffic"): the
//! first few seconds at which somebody comes through count most. On long roads that is the plain sum.

use crate::{JunctionId, LaneId, RoadNetwork, SignalPhase, SignalProgram, TrafficControl, likelihood_of};
use endless_world::math::f64::ln;
use endless_world::{SignalAspect, SignalId};
use std::collections::BTreeMap;

/// Signals further apart along the road know nothing of one another, metres.
const REACH_M: f64 = 400.0;
/// Vehicles go at this share of the limit between signals.
const PROGRESSION_SHARE: f64 = 0.8;
/// Robertson's dispersion of platoons: share of the mean travel time after which the first arrive, and smoothing per second.
const FIRST_SHARE: f64 = 0.8;
const SMOOTHING: f64 = 0.35;
/// Junctions whose cycles differ by more than this factor keep their own.
const MOST_STRETCH: f64 = 1.6;
/// A vehicle that stands has so much of a lane, metres, and a queue lets one go in so much time, seconds.
const STANDING_M: f64 = 7.0;
const SATURATION_HEADWAY_S: f64 = 2.0;
/// Rounds over all junctions at most.
const ROUNDS: usize = 8;

/// A way from one signal to the next.
#[derive(Debug, Clone, Copy)]
struct Progression {
    from: (JunctionId, SignalId),
    to: (JunctionId, SignalId),
    travel_s: f64,
    /// The green that fills up a lane between them, while nobody gets on, seconds.
    room_s: f64,
    /// The share of a lane's drivers who go it, as far as they keep together.
    weight: f64,
}

impl Progression {
    /// What so many seconds of green are worth at which those who are let go come through, of so many in all.
    fn worth(&self, through_s: f64, green_s: f64) -> f64 {
        self.weight * (self.room_s + green_s) * ln((self.room_s + through_s) / self.room_s)
    }
}

/// Gives neighbouring junctions one cycle, and all of them offsets.
pub(crate) fn coordinate(network: &mut RoadNetwork) {
    let ways = progressions(network);
    give_common_cycles(network, &ways);
    choose_offsets(network, &ways);
}

fn signal_at_end(network: &RoadNetwork, lane: LaneId) -> Option<SignalId> {
    match network.lane(lane).end_control {
        TrafficControl::Signal(id) => Some(id),
        _ => None,
    }
}

fn has_program(network: &RoadNetwork, junction: JunctionId) -> bool {
    network.junctions[junction.index()].program.as_ref().is_some_and(|program| cycle_s(program) > 0)
}

/// All ways between neighbouring signals.
fn progressions(network: &RoadNetwork) -> Vec<Progression> {
    let mut found = Vec::new();
    for approach in &network.lanes {
        let Some(signal) = signal_at_end(network, approach.id) else { continue };
        let Some(to) = approach.successors.first().and_then(|&way| network.lane(way).junction) else { continue };
        if !has_program(network, to) {
            continue;
        }
        // Back along the lanes: each with the metres, those outside of junctions, and the seconds from its end to the line.
        let mut open = vec![(approach.id, 0.0, 0.0, 0.0)];
        while let Some((lane, metres, standing_m, seconds)) = open.pop() {
            let here = network.lane(lane);
            let length = here.centerline.length();
            let (metres, seconds) =
                (metres + length, seconds + length / (PROGRESSION_SHARE * here.speed_limit_mps.max(1.0)));
            if metres > REACH_M {
                continue;
            }
            let standing_m = if here.junction.is_none() { standing_m + length } else { standing_m };
            for &before in &here.predecessors {
                let Some(earlier) = signal_at_end(network, before) else {
                    open.push((before, metres, standing_m, seconds));
                    continue;
                };
                let from = here.junction.filter(|&from| from != to && has_program(network, from));
                let smoothing = 1.0 / (1.0 + SMOOTHING * FIRST_SHARE * seconds);
                let turns = |way: LaneId| likelihood_of(network.lane(way).turn);
                let all: f64 = network.lane(before).successors.iter().map(|&way| turns(way)).sum();
                found.extend(from.map(|from| Progression {
                    from: (from, earlier),
                    to: (to, signal),
                    travel_s: seconds,
                    room_s: (standing_m / STANDING_M).max(1.0) * SATURATION_HEADWAY_S,
                    weight: turns(lane) / all * smoothing,
                }));
            }
        }
    }
    found
}

/// Whole seconds.
fn cycle_s(program: &SignalProgram) -> usize {
    program.phases.iter().map(|phase| phase.duration_s).sum::<f64>().round() as usize
}

/// The longest cycle of each neighbourhood becomes that of all its junctions.
fn give_common_cycles(network: &mut RoadNetwork, ways: &[Progression]) {
    let cycle_of =
        |network: &RoadNetwork, junction: usize| network.junctions[junction].program.as_ref().map_or(0, cycle_s);
    let mut longest: Vec<usize> = (0..network.junctions.len()).map(|j| cycle_of(network, j)).collect();
    let own = longest.clone();
    let near = |cycle: usize, junction: usize| cycle as f64 <= MOST_STRETCH * own[junction] as f64;
    // Spreads until nothing changes: cycles only grow, and to one of those that are there.
    let mut grows = true;
    while std::mem::take(&mut grows) {
        for way in ways {
            for (a, b) in [(way.from.0, way.to.0), (way.to.0, way.from.0)].map(|(a, b)| (a.index(), b.index())) {
                if longest[a] > longest[b] && near(longest[a], b) {
                    (longest[b], grows) = (longest[a], true);
                }
            }
        }
    }
    for (junction, longest) in network.junctions.iter_mut().zip(longest) {
        if let Some(program) = &mut junction.program {
            stretch(program, longest);
        }
    }
}

/// Makes a cycle longer: where people or vehicles have green and nothing is about to change, each as much as it is long.
fn stretch(program: &mut SignalProgram, cycle: usize) {
    let steady = |phase: &SignalPhase| {
        phase.aspects.iter().any(|a| a.1 == SignalAspect::Green)
            && phase.aspects.iter().all(|a| a.1 != SignalAspect::Yellow)
    };
    let whole: f64 = program.phases.iter().filter(|phase| steady(phase)).map(|phase| phase.duration_s).sum();
    let mut extra = cycle.saturating_sub(cycle_s(program)) as f64;
    if whole <= 0.0 {
        return;
    }
    let factor = extra / whole;
    let last = program.phases.iter().rposition(steady);
    for (place, phase) in program.phases.iter_mut().enumerate().filter(|(_, phase)| steady(phase)) {
        let more = if Some(place) == last { extra } else { (factor * phase.duration_s).round().min(extra) };
        phase.duration_s += more;
        extra -= more;
    }
}

/// When a signal is green, by second of its cycle.
fn greens(program: &SignalProgram, signal: SignalId) -> Vec<bool> {
    let mut ends = 0.0;
    let spans: Vec<(f64, bool)> = program
        .phases
        .iter()
        .map(|phase| {
            ends += phase.duration_s;
            (ends, phase.aspects.contains(&(signal, SignalAspect::Green)))
        })
        .collect();
    let at = |second: usize| spans.iter().find(|span| second as f64 + 0.5 < span.0).is_some_and(|span| span.1);
    (0..cycle_s(program)).map(at).collect()
}

/// How much arrives on green, by seconds by which the second junction's offset is ahead of the first's.
struct Arrivals {
    from: usize,
    to: usize,
    by_lead: Vec<f64>,
}

/// What arrives on green between each two junctions that have one cycle.
fn arrivals(network: &RoadNetwork, ways: &[Progression]) -> Vec<Arrivals> {
    let mut between: BTreeMap<(usize, usize), Vec<f64>> = BTreeMap::new();
    for way in ways {
        let [from, to] = [way.from, way.to].map(|(junction, signal)| {
            network.junctions[junction.index()].program.as_ref().map_or_else(Vec::new, |p| greens(p, signal))
        });
        let cycle = from.len();
        if cycle == 0 || cycle != to.len() {
            continue;
        }
        let travel = way.travel_s.round() as usize;
        let all = between.entry((way.from.0.index(), way.to.0.index())).or_insert_with(|| vec![0.0; cycle]);
        let green = from.iter().filter(|green| **green).count();
        for (lead, sum) in all.iter_mut().enumerate() {
            let on_green = (0..cycle).filter(|&t| from[t] && to[(t + travel + lead) % cycle]).count();
            *sum += way.worth(on_green as f64, green as f64);
        }
    }
    between.into_iter().map(|((from, to), by_lead)| Arrivals { from, to, by_lead }).collect()
}

fn choose_offsets(network: &mut RoadNetwork, ways: &[Progression]) {
    let arrivals = arrivals(network, ways);
    let mut offsets: BTreeMap<usize, usize> = BTreeMap::new();
    for (j, junction) in network.junctions.iter().enumerate() {
        if let Some(program) = junction.program.as_ref().filter(|program| cycle_s(program) > 0) {
            offsets.insert(j, program.offset_s.rem_euclid(cycle_s(program) as f64) as usize);
        }
    }
    let mut of: BTreeMap<usize, Vec<&Arrivals>> = BTreeMap::new();
    for a in &arrivals {
        of.entry(a.from).or_default().push(a);
        of.entry(a.to).or_default().push(a);
    }
    for _ in 0..ROUNDS {
        let mut better = false;
        for (&junction, near) in &of {
            let cycle = near[0].by_lead.len();
            let worth = |offset: usize| -> f64 {
                let one = |a: &&Arrivals| {
                    let [from, to] = [a.from, a.to].map(|j| if j == junction { offset } else { offsets[&j] });
                    a.by_lead[(to + cycle - from % cycle) % cycle]
                };
                near.iter().map(one).sum()
            };
            let now = offsets[&junction];
            let best = (0..cycle).fold((now, worth(now)), |best, offset| {
                let worth = worth(offset);
                if worth > best.1 + 1e-9 { (offset, worth) } else { best }
            });
            better |= best.0 != now;
            offsets.insert(junction, best.0);
        }
        if !better {
            break;
        }
    }
    for (junction, offset) in offsets {
        if let Some(program) = &mut network.junctions[junction].program {
            program.offset_s = offset as f64;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Junction, Lane, Polyline};
    use endless_world::math::f64::sin_cos;
    use glam::DVec3;
    use std::f64::consts::FRAC_PI_2;

    /// A program of two stages for signals 2 `junction` and 2 `junction` + 1: so many seconds of green each, 5 s between.
    fn program(junction: u16, greens_s: [f64; 2], offset_s: f64) -> SignalProgram {
        let ids = [SignalId(2 * junction), SignalId(2 * junction + 1)];
        let phase = |duration_s: f64, aspects: [SignalAspect; 2]| SignalPhase {
            duration_s,
            aspects: ids.into_iter().zip(aspects).collect(),
        };
        use SignalAspect::{Green, Red, Yellow};
        let phases = vec![
            phase(greens_s[0], [Green, Red]),
            phase(3.0, [Yellow, Red]),
            phase(2.0, [Red, Red]),
            phase(greens_s[1], [Red, Green]),
            phase(3.0, [Red, Yellow]),
            phase(2.0, [Red, Red]),
        ];
        SignalProgram { phases, offset_s }
    }

    /// A road over junctions, 120 m apart, with signal 2k before the k-th.
    fn road(programs: Vec<SignalProgram>) -> RoadNetwork {
        let line = |from: f64, to: f64| Polyline::new([DVec3::X * from, DVec3::X * to]);
        let mut network = RoadNetwork::default();
        let number = programs.len() as u32;
        for (k, program) in (0..).zip(programs) {
            let x = 120.0 * f64::from(k);
            let mut street = Lane::new(LaneId(2 * k), line(x, x + 100.0), 3.5, 12.5);
            street.end_control = TrafficControl::Signal(SignalId(2 * k as u16));
            street.successors = vec![LaneId(2 * k + 1)];
            let mut way = Lane::new(LaneId(2 * k + 1), line(x + 100.0, x + 120.0), 3.5, 12.5);
            way.junction = Some(JunctionId(k as u16));
            way.successors = vec![LaneId(2 * k + 2)];
            network.junctions.push(Junction { lanes: vec![way.id], program: Some(program), ..Junction::default() });
            network.lanes.extend([street, way]);
        }
        let x = 120.0 * f64::from(number);
        network.lanes.push(Lane::new(LaneId(2 * number), line(x, x + 100.0), 3.5, 12.5));
        network.signal_groups = 2 * number as u16;
        network.finish().expect("a road")
    }

    /// Whether a signal of a [`program`] is green at a time.
    fn is_green(network: &RoadNetwork, signal: usize, second: usize) -> bool {
        let program = network.junctions[signal / 2].program.as_ref().expect("a program");
        let greens = greens(program, SignalId(signal as u16));
        greens[(second + program.offset_s as usize) % greens.len()]
    }

    #[test]
    fn who_is_let_go_at_one_signal_comes_to_the_next_on_green() {
        let mut network =
            road(vec![program(0, [20.0, 14.0], 0.0), program(1, [16.0, 10.0], 30.0), program(2, [20.0, 14.0], 17.0)]);
        coordinate(&mut network);
        let cycles: Vec<usize> = network.junctions.iter().filter_map(|j| j.program.as_ref()).map(cycle_s).collect();
        assert_eq!(cycles, [44, 44, 44]);
        // 120 m at 10 m/s.
        for junction in [0, 1] {
            let gone = (0..44).filter(|&t| is_green(&network, 2 * junction, t));
            let arrives = gone.clone().filter(|&t| is_green(&network, 2 * (junction + 1), t + 12));
            assert!(arrives.count() + 1 >= gone.count().min(20), "after junction {junction}");
        }
    }

    /// Seconds a cycle at which who leaves a main road and who turns off a side street come through the next signal, which lies so
    /// many metres on.
    fn come_through(link_m: f64) -> [usize; 2] {
        let line = |from: DVec3, to: DVec3| Polyline::new([from, to]);
        let corner = DVec3::X * 20.0;
        // A quarter of a circle from the side street.
        let turn = (0..=16).map(|k| {
            let (sin, cos) = sin_cos(f64::from(k) / 16.0 * FRAC_PI_2);
            DVec3::new(20.0 - 20.0 * cos, 20.0 * sin - 20.0, 0.0)
        });
        let end = corner + DVec3::X * link_m;
        let beyond = end + DVec3::X * 20.0;
        let mut lanes = vec![
            Lane::new(LaneId(0), line(DVec3::X * -100.0, DVec3::ZERO), 3.5, 12.5),
            Lane::new(LaneId(1), line(DVec3::new(0.0, -120.0, 0.0), DVec3::new(0.0, -20.0, 0.0)), 3.5, 12.5),
            Lane::new(LaneId(2), line(DVec3::ZERO, corner), 3.5, 12.5),
            Lane::new(LaneId(3), Polyline::new(turn), 3.5, 12.5),
            Lane::new(LaneId(4), line(corner, end), 3.5, 12.5),
            Lane::new(LaneId(5), line(end, beyond), 3.5, 12.5),
            Lane::new(LaneId(6), line(beyond, beyond + DVec3::X * 100.0), 3.5, 12.5),
        ];
        for (lane, successor) in [(0, 2), (1, 3), (2, 4), (3, 4), (4, 5), (5, 6)] {
            lanes[lane].successors = vec![LaneId(successor)];
        }
        for (lane, signal) in [(0, 0), (1, 1), (4, 2)] {
            lanes[lane].end_control = TrafficControl::Signal(SignalId(signal));
        }
        let of = |id: u16, ways: &[u32]| Junction {
            lanes: ways.iter().map(|&way| LaneId(way)).collect(),
            program: Some(program(id, [30.0, 20.0], 0.0)),
            ..Junction::default()
        };
        let junctions = vec![of(0, &[2, 3]), of(1, &[5])];
        for (way, junction) in [(2, 0), (3, 0), (5, 1)] {
            lanes[way].junction = Some(JunctionId(junction));
        }
        let mut network =
            RoadNetwork { lanes, junctions, signal_groups: 4, ..RoadNetwork::default() }.finish().expect("roads");
        coordinate(&mut network);
        let travel = ((20.0 + link_m) / (PROGRESSION_SHARE * 12.5)).round() as usize;
        let through = |signal: usize, t: usize| is_green(&network, signal, t) && is_green(&network, 2, t + travel);
        [0, 1].map(|signal| (0..60).filter(|&t| through(signal, t)).count())
    }

    #[test]
    fn before_a_short_piece_nobody_is_left_without_green_beyond_it() {
        let [main, side] = come_through(200.0);
        assert!(main >= 28 && side <= 2, "{main} {side}");
        let [main, side] = come_through(15.0);
        assert!(main >= 14 && side >= 8, "{main} {side}");
    }

    #[test]
    fn cycles_that_differ_much_stay_and_changes_last_as_long_as_before() {
        let mut network = road(vec![program(0, [50.0, 40.0], 0.0), program(1, [12.0, 8.0], 0.0)]);
        let before = network.junctions[1].program.clone();
        coordinate(&mut network);
        let after = network.junctions[1].program.clone();
        assert_eq!(before.map(|p| p.phases), after.map(|p| p.phases));
        let mut network = road(vec![program(0, [30.0, 14.0], 0.0), program(1, [20.0, 10.0], 0.0)]);
        coordinate(&mut network);
        let phases = &network.junctions[1].program.as_ref().expect("a program").phases;
        let lasts: Vec<f64> = phases.iter().map(|phase| phase.duration_s).collect();
        assert_eq!([lasts[1], lasts[2], lasts[4], lasts[5]], [3.0, 2.0, 3.0, 2.0]);
        assert_eq!(lasts.iter().sum::<f64>(), 54.0);
        assert!(lasts[0] > 25.0 && lasts[3] > 12.0, "{lasts:?}");
    }
}
