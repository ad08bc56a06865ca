//! The layers of a recording: one entry each, with all that writers, readers, videos, estimates and documents need to
//! know of it. A new layer is a new entry here, and an image in the renderer's [`SensorFrame`].

use crate::{
    RgbFormat, StoredImage,
    body_parts::{body_parts_preview, parts_from_rgb, rgb_from_parts},
    encoding::{
        check_grey, depth_from_rgb, instance_from_panoptic, instance_from_rgb, panoptic_from_instance, rgb_from_depth,
        rgb_from_grey, rgb_from_instance, semantic_from_instance, tags_from_semantic,
    },
    flow::{check_flow, flow_preview},
    normals::check_normals,
    preview::{depth_preview, instance_preview, normals_preview, semantic_preview},
};
use endless_world::{CameraLookChoice, Image, SensorFrame, SensorLayers, UnknownName};
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
    /// Class tag alone.
    Semantic,
    /// Segments of objects and of stuff, COCO's encoding.
    Panoptic,
    /// Unit surface normals.
    Normals,
    /// Colours of surfaces without light.
    Albedo,
    /// Where the sun is hidden.
    Shadow,
    /// Parts of people's bodies, DensePose's.
    BodyParts,
    /// Optical flow to the next frame, KITTI's encoding.
    Flow,
    /// Optical flow to the frame before.
    FlowBackward,
}

/// A picture for people, or what is wrong with the image that it should show.
type Preview<'a> = Result<Cow<'a, Image<[u8; 3]>>, String>;

