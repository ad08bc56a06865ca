//! Ground: asphalt, paint on it, slabs, kerbs, concrete, lawn, earth.

use super::noise_batch::{Asked, NoiseBatch};
use super::{Bsdf, noise};
use crate::scene::SurfaceInteraction;
use endless_world::ClassTag;
use endless_world::math::UnfusedVec3A;
use endless_world::math::smoothstep;
use glam::{IVec2, Vec2, Vec3A};

fn plan(point: &SurfaceInteraction<'_>) -> Vec2 {
    Vec2::new(point.position.x, point.position.y)
}

/// 1 on a line `width` wide around `distance` = 0, blurred by the footprint.
fn line(distance: f32, width: f32, footprint: f32) -> f32 {
    let blur = footprint.max(0.002);
    let coverage = (width / (width + blur)).min(1.0);
    (1.0 - smoothstep(width * 0.5, width * 0.5 + blur, distance)) * coverage
}

/// A line along the borders of cells of a size, told by the distances of the two nearest feature points in cells: the
/// border lies half as far away as the two differ.
fn border_line(first: f32, second: f32, cell_m: f32, width: f32, footprint: f32) -> f32 {
    line((second - first) * 0.5 * cell_m, width, footprint)
}

/// Brightness of asphalt at a place, around 1: mixes, patches, cracks, tyre tracks, oil.
fn asphalt_tone(p: Vec2, uv: Vec2, footprint: f32) -> f32 {
    let mut batch = NoiseBatch::new(footprint);
    let broad = batch.filtered_fbm2(p, 11.0, 4);
    let mottle = batch.filtered_fbm2(p + 70.0, 0.6, 3);
    let grain = batch.filtered_fbm2(p, 0.02, 2);
    let bleached = batch.filtered_fbm2(p + 900.0, 85.0, 2);
    let stain = batch.filtered_fbm2(p + 40.0, 2.4, 3);
    let shift = [5, 6].map(|salt| batch.value2(p * 0.05, salt));
    let lateral = uv.y;
    let in_lane = lateral.abs() < 2.2;
    let traffic = match in_lane {
        true => [
            batch.filtered_fbm2(p, 0.9, 3),
            // Whatever drops from vehicles is drawn out along the lane.
            batch.filtered_fbm2(Vec2::new(uv.x / 40.0, lateral), 0.55, 3),
        ],
        // Where traffic crosses: rubber and oil in smears.
        false => [
            batch.filtered_fbm2(p * Vec2::new(0.45, 1.0), 1.4, 3),
            batch.filtered_fbm2(p * Vec2::new(1.0, 0.45) + 31.0, 1.4, 3),
        ],
    };
    let cracks =
        (footprint < 0.15).then(|| (batch.value2(p * 0.11, 9), [11, 12].map(|salt| batch.value2(p * 1.7, salt))));
    let sealed = (footprint < 0.3).then(|| {
        let wander = [14, 15].map(|salt| batch.value2(p * 0.4, salt));
        (wander, [16, 17].map(|salt| batch.value2(p * 1.9, salt)))
    });
    let found = batch.found();
    let at = |[x, y]: [Asked; 2]| Vec2::new(found.of(x), found.of(y));
    let mottle = found.of(mottle);
    let mut tone = 1.0 + 0.20 * found.of(broad) + 0.07 * mottle + 0.55 * found.of(grain);
    // Sun and traffic bleach bitumen over the years: whole stretches are of one age.
    tone *= 1.0 + 0.40 * found.of(bleached);
    // Repairs: rectangles of newer asphalt with a tar seam around.
    let block = Vec2::new(5.3, 3.1);
    let shifted = p + at(shift) * 0.4;
    let cell = noise::corner_of(shifted / block);
    let id = cell.as_ivec2();
    if noise::cell2(id, 71) < 0.16 {
        let local = (shifted / block - cell) * block;
        let low = Vec2::new(noise::cell2(id, 72), noise::cell2(id, 73)) * 1.2 + 0.15;
        let high = block - Vec2::new(noise::cell2(id, 74), noise::cell2(id, 75)) * 1.2 - 0.15;
        let inside = (local - low).min(high - local).min_element();
        let newer = smoothstep(-footprint, footprint.max(0.01), inside);
        // Most repairs are darker than the old road; some have bleached.
        tone *= 1.0 - newer * (0.36 * noise::cell2(id, 76) - 0.06);
        tone *= 1.0 - 0.45 * line((inside - 0.02).abs(), 0.05, footprint);
    }
    // Cracks along the borders of a cell pattern, where the surface is old.
    if let Some((old, wobble)) = cracks {
        let old = smoothstep(0.05, 0.35, found.of(old));
        if old > 0.0 {
            let (first, second, _) = noise::cells2((p + at(wobble) * 0.22) / 1.9, 13);
            tone *= 1.0 - 0.5 * old * border_line(first, second, 1.9, 0.008, footprint);
        }
    }
    // Cracks that were sealed: broad bands of tar that wander along and across.
    if let Some((wander, wobble)) = sealed {
        let (first, second, id) = noise::cells2((p + (at(wander) * 1.1 + at(wobble) * 0.2)) / 7.0, 18);
        if id < 0.55 {
            tone *= 1.0 - 0.42 * border_line(first, second, 7.0, 0.035, footprint);
        }
    }
    let traffic = traffic.map(|asked| found.of(asked));
    if in_lane {
        // Wheel paths polish and darken; oil drips between them.
        let path = 1.0 - smoothstep(0.15, 0.55, (lateral.abs() - 0.78).abs());
        let drip = 1.0 - smoothstep(0.05, 0.45, lateral.abs());
        let spots = smoothstep(0.1, 0.7, traffic[0] + 0.3);
        tone *= 1.0 - 0.20 * path * (0.75 + 0.5 * mottle) - 0.20 * drip * spots;
        tone *= 1.0 + 0.22 * traffic[1];
        // The joint where two lanes were laid beside each other.
        tone *= 1.0 - 0.18 * line((lateral.abs() - 1.72).abs(), 0.04, footprint);
    } else {
        tone *= 0.96 - 0.07 * smoothstep(0.0, 0.6, traffic[0] + traffic[1]);
    }
    let stain = smoothstep(0.42, 0.62, found.of(stain));
    tone * (1.0 - 0.12 * stain)
}

