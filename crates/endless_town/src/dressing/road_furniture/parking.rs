//! Parked vehicles: in parking lanes, along quiet streets and on car parks.

use crate::dressing::assembly::TownAssembly;
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::land_use_map::LandUseMap;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::pavement::crossing;
use crate::geometry::{Rect, inside, unit};
use endless_road::{LandUse, LaneSurface, LaneType, RoadNetwork};
use endless_world::math::f64::{atan2, wrap_angle};
use endless_world::{CameraSite, ParkedVehicle, Pose, Stream, VehicleModelId, VehicleRef};
use glam::{DVec2, DVec3, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// Share of places that are taken.
const TAKEN: f64 = 0.62;
/// A bay along the kerb, and one across it.
const BAY_M: [f64; 2] = [5.9, 2.6];
/// Parking lanes at least this wide are parked in across.
const ACROSS_FROM_M: f64 = 4.4;
/// Most parked vehicles before the cameras are chosen.
const MOST: usize = 2500;

/// A place for one vehicle.
struct ParkingBay {
    at: DVec3,
    yaw: f64,
    grade: f64,
}

pub(crate) fn add(
    assembly: &mut TownAssembly<'_>,
    network: &RoadNetwork,
    lane_surfaces: &[LaneSurface],
    areas: &LandUseMap,
    pavement: &PavementIndex,
    land: &GroundGrid,
) {
    for (i, strip) in lane_surfaces.iter().enumerate().filter(|(_, s)| s.kind == LaneType::Parking && !s.in_junction) {
        let mut stream = assembly.stream(70_000 + i as u64);
        let middle = strip.left[strip.left.len() / 2];
        let way = traffic_heading(network, middle.truncate());
        for mut bay in along(strip) {
            let reach = unit(bay.yaw) * 2.3;
            let side = reach.normalize_or(DVec2::X).perp() * 0.85;
            let at = bay.at.truncate();
            let drives = |p: DVec2| pavement.at(p).any(|(piece, _)| piece.kind == LaneType::Driving);
            let in_the_road =
                [reach + side, reach - side, -reach + side, -reach - side].iter().any(|&d| drives(at + d));
            if in_the_road || near_crossing(network, at) {
                continue;
            }
            // As the traffic beside it drives.
            if way.is_some_and(|way| wrap_angle(way - bay.yaw).abs() > FRAC_PI_2 + 0.1) {
                (bay.yaw, bay.grade) = (bay.yaw + PI, -bay.grade);
            }
            park(assembly, &bay, &mut stream);
        }
    }
    for (i, area) in areas.of(LandUse::Parking).enumerate() {
        let mut stream = assembly.stream(90_000 + i as u64);
        for bay in rows(&area.outline, &area.holes, pavement, land) {
            park(assembly, &bay, &mut stream);
        }
    }
}

/// Whether a car would stand on or right before a crossing.
fn near_crossing(network: &RoadNetwork, at: DVec2) -> bool {
    network.crossings.iter().any(|crossing| crossing::is_near(crossing, at, 3.4))
}

/// Bays of a parking lane.
fn along(strip: &LaneSurface) -> Vec<ParkingBay> {
    let middle: Vec<DVec3> = strip.left.iter().zip(&strip.right).map(|(l, r)| (*l + *r) / 2.0).collect();
    let widths: Vec<f64> = strip.left.iter().zip(&strip.right).map(|(l, r)| l.distance(*r)).collect();
    let mut bays = Vec::new();
    let mut since = 0.0;
    for k in 0..middle.len() - 1 {
        let (a, b) = (middle[k], middle[k + 1]);
        let length = a.distance(b);
        let width = widths[k].min(widths[k + 1]);
        let across = width > ACROSS_FROM_M;
        let step = if across { BAY_M[1] } else { BAY_M[0] };
        if width < 1.75 || length < 1e-3 {
            since = 0.0;
            continue;
        }
        let way = (b - a).truncate();
        let heading = atan2(way.y, way.x);
        let mut s = step / 2.0 - since;
        while s <= length {
            if s >= 0.0 {
                let yaw = if across { heading + FRAC_PI_2 } else { heading };
                let grade = (b.z - a.z) / way.length().max(1e-6);
                bays.push(ParkingBay { at: a.lerp(b, s / length), yaw, grade: if across { 0.0 } else { grade } });
            }
            s += step;
        }
        since = (since + length) % step;
    }
    bays
}

/// Heading of the lane nearest to a place, if one is near.
fn traffic_heading(network: &RoadNetwork, at: DVec2) -> Option<f64> {
    let lanes = network.lanes.iter().filter(|l| l.junction.is_none());
    let near = lanes.map(|l| (l, l.centerline.project(at))).min_by(|a, b| a.1.1.abs().total_cmp(&b.1.1.abs()))?;
    (near.1.1.abs() < 12.0).then(|| near.0.centerline.at(near.1.0).heading_rad)
}

/// Double rows of bays on a car park, in the direction of its longest side.
fn rows(outline: &[DVec2], holes: &[Vec<DVec2>], pavement: &PavementIndex, land: &GroundGrid) -> Vec<ParkingBay> {
    let rect = crate::geometry::around(outline);
    let (axis, half) = if rect.half.x >= rect.half.y {
        (rect.axis, rect.half)
    } else {
        (rect.axis.perp(), DVec2::new(rect.half.y, rect.half.x))
    };
    let within = |p: DVec2| inside(outline, p) && !holes.iter().any(|h| inside(h, p)) && !pavement.is_paved(p);
    let yaw = atan2(axis.y, axis.x) + FRAC_PI_2;
    let mut bays = Vec::new();
    let mut y = -half.y + 2.8;
    while y < half.y - 2.5 {
        let mut x = -half.x + 2.0;
        while x < half.x - 1.5 {
            let at = rect.centre + axis * x + axis.perp() * y;
            if Rect::new(at, DVec2::new(2.4, 1.2), yaw).corners().into_iter().all(within) {
                bays.push(ParkingBay { at: at.extend(land.level(at) - 0.03), yaw, grade: 0.0 });
            }
            x += BAY_M[1];
        }
        y += if bays.len() % 2 == 0 { 5.2 } else { 11.0 };
    }
    bays
}

fn park(assembly: &mut TownAssembly<'_>, bay: &ParkingBay, stream: &mut Stream) {
    let models = assembly.catalogue.vehicles();
    let weights: Vec<f64> = models.iter().map(|m| if m.spec.parks { m.spec.frequency } else { 0.0 }).collect();
    let taken = stream.chance(TAKEN);
    if !taken || assembly.parked.len() >= MOST || weights.iter().sum::<f64>() <= 0.0 {
        return;
    }
    let model = stream.weighted(&weights);
    let variant = stream.next_u64();
    let spec = &models[model].spec;
    if f64::from(spec.length_m) > BAY_M[0] - 0.4 {
        return;
    }
    let yaw = bay.yaw + (stream.normal() * 0.02).clamp(-0.04, 0.04);
    let half = DVec2::new(f64::from(spec.length_m), f64::from(spec.width_m)) / 2.0;
    let at = bay.at + (unit(yaw) * (stream.normal() * 0.12).clamp(-0.3, 0.3)).extend(0.0);
    if assembly.occupied.try_take(Rect::new(at.truncate(), half.map(|h| h + 0.05), yaw)) {
        let pitch_rad = endless_world::math::atan(bay.grade as f32);
        let pose = Pose { pitch_rad, ..Pose::level(at.as_vec3(), yaw as f32) };
        let vehicle = VehicleRef { model: VehicleModelId::from_index(model), variant };
        assembly.parked.push(ParkedVehicle { vehicle, pose });
    }
}

/// Most vehicles parked along the streets of a town.
const MOST_PARKED: usize = 160;

/// Keeps the vehicles parked nearest to cameras: no others are ever seen large.
pub(crate) fn keep_the_seen(parked: &mut Vec<ParkedVehicle>, sites: &[CameraSite]) {
    let far = |p: &ParkedVehicle| {
        let of = |s: &CameraSite| Vec3::from_array(s.position).distance(p.pose.position);
        sites.iter().map(of).fold(f32::INFINITY, f32::min)
    };
    parked.sort_by(|a, b| far(a).total_cmp(&far(b)));
    parked.truncate(MOST_PARKED);
}
