//! Optical flow of a fixed camera: where the points that a frame shows are in the frame before or after it.
//!
//! The camera stands, so what stands still stays where it is, and only what moves can hide it. A point on what moves is the
//! same point of the same triangle in the other instant, so the flow is exact, deforming bodies included.

use super::bake::CameraBake;
use super::moving_centre::MovingCentre;
use super::tile::TILE;
use super::visible_tiles::each_visible_tile;
use crate::accel::{Hit, Ray, RayStream, lanes};
use crate::camera_rays::directions8;
use crate::scene::{FrameScene, Instance, StaticScene};
use endless_world::math::UnfusedVec3A;
use endless_world::{FlowPixel, FlowTarget, Image, ImageSize, SensorFrame};
use glam::{Vec2, Vec3A};
use std::{ops::Range, sync::Arc};
use wide::f32x8;

/// The instants to which flow leads. What moves is in all of them, in the same order; where one is missing, flow to it is
/// unknown.
#[derive(Debug, Clone, Copy, Default)]
pub struct NeighbourFrames<'a> {
    /// The one before.
    pub before: Option<&'a FrameScene>,
    /// The one after.
    pub after: Option<&'a FrameScene>,
}

/// A frame, and what moves in it.
pub(super) struct FlowPass<'a> {
    pub(super) bake: &'a CameraBake,
    pub(super) still: &'a StaticScene,
    pub(super) frame: &'a FrameScene,
    pub(super) centres: &'a [MovingCentre],
}

/// Rows of a tile whose rays are traced together.
const ROWS: u32 = 4;
/// Rays that are traced together.
const RAYS: usize = (ROWS * TILE) as usize;

