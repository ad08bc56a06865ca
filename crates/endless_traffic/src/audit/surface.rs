//! Vehicles on their lanes, people on sidewalks and crossings.

use super::bench::Benches;
use super::bus_door::is_before_door;
use super::cell_grid::CellGrid;
use super::check::AuditCheck;
use super::finding::{Share, Worst};
use super::parking::ParkedBodies;
use super::report::AuditLine;
use super::sight::{Glance, Sight, entry};
use endless_road::{Lane, LaneId, RoadNetwork};
use endless_world::math::segment::share_along;
use endless_world::{VehicleLights, VehicleMotion, VehicleSpec};
use glam::DVec2;

/// In a junction there is road beside lanes, too, at least so much, metres.
const IN_JUNCTION_M: f64 = 0.5;
/// People who are further beside their strip are off it, metres.
const BESIDE_M: f64 = 0.1;
/// Strips this near are looked at, metres.
const NEAR_M: f64 = 1.0;
/// Who is further beside the middle of their lane is aside, metres.
const ASIDE_M: f64 = 0.5;
/// Slower than this a vehicle stands, m/s; hazard lights flash at least so often, seconds.
const STANDS_MPS: f64 = 0.05;
const FLASHES_S: f64 = 1.0;

/// Measures where road users are.
#[derive(Debug)]
pub(super) struct Surfaces {
    strips: Vec<Strip>,
    strip_grid: CellGrid,
    off_lane: Worst,
    off_sidewalk: Worst,
    off_sidewalk_share: Share,
    lane_error: Worst,
    lane_error_share: Share,
    two_wheelers_out: Worst,
    /// When the hazard lights of each vehicle were last seen, by id, seconds.
    hazards_s: Vec<Option<f64>>,
}

/// A sidewalk or a crossing.
#[derive(Debug, Clone, Copy)]
struct Strip {
    ends: [DVec2; 2],
    half_width_m: f64,
}

impl Strip {
    fn bounds(&self) -> [DVec2; 2] {
        let [a, b] = self.ends;
        [a.min(b) - DVec2::splat(self.half_width_m), a.max(b) + DVec2::splat(self.half_width_m)]
    }

    /// How far outside a place is, metres. Its ends are round.
    fn outside_m(&self, at: DVec2) -> f64 {
        let [a, b] = self.ends;
        let along = b - a;
        (at.distance(a + along * share_along(at, a, b)) - self.half_width_m).max(0.0)
    }
}

impl Surfaces {
    pub(super) fn new(network: &RoadNetwork) -> Self {
        let node = |node: endless_road::WalkNodeId| network.walk.nodes[node.index()].truncate();
        let strip =
            |edge: &endless_road::WalkEdge| Strip { ends: edge.nodes.map(node), half_width_m: 0.5 * edge.width_m };
        let strips: Vec<Strip> = network.walk.edges.iter().map(strip).collect();
        let mut strip_grid = CellGrid::default();
        strip_grid.rebuild(strips.iter().map(Strip::bounds));
        Self {
            strips,
            strip_grid,
            off_lane: Worst::default(),
            off_sidewalk: Worst::default(),
            off_sidewalk_share: Share::default(),
            lane_error: Worst::default(),
            lane_error_share: Share::default(),
            two_wheelers_out: Worst::default(),
            hazards_s: Vec::new(),
        }
    }

    pub(super) fn look(&mut self, sight: &Sight<'_>, benches: &Benches, parking: &ParkedBodies) {
        for glance in &sight.glances {
            match glance.driven {
                Some((motion, spec)) => self.driving(sight, parking, glance, (motion, spec)),
                None => self.walking(sight, benches, glance),
            }
        }
    }

    fn walking(&mut self, sight: &Sight<'_>, benches: &Benches, glance: &Glance<'_>) {
        // Who crosses a road away from crossings is off them on purpose.
        if glance.actor.behaviour.jaywalking {
            return;
        }
        let around = [glance.at - DVec2::splat(NEAR_M), glance.at + DVec2::splat(NEAR_M)];
        let mut outside_m = f64::INFINITY;
        for strip in self.strip_grid.near(around) {
            outside_m = outside_m.min(self.strips[strip].outside_m(glance.at));
            if outside_m <= 0.0 {
                break;
            }
        }
        if outside_m > NEAR_M {
            outside_m = self.strips.iter().map(|strip| strip.outside_m(glance.at)).fold(outside_m, f64::min);
        }
        // So is who gets on or off a bus, and who sits down or gets up.
        if outside_m > 0.0 && (is_before_door(sight, glance.at) || benches.is_before_seat(glance.at)) {
            return;
        }
        self.off_sidewalk.note(outside_m, || glance.told(sight));
        self.off_sidewalk_share.note(outside_m > BESIDE_M);
    }

