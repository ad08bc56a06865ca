//! Where things may be in a picture, whatever its lens. Conservative.

use endless_world::{Fisheye, Intrinsics, Lens, PinholeCamera, math};
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, PI, TAU};

/// A rectangle of a picture, pixels; it may reach beyond the picture.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ImageRect {
    pub(crate) low: Vec2,
    pub(crate) high: Vec2,
}

impl ImageRect {
    /// Everywhere.
    const ALL: Self = Self { low: Vec2::NEG_INFINITY, high: Vec2::INFINITY };

    /// Around both.
    pub(crate) fn joined(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }

    fn around(points: impl IntoIterator<Item = Vec2>) -> Self {
        let none = Self { low: Vec2::INFINITY, high: Vec2::NEG_INFINITY };
        points.into_iter().fold(none, |all, p| all.joined(Self { low: p, high: p }))
    }

    fn in_pixels(self, k: &Intrinsics) -> Self {
        let pixel = |p: Vec2| p * Vec2::new(k.fx, k.fy) + Vec2::new(k.cx, k.cy);
        Self { low: pixel(self.low), high: pixel(self.high) }
    }
}

/// By how much angles are taken to be larger than they are, radians: rounding.
const SLACK: f32 = 2e-5;

/// Rectangles that hold what a lens that is not perspective shows of a sphere of the world: two where the picture's left
/// and right edges meet, none if it shows nothing of it.
pub(crate) fn sphere_in_image(camera: &PinholeCamera, centre: Vec3, radius: f32) -> [Option<ImageRect>; 2] {
    let p = camera.camera_from_world(centre);
    let k = &camera.intrinsics;
    if camera.lens == Lens::Orthographic {
        let (middle, reach) = (p.truncate(), Vec2::splat(radius * 1.001 + 1e-3));
        let seen = ImageRect { low: middle - reach, high: middle + reach };
        return [(p.z + reach.x > 0.0).then(|| seen.in_pixels(k)), None];
    }
    let distance = p.length();
    if distance <= radius * 1.01 + 1e-2 {
        return [Some(ImageRect::ALL), None];
    }
    let reach = math::asin(radius / distance) * 1.0001 + SLACK;
    let seen = match &camera.lens {
        Lens::Fisheye(fisheye) => [fisheye_cone(fisheye, p, reach), None],
        Lens::Equirectangular => equirectangular_cone(p, reach),
        Lens::Perspective(_) | Lens::Orthographic => [Some(ImageRect::ALL), None],
    };
    seen.map(|rect| rect.map(|rect| rect.in_pixels(k)))
}

/// What a fisheye shows of the directions within an angle of that of a point: a piece of a ring.
fn fisheye_cone(fisheye: &Fisheye, p: Vec3, reach: f32) -> Option<ImageRect> {
    let across = p.truncate().length();
    let angle = math::atan2(across, p.z);
    let (nearest, farthest) = (angle - reach, angle + reach);
    if nearest > fisheye.max_angle_rad() {
        return None;
    }
    let outer = fisheye.radius_of(farthest);
    if nearest <= 0.0 || farthest >= PI {
        return Some(ImageRect { low: Vec2::splat(-outer), high: Vec2::splat(outer) });
    }
    let inner = fisheye.radius_of(nearest);
    let turn = math::asin((math::sin(reach) / math::sin(angle)).min(1.0)) + SLACK;
    let middle = math::atan2(p.y, p.x);
    let at = |turn: f32, radius: f32| {
        let (sin, cos) = math::sin_cos(turn);
        Vec2::new(cos, sin) * radius
    };
    let corners = [-turn, turn].into_iter().flat_map(|side| [inner, outer].map(|radius| at(middle + side, radius)));
    // Where the outer rim is farthest to one side.
    let extremes = (-4i8..=4).map(|quarter| f32::from(quarter) * FRAC_PI_2).filter(|t| (t - middle).abs() <= turn);
    Some(ImageRect::around(corners.chain(extremes.map(|t| at(t, outer)))))
}

/// The same of longitude and latitude.
fn equirectangular_cone(p: Vec3, reach: f32) -> [Option<ImageRect>; 2] {
    let (longitude, latitude) = (math::atan2(p.x, p.z), math::atan2(p.y, Vec2::new(p.x, p.z).length()));
    let (low, high) = (latitude - reach, latitude + reach);
    let strip = |from: f32, to: f32| ImageRect { low: Vec2::new(from, low), high: Vec2::new(to, high) };
    if low <= -FRAC_PI_2 || high >= FRAC_PI_2 {
        return [Some(strip(-PI, PI)), None];
    }
    let turn = math::asin((math::sin(reach) / math::cos(latitude)).min(1.0)) + SLACK;
    let (from, to) = (longitude - turn, longitude + turn);
    let again = if from < -PI {
        Some(strip(from + TAU, to + TAU))
    } else if to > PI {
        Some(strip(from - TAU, to - TAU))
    } else {
        None
    };
    [Some(strip(from, to)), again]
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{CameraSite, ImageSize, LensModel, Mount};
    use proptest::prelude::*;

    fn camera(lens: LensModel, fov_deg: f32) -> PinholeCamera {
        let site = CameraSite {
            name: "t".into(),
            position: [3.0, -4.0, 7.0],
            yaw_rad: 2.1,
            down_tilt_rad: 0.5,
            horizontal_fov_rad: fov_deg.to_radians(),
            lens,
            mount: Mount::Pole,
            roll_rad: 0.07,
        };
        PinholeCamera::new(&site, ImageSize { width: 640, height: 360 })
    }

    proptest! {
        #[test]
        fn no_point_of_a_sphere_is_shown_elsewhere(
            centre in [-40f32..40.0, -40f32..40.0, -10f32..30.0],
            radius in 0.01f32..9.0,
            direction in [-1f32..1.0, -1f32..1.0, -1f32..1.0],
            share in 0.9f32..1.0,
        ) {
            let (centre, direction) = (Vec3::from_array(centre), Vec3::from_array(direction));
            prop_assume!(direction.length() > 0.1);
            let point = centre + direction.normalize() * (radius * share);
            for camera in [
                camera(LensModel::Fisheye { k: [0.0; 4] }, 180.0),
                camera(LensModel::Fisheye { k: [-0.01, 0.004, 0.0, 0.0] }, 215.0),
                camera(LensModel::Equirectangular, 360.0),
                camera(LensModel::Orthographic { width_m: 30.0 }, 60.0),
            ] {
                let Some((at, _)) = camera.project(point) else { continue };
                let rects = sphere_in_image(&camera, centre, radius);
                let holds = |r: &ImageRect| at.cmpge(r.low - 0.05).all() && at.cmple(r.high + 0.05).all();
                prop_assert!(rects.iter().flatten().any(holds), "{at} is not in {rects:?} of {:?}", camera.lens);
            }
        }
    }

    #[test]
    fn a_small_thing_takes_little_room() {
        for (lens, fov) in [(LensModel::Fisheye { k: [0.0; 4] }, 180.0), (LensModel::Equirectangular, 360.0)] {
            let camera = camera(lens, fov);
            for direction in [Vec3::Z, Vec3::new(0.6, 0.1, 0.8), Vec3::new(-0.5, 0.3, 0.4)] {
                let rects =
                    sphere_in_image(&camera, camera.position + camera.world_from_camera * direction * 30.0, 0.3);
                let sizes = rects.iter().flatten().map(|r| (r.high - r.low).max_element());
                assert!(rects[0].is_some() && sizes.fold(0.0, f32::max) < 20.0, "{rects:?}");
            }
        }
    }
}
