//! Draws of places from which cameras may look, by what they are mounted on: the ranges that city cameras have.

use super::height_field::{HeightField, TopSurface};
use super::roadside::beside;
use super::surroundings::{BuildingPrism, CameraSurroundings, OpenSpace};
use crate::geometry::unit;
use endless_road::{Crossing, Lane};
use endless_world::math::f64::{atan, atan2, exp, ln};
use endless_world::{CameraSite, LensModel, Mount, Stream, ViewSubject};
use glam::{DVec2, DVec3};
use std::f64::consts::TAU;

/// Mounts by frequency where vehicles are filmed.
const MOUNTS: [(Mount, f64); 6] = [
    (Mount::Pole, 0.26),
    (Mount::Wall, 0.1),
    (Mount::Roof, 0.12),
    (Mount::Gantry, 0.16),
    (Mount::Bridge, 0.2),
    (Mount::Mast, 0.16),
];
/// What cameras look at, by frequency, where all views are wanted.
const SUBJECTS: [(ViewSubject, f64); 4] = [
    (ViewSubject::Street, 0.4),
    (ViewSubject::Junction, 0.28),
    (ViewSubject::Highway, 0.22),
    (ViewSubject::Square, 0.1),
];
/// Share of squares and parks among squares, parks and crossings.
const SQUARES: f64 = 0.35;
/// From which speed a road is a highway, m/s.
const HIGHWAY_MPS: f64 = 16.0;
/// Cameras at a junction stand so far before its stop line, metres.
const BEFORE_JUNCTION_M: [f64; 2] = [3.0, 60.0];
/// Shorter lanes are no place, metres.
const SHORTEST_LANE_M: f64 = 12.0;
/// Steepest and flattest angle below the horizon, and widest and narrowest field of view, degrees.
const TILT_DEG: [f64; 2] = [5.0, 60.0];
const FOV_DEG: [f64; 2] = [15.0, 110.0];
/// Width of what a picture shows where the camera is aimed, metres.
const SHOWN_M: [f64; 2] = [12.0, 56.0];
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
    /// Of each kind of view that is wanted and that the town has: its frequency, and the lanes from which it is seen with
    /// what is expected on them.
    subjects: Vec<(ViewSubject, f64, Vec<(&'s Lane, f64)>)>,
}

/// Between two lengths, short ones as often as long ones.
fn log_between(low: f64, high: f64, random: &mut Stream) -> f64 {
    exp(random.range_f64(ln(low), ln(high)))
}

impl<'s> MountDraw<'s> {
    /// Of a town; of all views if it has none of those that are wanted.
    pub(super) fn new(scene: &CameraSurroundings<'s>, wanted: &[ViewSubject]) -> Self {
        let network = scene.network;
        let open_road = |l: &&Lane| l.junction.is_none() && l.centerline.length() > SHORTEST_LANE_M;
        let weight = |l: &'s Lane| (l, l.centerline.length() * (l.speed_limit_mps / 11.0).clamp(0.6, 1.6));
        let lanes: Vec<(&Lane, f64)> = network.lanes.iter().filter(open_road).map(weight).collect();
        let at_junction = |l: &Lane| l.successors.iter().any(|&next| network.lane(next).junction.is_some());
        let seen_from = |subject| -> Vec<(&'s Lane, f64)> {
            let from = |l: &Lane| match subject {
                ViewSubject::Street => l.speed_limit_mps < HIGHWAY_MPS,
                ViewSubject::Junction => at_junction(l),
                ViewSubject::Highway => l.speed_limit_mps >= HIGHWAY_MPS,
                ViewSubject::Square => !scene.open.is_empty() || !network.crossings.is_empty(),
            };
            lanes.iter().filter(|(lane, _)| from(lane)).copied().collect()
        };
        let of = |wanted: &[ViewSubject]| -> Vec<_> {
            let subjects = SUBJECTS.iter().filter(|(subject, _)| wanted.contains(subject));
            let subjects = subjects.map(|&(subject, frequency)| (subject, frequency, seen_from(subject)));
            subjects.filter(|(_, _, lanes)| !lanes.is_empty()).collect()
        };
        let subjects = of(wanted);
        let subjects = if subjects.is_empty() { of(ViewSubject::ALL) } else { subjects };
        let CameraSurroundings { relief, solids, open, .. } = *scene;
        Self { relief, solids, open, crossings: &network.crossings, subjects }
    }

    /// The lanes of a map from which cameras look that are to see a place.
    pub(super) fn near(&self, at: DVec2, within_m: f64) -> Self {
        let close = |lane: &Lane| lane.centerline.project(at).1.abs() < within_m;
        let of = |(subject, frequency, lanes): &(ViewSubject, f64, Vec<(&'s Lane, f64)>)| {
            (*subject, *frequency, lanes.iter().filter(|(lane, _)| close(lane)).copied().collect::<Vec<_>>())
        };
        let subjects = self.subjects.iter().map(of).filter(|(_, _, lanes)| !lanes.is_empty()).collect();
        Self { subjects, ..*self }
    }

    /// What a camera is to look at, by its place among the town's, and from what; `None` where there is nothing.
    pub(super) fn intent(&self, random: &mut Stream) -> Option<ViewIntent> {
        let frequencies: Vec<f64> = self.subjects.iter().map(|subject| subject.1).collect();
        if frequencies.is_empty() {
            return None;
        }
        let subject = random.weighted(&frequencies);
        // Houses stand at streets.
        let at_houses = self.subjects[subject].0 != ViewSubject::Highway;
        let share = |(mount, share)| if at_houses || !matches!(mount, Mount::Wall | Mount::Roof) { share } else { 0.0 };
        let mount = MOUNTS[random.weighted(&MOUNTS.map(share))].0;
        Some(ViewIntent { subject, mount })
    }

    /// A place; `None` where what was drawn has no room.
    pub(super) fn draw(&self, intent: ViewIntent, random: &mut Stream) -> Option<DrawnPlace> {
        let (subject, _, lanes) = &self.subjects[intent.subject];
        if *subject == ViewSubject::Square {
            return self.over_people(random);
        }
        let spot = LaneSpot::draw(*subject, lanes, random);
        match intent.mount {
            Mount::Wall => self.on_wall(random),
            Mount::Roof => self.on_roof(random),
            Mount::Gantry => Some(over_road(Mount::Gantry, spot, [5.5, 7.5], [9.0, 90.0], random)),
            Mount::Bridge => Some(over_road(Mount::Bridge, spot, [6.0, 12.0], [4.0, 140.0], random)),
            Mount::Mast => self.on_mast(spot, random),
            Mount::Pole | Mount::TrafficLight => self.on_pole(spot, random),
        }
    }

    fn on_pole(&self, spot: LaneSpot<'_>, random: &mut Stream) -> Option<DrawnPlace> {
        let LaneSpot { lane, s, .. } = spot;
        let side = if random.chance(0.8) { -1.0 } else { 1.0 };
        let roadside = beside(self.relief, &lane.centerline, s, lane.width_m, side)?;
        let aim = spot.aim([8.0, 90.0], random);
        let lens = roadside.foot + (aim.truncate() - roadside.foot).normalize_or(DVec2::X) * 0.4;
        let height = random.range_f64(4.0, 10.0);
        let site = aimed(lens.extend(roadside.ground + height), aim, Mount::Pole, random);
        let pole = Some(roadside.foot.extend(roadside.ground));
        Some(DrawnPlace { site, level: roadside.road_z, aim: aim.truncate(), pole, on_foot: false })
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
    subject: usize,
    mount: Mount,
}

/// A place on a lane, and which way from it one looks.
#[derive(Clone, Copy)]
struct LaneSpot<'l> {
    lane: &'l Lane,
    s: f64,
    /// Distance of what one must look at, where that matters.
    ahead: Option<f64>,
}

impl<'l> LaneSpot<'l> {
    fn draw(subject: ViewSubject, lanes: &[(&'l Lane, f64)], random: &mut Stream) -> Self {
        let weights: Vec<f64> = lanes.iter().map(|lane| lane.1).collect();
        let lane = lanes[random.weighted(&weights)].0;
        let length = lane.centerline.length();
        if subject != ViewSubject::Junction {
            return Self { lane, s: length * random.f64(), ahead: None };
        }
        let before = log_between(BEFORE_JUNCTION_M[0], BEFORE_JUNCTION_M[1], random).min(length);
        Self { lane, s: length - before, ahead: Some(before + random.range_f64(-4.0, 16.0)) }
    }

    /// A place on the road ahead, or behind.
    fn aim(&self, distances: [f64; 2], random: &mut Stream) -> DVec3 {
        let drawn = log_between(distances[0], distances[1], random) * if random.chance(0.5) { 1.0 } else { -1.0 };
        let ahead = self.ahead.unwrap_or(drawn);
        let line = &self.lane.centerline;
        let end = (self.s + ahead).clamp(0.0, line.length());
        let place = line.at(end);
        let forward = unit(place.heading_rad);
        let width = self.lane.width_m;
        let across = forward.perp() * random.range_f64(-1.2 * width, 1.2 * width);
        (place.position.truncate() + forward * (self.s + ahead - end) + across).extend(place.position.z)
    }
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
