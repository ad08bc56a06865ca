//! Signs that no map tells of: along kerbs, before junctions, and at the noses of medians, in one country's manner.

use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::road_furniture::post::{RoadsidePosts, sign_variant};
use crate::dressing::road_furniture::sign_standard::{Codes, SignStandard};
use crate::geometry::unit;
use endless_asset::{Catalogue, Prop};
use endless_road::{Lane, TrafficControl};
use endless_world::Stream;
use glam::DVec2;
use std::f64::consts::PI;

/// From one sign to the next along a kerb, metres.
const APART_M: [f64; 2] = [28.0, 90.0];
/// Before the end of a street, metres.
const BEFORE_JUNCTION_M: [f64; 2] = [4.0, 16.0];
/// Share of streets' ends with a sign, and of medians.
const ENDS: f64 = 0.45;
const MEDIANS: f64 = 0.8;
/// From the edge of the carriageway to a post.
const BEYOND_M: f64 = 0.5;
/// From the nose of a median to its sign.
const NOSE_M: f64 = 0.9;
/// Signs on medians stand so much lower than others.
const LOWER_M: f64 = 1.45;
/// Share of medians with a beacon in place of the sign, and of those with delineators behind it: fewest and most, and how
/// far apart.
const BEACONS: f64 = 0.2;
const DELINEATED: f64 = 0.35;
const DELINEATORS: [usize; 2] = [3, 8];
const DELINEATORS_APART_M: f64 = 1.6;
const HALF: DVec2 = DVec2::splat(0.2);
/// Most signs of a map.
const MOST: usize = 700;

/// Puts them where there is room.
pub(crate) fn add(assembly: &mut TownAssembly<'_>, posts: &RoadsidePosts<'_>, standard: SignStandard) {
    let mut placed = 0;
    for (i, lane) in posts.kerb_lanes() {
        let mut stream = assembly.stream(35_000_000 + i as u64);
        let length = lane.centerline.length();
        if stream.chance(ENDS) {
            let controlled = matches!(lane.end_control, TrafficControl::Signal(_));
            let codes = if controlled { standard.before_signals() } else { standard.before_junctions() };
            let (code, back) =
                (drawn(codes, &mut stream), stream.range_f64(BEFORE_JUNCTION_M[0], BEFORE_JUNCTION_M[1]));
            placed += usize::from(back < length && beside_kerb(assembly, posts, (lane, length - back), code));
        }
        let mut s = stream.range_f64(5.0, APART_M[1]);
        while s < length - BEFORE_JUNCTION_M[1] && placed < MOST {
            let code = drawn(standard.along_kerbs(), &mut stream);
            placed += usize::from(beside_kerb(assembly, posts, (lane, s), code));
            s += stream.range_f64(APART_M[0], APART_M[1]);
        }
    }
    for (i, lane) in posts.map.network.lanes.iter().enumerate() {
        let mut stream = assembly.stream(36_000_000 + i as u64);
        if lane.junction.is_none() && stream.chance(MEDIANS) && placed < MOST {
            placed += on_median(assembly, posts, lane, standard.on_medians(), &mut stream);
        }
    }
}

fn drawn(codes: Codes, stream: &mut Stream) -> &'static str {
    let weights: Vec<f64> = codes.iter().map(|c| c.1).collect();
    codes[stream.weighted(&weights)].0
}

/// Puts up the sign of a code; whether there is such a sign, and room for it.
fn put_up(assembly: &mut TownAssembly<'_>, code: &str, spot: PropPose) -> bool {
    sign_variant(code).is_some_and(|face| assembly.put_variant((Prop::TrafficSign, face), spot, HALF))
}

/// A sign on a sidewalk, for those who drive towards it; whether it has room.
fn beside_kerb(
    assembly: &mut TownAssembly<'_>,
    posts: &RoadsidePosts<'_>,
    (lane, s): (&Lane, f64),
    code: &str,
) -> bool {
    let Some(verge) = posts.verge(lane, s, posts.side(), BEYOND_M).filter(|v| v.walk) else { return false };
    let spot = PropPose { z: verge.z, ..PropPose::new(verge.at, lane.centerline.at(s).heading_rad + PI) };
    put_up(assembly, code, spot)
}

/// What warns of a median where it begins: a low sign or a beacon, and delineators behind it; how many pieces.
fn on_median(
    assembly: &mut TownAssembly<'_>,
    posts: &RoadsidePosts<'_>,
    lane: &Lane,
    code: &str,
    stream: &mut Stream,
) -> usize {
    let Some(nose) = median_spot(posts, lane, NOSE_M) else { return 0 };
    let stands = if stream.chance(BEACONS) {
        assembly.put(Prop::Beacon, nose, HALF, None)
    } else {
        put_up(assembly, code, PropPose { z: nose.z - LOWER_M, ..nose })
    };
    let count = if stream.chance(DELINEATED) {
        stream.range_f64(DELINEATORS[0] as f64, DELINEATORS[1] as f64) as usize
    } else {
        0
    };
    let row = (1..=count).filter(|&k| {
        let spot = median_spot(posts, lane, NOSE_M + DELINEATORS_APART_M * k as f64);
        spot.is_some_and(|spot| assembly.put_variant(Catalogue::DELINEATOR, spot, HALF / 2.0))
    });
    usize::from(stands) + row.count()
}

/// A place in the median beside the innermost lane of its direction, facing those who drive towards it; `None` where there is
/// none.
fn median_spot(posts: &RoadsidePosts<'_>, lane: &Lane, s: f64) -> Option<PropPose> {
    let inner = if posts.map.left_hand { lane.right } else { lane.left };
    if inner.is_some() || lane.centerline.length() < s + NOSE_M {
        return None;
    }
    let place = lane.centerline.at(s);
    let across = unit(place.heading_rad).perp() * -posts.side();
    let at = place.position.truncate() + across * (lane.width_m / 2.0 + BEYOND_M);
    let free = [at, at + across * 0.3].into_iter().all(|p| !posts.pavement.is_carriageway(p));
    // Beyond a median others drive.
    let divides = (2..9).any(|k| posts.pavement.is_carriageway(at + across * f64::from(k)));
    let z = posts.ground(at.extend(place.position.z));
    let spot = PropPose { z, ..PropPose::new(at, place.heading_rad + PI) };
    (free && divides && (z - place.position.z).abs() < 0.6).then_some(spot)
}
