//! Moving objects in mirror reflections of static surfaces.

use super::moving_hits::MovingHits;
use super::row::PixelRow;
use super::still_pixel::StillPixel;
use super::tile::TILE;
use crate::accel::Ray;
use crate::sampling::SAMPLES;
use crate::shade::{SceneHit, Tracer, mirror_footprint, shade_hit, shade_hit8};
use glam::Vec3A;

/// The light of each sample's mirror that shows something that moves, fog included.
pub(super) type MirroredLight = [Option<Vec3A>; SAMPLES];

/// The mirrors of a pixel, a sample at a time: the oracle of [`mirrored_row`].
pub(super) fn mirrored(
    tracer: &Tracer<'_>,
    still: &StillPixel<'_>,
    rays: &[Ray; SAMPLES],
    found: &MovingHits,
    pixel_angle: f32,
) -> MirroredLight {
    std::array::from_fn(|s| {
        let (hit, mirror) = (found.mirrored[s]?, still.mirror(s)?);
        let ray = mirror.ray(&still.facet(&rays[s], s));
        let footprint = mirror_footprint(still.distances[s], mirror.roughness(), pixel_angle);
        Some(mirror.weight() * shade_hit(tracer, &ray, Some(&SceneHit { hit, moving: true }), footprint))
    })
}

/// Those of a row of pixels; of pixels that something covers wholly, none.
pub(super) fn mirrored_row(
    tracer: &Tracer<'_>,
    row: &PixelRow<'_>,
    pixel_angle: f32,
) -> [MirroredLight; TILE as usize] {
    let mut light = [[None; SAMPLES]; TILE as usize];
    let mut asked = [(0, 0); SAMPLES * TILE as usize];
    let mut count = 0;
    for (i, found) in row.found.iter().enumerate() {
        if found.mirrored.iter().all(Option::is_none) || found.primary.iter().all(Option::is_some) {
            continue;
        }
        for s in (0..SAMPLES).filter(|&s| found.mirrored[s].is_some()) {
            asked[count] = (i, s);
            count += 1;
        }
    }
    for asked in asked[..count].chunks(8) {
        let mut rays = [Ray::NONE; 8];
        let (mut struck, mut weights, mut footprints) = ([None; 8], [Vec3A::ZERO; 8], [0.0; 8]);
        for (lane, &(i, s)) in asked.iter().enumerate() {
            let still = row.still(i);
            let Some(mirror) = still.mirror(s) else { continue };
            rays[lane] = mirror.ray(&still.facet(&row.ray(i, s), s));
            struck[lane] = row.found[i].mirrored[s].map(|hit| SceneHit { hit, moving: true });
            weights[lane] = mirror.weight();
            footprints[lane] = mirror_footprint(still.distances[s], mirror.roughness(), pixel_angle);
        }
        let active = ((1u16 << asked.len()) - 1) as u8;
        let shown = shade_hit8(tracer, &rays, &struck, active, &footprints);
        for (lane, &(i, s)) in asked.iter().enumerate() {
            light[i][s] = Some(weights[lane] * shown[lane]);
        }
    }
    light
}
