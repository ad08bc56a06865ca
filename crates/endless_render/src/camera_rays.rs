//! Rays through the samples of a camera's pixels.

use crate::accel::{Ray, RayStream};
use crate::sampling::SAMPLE_OFFSETS;
use crate::vec3x8::{Vec3x8, normalize, splat};
use endless_world::{DepthMeasure, Distortion, FAR_PLANE_M, Lens, PinholeCamera};
use glam::Vec3A;
use wide::f32x8;

/// The ray of a place where the lens shows nothing: so far below the world, and downwards, that it meets nothing.
const NOWHERE: Ray = Ray { origin: Vec3A::new(0.0, 0.0, -1.0e9), direction: Vec3A::NEG_Z, tmax: f32::MAX };

const FIRST_EIGHT: f32x8 = f32x8::new([0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]);

/// Whether the lens shows nothing where this ray belongs.
pub(crate) fn is_nowhere(ray: &Ray) -> bool {
    ray.origin == NOWHERE.origin
}

/// Unit ray from the lens through a pixel's sample.
pub(crate) fn sample_ray(camera: &PinholeCamera, x: u32, y: u32, sample: usize) -> Ray {
    let offset = SAMPLE_OFFSETS[sample];
    let (x, y) = (x as f32 + 0.5 + offset.x, y as f32 + 0.5 + offset.y);
    match camera.lens {
        Lens::Perspective(_) => {
            let direction = Vec3A::from(camera.ray_through(x, y));
            Ray { origin: Vec3A::from(camera.position), direction, tmax: f32::MAX }
        }
        _ => ray_of_aim(camera, aim_through(camera, x, y)),
    }
}

/// What differs from ray to ray: the direction of one that leaves the lens, 0 where the lens shows nothing; where all
/// rays are parallel, where one starts.
fn aim_through(camera: &PinholeCamera, x: f32, y: f32) -> Vec3A {
    if !camera.lens.is_central() {
        return camera.ray_origin(x, y).into();
    }
    if camera.shows(x, y) { camera.ray_through(x, y).into() } else { Vec3A::ZERO }
}

/// The ray of what differs from ray to ray.
pub(crate) fn ray_of_aim(camera: &PinholeCamera, aim: Vec3A) -> Ray {
    if !camera.lens.is_central() {
        return Ray { origin: aim, direction: camera.world_from_camera.z_axis.normalize().into(), tmax: f32::MAX };
    }
    if aim == Vec3A::ZERO { NOWHERE } else { Ray { origin: camera.position.into(), direction: aim, tmax: f32::MAX } }
}

/// One of eight.
pub(crate) fn lane_ray(camera: &PinholeCamera, aims: &Vec3x8, lane: usize) -> Ray {
    ray_of_aim(camera, Vec3A::from_array(aims.each_ref().map(|axis| axis.as_array()[lane])))
}

/// Where eight rays have come after these distances. Where the lens shows nothing, no place means anything.
pub(crate) fn places8(camera: &PinholeCamera, aims: &Vec3x8, distances: f32x8) -> Vec3x8 {
    if camera.lens.is_central() {
        let origin = splat(camera.position.into());
        return std::array::from_fn(|k| origin[k] + aims[k] * distances);
    }
    let direction = splat(camera.world_from_camera.z_axis.normalize().into());
    std::array::from_fn(|k| aims[k] + direction[k] * distances)
}

/// Sets the origins and directions of a row of rays that are traced together.
pub(crate) fn set_row<const N: usize>(camera: &PinholeCamera, rays: &mut RayStream<N>, row: usize, aims: Vec3x8) {
    let Lens::Perspective(_) = camera.lens else {
        for lane in 0..8 {
            let tmax = rays.tmax[row].as_array()[lane];
            rays.set(8 * row + lane, &Ray { tmax, ..lane_ray(camera, &aims, lane) });
        }
        return;
    };
    for ((origin, at), (direction, aim)) in
        rays.origin.iter_mut().zip(camera.position.to_array()).zip(rays.direction.iter_mut().zip(aims))
    {
        origin[row] = f32x8::splat(at);
        direction[row] = aim;
    }
}

/// What tells the rays through a sample of the pixels `x0..x1` of a line, the last one's repeated: those of
/// [`sample_ray`], eight side by side. See [`lane_ray`].
pub(crate) fn aims8(camera: &PinholeCamera, x0: u32, x1: u32, y: u32, sample: usize) -> Vec3x8 {
    let offset = SAMPLE_OFFSETS[sample];
    // Whole numbers of this size are exact.
    let pixels = (f32x8::splat(x0 as f32) + FIRST_EIGHT).fast_min(f32x8::splat((x1 - 1) as f32));
    let across = pixels + f32x8::HALF + f32x8::splat(offset.x);
    aims_through(camera, across, f32x8::splat(y as f32 + 0.5 + offset.y))
}

