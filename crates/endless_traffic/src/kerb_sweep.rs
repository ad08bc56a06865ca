//! Turns in which a vehicle would sweep over a sidewalk.
//!
//! Beyond a tight turn onto a narrow street the front corner reaches further out than the lane, over the kerb, where people walk, and
//! the rear wheels cut the corner, so that the side reaches over the kerb within the turn: designers of junctions draw the swept path
//! of a design vehicle for that (AASHTO 2018, "A Policy on Geometric Design of Highways and Streets", chapter 2). Here each model is
//! driven through the turn once, and stays away from it where it would touch somebody.

use endless_road::swept::{DRAWBAR, SWINGS_OUT_M, towed_heading};
use endless_road::{Lane, RoadNetwork, WalkEdge, WalkKind};
use endless_world::VehicleSpec;
use endless_world::math::f64::{atan2, sin_cos};
use endless_world::math::segment::share_along;
use glam::DVec2;

/// Bends of a larger radius are no turns, metres.
const TURN_RADIUS_M: f64 = 16.0;
/// The road beyond a turn is looked along so far, metres, in steps of so much.
const BEYOND_M: f64 = 8.0;
const STEP_M: f64 = 0.5;
/// Sidewalks further from the middle of the lane are out of reach, metres.
const REACH_M: f64 = 4.0;
/// Drivers keep within this beside the middle of their lane, and people within as much of their sidewalk's edge, metres.
const BESIDE_M: f64 = 0.1;
/// The sides of a body are looked at where they begin and end, and between so many pieces of them.
const SIDE_PIECES: u32 = 4;

/// A sidewalk: its axis, and half its width, metres.
#[derive(Clone)]
struct Strip {
    ends: [DVec2; 2],
    half_width_m: f64,
}

impl Strip {
    /// How far a place is from it, metres; negative on it.
    fn away_m(&self, at: DVec2) -> f64 {
        let [a, b] = self.ends;
        let along = share_along(at, a, b);
        at.distance(a.lerp(b, along)) - self.half_width_m
    }

    /// Whether it may be within reach of a box: boxes tell it of most, at once.
    fn may_reach(&self, low: DVec2, high: DVec2) -> bool {
        let ([a, b], reach_m) = (self.ends, REACH_M + self.half_width_m);
        a.min(b).cmple(high + reach_m).all() && a.max(b).cmpge(low - reach_m).all()
    }
}

/// The turns of a network that have sidewalks near by.
pub(crate) struct KerbSweeps {
    turns: Vec<Turning>,
}

/// The way through a turn, and the sidewalks beside it.
struct Turning {
    lane: usize,
    way: Vec<DVec2>,
    strips: Vec<Strip>,
    /// Room beside the way, metres.
    room_m: f64,
}

impl KerbSweeps {
    /// Of a network whose lanes have bends of these radii, metres.
    pub(crate) fn new(network: &RoadNetwork, radii_m: impl Iterator<Item = f64>) -> Self {
        let lanes = network.lanes.iter().zip(radii_m);
        let turns = lanes.filter(|(lane, radius_m)| lane.junction.is_some() && *radius_m < TURN_RADIUS_M);
        let strips = sidewalks(network);
        Self { turns: turns.filter_map(|(lane, _)| Turning::of(network, &strips, lane)).collect() }
    }

    /// Forbids a model the turns in which it would sweep over a sidewalk.
    pub(crate) fn forbid(&self, spec: &VehicleSpec, stays: &mut [bool]) {
        if f64::from(spec.length_m) < SWINGS_OUT_M {
            return;
        }
        for turn in &self.turns {
            stays[turn.lane] = stays[turn.lane] && !turn.is_swept_by(spec);
        }
    }
}

impl Turning {
    fn of(network: &RoadNetwork, sidewalks: &[Strip], lane: &Lane) -> Option<Self> {
        let way = way(network, lane);
        let (low, high) = way.iter().fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(*p), h.max(*p)));
        let near = |strip: &&Strip| strip.may_reach(low, high) && way.iter().any(|&at| strip.away_m(at) < REACH_M);
        let strips: Vec<Strip> = sidewalks.iter().filter(near).cloned().collect();
        let rooms = way.iter().flat_map(|&at| strips.iter().map(move |strip| strip.away_m(at)));
        let room_m = rooms.fold(f64::INFINITY, f64::min);
        room_m.is_finite().then_some(Self { lane: lane.id.index(), way, strips, room_m })
    }

    /// Whether the body of a model comes over a sidewalk. Where even who drives straight would, there is no kerb.
    fn is_swept_by(&self, spec: &VehicleSpec) -> bool {
        let half_width_m = 0.5 * f64::from(spec.width_m);
        if self.room_m < half_width_m + BESIDE_M {
            return false;
        }
        let [front_axle_m, rear_axle_m] = [spec.front_axle_m, spec.rear_axle_m].map(f64::from);
        let drawbar_m = DRAWBAR * (front_axle_m - rear_axle_m);
        let front_m = 0.5 * f64::from(spec.length_m) - rear_axle_m - drawbar_m;
        let mut yaw = heading(self.way[1] - self.way[0]);
        self.way.windows(2).any(|step| {
            yaw = towed_heading(yaw, heading(step[1] - step[0]), step[0].distance(step[1]), drawbar_m);
            let (sin, cos) = sin_cos(yaw);
            let ahead = DVec2::new(cos, sin);
            let sides = (0..=SIDE_PIECES).flat_map(|k| {
                let along_m = front_m - f64::from(spec.length_m) * f64::from(k) / f64::from(SIDE_PIECES);
                [-half_width_m, half_width_m].map(|left_m| step[1] + ahead * along_m + ahead.perp() * left_m)
            });
            sides.into_iter().any(|place| self.strips.iter().any(|strip| strip.away_m(place) < BESIDE_M))
        })
    }
}

