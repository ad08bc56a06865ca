//! Maize on the fields that cameras see.

use super::detail_ground::DetailGround;
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::geometry::{Rect, around, inside};
use endless_asset::Prop;
use endless_road::LandUse;
use endless_world::CameraSite;
use endless_world::math::f64::atan2;
use glam::{DVec2, Vec3};
use std::f64::consts::PI;

/// From this far a field of maize is a colour, metres; before the lens a place is left free.
const SEEN_M: [f64; 2] = [4.0, 170.0];
/// Side of a block of plants, metres.
const BLOCK_M: f64 = 4.0;

/// Plants blocks of maize that look alike to every camera that sees them.
pub(crate) fn add(assembly: &mut TownAssembly<'_>, ground: &DetailGround, sites: &[CameraSite]) {
    let stream = assembly.stream(24_000);
    for (number, field) in ground.areas.of(LandUse::Farmland).enumerate() {
        let stream = stream.fork(number as u64);
        let rect = around(&field.outline);
        let (nx, ny) = ((2.0 * rect.half.x / BLOCK_M) as i64, (2.0 * rect.half.y / BLOCK_M) as i64);
        for i in 0..nx * ny {
            let step = DVec2::new((i % nx) as f64 + 0.5, (i / nx) as f64 + 0.5) * BLOCK_M - rect.half;
            let at = rect.centre + rect.axis * step.x + rect.axis.perp() * step.y;
            let is_seen = sites.iter().any(|site| {
                let [x, y, _] = site.position.map(f64::from);
                (SEEN_M[0]..SEEN_M[1]).contains(&at.distance(DVec2::new(x, y)))
            });
            if !is_seen {
                continue;
            }
            let block = Rect { centre: at, half: DVec2::splat(BLOCK_M / 2.0), axis: rect.axis };
            let grows = |&c: &DVec2| inside(&field.outline, c) && !ground.pavement.is_near(c, 2.5);
            if block.corners().iter().all(grows) && assembly.occupied.is_free(&block) {
                let mut stream = stream.fork(i as u64);
                let yaw = atan2(rect.axis.y, rect.axis.x) + if stream.chance(0.5) { 0.0 } else { PI };
                let scale = Vec3::new(1.0, 1.0, stream.range_f32(0.92, 1.06));
                assembly.place(Prop::Corn, PropPose { at, z: ground.land.height(at), yaw, scale }, None);
            }
        }
    }
}
