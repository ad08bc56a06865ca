use super::*;
use crate::LastPng;
use endless_world::{ClassTag, FlowPixel, Image, ImageSize, InstanceId, InstancePixel};

/// Whatever is stored passes its own check and can be shown.
#[test]
fn every_layer_stores_what_it_accepts() {
    let size = ImageSize { width: 3, height: 2 };
    let frame = SensorFrame {
        frame: 0,
        rgb: Image::filled(size, [1, 2, 3]),
        depth: Image::filled(size, 12.5),
        instance: Image::filled(size, InstancePixel { tag: ClassTag::Car, id: InstanceId(700) }),
        normals: Some(Image::filled(size, [32_768, 32_768, 0])),
        albedo: Some(Image::filled(size, [9, 8, 7])),
        shadow: Some(Image::filled(size, 191)),
        body_parts: Some(Image::filled(size, 14)),
        flow: Some(Image::filled(size, FlowPixel::STILL.encoded())),
        flow_backward: Some(Image::filled(size, FlowPixel::UNKNOWN)),
    };
    for layer in Layer::ALL {
        let entry = layer.entry();
        let stored = (entry.encode)(&frame).expect("made");
        assert_eq!((entry.check)(&stored), Ok(()), "{layer}");
        assert_eq!((entry.preview)(&stored).expect("shown").size, size, "{layer}");
        let last = LastPng::default();
        let bytes = (RgbFormat::Png.entry().encode)(&stored, &last).expect("a PNG");
        assert_eq!((RgbFormat::Png.entry().decode)(&bytes), Ok(stored), "{layer}");
        let bytes = (entry.bytes_a_pixel)(RgbFormat::Png, CameraLookChoice::Natural);
        assert!((0.01..=3.1).contains(&bytes), "{layer}: {bytes}");
        assert_eq!(entry.lossy, layer.format(RgbFormat::Jpg) == RgbFormat::Jpg, "{layer}");
    }
    for (layer, pixel) in
        [(Layer::Instance, [29u8, 0, 0]), (Layer::Semantic, [29, 0, 0]), (Layer::Panoptic, [0, 0, 29])]
    {
        let no_tag = Image::filled(size, pixel).into();
        assert!((layer.entry().check)(&no_tag).is_err_and(|reason| reason.contains("29")));
        assert!((layer.entry().preview)(&no_tag).is_err());
    }
    let with_id = Image::filled(size, [1u8, 2, 0]).into();
    assert!((Layer::Semantic.entry().check)(&with_id).is_err_and(|reason| reason.contains("green")));
}
