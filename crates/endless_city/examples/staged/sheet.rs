//! Frames side by side on one picture.

use endless_world::ImageSize;
use std::error::Error;

/// Frames are drawn larger by this much and shrunk: small pictures without jagged edges.
const FINER: u32 = 2;
/// Between frames, pixels.
const GAP: usize = 2;

/// The size in which to draw a frame that shows as `size`.
pub(crate) fn large(size: ImageSize) -> ImageSize {
    ImageSize { width: size.width * FINER, height: size.height * FINER }
}

/// Rows of frames drawn [`large`], shrunk to `size` each, as a JPEG file of a quality from 1 to 100.
pub(crate) fn save(out: &str, rows: &[Vec<Vec<[u8; 3]>>], size: ImageSize, quality: u8) -> Result<(), Box<dyn Error>> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(1);
    let (wide, tall) = (size.width as usize, size.height as usize);
    let (width, height) = (columns * (wide + GAP) - GAP, rows.len() * (tall + GAP) - GAP);
    let mut sheet = vec![[20u8, 20, 22]; width * height];
    for (y, row) in rows.iter().enumerate() {
        for (x, frame) in row.iter().enumerate() {
            for (line, pixels) in shrunk(frame, large(size)).chunks(wide).enumerate() {
                let start = (y * (tall + GAP) + line) * width + x * (wide + GAP);
                sheet[start..start + wide].copy_from_slice(pixels);
            }
        }
    }
    let encoder = jpeg_encoder::Encoder::new_file(out, quality)?;
    encoder.encode(sheet.as_flattened(), width as u16, height as u16, jpeg_encoder::ColorType::Rgb)?;
    Ok(())
}

/// Means of squares of pixels.
fn shrunk(pixels: &[[u8; 3]], size: ImageSize) -> Vec<[u8; 3]> {
    let (width, finer) = (size.width as usize, FINER as usize);
    let mean = |x: usize, y: usize, channel: usize| {
        let square = (0..finer * finer).map(|k| pixels[(y * finer + k / finer) * width + x * finer + k % finer]);
        (square.map(|p| usize::from(p[channel])).sum::<usize>() / (finer * finer)) as u8
    };
    (0..size.height as usize / finer)
        .flat_map(|y| (0..width / finer).map(move |x| (x, y)))
        .map(|(x, y)| [0, 1, 2].map(|channel| mean(x, y, channel)))
        .collect()
}
