//! Where the areas swept on different lanes overlap: inside junctions, before their lines, and where lanes run into one
//! another without a junction.

use endless_road::swept::{DesignVehicle, LONG_M, SWINGS_OUT_M, SweptPath};
use endless_road::{Lane, LaneConflict, LaneId, PolylinePoint, RoadNetwork, Turn, gives_way, near_ranges};
use endless_world::VehicleSpec;
use endless_world::math::f64::{cos, wrap_angle};
use std::collections::{BTreeMap, BTreeSet};

/// Distance between centre lines at which a long vehicle in a bend may touch another, metres.
const LONG_SWEPT_M: f64 = 5.0;
/// Beside the middle of their lanes drivers keep within this, metres.
const ASIDE_M: f64 = 0.15;
/// Lines before junctions are never kept from further than this, metres.
const MOST_SETBACK_M: f64 = 6.0;
/// Long vehicles touch this much before others do where lanes run together, metres.
const LONGER_M: f64 = 4.0;
/// Lanes that part have parted after this, metres: if they are near one another again, they run together.
const PART_M: f64 = 60.0;
/// Lanes with nothing but a lane shorter than this between follow one another, metres.
const SCRAP_M: f64 = 10.0;
/// Lanes with places nearer than this may run into one another, metres.
const NEAR_M: f64 = 3.0;
/// Distance between these places, and size of the cells in which they are looked up, metres.
const PLACE_M: f64 = 2.0;

/// A lane that parts from the same lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DivergingLane {
    pub(crate) lane: LaneId,
    /// Up to this `s` their swept areas overlap.
    pub(crate) until: f64,
}

/// A lane that runs into this one, or along it too near, without a junction.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MergeOverlap {
    pub(crate) lane: LaneId,
    /// Range of `s` of this lane within which bodies touch, and that of the other lane.
    pub(crate) range: (f64, f64),
    pub(crate) other_range: (f64, f64),
}

impl MergeOverlap {
    /// From `s` of the other lane to that of this one.
    pub(crate) fn here_minus_there(&self) -> f64 {
        self.range.1 - self.other_range.1
    }
}

/// The last piece of a lane before a junction, over which long vehicles sweep that turn beside it.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SweptApproach {
    pub(crate) lane: LaneId,
    /// From its end, metres.
    pub(crate) last_m: f64,
}

/// The first piece of a lane beyond a junction, over which a long vehicle sweeps that turns onto another.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SweptExit {
    pub(crate) lane: LaneId,
    /// It does so from here on along its own lane, metres: a place of its middle.
    pub(crate) from_m: f64,
    /// Up to here on the other, metres: a place of a rear bumper.
    pub(crate) to_m: f64,
}

/// What long vehicles sweep that turn on a lane.
#[derive(Debug, Clone, Default)]
pub(crate) struct SweptBeside {
    pub(crate) approaches: Vec<SweptApproach>,
    pub(crate) exits: Vec<SweptExit>,
}

/// The bodies for which room is kept.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DesignVehicles {
    small: DesignVehicle,
    /// Vans too.
    broad: DesignVehicle,
}

impl DesignVehicles {
    pub(crate) fn of(specs: &[VehicleSpec]) -> Self {
        let shorter = |than: f64| {
            let specs = specs.iter().filter(move |s| f64::from(s.length_m) < than);
            DesignVehicle::around(specs, ASIDE_M)
        };
        Self { small: shorter(SWINGS_OUT_M), broad: shorter(LONG_M) }
    }

    /// Length of the longest of them, metres.
    pub(crate) fn length_m(&self) -> f64 {
        2.0 * self.broad.half.x
    }
}

/// Conflicts inside junctions, by lane: for cars, and if one of the two is long and swings out in bends.
#[derive(Debug, Default)]
pub(crate) struct ConflictTables {
    pub(crate) small: Vec<Vec<LaneConflict>>,
    pub(crate) wide: Vec<Vec<LaneConflict>>,
    /// Distance before each lane's end at which vehicles wait, so that those who turn get past, metres.
    pub(crate) setbacks: Vec<f64>,
}

