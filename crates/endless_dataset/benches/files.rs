//! Encoding of one 720p frame.

use endless_dataset::{VideoEncoder, encode_jpg, encode_png, rgb_from_depth, rgb_from_instance, yuv_from_rgb};
use endless_world::{ClassTag, Image, ImageSize, InstanceId, InstancePixel, Stream, math};

const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };

fn main() {
    divan::main();
}

/// Smooth shading with fine texture, as asphalt and walls have.
fn rgb() -> Image<[u8; 3]> {
    let mut stream = Stream::named(0, "files bench", &[]);
    let pixel = |i: usize| {
        let (x, y) = ((i % 1280) as f32, (i / 1280) as f32);
        let base = 110.0 + 60.0 * math::sin(x * 0.011) * math::cos(y * 0.017) + stream.range_f32(-4.0, 4.0);
        [base as u8, (base * 0.96) as u8, (base * 0.9) as u8]
    };
    Image { size: SIZE, data: (0..SIZE.pixels()).map(pixel).collect() }
}

/// A plane seen at a slant under a sky.
fn depth() -> Image<f32> {
    let metres = |i: usize| {
        let y = (i / 1280) as f32;
        if y < 200.0 { 1000.0 } else { 3000.0 / (y - 190.0) + (i % 1280) as f32 * 1e-4 }
    };
    Image { size: SIZE, data: (0..SIZE.pixels()).map(metres).collect() }
}

fn instance() -> Image<InstancePixel> {
    let pixel = |i: usize| {
        let (x, y) = (i % 1280, i / 1280);
        let car = x % 160 > 90 && y % 120 > 70;
        let id = if car { 1 + x / 160 + 8 * (y / 120) } else { 0 };
        InstancePixel { tag: if car { ClassTag::Car } else { ClassTag::Roads }, id: InstanceId(id as u16) }
    };
    Image { size: SIZE, data: (0..SIZE.pixels()).map(pixel).collect() }
}

#[divan::bench]
fn png_rgb(bencher: divan::Bencher<'_, '_>) {
    let image = rgb();
    bencher.bench(|| encode_png(&image));
}

#[divan::bench]
fn jpg_rgb(bencher: divan::Bencher<'_, '_>) {
    let image = rgb();
    bencher.bench(|| encode_jpg(&image));
}

#[divan::bench]
fn png_depth(bencher: divan::Bencher<'_, '_>) {
    let image = depth();
    bencher.bench(|| encode_png(&rgb_from_depth(&image)));
}

#[divan::bench]
fn png_instance(bencher: divan::Bencher<'_, '_>) {
    let image = instance();
    bencher.bench(|| encode_png(&rgb_from_instance(&image)));
}

#[divan::bench]
fn yuv(bencher: divan::Bencher<'_, '_>) {
    let image = rgb();
    bencher.bench(|| yuv_from_rgb(&image));
}

#[divan::bench]
fn h264_frame(bencher: divan::Bencher<'_, '_>) {
    let folder = tempfile::tempdir().expect("temp");
    let mut video = VideoEncoder::create(&folder.path().join("a.mp4"), SIZE, 30.0).expect("encodable");
    let pictures: Vec<_> = (0..16)
        .map(|f| {
            let mut image = rgb();
            for y in 300..400 {
                image.data[y * 1280 + 100 + f * 4..][..200].fill([200, 30, 20]);
            }
            yuv_from_rgb(&image)
        })
        .collect();
    let mut next = 0;
    bencher.bench_local(|| {
        next += 1;
        video.push(&pictures[next % 16]).expect("writable");
    });
}