/// All that is to be known of a layer.
#[derive(Debug, Clone, Copy)]
pub struct LayerEntry {
    /// Meaning of its pixels, in one line for the documents.
    pub summary: &'static str,
    /// Whether it may be stored with loss, in the recipe's RGB format. What is not is always PNG.
    pub lossy: bool,
    /// The image of a frame that is stored, if the simulator made it.
    pub encode: fn(&SensorFrame) -> Option<StoredImage<'_>>,
    /// The frame of the layer's video for a stored image, or what is wrong with the image.
    pub preview: for<'a> fn(&'a StoredImage<'_>) -> Preview<'a>,
    /// What is wrong with a stored image by itself.
    pub check: fn(&StoredImage<'_>) -> Result<(), String>,
    /// Bytes a pixel of its files, a tenth above the dearest scene measured.
    pub bytes_a_pixel: fn(RgbFormat, CameraLookChoice) -> f64,
}

impl Layer {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;
    /// Those that are stored where nothing else is asked for.
    pub const DEFAULT: &[Self] = &[Self::Rgb, Self::Depth, Self::Instance];

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
            Self::Semantic => &SEMANTIC,
            Self::Panoptic => &PANOPTIC,
            Self::Normals => &NORMALS,
            Self::Albedo => &ALBEDO,
            Self::Shadow => &SHADOW,
            Self::BodyParts => &BODY_PARTS,
            Self::Flow => &FLOW,
            Self::FlowBackward => &FLOW_BACKWARD,
        }
    }

    /// What a simulator must be asked for to store these layers.
    pub fn wanted(layers: &[Self]) -> SensorLayers {
        SensorLayers {
            normals: layers.contains(&Self::Normals),
            albedo: layers.contains(&Self::Albedo),
            shadow: layers.contains(&Self::Shadow),
            body_parts: layers.contains(&Self::BodyParts),
            flow: layers.contains(&Self::Flow),
            flow_backward: layers.contains(&Self::FlowBackward),
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
    encode: |frame| Some((&frame.rgb).into()),
    preview: |stored| Ok(Cow::Borrowed(stored.rgb8()?)),
    check: |stored| stored.rgb8().map(drop),
    bytes_a_pixel: |format, look| (format.entry().rgb_bytes_a_pixel)(look),
};

const DEPTH: LayerEntry = LayerEntry {
    summary: "`metres = 1000 × (R + 256 G + 65536 B) / (256³ − 1)` along the optical axis; the sky has the largest value",
    lossy: false,
    encode: |frame| Some(rgb_from_depth(&frame.depth).into()),
    preview: |stored| Ok(Cow::Owned(depth_preview(&depth_from_rgb(stored.rgb8()?)))),
    check: |stored| stored.rgb8().map(drop),
    bytes_a_pixel: |_format, _look| 1.1,
};

const INSTANCE: LayerEntry = LayerEntry {
    summary: "R = class tag (CARLA's 29), object id = G + 256 B; ids are unique within a video, the same in all its cameras \
              and frames, 0 for stuff",
    lossy: false,
    encode: |frame| Some(rgb_from_instance(&frame.instance).into()),
    preview: |stored| Ok(Cow::Owned(instance_preview(&instance_from_rgb(stored.rgb8()?).map_err(no_tag)?))),
    check: |stored| instance_from_rgb(stored.rgb8()?).map(drop).map_err(no_tag),
    bytes_a_pixel: |_format, _look| 0.06,
};

const SEMANTIC: LayerEntry = LayerEntry {
    summary: "R = class tag (CARLA's 29), G = B = 0 (docs/layers/semantic.md)",
    lossy: false,
    encode: |frame| Some(semantic_from_instance(&frame.instance).into()),
    preview: |stored| Ok(Cow::Owned(semantic_preview(&tags_from_semantic(stored.rgb8()?)?))),
    check: |stored| tags_from_semantic(stored.rgb8()?).map(drop),
    bytes_a_pixel: |_format, _look| 0.05,
};

const PANOPTIC: LayerEntry = LayerEntry {
    summary: "COCO's panoptic PNG: segment = R + 256 G + 65536 B = object id + 65536 × class tag, object id 0 for stuff \
              (docs/layers/panoptic.md)",
    lossy: false,
    encode: |frame| Some(panoptic_from_instance(&frame.instance).into()),
    preview: |stored| Ok(Cow::Owned(instance_preview(&instance_from_panoptic(stored.rgb8()?).map_err(no_tag)?))),
    check: |stored| instance_from_panoptic(stored.rgb8()?).map(drop).map_err(no_tag),
    bytes_a_pixel: |_format, _look| 0.06,
};

const NORMALS: LayerEntry = LayerEntry {
    summary: "16 bits a channel: unit surface normal `n = 2 × RGB / 65535 − 1`, x right, y down, z forward; the sky is 0, 0, 0 \
              (docs/layers/normals.md)",
    lossy: false,
    encode: |frame| Some(frame.normals.as_ref()?.into()),
    preview: |stored| Ok(Cow::Owned(normals_preview(stored.rgb16()?))),
    check: |stored| check_normals(stored.rgb16()?),
    bytes_a_pixel: |_format, _look| 1.6,
};

const ALBEDO: LayerEntry = LayerEntry {
    summary: "colour of the surface without the light that falls on it, sRGB; the sky is black (docs/layers/albedo.md)",
    lossy: false,
    encode: |frame| Some(frame.albedo.as_ref()?.into()),
    preview: |stored| Ok(Cow::Borrowed(stored.rgb8()?)),
    check: |stored| stored.rgb8().map(drop),
    bytes_a_pixel: |_format, _look| 1.6,
};

const SHADOW: LayerEntry = LayerEntry {
    summary: "R = G = B: share of the sun's disc that is hidden there, 0 in the light, 255 in the shadow; 0 for the sky and where no \
              sun shines (docs/layers/shadow.md)",
    lossy: false,
    encode: |frame| Some(rgb_from_grey(frame.shadow.as_ref()?).into()),
    preview: |stored| Ok(Cow::Borrowed(stored.rgb8()?)),
    check: |stored| check_grey(stored.rgb8()?),
    bytes_a_pixel: |_format, _look| 0.2,
};

const BODY_PARTS: LayerEntry = LayerEntry {
    summary: "R = part of the body of people and riders, 1 to 14 as DensePose numbers them, 15 what they carry; G = B = 0; 0 \
              everywhere else (docs/layers/body_parts.md)",
    lossy: false,
    encode: |frame| Some(rgb_from_parts(frame.body_parts.as_ref()?).into()),
    preview: |stored| Ok(Cow::Owned(body_parts_preview(stored.rgb8()?)?)),
    check: |stored| parts_from_rgb(stored.rgb8()?).map(drop),
    bytes_a_pixel: |_format, _look| 0.05,
};

const FLOW: LayerEntry = LayerEntry {
    summary: "16 bits a channel, KITTI's encoding: the point of pixel (x, y) is at x + (R − 2¹⁵) / 64, y + (G − 2¹⁵) / 64 in the \
              next frame; B = 1 visible there, 2 hidden, 3 outside, 0 unknown (docs/layers/flow.md)",
    lossy: false,
    encode: |frame| Some(frame.flow.as_ref()?.into()),
    preview: |stored| Ok(Cow::Owned(flow_preview(stored.rgb16()?)?)),
    check: |stored| check_flow(stored.rgb16()?),
    bytes_a_pixel: |_format, _look| 0.2,
};

const FLOW_BACKWARD: LayerEntry = LayerEntry {
    summary: "the same to the frame before (docs/layers/flow.md)",
    encode: |frame| Some(frame.flow_backward.as_ref()?.into()),
    ..FLOW
};

/// The error of an image that has this value as a class tag.
fn no_tag(value: u8) -> String {
    format!("has the tag {value}: they end at 28")
}

#[cfg(test)]
mod tests;
