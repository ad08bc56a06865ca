//! Ground: asphalt, paint on it, slabs, kerbs, concrete, lawn, earth.

use super::noise_questions::NoiseQuestions;
use super::per_pixel::{PerPixel, Truth, edge_distance, smoothstep, smoothstep_between};
use super::pixel_group::PixelGroup;
use super::{Bsdf, noise};
use crate::scene::SurfaceInteraction;
use endless_world::ClassTag;
use endless_world::math::UnfusedVec3A;
use glam::{IVec2, Vec3A};

/// 1 on a line `width` wide around `distance` = 0, blurred by the footprint.
#[inline]
fn line<N: PerPixel>(distance: N, width: f32, footprint: N) -> N {
    let blur = footprint.max(N::splat(0.002));
    let coverage = (N::splat(width) / (blur + width)).min(N::ONE);
    (N::ONE - smoothstep_between(N::splat(width * 0.5), blur + width * 0.5, distance)) * coverage
}

/// A line along the borders of cells of a size, told by the distances of the two nearest feature points in cells: the
/// border lies half as far away as the two differ.
#[inline]
fn border_line<N: PerPixel>(first: N, second: N, cell_m: f32, width: f32, footprint: N) -> N {
    line((second - first) * 0.5 * cell_m, width, footprint)
}

