//! Places from which a camera could look: beside lanes, at crossings and stop lines, on walls, at squares and in parks.

use super::height_field::{HeightField, TopSurface};
use super::roadside::{Roadside, beside};
use super::surroundings::{BuildingPrism, OpenSpace};
use crate::geometry::area;
use crate::geometry::unit;
use endless_road::{Lane, RoadNetwork};
use endless_world::math::f64::{atan2, wrap_angle};
use endless_world::{CameraSite, LensModel, Mount};
use glam::DVec2;

/// Kind of a view, by what it shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, strum::IntoStaticStr)]
#[strum(serialize_all = "snake_case")]
pub(crate) enum ViewKind {
    /// Over waiting vehicles towards a junction.
    #[strum(serialize = "junction")]
    Approach,
    /// From a junction out along one of its arms.
    Arm,
    /// Across a junction's corner.
    Corner,
    /// A crossing from near by.
    Crossing,
    /// Along a street with parked cars and sidewalks.
    Street,
    /// Along a fast road.
    Highway,
    /// Along a road between fields or trees.
    Rural,
    /// From a house front.
    Wall,
    /// Over a square.
    Square,
    /// Along a way through a park.
    Park,
}

impl ViewKind {
    /// Where people walk and nobody drives.
    pub(crate) fn is_on_foot(self) -> bool {
        matches!(self, Self::Square | Self::Park)
    }

    pub(crate) fn name(self) -> &'static str {
        self.into()
    }
}

/// A place with what it would show.
#[derive(Debug, Clone)]
pub(crate) struct CameraCandidate {
    pub(crate) view: ViewKind,
    /// Foot of the pole and height of the ground there; `None` on walls.
    pub(crate) pole: Option<(DVec2, f64)>,
    /// Height of what it is aimed at.
    pub(crate) level: f64,
    pub(crate) site: CameraSite,
}

/// From which speed a road is a highway, m/s.
pub(super) const HIGHWAY_MPS: f64 = 16.0;
/// Squares and parks smaller than this are no place, m².
const LEAST_OPEN_M2: f64 = 260.0;
/// Most candidates of a kind that are judged.
const MOST_OF_A_KIND: usize = 420;

/// Height above ground, field of view and mount of a camera.
#[derive(Debug, Clone, Copy)]
pub(super) struct CameraAim {
    pub(super) height: f64,
    pub(super) fov_deg: f64,
    pub(super) mount: Mount,
}

/// A lens at `lens` (seen from above), `height` above `ground`, looking at a place on the ground.
pub(super) fn aimed(lens: DVec2, ground: f64, aim: DVec2, aim_z: f64, turned: CameraAim) -> CameraSite {
    let towards = (aim - lens).normalize_or(DVec2::X);
    let z = ground + turned.height;
    let tilt = atan2(z - aim_z, lens.distance(aim)).clamp(15.5f64.to_radians(), 38.0f64.to_radians());
    CameraSite {
        name: String::new(),
        position: lens.extend(z).as_vec3().to_array(),
        yaw_rad: atan2(towards.y, towards.x) as f32,
        down_tilt_rad: tilt as f32,
        horizontal_fov_rad: turned.fov_deg.to_radians() as f32,
        lens: LensModel::Pinhole,
        mount: turned.mount,
        roll_rad: 0.0,
    }
}

pub(crate) fn all(
    network: &RoadNetwork,
    relief: &HeightField,
    solids: &[BuildingPrism],
    open: &[OpenSpace],
) -> Vec<CameraCandidate> {
    let mut finder = CandidateFinder { network, relief, found: Vec::new() };
    for lane in network.lanes.iter().filter(|l| l.junction.is_none() && l.centerline.length() > 18.0) {
        for side in [-1.0, 1.0] {
            let outermost = if side < 0.0 { lane.right.is_none() } else { lane.left.is_none() };
            if outermost {
                finder.along(lane, side);
            }
        }
    }
    for solid in solids {
        finder.on_walls(solid);
    }
    for open in open.iter().filter(|o| area(&o.outline).abs() > LEAST_OPEN_M2) {
        if open.park {
            finder.in_park(&open.outline);
        } else {
            finder.at_square(&open.outline);
        }
    }
    thinned(&finder.found)
}

/// The same number of each kind at most, spread evenly.
fn thinned(found: &[CameraCandidate]) -> Vec<CameraCandidate> {
    let mut kept = Vec::new();
    let mut kinds: Vec<ViewKind> = found.iter().map(|c| c.view).collect();
    kinds.sort_unstable();
    kinds.dedup();
    for kind in kinds {
        let of_kind: Vec<&CameraCandidate> = found.iter().filter(|c| c.view == kind).collect();
        let stride = of_kind.len() as f64 / of_kind.len().clamp(1, MOST_OF_A_KIND) as f64;
        kept.extend((0..of_kind.len().min(MOST_OF_A_KIND)).map(|i| of_kind[(i as f64 * stride) as usize].clone()));
    }
    kept
}

pub(super) struct CandidateFinder<'a> {
    pub(super) network: &'a RoadNetwork,
    pub(super) relief: &'a HeightField,
    pub(super) found: Vec<CameraCandidate>,
}

