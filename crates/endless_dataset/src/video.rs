//! H.264 video of the frames.

use crate::{DatasetError, Mp4Writer};
use endless_world::{Image, ImageSize};
use rusty_h264_common::YuvPlanes;
use rusty_h264_encoder::{Encoder, EncoderConfig};
use std::path::Path;

/// Constant quality: about 44 dB on the fixed cameras' frames.
const QP: u8 = 24;

/// Seconds between key frames, so that a player can jump.
const KEY_INTERVAL_S: f64 = 2.0;

/// A picture as the encoder takes it: planar 4:2:0, BT.709, studio range. Odd sizes are padded by one row or column,
/// repeating the last.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Yuv {
    width: usize,
    height: usize,
    y: Vec<u8>,
    u: Vec<u8>,
    v: Vec<u8>,
}

/// The size of the video of images of this size: even.
pub(crate) fn even(size: ImageSize) -> ImageSize {
    ImageSize { width: size.width.next_multiple_of(2), height: size.height.next_multiple_of(2) }
}

/// Converts a picture. Each chroma sample is the mean of its four pixels.
pub fn yuv_from_rgb(rgb: &Image<[u8; 3]>) -> Yuv {
    let size = even(rgb.size);
    let (width, height) = (size.width as usize, size.height as usize);
    let (source_width, source_height) = (rgb.size.width as usize, rgb.size.height as usize);
    let mut yuv = Yuv {
        width,
        height,
        y: vec![0; width * height],
        u: vec![0; width * height / 4],
        v: vec![0; width * height / 4],
    };
    let source_row = |y: usize| {
        let y = y.min(source_height - 1);
        &rgb.data[y * source_width..(y + 1) * source_width]
    };
    let (mut upper, mut lower) = (vec![[0u8; 3]; width], vec![[0u8; 3]; width]);
    for half_row in 0..height / 2 {
        for (padded, y) in [(&mut upper, 2 * half_row), (&mut lower, 2 * half_row + 1)] {
            padded[..source_width].copy_from_slice(source_row(y));
            padded[source_width..].fill(source_row(y)[source_width - 1]);
            for (luma, pixel) in yuv.y[y * width..(y + 1) * width].iter_mut().zip(padded.iter()) {
                *luma = luma_of(*pixel);
            }
        }
        let out = half_row * width / 2..(half_row + 1) * width / 2;
        let chroma = yuv.u[out.clone()].iter_mut().zip(yuv.v[out].iter_mut());
        for ((u, v), (a, b)) in chroma.zip(upper.as_chunks::<2>().0.iter().zip(lower.as_chunks::<2>().0)) {
            let sum = |c: usize| i32::from(a[0][c]) + i32::from(a[1][c]) + i32::from(b[0][c]) + i32::from(b[1][c]);
            (*u, *v) = chroma_of([sum(0), sum(1), sum(2)]);
        }
    }
    yuv
}

/// BT.709 in 16-bit fixed point.
#[inline]
fn luma_of([r, g, b]: [u8; 3]) -> u8 {
    let weighted = 11_966 * i32::from(r) + 40_254 * i32::from(g) + 4_064 * i32::from(b);
    ((weighted + (16 << 16) + (1 << 15)) >> 16) as u8
}

/// From the sums of four pixels.
#[inline]
fn chroma_of([r, g, b]: [i32; 3]) -> (u8, u8) {
    let offset = (128 << 18) + (1 << 17);
    let u = (-6_596 * r - 22_188 * g + 28_784 * b + offset) >> 18;
    let v = (28_784 * r - 26_145 * g - 2_639 * b + offset) >> 18;
    (u as u8, v as u8)
}

/// Encodes pictures, in order, into an MP4 file.
pub struct VideoEncoder {
    encoder: Encoder,
    muxer: Mp4Writer,
}

impl std::fmt::Debug for VideoEncoder {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("VideoEncoder").field("muxer", &self.muxer).finish_non_exhaustive()
    }
}

impl VideoEncoder {
    /// A video of images of this size at this rate.
    ///
    /// # Errors
    /// When the encoder does not take the size or the file cannot be created.
    pub fn create(path: &Path, size: ImageSize, fps: f64) -> Result<Self, DatasetError> {
        let size = even(size);
        // Constrained baseline, one reference, no B-frames: every browser plays it, in order, and it costs least.
        let mut config = EncoderConfig::baseline(size.width as usize, size.height as usize);
        config.qp = QP;
        config.bitrate = 0;
        config.gop_size = (fps * KEY_INTERVAL_S).round().max(1.0) as u32;
        config.scenecut = 0;
        config.framerate = fps as f32;
        config.level_idc = level(size, fps);
        let encoder = Encoder::new(config).map_err(|e| DatasetError::Video { reason: format!("{e:?}") })?;
        Ok(Self { encoder, muxer: Mp4Writer::create(path, size, fps)? })
    }

    /// Appends a picture.
    ///
    /// # Errors
    /// When the encoder refuses the picture or the disk the bytes.
    pub fn push(&mut self, picture: &Yuv) -> Result<(), DatasetError> {
        let planes = YuvPlanes {
            width: picture.width,
            height: picture.height,
            y: &picture.y,
            u: &picture.u,
            v: &picture.v,
            stride_y: picture.width,
            stride_c: picture.width / 2,
        };
        let access_unit =
            self.encoder.encode_planes(&planes).map_err(|e| DatasetError::Video { reason: format!("{e:?}") })?;
        self.muxer.push(&access_unit)
    }

