//! Pictures as CARLA's cameras send them.

use crate::blueprint::SensorKind;
use crate::stream::{SensorHeader, image_payload};
use endless_dataset::rgb_from_metres;
use endless_world::{PinholeCamera, SensorFrame};
use glam::Vec3;

/// The message of a camera; `None` of those that are not served.
pub(super) fn message(
    header: &SensorHeader,
    kind: SensorKind,
    fov_deg: f32,
    seen: &SensorFrame,
    camera: &PinholeCamera,
) -> Option<Vec<u8>> {
    const OPAQUE: u8 = 255;
    let size = [seen.rgb.size.width, seen.rgb.size.height];
    let mut message = header.begin(12 + 4 * seen.rgb.data.len());
    let out = &mut message;
    match kind {
        SensorKind::Rgb => {
            image_payload(out, size, fov_deg, seen.rgb.data.iter().map(|&[r, g, b]| [b, g, r, OPAQUE]));
        }
        SensorKind::Depth => {
            image_payload(out, size, fov_deg, seen.depth.data.iter().map(|&depth_m| depth_pixel(depth_m)));
        }
        SensorKind::Semantic => {
            image_payload(out, size, fov_deg, seen.instance.data.iter().map(|p| [0, 0, p.tag.value(), OPAQUE]));
        }
        SensorKind::Instance => {
            let pixel = |p: &endless_world::InstancePixel| {
                let [low, high] = p.id.0.to_le_bytes();
                [high, low, p.tag.value(), OPAQUE]
            };
            image_payload(out, size, fov_deg, seen.instance.data.iter().map(pixel));
        }
        SensorKind::Normals => {
            let normals = seen.normals.as_ref()?;
            image_payload(out, size, fov_deg, normals.data.iter().map(|normal| normal_pixel(*normal, camera)));
        }
        _ => return None,
    }
    Some(message)
}

/// A share of the far plane's distance, as datasets have it.
fn depth_pixel(depth_m: f32) -> [u8; 4] {
    let [r, g, b] = rgb_from_metres(depth_m);
    [b, g, r, 255]
}

/// The world's x, y and z in red, green and blue; the sky is black.
fn normal_pixel(normal: [u16; 3], camera: &PinholeCamera) -> [u8; 4] {
    if normal == [0; 3] {
        return [0, 0, 0, 255];
    }
    let in_camera = Vec3::from_array(normal.map(|n| f32::from(n) / 65535.0 * 2.0 - 1.0));
    let world = camera.world_from_camera * in_camera;
    // CARLA's y axis points south.
    let [r, g, b] = [world.x, -world.y, world.z].map(|n| ((n + 1.0) * 127.5).round() as u8);
    [b, g, r, 255]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn depths_are_read_as_clients_read_them() {
        for depth_m in [0.0, 0.31, 12.5, 999.9, 1000.0, 5000.0] {
            let [b, g, r, _] = depth_pixel(depth_m).map(f64::from);
            let read_m = (r + 256.0 * g + 65536.0 * b) / 16_777_215.0 * 1000.0;
            assert!((read_m - f64::from(depth_m.min(1000.0))).abs() < 1e-4, "{depth_m} {read_m}");
        }
    }
}