impl CandidateFinder<'_> {
    fn push(&mut self, view: ViewKind, beside: &Roadside, aim: DVec2, turned: CameraAim) {
        let towards = (aim - beside.foot).normalize_or(DVec2::X);
        let lens = beside.foot + towards * 0.4;
        let site = aimed(lens, beside.ground, aim, beside.road_z, turned);
        let pole = Some((beside.foot, beside.ground));
        self.found.push(CameraCandidate { view, pole, level: beside.road_z, site });
    }

    /// Views from the edge of a lane, along it and back.
    fn along(&mut self, lane: &Lane, side: f64) {
        let line = &lane.centerline;
        let length = line.length();
        let wide = self.same_way(lane) >= 3 || lane.speed_limit_mps > HIGHWAY_MPS;
        let pole = |height: f64, fov_deg: f64| CameraAim { height, fov_deg, mount: Mount::Pole };
        let ends_at_junction = lane.successors.iter().any(|&next| self.network.lane(next).junction.is_some());
        let to_middle = |b: &Roadside, more: f64| b.forward.perp() * -side * (b.across + more);
        if ends_at_junction && length > 30.0 {
            for back in [13.0, 19.0] {
                let Some(b) = beside(self.relief, line, length - back, lane.width_m, side) else { continue };
                let aim = b.foot + b.forward * (back + 5.0) + to_middle(&b, lane.width_m);
                self.push(ViewKind::Approach, &b, aim, pole(7.6, 72.0));
            }
            if let Some(b) = beside(self.relief, line, length - 2.0, lane.width_m, side) {
                let aim = b.foot - b.forward * 22.0 + to_middle(&b, lane.width_m * 0.7);
                self.push(ViewKind::Arm, &b, aim, pole(if wide { 9.0 } else { 6.8 }, 68.0));
                for turn in [0.6f64, 1.05] {
                    let aim = b.foot + unit(-side * turn).rotate(b.forward) * 22.0;
                    self.push(ViewKind::Corner, &b, aim, pole(8.6, 76.0));
                }
            }
        }
        if length > 50.0 {
            let (height, fov, view) = if wide { (9.5, 66.0, ViewKind::Highway) } else { (7.2, 74.0, ViewKind::Street) };
            let count = (length / 28.0).floor().min(12.0) as usize;
            for k in 1..count {
                let s = length * k as f64 / count as f64;
                let Some(b) = beside(self.relief, line, s, lane.width_m, side) else { continue };
                for ahead in [1.0, -1.0] {
                    let reach = if wide { 34.0 } else { 24.0 };
                    let aim = b.foot + b.forward * (ahead * reach) + to_middle(&b, lane.width_m * 0.5);
                    self.push(view, &b, aim, pole(height, fov));
                    if !wide {
                        // Steeper, so that a narrow road fills the picture.
                        let near = b.foot + b.forward * (ahead * 12.0) + to_middle(&b, lane.width_m * 0.5);
                        self.push(view, &b, near, pole(6.4, 60.0));
                    }
                }
            }
        }
        for crossing in &self.network.crossings {
            let Some(cut) = crossing.cuts.iter().find(|c| c.lane == lane.id) else { continue };
            let middle = (cut.range.0 + cut.range.1) / 2.0;
            for away in [-11.0, -16.0, 11.0, 16.0] {
                let s = middle + away;
                if !(2.0..length - 2.0).contains(&s) {
                    continue;
                }
                let Some(b) = beside(self.relief, line, s, lane.width_m, side) else { continue };
                let aim = b.foot - b.forward * (away * 1.05) + to_middle(&b, lane.width_m * 0.4);
                self.push(ViewKind::Crossing, &b, aim, pole(6.2, 70.0));
            }
        }
    }

    /// Number of lanes side by side in a lane's direction.
    fn same_way(&self, lane: &Lane) -> usize {
        let count = |next: fn(&Lane) -> Option<endless_road::LaneId>| {
            std::iter::successors(next(lane), |&id| next(self.network.lane(id))).take(8).count()
        };
        1 + count(|l| l.left) + count(|l| l.right)
    }

    /// From fronts near a road, along it.
    fn on_walls(&mut self, solid: &BuildingPrism) {
        let n = solid.outline.len();
        for k in 0..n {
            let (a, b) = (solid.outline[k], solid.outline[(k + 1) % n]);
            if a.distance(b) < 5.0 || solid.top - solid.base < 8.0 {
                continue;
            }
            let along = (b - a).normalize_or(DVec2::X);
            // Outlines run counter-clockwise: outside is on the right.
            let out = -along.perp();
            let middle = (a + b) / 2.0;
            let road =
                (2..28).map(|i| 0.5 * f64::from(i)).find(|&d| self.relief.at(middle + out * d).1 == TopSurface::Road);
            let Some(road) = road.filter(|d| *d < 8.5) else { continue };
            let road_z = f64::from(self.relief.at(middle + out * road).0);
            // Clear of cornices and awnings.
            let lens = middle + out * 0.6;
            // No further along the wall than that its stones stay out of the picture.
            for turn in [-0.85f64, -0.4, 0.4, 0.85] {
                let aim = lens + unit(turn).rotate(out) * (road + 11.0);
                let turned = CameraAim { height: 6.9, fov_deg: 72.0, mount: Mount::Wall };
                let site = aimed(lens, solid.base, aim, road_z, turned);
                self.found.push(CameraCandidate { view: ViewKind::Wall, pole: None, level: road_z, site });
            }
        }
    }
}

/// Angle between two directions, 0 to π.
pub(crate) fn between(a: f32, b: f32) -> f64 {
    wrap_angle(f64::from(a - b)).abs()
}