fn sidewalks(network: &RoadNetwork) -> Vec<Strip> {
    let walk = &network.walk;
    let edges = walk.edges.iter().filter(|edge| edge.kind == WalkKind::Sidewalk);
    let strip = |edge: &WalkEdge| Strip {
        ends: edge.nodes.map(|node| walk.nodes[node.index()].truncate()),
        half_width_m: 0.5 * edge.width_m,
    };
    edges.map(strip).collect()
}

fn heading(way: DVec2) -> f64 {
    atan2(way.y, way.x)
}

/// The middle of a lane and of the road beyond it.
fn way(network: &RoadNetwork, lane: &Lane) -> Vec<DVec2> {
    let beyond = lane.successors.first().map(|&next| &network.lane(next).centerline);
    let on = |line: &endless_road::Polyline, most_m: f64| {
        let length_m = line.length().min(most_m);
        let steps = (length_m / STEP_M).ceil().max(1.0) as u32;
        let place = |k: u32| line.position(length_m * f64::from(k) / f64::from(steps)).truncate();
        (0..=steps).map(place).collect::<Vec<DVec2>>()
    };
    let mut way = on(&lane.centerline, f64::INFINITY);
    way.extend(beyond.into_iter().flat_map(|line| on(line, BEYOND_M)));
    way.dedup_by(|a, b| a.distance(*b) < 1e-3);
    way
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{Junction, JunctionId, LaneId, Polyline, WalkNodeId};
    use endless_world::ObjectClass;
    use glam::DVec3;

    /// A turn to the right of this radius onto a street with a sidewalk on its left, so far from the middle of the lane; on its right
    /// where that is negative.
    fn corner(radius_m: f64, away_m: f64) -> RoadNetwork {
        let arc = (0..=18).map(|k| {
            let (sin, cos) = sin_cos((5.0 * f64::from(k)).to_radians());
            DVec3::new(radius_m * sin, radius_m * (cos - 1.0), 0.0)
        });
        let bend = Polyline::new(std::iter::once(DVec3::new(-10.0, 0.0, 0.0)).chain(arc));
        let beyond = Polyline::new([0.0, -40.0].map(|y| DVec3::new(radius_m, y - radius_m, 0.0)));
        let mut turn = Lane::new(LaneId(0), bend, 3.1, 13.9);
        (turn.junction, turn.successors) = (Some(JunctionId(0)), vec![LaneId(1)]);
        let lanes = vec![turn, Lane::new(LaneId(1), beyond, 3.1, 13.9)];
        let junctions = vec![Junction { lanes: vec![LaneId(0)], ..Junction::default() }];
        let mut network = RoadNetwork { lanes, junctions, ..RoadNetwork::default() };
        network.walk.nodes = [-radius_m, -40.0].map(|y| DVec3::new(radius_m + away_m, y, 0.0)).to_vec();
        let nodes = [WalkNodeId(0), WalkNodeId(1)];
        network.walk.edges = vec![WalkEdge { nodes, width_m: 1.15, kind: WalkKind::Sidewalk }];
        network
    }

    fn model(length_m: f32, width_m: f32) -> VehicleSpec {
        let (front_axle_m, rear_axle_m) = (0.3 * length_m, -0.3 * length_m);
        VehicleSpec {
            class: ObjectClass::Truck,
            length_m,
            width_m,
            front_axle_m,
            rear_axle_m,
            ..VehicleSpec::default()
        }
    }

    #[test]
    fn who_would_sweep_over_the_sidewalk_beyond_a_tight_turn_stays_away_from_it() {
        let drives = |radius_m: f64, away_m: f64, spec: &VehicleSpec| {
            let network = corner(radius_m, away_m);
            let mut stays = [true; 2];
            KerbSweeps::new(&network, [radius_m, 1e6].into_iter()).forbid(spec, &mut stays);
            assert!(stays[1]);
            stays[0]
        };
        let lorry = model(5.9, 2.47);
        assert!(!drives(7.5, 2.2, &lorry));
        assert!(drives(7.5, 3.2, &lorry), "there is room");
        assert!(drives(20.0, 2.2, &lorry), "the turn is wide");
        assert!(drives(7.5, 2.2, &model(4.5, 1.8)), "short ones turn anywhere");
        assert!(!drives(7.5, -2.2, &lorry), "its side reaches over the kerb within the turn");
        assert!(drives(7.5, -3.2, &lorry), "there is room within it, too");
        assert!(drives(7.5, 1.5, &lorry), "there is no kerb where everybody would be on it");
    }
}
