//! The extent of an object: its box in space, and the rectangle around its projection.

use super::ObjectShape;
use crate::accel::corners;
use crate::image_rect::{ImageRect, sphere_in_image};
use crate::scene::Instance;
use endless_world::math::UnfusedMatrix;
use endless_world::{DepthMeasure, Lens, PinholeCamera};
use glam::{Affine3A, Vec2, Vec3, Vec3A};

/// What is nearer has no place in the picture, metres of depth.
const NEAR_M: f32 = 0.1;

impl ObjectShape {
    /// Smallest and largest corner of the box around it in a frame of reference, metres. It is tight: it follows from the
    /// vertices, except for pieces that lie in that very frame, whose own boxes are tight already.
    pub fn bounds_in(&self, world_from_frame: &Affine3A) -> (Vec3, Vec3) {
        let frame_from_world = world_from_frame.inverse_unfused();
        let (mut low, mut high) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
        for instance in &self.instances {
            if instance.world_from_object == *world_from_frame {
                let (a, b) = instance.geometry.posed.blas.bounds();
                (low, high) = (low.min(a), high.max(b));
                continue;
            }
            let frame_from_object = frame_from_world * instance.world_from_object;
            for &vertex in instance.geometry.posed.positions() {
                let p = frame_from_object.transform_point3a(vertex.into());
                (low, high) = (low.min(p), high.max(p));
            }
        }
        (low.into(), high.into())
    }

    /// The rectangle around its projection, `[left, top, right, bottom]` in pixels, also where that lies outside the
    /// picture. Vertices beside or behind the camera are left out; `None` if there are no others.
    pub fn image_bounds(&self, camera: &PinholeCamera) -> Option<[f32; 4]> {
        let points = self.instances.iter().flat_map(|instance| {
            let place = |&vertex: &Vec3| instance.world_from_object.transform_point3(vertex);
            instance.geometry.posed.positions().iter().map(place)
        });
        rectangle(camera, points)
    }

    /// A rectangle that its projection does not leave, of boxes that hold its pieces; `None` if one of these reaches a
    /// perspective camera, so that there is no such rectangle, or if another lens shows nothing of them.
    pub(super) fn rough_image_bounds(&self, camera: &PinholeCamera) -> Option<[f32; 4]> {
        let boxes = || self.instances.iter().flat_map(Instance::close_bounds);
        if !matches!(camera.lens, Lens::Perspective(_)) {
            let spheres = boxes().map(|(low, high)| ((low + high) * 0.5, (high - low).length() * 0.5));
            let seen = spheres.flat_map(|(centre, radius)| sphere_in_image(camera, centre.into(), radius));
            return seen
                .flatten()
                .reduce(ImageRect::joined)
                .map(|ImageRect { low, high }| [low.x, low.y, high.x, high.y]);
        }
        let corners: Vec<Vec3> = boxes().flat_map(corners).map(Vec3::from).collect();
        let ahead = |corner: &Vec3| camera.camera_from_world(*corner).z >= NEAR_M;
        corners.iter().all(ahead).then(|| rectangle(camera, corners.into_iter())).flatten()
    }

    /// Largest depth as the lens measures it, metres, or a little more.
    pub fn farthest_depth(&self, camera: &PinholeCamera) -> f32 {
        if camera.lens.depth_measure() == DepthMeasure::Distance {
            let lens = Vec3A::from(camera.position);
            let distance = |(low, high): (Vec3A, Vec3A)| ((low - lens).abs()).max((high - lens).abs()).length();
            return self.instances.iter().flat_map(Instance::close_bounds).map(distance).fold(0.0, f32::max) * 1.001;
        }
        let forward = Vec3A::from(camera.world_from_camera.z_axis);
        let origin = Vec3A::from(camera.position);
        let depth = |(low, high): (Vec3A, Vec3A)| {
            let corner = Vec3A::select(forward.cmpgt(Vec3A::ZERO), high, low);
            (corner - origin).dot(forward)
        };
        self.instances.iter().flat_map(Instance::close_bounds).map(depth).fold(f32::NEG_INFINITY, f32::max)
    }
}

/// Around the projections of those of the points that lie before the camera.
fn rectangle(camera: &PinholeCamera, points: impl Iterator<Item = Vec3>) -> Option<[f32; 4]> {
    let (mut low, mut high) = (Vec2::INFINITY, Vec2::NEG_INFINITY);
    for (at, depth) in points.filter_map(|point| camera.project(point)) {
        if depth >= NEAR_M {
            (low, high) = (low.min(at), high.max(at));
        }
    }
    (low.x <= high.x).then_some([low.x, low.y, high.x, high.y])
}
