//! Draws of places from which cameras may look, by what they are mounted on: the ranges that city cameras have.

use super::height_field::{HeightField, TopSurface};
use super::lane_spot::{LaneSpot, TownView, log_between};
use super::roadside::{Roadside, beside};
use super::surroundings::{BuildingPrism, CameraSurroundings, OpenSpace};
use crate::geometry::unit;
use endless_road::{Crossing, TrafficControl};
use endless_world::math::f64::{atan, atan2};
use endless_world::{CameraSite, LensModel, Mount, Stream, ViewSubject};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Mounts by frequency where vehicles are filmed.
const MOUNTS: [(Mount, f64); 7] = [
    (Mount::Pole, 0.26),
    (Mount::TrafficLight, 0.12),
    (Mount::Wall, 0.1),
    (Mount::Roof, 0.12),
    (Mount::Gantry, 0.16),
    (Mount::Bridge, 0.2),
    (Mount::Mast, 0.16),
];
/// Share of squares and parks among squares, parks and crossings.
const SQUARES: f64 = 0.35;
/// Steepest and flattest angle below the horizon, and widest and narrowest field of view, degrees.
const TILT_DEG: [f64; 2] = [5.0, 60.0];
const FOV_DEG: [f64; 2] = [15.0, 110.0];
/// Width of what a picture shows where the camera is aimed, metres.
const SHOWN_M: [f64; 2] = [9.0, 54.0];
/// Cameras are put up askew by so much (standard deviation), at most, degrees.
const ROLL_DEG: f64 = 0.8;
const MOST_ROLL_DEG: f64 = 2.5;
/// Roofs hang cameras this high above the ground, metres.
const ROOF_M: [f64; 2] = [8.0, 30.0];
/// Walls are this near to a road, and roofs, metres.
const WALL_TO_ROAD_M: f64 = 12.0;
const ROOF_TO_ROAD_M: f64 = 40.0;

/// A place that was drawn.
pub(super) struct DrawnPlace {
    pub(super) site: CameraSite,
    /// Height of what it is aimed at.
    pub(super) level: f64,
    /// What it is aimed at.
    pub(super) aim: DVec2,
    /// Foot of its pole, and height of the ground there; `None` where it stands on something.
    pub(super) pole: Option<DVec3>,
    /// Over a square or in a park.
    pub(super) on_foot: bool,
}

/// Draws places in a town.
pub(super) struct MountDraw<'s> {
    relief: &'s HeightField,
    solids: &'s [BuildingPrism],
    open: &'s [OpenSpace],
    crossings: &'s [Crossing],
    views: Vec<TownView<'s>>,
}

impl<'s> MountDraw<'s> {
    /// Of a town; of all views if it has none of those that are wanted.
    pub(super) fn new(scene: &CameraSurroundings<'s>, wanted: &[ViewSubject]) -> Self {
        let CameraSurroundings { network, relief, solids, open, .. } = *scene;
        let views = TownView::all(network, !open.is_empty(), wanted);
        Self { relief, solids, open, crossings: &network.crossings, views }
    }

    /// The same, from the lanes of a map that are near a place.
    pub(super) fn near(&self, at: DVec2, within_m: f64) -> Self {
        Self { views: self.views.iter().filter_map(|view| view.near(at, within_m)).collect(), ..*self }
    }

    /// What a camera is to look at, by its place among the town's, and from what; `None` where there is nothing.
    pub(super) fn intent(&self, random: &mut Stream) -> Option<ViewIntent> {
        if self.views.is_empty() {
            return None;
        }
        let frequencies: Vec<f64> = self.views.iter().map(|view| view.frequency).collect();
        let view = random.weighted(&frequencies);
        // Houses stand at streets.
        let at_houses = self.views[view].subject != ViewSubject::Highway;
        let share = |(mount, share)| if at_houses || !matches!(mount, Mount::Wall | Mount::Roof) { share } else { 0.0 };
        let mount = MOUNTS[random.weighted(&MOUNTS.map(share))].0;
        Some(ViewIntent { view, mount })
    }

    /// A place; `None` where what was drawn has no room.
    pub(super) fn draw(&self, intent: ViewIntent, random: &mut Stream) -> Option<DrawnPlace> {
        let view = &self.views[intent.view];
        if view.subject == ViewSubject::Square {
            return self.over_people(random);
        }
        let spot = view.spot(random);
        match intent.mount {
            Mount::Wall => self.on_wall(random),
            Mount::Roof => self.on_roof(random),
            Mount::Gantry => Some(over_road(Mount::Gantry, spot, [5.5, 7.5], [9.0, 90.0], random)),
            Mount::Bridge => Some(over_road(Mount::Bridge, spot, [6.0, 12.0], [4.0, 140.0], random)),
            Mount::Mast => self.on_mast(spot, random),
            Mount::TrafficLight => self.on_traffic_light(spot, random),
            Mount::Pole => self.on_pole(spot, random),
        }
    }

