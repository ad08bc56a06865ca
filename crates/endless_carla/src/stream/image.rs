//! The payload of cameras.

use super::message::push_floats;

/// Width, height and field of view in degrees.
pub fn image_header(message: &mut Vec<u8>, [width, height]: [u32; 2], fov_deg: f32) {
    message.extend(width.to_le_bytes());
    message.extend(height.to_le_bytes());
    push_floats(message, &[fov_deg]);
}

/// Width, height, field of view in degrees, and pixels of blue, green, red and opacity by rows.
pub fn image_payload(
    message: &mut Vec<u8>,
    [width, height]: [u32; 2],
    fov_deg: f32,
    bgra: impl Iterator<Item = [u8; 4]>,
) {
    image_header(message, [width, height], fov_deg);
    message.reserve(4 * width as usize * height as usize);
    message.extend(bgra.flatten());
}