/// Brightness of asphalt at a place, around 1: mixes, patches, cracks, tyre tracks, oil.
fn asphalt_tone<N: PerPixel>(p: [N; 2], uv: [N; 2], footprint: N) -> N {
    let moved = |aside: f32| p.map(|axis| axis + aside);
    let scaled = |scale: f32| p.map(|axis| axis * scale);
    let mut batch = N::Noise::new(footprint);
    let broad = batch.fbm2(p, 11.0, 4);
    let mottle = batch.fbm2(moved(70.0), 0.6, 3);
    let grain = batch.fbm2(p, 0.02, 2);
    let bleached = batch.fbm2(moved(900.0), 85.0, 2);
    let stain = batch.fbm2(moved(40.0), 2.4, 3);
    let shift = [5, 6].map(|salt| batch.value2(scaled(0.05), salt));
    let lateral = uv[1];
    let in_lane = lateral.abs().is_below(N::splat(2.2));
    // Where traffic crosses: rubber and oil in smears. Along the lane: whatever drops from vehicles is drawn out.
    let wear = [in_lane.select(p[0], p[0] * 0.45), p[1]];
    let drawn = [in_lane.select(uv[0] / 40.0, p[0] + 31.0), in_lane.select(lateral, p[1] * 0.45 + 31.0)];
    let traffic = [
        batch.fbm2_of(wear, in_lane.select(N::splat(0.9), N::splat(1.4)), 3),
        batch.fbm2_of(drawn, in_lane.select(N::splat(0.55), N::splat(1.4)), 3),
    ];
    let (shows_cracks, shows_seals) = (footprint.is_below(N::splat(0.15)), footprint.is_below(N::splat(0.3)));
    let cracks = shows_cracks
        .anywhere()
        .then(|| (batch.value2(scaled(0.11), 9), [11, 12].map(|salt| batch.value2(scaled(1.7), salt))));
    let sealed = shows_seals.anywhere().then(|| {
        let wander = [14, 15].map(|salt| batch.value2(scaled(0.4), salt));
        (wander, [16, 17].map(|salt| batch.value2(scaled(1.9), salt)))
    });
    let found = batch.found();
    let mottle = found(mottle);
    let mut tone = found(broad) * 0.20 + 1.0 + mottle * 0.07 + found(grain) * 0.55;
    // Sun and traffic bleach bitumen over the years: whole stretches are of one age.
    tone = tone * (found(bleached) * 0.40 + 1.0);
    // Repairs: rectangles of newer asphalt with a tar seam around.
    const BLOCK_M: [f32; 2] = [5.3, 3.1];
    let shifted: [N; 2] = std::array::from_fn(|k| (p[k] + found(shift[k]) * 0.4) / BLOCK_M[k]);
    let cell = shifted.map(N::floor);
    let repaired = N::cell2(cell, 71).is_below(N::splat(0.16));
    if repaired.anywhere() {
        let local: [N; 2] = std::array::from_fn(|k| (shifted[k] - cell[k]) * BLOCK_M[k]);
        let low = [72, 73].map(|salt| N::cell2(cell, salt) * 1.2 + 0.15);
        let high = [74, 75].map(|salt| N::cell2(cell, salt) * 1.2);
        let [x, y] = [0, 1].map(|k| (local[k] - low[k]).min(N::splat(BLOCK_M[k]) - high[k] - 0.15 - local[k]));
        let inside = x.min(y);
        let newer = smoothstep_between(-footprint, footprint.max(N::splat(0.01)), inside);
        // Most repairs are darker than the old road; some have bleached.
        let mended = tone * (N::ONE - newer * (N::cell2(cell, 76) * 0.36 - 0.06));
        let mended = mended * (N::ONE - line((inside - 0.02).abs(), 0.05, footprint) * 0.45);
        tone = repaired.select(mended, tone);
    }
    // Cracks along the borders of a cell pattern, where the surface is old.
    if let Some((old, wobble)) = cracks {
        let old = smoothstep(0.05, 0.35, found(old));
        let cracked = shows_cracks.and(N::splat(0.0).is_below(old));
        if cracked.anywhere() {
            let at: [N; 2] = std::array::from_fn(|k| (p[k] + found(wobble[k]) * 0.22) / 1.9);
            let [first, second, _] = N::cells2(at, 13);
            let dark = old * 0.5 * border_line(first, second, 1.9, 0.008, footprint);
            tone = cracked.select(tone * (N::ONE - dark), tone);
        }
    }
    // Cracks that were sealed: broad bands of tar that wander along and across.
    if let Some((wander, wobble)) = sealed {
        let at: [N; 2] = std::array::from_fn(|k| (p[k] + (found(wander[k]) * 1.1 + found(wobble[k]) * 0.2)) / 7.0);
        let [first, second, id] = N::cells2(at, 18);
        let tarred = shows_seals.and(id.is_below(N::splat(0.55)));
        if tarred.anywhere() {
            let dark = border_line(first, second, 7.0, 0.035, footprint) * 0.42;
            tone = tarred.select(tone * (N::ONE - dark), tone);
        }
    }
    let traffic = traffic.map(&found);
    let untravelled = tone;
    if in_lane.anywhere() {
        // Wheel paths polish and darken; oil drips between them.
        let path = N::ONE - smoothstep(0.15, 0.55, (lateral.abs() - 0.78).abs());
        let drip = N::ONE - smoothstep(0.05, 0.45, lateral.abs());
        let spots = smoothstep(0.1, 0.7, traffic[0] + 0.3);
        tone = tone * (N::ONE - path * 0.20 * (mottle * 0.5 + 0.75) - drip * 0.20 * spots);
        tone = tone * (traffic[1] * 0.22 + 1.0);
        // The joint where two lanes were laid beside each other.
        tone = tone * (N::ONE - line((lateral.abs() - 1.72).abs(), 0.04, footprint) * 0.18);
    }
    if !in_lane.everywhere() {
        let crossed = untravelled * (N::splat(0.96) - smoothstep(0.0, 0.6, traffic[0] + traffic[1]) * 0.07);
        tone = in_lane.select(tone, crossed);
    }
    let stain = smoothstep(0.42, 0.62, found(stain));
    tone * (N::ONE - stain * 0.12)
}

/// The colour with a share of its saturation taken away.
pub(super) fn muted(color: Vec3A, share: f32) -> Vec3A {
    color.lerp_unfused(Vec3A::splat(color.dot(Vec3A::new(0.2126, 0.7152, 0.0722))), share)
}

