//! Parked vehicles: in parking lanes, along quiet streets and on car parks.

use crate::dressing::assembly::TownAssembly;
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::land_use_map::LandUseMap;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::pavement::crossing;
use crate::dressing::road_furniture::parking_bay::{ParkingBay, along, rows};
use crate::dressing::road_furniture::swept_ground::clear_of_traffic;
use crate::geometry::{OccupiedSpace, unit};
use endless_road::{LandUse, LaneSurface, LaneType, RoadNetwork};
use endless_world::math::f64::wrap_angle;
use endless_world::{ParkedVehicle, Pose, Stream, VehicleRef, VehicleSpec};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, PI};

/// Share of places that are taken.
const TAKEN: f64 = 0.62;
/// Between who stands in a bay and its ends, both together, metres; and what a bay is wider than who stands in it.
const ENDS_M: f64 = 0.15;
const SIDES_M: f64 = 0.05;
/// Strips of car parks are numbered from here on.
const CAR_PARKS: u64 = 90_000;
/// Of more bays than have so many vehicles, a smaller share is taken.
const MOST: f64 = 1500.0;

/// A bay along the kerb of a street.
pub(crate) struct KerbBay {
    bay: ParkingBay,
    /// By a vehicle.
    is_taken: bool,
}

/// Those in which a vehicle stands, or could.
pub(crate) fn usable(bays: &[KerbBay], occupied: &OccupiedSpace) -> Vec<endless_world::ParkingBay> {
    let usable = bays.iter().filter(|KerbBay { bay, is_taken }| *is_taken || occupied.is_free(&bay.rect()));
    usable.map(|KerbBay { bay, .. }| bay.told()).collect()
}

/// Parks vehicles. Returns the bays along kerbs.
pub(crate) fn add(
    assembly: &mut TownAssembly<'_>,
    network: &RoadNetwork,
    lane_surfaces: &[LaneSurface],
    areas: &LandUseMap,
    pavement: &PavementIndex,
    land: &GroundGrid,
) -> Vec<KerbBay> {
    // Each with a number of its own from which all that stands there is drawn.
    let mut bays: Vec<([u64; 2], ParkingBay)> = Vec::new();
    for (i, strip) in lane_surfaces.iter().enumerate().filter(|(_, s)| s.kind == LaneType::Parking && !s.in_junction) {
        let middle = strip.left[strip.left.len() / 2];
        let way = traffic_heading(network, middle.truncate());
        for (k, mut bay) in along(strip).into_iter().enumerate() {
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
            bays.push(([70_000 + i as u64, k as u64], bay));
        }
    }
    for (i, area) in areas.of(LandUse::Parking).enumerate() {
        let inside = rows(&area.outline, &area.holes, pavement, land);
        bays.extend(inside.into_iter().enumerate().map(|(k, bay)| ([CAR_PARKS + i as u64, k as u64], bay)));
    }
    let clear = clear_of_traffic(network, &bays.iter().map(|b| b.1).collect::<Vec<_>>());
    let bays: Vec<_> = bays.iter().zip(clear).filter(|(_, clear)| *clear).map(|(bay, _)| bay).collect();
    let taken = TAKEN.min(MOST / bays.len().max(1) as f64);
    let mut at_kerb = Vec::new();
    for ([strip, k], bay) in bays {
        let mut stream = assembly.stream(*strip).fork(*k);
        let is_taken = stream.chance(taken) && park(assembly, bay, &mut stream);
        if *strip < CAR_PARKS && bay.is_along() {
            at_kerb.push(KerbBay { bay: *bay, is_taken });
        }
    }
    at_kerb
}

/// Whether a car would stand on or right before a crossing.
fn near_crossing(network: &RoadNetwork, at: DVec2) -> bool {
    network.crossings.iter().any(|crossing| crossing::is_near(crossing, at, 3.4))
}

/// Heading of the lane nearest to a place, if one is near.
fn traffic_heading(network: &RoadNetwork, at: DVec2) -> Option<f64> {
    let lanes = network.lanes.iter().filter(|l| l.junction.is_none());
    let near = lanes.map(|l| (l, l.centerline.project(at))).min_by(|a, b| a.1.1.abs().total_cmp(&b.1.1.abs()))?;
    (near.1.1.abs() < 12.0).then(|| near.0.centerline.at(near.1.0).heading_rad)
}

/// Who stands in a bay, if it is free; whether somebody does. What is taken is the bay, whatever stands in it: its neighbours do not depend on it.
fn park(assembly: &mut TownAssembly<'_>, bay: &ParkingBay, stream: &mut Stream) -> bool {
    let fits = |spec: &VehicleSpec| {
        f64::from(spec.length_m) <= bay.room.x - ENDS_M && f64::from(spec.width_m) <= bay.room.y - SIDES_M
    };
    let Some(model) = assembly.catalogue.choose_parked(stream, fits) else { return false };
    let variant = stream.next_u64();
    let yaw = bay.yaw + (stream.normal() * 0.015).clamp(-0.03, 0.03);
    let ahead = (stream.normal() * 0.12).clamp(-ENDS_M / 2.0, ENDS_M / 2.0);
    let is_free = assembly.occupied.try_take(bay.rect());
    if is_free {
        let at = bay.at + (unit(yaw) * ahead).extend(0.0);
        let pitch_rad = endless_world::math::atan(bay.grade as f32);
        let pose = Pose { pitch_rad, ..Pose::level(at.as_vec3(), yaw as f32) };
        assembly.parked.push(ParkedVehicle { vehicle: VehicleRef { model, variant }, pose });
    }
    is_free
}
