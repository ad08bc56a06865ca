//! The messages of cameras.

use super::message::{SensorHeader, push_floats};

/// What comes before the pixels, bytes: the header of all messages, width, height and field of view.
const BEFORE_PIXELS: usize = SensorHeader::SIZE + 12;
const _: () = assert!(BEFORE_PIXELS.is_multiple_of(4), "it can be written as pixels");

/// A message that begins with the header, width, height and field of view in degrees, and has room for so many bytes more.
pub fn image_header(header: &SensorHeader, [width, height]: [u32; 2], fov_deg: f32, payload: usize) -> Vec<u8> {
    let mut message = header.begin(BEFORE_PIXELS - SensorHeader::SIZE + payload);
    message.extend(width.to_le_bytes());
    message.extend(height.to_le_bytes());
    push_floats(&mut message, &[fov_deg]);
    message
}

/// A message of width, height, field of view in degrees, and pixels of blue, green, red and opacity by rows, as many as there are.
pub fn image_message(
    header: &SensorHeader,
    size: [u32; 2],
    fov_deg: f32,
    bgra: impl ExactSizeIterator<Item = [u8; 4]>,
) -> Vec<u8> {
    // Pixel by pixel, and what comes before them as if it were pixels: byte by byte takes several times as long, and memory that is
    // made first is written twice.
    let mut pixels = Vec::with_capacity(BEFORE_PIXELS / 4 + bgra.len());
    pixels.extend_from_slice(image_header(header, size, fov_deg, 0).as_chunks().0);
    pixels.extend(bgra);
    pixels.into_flattened()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::Transform;

    #[test]
    fn pixels_follow_the_header() {
        let header = SensorHeader { type_id: 1, frame: 7, timestamp: 0.35, transform: Transform::default() };
        let message = image_message(&header, [2, 1], 90.0, [[1, 2, 3, 4], [5, 6, 7, 8]].into_iter());
        let before = [header.begin(0), [2u32.to_le_bytes(), 1u32.to_le_bytes(), 90f32.to_le_bytes()].concat()].concat();
        assert_eq!(before.len(), BEFORE_PIXELS);
        assert_eq!(message, [before, (1..=8).collect()].concat());
        assert_eq!(message.len(), message.capacity());
    }
}
