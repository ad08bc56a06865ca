//! Conflicts inside junctions: which paths overlap, and which has priority.

use crate::{Junction, Lane, LaneConflict, LaneId, RoadNetwork, TrafficControl, Turn};
use endless_world::math::f64::wrap_angle;
use glam::{DVec2, DVec3};

/// Width of the swept area of a lane, metres: that of a lorry with its mirrors.
const SWEPT_M: f64 = 2.9;
/// Distance between samples of a centre line, metres.
const STEP_M: f64 = 0.5;
/// Places that are looked at together.
const CHUNK: usize = 16;

pub(crate) fn derive(network: &mut RoadNetwork) {
    for place in 0..network.junctions.len() {
        network.junctions[place].conflicts = conflicts_of(network, &network.junctions[place]);
    }
}

fn conflicts_of(network: &RoadNetwork, junction: &Junction) -> Vec<LaneConflict> {
    let sampled: Vec<SampledLane> = junction.lanes.iter().map(|&lane| SampledLane::new(network.lane(lane))).collect();
    let mut conflicts = Vec::new();
    for (i, &first) in junction.lanes.iter().enumerate() {
        for (j, &second) in junction.lanes.iter().enumerate().skip(i + 1) {
            let (a, b) = (network.lane(first), network.lane(second));
            if follow_or_diverge(a, b) {
                continue;
            }
            let Some((range, other_range)) = sampled[i].near(&sampled[j], swept_m(a, b)) else { continue };
            let first_waits = gives_way(network, a, b);
            conflicts.push(LaneConflict { lane: a.id, other: b.id, range, other_range, gives_way: first_waits });
            conflicts.push(LaneConflict {
                lane: b.id,
                other: a.id,
                range: other_range,
                other_range: range,
                gives_way: !first_waits,
            });
        }
    }
    conflicts
}

/// Lanes one after the other, or that part from the same lane: those who use them already follow one another.
fn follow_or_diverge(a: &Lane, b: &Lane) -> bool {
    a.successors.contains(&b.id)
        || b.successors.contains(&a.id)
        || a.predecessors.iter().any(|p| b.predecessors.contains(p))
}

/// The ranges of `s` on two lanes within which their swept areas overlap; `None` if they do not.
pub fn swept_overlap(a: &Lane, b: &Lane) -> Option<((f64, f64), (f64, f64))> {
    near_ranges(a, b, swept_m(a, b))
}

/// The ranges of `s` on two lanes within which their centre lines are nearer than `clearance` metres.
pub fn near_ranges(a: &Lane, b: &Lane, clearance: f64) -> Option<((f64, f64), (f64, f64))> {
    SampledLane::new(a).near(&SampledLane::new(b), clearance)
}

/// Centre lines nearer than this have swept areas that overlap, metres.
fn swept_m(a: &Lane, b: &Lane) -> f64 {
    SWEPT_M.min(0.45 * (a.width_m + b.width_m))
}

/// The box around places.
fn around(places: &[(f64, DVec3)]) -> [DVec2; 2] {
    let flat = || places.iter().map(|(_, p)| p.truncate());
    [flat().fold(DVec2::INFINITY, DVec2::min), flat().fold(DVec2::NEG_INFINITY, DVec2::max)]
}

/// A lane's centre line at close places, and the box around it.
struct SampledLane {
    places: Vec<(f64, DVec3)>,
    /// Around every [`CHUNK`] places.
    boxes: Vec<[DVec2; 2]>,
    low: DVec2,
    high: DVec2,
}

impl SampledLane {
    fn new(lane: &Lane) -> Self {
        let length = lane.centerline.length();
        let n = (length / STEP_M).ceil().max(1.0) as usize;
        let at = |i: usize| length * i as f64 / n as f64;
        let places: Vec<(f64, DVec3)> = (0..=n).map(|i| (at(i), lane.centerline.position(at(i)))).collect();
        let boxes: Vec<[DVec2; 2]> = places.chunks(CHUNK).map(around).collect();
        let low = boxes.iter().map(|b| b[0]).fold(DVec2::INFINITY, DVec2::min);
        let high = boxes.iter().map(|b| b[1]).fold(DVec2::NEG_INFINITY, DVec2::max);
        Self { places, boxes, low, high }
    }

    /// The ranges of `s` on both within which they are nearer than `clearance`.
    fn near(&self, other: &Self, clearance: f64) -> Option<((f64, f64), (f64, f64))> {
        if (self.low - clearance).cmpgt(other.high).any() || (other.low - clearance).cmpgt(self.high).any() {
            return None;
        }
        let range_of = |of: &Self, others: &Self| {
            let (low, high) = (others.low - clearance, others.high + clearance);
            let mut range: Option<(f64, f64)> = None;
            for &(s, p) in &of.places {
                let flat = p.truncate();
                if flat.cmplt(low).any() || flat.cmpgt(high).any() {
                    continue;
                }
                let close = |&(_, q): &(f64, DVec3)| {
                    (p - q).truncate().length_squared() < clearance * clearance && (p.z - q.z).abs() < SWEPT_M
                };
                let mut chunks = others.places.chunks(CHUNK).zip(&others.boxes);
                let touches = chunks.any(|(places, [low, high])| {
                    !(flat.cmplt(*low - clearance).any() || flat.cmpgt(*high + clearance).any())
                        && places.iter().any(close)
                });
                if touches {
                    range = Some(range.map_or((s, s), |(low, _)| (low, s)));
                }
            }
            range
        };
        Some((range_of(self, other)?, range_of(other, self)?))
    }
}

/// Whether traffic on `a` lets traffic on `b` go first. Exactly one of `gives_way(a, b)` and `gives_way(b, a)` holds.
pub fn gives_way(network: &RoadNetwork, a: &Lane, b: &Lane) -> bool {
    // Signs first: free and signalled approaches before give-way signs before stop signs.
    let (rank_a, rank_b) = (approach_rank(network, a), approach_rank(network, b));
    if rank_a != rank_b {
        return rank_a > rank_b;
    }
    // Who turns back waits for everybody; who turns left waits for those who come towards them.
    let angle = wrap_angle(b.centerline.at(0.0).heading_rad - a.centerline.at(0.0).heading_rad).to_degrees();
    let oncoming = angle.abs() > 135.0;
    let back = |lane: &Lane| lane.turn == Turn::UTurn;
    if back(a) != back(b) {
        return back(a);
    }
    let yields_to_oncoming = |lane: &Lane| matches!(lane.turn, Turn::Left | Turn::UTurn);
    if oncoming && yields_to_oncoming(a) != yields_to_oncoming(b) {
        return yields_to_oncoming(a);
    }
    // Priority to the right: who heads to my left comes from my right.
    if !oncoming && angle.abs() > 30.0 {
        return angle > 0.0;
    }
    a.id > b.id
}

fn approach_rank(network: &RoadNetwork, connector: &Lane) -> u8 {
    let control = |id: &LaneId| network.lane(*id).end_control;
    match connector.predecessors.first().map(control) {
        None | Some(TrafficControl::Free | TrafficControl::Signal(_)) => 0,
        Some(TrafficControl::Yield) => 1,
        Some(TrafficControl::Stop) => 2,
    }
}
