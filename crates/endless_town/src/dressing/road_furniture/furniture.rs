//! Benches, bins and the rest along sidewalks, and wires' poles beside quiet roads.

use crate::camera::occludes_view;
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::road_furniture::post::{RoadsidePosts, RoadsideSpot};
use crate::dressing::road_furniture::wire::hang;
use crate::geometry::Rect;
use endless_asset::Prop;
use endless_road::Lane;
use endless_scene::MeshBuilder;
use endless_world::CameraSite;
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// What stands at the kerb: half sizes, share, and turn from facing the road.
const PIECES: &[(Prop, [f64; 2], f64, f64)] = &[
    (Prop::Bench, [0.42, 0.95], 1.0, PI),
    (Prop::Bin, [0.3, 0.3], 1.4, 0.0),
    (Prop::Hydrant, [0.25, 0.25], 0.7, 0.0),
    (Prop::PostBox, [0.35, 0.35], 0.35, PI),
    (Prop::Bollard, [0.15, 0.15], 1.0, 0.0),
    (Prop::Planter, [0.4, 0.8], 0.7, 0.0),
    (Prop::BikeRack, [0.5, 0.4], 0.8, FRAC_PI_2),
    (Prop::Cabinet, [0.35, 0.6], 0.6, PI),
    (Prop::ParkingMeter, [0.2, 0.2], 0.5, PI),
    (Prop::PayStation, [0.25, 0.3], 0.2, PI),
    (Prop::NewsBox, [0.3, 0.75], 0.2, PI),
    (Prop::BusStop, [0.2, 0.3], 0.3, FRAC_PI_2),
    (Prop::WheelieBins, [0.45, 1.05], 0.5, PI),
    (Prop::RubbishBags, [0.55, 0.6], 0.35, 0.0),
    (Prop::SandwichBoard, [0.3, 0.35], 0.3, FRAC_PI_2),
    (Prop::BikeStand, [0.4, 1.2], 0.25, 0.0),
    (Prop::Charger, [0.25, 0.35], 0.2, 0.0),
    (Prop::CityLight, [0.2, 0.7], 0.25, FRAC_PI_2),
    (Prop::DrinkingFountain, [0.3, 0.3], 0.08, PI),
];
/// Roads at least this fast have guard rails, m/s; rails stand this far outside them, a piece this long, metres.
const RAILED_FROM_MPS: f64 = 24.0;
const RAIL_BEYOND_M: f64 = 0.9;
const RAIL_M: f64 = 4.0;
/// Most pieces of a map.
const MOST: usize = 1200;
/// Distance between utility poles, metres.
const POLES_M: f64 = 38.0;

pub(crate) fn add(
    assembly: &mut TownAssembly<'_>,
    mesh: &mut MeshBuilder,
    posts: &RoadsidePosts<'_>,
    sites: &[CameraSite],
) {
    let weights: Vec<f64> = PIECES.iter().map(|p| p.2).collect();
    let crossings: Vec<DVec2> = posts.map.network.crossings.iter().flat_map(|c| c.ends).map(DVec3::truncate).collect();
    let mut placed = 0;
    for (i, lane) in posts.kerb_lanes() {
        let mut stream = assembly.stream(30_000 + i as u64);
        let length = lane.centerline.length();
        let mut s = stream.range_f64(3.0, 14.0);
        while s < length - 3.0 && placed < MOST {
            let (prop, half, _, turn) = PIECES[stream.weighted(&weights)];
            let verge = posts.verge(lane, s, posts.side(), 0.7);
            let heading = lane.centerline.at(s).heading_rad;
            s += stream.range_f64(7.0, 24.0);
            // Asphalt between roads is paved, too, where ramps part.
            let walked = |v: &RoadsideSpot| v.walk && posts.pavement.at(v.at).next().is_some();
            let Some(verge) = verge.filter(walked) else { continue };
            if crossings.iter().any(|c| c.distance(verge.at) < 4.0) {
                continue;
            }
            let yaw = heading - posts.side() * FRAC_PI_2 + turn;
            let spot = PropPose { z: verge.z, ..PropPose::new(verge.at, yaw) };
            placed += usize::from(assembly.put(prop, spot, DVec2::from_array(half), None));
        }
    }
    add_poles(assembly, mesh, posts, sites);
    add_guard_rails(assembly, posts);
}

/// Guard rails along both sides of fast roads.
fn add_guard_rails(assembly: &mut TownAssembly<'_>, posts: &RoadsidePosts<'_>) {
    let fast = |l: &&Lane| l.junction.is_none() && l.speed_limit_mps >= RAILED_FROM_MPS;
    for lane in posts.map.network.lanes.iter().filter(fast) {
        let length = lane.centerline.length();
        let sides = [(-1.0, lane.right.is_none()), (1.0, lane.left.is_none())];
        for (side, _) in sides.into_iter().filter(|s| s.1) {
            for k in 0..(length / RAIL_M) as usize {
                let s = (k as f64 + 0.5) * RAIL_M;
                let Some(verge) = posts.verge(lane, s, side, RAIL_BEYOND_M).filter(|v| !v.walk) else { continue };
                // Its face looks at the road.
                let heading = lane.centerline.at(s).heading_rad;
                let yaw = if side < 0.0 { heading + PI } else { heading };
                let spot = PropPose { z: verge.z, ..PropPose::new(verge.at, yaw) };
                assembly.put(Prop::GuardRail, spot, DVec2::new(RAIL_M / 2.0 - 0.05, 0.12), None);
            }
        }
    }
}

/// Wooden poles with wires, along roads without sidewalks, or along all quiet ones where that is the custom.
fn add_poles(assembly: &mut TownAssembly<'_>, mesh: &mut MeshBuilder, posts: &RoadsidePosts<'_>, sites: &[CameraSite]) {
    for lane in posts.map.network.lanes.iter().filter(|l| l.junction.is_none() && posts.is_outermost(l)) {
        let length = lane.centerline.length();
        // One side of the road is enough: that of the lanes that lead north or east.
        let way = crate::geometry::unit(lane.centerline.at(length / 2.0).heading_rad);
        let least = if posts.preset.wires { 16.0 } else { POLES_M };
        if way.x + way.y < 0.0 || length < least || lane.speed_limit_mps > 25.0 {
            continue;
        }
        let step = if posts.preset.wires { 26.0 } else { POLES_M };
        let count = (length / step).floor().max(1.0);
        let mut last: Option<(f64, DVec3)> = None;
        for k in 0..=count as usize {
            let s = (length * k as f64 / count).clamp(1.5, length - 1.5);
            let beyond = if posts.preset.wires { 0.35 } else { 2.2 };
            let verge = posts.verge(lane, s, posts.side(), beyond);
            let Some(verge) = verge.filter(|v| posts.preset.wires || !v.walk) else { continue };
            let clear = !occludes_view(sites, verge.at) && assembly.occupied.is_free(&Rect::around(verge.at, 0.3));
            let spot = PropPose { z: verge.z, ..PropPose::new(verge.at, lane.centerline.at(s).heading_rad) };
            let pole = if posts.preset.bright { Prop::CrowdedPole } else { Prop::UtilityPole };
            if !clear || !assembly.put(pole, spot, DVec2::splat(0.22), None) {
                continue;
            }
            let here = verge.at.extend(verge.z);
            if let Some((_, before)) = last.filter(|l| s - l.0 < 1.8 * step) {
                hang(mesh, sites, before, here);
            }
            last = Some((s, here));
        }
    }
}