/// What bumps of a wavelength add to a normal, along x and y, and how far they do.
#[inline]
fn bumps<N: PerPixel>(p: [N; 2], wavelength: f32, strength: f32, footprint: N) -> [N; 3] {
    let keep = ((N::splat(wavelength) / footprint.max(N::splat(1e-4))) * 0.5 - 0.5).clamped() * strength;
    if !N::splat(0.0).is_below(keep).anywhere() {
        return [N::splat(0.0); 3];
    }
    let q = p.map(|axis| axis / wavelength);
    [N::value2(q, 21), N::value2(q, 22), keep]
}

/// The normal of a surface with [`bumps`].
fn bumped(normal: Vec3A, [x, y, keep]: [f32; 3]) -> Vec3A {
    if keep == 0.0 {
        return normal;
    }
    (normal + Vec3A::new(x, y, 0.0) * keep).normalize()
}

/// Tone and bumps of asphalt.
pub(super) fn asphalt_look<G: PixelGroup>(at: &G) -> [G::Number; 4] {
    let (p, footprint) = (at.plan(), at.footprint_m());
    let [x, y, keep] = bumps(p, 0.03, 0.10, footprint);
    [asphalt_tone(p, at.uv(), footprint), x, y, keep]
}

pub(super) fn asphalt(point: &SurfaceInteraction<'_>, base: Vec3A, [tone, bumps @ ..]: [f32; 4]) -> Bsdf {
    let mut bsdf = Bsdf::matte(base * tone, bumped(point.normal, bumps));
    bsdf.roughness = 0.84;
    bsdf.specular = 0.022;
    bsdf
}

/// Tone of the asphalt below road paint, how much of the paint is gone, and how bright dirt leaves it.
pub(super) fn road_paint_look<G: PixelGroup>(at: &G) -> [G::Number; 3] {
    let (p, footprint) = (at.plan(), at.footprint_m());
    let tone = asphalt_tone(p, [0.0, 9.0].map(PerPixel::splat), footprint);
    let wear = PerPixel::filtered_fbm2(p, 0.7, 5, footprint) + PerPixel::value2(p.map(|axis| axis * 0.2), 33) * 0.25;
    let gone = smoothstep(0.18, 0.42, wear) * 0.75;
    let dirt = PerPixel::value2(p.map(|axis| axis * 0.9), 35).max(PerPixel::splat(0.0)) * 0.12;
    [tone, gone, <G::Number as PerPixel>::ONE - dirt]
}

pub(super) fn road_paint(point: &SurfaceInteraction<'_>, base: Vec3A, [tone, gone, clean]: [f32; 3]) -> Bsdf {
    let dirty = base * (0.86 + 0.14 * tone) * clean;
    let mut bsdf = Bsdf::matte(dirty.lerp_unfused(Vec3A::splat(0.125) * tone, gone), point.normal);
    bsdf.roughness = 0.7;
    bsdf
}

/// Tone of slabs.
pub(super) fn paving_look<G: PixelGroup>(at: &G) -> [G::Number; 1] {
    [paving_tone(at.plan(), at.footprint_m())]
}

