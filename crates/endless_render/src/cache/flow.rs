//! Optical flow: where the points that a frame shows are in the frame before or after it.
//!
//! A point on what moves is the same point of the same triangle in the other instant, so the flow is exact, deforming bodies
//! included. Before a camera that stands, what stands still stays where it is, and only what moves can hide it; before one
//! that moves, each point is looked for (`flow_from_elsewhere.rs`).

use super::bake::CameraBake;
use super::covered_centres::CoveredCentres;
use super::moving_centre::MovingCentre;
use super::other_instant::OtherInstant;
use crate::accel::{Hit, Ray, RayStream, lanes};
use crate::scene::{FrameScene, Instance, StaticScene};
use endless_world::math::UnfusedVec3A;
use endless_world::{FlowPixel, FlowTarget, Image, PinholeCamera, SensorFrame};
use glam::{Vec2, Vec3A};
use std::sync::Arc;

/// The instants to which flow leads. Where one is missing, flow to it is unknown, as it is of what is not there then.
#[derive(Debug, Clone, Copy, Default)]
pub struct NeighbourFrames<'a> {
    /// The one before.
    pub before: Option<NeighbourFrame<'a>>,
    /// The one after.
    pub after: Option<NeighbourFrame<'a>>,
}

/// An instant to which flow leads.
#[derive(Debug, Clone, Copy)]
pub struct NeighbourFrame<'a> {
    /// What moves.
    pub scene: &'a FrameScene,
    /// Of this camera and instant, if they are kept.
    pub covered: Option<&'a CoveredCentres>,
    /// The camera then, if it moves.
    pub camera: Option<&'a PinholeCamera>,
}

impl<'a> From<&'a FrameScene> for NeighbourFrame<'a> {
    fn from(scene: &'a FrameScene) -> Self {
        Self { scene, covered: None, camera: None }
    }
}

/// A frame, and what moves in it.
pub(super) struct FlowPass<'a> {
    pub(super) bake: &'a CameraBake,
    pub(super) still: &'a StaticScene,
    pub(super) frame: &'a FrameScene,
    pub(super) centres: &'a [MovingCentre],
}

/// Rays that are traced together.
pub(super) const RAYS: usize = 32;