/// The colour with a share of its saturation taken away.
pub(super) fn muted(color: Vec3A, share: f32) -> Vec3A {
    color.lerp_unfused(Vec3A::splat(color.dot(Vec3A::new(0.2126, 0.7152, 0.0722))), share)
}

fn bumped(normal: Vec3A, p: Vec2, wavelength: f32, strength: f32, footprint: f32) -> Vec3A {
    let keep = (wavelength / footprint.max(1e-4) * 0.5 - 0.5).clamp(0.0, 1.0) * strength;
    if keep == 0.0 {
        return normal;
    }
    let q = p / wavelength;
    (normal + Vec3A::new(noise::value2(q, 21), noise::value2(q, 22), 0.0) * keep).normalize()
}

pub(super) fn asphalt(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let p = plan(point);
    let tone = asphalt_tone(p, point.uv, footprint);
    let mut bsdf = Bsdf::matte(base * tone, bumped(point.normal, p, 0.03, 0.10, footprint));
    bsdf.roughness = 0.84;
    bsdf.specular = 0.022;
    bsdf
}

pub(super) fn road_paint(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let p = plan(point);
    let tone = asphalt_tone(p, Vec2::new(0.0, 9.0), footprint);
    let wear = noise::filtered_fbm2(p, 0.7, 5, footprint) + 0.25 * noise::value2(p * 0.2, 33);
    let gone = smoothstep(0.18, 0.42, wear) * 0.75;
    let dirty = base * (0.86 + 0.14 * tone) * (1.0 - 0.12 * noise::value2(p * 0.9, 35).max(0.0));
    let mut bsdf = Bsdf::matte(dirty.lerp_unfused(Vec3A::splat(0.125) * tone, gone), point.normal);
    bsdf.roughness = 0.7;
    bsdf
}