fn paving_tone<N: PerPixel>(p: [N; 2], footprint: N) -> N {
    const SLAB: [f32; 2] = [0.6, 0.4];
    // Half-bond: every other row shifted by half a slab.
    let row = (p[1] / SLAB[1]).floor();
    let shifted = [p[0] / SLAB[0] + (row - (row * 0.5).floor() * 2.0) * 0.5, p[1] / SLAB[1]];
    let cell = shifted.map(N::floor);
    let edge = edge_distance(std::array::from_fn(|k| (shifted[k] - cell[k]) * SLAB[k]), SLAB);
    let visible = (N::splat(0.5) / footprint.max(N::splat(0.01)) * 0.25).min(N::ONE);
    let slab = (N::cell2(cell, 41) - 0.5) * 0.26 * visible + 0.84;
    let joint = line(edge, 0.012, footprint);
    let mut batch = N::Noise::new(footprint);
    let stains = [batch.fbm2(p, 3.1, 5), batch.fbm2(p, 14.0, 2)];
    let stains = stains.map(batch.found());
    let stain = stains[0] * 0.34 + 1.0 + stains[1] * 0.16;
    let clean = slab * stain * (N::ONE - joint * 0.5);
    let shows_gum = footprint.is_below(N::splat(0.05));
    if !shows_gum.anywhere() {
        return clean;
    }
    let [first, _, id] = N::cells2(p.map(|axis| axis / 0.8), 43);
    let gum = (N::ONE - smoothstep(0.02, 0.035, first * 0.8)) * 0.35;
    shows_gum.and(id.is_below(N::splat(0.25))).select(clean * (N::ONE - gum), clean)
}

/// Tone of setts of a hand's width, worn round, with dark joints.
pub(super) fn cobbles_look<G: PixelGroup>(at: &G) -> [G::Number; 1] {
    [cobbles_tone(at.plan(), at.footprint_m())]
}

fn cobbles_tone<N: PerPixel>(p: [N; 2], footprint: N) -> N {
    const SETT_M: f32 = 0.13;
    let [first, second, id] = N::cells2(p.map(|axis| axis / SETT_M), 53);
    let joint = border_line(first, second, SETT_M, 0.018, footprint);
    // Stones differ as far as a pixel still tells them apart.
    let visible = (N::splat(0.12) / footprint.max(N::splat(0.01))).min(N::ONE);
    let stone = (id - 0.5) * 0.5 * visible + 0.92;
    let broad = N::filtered_fbm2(p, 6.0, 4, footprint) * 0.22 + 1.0 + N::filtered_fbm2(p, 1.1, 3, footprint) * 0.16;
    stone * broad * (N::ONE - joint * 0.55)
}

/// Tone of kerb stones.
pub(super) fn kerb_look<G: PixelGroup>(at: &G) -> [G::Number; 1] {
    let (p, footprint) = (at.plan(), at.footprint_m());
    let across = [at.each(|point| point.normal.x), at.each(|point| point.normal.y)];
    [kerb_tone(p, at.each(|point| point.position.z), across, footprint)]
}

fn kerb_tone<N: PerPixel>(p: [N; 2], height: N, across: [N; 2], footprint: N) -> N {
    let [x, y] = across.map(|axis| axis.abs().max(N::splat(0.3)));
    let along = p[0] * y + p[1] * x;
    let joint = line((along - (along + 0.5).floor()).abs(), 0.015, footprint);
    let grime = N::filtered_fbm2(p, 1.3, 5, footprint) * 0.36 + 0.82;
    let splash = smoothstep(0.0, 0.14, height) * 0.38 + 0.62;
    grime * splash * (N::ONE - joint * 0.45)
}

/// Slabs, setts or kerb stones of a tone.
pub(super) fn stones(point: &SurfaceInteraction<'_>, base: Vec3A, [tone]: [f32; 1]) -> Bsdf {
    Bsdf::matte(base * tone, point.normal)
}

