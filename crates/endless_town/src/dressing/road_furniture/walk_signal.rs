//! Signals for those who cross: at both ends of each crossing that has some, each facing the other end.

use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::dressing::road_furniture::post::RoadsidePosts;
use endless_asset::Prop;
use endless_world::math::f64::atan2;
use glam::{DVec2, DVec3};

/// From the kerb to the pole, and from the edge of the crossing to it, metres.
const BEHIND_M: [f64; 2] = [0.6, 1.2];
const ASIDE_M: f64 = 0.35;
const HALF: DVec2 = DVec2::splat(0.15);

/// Puts them where there is room.
pub(crate) fn add(assembly: &mut TownAssembly<'_>, posts: &RoadsidePosts<'_>) {
    for crossing in &posts.map.network.crossings {
        let Some(signal) = crossing.signal else { continue };
        let [a, b] = crossing.ends.map(DVec3::truncate);
        for (end, other) in [(a, b), (b, a)] {
            let across = (other - end).normalize_or(DVec2::X);
            let aside = crossing.width_m / 2.0 + ASIDE_M;
            let places = BEHIND_M
                .iter()
                .flat_map(|&behind| [1.0, -1.0].map(|side| end - across * behind + across.perp() * (side * aside)));
            for at in places {
                let level = crossing.ends[0].z;
                let height = posts.pavement.height(at, level + 1.0).filter(|z| (z - level).abs() < 1.0);
                let Some(z) = height.filter(|_| !posts.pavement.is_carriageway(at)) else { continue };
                let spot = PropPose { z, ..PropPose::new(at, atan2(across.y, across.x)) };
                if assembly.put(Prop::WalkSignal, spot, HALF, Some(signal)) {
                    break;
                }
            }
        }
    }
}
