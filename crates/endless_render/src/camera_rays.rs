//! Rays through the samples of a camera's pixels.

use crate::accel::Ray;
use crate::sampling::SAMPLE_OFFSETS;
use crate::vec3x8::{Vec3x8, normalize};
use endless_world::{Distortion, FAR_PLANE_M, PinholeCamera};
use glam::Vec3A;
use wide::f32x8;

/// Unit ray from the lens through a pixel's sample.
pub(crate) fn sample_ray(camera: &PinholeCamera, x: u32, y: u32, sample: usize) -> Ray {
    let offset = SAMPLE_OFFSETS[sample];
    let direction = camera.ray_through(x as f32 + 0.5 + offset.x, y as f32 + 0.5 + offset.y);
    Ray { origin: Vec3A::from(camera.position), direction: Vec3A::from(direction), tmax: f32::MAX }
}

/// Directions of the rays through a sample of the pixels `x0..x1` of a line, the last one's repeated: those of
/// [`sample_ray`], eight side by side.
pub(crate) fn directions8(camera: &PinholeCamera, x0: u32, x1: u32, y: u32, sample: usize) -> Vec3x8 {
    let offset = SAMPLE_OFFSETS[sample];
    let across = f32x8::new(std::array::from_fn(|i| (x0 + i as u32).min(x1 - 1) as f32 + 0.5 + offset.x));
    directions_through(camera, across, f32x8::splat(y as f32 + 0.5 + offset.y))
}

/// Directions of the rays through places of the picture: those of [`PinholeCamera::ray_through`].
pub(crate) fn directions_through(camera: &PinholeCamera, x: f32x8, y: f32x8) -> Vec3x8 {
    let k = &camera.intrinsics;
    let across = (x - f32x8::splat(k.cx)) / f32x8::splat(k.fx);
    let down = (y - f32x8::splat(k.cy)) / f32x8::splat(k.fy);
    let [across, down] = undistort8(camera.distortion, [across, down]);
    let m = &camera.world_from_camera;
    normalize([0, 1, 2].map(|axis| {
        let [x, y, z] = [m.x_axis[axis], m.y_axis[axis], m.z_axis[axis]].map(f32x8::splat);
        x * across + y * down + z
    }))
}

/// [`Distortion::undistort`] for eight image points.
fn undistort8(lens: Distortion, [x, y]: [f32x8; 2]) -> [f32x8; 2] {
    if lens == Distortion::NONE {
        return [x, y];
    }
    let [one, three_k1, five_k2] = [1.0, 3.0 * lens.k1, 5.0 * lens.k2].map(f32x8::splat);
    let [k1, k2] = [lens.k1, lens.k2].map(f32x8::splat);
    let bent = (x * x + y * y).sqrt();
    let mut r = bent * (one - bent * bent * k1);
    for _ in 0..Distortion::NEWTON_STEPS {
        let r2 = r * r;
        let miss = r * (one + r2 * (k1 + k2 * r2)) - bent;
        r -= miss / (one + r2 * (three_k1 + five_k2 * r2)).fast_max(f32x8::splat(0.05));
    }
    let longer = bent.simd_gt(f32x8::ZERO).select(r / bent, one);
    [x * longer, y * longer]
}

/// Depth along the optical axis, never beyond the far plane.
pub(crate) fn planar_depth(camera: &PinholeCamera, ray: &Ray, t: f32) -> f32 {
    let forward = Vec3A::from(camera.world_from_camera.z_axis);
    (t * ray.direction.dot(forward)).min(FAR_PLANE_M)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{Blas, Tlas};
    use crate::sampling::SAMPLES;
    use endless_world::{CameraSite, ImageSize, Mount, math};
    use glam::{Affine3A, DVec3, Vec3};
    use std::sync::Arc;

    #[test]
    fn eight_rays_are_those_of_one_after_another() {
        let site = CameraSite {
            name: "mast".into(),
            position: [3.0, -5.0, 7.5],
            yaw_rad: 2.7,
            down_tilt_rad: 0.43,
            horizontal_fov_rad: 1.1,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let straight = PinholeCamera::new(&site, ImageSize { width: 325, height: 180 });
        let bent = straight.clone().with_distortion(Distortion { k1: -0.2, k2: 0.05 });
        for camera in [straight, bent] {
            for (y, x0) in (0..180).flat_map(|y| (0..325).step_by(8).map(move |x0| (y, x0))) {
                let x1 = (x0 + 8).min(325);
                for sample in 0..SAMPLES {
                    let [dx, dy, dz] = directions8(&camera, x0, x1, y, sample).map(f32x8::to_array);
                    for (i, x) in (x0..x1).enumerate() {
                        let direction = Vec3A::new(dx[i], dy[i], dz[i]);
                        assert_eq!(direction, sample_ray(&camera, x, y, sample).direction);
                    }
                }
            }
        }
    }

    /// Depth of the plane z = 0 through a pixel's centre, in double precision.
    fn depth_of_ground(site: &CameraSite, camera: &PinholeCamera, x: u32, y: u32) -> f64 {
        let (sin_yaw, cos_yaw) = math::f64::sin_cos(f64::from(site.yaw_rad));
        let (sin_tilt, cos_tilt) = math::f64::sin_cos(f64::from(site.down_tilt_rad));
        let forward = DVec3::new(cos_yaw * cos_tilt, sin_yaw * cos_tilt, -sin_tilt);
        let right = DVec3::new(sin_yaw, -cos_yaw, 0.0);
        let k = &camera.intrinsics;
        let across = (f64::from(x) + 0.5 - f64::from(k.cx)) / f64::from(k.fx);
        let down = (f64::from(y) + 0.5 - f64::from(k.cy)) / f64::from(k.fy);
        // One metre of depth along this ray sinks by the z of it.
        let ray = forward + right * across + forward.cross(right) * down;
        f64::from(site.position[2]) / -ray.z
    }

    #[test]
    fn the_depth_of_a_plane_is_right_to_a_tenth_of_a_millimetre() {
        let corners = [(-60.0, -60.0), (60.0, -60.0), (60.0, 60.0), (-60.0, 60.0)];
        let ground = Blas::build(&corners.map(|(x, y)| Vec3::new(x, y, 0.0)), &[[0, 1, 2], [0, 2, 3]]);
        let accel = Tlas::build(vec![(Arc::new(ground), Affine3A::IDENTITY)]);
        let site = CameraSite {
            name: "mast".into(),
            position: [3.0, -5.0, 7.5],
            yaw_rad: 0.7,
            down_tilt_rad: 0.62,
            horizontal_fov_rad: 1.2,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let camera = PinholeCamera::new(&site, ImageSize { width: 320, height: 180 });
        for y in (0..180).step_by(7) {
            for x in (0..320).step_by(11) {
                let ray = sample_ray(&camera, x, y, 0);
                let hit = accel.closest(&ray).expect("the ground fills the picture");
                let wanted = depth_of_ground(&site, &camera, x, y);
                let depth = f64::from(planar_depth(&camera, &ray, hit.t));
                assert!((depth - wanted).abs() < 1e-4, "pixel {x}, {y}: {depth}, not {wanted}");
            }
        }
    }
}