/// Brightness of a yard at a place, around 1, and the share of moss: concrete cast in bays, some of them broken up and
/// cast anew, with cracks, and dirt and moss in the joints.
fn yard_tone<N: PerPixel>(p: [N; 2], footprint: N) -> [N; 2] {
    const BAY_M: [f32; 2] = [4.2, 3.4];
    let cell: [N; 2] = std::array::from_fn(|k| (p[k] / BAY_M[k]).floor());
    let edge = edge_distance(std::array::from_fn(|k| p[k] - cell[k] * BAY_M[k]), BAY_M);
    let renewed = N::cell2(cell, 61);
    let older = renewed.is_below(N::splat(0.16)).select(N::splat(-0.20), N::splat(0.0));
    let renewed = renewed.is_below(N::splat(0.07)).select(N::splat(0.22), older);
    let cast = (N::cell2(cell, 62) - 0.5) * 0.14 + 1.0 + renewed;
    let mut batch = N::Noise::new(footprint);
    let wobble = [63, 64].map(|salt| batch.value2(p.map(|axis| axis * 0.9), salt));
    let grime = batch.fbm2(p.map(|axis| axis + 19.0), 0.8, 3);
    let worn = batch.fbm2([p[0] + 23.0, p[1] * 0.4 + 23.0], 3.2, 3);
    let overgrown = batch.fbm2(p.map(|axis| axis + 140.0), 4.5, 3);
    let found = batch.found();
    let at: [N; 2] = std::array::from_fn(|k| (p[k] + found(wobble[k]) * 0.35) / 3.7);
    let [first, second, crack] = N::cells2(at, 65);
    let cracked = border_line(first, second, 3.7, 0.007, footprint);
    let cracked = crack.is_below(N::splat(0.3)).select(cracked, N::splat(0.0));
    let joint = line(edge, 0.016, footprint);
    let grime = (N::ONE - smoothstep(0.0, 0.45, edge)) * (found(grime) * 0.5 + 0.5);
    let worn = smoothstep(0.1, 0.55, found(worn));
    let overgrown = smoothstep(-0.1, 0.3, found(overgrown));
    let tone = cast * (N::ONE - joint * 0.5) * (N::ONE - cracked * 0.45);
    [tone * (N::ONE - grime * 0.16) * (N::ONE - worn * 0.16), line(edge, 0.05, footprint) * overgrown]
}

/// Whether concrete is that of a yard, not of a wall or a kerb.
fn is_yard(point: &SurfaceInteraction<'_>) -> bool {
    point.material.tag == ClassTag::Ground && point.geometric_normal.z > 0.9
}

/// Tone and moss of concrete.
pub(super) fn concrete_look<G: PixelGroup>(at: &G) -> [G::Number; 2] {
    let built = at.each(|point| if is_yard(point) { 0.0 } else { 1.0 });
    concrete_tone(at.plan(), at.each(|point| point.position.z), built.is_below(PerPixel::splat(0.5)), at.footprint_m())
}

fn concrete_tone<N: PerPixel>(p: [N; 2], height: N, yard: N::Truth, footprint: N) -> [N; 2] {
    let along = [yard.select(p[0], p[0] + height * 0.37), yard.select(p[1], p[1] + height * 0.91)];
    let [stain, cloudy, broad] = concrete_noise(along, footprint);
    let stain = smoothstep(0.25, 0.6, stain);
    let built = cloudy * 0.26 + 0.86 + broad * 0.18 - stain * 0.16;
    if !yard.anywhere() {
        return [built, N::splat(0.0)];
    }
    let [bays, moss] = yard_tone(p, footprint);
    let tone = (cloudy * 0.20 + 0.92 - stain * 0.12) * bays;
    [yard.select(tone, built), moss * 0.7]
}

pub(super) fn concrete(point: &SurfaceInteraction<'_>, base: Vec3A, [tone, moss]: [f32; 2]) -> Bsdf {
    let bare = base * tone;
    let color = if is_yard(point) { bare.lerp_unfused(Vec3A::new(0.055, 0.075, 0.03), moss) } else { bare };
    Bsdf::matte(color, point.normal)
}

/// Of stains, of unevenness within metres and over more of them.
fn concrete_noise<N: PerPixel>(p: [N; 2], footprint: N) -> [N; 3] {
    let moved = |aside: f32| p.map(|axis| axis + aside);
    let mut batch = N::Noise::new(footprint);
    let asked = [batch.fbm2(moved(57.0), 1.9, 4), batch.fbm2(p, 2.7, 6), batch.fbm2(moved(11.0), 9.0, 3)];
    asked.map(batch.found())
}

