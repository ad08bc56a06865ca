//! What lens, sensor and recorder do to a picture: bad focus, dirt, vignetting and lateral chromatic aberration, noise, an unsharp mask,
//! the clock, and compression. Distortion is not here: rays are bent by it, so all layers have it alike.

use super::defocus::blurred;
use super::droplets::Droplets;
use super::sensor_noise::SensorNoise;
use super::smudges::Smudges;
use super::timestamp::stamp;
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
    smudges: Option<Smudges>,
}

impl PostProcess {
    /// `None` where nothing is done to pictures.
    pub(crate) fn new(look: &CameraLook, size: ImageSize, fps: f64, seed: u64, rain: f32) -> Option<Self> {
        let grain = (look.noise > 0.0).then(|| SensorNoise::new(look.noise, seed));
        let count = (look.droplets as f32 * rain) as u32;
        let droplets = (count > 0).then(|| Droplets::new(count, size, seed));
        let smudges = (look.smudges > 0).then(|| Smudges::new(look.smudges, size, seed));
        (!look.is_clean()).then_some(Self { look: *look, size, fps, grain, droplets, smudges })
    }

    /// Whether the lens does anything to light.
    pub(crate) fn has_lens(&self) -> bool {
        let CameraLook { vignetting, aberration, defocus, .. } = self.look;
        vignetting > 0.0 || aberration > 0.0 || defocus > 0.0 || self.droplets.is_some() || self.smudges.is_some()
    }

    /// What the lens makes of a picture in linear light; `through` is overwritten.
    pub(crate) fn lens(&self, seen: &[Vec3A], through: &mut Vec<Vec3A>) {
        let CameraLook { vignetting, aberration, .. } = self.look;
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let mut spoiled =
            (self.look.defocus > 0.0).then(|| blurred(self.size, seen, self.look.defocus * self.size.height as f32));
        if let Some(smudges) = &self.smudges {
            smudges.draw(self.size, spoiled.get_or_insert_with(|| seen.to_vec()));
        }
        if let Some(droplets) = &self.droplets {
            droplets.draw(self.size, spoiled.get_or_insert_with(|| seen.to_vec()));
        }
        let from = spoiled.as_deref().unwrap_or(seen);
        let middle = Vec2::new(width as f32, height as f32) * 0.5;
        let corner = middle.length_squared();
        // Where red and blue come from along an axis: rows and columns do not depend on each other.
        let red_and_blue = |i: usize, middle: f32, n: usize| {
            let away = i as f32 + 0.5 - middle;
            [1.0 - aberration, 1.0 + aberration].map(|scale| AxisPlace::new(middle + away * scale, n))
        };
        let columns: Vec<_> = (0..width).map(|x| (x, red_and_blue(x, middle.x, width))).collect();
        through.clear();
        through.reserve(from.len());
        for (y, row) in from.chunks_exact(width).enumerate() {
            let rows = red_and_blue(y, middle.y, height);
            through.extend(row.iter().zip(&columns).map(|(&pixel, (x, column))| {
                let mut pixel = pixel;
                if aberration > 0.0 {
                    pixel.x = bilinear(from, width, [column[0], rows[0]], |p| p.x);
                    pixel.z = bilinear(from, width, [column[1], rows[1]], |p| p.z);
                }
                let away = Vec2::new(*x as f32 + 0.5, y as f32 + 0.5) - middle;
                let r2 = away.length_squared() / corner;
                pixel * (1.0 - vignetting * r2 * (0.6 + 0.4 * r2))
            }));
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

    /// An unsharp mask over the four neighbours; the border is repeated.
    fn sharpen(&self, rgb: &mut [[u8; 3]]) {
        let from = rgb.to_vec();
        let (width, height) = (self.size.width as usize, self.size.height as usize);
        let row_of = |y: usize| &from[y * width..][..width];
        for (y, out) in rgb.chunks_exact_mut(width).enumerate() {
            let (here, above, below) = (row_of(y), row_of(y.saturating_sub(1)), row_of((y + 1).min(height - 1)));
            let around = |x: usize| [above[x], below[x], here[x.saturating_sub(1)], here[(x + 1).min(width - 1)]];
            let last = width - 1;
            for x in [0, last] {
                for c in 0..3 {
                    out[x][c] = sharpened(self.look.sharpening, here[x][c], around(x).map(|pixel| pixel[c]));
                }
            }
            if width < 3 {
                continue;
            }
            let (left, right) = (here[..last - 1].as_flattened(), here[2..].as_flattened());
            let [here, above, below] = [here, above, below].map(|row| row[1..last].as_flattened());
            for (i, out) in out[1..last].as_flattened_mut().iter_mut().enumerate() {
                *out = sharpened(self.look.sharpening, here[i], [above[i], below[i], left[i], right[i]]);
            }
        }
    }
}

/// A value and the mean of its neighbours are led apart.
fn sharpened(strength: f32, here: u8, [above, below, left, right]: [u8; 4]) -> u8 {
    let here = f32::from(here);
    let around = (f32::from(above) + f32::from(below) + f32::from(left) + f32::from(right)) * 0.25;
    (here + strength * (here - around)).round().clamp(0.0, 255.0) as u8
}

/// A place between the centres of pixels along one axis; the border is repeated.
#[derive(Clone, Copy)]
struct AxisPlace {
    before: usize,
    after: usize,
    share: f32,
}

impl AxisPlace {
    /// In pixels, of so many.
    fn new(at: f32, pixels: usize) -> Self {
        let at = (at - 0.5).clamp(0.0, (pixels - 1) as f32);
        let before = at as usize;
        Self { before, after: (before + 1).min(pixels - 1), share: at - before as f32 }
    }
}

/// A channel of a picture between its pixels' centres.
fn bilinear(from: &[Vec3A], width: usize, [x, y]: [AxisPlace; 2], channel: impl Fn(&Vec3A) -> f32) -> f32 {
    let lerp = |a: f32, b: f32, share: f32| a + (b - a) * share;
    let row = |y: usize| {
        let row = &from[y * width..][..width];
        lerp(channel(&row[x.before]), channel(&row[x.after]), x.share)
    };
    lerp(row(y.before), row(y.after), y.share)
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
        let mut pixels = Vec::new();
        let look = CameraLook { vignetting: 0.4, aberration: 0.001, ..CameraLook::CLEAN };
        finish(look).lens(&vec![Vec3A::ONE; SIZE.pixels()], &mut pixels);
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
