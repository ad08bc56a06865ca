//! The tiles in which moving surfaces may be seen. Conservative.

use super::bake::CameraBake;
use super::tile::TILE;
use crate::accel::corners;
use crate::image_rect::{ImageRect, sphere_in_image};
use crate::scene::{FrameScene, Instance};
use endless_world::{Distortion, Lens, PinholeCamera};
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
    // About as many parts as tiles: smaller ones tell no more.
    let area: u32 = tiles(blas.bounds()).map(|[low, high]| (high - low + 1).element_product()).sum();
    if area == 0 {
        return;
    }
    for [low, high] in blas.parts((area as usize).min(MOST_PARTS)).into_iter().flat_map(tiles) {
        for y in low.y..=high.y {
            for x in low.x..=high.x {
                tell((y * bake.tiles.tiles().columns + x) as usize);
            }
        }
    }
}

/// The first and last tile, column and row, over which a box of an object projects: twice, where the picture's left and
/// right edges meet.
fn tiles_of(
    bake: &CameraBake,
    world_from_object: &Affine3A,
    bounds: (Vec3A, Vec3A),
) -> impl Iterator<Item = [UVec2; 2]> + use<> {
    let camera = &bake.camera;
    let rectangles = match camera.lens {
        Lens::Perspective(distortion) => [projected(camera, distortion, world_from_object, bounds), None],
        _ => {
            let corners = corners(bounds).map(|corner| world_from_object.transform_point3a(corner));
            let centre = world_from_object.transform_point3a((bounds.0 + bounds.1) * 0.5);
            let radius = corners.map(|corner| corner.distance(centre)).into_iter().fold(0.0, f32::max);
            sphere_in_image(camera, centre.into(), radius)
        }
    };
    let tiles = rectangles.map(|rectangle| tiles_in(camera, rectangle?));
    tiles.into_iter().flatten()
}

/// The first and last tile that a rectangle of the picture touches.
fn tiles_in(camera: &PinholeCamera, ImageRect { low, high }: ImageRect) -> Option<[UVec2; 2]> {
    let limit = Vec2::new(camera.size.width as f32, camera.size.height as f32);
    // A pixel of slack: samples lie up to half a pixel from the centre.
    let (low, high) = (low - 1.5, high + 1.5);
    if high.x < 0.0 || high.y < 0.0 || low.x >= limit.x || low.y >= limit.y {
        return None;
    }
    Some([low.max(Vec2::ZERO).as_uvec2() / TILE, high.min(limit - 1.0).max(Vec2::ZERO).as_uvec2() / TILE])
}

/// Bounds of the visible part of an object's box in the image of a perspective camera; `None` if it lies behind the camera.
fn projected(
    camera: &PinholeCamera,
    lens: Distortion,
    world_from_object: &Affine3A,
    bounds: (Vec3A, Vec3A),
) -> Option<ImageRect> {
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
    (first.x <= last.x).then(|| in_pixels(camera, lens, first, last))
}

/// Bounds in the image of a rectangle of the plane at distance 1 before the lens.
fn in_pixels(camera: &PinholeCamera, lens: Distortion, mut first: Vec2, mut last: Vec2) -> ImageRect {
    let k = &camera.intrinsics;
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
    ImageRect { low: pixel(first), high: pixel(last) }
}