/// Unevenness of grass, over metres and down to blades, how dry and how worn it is, how lush over tens of metres, and its bumps.
pub(super) fn grass_look<G: PixelGroup>(at: &G) -> [G::Number; 10] {
    let (p, footprint) = (at.plan(), at.footprint_m());
    let moved = |aside: f32| p.map(|axis| axis + aside);
    let mut batch = <G::Number as PerPixel>::Noise::new(footprint);
    let asked = [
        batch.fbm2(p, 7.0, 4),
        batch.fbm2(p, 0.35, 2),
        batch.fbm2(moved(7.0), 0.13, 2),
        batch.fbm2([p[0], p[1] * 0.6], 0.05, 3),
        batch.fbm2(moved(90.0), 5.0, 3),
        batch.fbm2(moved(210.0), 3.3, 4),
        batch.fbm2(moved(530.0), 42.0, 3),
    ];
    let [broad, tuft, clump, blades, dry, worn, lush] = asked.map(batch.found());
    let dry = smoothstep(0.1, 0.6, dry + tuft * 0.15);
    let worn = smoothstep(0.28, 0.62, worn + tuft * 0.1);
    let [x, y, keep] = bumps(p, 0.10, 0.8, footprint);
    let lush = smoothstep(-0.45, 0.45, lush + broad * 0.15);
    [broad, tuft, clump, blades, dry, worn, lush, x, y, keep]
}

pub(super) fn grass(point: &SurfaceInteraction<'_>, base: Vec3A, look: [f32; 10]) -> Bsdf {
    let [broad, tuft, clump, blades, dry, worn, lush, bumps @ ..] = look;
    // Where it is mown short or stands in the sun it is pale and yellowish, and dark where it is watered or shaded.
    let grown = Vec3A::new(1.42, 1.14, 1.12).lerp_unfused(Vec3A::new(0.70, 0.86, 0.84), lush);
    let green = muted(base * grown, 0.22) * (0.94 + 0.34 * broad + 0.35 * tuft + 0.75 * clump + 0.7 * blades);
    let straw = Vec3A::new(0.20, 0.17, 0.085) * (1.0 + 0.4 * blades + 0.3 * tuft);
    let earth = Vec3A::new(0.115, 0.09, 0.065) * (1.0 + 0.5 * tuft);
    let color = green.lerp_unfused(straw, dry * 0.6).lerp_unfused(earth, worn * 0.6);
    let mut bsdf = Bsdf::matte(color, bumped(point.normal, bumps));
    bsdf.roughness = 0.8;
    bsdf
}

/// Tone of earth or gravel, and its bumps.
pub(super) fn loose_look<G: PixelGroup>(at: &G) -> [G::Number; 4] {
    let (p, footprint) = (at.plan(), at.footprint_m());
    let [x, y, keep] = bumps(p, 0.06, 0.4, footprint);
    [loose_tone(p, footprint), x, y, keep]
}

fn loose_tone<N: PerPixel>(p: [N; 2], footprint: N) -> N {
    let tone = N::filtered_fbm2(p, 2.0, 7, footprint) * 0.35 + 1.0;
    let [_, _, id] = N::cells2(p.map(|axis| axis / 0.035), 51);
    let visible = (N::splat(0.03) / footprint.max(N::splat(1e-3))).min(N::ONE);
    tone * ((id - 0.5) * 0.5 * visible + 1.0)
}

pub(super) fn loose(point: &SurfaceInteraction<'_>, base: Vec3A, [tone, bumps @ ..]: [f32; 4]) -> Bsdf {
    let tint = noise::tint(IVec2::new((point.position.x / 3.0) as i32, 0), 52, 0.02);
    Bsdf::matte(base * tint * tone, bumped(point.normal, bumps))
}
