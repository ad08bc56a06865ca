//! The payload of cameras.

use super::message::push_floats;

/// Width, height and field of view in degrees.
pub fn image_header(message: &mut Vec<u8>, [width, height]: [u32; 2], fov_deg: f32) {
    message.extend(width.to_le_bytes());
    message.extend(height.to_le_bytes());
    push_floats(message, &[fov_deg]);
}

/// Width, height, field of view in degrees, and pixels of blue, green, red and opacity by rows, as many as there are.
pub fn image_payload(
    message: &mut Vec<u8>,
    [width, height]: [u32; 2],
    fov_deg: f32,
    bgra: impl ExactSizeIterator<Item = [u8; 4]>,
) {
    image_header(message, [width, height], fov_deg);
    let first = message.len();
    // Pixel by pixel: byte by byte takes several times as long.
    message.resize(first + 4 * bgra.len(), 0);
    for (place, pixel) in message[first..].as_chunks_mut().0.iter_mut().zip(bgra) {
        *place = pixel;
    }
}
