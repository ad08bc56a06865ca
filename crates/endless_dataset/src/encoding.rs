//! The pixel encodings of the contract: CARLA's, and COCO's of panoptic images.

use endless_world::{ClassTag, FAR_PLANE_M, Image, InstanceId, InstancePixel};

/// The value of the far plane: `256³ − 1`.
const FAR_VALUE: u32 = (1 << 24) - 1;

/// `metres = 1000 × (R + 256 G + 65536 B) / (256³ − 1)`; beyond the far plane is the far plane.
pub fn rgb_from_depth(depth: &Image<f32>) -> Image<[u8; 3]> {
    let data = depth.data.iter().map(|&metres| rgb_from_metres(metres)).collect();
    Image { size: depth.size, data }
}

/// One pixel of a depth image; beyond the far plane is the far plane.
#[inline]
pub fn rgb_from_metres(metres: f32) -> [u8; 3] {
    let value = f64::from(metres) * (f64::from(FAR_VALUE) / f64::from(FAR_PLANE_M));
    // A cast saturates and takes NaN for 0, so every float has an encoding.
    let value = ((value + 0.5) as u32).min(FAR_VALUE);
    let [r, g, b, _] = value.to_le_bytes();
    [r, g, b]
}

/// Metres of a depth image.
pub fn depth_from_rgb(encoded: &Image<[u8; 3]>) -> Image<f32> {
    Image { size: encoded.size, data: encoded.data.iter().map(|&pixel| metres_from_rgb(pixel)).collect() }
}

/// Metres of one of its pixels.
#[inline]
pub fn metres_from_rgb([r, g, b]: [u8; 3]) -> f32 {
    let value = u32::from_le_bytes([r, g, b, 0]);
    (f64::from(value) * (f64::from(FAR_PLANE_M) / f64::from(FAR_VALUE))) as f32
}

/// R = tag, `id = G + 256 B`.
pub fn rgb_from_instance(instance: &Image<InstancePixel>) -> Image<[u8; 3]> {
    let encode = |p: &InstancePixel| {
        let [low, high] = p.id.0.to_le_bytes();
        [p.tag.value(), low, high]
    };
    Image { size: instance.size, data: instance.data.iter().map(encode).collect() }
}

/// Tags and ids of an instance image; the first value that is no tag if there is one.
///
/// # Errors
/// The red value that no tag has.
pub fn instance_from_rgb(encoded: &Image<[u8; 3]>) -> Result<Image<InstancePixel>, u8> {
    let mut data = Vec::with_capacity(encoded.data.len());
    for &[r, g, b] in &encoded.data {
        let tag = ClassTag::from_value(r).ok_or(r)?;
        data.push(InstancePixel { tag, id: InstanceId(u16::from_le_bytes([g, b])) });
    }
    Ok(Image { size: encoded.size, data })
}

/// R = tag, G = B = 0.
pub(crate) fn semantic_from_instance(instance: &Image<InstancePixel>) -> Image<[u8; 3]> {
    Image { size: instance.size, data: instance.data.iter().map(|p| [p.tag.value(), 0, 0]).collect() }
}

/// Tags of a semantic image.
///
/// # Errors
/// What is wrong with it.
pub(crate) fn tags_from_semantic(encoded: &Image<[u8; 3]>) -> Result<Image<ClassTag>, String> {
    let tag = |&[r, g, b]: &[u8; 3]| match (ClassTag::from_value(r), [g, b]) {
        (Some(tag), [0, 0]) => Ok(tag),
        (None, _) => Err(format!("has the tag {r}: they end at 28")),
        _ => Err(format!("has green {g} and blue {b}: they are 0")),
    };
    Ok(Image { size: encoded.size, data: encoded.data.iter().map(tag).collect::<Result<_, _>>()? })
}

/// Segment = R + 256 G + 65536 B = id + 65536 × tag.
pub(crate) fn panoptic_from_instance(instance: &Image<InstancePixel>) -> Image<[u8; 3]> {
    let encode = |p: &InstancePixel| {
        let [low, high] = p.id.0.to_le_bytes();
        [low, high, p.tag.value()]
    };
    Image { size: instance.size, data: instance.data.iter().map(encode).collect() }
}