impl FlowPass<'_> {
    /// A sensor frame with the flow that is wanted.
    pub(super) fn added(&self, sensor: SensorFrame, neighbours: NeighbourFrames<'_>) -> SensorFrame {
        let wanted = self.bake.wanted;
        let sides = if wanted.needs_neighbours() { self.sides() } else { Vec::new() };
        SensorFrame {
            flow: wanted.flow.then(|| self.flow_to(neighbours.after, &sides)),
            flow_backward: wanted.flow_backward.then(|| self.flow_to(neighbours.before, &sides)),
            ..sensor
        }
    }

    /// On which side of its triangle, as [`point_of`] tells, each centre is seen: the sign of a number.
    fn sides(&self) -> Vec<f32> {
        let side = |centre: &MovingCentre| {
            let (seen, outwards) = point_of(&self.frame.instances[centre.hit.instance as usize], &centre.hit);
            (Vec3A::from(self.bake.camera.eye_for(seen.into())) - seen).dot(outwards)
        };
        self.centres.iter().map(side).collect()
    }

    fn flow_to(&self, other: Option<NeighbourFrame<'_>>, sides: &[f32]) -> Image<[u16; 3]> {
        let size = self.bake.camera.size;
        let Some(NeighbourFrame { scene, covered, camera }) = other else {
            return Image::filled(size, FlowPixel::UNKNOWN);
        };
        if let Some(camera) = camera {
            return self.flow_from_elsewhere(&OtherInstant::new(self.frame, scene), camera, sides);
        }
        let mut image = Image::filled(size, FlowPixel::STILL.encoded());
        // What stands still is hidden by what moves in the other frame.
        let hidden = FlowPixel { target: FlowTarget::Hidden, ..FlowPixel::STILL }.encoded();
        for &pixel in &self.bake.film.unlit {
            image.data[pixel as usize] = FlowPixel::UNKNOWN;
        }
        let other = OtherInstant::new(self.frame, scene);
        let found = CoveredCentres::default();
        for pixel in covered.unwrap_or(&found).rows(self.bake, scene).pixels(size.width as usize) {
            image.data[pixel] = hidden;
        }
        for (centres, sides) in self.centres.chunks(RAYS).zip(sides.chunks(RAYS)) {
            self.follow(&other, &self.bake.camera, centres, sides, &mut image.data);
        }
        image
    }

    /// The flow of points on what moves, seen by this camera then.
    pub(super) fn follow(
        &self,
        other: &OtherInstant<'_>,
        camera: &PinholeCamera,
        centres: &[MovingCentre],
        sides: &[f32],
        image: &mut [[u16; 3]],
    ) {
        let mut rays = RayStream::NONE;
        let mut active = 0;
        let mut flows = [FlowPixel::STILL; RAYS];
        for (lane, (&MovingCentre { pixel, hit, .. }, &side)) in centres.iter().zip(sides).enumerate() {
            image[pixel as usize] = FlowPixel::UNKNOWN;
            let Some((place, ray)) = self.point_then(other, camera, &hit, side) else { continue };
            let width = self.bake.camera.size.width;
            let (flow, ray) = self.flow_towards([pixel % width, pixel / width], place, ray);
            if let Some(ray) = ray {
                rays.set(lane, &ray);
                active |= 1 << lane;
            }
            flows[lane] = flow;
            image[pixel as usize] = flows[lane].encoded();
        }
        let camera_stays = *camera == self.bake.camera;
        for lane in lanes(self.hidden(other, camera_stays, centres, &rays, active)) {
            let hidden = FlowPixel { target: FlowTarget::Hidden, ..flows[lane] };
            image[centres[lane].pixel as usize] = hidden.encoded();
        }
    }

    /// The flow of a pixel to a place of the other picture, visible there if this ray is free; with the ray, if that must be
    /// asked. Without a ray the point faces away.
    pub(super) fn flow_towards(&self, [x, y]: [u32; 2], place: Vec2, ray: Option<Ray>) -> (FlowPixel, Option<Ray>) {
        let camera = &self.bake.camera;
        let size = Vec2::new(camera.size.width as f32, camera.size.height as f32);
        let inside = place.cmpge(Vec2::ZERO).all() && place.cmplt(size).all();
        let target = match &ray {
            _ if !inside => FlowTarget::Outside,
            None => FlowTarget::Hidden,
            Some(_) => FlowTarget::Visible,
        };
        let centre = Vec2::new(x as f32 + 0.5, y as f32 + 0.5);
        (FlowPixel { flow_px: camera.way_in_image(centre, place), target }, ray.filter(|_| inside))
    }

    /// Which of these rays, of those in `active`, meet something before the point of their centre, a bit each.
    fn hidden(
        &self,
        other: &OtherInstant<'_>,
        camera_stays: bool,
        centres: &[MovingCentre],
        rays: &RayStream<4>,
        active: u32,
    ) -> u32 {
        let met = other.scene.accel.closest32(rays, active);
        let bit = |lane: usize, is: bool| u32::from(is) << lane;
        // Its own triangle, whatever rounding says of the distance.
        let other_than_itself = |lane: usize| {
            let itself = &centres[lane].hit;
            let then = other.instance(itself.instance);
            met.get(lane).is_some_and(|met| (Some(met.instance), met.triangle) != (then, itself.triangle))
        };
        let by_moving = lanes(active).fold(0, |bits, lane| bits | bit(lane, other_than_itself(lane)));
        // What stands still does not hide what is where it is seen now.
        let stays = |lane: usize| camera_stays && self.stays(other, &centres[lane].hit);
        let stays = lanes(active).fold(0, |bits, lane| bits | bit(lane, stays(lane)));
        let open = active & !by_moving & !stays;
        if open == 0 { by_moving } else { by_moving | self.still.accel.occluded32(&met.shortened(rays), open) }
    }

    /// Whether what was hit is in the same place in the other frame.
    fn stays(&self, other: &OtherInstant<'_>, hit: &Hit) -> bool {
        let Some(then) = other.instance(hit.instance) else { return false };
        let (now, then) = (&self.frame.instances[hit.instance as usize], &other.scene.instances[then as usize]);
        now.world_from_object == then.world_from_object && Arc::ptr_eq(&now.geometry.posed, &then.geometry.posed)
    }

    /// Where the point of a hit, seen from this side, is in the picture of the other frame, and the ray that must be free
    /// for the camera to see it: none if it faces away. `None` if it is behind the camera, or not there.
    fn point_then(
        &self,
        other: &OtherInstant<'_>,
        camera: &PinholeCamera,
        hit: &Hit,
        side: f32,
    ) -> Option<(Vec2, Option<Ray>)> {
        let then = other.instance(hit.instance)?;
        let (now, then) = (&self.frame.instances[hit.instance as usize], &other.scene.instances[then as usize]);
        if now.id != then.id || !Arc::ptr_eq(&now.geometry.mesh, &then.geometry.mesh) {
            return None;
        }
        let (position, outwards) = point_of(then, hit);
        let (place, _) = camera.project(position.into())?;
        let lens = Vec3A::from(camera.eye_for(position.into()));
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
