//! What people have put into a street that no plan has: vendors, works, rubbish, scaffolds, laundry.

use crate::camera::occludes_view;
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::built_up::growth::FrontYard;
use crate::dressing::preset::StreetLife;
use crate::dressing::road_furniture::post::RoadsidePosts;
use endless_asset::Prop;
use endless_road::Lane;
use endless_world::{CameraSite, Stream};
use glam::{DVec2, DVec3, Vec3};
use std::f64::consts::{FRAC_PI_2, PI};

/// A prop, its half sizes, its share, and its turn from facing the road.
type Piece = (Prop, [f64; 2], f64, f64);

const VENDORS: &[Piece] = &[
    (Prop::FoodCart, [0.9, 0.6], 3.0, -FRAC_PI_2),
    (Prop::VendorBlanket, [0.6, 0.9], 2.0, 0.0),
    (Prop::MarketStall, [1.1, 1.4], 1.0, 0.0),
    (Prop::CafeTable, [0.7, 0.7], 1.5, 0.0),
    (Prop::CrateStack, [0.4, 0.4], 2.0, 0.0),
    (Prop::SandwichBoard, [0.3, 0.35], 1.5, FRAC_PI_2),
    (Prop::HandCart, [0.9, 0.5], 1.0, FRAC_PI_2),
];
const WORKS: &[Piece] = &[
    (Prop::SandHeap, [1.2, 1.2], 2.0, 0.0),
    (Prop::BrickPallet, [0.6, 0.6], 1.5, 0.0),
    (Prop::BuildingStock, [1.1, 0.7], 1.5, FRAC_PI_2),
    (Prop::Skip, [1.8, 0.9], 0.8, FRAC_PI_2),
    (Prop::Pallets, [0.6, 0.6], 1.0, 0.0),
    (Prop::Cone, [0.2, 0.2], 3.0, 0.0),
    (Prop::Drum, [0.3, 0.3], 1.5, 0.0),
    (Prop::WaterBarrier, [1.0, 0.3], 2.0, FRAC_PI_2),
    (Prop::Barricade, [0.3, 0.7], 1.0, 0.0),
    (Prop::WorksBarrier, [0.3, 1.0], 1.5, 0.0),
];
const RUBBISH: &[Piece] = &[
    (Prop::RubbishBags, [0.55, 0.6], 3.0, 0.0),
    (Prop::WheelieBins, [0.45, 1.05], 2.0, PI),
    (Prop::Dumpster, [0.7, 1.0], 1.0, PI),
    (Prop::CrateStack, [0.4, 0.4], 1.0, 0.0),
    (Prop::Pallets, [0.6, 0.6], 0.7, 0.0),
];
/// Streets are gone along in steps of this length, metres; each has a group at most.
const STEP_M: f64 = 18.0;
/// A group has so many pieces, this far apart, metres.
const PIECES: [usize; 2] = [2, 7];
const APART_M: [f64; 2] = [0.9, 2.2];
/// Most groups of each kind in a town.
const MOST: usize = 260;
/// Nothing is put this near to a crossing's end, metres.
const CROSSING_M: f64 = 4.0;
/// A bay of a scaffold along the wall and away from it, and a line of laundry, metres.
const BAY_M: [f64; 2] = [2.5, 1.2];
const LAUNDRY_M: f64 = 4.0;

/// Puts it along the streets and about the houses of a town.
pub(crate) fn add(
    assembly: &mut TownAssembly<'_>,
    posts: &RoadsidePosts<'_>,
    yards: &[FrontYard],
    sites: &[CameraSite],
    life: StreetLife,
) {
    let groups = [(VENDORS, life.vendors), (WORKS, life.works), (RUBBISH, life.rubbish)];
    for (k, (pieces, share)) in (0..).zip(groups).filter(|(_, (_, share))| *share > 0.0) {
        add_groups(assembly, posts, sites, pieces, share, 31_000_000 + 100_000 * k);
    }
    for (i, yard) in yards.iter().enumerate() {
        let mut stream = assembly.stream(32_000_000 + i as u64);
        if stream.chance(life.scaffolds) && yard.front_m > BAY_M[1] + 0.2 {
            add_scaffold(assembly, posts, yard);
        }
        if stream.chance(life.laundry) {
            add_laundry(assembly, posts, yard, &mut stream);
        }
    }
}

