//! What lens, sensor and recorder do to a picture: vignetting and lateral chromatic aberration, noise, an unsharp mask,
//! the clock, and compression. Distortion is not here: rays are bent by it, so all layers have it alike.

use super::droplets::Droplets;
use super::sensor_noise::SensorNoise;
use super::timestamp::stamp;
use endless_world::math::UnfusedVec3A;
use endless_world::{CameraLook, ImageSize};
use glam::{Vec2, Vec3A};

/// The look of one camera, ready to be laid over its pictures.
#[derive(Debug, Clone)]
pub(crate) struct PostProcess {
    look: CameraLook,
    size: ImageSize,
    fps: f64,
    grain: Option<SensorNoise>,
    /// In rain.
    droplets: Option<Droplets>,
}

impl PostProcess {
    /// `None` where nothing is done to pictures.
    pub(crate) fn new(look: &CameraLook, size: ImageSize, fps: f64, seed: u64, rain: f32) -> Option<Self> {
        let grain = (look.noise > 0.0).then(|| SensorNoise::new(look.noise, seed));
        let count = (look.droplets as f32 * rain) as u32;
        let droplets = (count > 0).then(|| Droplets::new(count, size, seed));
        (!look.is_clean()).then_some(Self { look: *look, size, fps, grain, droplets })
    }

    /// Whether the lens does anything to light.
    pub(crate) fn has_lens(&self) -> bool {
        self.look.vignetting > 0.0 || self.look.aberration > 0.0 || self.droplets.is_some()
    }

    /// What the lens does to a picture in linear light.
    pub(crate) fn lens(&self, pixels: &mut [Vec3A]) {
        let CameraLook { vignetting, aberration, .. } = self.look;
        if let Some(droplets) = &self.droplets {
            droplets.draw(self.size, pixels);
        }
        let from = (aberration > 0.0).then(|| pixels.to_vec());
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let middle = Vec2::new(width as f32, height as f32) * 0.5;
        let corner = middle.length_squared();
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let away = Vec2::new((i % width) as f32 + 0.5, (i / width) as f32 + 0.5) - middle;
            if let Some(from) = &from {
                let at = |scale: f32| bilinear(from, width, height, middle + away * scale);
                pixel.x = at(1.0 - aberration).x;
                pixel.z = at(1.0 + aberration).z;
            }
            let r2 = away.length_squared() / corner;
            *pixel *= 1.0 - vignetting * r2 * (0.6 + 0.4 * r2);
        }
    }

    /// What sensor and recorder do to the developed picture of a frame.
    pub(crate) fn record(&self, frame: u32, rgb: &mut Vec<[u8; 3]>) {
        if let Some(grain) = &self.grain {
            grain.add(frame, self.size.width as usize, rgb);
        }
        if self.look.sharpening > 0.0 {
            self.sharpen(rgb);
        }
        if let Some(clock) = self.look.clock {
            stamp(clock, (f64::from(frame) / self.fps) as u32, self.size, rgb);
        }
        if let Some(quality) = self.look.jpeg_quality {
            *rgb = compressed(rgb, self.size, quality);
        }
    }

    /// An unsharp mask over the four neighbours.
    fn sharpen(&self, rgb: &mut [[u8; 3]]) {
        let from = rgb.to_vec();
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let strength = self.look.sharpening;
        for y in 0..height {
            let (above, below) = (y.saturating_sub(1) * width, (y + 1).min(height - 1) * width);
            for x in 0..width {
                let (left, right) = (x.saturating_sub(1), (x + 1).min(width - 1));
                for c in 0..3 {
                    let at = |row: usize, column: usize| f32::from(from[row + column][c]);
                    let here = at(y * width, x);
                    let around = (at(above, x) + at(below, x) + at(y * width, left) + at(y * width, right)) * 0.25;
                    rgb[y * width + x][c] = (here + strength * (here - around)).round().clamp(0.0, 255.0) as u8;
                }
            }
        }
    }
}