    /// Beside the traffic light of a lane, aimed at or across its junction.
    fn on_traffic_light(&self, spot: LaneSpot<'_>, random: &mut Stream) -> Option<DrawnPlace> {
        let lane = spot.lane;
        if !matches!(lane.end_control, TrafficControl::Signal(_)) {
            return None;
        }
        let length = lane.centerline.length();
        let side = if random.chance(0.7) { -1.0 } else { 1.0 };
        let back = random.range_f64(0.2, 5.0).min(length);
        let roadside = beside(self.relief, &lane.centerline, length - back, lane.width_m, side)?;
        let end = lane.centerline.at(length);
        let ahead = unit(end.heading_rad + random.range_f64(-1.3, 1.3));
        let aim = end.position.truncate() + ahead * log_between(7.0, 60.0, random);
        let height = random.range_f64(4.5, 9.0);
        Some(on_roadside(&roadside, height, aim.extend(end.position.z), Mount::TrafficLight, random))
    }

    fn on_pole(&self, spot: LaneSpot<'_>, random: &mut Stream) -> Option<DrawnPlace> {
        let LaneSpot { lane, s, .. } = spot;
        let side = if random.chance(0.8) { -1.0 } else { 1.0 };
        let roadside = beside(self.relief, &lane.centerline, s, lane.width_m, side)?;
        let aim = spot.aim([8.0, 90.0], random);
        let height = random.range_f64(4.0, 10.0);
        Some(on_roadside(&roadside, height, aim, Mount::Pole, random))
    }

    fn on_mast(&self, spot: LaneSpot<'_>, random: &mut Stream) -> Option<DrawnPlace> {
        let LaneSpot { lane, s, .. } = spot;
        let side = if random.chance(0.5) { -1.0 } else { 1.0 };
        let place = lane.centerline.at(s);
        let off = lane.width_m / 2.0 + random.range_f64(2.0, 32.0);
        let foot = place.position.truncate() + unit(place.heading_rad).perp() * (side * off);
        let ground = self.standing_room(foot)?;
        let aim = spot.aim([6.0, 150.0], random);
        let height = log_between(11.0, 30.0, random);
        let site = aimed(foot.extend(ground + height), aim, Mount::Mast, random);
        let pole = Some(foot.extend(ground));
        Some(DrawnPlace { site, level: aim.z, aim: aim.truncate(), pole, on_foot: false })
    }

    /// The middle part of an outer wall with a road before it: a place on it, the direction out, the distance of the
    /// road and its height.
    fn front(&self, within_m: f64, random: &mut Stream) -> Option<(&'s BuildingPrism, DVec2, DVec2, f64, f64)> {
        let solid = (!self.solids.is_empty()).then(|| &self.solids[random.below(self.solids.len())])?;
        let k = random.below(solid.outline.len());
        let (a, b) = (solid.outline[k], solid.outline[(k + 1) % solid.outline.len()]);
        if a.distance(b) < 4.0 {
            return None;
        }
        // Outlines run counter-clockwise: outside is on the right.
        let out = -(b - a).normalize_or(DVec2::X).perp();
        let at = a.lerp(b, random.range_f64(0.15, 0.85));
        let road_at = |d: &f64| self.relief.at(at + out * *d).1 == TopSurface::Road;
        let road = (2..(2.0 * within_m) as u32).map(|i| 0.5 * f64::from(i)).find(road_at)?;
        let road_z = f64::from(self.relief.at(at + out * road).0);
        Some((solid, at, out, road, road_z))
    }

    fn on_wall(&self, random: &mut Stream) -> Option<DrawnPlace> {
        let (solid, at, out, road, road_z) = self.front(WALL_TO_ROAD_M, random)?;
        let height = random.range_f64(4.0, 9.0).min(solid.top - solid.base - 0.8);
        let turn = random.range_f64(-1.2, 1.2);
        let lens = at + out * 0.7;
        let aim = lens + unit(turn).rotate(out) * (road + log_between(4.0, 45.0, random));
        let (lens, aim) = (lens.extend(solid.base + height), aim.extend(road_z));
        let site = aimed(lens, aim, Mount::Wall, random);
        (height > 3.0).then(|| DrawnPlace { site, level: road_z, aim: aim.truncate(), pole: None, on_foot: false })
    }