    fn driving(
        &mut self,
        sight: &Sight<'_>,
        parking: &ParkedBodies,
        glance: &Glance<'_>,
        (motion, spec): (VehicleMotion, &VehicleSpec),
    ) {
        let warns = self.warns(sight, glance, motion);
        let behaviour = glance.actor.behaviour;
        let parks = behaviour.parking.is_some();
        let (Some((lane, s)), None) = (glance.lane(sight.network), behaviour.lane_left) else { return };
        let [front_m, rear_m] = [spec.front_axle_m, spec.rear_axle_m].map(f64::from);
        let aside = |along_m: f64| aside(sight.network, lane, s + along_m, glance.at + glance.ahead * along_m);
        let middle = aside(0.5 * (front_m + rear_m));
        let width_m = f64::from(spec.width_m);
        if spec.class.two_wheeled() {
            // Between two lanes of one direction they pass queues: the body may be over the line, but no further.
            let room_m = if middle.beside_lane { width_m } else { 0.0 };
            self.two_wheelers_out.note(middle.off_m + 0.5 * width_m - room_m, || glance.told(sight));
        } else if !parks {
            self.lane_error.note(middle.error_m, || glance.told(sight));
            self.lane_error_share.note(middle.error_m > ASIDE_M && !warns);
        }
        for along_m in [front_m, rear_m] {
            let axle = aside(along_m);
            // Who parks leaves the lane for a bay.
            if parks && axle.off_m > 0.0 && parking.hold(glance.at + glance.ahead * along_m) {
                continue;
            }
            let room_m = if spec.class.two_wheeled() && axle.beside_lane { 0.5 * width_m } else { 0.0 };
            self.off_lane.note(axle.off_m - room_m, || glance.told(sight));
        }
    }

    /// Whether somebody stands with hazard lights on: they are where they are on purpose.
    fn warns(&mut self, sight: &Sight<'_>, glance: &Glance<'_>, motion: VehicleMotion) -> bool {
        let seen_s = entry(&mut self.hazards_s, glance.place());
        if motion.lights.contains(VehicleLights::LEFT_BLINKER | VehicleLights::RIGHT_BLINKER) {
            *seen_s = Some(sight.state.time_s);
        }
        f64::from(motion.speed_mps) < STANDS_MPS && seen_s.is_some_and(|seen_s| sight.state.time_s - seen_s < FLASHES_S)
    }

    pub(super) fn lines(&self) -> Vec<AuditLine> {
        vec![
            self.off_lane.line(AuditCheck::OffLane),
            self.off_sidewalk.line(AuditCheck::OffSidewalk),
            self.off_sidewalk_share.line(AuditCheck::OffSidewalkShare),
            self.lane_error.line(AuditCheck::LaneError),
            self.lane_error_share.line(AuditCheck::LaneErrorShare),
            self.two_wheelers_out.line(AuditCheck::TwoWheelersOut),
        ]
    }
}

/// Where a place is across a lane.
#[derive(Clone, Copy)]
struct Aside {
    /// Beside the lane's middle, metres.
    error_m: f64,
    /// Beyond its edge, metres; negative inside.
    off_m: f64,
    /// Whether a lane of the same direction lies on that side.
    beside_lane: bool,
}

impl Aside {
    /// Across two lanes that overlap: whoever is inside of one of them is not outside.
    fn or(self, other: Self) -> Self {
        let inner = if self.off_m <= other.off_m { self } else { other };
        Self { error_m: self.error_m.min(other.error_m), ..inner }
    }
}

/// A place near `s` of a lane, across it, or across those before or after it.
fn aside(network: &RoadNetwork, lane: &Lane, s: f64, at: DVec2) -> Aside {
    let across = |lane: &Lane, s: f64| {
        let line = &lane.centerline;
        let left_m = (at - line.position(s).truncate()).dot(line.direction(s).perp());
        let side = |lane: &Lane| if left_m > 0.0 { lane.left } else { lane.right }.is_some();
        let beside_lane = if lane.junction.is_some() {
            lane.predecessors.iter().any(|&before| side(network.lane(before)))
        } else {
            side(lane)
        };
        let room_m = if lane.junction.is_some() { IN_JUNCTION_M } else { 0.0 };
        Aside { error_m: left_m.abs(), off_m: left_m.abs() - 0.5 * lane.width_m - room_m, beside_lane }
    };
    let length_m = lane.centerline.length();
    let any_of = |lanes: &[LaneId], s: &dyn Fn(&Lane) -> f64| {
        lanes.iter().map(|&id| network.lane(id)).map(|lane| across(lane, s(lane))).reduce(Aside::or)
    };
    let beyond = if s < 0.0 {
        any_of(&lane.predecessors, &|before| before.centerline.length() + s)
    } else if s > length_m {
        any_of(&lane.successors, &|_| s - length_m)
    } else {
        None
    };
    beyond.unwrap_or_else(|| across(lane, s))
}