impl FlowPass<'_> {
    /// A sensor frame with the flow that is wanted.
    pub(super) fn added(&self, sensor: SensorFrame, neighbours: NeighbourFrames<'_>) -> SensorFrame {
        let wanted = self.bake.wanted;
        SensorFrame {
            flow: wanted.flow.then(|| self.flow_to(neighbours.after)),
            flow_backward: wanted.flow_backward.then(|| self.flow_to(neighbours.before)),
            ..sensor
        }
    }

    fn flow_to(&self, other: Option<&FrameScene>) -> Image<[u16; 3]> {
        let size = self.bake.camera.size;
        let Some(other) = other else { return Image::filled(size, FlowPixel::UNKNOWN) };
        let mut image = Image::filled(size, FlowPixel::STILL.encoded());
        self.hide_still(other, &mut image.data);
        for centres in self.centres.chunks(RAYS) {
            self.follow(other, centres, &mut image.data);
        }
        image
    }

    /// Marks what stands still, and is hidden by what moves in the other frame.
    fn hide_still(&self, other: &FrameScene, image: &mut [[u16; 3]]) {
        let tiles = self.bake.tiles.tiles();
        let moving = self.moving_rows(tiles.columns);
        let mut visible = vec![false; tiles.bounds.len()];
        each_visible_tile(self.bake, other, |tile| visible[tile] = true);
        let hidden = FlowPixel { target: FlowTarget::Hidden, ..FlowPixel::STILL }.encoded();
        for tile in (0..visible.len() as u32).filter(|&tile| visible[tile as usize]) {
            let (x0, y0) = (tile % tiles.columns * TILE, tile / tiles.columns * TILE);
            let (x1, y1) = self.bake.tile_end(x0, y0);
            for y in (y0..y1).step_by(ROWS as usize) {
                let rows = y..y1.min(y + ROWS);
                let stands =
                    |y: u32| ((1u32 << (x1 - x0)) - 1) & !u32::from(moving[(y * tiles.columns + x0 / TILE) as usize]);
                let active = rows.clone().rev().fold(0, |active, y| active << TILE | stands(y));
                if active == 0 {
                    continue;
                }
                let rays = self.centre_rays(x0..x1, rows);
                for lane in lanes(other.accel.occluded32(&rays, active)) {
                    let (x, y) = (x0 + lane as u32 % TILE, y + lane as u32 / TILE);
                    image[(y * self.bake.camera.size.width + x) as usize] = hidden;
                }
            }
        }
    }

    /// Which pixels show something that moves, a bit each, by row and by column of tiles.
    fn moving_rows(&self, columns: u32) -> Vec<u8> {
        let ImageSize { width, height } = self.bake.camera.size;
        let mut rows = vec![0; (columns * height) as usize];
        for centre in self.centres {
            let (x, y) = (centre.pixel % width, centre.pixel / width);
            rows[(y * columns + x / TILE) as usize] |= 1 << (x % TILE);
        }
        rows
    }

    /// Rays through the centres of pixels, up to where they meet what stands still.
    fn centre_rays(&self, columns: Range<u32>, rows: Range<u32>) -> RayStream<{ ROWS as usize }> {
        let CameraBake { camera, gbuffer, .. } = self.bake;
        let mut rays = RayStream::NONE;
        rays.origin = camera.position.to_array().map(|axis| [f32x8::splat(axis); ROWS as usize]);
        for (row, y) in rows.enumerate() {
            let directions = directions8(camera, columns.start, columns.end, y, 0);
            for (axis, direction) in rays.direction.iter_mut().zip(directions) {
                axis[row] = direction;
            }
            let distance = |i: usize| {
                let x = (columns.start + i as u32).min(columns.end - 1);
                // What is no nearer hides nothing.
                gbuffer.distances[(y * camera.size.width + x) as usize][0].next_down()
            };
            rays.tmax[row] = f32x8::new(std::array::from_fn(distance));
        }
        rays
    }

    /// The flow of points on what moves.
    fn follow(&self, other: &FrameScene, centres: &[MovingCentre], image: &mut [[u16; 3]]) {
        let mut rays = RayStream::NONE;
        let mut active = 0;
        let mut flows = [FlowPixel::STILL; RAYS];
        for (lane, &MovingCentre { pixel, hit, .. }) in centres.iter().enumerate() {
            image[pixel as usize] = FlowPixel::UNKNOWN;
            let Some((place, ray)) = self.point_then(other, &hit) else { continue };
            let ImageSize { width, height } = self.bake.camera.size;
            let centre = Vec2::new((pixel % width) as f32 + 0.5, (pixel / width) as f32 + 0.5);
            let outside = place.cmplt(Vec2::ZERO).any() || place.cmpge(Vec2::new(width as f32, height as f32)).any();
            let target = match ray {
                _ if outside => FlowTarget::Outside,
                None => FlowTarget::Hidden,
                Some(ray) => {
                    rays.set(lane, &ray);
                    active |= 1 << lane;
                    FlowTarget::Visible
                }
            };
            flows[lane] = FlowPixel { flow_px: place - centre, target };
            image[pixel as usize] = flows[lane].encoded();
        }
        for lane in lanes(self.hidden(other, centres, &rays, active)) {
            let hidden = FlowPixel { target: FlowTarget::Hidden, ..flows[lane] };
            image[centres[lane].pixel as usize] = hidden.encoded();
        }
    }

    /// Which of these rays, of those in `active`, meet something before the point of their centre, a bit each.
    fn hidden(&self, other: &FrameScene, centres: &[MovingCentre], rays: &RayStream<4>, active: u32) -> u32 {
        let met = other.accel.closest32(rays, active);
        let bit = |lane: usize, is: bool| u32::from(is) << lane;
        // Its own triangle, whatever rounding says of the distance.
        let other_than_itself = |lane: usize| {
            let itself = &centres[lane].hit;
            met.get(lane).is_some_and(|met| (met.instance, met.triangle) != (itself.instance, itself.triangle))
        };
        let by_moving = lanes(active).fold(0, |bits, lane| bits | bit(lane, other_than_itself(lane)));
        // What stands still does not hide what is where it is seen now.
        let stays = lanes(active).fold(0, |bits, lane| bits | bit(lane, self.stays(other, &centres[lane].hit)));
        let open = active & !by_moving & !stays;
        if open == 0 { by_moving } else { by_moving | self.still.accel.occluded32(&met.shortened(rays), open) }
    }

    /// Whether what was hit is in the same place in the other frame.
    fn stays(&self, other: &FrameScene, hit: &Hit) -> bool {
        let [now, then] = [self.frame, other].map(|frame| &frame.instances[hit.instance as usize]);
        now.world_from_object == then.world_from_object && Arc::ptr_eq(&now.geometry.posed, &then.geometry.posed)
    }

    /// Where the point of a hit is in the picture of the other frame, and the ray that must be free for the camera to see
    /// it: none if it faces away. `None` if it is behind the camera, or not there.
    fn point_then(&self, other: &FrameScene, hit: &Hit) -> Option<(Vec2, Option<Ray>)> {
        let camera = &self.bake.camera;
        let lens = Vec3A::from(camera.position);
        let (now, then) = (&self.frame.instances[hit.instance as usize], other.instances.get(hit.instance as usize)?);
        if now.id != then.id || !Arc::ptr_eq(&now.geometry.mesh, &then.geometry.mesh) {
            return None;
        }
        let (seen, outwards) = point_of(now, hit);
        let side = (lens - seen).dot(outwards);
        let (position, outwards) = point_of(then, hit);
        let (place, _) = camera.project(position.into())?;
        if (lens - position).dot(outwards) * side <= 0.0 {
            return Some((place, None));
        }
        // Up to a little before it: rounding may let the ray meet the triangles beside it too early.
        let distance = position.distance(lens);
        let tmax = distance - (5e-4 + 1e-5 * distance + 4e-7 * position.abs().max_element());
        Some((place, Some(Ray { origin: lens, direction: (position - lens) / distance, tmax })))
    }
}

/// The place of a hit in the world, and a normal of its triangle, of any length, on the same side at all instants.
fn point_of(instance: &Instance, hit: &Hit) -> (Vec3A, Vec3A) {
    let positions = instance.geometry.posed.positions();
    let corners = instance.geometry.mesh.triangles[hit.triangle as usize];
    let [a, b, c] = corners.map(|corner| Vec3A::from(positions[corner as usize]));
    let point = a * (1.0 - hit.u - hit.v) + b * hit.u + c * hit.v;
    let normal = instance.normal_matrix * (b - a).cross_unfused(c - a);
    (instance.world_from_object.transform_point3a(point), normal)
}
