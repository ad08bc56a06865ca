//! Keeps the views of the selected cameras clear of what is placed later.

use crate::geometry::Rect;
use endless_world::CameraSite;
use endless_world::math::f64::{atan2, wrap_angle};
use glam::DVec2;

/// No building stands so near around a camera, nor so near before it, metres.
const BUILT_AROUND_M: f64 = 1.5;
const BUILT_NEAR_M: f64 = 16.0;

/// Whether a pole would stand large in a camera's picture.
pub(crate) fn occludes_view(sites: &[CameraSite], at: DVec2) -> bool {
    sites.iter().any(|site| {
        let [x, y, _] = site.position.map(f64::from);
        let between = at - DVec2::new(x, y);
        let off_axis = wrap_angle(atan2(between.y, between.x) - f64::from(site.yaw_rad)).abs();
        let distance = between.length();
        distance < 3.0 || (distance < 13.0 && off_axis < f64::from(site.horizontal_fov_rad) / 2.0 + 0.05)
    })
}

/// Whether a tree or other wide thing would stand in a camera's view: near in front of it, or on its axis.
pub(crate) fn blocks_view(sites: &[CameraSite], at: DVec2, radius: f64) -> bool {
    sites.iter().any(|site| {
        let [x, y, _] = site.position.map(f64::from);
        let between = at - DVec2::new(x, y);
        let distance = between.length();
        let off_axis = wrap_angle(atan2(between.y, between.x) - f64::from(site.yaw_rad)).abs();
        let half = f64::from(site.horizontal_fov_rad) / 2.0;
        distance < radius + 1.8
            || (distance < 26.0 && off_axis < half + (radius / distance).min(1.0))
            || (distance < 45.0 && off_axis < 0.28 + radius / distance)
    })
}

/// Whether a building on a rectangle would stand around a camera, or large before its lens.
pub(crate) fn builds_into_view(sites: &[CameraSite], lot: &Rect) -> bool {
    sites.iter().any(|site| {
        let [x, y, _] = site.position.map(f64::from);
        let lens = DVec2::new(x, y);
        let half = f64::from(site.horizontal_fov_rad) / 2.0;
        let seen = |p: DVec2| {
            let between = p - lens;
            let off_axis = wrap_angle(atan2(between.y, between.x) - f64::from(site.yaw_rad)).abs();
            between.length() < BUILT_NEAR_M && off_axis < half
        };
        lot.meets(&Rect::around(lens, BUILT_AROUND_M)) || lot.corners().into_iter().any(seen)
    })
}
