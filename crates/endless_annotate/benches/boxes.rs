//! Boxes of a busy 720p instance image.

use endless_annotate::visible_objects;
use endless_world::{ClassTag, Image, ImageSize, InstanceId, InstancePixel, Stream};

fn main() {
    divan::main();
}

#[divan::bench]
fn boxes_720p_80_objects(bencher: divan::Bencher<'_, '_>) {
    let size = ImageSize { width: 1280, height: 720 };
    let mut image = Image::filled(size, InstancePixel { tag: ClassTag::Roads, id: InstanceId::STUFF });
    let mut stream = Stream::named(0, "boxes bench", &[]);
    for id in 1..=80 {
        let (x0, y0) = (stream.below(1200), stream.below(660));
        for y in y0..y0 + 60 {
            for x in x0..x0 + 80 {
                image.data[y * 1280 + x] = InstancePixel { tag: ClassTag::Car, id: InstanceId(id) };
            }
        }
    }
    bencher.bench(|| visible_objects(divan::black_box(&image)));
}