impl ConflictTables {
    pub(crate) fn of(network: &RoadNetwork, bodies: DesignVehicles) -> Self {
        let n = network.lanes.len();
        let mut all = Self { small: vec![Vec::new(); n], wide: vec![Vec::new(); n], setbacks: vec![0.0; n] };
        for junction in &network.junctions {
            let sweep = |body: DesignVehicle| -> Vec<SweptPath> {
                junction.lanes.iter().map(|&l| SweptPath::along(network, network.lane(l), body)).collect()
            };
            let (small, broad) = (sweep(bodies.small), sweep(bodies.broad));
            let known: BTreeMap<(LaneId, LaneId), LaneConflict> =
                junction.conflicts.iter().map(|c| ((c.lane, c.other), *c)).collect();
            for (i, &a) in junction.lanes.iter().enumerate() {
                for (j, &b) in junction.lanes.iter().enumerate().skip(i + 1) {
                    let (first, second) = (network.lane(a), network.lane(b));
                    if follow_or_part(first, second) {
                        continue;
                    }
                    let before = known.get(&(a, b)).map(|c| (c.range, c.other_range));
                    let waits = known.get(&(a, b)).map_or_else(|| gives_way(network, first, second), |c| c.gives_way);
                    let turns = first.turn != Turn::Straight || second.turn != Turn::Straight;
                    let near = if turns { near_ranges(first, second, LONG_SWEPT_M) } else { None };
                    let swept = join(before, small[i].conflict(&small[j]));
                    let widest = join(join(swept, near), broad[i].conflict(&broad[j]));
                    for (ranges, lists) in [(swept, &mut all.small), (widest, &mut all.wide)] {
                        let Some((range, other_range)) = ranges else { continue };
                        let there = LaneConflict { lane: a, other: b, range, other_range, gives_way: waits };
                        let back = LaneConflict {
                            lane: b,
                            other: a,
                            range: other_range,
                            other_range: range,
                            gives_way: !waits,
                        };
                        lists[a.index()].push(there);
                        lists[b.index()].push(back);
                    }
                }
            }
            for before in approaches(network, &junction.lanes) {
                let own = |l: LaneId| network.lane(before).successors.contains(&l);
                let others = junction.lanes.iter().zip(&broad).filter(|(l, _)| !own(**l));
                let needed = others.map(|(_, sweep)| setback(network, before, bodies.broad, sweep));
                all.setbacks[before.index()] = needed.filter(|&b| b <= MOST_SETBACK_M).fold(0.0, f64::max);
            }
        }
        all
    }
}

type RangePair = ((f64, f64), (f64, f64));

/// Both together.
fn join(a: Option<RangePair>, b: Option<RangePair>) -> Option<RangePair> {
    let wider = |a: (f64, f64), b: (f64, f64)| (a.0.min(b.0), a.1.max(b.1));
    match (a, b) {
        (Some(a), Some(b)) => Some((wider(a.0, b.0), wider(a.1, b.1))),
        (one, other) => one.or(other),
    }
}

/// Lanes one after the other, or that part from the same lane: those who use them already follow one another.
fn follow_or_part(a: &Lane, b: &Lane) -> bool {
    a.successors.contains(&b.id)
        || b.successors.contains(&a.id)
        || a.predecessors.iter().any(|p| b.predecessors.contains(p))
}

/// The lanes that lead into a junction.
fn approaches(network: &RoadNetwork, inside: &[LaneId]) -> BTreeSet<LaneId> {
    let before = inside.iter().flat_map(|&l| network.lane(l).predecessors.iter().copied());
    before.filter(|&l| network.lane(l).junction.is_none()).collect()
}

/// The lanes that lead out of a junction.
fn exits(network: &RoadNetwork, inside: &[LaneId]) -> BTreeSet<LaneId> {
    let after = inside.iter().flat_map(|&l| network.lane(l).successors.iter().copied());
    after.filter(|&l| network.lane(l).junction.is_none()).collect()
}