pub(super) fn paving(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let p = plan(point);
    const SLAB: Vec2 = Vec2::new(0.6, 0.4);
    // Half-bond: every other row shifted by half a slab.
    let row = (p.y / SLAB.y).floor();
    let shifted = Vec2::new(p.x / SLAB.x + 0.5 * (row - 2.0 * (row * 0.5).floor()), p.y / SLAB.y);
    let cell = noise::corner_of(shifted);
    let local = (shifted - cell) * SLAB;
    let edge = local.min(SLAB - local).min_element();
    let visible = (0.5 / footprint.max(0.01) * 0.25).min(1.0);
    let slab = 0.84 + (noise::cell2(cell.as_ivec2(), 41) - 0.5) * 0.26 * visible;
    let joint = line(edge, 0.012, footprint);
    let mut batch = NoiseBatch::new(footprint);
    let stains = [batch.filtered_fbm2(p, 3.1, 5), batch.filtered_fbm2(p, 14.0, 2)];
    let found = batch.found();
    let stain = 1.0 + 0.34 * found.of(stains[0]) + 0.16 * found.of(stains[1]);
    let gum = {
        let (first, _, id) = noise::cells2(p / 0.8, 43);
        if id < 0.25 && footprint < 0.05 { 0.35 * (1.0 - smoothstep(0.02, 0.035, first * 0.8)) } else { 0.0 }
    };
    Bsdf::matte(base * (slab * stain * (1.0 - 0.5 * joint) * (1.0 - gum)), point.normal)
}

/// Setts of a hand's width, worn round, with dark joints.
pub(super) fn cobbles(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    const SETT_M: f32 = 0.13;
    let p = plan(point);
    let (first, second, id) = noise::cells2(p / SETT_M, 53);
    let joint = border_line(first, second, SETT_M, 0.018, footprint);
    // Stones differ as far as a pixel still tells them apart.
    let visible = (0.12 / footprint.max(0.01)).min(1.0);
    let stone = 0.92 + (id - 0.5) * 0.5 * visible;
    let broad =
        1.0 + 0.22 * noise::filtered_fbm2(p, 6.0, 4, footprint) + 0.16 * noise::filtered_fbm2(p, 1.1, 3, footprint);
    Bsdf::matte(base * (stone * broad * (1.0 - 0.55 * joint)), point.normal)
}

pub(super) fn kerb(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let p = plan(point);
    let along = p.x * point.normal.y.abs().max(0.3) + p.y * point.normal.x.abs().max(0.3);
    let joint = line((along - (along + 0.5).floor()).abs(), 0.015, footprint);
    let grime = 0.82 + 0.36 * noise::filtered_fbm2(p, 1.3, 5, footprint);
    let splash = 0.62 + 0.38 * smoothstep(0.0, 0.14, point.position.z);
    Bsdf::matte(base * (grime * splash * (1.0 - 0.45 * joint)), point.normal)
}

/// Brightness of a yard at a place, around 1, and the share of moss: concrete cast in bays, some of them broken up and
/// cast anew, with cracks, and dirt and moss in the joints.
fn yard_tone(p: Vec2, footprint: f32) -> (f32, f32) {
    const BAY_M: Vec2 = Vec2::new(4.2, 3.4);
    let cell = noise::corner_of(p / BAY_M);
    let id = cell.as_ivec2();
    let local = p - cell * BAY_M;
    let edge = local.min(BAY_M - local).min_element();
    let renewed = noise::cell2(id, 61);
    let cast = 1.0
        + (noise::cell2(id, 62) - 0.5) * 0.14
        + if renewed < 0.07 {
            0.22
        } else if renewed < 0.16 {
            -0.20
        } else {
            0.0
        };
    let mut batch = NoiseBatch::new(footprint);
    let wobble = [63, 64].map(|salt| batch.value2(p * 0.9, salt));
    let grime = batch.filtered_fbm2(p + 19.0, 0.8, 3);
    let worn = batch.filtered_fbm2(p * Vec2::new(1.0, 0.4) + 23.0, 3.2, 3);
    let overgrown = batch.filtered_fbm2(p + 140.0, 4.5, 3);
    let found = batch.found();
    let wobble = Vec2::from_array(wobble.map(|asked| found.of(asked))) * 0.35;
    let (first, second, crack) = noise::cells2((p + wobble) / 3.7, 65);
    let cracked = if crack < 0.3 { border_line(first, second, 3.7, 0.007, footprint) } else { 0.0 };
    let joint = line(edge, 0.016, footprint);
    let grime = (1.0 - smoothstep(0.0, 0.45, edge)) * (0.5 + 0.5 * found.of(grime));
    let worn = smoothstep(0.1, 0.55, found.of(worn));
    let overgrown = smoothstep(-0.1, 0.3, found.of(overgrown));
    let tone = cast * (1.0 - 0.5 * joint) * (1.0 - 0.45 * cracked) * (1.0 - 0.16 * grime) * (1.0 - 0.16 * worn);
    (tone, line(edge, 0.05, footprint) * overgrown)
}

