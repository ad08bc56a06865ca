//! How bodies move: without jumps and jerks, wheels forward, and nobody vanishes.

use super::bus_door::is_behind_door;
use super::check::AuditCheck;
use super::finding::{Incidents, Share, Worst};
use super::report::AuditLine;
use super::sight::{Glance, Past, Sight, entry};
use endless_road::RoadNetwork;
use endless_world::math::f64::wrap_angle;
use endless_world::{Actor, Motion, VehicleMotion, VehicleSpec};
use glam::DVec2;

/// Nobody on foot is faster, m/s.
const FASTEST_ON_FOOT_MPS: f64 = 4.5;
/// A body that turns may be faster than its wheels by this factor, and by this speed, m/s.
const TURNING_FACTOR: f64 = 1.2;
const TURNING_MPS: f64 = 1.0;
/// A rear axle that goes backwards slower than this stands, m/s.
const STANDS_MPS: f64 = 0.05;
/// Accelerations and jerks that are hard, m/s² and m/s³.
const HARD_MPS2: f64 = 8.0;
const HARD_MPS3: f64 = 30.0;
/// Who comes or goes does so within this of an end of the roads, or of the ways on foot, metres.
const ROAD_END_M: f64 = 25.0;
const WAY_END_M: f64 = 5.0;

/// Measures motion.
#[derive(Debug)]
pub(super) struct Motions {
    /// Where roads end without another lane, or begin without one, and where ways on foot end.
    road_ends: Vec<DVec2>,
    way_ends: Vec<DVec2>,
    /// Acceleration of each vehicle in the frame before, by id, m/s².
    accelerations: Vec<Option<f64>>,
    driven_m: f64,
    walked_m: f64,
    jumps: Incidents,
    vanishings: Incidents,
    acceleration: Worst,
    hard_acceleration: Share,
    jerk: Worst,
    hard_jerk: Share,
    slip: Worst,
    yaw_rate: Worst,
}

impl Motions {
    pub(super) fn new(network: &RoadNetwork) -> Self {
        let mut ways = vec![0u32; network.walk.nodes.len()];
        network.walk.edges.iter().flat_map(|edge| edge.nodes).for_each(|node| ways[node.index()] += 1);
        let ends = network.walk.nodes.iter().zip(&ways).filter(|(_, ways)| **ways < 2);
        Self {
            road_ends: road_ends(network),
            way_ends: ends.map(|(node, _)| node.truncate()).collect(),
            accelerations: Vec::new(),
            driven_m: 0.0,
            walked_m: 0.0,
            jumps: Incidents::default(),
            vanishings: Incidents::default(),
            acceleration: Worst::default(),
            hard_acceleration: Share::default(),
            jerk: Worst::default(),
            hard_jerk: Share::default(),
            slip: Worst::default(),
            yaw_rate: Worst::default(),
        }
    }

    pub(super) fn driven_m(&self) -> f64 {
        self.driven_m
    }

    pub(super) fn walked_m(&self) -> f64 {
        self.walked_m
    }

    pub(super) fn look(&mut self, sight: &Sight<'_>) {
        for gone in &sight.vanished {
            *entry(&mut self.accelerations, usize::from(gone.id.0)) = None;
            if !self.at_an_end(gone) && !at_a_door(sight, gone) {
                self.vanishings.add(|| format!("{} is gone", Glance::new(gone, None, sight.specs).told(sight)));
            }
        }
        for glance in &sight.glances {
            match (glance.before, glance.driven) {
                (Some(before), Some((motion, spec))) => self.driving(sight, glance, &before, motion, spec),
                (Some(_), None) => self.walking(sight, glance),
                (None, _) if !sight.first && !self.at_an_end(glance.actor) && !at_a_door(sight, glance.actor) => {
                    self.vanishings.add(|| format!("{} appears", glance.told(sight)));
                }
                (None, _) => {}
            }
        }
    }

    fn at_an_end(&self, actor: &Actor) -> bool {
        let drives = matches!(actor.motion, Motion::Vehicle(_));
        let (ends, reach_m) = if drives { (&self.road_ends, ROAD_END_M) } else { (&self.way_ends, WAY_END_M) };
        let at = actor.pose.position.as_dvec3().truncate();
        ends.iter().any(|end| end.distance(at) < reach_m)
    }