/// Where the middle of one who turns comes near whoever stands at the beginning of a lane, and how far on their rear bumper must be
/// to be out of its way, metres.
fn swept_exit(network: &RoadNetwork, beyond: LaneId, body: DesignVehicle, turning: &SweptPath) -> Option<(f64, f64)> {
    let stands = SweptPath::between(network, network.lane(beyond), body, body.half.x, body.half.x + MOST_SETBACK_M);
    turning.touch(&stands).map(|((from_m, _), (_, to_m))| (from_m, to_m - body.half.x))
}

/// How far before the end of a lane those who wait there must keep, for one who turns beside them to get past; more than
/// [`MOST_SETBACK_M`] if that is not enough.
fn setback(network: &RoadNetwork, before: LaneId, body: DesignVehicle, turning: &SweptPath) -> f64 {
    let lane = network.lane(before);
    let at_line = lane.centerline.length() - body.half.x;
    let waits = SweptPath::between(network, lane, body, (at_line - MOST_SETBACK_M - 2.0).max(0.0), at_line);
    waits.touch(turning).map_or(0.0, |(mine, _)| at_line - mine.0)
}

/// Takes the ways through junctions from a long model on which it would touch those who wait, wherever they wait, and
/// keeps its room free before the lines elsewhere: `sweeps` has it by the lane on which one turns, and what it sweeps beyond the
/// junction.
pub(crate) fn make_room(
    network: &RoadNetwork,
    bodies: DesignVehicles,
    spec: &VehicleSpec,
    allowed: &mut [bool],
    setbacks: &mut [f64],
    sweeps: &mut [SweptBeside],
) {
    let body = DesignVehicle::around(std::iter::once(spec), ASIDE_M);
    for junction in &network.junctions {
        let (before, beyond) = (approaches(network, &junction.lanes), exits(network, &junction.lanes));
        for &lane in junction.lanes.iter().filter(|l| network.lane(**l).turn != Turn::Straight) {
            if !allowed[lane.index()] {
                continue;
            }
            let sweep = SweptPath::along(network, network.lane(lane), body);
            // To the left the ground inside the bend is the junction's own.
            if network.lane(lane).turn != Turn::Left {
                let after = &network.lane(lane).successors;
                let ends = network.lane(lane).predecessors.first().into_iter().chain(after.first());
                let way: Vec<&Lane> = ends.chain([&lane]).map(|&l| network.lane(l)).collect();
                if !sweep.keeps_to(spec, &way) {
                    allowed[lane.index()] = false;
                    continue;
                }
            }
            let beside = || before.iter().filter(|b| !network.lane(**b).successors.contains(&lane));
            let needed: Vec<(LaneId, f64)> =
                beside().map(|&b| (b, setback(network, b, bodies.broad, &sweep))).collect();
            if needed.iter().any(|n| n.1 > MOST_SETBACK_M) {
                allowed[lane.index()] = false;
                continue;
            }
            for (before, needed) in needed.into_iter().filter(|(_, needed)| *needed > 0.0) {
                setbacks[before.index()] = needed.max(setbacks[before.index()]);
                let swept = &mut sweeps[lane.index()].approaches;
                match swept.iter_mut().find(|s| s.lane == before) {
                    Some(known) => known.last_m = needed.max(known.last_m),
                    None => swept.push(SweptApproach { lane: before, last_m: needed }),
                }
            }
            for &exit in beyond.iter().filter(|l| !network.lane(lane).successors.contains(l)) {
                let Some((from_m, to_m)) = swept_exit(network, exit, bodies.broad, &sweep) else { continue };
                let swept = &mut sweeps[lane.index()].exits;
                match swept.iter_mut().find(|s| s.lane == exit) {
                    Some(known) => (known.from_m, known.to_m) = (from_m.min(known.from_m), to_m.max(known.to_m)),
                    None => swept.push(SweptExit { lane: exit, from_m, to_m }),
                }
            }
        }
    }
}