/// Groups of pieces of a kind along the kerbs of streets that have sidewalks, in a share of all places.
fn add_groups(
    assembly: &mut TownAssembly<'_>,
    posts: &RoadsidePosts<'_>,
    sites: &[CameraSite],
    pieces: &[Piece],
    share: f64,
    trade: u64,
) {
    let crossings: Vec<DVec2> = posts.map.network.crossings.iter().flat_map(|c| c.ends).map(DVec3::truncate).collect();
    let weights: Vec<f64> = pieces.iter().map(|piece| piece.2).collect();
    let mut placed = 0;
    for (i, lane) in posts.kerb_lanes() {
        let mut stream = assembly.stream(trade + i as u64);
        let mut s = stream.range_f64(2.0, STEP_M);
        while s < lane.centerline.length() - 4.0 && placed < MOST {
            if stream.chance(share) {
                placed += usize::from(add_group(
                    (assembly, posts),
                    sites,
                    &crossings,
                    (lane, s),
                    (pieces, &weights),
                    &mut stream,
                ));
            }
            s += STEP_M * stream.range_f64(0.7, 1.3);
        }
    }
}

/// One group from a place on; whether any of it has room.
fn add_group(
    (assembly, posts): (&mut TownAssembly<'_>, &RoadsidePosts<'_>),
    sites: &[CameraSite],
    crossings: &[DVec2],
    (lane, from): (&Lane, f64),
    (pieces, weights): (&[Piece], &[f64]),
    stream: &mut Stream,
) -> bool {
    let count = PIECES[0] + stream.below(PIECES[1] - PIECES[0] + 1);
    let (mut s, mut any) = (from, false);
    for _ in 0..count {
        let (prop, half, _, turn) = pieces[stream.weighted(weights)];
        s += half[1] + stream.range_f64(APART_M[0], APART_M[1]);
        let beyond = half[0].max(0.35) + stream.range_f64(0.15, 0.5);
        let askew = stream.range_f64(-0.15, 0.15);
        if s > lane.centerline.length() - 3.0 {
            break;
        }
        let walked = |at: DVec2| posts.pavement.at(at).next().is_some();
        let Some(verge) = posts.verge(lane, s, posts.side(), beyond).filter(|v| v.walk && walked(v.at)) else {
            continue;
        };
        let near_crossing = crossings.iter().any(|c| c.distance(verge.at) < CROSSING_M);
        if near_crossing || half[0] > 0.8 && occludes_view(sites, verge.at) {
            continue;
        }
        let yaw = lane.centerline.at(s).heading_rad - posts.side() * FRAC_PI_2 + turn + askew;
        let spot = PropPose { z: verge.z, ..PropPose::new(verge.at, yaw) };
        any |= assembly.put(prop, spot, DVec2::from_array(half), None);
    }
    any
}

/// Bays along the whole front of a house, as many as there is room for.
fn add_scaffold(assembly: &mut TownAssembly<'_>, posts: &RoadsidePosts<'_>, yard: &FrontYard) {
    let out = -yard.rect.axis.perp();
    let front = yard.rect.centre + out * (yard.rect.half.y + BAY_M[1] / 2.0 + 0.1);
    let bays = (2.0 * yard.rect.half.x / BAY_M[0]) as usize;
    let yaw = endless_world::math::f64::atan2(out.y, out.x) - FRAC_PI_2;
    for k in 0..bays {
        let at = front + yard.rect.axis * ((k as f64 - (bays as f64 - 1.0) / 2.0) * BAY_M[0]);
        let z = posts.ground(at.extend(posts.land.height(at)));
        let half = DVec2::new(BAY_M[0] / 2.0 - 0.02, BAY_M[1] / 2.0);
        assembly.put(Prop::ScaffoldBay, PropPose { z, ..PropPose::new(at, yaw) }, half, None);
    }
}

/// Laundry beside or behind a house.
fn add_laundry(assembly: &mut TownAssembly<'_>, posts: &RoadsidePosts<'_>, yard: &FrontYard, stream: &mut Stream) {
    let back = yard.rect.axis.perp();
    let aside = yard.rect.axis * stream.range_f64(-0.4, 0.4) * yard.rect.half.x;
    let at = yard.rect.centre + back * (yard.rect.half.y + stream.range_f64(1.5, 3.0)) + aside;
    if posts.pavement.is_near(at, 1.0) {
        return;
    }
    let yaw = endless_world::math::f64::atan2(yard.rect.axis.y, yard.rect.axis.x);
    let spot = PropPose { z: posts.land.height(at), yaw, at, scale: Vec3::ONE };
    assembly.put(Prop::LaundryLine, spot, DVec2::new(LAUNDRY_M / 2.0, 0.4), None);
}
