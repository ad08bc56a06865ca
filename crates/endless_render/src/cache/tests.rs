//! What pixels hold, against geometry.

use super::bake::{planar_depth, sample_ray};
use crate::accel::{Accel, Blas};
use endless_world::{CameraSite, ImageSize, Mount, PinholeCamera, math};
use glam::{Affine3A, DVec3, Vec3};
use std::sync::Arc;

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
    let accel = Accel::build(vec![(Arc::new(ground), Affine3A::IDENTITY)]);
    let site = CameraSite {
        name: "mast".into(),
        position: [3.0, -5.0, 7.5],
        yaw_rad: 0.7,
        down_tilt_rad: 0.62,
        horizontal_fov_rad: 1.2,
        mount: Mount::Pole,
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