/// Lanes that part from the same lane as this one, while they overlap.
pub(crate) fn siblings(network: &RoadNetwork, lane: &Lane, body: &DesignVehicles) -> Vec<DivergingLane> {
    let mut siblings = Vec::new();
    for before in &lane.predecessors {
        for &other in network.lane(*before).successors.iter().filter(|&&o| o != lane.id) {
            let them = network.lane(other);
            let known = endless_road::swept_overlap(lane, them).map(|((_, until), _)| until.min(PART_M));
            let reach = lane.centerline.length().min(them.centerline.length()).min(PART_M);
            let sweep = |l: &Lane| SweptPath::between(network, l, body.broad, 0.0, reach);
            let swept = sweep(lane).conflict(&sweep(them)).map(|((_, until), _)| until);
            if let Some(until) = known.into_iter().chain(swept).reduce(f64::max) {
                siblings.push(DivergingLane { lane: other, until: until + LONGER_M });
            }
        }
    }
    siblings
}

/// For every lane the lanes with the same direction of travel that run into it, or too near beside it, without a
/// junction that would order who goes first.
pub(crate) fn alongside(network: &RoadNetwork, bodies: DesignVehicles) -> Vec<Vec<MergeOverlap>> {
    let mut found: Vec<Vec<MergeOverlap>> = vec![Vec::new(); network.lanes.len()];
    for (a, b) in near_pairs(network) {
        let (one, other) = (network.lane(a), network.lane(b));
        let parted = one.predecessors.iter().any(|p| other.predecessors.contains(p));
        let from = if parted { PART_M } else { 0.0 };
        if one.centerline.length().min(other.centerline.length()) <= from {
            continue;
        }
        let sweep = |l: &Lane| SweptPath::between(network, l, bodies.broad, from, l.centerline.length());
        let Some((range, other_range)) = sweep(one).touch(&sweep(other)) else { continue };
        // Long vehicles swing out further.
        let early = |r: (f64, f64)| ((r.0 - LONGER_M).max(from), r.1);
        let (range, other_range) = (early(range), early(other_range));
        found[a.index()].push(MergeOverlap { lane: b, range, other_range });
        found[b.index()].push(MergeOverlap { lane: a, range: other_range, other_range: range });
    }
    found
}

/// A place on a lane.
struct LanePlace {
    lane: LaneId,
    on: PolylinePoint,
}

/// Lanes with the same direction of travel that come near one another, and that nothing else relates.
fn near_pairs(network: &RoadNetwork) -> BTreeSet<(LaneId, LaneId)> {
    let mut cells: BTreeMap<(i64, i64), Vec<LanePlace>> = BTreeMap::new();
    let mut pairs = BTreeSet::new();
    let cell = |x: f64| (x / NEAR_M).floor() as i64;
    for lane in &network.lanes {
        let length = lane.centerline.length();
        let n = (length / PLACE_M).ceil().max(1.0) as usize;
        for k in 0..=n {
            let on = lane.centerline.at(length * k as f64 / n as f64);
            let (x, y) = (cell(on.position.x), cell(on.position.y));
            for others in (x - 1..=x + 1).flat_map(|i| (y - 1..=y + 1).map(move |j| (i, j))) {
                for other in cells.get(&others).into_iter().flatten() {
                    let apart = other.on.position - on.position;
                    let near = apart.truncate().length_squared() < NEAR_M * NEAR_M
                        && apart.z.abs() < NEAR_M
                        && cos(wrap_angle(other.on.heading_rad - on.heading_rad)) > 0.7;
                    if near && other.lane != lane.id && unrelated(network, network.lane(other.lane), lane) {
                        pairs.insert((other.lane, lane.id));
                    }
                }
            }
            cells.entry((x, y)).or_default().push(LanePlace { lane: lane.id, on });
        }
    }
    pairs
}