/// A picture between its pixels' centres; the border is repeated.
fn bilinear(from: &[Vec3A], width: usize, height: usize, at: Vec2) -> Vec3A {
    let most = Vec2::new((width - 1) as f32, (height - 1) as f32);
    let p = (at - 0.5).clamp(Vec2::ZERO, most);
    let (x, y) = (p.x as usize, p.y as usize);
    let (x1, y1) = ((x + 1).min(width - 1), (y + 1).min(height - 1));
    let (u, v) = (p.x - x as f32, p.y - y as f32);
    let row = |y: usize| from[y * width + x].lerp_unfused(from[y * width + x1], u);
    row(y).lerp_unfused(row(y1), v)
}

/// The picture as a recorder's JPEG-like compression leaves it.
fn compressed(rgb: &[[u8; 3]], size: ImageSize, quality: u8) -> Vec<[u8; 3]> {
    let mut bytes = Vec::new();
    let encoder = jpeg_encoder::Encoder::new(&mut bytes, quality);
    let (width, height) = (size.width as u16, size.height as u16);
    let encoded = encoder.encode(rgb.as_flattened(), width, height, jpeg_encoder::ColorType::Rgb);
    let options =
        zune_core::options::DecoderOptions::default().jpeg_set_out_colorspace(zune_core::colorspace::ColorSpace::RGB);
    let cursor = zune_core::bytestream::ZCursor::new(&bytes[..]);
    let decoded = zune_jpeg::JpegDecoder::new_with_options(cursor, options).decode();
    // Neither fails on a picture in memory whose sides are within JPEG's 65,535.
    encoded.expect("a picture can be compressed");
    decoded.expect("what was compressed can be read").as_chunks::<3>().0.to_vec()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: ImageSize = ImageSize { width: 320, height: 200 };

    fn finish(look: CameraLook) -> PostProcess {
        PostProcess::new(&look, SIZE, 30.0, 7, 1.0).expect("not clean")
    }

    #[test]
    fn nothing_is_done_by_a_clean_camera() {
        assert!(PostProcess::new(&CameraLook::CLEAN, SIZE, 30.0, 1, 1.0).is_none());
    }

    #[test]
    fn noise_has_the_asked_deviation_and_no_bias() {
        let camera = finish(CameraLook { noise: 4.0, ..CameraLook::CLEAN });
        let mut rgb = vec![[128u8; 3]; SIZE.pixels()];
        camera.record(3, &mut rgb);
        let values: Vec<f32> = rgb.as_flattened().iter().map(|&v| f32::from(v) - 128.0).collect();
        let mean = values.iter().sum::<f32>() / values.len() as f32;
        let deviation = (values.iter().map(|v| v * v).sum::<f32>() / values.len() as f32).sqrt();
        assert!(mean.abs() < 0.05, "{mean}");
        assert!((3.6..4.4).contains(&deviation), "{deviation}");
        // Another frame, another noise; the same frame, the same.
        let mut again = vec![[128u8; 3]; SIZE.pixels()];
        camera.record(3, &mut again);
        assert_eq!(again, rgb);
        let mut other = vec![[128u8; 3]; SIZE.pixels()];
        camera.record(4, &mut other);
        assert_ne!(other, rgb);
    }

    #[test]
    fn corners_lose_what_is_asked() {
        let mut pixels = vec![Vec3A::ONE; SIZE.pixels()];
        finish(CameraLook { vignetting: 0.4, aberration: 0.001, ..CameraLook::CLEAN }).lens(&mut pixels);
        assert!((pixels[0].x - 0.6).abs() < 0.01, "{}", pixels[0]);
        assert!((pixels[SIZE.pixels() / 2 + SIZE.width as usize / 2].y - 1.0).abs() < 1e-3);
    }

    #[test]
    fn flat_pictures_stay_flat_when_sharpened_and_compressed() {
        let mut rgb = vec![[90u8, 120, 60]; SIZE.pixels()];
        finish(CameraLook { sharpening: 1.0, jpeg_quality: Some(50), ..CameraLook::CLEAN }).record(0, &mut rgb);
        assert!(rgb.iter().all(|p| p.iter().zip([90i16, 120, 60]).all(|(&a, b)| (i16::from(a) - b).abs() <= 4)));
    }
}