    fn on_roof(&self, random: &mut Stream) -> Option<DrawnPlace> {
        let (solid, at, out, road, road_z) = self.front(ROOF_TO_ROAD_M, random)?;
        let lens = (at + out * 1.4).extend(solid.top + random.range_f64(0.3, 1.5));
        let turn = random.range_f64(-1.1, 1.1);
        let aim = (at + unit(turn).rotate(out) * (road + log_between(4.0, 70.0, random))).extend(road_z);
        let high = (ROOF_M[0]..ROOF_M[1]).contains(&(lens.z - road_z));
        let site = aimed(lens, aim, Mount::Roof, random);
        high.then(|| DrawnPlace { site, level: road_z, aim: aim.truncate(), pole: None, on_foot: false })
    }

    /// Over a square, a park or a crossing.
    fn over_people(&self, random: &mut Stream) -> Option<DrawnPlace> {
        let square = self.crossings.is_empty() || !self.open.is_empty() && random.chance(SQUARES);
        let aim = if square {
            let outline = &self.open[random.below(self.open.len())].outline;
            let middle = outline.iter().sum::<DVec2>() / outline.len() as f64;
            middle.lerp(outline[random.below(outline.len())], random.range_f64(0.0, 0.8))
        } else {
            let [a, b] = self.crossings[random.below(self.crossings.len())].ends;
            a.lerp(b, random.f64()).truncate()
        };
        let foot = aim + unit(random.range_f64(0.0, TAU)) * log_between(8.0, 45.0, random);
        let (ground, level) = (self.standing_room(foot)?, f64::from(self.relief.at(aim).0));
        let height = log_between(4.0, 14.0, random);
        let mount = if height > 9.0 { Mount::Mast } else { Mount::Pole };
        let site = aimed(foot.extend(ground + height), aim.extend(level), mount, random);
        let clear = (level - ground).abs() < 3.0;
        clear.then(|| DrawnPlace { site, level, aim, pole: Some(foot.extend(ground)), on_foot: true })
    }

    /// Height of the ground where a pole could stand.
    fn standing_room(&self, foot: DVec2) -> Option<f64> {
        let (ground, top) = self.relief.at(foot);
        matches!(top, TopSurface::Walk | TopSurface::Green | TopSurface::Ground).then(|| f64::from(ground))
    }
}

/// What a camera is to look at, by its place among the views of a town, and from what.
#[derive(Debug, Clone, Copy)]
pub(super) struct ViewIntent {
    view: usize,
    mount: Mount,
}

/// On a pole beside a lane, so high above the ground.
fn on_roadside(roadside: &Roadside, height: f64, aim: DVec3, mount: Mount, random: &mut Stream) -> DrawnPlace {
    let lens = roadside.foot + (aim.truncate() - roadside.foot).normalize_or(DVec2::X) * 0.4;
    let site = aimed(lens.extend(roadside.ground + height), aim, mount, random);
    let pole = Some(roadside.foot.extend(roadside.ground));
    DrawnPlace { site, level: roadside.road_z, aim: aim.truncate(), pole, on_foot: false }
}

/// Above a lane.
fn over_road(
    mount: Mount,
    spot: LaneSpot<'_>,
    heights: [f64; 2],
    distances: [f64; 2],
    random: &mut Stream,
) -> DrawnPlace {
    let LaneSpot { lane, s, .. } = spot;
    let place = lane.centerline.at(s);
    let aside = unit(place.heading_rad).perp() * random.range_f64(-lane.width_m, lane.width_m);
    let lens = place.position + aside.extend(random.range_f64(heights[0], heights[1]));
    let aim = spot.aim(distances, random);
    let site = aimed(lens, aim, mount, random);
    DrawnPlace { site, level: place.position.z, aim: aim.truncate(), pole: None, on_foot: false }
}

/// A camera aimed at a place, with a lens that shows a street's width there or several.
fn aimed(lens: DVec3, aim: DVec3, mount: Mount, random: &mut Stream) -> CameraSite {
    let towards = aim.truncate() - lens.truncate();
    let tilt = atan2(lens.z - aim.z, towards.length()).clamp(TILT_DEG[0].to_radians(), TILT_DEG[1].to_radians());
    let shown = log_between(SHOWN_M[0], SHOWN_M[1], random);
    let fov = 2.0 * atan(shown / (2.0 * lens.distance(aim)));
    let roll = (ROLL_DEG * random.normal()).clamp(-MOST_ROLL_DEG, MOST_ROLL_DEG);
    CameraSite {
        name: String::new(),
        position: lens.as_vec3().to_array(),
        yaw_rad: atan2(towards.y, towards.x) as f32,
        down_tilt_rad: tilt as f32,
        horizontal_fov_rad: fov.clamp(FOV_DEG[0].to_radians(), FOV_DEG[1].to_radians()) as f32,
        lens: LensModel::Pinhole,
        mount,
        roll_rad: roll.to_radians() as f32,
    }
}