/// What tells the rays through places of the picture.
pub(crate) fn aims_through(camera: &PinholeCamera, x: f32x8, y: f32x8) -> Vec3x8 {
    let Lens::Perspective(distortion) = camera.lens else {
        let (x, y) = (x.to_array(), y.to_array());
        let aims: [Vec3A; 8] = std::array::from_fn(|i| aim_through(camera, x[i], y[i]));
        return [0, 1, 2].map(|axis| f32x8::new(aims.map(|aim| aim[axis])));
    };
    let k = &camera.intrinsics;
    let across = (x - f32x8::splat(k.cx)) / f32x8::splat(k.fx);
    let down = (y - f32x8::splat(k.cy)) / f32x8::splat(k.fy);
    let [across, down] = undistort8(distortion, [across, down]);
    let m = &camera.world_from_camera;
    // Each splat from its own number: of an array, the compiler would write all to the stack, to read it back at once.
    normalize(std::array::from_fn(|axis| {
        f32x8::splat(m.x_axis[axis]) * across + f32x8::splat(m.y_axis[axis]) * down + f32x8::splat(m.z_axis[axis])
    }))
}

/// [`Distortion::undistort`] for eight image points.
fn undistort8(lens: Distortion, [x, y]: [f32x8; 2]) -> [f32x8; 2] {
    if lens == Distortion::NONE {
        return [x, y];
    }
    let one = f32x8::ONE;
    let (k1, k2) = (f32x8::splat(lens.k1), f32x8::splat(lens.k2));
    let (three_k1, five_k2) = (f32x8::splat(3.0 * lens.k1), f32x8::splat(5.0 * lens.k2));
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

/// Depth as the lens measures it, never beyond the far plane.
pub(crate) fn measured_depth(camera: &PinholeCamera, ray: &Ray, t: f32) -> f32 {
    let depth = match camera.lens.depth_measure() {
        DepthMeasure::Planar => t * ray.direction.dot(Vec3A::from(camera.world_from_camera.z_axis)),
        DepthMeasure::Distance => t,
    };
    depth.min(FAR_PLANE_M)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::{Blas, Tlas};
    use crate::sampling::SAMPLES;
    use endless_world::{CameraRay, CameraSite, ImageSize, LensModel, Mount, math};
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
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let straight = PinholeCamera::new(&site, ImageSize { width: 325, height: 180 });
        let bent = straight.clone().with_distortion(Distortion { k1: -0.2, k2: 0.05 });
        let behind = |lens, fov_deg: f32| straight.clone().with_lens(lens, fov_deg.to_radians());
        let fisheye = behind(LensModel::Fisheye { k: [-0.01, 0.004, 0.0, 0.0] }, 190.0);
        let round = behind(LensModel::Equirectangular, 360.0);
        let parallel = behind(LensModel::Orthographic { width_m: 60.0 }, 60.0);
        for camera in [straight, bent, fisheye, round, parallel] {
            for (y, x0) in (0..180).flat_map(|y| (0..325).step_by(8).map(move |x0| (y, x0))) {
                let x1 = (x0 + 8).min(325);
                for sample in 0..SAMPLES {
                    let aims = aims8(&camera, x0, x1, y, sample);
                    let mut rays = RayStream::<1>::NONE;
                    rays.tmax = [f32x8::splat(f32::MAX)];
                    set_row(&camera, &mut rays, 0, aims);
                    for (i, x) in (x0..x1).enumerate() {
                        let (one, shown) = (sample_ray(&camera, x, y, sample), SAMPLE_OFFSETS[sample]);
                        let shown = camera.ray(x as f32 + 0.5 + shown.x, y as f32 + 0.5 + shown.y);
                        assert_eq!(shown.is_none(), is_nowhere(&one));
                        if let Some(CameraRay { origin, direction }) = shown {
                            assert_eq!((one.origin, one.direction), (origin.into(), direction.into()));
                        }
                        for ray in [rays.ray(i), lane_ray(&camera, &aims, i)] {
                            assert_eq!((ray.origin, ray.direction), (one.origin, one.direction));
                        }
                        let place = places8(&camera, &aims, f32x8::splat(7.3)).map(|axis| axis.to_array()[i]);
                        if shown.is_some() {
                            assert_eq!(Vec3A::from_array(place), one.origin + one.direction * 7.3);
                        }
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
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        let camera = PinholeCamera::new(&site, ImageSize { width: 320, height: 180 });
        for y in (0..180).step_by(7) {
            for x in (0..320).step_by(11) {
                let ray = sample_ray(&camera, x, y, 0);
                let hit = accel.closest(&ray).expect("the ground fills the picture");
                let wanted = depth_of_ground(&site, &camera, x, y);
                let depth = f64::from(measured_depth(&camera, &ray, hit.t));
                assert!((depth - wanted).abs() < 1e-4, "pixel {x}, {y}: {depth}, not {wanted}");
            }
        }
    }
}