    fn walking(&mut self, sight: &Sight<'_>, glance: &Glance<'_>) {
        let moved_m = glance.moved_m().unwrap_or_default();
        self.walked_m += moved_m;
        let speed_mps = moved_m / sight.frame_s;
        if speed_mps > FASTEST_ON_FOOT_MPS {
            self.jumps.add(|| format!("{}, {speed_mps:.1} m/s on foot", glance.told(sight)));
        }
    }

    fn driving(
        &mut self,
        sight: &Sight<'_>,
        glance: &Glance<'_>,
        before: &Past,
        motion: VehicleMotion,
        spec: &VehicleSpec,
    ) {
        let moved_m = glance.moved_m().unwrap_or_default();
        self.driven_m += moved_m;
        let speed_mps = moved_m / sight.frame_s;
        let turned = wrap_angle(f64::from(glance.actor.pose.yaw_rad - before.actor.pose.yaw_rad));
        let rear_m = f64::from(spec.rear_axle_m);
        let from = before.actor.pose.position.as_dvec3().truncate() + before.ahead * rear_m;
        let way = (glance.at + glance.ahead * rear_m - from) / sight.frame_s;
        let ahead = (before.ahead + glance.ahead).normalize_or(glance.ahead);
        let (forward, sideways) = (way.dot(ahead), way.dot(ahead.perp()));
        let fastest = f64::from(motion.speed_mps) * TURNING_FACTOR + TURNING_MPS;
        if speed_mps > fastest || forward < -STANDS_MPS {
            self.jumps.add(|| format!("{}, {speed_mps:.1} m/s at {:.1} m/s", glance.told(sight), motion.speed_mps));
        }
        self.slip.note(sideways.abs(), || glance.told(sight));
        self.yaw_rate.note(turned.abs() / sight.frame_s, || glance.told(sight));
        let Motion::Vehicle(earlier) = before.actor.motion else { return };
        let acceleration = f64::from(motion.speed_mps - earlier.speed_mps) / sight.frame_s;
        self.acceleration.note(acceleration.abs(), || glance.told(sight));
        self.hard_acceleration.note(acceleration.abs() > HARD_MPS2);
        let last = entry(&mut self.accelerations, glance.place()).replace(acceleration);
        if let Some(last) = last {
            let jerk = (acceleration - last) / sight.frame_s;
            self.jerk.note(jerk.abs(), || {
                format!(
                    "{}, from {last:.2} to {acceleration:.2} m/s² at {:.2} m/s",
                    glance.told(sight),
                    motion.speed_mps
                )
            });
            self.hard_jerk.note(jerk.abs() > HARD_MPS3);
        }
    }

    pub(super) fn lines(&self) -> Vec<AuditLine> {
        vec![
            self.jumps.line(AuditCheck::Jumps),
            self.vanishings.line(AuditCheck::Vanishings),
            self.acceleration.line(AuditCheck::Acceleration),
            self.hard_acceleration.line(AuditCheck::HardAcceleration),
            self.jerk.line(AuditCheck::Jerk),
            self.hard_jerk.line(AuditCheck::HardJerk),
            self.slip.line(AuditCheck::Slip),
            self.yaw_rate.line(AuditCheck::YawRate),
        ]
    }
}

/// Whether somebody on foot is right behind the door of a bus that stands.
fn at_a_door(sight: &Sight<'_>, actor: &Actor) -> bool {
    let at = actor.pose.position.as_dvec3().truncate();
    matches!(actor.motion, Motion::Walker(_)) && sight.glances.iter().any(|bus| is_behind_door(bus, at))
}

fn road_ends(network: &RoadNetwork) -> Vec<DVec2> {
    let mut ends = Vec::new();
    for lane in &network.lanes {
        let line = &lane.centerline;
        if lane.predecessors.is_empty() {
            ends.push(line.position(0.0).truncate());
        }
        if lane.successors.is_empty() {
            ends.push(line.position(line.length()).truncate());
        }
    }
    ends
}