/// Tags and ids of a panoptic image.
///
/// # Errors
/// The blue value that no tag has.
pub(crate) fn instance_from_panoptic(encoded: &Image<[u8; 3]>) -> Result<Image<InstancePixel>, u8> {
    let decode = |&[r, g, b]: &[u8; 3]| {
        let tag = ClassTag::from_value(b).ok_or(b)?;
        Ok(InstancePixel { tag, id: InstanceId(u16::from_le_bytes([r, g])) })
    };
    Ok(Image { size: encoded.size, data: encoded.data.iter().map(decode).collect::<Result<_, u8>>()? })
}

/// R = G = B.
pub(crate) fn rgb_from_grey(grey: &Image<u8>) -> Image<[u8; 3]> {
    Image { size: grey.size, data: grey.data.iter().map(|&value| [value; 3]).collect() }
}

/// Whether an image is grey.
///
/// # Errors
/// How many pixels are not.
pub(crate) fn check_grey(image: &Image<[u8; 3]>) -> Result<(), String> {
    let colored = image.data.iter().filter(|[r, g, b]| r != g || g != b).count();
    if colored == 0 { Ok(()) } else { Err(format!("has {colored} pixels that are not grey")) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::ImageSize;
    use proptest::prelude::*;

    const ONE: ImageSize = ImageSize { width: 1, height: 1 };

    #[test]
    fn all_depth_values_survive() {
        for value in (0..=FAR_VALUE).step_by(97).chain([FAR_VALUE]) {
            let [r, g, b, _] = value.to_le_bytes();
            let image = Image { size: ONE, data: vec![[r, g, b]] };
            let metres = depth_from_rgb(&image);
            // Above 500 m a float is coarser than the encoding's step of 0.06 mm: one step may be lost there.
            let [r2, g2, b2] = rgb_from_depth(&metres).data[0];
            let again = u32::from_le_bytes([r2, g2, b2, 0]);
            assert!(value.abs_diff(again) <= u32::from(metres.data[0] >= 500.0), "{value} became {again}");
        }
    }

    #[test]
    fn depth_of_anything_is_encoded() {
        for (metres, expected) in
            [(0.0, [0, 0, 0]), (1000.0, [255; 3]), (5000.0, [255; 3]), (-1.0, [0, 0, 0]), (f32::NAN, [0, 0, 0])]
        {
            assert_eq!(rgb_from_metres(metres), expected, "{metres}");
        }
    }

    proptest! {
        #[test]
        fn depth_is_exact_to_half_a_step(metres in 0.0f32..1000.0) {
            let image = Image { size: ONE, data: vec![metres] };
            let back = depth_from_rgb(&rgb_from_depth(&image)).data[0];
            prop_assert!((back - metres).abs() <= 0.5 * 1000.0 / FAR_VALUE as f32 + 1e-7 * metres);
        }

        #[test]
        fn instance_round_trip(id: u16, tag in 0usize..29) {
            let pixel = InstancePixel { tag: ClassTag::ALL[tag], id: InstanceId(id) };
            let image = Image { size: ONE, data: vec![pixel] };
            prop_assert_eq!(tags_from_semantic(&semantic_from_instance(&image)).expect("tags").data, vec![pixel.tag]);
            let [r, g, b] = panoptic_from_instance(&image).data[0].map(u32::from);
            prop_assert_eq!(r + 256 * g + 65_536 * b, u32::from(id) + 65_536 * tag as u32);
            prop_assert_eq!(instance_from_panoptic(&panoptic_from_instance(&image)), Ok(image.clone()));
            prop_assert_eq!(instance_from_rgb(&rgb_from_instance(&image)), Ok(image));
        }
    }

    #[test]
    fn a_value_that_is_no_tag_is_refused() {
        assert_eq!(instance_from_rgb(&Image { size: ONE, data: vec![[29, 0, 0]] }), Err(29));
    }
}