    /// Completes the file and gives it its name.
    ///
    /// # Errors
    /// When the disk refuses.
    pub fn finish(self) -> Result<(), DatasetError> {
        self.muxer.finish()
    }
}

/// The lowest level (times ten) whose limits on macroblocks hold this video: table A-1 of the standard.
fn level(size: ImageSize, fps: f64) -> u8 {
    const LEVELS: &[(u8, u32, f64)] = &[
        (30, 1_620, 40_500.0),
        (31, 3_600, 108_000.0),
        (32, 5_120, 216_000.0),
        (40, 8_192, 245_760.0),
        (42, 8_704, 522_240.0),
        (50, 22_080, 589_824.0),
        (51, 36_864, 983_040.0),
        (52, 36_864, 2_073_600.0),
        (60, 139_264, 4_177_920.0),
        (61, 139_264, 8_355_840.0),
    ];
    let blocks = size.width.div_ceil(16) * size.height.div_ceil(16);
    let longest = f64::from(size.width.div_ceil(16).max(size.height.div_ceil(16)));
    let holds = |&&(_, most, rate): &&(u8, u32, f64)| {
        blocks <= most && f64::from(blocks) * fps <= rate && longest * longest <= 8.0 * f64::from(most)
    };
    LEVELS.iter().find(holds).map_or(62, |l| l.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::read_mp4;
    use endless_world::Stream;
    use rusty_h264_decoder::Decoder;

    #[test]
    fn the_environment_is_out_of_the_encoder_s_reach() {
        // Another dependency could turn on the codec's `std`, and with it dozens of variables that change the bytes.
        assert!(std::env::var("PATH").is_ok());
        assert_eq!(rusty_h264_common::knob("PATH"), None);
    }

    #[test]
    fn colours_are_bt709() {
        let convert = |rgb| {
            let yuv = yuv_from_rgb(&Image::filled(ImageSize { width: 2, height: 2 }, rgb));
            (yuv.y[0], yuv.u[0], yuv.v[0])
        };
        assert_eq!(convert([0, 0, 0]), (16, 128, 128));
        assert_eq!(convert([255, 255, 255]), (235, 128, 128));
        assert_eq!(convert([255, 0, 0]), (63, 102, 240));
        assert_eq!(convert([0, 255, 0]), (173, 42, 26));
        assert_eq!(convert([0, 0, 255]), (32, 240, 118));
    }

    #[test]
    fn levels_follow_the_table() {
        assert_eq!(level(ImageSize { width: 1280, height: 720 }, 30.0), 31);
        assert_eq!(level(ImageSize { width: 1920, height: 1080 }, 30.0), 40);
        assert_eq!(level(ImageSize { width: 3840, height: 2160 }, 60.0), 52);
    }

    /// A striped picture with a square that moves.
    fn picture(size: ImageSize, frame: u32) -> Image<[u8; 3]> {
        let mut stream = Stream::named(3, "video test", &[]);
        let stripes: Vec<u8> = (0..size.width).map(|_| 60 + stream.below(120) as u8).collect();
        let pixel = |i: u32| {
            let (x, y) = (i % size.width, i / size.width);
            let inside = (frame * 3..frame * 3 + 20).contains(&x) && (5..25).contains(&y);
            if inside { [220, 40, 30] } else { [stripes[(x / 8 * 8) as usize], (y * 2).min(255) as u8, 90] }
        };
        Image { size, data: (0..size.pixels() as u32).map(pixel).collect() }
    }

    #[test]
    fn every_frame_decodes_to_what_went_in() {
        let folder = tempfile::tempdir().expect("temp");
        for (w, h, fps) in [(96, 64, 30.0), (61, 35, 29.97), (2, 2, 0.5), (1, 1, 10.0), (33, 16, 1000.0)] {
            let size = ImageSize { width: w, height: h };
            let path = folder.path().join(format!("{w}x{h}.mp4"));
            let mut video = VideoEncoder::create(&path, size, fps).expect("encodable");
            let pictures: Vec<Yuv> = (0..9).map(|f| yuv_from_rgb(&picture(size, f))).collect();
            for p in &pictures {
                video.push(p).expect("writable");
            }
            video.finish().expect("writable");
            let mp4 = read_mp4(&path).expect("own output");
            assert_eq!((mp4.size, mp4.samples()), (even(size), 9));
            assert!((mp4.fps() - fps).abs() < 1e-3, "{} instead of {fps}", mp4.fps());
            let mut decoder = Decoder::new();
            for (i, expected) in pictures.iter().enumerate() {
                let unit = mp4.access_unit(i).expect("in the file");
                let decoded = decoder.decode(&unit).expect("decodable").expect("one picture a unit");
                assert_eq!((decoded.width, decoded.height), (expected.width, expected.height));
                let squares: f64 =
                    decoded.y.iter().zip(&expected.y).map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2)).sum();
                let mean = squares / decoded.y.len() as f64;
                assert!(mean < 20.0, "{w}x{h} frame {i}: mean square error {mean}");
            }
        }
    }
}
