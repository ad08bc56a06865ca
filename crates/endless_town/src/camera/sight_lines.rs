//! Keeps the views of the selected cameras clear of what is placed later.

use endless_world::CameraSite;
use endless_world::math::f64::{atan2, wrap_angle};
use glam::DVec2;

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
