//! Rails or bollards at the corners of streets, between those who walk and those who drive.

use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::pavement::crossing;
use crate::dressing::road_furniture::post::RoadsidePosts;
use endless_asset::Prop;
use endless_road::Lane;
use glam::DVec2;

/// They begin and end this far from the end of a lane, metres.
const FROM_M: f64 = 2.5;
const TO_M: [f64; 2] = [8.0, 20.0];
/// Distance of their middles: along, and outside the carriageway.
const RAIL_M: f64 = 2.0;
const BOLLARD_M: f64 = 1.7;
const BEYOND_M: f64 = 0.32;
/// Nothing stands this near to a crossing, metres.
const CROSSING_M: f64 = 0.7;
/// Share of corners, and most pieces of a map.
const CORNERS: f64 = 0.65;
const MOST: usize = 900;

/// Puts guards of a kind along the kerbs at both ends of streets.
pub(crate) fn add(assembly: &mut TownAssembly<'_>, posts: &RoadsidePosts<'_>, guard: Prop) {
    let rail = guard == Prop::KerbRail;
    let (step, half) = if rail { (RAIL_M, DVec2::new(0.97, 0.06)) } else { (BOLLARD_M, DVec2::splat(0.12)) };
    let mut placed = 0;
    for (i, lane) in posts.kerb_lanes() {
        let mut stream = assembly.stream(34_000_000 + i as u64);
        let length = lane.centerline.length();
        for at_start in [true, false] {
            let guarded = stream.chance(CORNERS);
            let reach = stream.range_f64(TO_M[0], TO_M[1]).min(0.45 * length);
            if !guarded || placed > MOST {
                continue;
            }
            for k in 0..((reach - FROM_M) / step).max(0.0) as usize {
                let along = FROM_M + (k as f64 + 0.5) * step;
                let s = if at_start { along } else { length - along };
                placed += usize::from(add_piece(assembly, posts, (lane, s), guard, half));
            }
        }
    }
}

/// One piece; whether it has room.
fn add_piece(
    assembly: &mut TownAssembly<'_>,
    posts: &RoadsidePosts<'_>,
    (lane, s): (&Lane, f64),
    guard: Prop,
    half: DVec2,
) -> bool {
    let verge = posts.verge(lane, s, posts.side(), BEYOND_M).filter(|v| v.walk);
    let Some(verge) = verge.filter(|v| posts.pavement.at(v.at).next().is_some()) else { return false };
    if posts.map.network.crossings.iter().any(|c| crossing::is_near(c, verge.at, CROSSING_M + half.x)) {
        return false;
    }
    let spot = PropPose { z: verge.z, ..PropPose::new(verge.at, lane.centerline.at(s).heading_rad) };
    assembly.put(guard, spot, half, None)
}
