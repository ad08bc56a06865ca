//! Pictures as CARLA's cameras send them.

use crate::blueprint::SensorKind;
use crate::stream::{SensorHeader, image_header, image_message};
use endless_dataset::rgb_from_metres;
use endless_world::{FlowPixel, PinholeCamera, SensorFrame};
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
    Some(match kind {
        SensorKind::Rgb => {
            image_message(header, size, fov_deg, seen.rgb.data.iter().map(|&[r, g, b]| [b, g, r, OPAQUE]))
        }
        SensorKind::Depth => {
            image_message(header, size, fov_deg, seen.depth.data.iter().map(|&depth_m| depth_pixel(depth_m)))
        }
        SensorKind::Semantic => {
            image_message(header, size, fov_deg, seen.instance.data.iter().map(|p| [0, 0, p.tag.value(), OPAQUE]))
        }
        SensorKind::Instance => {
            let pixel = |p: &endless_world::InstancePixel| {
                let [low, high] = p.id.0.to_le_bytes();
                [high, low, p.tag.value(), OPAQUE]
            };
            image_message(header, size, fov_deg, seen.instance.data.iter().map(pixel))
        }
        SensorKind::Normals => {
            let normals = seen.normals.as_ref()?;
            image_message(header, size, fov_deg, normals.data.iter().map(|normal| normal_pixel(*normal, camera)))
        }
        SensorKind::OpticalFlow => {
            let flow = seen.flow_backward.as_ref()?;
            let mut message = image_header(header, size, fov_deg, 8 * flow.data.len());
            message.extend(flow.data.iter().flat_map(|&pixel| flow_pixel(pixel, size)).flat_map(f32::to_le_bytes));
            message
        }
        _ => return None,
    })
}

/// A share of the far plane's distance, as datasets have it.
fn depth_pixel(depth_m: f32) -> [u8; 4] {
    let [r, g, b] = rgb_from_metres(depth_m);
    [b, g, r, 255]
}

/// How the point of a pixel has moved since the picture before, to the right and upwards: 2 is the width and the height of the
/// picture, as Unreal has it. 0 where that is not known.
fn flow_pixel(to_before: [u16; 3], [width, height]: [u32; 2]) -> [f32; 2] {
    let Ok(Some(FlowPixel { flow_px, .. })) = FlowPixel::decoded(to_before) else { return [0.0; 2] };
    [-2.0 * flow_px.x / width as f32, 2.0 * flow_px.y / height as f32]
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
    use endless_world::FlowTarget;
    use glam::Vec2;

    #[test]
    fn flow_is_that_of_the_screen_and_since_the_picture_before() {
        let flow = |x, y| FlowPixel { flow_px: Vec2::new(x, y), target: FlowTarget::Visible }.encoded();
        // It was 80 pixels to the left and 30 above, in a picture of 320 by 240.
        assert_eq!(flow_pixel(flow(-80.0, -30.0), [320, 240]), [0.5, -0.25]);
        assert_eq!(flow_pixel(FlowPixel::UNKNOWN, [320, 240]), [0.0; 2]);
    }

    #[test]
    fn depths_are_read_as_clients_read_them() {
        for depth_m in [0.0, 0.31, 12.5, 999.9, 1000.0, 5000.0] {
            let [b, g, r, _] = depth_pixel(depth_m).map(f64::from);
            let read_m = (r + 256.0 * g + 65536.0 * b) / 16_777_215.0 * 1000.0;
            assert!((read_m - f64::from(depth_m.min(1000.0))).abs() < 1e-4, "{depth_m} {read_m}");
        }
    }
}
