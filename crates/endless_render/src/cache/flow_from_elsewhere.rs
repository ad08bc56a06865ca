//! Optical flow of a camera that moves: every point that it shows is looked for from where it is in the other instant.

use super::flow::{FlowPass, RAYS};
use super::other_instant::OtherInstant;
use crate::accel::{Ray, RayStream, lanes};
use crate::camera_rays::{is_nowhere, sample_ray};
use endless_world::{FlowPixel, FlowTarget, Image, PinholeCamera};
use glam::{Vec2, Vec3A};
use rayon::prelude::*;

/// How far away the sky is taken to be, metres: no flow of it tells the difference.
const SKY_M: f32 = 1.0e7;

impl FlowPass<'_> {
    /// Flow to an instant at which the camera is elsewhere.
    pub(super) fn flow_from_elsewhere(
        &self,
        other: &OtherInstant<'_>,
        camera: &PinholeCamera,
        sides: &[f32],
    ) -> Image<[u16; 3]> {
        let size = self.bake.camera.size;
        let mut image = Image::filled(size, FlowPixel::UNKNOWN);
        let width = size.width as usize;
        image.data.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
            for (first, flows) in (0..width).step_by(RAYS).zip(row.chunks_mut(RAYS)) {
                self.look_for(other, camera, [first, y], flows);
            }
        });
        for (centres, sides) in self.centres.chunks(RAYS).zip(sides.chunks(RAYS)) {
            self.follow(other, camera, centres, sides, &mut image.data);
        }
        image
    }

    /// The flow of pixels from here on, as if nothing that moves covered them.
    fn look_for(&self, other: &OtherInstant<'_>, camera: &PinholeCamera, [x0, y]: [usize; 2], flows: &mut [[u16; 3]]) {
        let mut found = [FlowPixel::STILL; RAYS];
        let (mut rays, mut active) = (RayStream::NONE, 0u32);
        for (lane, flow) in flows.iter_mut().enumerate() {
            let (x, y) = ((x0 + lane) as u32, y as u32);
            let Some((place, ray)) = self.still_point_then(camera, x, y) else { continue };
            let (towards, ray) = self.flow_towards([x, y], place, ray);
            if let Some(ray) = ray {
                rays.set(lane, &ray);
                active |= 1 << lane;
            }
            found[lane] = towards;
            *flow = found[lane].encoded();
        }
        if active == 0 {
            return;
        }
        let by_moving = other.scene.accel.occluded32(&rays, active);
        let open = active & !by_moving;
        let by_still = if open == 0 { 0 } else { self.still.accel.occluded32(&rays, open) };
        for lane in lanes(by_moving | by_still) {
            flows[lane] = FlowPixel { target: FlowTarget::Hidden, ..found[lane] }.encoded();
        }
    }

    /// Where the still point behind a pixel's centre is in the other picture, and the ray that must be free for the camera to
    /// see it: none if it faces away. `None` if the camera cannot see there, or the lens shows nothing here.
    fn still_point_then(&self, camera: &PinholeCamera, x: u32, y: u32) -> Option<(Vec2, Option<Ray>)> {
        let ray = sample_ray(&self.bake.camera, x, y, 0);
        if is_nowhere(&ray) {
            return None;
        }
        let still = self.bake.gbuffer.pixel((y * self.bake.camera.size.width + x) as usize);
        if still.is_sky(0) {
            let place = camera.project((Vec3A::from(camera.position) + ray.direction * SKY_M).into())?.0;
            return Some((place, Some(Ray { origin: camera.position.into(), ..ray })));
        }
        let facet = still.facet(&ray, 0);
        let place = camera.project(facet.position.into())?.0;
        let lens = Vec3A::from(camera.eye_for(facet.position.into()));
        let distance = facet.position.distance(lens);
        let direction = (facet.position - lens) / distance;
        let facing = -direction.dot(facet.geometric_normal);
        // A little before it, and more where the ray grazes it: rounding may let it meet the surface too early.
        let short = (2e-3 + 2e-5 * distance + 1e-6 * facet.position.abs().max_element()) / facing.max(0.02);
        let ray = Ray { origin: lens, direction, tmax: distance - short };
        Some((place, (facing > 0.0).then_some(ray)))
    }
}
