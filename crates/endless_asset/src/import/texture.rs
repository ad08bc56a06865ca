//! Embedded texture images, decoded and sampled.

use super::ImportError;
use super::container::GlbFile;
use glam::{Vec2, Vec4};
use std::io::Cursor;
use zune_core::{bytestream::ZCursor, colorspace::ColorSpace, options::DecoderOptions};
use zune_jpeg::JpegDecoder;

/// Longest side, pixels.
const MOST_PX: usize = 8192;

/// An sRGB image with alpha.
#[derive(Debug)]
pub(super) struct TextureImage {
    width: usize,
    height: usize,
    rgba: Vec<[u8; 4]>,
}

impl TextureImage {
    /// Linear colour and alpha at texture coordinates, repeated beyond 0 to 1. The nearest pixel: callers sample many points.
    pub(super) fn at(&self, uv: Vec2) -> Vec4 {
        let place = |x: f32, n: usize| {
            let x = if x.is_finite() { x - x.floor() } else { 0.0 };
            ((x * n as f32) as usize).min(n - 1)
        };
        let [r, g, b, a] = self.rgba[place(uv.y, self.height) * self.width + place(uv.x, self.width)];
        Vec4::new(linear(r), linear(g), linear(b), f32::from(a) / 255.0)
    }
}

/// Linear light of an sRGB value (IEC 61966-2-1).
fn linear(value: u8) -> f32 {
    let v = f32::from(value) / 255.0;
    if v <= 0.04045 { v / 12.92 } else { endless_world::math::pow((v + 0.055) / 1.055, 2.4) }
}

/// Decodes an image of the file, or one beside it.
///
/// # Errors
/// When it cannot be had, is neither PNG nor JPEG, or is broken.
pub(super) fn decode(opened: &GlbFile<'_>, image: &gltf::Image<'_>) -> Result<TextureImage, ImportError> {
    let number = image.index();
    let wrong = |why: String| ImportError::Image { number, why, most_px: MOST_PX };
    let decoded = match image.source() {
        gltf::image::Source::View { view, .. } => {
            let end = view.offset().checked_add(view.length());
            let bytes = end.and_then(|end| opened.buffer.get(view.offset()..end));
            either(bytes.ok_or_else(|| wrong("it reaches beyond the buffer".to_owned()))?)
        }
        gltf::image::Source::Uri { uri, .. } => {
            let outside = || ImportError::Outside { what: "an image", uri: uri.chars().take(60).collect() };
            either(&(opened.read_external)(&uri.replace("%20", " ")).ok_or_else(outside)?)
        }
    };
    decoded.map_err(wrong)
}

fn either(bytes: &[u8]) -> Result<TextureImage, String> {
    if bytes.starts_with(b"\x89PNG") { png(bytes) } else { jpeg(bytes) }
}

fn png(bytes: &[u8]) -> Result<TextureImage, String> {
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(png::Transformations::normalize_to_color8() | png::Transformations::ALPHA);
    let mut reader = decoder.read_info().map_err(|e| e.to_string())?;
    let (width, height) = (reader.info().width as usize, reader.info().height as usize);
    check(width, height)?;
    let size = reader.output_buffer_size().filter(|&n| n <= 8 * width * height).ok_or("its size makes no sense")?;
    let mut data = vec![0; size];
    let frame = reader.next_frame(&mut data).map_err(|e| e.to_string())?;
    let rgba = match frame.color_type {
        png::ColorType::Rgba => data.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect(),
        png::ColorType::GrayscaleAlpha => data.chunks_exact(2).map(|p| [p[0], p[0], p[0], p[1]]).collect(),
        png::ColorType::Rgb => data.chunks_exact(3).map(|p| [p[0], p[1], p[2], 255]).collect(),
        _ => data.iter().map(|&v| [v, v, v, 255]).collect(),
    };
    image(width, height, rgba)
}

fn jpeg(bytes: &[u8]) -> Result<TextureImage, String> {
    let options = DecoderOptions::default().jpeg_set_out_colorspace(ColorSpace::RGB);
    let options = options.set_max_width(MOST_PX).set_max_height(MOST_PX);
    let mut decoder = JpegDecoder::new_with_options(ZCursor::new(bytes), options);
    decoder.decode_headers().map_err(|e| e.to_string())?;
    let (width, height) = decoder.dimensions().ok_or("it has no size")?;
    check(width, height)?;
    let data = decoder.decode().map_err(|e| e.to_string())?;
    image(width, height, data.chunks_exact(3).map(|p| [p[0], p[1], p[2], 255]).collect())
}

fn check(width: usize, height: usize) -> Result<(), String> {
    let sides = 1..=MOST_PX;
    if sides.contains(&width) && sides.contains(&height) { Ok(()) } else { Err(format!("it is {width} by {height}")) }
}

fn image(width: usize, height: usize, rgba: Vec<[u8; 4]>) -> Result<TextureImage, String> {
    if rgba.len() == width * height {
        Ok(TextureImage { width, height, rgba })
    } else {
        Err("pixels are missing".to_owned())
    }
}
