//! The tiles that moving objects can change, and how. Conservative.

use super::bake::CameraBake;
use super::contact_shadow::contact_may_reach;
use super::object_group::ObjectGroup;
use super::ray_bounds::RayBounds;
use super::tile::{Bounds3, TILE, TileBounds, TileRayBounds};
use super::tile_hierarchy::{FACTOR, TileHierarchy, TileLevel};
use super::tile_work::{BeamSweep, TileWork};
use crate::accel::corners;
use crate::light::{Lamps, VehicleBeam};
use crate::scene::{FrameScene, Instance, MovingVolume, StaticScene};
use endless_world::{Distortion, PinholeCamera};
use glam::{Affine3A, UVec2, Vec2, Vec3, Vec3A};
use std::cell::LazyCell;

/// Most boxes as which something that moves is told apart in the picture.
const MOST_PARTS: usize = 128;

/// The work of every tile of a frame.
pub(super) fn affected(bake: &CameraBake, still: &StaticScene, frame: &FrameScene) -> Vec<TileWork> {
    let mut work = vec![TileWork::default(); bake.tiles.tiles().bounds.len()];
    for (tile, bounds) in work.iter_mut().zip(&bake.tiles.tiles().bounds) {
        tile.lens = bounds.lens;
    }
    for instance in &frame.instances {
        mark_visible(bake, instance, &mut work);
    }
    let shadows: Vec<Vec<LampShadow>> =
        frame.objects.iter().map(|object| lamp_shadows(bake, &still.lamps, object)).collect();
    let spans: Vec<Bounds3> = shadows.iter().map(|shadows| span_of(shadows)).collect();
    for group in ObjectGroup::all(&frame.objects, &spans) {
        mark(&bake.tiles, &mut work, |area, tile| {
            let may_change = !area.bounds.points.is_empty() && group.may_change(area.bounds, area.rays);
            if let (Some(tile), true) = (tile, may_change) {
                for &i in &group.members {
                    mark_object(&frame.objects[i], &shadows[i], i as u16, area, tile);
                }
            }
            may_change
        });
    }
    for tile in &mut work {
        tile.contacts.sort_unstable();
    }
    // By day vehicle lights are seen, but light nothing.
    let beams: &[VehicleBeam] = if bake.lighting.environment.night { &frame.beams } else { &[] };
    for (i, beam) in beams.iter().enumerate() {
        let range = beam.range_m();
        let near = |o: &&MovingVolume| beam.position.clamp(o.low, o.high).distance(beam.position) <= range * 1.01;
        let objects: LazyCell<Vec<&MovingVolume>, _> = LazyCell::new(|| frame.objects.iter().filter(near).collect());
        mark(&bake.tiles, &mut work, |TileArea { bounds, .. }, tile| {
            let reaches = !bounds.points.is_empty() && beam.reaches(bounds.points.low - 0.1, bounds.points.high + 0.1);
            if let (Some(tile), true) = (tile, reaches) {
                let way = bounds.lamp_rays(beam.position);
                let crossed = objects.iter().any(|o| way.may_meet(o.low, o.high, 1.0));
                tile.beams.push(BeamSweep { beam: i as u16, crossed });
            }
            reaches
        });
    }
    work
}

/// A tile or a larger area.
#[derive(Clone, Copy)]
struct TileArea<'a> {
    bounds: &'a TileBounds,
    rays: &'a TileRayBounds,
}