/// Outside junctions, where nobody orders who goes first; neither neighbours nor one after the other.
fn unrelated(network: &RoadNetwork, a: &Lane, b: &Lane) -> bool {
    let outside = a.junction.is_none() && b.junction.is_none();
    let beside = [a.left, a.right].contains(&Some(b.id)) || [b.left, b.right].contains(&Some(a.id));
    let after = |a: &Lane, b: &Lane| a.successors.contains(&b.id);
    let scrap = |id: LaneId| network.lane(id).centerline.length() < SCRAP_M;
    let soon_after = |a: &Lane, b: &Lane| a.successors.iter().any(|&s| scrap(s) && b.predecessors.contains(&s));
    outside && !(beside || after(a, b) || after(b, a) || soon_after(a, b) || soon_after(b, a))
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{Junction, JunctionId, Polyline};
    use endless_world::math::f64::sin_cos;
    use glam::DVec3;
    use std::f64::consts::FRAC_PI_2;

    /// Two lanes (0, 1) that turn left side by side (2, 3), and on (4, 5): the one on the inside first.
    fn double_left_turn() -> RoadNetwork {
        const TIGHT_M: f64 = 12.0;
        let radius_m = [TIGHT_M, TIGHT_M + 3.5];
        let straight = |from: [f64; 2], to: [f64; 2]| [from, to].map(|[x, y]| DVec3::new(x, y, 0.0)).to_vec();
        let arc = |radius: f64| {
            let at = |k: u32| {
                let (sin, cos) = sin_cos(FRAC_PI_2 * f64::from(k) / 12.0);
                DVec3::new(radius * cos - TIGHT_M, radius * sin, 0.0)
            };
            (0..=12).map(at).collect::<Vec<_>>()
        };
        let before = radius_m.map(|radius| straight([radius - TIGHT_M, -40.0], [radius - TIGHT_M, 0.0]));
        let after = radius_m.map(|radius| straight([-TIGHT_M, radius], [-TIGHT_M - 40.0, radius]));
        let lines = before.into_iter().chain(radius_m.map(arc)).chain(after);
        let mut lanes: Vec<Lane> =
            (0..).zip(lines).map(|(id, line)| Lane::new(LaneId(id), Polyline::new(line), 3.5, 13.9)).collect();
        for k in 0..4 {
            lanes[k].successors = vec![LaneId(k as u32 + 2)];
        }
        for turn in [2, 3] {
            (lanes[turn].junction, lanes[turn].turn) = (Some(JunctionId(0)), Turn::Left);
        }
        let junctions = vec![Junction { lanes: vec![LaneId(2), LaneId(3)], ..Junction::default() }];
        RoadNetwork { lanes, junctions, ..RoadNetwork::default() }.finish().expect("two turns")
    }

    #[test]
    fn a_bus_that_turns_sweeps_over_who_stands_where_the_lane_beside_goes_on() {
        let bus = VehicleSpec {
            length_m: 12.0,
            width_m: 2.5,
            front_axle_m: 3.3,
            rear_axle_m: -2.6,
            ..VehicleSpec::default()
        };
        let network = double_left_turn();
        let bodies = DesignVehicles::of(&[VehicleSpec::default()]);
        let exits = |spec: &VehicleSpec| {
            let n = network.lanes.len();
            let (mut allowed, mut setbacks, mut sweeps) =
                (vec![true; n], vec![0.0; n], vec![SweptBeside::default(); n]);
            make_room(&network, bodies, spec, &mut allowed, &mut setbacks, &mut sweeps);
            sweeps.swap_remove(2).exits
        };
        let length_m = network.lanes[2].centerline.length();
        let [swept] = exits(&bus)[..] else { panic!("{:?}", exits(&bus)) };
        assert_eq!(swept.lane, LaneId(5));
        assert!((0.5 * length_m..length_m).contains(&swept.from_m), "{swept:?}, {length_m} m");
        assert!((0.0..MOST_SETBACK_M).contains(&swept.to_m), "{swept:?}");
        assert!(exits(&VehicleSpec::default()).is_empty());
    }
}
