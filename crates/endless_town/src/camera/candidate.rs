//! Places from which a camera could look.

use crate::building::Lot;
use crate::dressing::POST_M;
use crate::network::{KERB_HEIGHT_M, Node, Plan, Rule};
use endless_world::math::f64::{atan2, cos, sin};
use endless_world::{CameraSite, Mount};
use glam::DVec2;

/// What a view shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum View {
    /// A junction with traffic lights.
    Signals,
    /// A junction without.
    Corner,
    /// A crossing between junctions.
    Crossing,
    /// Along a busy street.
    Street,
    /// Along a quiet one.
    Residential,
    /// From a house front.
    Wall,
}

impl View {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Signals => "junction",
            Self::Corner => "corner",
            Self::Crossing => "crossing",
            Self::Street => "street",
            Self::Residential => "residential",
            Self::Wall => "wall",
        }
    }
}

/// A place with what it would show.
#[derive(Debug, Clone)]
pub(crate) struct Candidate {
    pub(crate) view: View,
    /// Views of the same thing share this.
    pub(crate) subject: usize,
    /// Foot of the pole; `None` on walls.
    pub(crate) pole: Option<DVec2>,
    pub(crate) site: CameraSite,
}

/// From a pole at `foot`, the lens a little before it at `height` above the sidewalk, towards `aim` on the road.
fn aimed(foot: DVec2, height: f64, aim: DVec2, fov_deg: f64, mount: Mount) -> CameraSite {
    let towards = (aim - foot).normalize_or(DVec2::X);
    let lens = foot + towards * 0.4;
    let z = KERB_HEIGHT_M + height;
    // Between 15 and 35 degrees below the horizon.
    let tilt = atan2(z, lens.distance(aim)).clamp(15.5f64.to_radians(), 34.0f64.to_radians());
    CameraSite {
        name: String::new(),
        position: lens.extend(z).as_vec3().to_array(),
        yaw_rad: atan2(towards.y, towards.x) as f32,
        down_tilt_rad: tilt as f32,
        horizontal_fov_rad: fov_deg.to_radians() as f32,
        mount,
    }
}

pub(crate) fn all(plan: &Plan, lots: &[Lot]) -> Vec<Candidate> {
    let mut found = Vec::new();
    for (n, node) in plan.nodes.iter().enumerate() {
        at_junction(plan, n, node, &mut found);
    }
    for i in 0..plan.streets.len() {
        along_street(plan, i, &mut found);
        at_crossings(plan, i, &mut found);
    }
    on_walls(plan, lots, &mut found);
    found
}

/// From every corner over the junction's middle.
fn at_junction(plan: &Plan, n: usize, node: &Node, found: &mut Vec<Candidate>) {
    let view = if node.rule == Rule::Signals { View::Signals } else { View::Corner };
    for i in 0..node.arms.len() {
        let corner = plan.corner(node, i, POST_M + 0.5, 0.3);
        let foot = corner[corner.len() / 2];
        let across = node.position - foot;
        let height = (5.6 + 0.16 * across.length()).clamp(6.6, 9.5);
        for turn in [-0.3, 0.0, 0.3] {
            let aim = foot
                + DVec2::new(cos(turn), sin(turn)).rotate(across.normalize_or(DVec2::X))
                    * (across.length() + 9.0).max(23.0);
            let site = aimed(foot, height, aim, 84.0, Mount::Pole);
            found.push(Candidate { view, subject: n, pole: Some(foot), site });
        }
    }
}

/// From the furniture strip along the street.
fn along_street(plan: &Plan, i: usize, found: &mut Vec<Candidate>) {
    let street = &plan.streets[i];
    let view = if street.profile.priority >= 3 { View::Street } else { View::Residential };
    let (from, to) = street.body();
    if to - from < 55.0 {
        return;
    }
    let height = if view == View::Street { 8.2 } else { 6.8 };
    for (s, ahead) in [(from + 9.0, 1.0), (from + 24.0, 1.0), (to - 9.0, -1.0), (to - 24.0, -1.0)] {
        for side in [1.0, -1.0] {
            let foot = street.point(s, side * (street.profile.kerb() + POST_M));
            let aim = street.point(s + ahead * 27.0, 0.0);
            let site = aimed(foot, height, aim, 72.0, Mount::Pole);
            if !street.near_crossing(s, 1.5) {
                found.push(Candidate { view, subject: i, pole: Some(foot), site });
            }
        }
    }
}

/// Towards crossings in the middle of streets.
fn at_crossings(plan: &Plan, i: usize, found: &mut Vec<Candidate>) {
    let street = &plan.streets[i];
    let (from, to) = street.lane_range();
    for (k, crossing) in street.crossings.iter().enumerate().filter(|(_, c)| c.s > from && c.s < to) {
        for (away, side) in [(17.0, 1.0), (-17.0, 1.0), (17.0, -1.0), (-17.0, -1.0)] {
            let foot = street.point(crossing.s + away, side * (street.profile.kerb() + POST_M));
            let site = aimed(foot, 7.2, street.point(crossing.s - 0.15 * away, 0.0), 68.0, Mount::Pole);
            found.push(Candidate { view: View::Crossing, subject: i * 16 + k, pole: Some(foot), site });
        }
    }
}

/// From fronts near the sidewalk, along their street.
fn on_walls(plan: &Plan, lots: &[Lot], found: &mut Vec<Candidate>) {
    for (k, lot) in lots.iter().enumerate().filter(|(_, lot)| lot.measures.storeys >= 3) {
        let Some((street, s, t)) = nearest(plan, lot.front) else { continue };
        let street = &plan.streets[street];
        if t.abs() > street.profile.back() + 1.5 {
            continue;
        }
        let outwards = -lot.footprint.axis.perp();
        for ahead in [24.0, -24.0] {
            let aim = street.point((s + ahead).clamp(0.0, street.length()), 0.0);
            // Clear of cornices and awnings.
            let site = aimed(lot.front + outwards * 0.6, 7.4, aim, 76.0, Mount::Wall);
            found.push(Candidate { view: View::Wall, subject: k, pole: None, site });
        }
    }
}

/// The street nearest to a point: its index and the place on it.
fn nearest(plan: &Plan, p: DVec2) -> Option<(usize, f64, f64)> {
    plan.streets
        .iter()
        .enumerate()
        .map(|(i, street)| {
            let (s, t) = street.path.project(p);
            (i, s, t)
        })
        .min_by(|a, b| a.2.abs().total_cmp(&b.2.abs()))
}
