//! The tiles in which moving surfaces may be seen. Conservative.

use super::bake::CameraBake;
use super::tile::TILE;
use crate::accel::corners;
use crate::scene::{FrameScene, Instance};
use endless_world::{Distortion, PinholeCamera};
use glam::{Affine3A, UVec2, Vec2, Vec3, Vec3A};

/// Most boxes as which something that moves is told apart in the picture.
const MOST_PARTS: usize = 128;

/// Tells the tiles over which the parts of what moves project, by index, some of them several times.
pub(super) fn each_visible_tile(bake: &CameraBake, frame: &FrameScene, mut tell: impl FnMut(usize)) {
    for instance in &frame.instances {
        each_tile_of(bake, instance, &mut tell);
    }
}

/// Those of one instance.
fn each_tile_of(bake: &CameraBake, instance: &Instance, tell: &mut impl FnMut(usize)) {
    let blas = &instance.geometry.posed.blas;
    let tiles = |bounds| tiles_of(bake, &instance.world_from_object, bounds);
    let Some([low, high]) = tiles(blas.bounds()) else { return };
    // About as many parts as tiles: smaller ones tell no more.
    let area = (high - low + 1).element_product();
    for [low, high] in blas.parts((area as usize).min(MOST_PARTS)).into_iter().filter_map(tiles) {
        for y in low.y..=high.y {
            for x in low.x..=high.x {
                tell((y * bake.tiles.tiles().columns + x) as usize);
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