pub(super) fn concrete(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    if point.material.tag == ClassTag::Ground && point.geometric_normal.z > 0.9 {
        let p = plan(point);
        let (bays, moss) = yard_tone(p, footprint);
        let [stain, cloudy, _] = concrete_noise(p, footprint);
        let tone = 0.92 + 0.20 * cloudy - 0.12 * smoothstep(0.25, 0.6, stain);
        let color = (base * (tone * bays)).lerp_unfused(Vec3A::new(0.055, 0.075, 0.03), 0.7 * moss);
        return Bsdf::matte(color, point.normal);
    }
    let p = plan(point) + point.position.z * Vec2::new(0.37, 0.91);
    let [stain, cloudy, broad] = concrete_noise(p, footprint);
    let tone = 0.86 + 0.26 * cloudy + 0.18 * broad - 0.16 * smoothstep(0.25, 0.6, stain);
    Bsdf::matte(base * tone, point.normal)
}

/// Of stains, of unevenness within metres and over more of them.
fn concrete_noise(p: Vec2, footprint: f32) -> [f32; 3] {
    let mut batch = NoiseBatch::new(footprint);
    let asked =
        [batch.filtered_fbm2(p + 57.0, 1.9, 4), batch.filtered_fbm2(p, 2.7, 6), batch.filtered_fbm2(p + 11.0, 9.0, 3)];
    let found = batch.found();
    asked.map(|asked| found.of(asked))
}

pub(super) fn grass(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let p = plan(point);
    let mut batch = NoiseBatch::new(footprint);
    let asked = [
        batch.filtered_fbm2(p, 7.0, 4),
        batch.filtered_fbm2(p, 0.35, 2),
        batch.filtered_fbm2(p + 7.0, 0.13, 2),
        batch.filtered_fbm2(p * Vec2::new(1.0, 0.6), 0.05, 3),
        batch.filtered_fbm2(p + 90.0, 5.0, 3),
        batch.filtered_fbm2(p + 210.0, 3.3, 4),
    ];
    let found = batch.found();
    let [broad, tuft, clump, blades, dry, worn] = asked.map(|asked| found.of(asked));
    let dry = smoothstep(0.1, 0.6, dry + 0.15 * tuft);
    let worn = smoothstep(0.28, 0.62, worn + 0.1 * tuft);
    let green = muted(base, 0.22) * (0.94 + 0.34 * broad + 0.35 * tuft + 0.75 * clump + 0.7 * blades);
    let straw = Vec3A::new(0.20, 0.17, 0.085) * (1.0 + 0.4 * blades + 0.3 * tuft);
    let earth = Vec3A::new(0.115, 0.09, 0.065) * (1.0 + 0.5 * tuft);
    let color = green.lerp_unfused(straw, dry * 0.6).lerp_unfused(earth, worn * 0.6);
    let mut bsdf = Bsdf::matte(color, bumped(point.normal, p, 0.10, 0.8, footprint));
    bsdf.roughness = 0.8;
    bsdf
}

pub(super) fn loose(point: &SurfaceInteraction<'_>, base: Vec3A, footprint: f32) -> Bsdf {
    let p = plan(point);
    let tone = 1.0 + 0.35 * noise::filtered_fbm2(p, 2.0, 7, footprint);
    let (_, _, id) = noise::cells2(p / 0.035, 51);
    let pebble = 1.0 + (id - 0.5) * 0.5 * (0.03 / footprint.max(1e-3)).min(1.0);
    let tint = noise::tint(IVec2::new((p.x / 3.0) as i32, 0), 52, 0.02);
    Bsdf::matte(base * tint * (tone * pebble), bumped(point.normal, p, 0.06, 0.4, footprint))
}
