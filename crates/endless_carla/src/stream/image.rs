//! The payload of cameras.

use super::message::push_floats;

/// Width, height, field of view in degrees, and pixels of blue, green, red and opacity by rows.
pub fn image_payload(
    message: &mut Vec<u8>,
    [width, height]: [u32; 2],
    fov_deg: f32,
    bgra: impl Iterator<Item = [u8; 4]>,
) {
    message.extend(width.to_le_bytes());
    message.extend(height.to_le_bytes());
    push_floats(message, &[fov_deg]);
    message.reserve(4 * width as usize * height as usize);
    message.extend(bgra.flatten());
}
