//! The layers of a recording: one entry each, with all that writers, readers, videos, estimates and documents need to
//! know of it. A new layer is a new entry here, and an image in the renderer's [`SensorFrame`].

use crate::{
    RgbFormat, StoredImage,
    encoding::{depth_from_rgb, instance_from_rgb, rgb_from_depth, rgb_from_instance},
    preview::{depth_preview, instance_preview},
};
use endless_world::{CameraLookChoice, SensorFrame, UnknownName};
use std::borrow::Cow;
use strum::VariantArray as _;

/// One aligned image of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum Layer {
    /// The camera's picture, sRGB.
    Rgb,
    /// Planar depth, CARLA's 24-bit encoding.
    Depth,
    /// Class tag and instance id.
    Instance,
}

/// All that is to be known of a layer.
#[derive(Debug, Clone, Copy)]
pub struct LayerEntry {
    /// Meaning of its pixels, in one line for the documents.
    pub summary: &'static str,
    /// Whether it may be stored with loss, in the recipe's RGB format. What is not is always PNG.
    pub lossy: bool,
    /// The image of a frame that is stored.
    pub encode: fn(&SensorFrame) -> Cow<'_, StoredImage>,
    /// The frame of the layer's video for a stored image, or what is wrong with the image.
    pub preview: fn(&StoredImage) -> Result<Cow<'_, StoredImage>, String>,
    /// What is wrong with a stored image by itself.
    pub check: fn(&StoredImage) -> Result<(), String>,
    /// Bytes a pixel of its files, a tenth above the dearest scene measured.
    pub bytes_a_pixel: fn(RgbFormat, CameraLookChoice) -> f64,
}

impl Layer {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The word used on the command line and in files.
    pub fn name(self) -> &'static str {
        self.into()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("layer", given, Self::ALL)
    }

    /// The layer's entry.
    pub const fn entry(self) -> &'static LayerEntry {
        match self {
            Self::Rgb => &RGB,
            Self::Depth => &DEPTH,
            Self::Instance => &INSTANCE,
        }
    }

    /// The format of its files.
    pub const fn format(self, rgb_format: RgbFormat) -> RgbFormat {
        if self.entry().lossy { rgb_format } else { RgbFormat::Png }
    }
}

// Bytes were measured on four scenes at 1280x720 (rain, fog, clear sky and after rain, by day and by night), each file's
// bytes by its pixels: 0.45 to 1.11 for RGB, 0.63 to 1.0 for depth, 0.035 to 0.06 for instances; all three of a camera
// frame 1.1 to 2.0, about 1.7 in the mean.

const RGB: LayerEntry = LayerEntry {
    summary: "what the camera sees, sRGB",
    lossy: true,
    encode: |frame| Cow::Borrowed(&frame.rgb),
    preview: |stored| Ok(Cow::Borrowed(stored)),
    check: |_any| Ok(()),
    bytes_a_pixel: |format, look| (format.entry().rgb_bytes_a_pixel)(look),
};

const DEPTH: LayerEntry = LayerEntry {
    summary: "`metres = 1000 × (R + 256 G + 65536 B) / (256³ − 1)` along the optical axis; the sky has the largest value",
    lossy: false,
    encode: |frame| Cow::Owned(rgb_from_depth(&frame.depth)),
    preview: |stored| Ok(Cow::Owned(depth_preview(&depth_from_rgb(stored)))),
    check: |_any| Ok(()),
    bytes_a_pixel: |_format, _look| 1.1,
};

const INSTANCE: LayerEntry = LayerEntry {
    summary: "R = class tag (CARLA's 29), object id = G + 256 B; ids are unique within a video, the same in all its cameras \
              and frames, 0 for stuff",
    lossy: false,
    encode: |frame| Cow::Owned(rgb_from_instance(&frame.instance)),
    preview: |stored| Ok(Cow::Owned(instance_preview(&instance_from_rgb(stored).map_err(no_tag)?))),
    check: |stored| instance_from_rgb(stored).map(drop).map_err(no_tag),
    bytes_a_pixel: |_format, _look| 0.06,
};

/// The error of an instance image that has this value as a class tag.
fn no_tag(value: u8) -> String {
    format!("has the tag {value}: they end at 28")
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{ClassTag, Image, ImageSize, InstanceId, InstancePixel};

    /// Whatever is stored passes its own check and can be shown.
    #[test]
    fn every_layer_stores_what_it_accepts() {
        let size = ImageSize { width: 3, height: 2 };
        let frame = SensorFrame {
            frame: 0,
            rgb: Image::filled(size, [1, 2, 3]),
            depth: Image::filled(size, 12.5),
            instance: Image::filled(size, InstancePixel { tag: ClassTag::Car, id: InstanceId(700) }),
        };
        for layer in Layer::ALL {
            let entry = layer.entry();
            let stored = (entry.encode)(&frame);
            assert_eq!((entry.check)(&stored), Ok(()), "{layer}");
            assert_eq!((entry.preview)(&stored).expect("shown").size, size, "{layer}");
            let bytes = (entry.bytes_a_pixel)(RgbFormat::Png, CameraLookChoice::Natural);
            assert!((0.01..=3.1).contains(&bytes), "{layer}: {bytes}");
            assert_eq!(entry.lossy, layer.format(RgbFormat::Jpg) == RgbFormat::Jpg, "{layer}");
        }
        let no_tag = Image::filled(size, [29, 0, 0]);
        assert!((Layer::Instance.entry().check)(&no_tag).is_err_and(|reason| reason.contains("29")));
        assert!((Layer::Instance.entry().preview)(&no_tag).is_err());
    }
}
