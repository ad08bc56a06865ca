//! Layers as pictures for people, for their videos.

use endless_world::{ClassTag, FAR_PLANE_M, Image, InstancePixel, Stream, math};

/// Near is bright, far is dark, logarithmic from 1 m to the far plane.
pub fn depth_preview(depth: &Image<f32>) -> Image<[u8; 3]> {
    let scale = 255.0 / math::log2(FAR_PLANE_M);
    let grey = |&metres: &f32| {
        let value = 255.0 - math::log2(metres.clamp(1.0, FAR_PLANE_M)) * scale;
        [value.round() as u8; 3]
    };
    Image { size: depth.size, data: depth.data.iter().map(grey).collect() }
}

/// Stuff in its palette colour at half brightness, every object in a bright colour of its own.
pub fn instance_preview(instance: &Image<InstancePixel>) -> Image<[u8; 3]> {
    let color = |p: &InstancePixel| if p.id.0 == 0 { stuff_color(p.tag) } else { object_color(p.id.0) };
    let mut last = None;
    let data = instance
        .data
        .iter()
        .map(|pixel| match last {
            // Runs are long: most pixels are what the one before was.
            Some((same, color)) if same == *pixel => color,
            _ => last.insert((*pixel, color(pixel))).1,
        })
        .collect();
    Image { size: instance.size, data }
}

/// Every class in its colour of CARLA's palette.
pub(crate) fn semantic_preview(tags: &Image<ClassTag>) -> Image<[u8; 3]> {
    Image { size: tags.size, data: tags.data.iter().map(|tag| tag.color()).collect() }
}

/// Each axis as a colour, -1 dark, 1 bright.
pub(crate) fn normals_preview(normals: &Image<[u16; 3]>) -> Image<[u8; 3]> {
    let color = |pixel: &[u16; 3]| pixel.map(|value| (value >> 8) as u8);
    Image { size: normals.size, data: normals.data.iter().map(color).collect() }
}

fn stuff_color(tag: ClassTag) -> [u8; 3] {
    tag.color().map(|c| c / 2)
}

fn object_color(id: u16) -> [u8; 3] {
    let bits = Stream::named(0, "instance color", &[u64::from(id)]).next_u64().to_le_bytes();
    [bits[0] | 0x60, bits[1] | 0x60, bits[2] | 0x60]
}