/// Runs a test over the picture, over those parts of it that pass it, and so on down to tiles.
fn mark(
    TileHierarchy { levels, .. }: &TileHierarchy,
    work: &mut [TileWork],
    mut test: impl FnMut(TileArea<'_>, Option<&mut TileWork>) -> bool,
) {
    mark_area(levels, [0, 0], work, &mut test);
}

/// The same for the area of the last of these levels at a place.
fn mark_area(
    levels: &[TileLevel],
    [x, y]: [u32; 2],
    work: &mut [TileWork],
    test: &mut impl FnMut(TileArea<'_>, Option<&mut TileWork>) -> bool,
) {
    let Some((level, below)) = levels.split_last() else { return };
    let i = (y * level.columns + x) as usize;
    let area = TileArea { bounds: &level.bounds[i], rays: &level.rays[i] };
    let Some(next) = below.last() else {
        test(area, Some(&mut work[i]));
        return;
    };
    if test(area, None) {
        for y in y * FACTOR..((y + 1) * FACTOR).min(next.rows) {
            for x in x * FACTOR..((x + 1) * FACTOR).min(next.columns) {
                mark_area(below, [x, y], work, test);
            }
        }
    }
}

/// Marks a tile with what an object does to it.
fn mark_object(
    object: &MovingVolume,
    shadows: &[LampShadow],
    index: u16,
    TileArea { bounds, rays }: TileArea<'_>,
    tile: &mut TileWork,
) {
    let (low, high) = (object.low, object.high);
    let meets = |rays: &RayBounds, reach: f32| {
        rays.may_meet(low, high, reach) && object.parts.iter().any(|&(low, high)| rays.may_meet(low, high, reach))
    };
    let sun = || rays.sun.as_ref().is_some_and(|b| meets(b, f32::MAX));
    let mirror = || rays.mirror.as_ref().is_some_and(|b| meets(b, bounds.mirror_reach * 1.001 + 0.1));
    let contact = || contact_may_reach(object, &bounds.points);
    let shades = |shadow: &LampShadow| {
        bounds.points.meets(shadow.span.low - 0.1, shadow.span.high + 0.1)
            && bounds.lamp_rays(shadow.position).may_meet(low, high, 1.0)
    };
    tile.sun = tile.sun || sun();
    tile.mirror = tile.mirror || mirror();
    if contact() {
        tile.contacts.push(index);
    }
    for shadow in shadows.iter().filter(|s| shades(s)) {
        if !tile.lamps.contains(&shadow.lamp) {
            tile.lamps.push(shadow.lamp);
        }
    }
}

/// Where an object's shadow by one lamp can lie.
struct LampShadow {
    lamp: u16,
    position: Vec3A,
    span: Bounds3,
}

/// Around all of some shadows, with the slack of a tile's test.
fn span_of(shadows: &[LampShadow]) -> Bounds3 {
    let mut span = Bounds3::EMPTY;
    for shadow in shadows {
        span.join(&Bounds3 { low: shadow.span.low - 0.1, high: shadow.span.high + 0.1 });
    }
    span
}

/// Bounds of the shadows that an object throws by the light of lamps, down to the lowest surface in view.
fn lamp_shadows(bake: &CameraBake, lamps: &Lamps, object: &MovingVolume) -> Vec<LampShadow> {
    let range = Lamps::range_m();
    let reach = |p: Vec3A, low: Vec3A, high: Vec3A| p.clamp(low, high).distance_squared(p) <= range * range * 1.01;
    let floor = bake.tiles.lowest - 0.1;
    if !bake.lighting.environment.night {
        return Vec::new();
    }
    lamps
        .all()
        .iter()
        .enumerate()
        .filter(|(_, lamp)| reach(lamp.position, object.low, object.high))
        .map(|(i, lamp)| {
            let position = lamp.position;
            let mut span = Bounds3 { low: object.low.with_z(floor), high: object.high };
            if position.z > object.high.z + 0.3 {
                // The top's corners, thrown from the lamp onto the floor.
                let stretch = (position.z - floor) / (position.z - object.high.z);
                span.add((position + (object.low - position) * stretch).with_z(floor));
                span.add((position + (object.high - position) * stretch).with_z(floor));
            } else {
                span.add(position - range);
                span.add(position + range);
            }
            LampShadow { lamp: i as u16, position, span }
        })
        .collect()
}

/// Marks the tiles over which the parts of something that moves project.
fn mark_visible(bake: &CameraBake, instance: &Instance, work: &mut [TileWork]) {
    let blas = &instance.geometry.posed.blas;
    let tiles = |bounds| tiles_of(bake, &instance.world_from_object, bounds);
    let Some([low, high]) = tiles(blas.bounds()) else { return };
    // About as many parts as tiles: smaller ones tell no more.
    let area = (high - low + 1).element_product();
    for [low, high] in blas.parts((area as usize).min(MOST_PARTS)).into_iter().filter_map(tiles) {
        for y in low.y..=high.y {
            for x in low.x..=high.x {
                work[(y * bake.tiles.tiles().columns + x) as usize].primary = true;
            }
        }
    }
}

/// The first and last tile, column and row, over which a box of an object projects.
fn tiles_of(bake: &CameraBake, world_from_object: &Affine3A, bounds: (Vec3A, Vec3A)) -> Option<[UVec2; 2]> {
    let (low, high) = projected(&bake.camera, world_from_object, bounds)?;
    let limit = Vec2::new(bake.camera.size.width as f32, bake.camera.size.height as f32);
    // A pixel of slack: samples lie up to half a pixel from the centre.
    let (low, high) = (low - 1.5, high + 1.5);
    if high.x < 0.0 || high.y < 0.0 || low.x >= limit.x || low.y >= limit.y {
        return None;
    }
    Some([low.max(Vec2::ZERO).as_uvec2() / TILE, high.min(limit - 1.0).max(Vec2::ZERO).as_uvec2() / TILE])
}

/// Bounds of the visible part of an object's box in the image; `None` if it lies behind the camera.
fn projected(camera: &PinholeCamera, world_from_object: &Affine3A, bounds: (Vec3A, Vec3A)) -> Option<(Vec2, Vec2)> {
    const NEAR: f32 = 0.02;
    let seen = |corner| camera.camera_from_world(world_from_object.transform_point3a(corner).into());
    let corners: [Vec3; 8] = corners(bounds).map(seen);
    let (mut first, mut last) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    let mut add = |c: Vec3| {
        let p = Vec2::new(c.x, c.y) / c.z;
        (first, last) = (first.min(p), last.max(p));
    };
    for (i, &a) in corners.iter().enumerate() {
        if a.z >= NEAR {
            add(a);
        }
        // The three edges that leave towards higher corners, cut at the near plane.
        for bit in 0..3 {
            let b = corners[i | 1 << bit];
            if i >> bit & 1 == 0 && (a.z < NEAR) != (b.z < NEAR) {
                let t = (NEAR - a.z) / (b.z - a.z);
                add((a + (b - a) * t).with_z(NEAR));
            }
        }
    }
    (first.x <= last.x).then(|| in_pixels(camera, first, last))
}

/// Bounds in the image of a rectangle of the plane at distance 1 before the lens.
fn in_pixels(camera: &PinholeCamera, mut first: Vec2, mut last: Vec2) -> (Vec2, Vec2) {
    let k = &camera.intrinsics;
    let lens = camera.distortion;
    if lens != Distortion::NONE {
        // Far beyond the picture the lens is of no interest, and its curve no longer simple.
        let edge = lens.undistort(Vec2::new(k.cx / k.fx, k.cy / k.fy)) * 1.1;
        (first, last) = (first.clamp(-edge, edge), last.clamp(-edge, edge));
        // A side bulges most where it is nearest to the middle or farthest from it.
        let middle = Vec2::ZERO.clamp(first, last);
        let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
        for x in [first.x, last.x, middle.x] {
            for y in [first.y, last.y, middle.y] {
                let bent = lens.distort(Vec2::new(x, y));
                (low, high) = (low.min(bent), high.max(bent));
            }
        }
        (first, last) = (low, high);
    }
    let pixel = |p: Vec2| p * Vec2::new(k.fx, k.fy) + Vec2::new(k.cx, k.cy);
    (pixel(first), pixel(last))
}
