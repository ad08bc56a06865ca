//! The label schema, written to every dataset.

use crate::ActorSchema;
use crate::object_fields::{FieldLabel, object_fields};
use endless_world::{ClassTag, FOOT_KEYPOINTS, KEYPOINT_LIMBS, KEYPOINTS, ObjectClass};
use serde::{Deserialize, Serialize};

/// Meaning of the numbers in the instance image and of the words in `objects.jsonl`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct LabelSchema {
    /// The part before the slash changes when a tag or a class changes its meaning, the number when there are new fields.
    pub version: String,
    /// How to read the instance image.
    pub instance_encoding: String,
    /// How to read the depth image.
    pub depth_encoding: String,
    /// Convention of `bbox`.
    pub bbox: String,
    /// Values of the red channel of the instance image.
    pub tags: Vec<TagLabel>,
    /// Classes of annotated objects.
    pub classes: Vec<ClassLabel>,
    /// Fields of an object in `objects.jsonl`.
    #[serde(default)]
    pub object_fields: Vec<FieldLabel>,
    /// Names of people's keypoints, in the order of `keypoints`: COCO's.
    #[serde(default)]
    pub keypoints: Vec<String>,
    /// Names of the keypoints of feet, in the order of `foot_kpts`: COCO-WholeBody's.
    #[serde(default)]
    pub foot_kpts: Vec<String>,
    /// Which of them limbs join, counted from 1.
    #[serde(default)]
    pub skeleton: Vec<[u8; 2]>,
    /// How to read `actors.json`.
    #[serde(default)]
    pub actors: ActorSchema,
}

/// One tag.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct TagLabel {
    /// Red value.
    pub value: u8,
    /// CARLA's name.
    pub name: String,
    /// CARLA's palette, sRGB.
    pub color: [u8; 3],
}

/// One class of annotated objects.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClassLabel {
    /// Position in the list: a category id for detectors.
    pub id: u8,
    /// The word in `objects.jsonl`.
    pub name: String,
    /// Tag of its pixels.
    pub tag: u8,
}

impl LabelSchema {
    /// The schema of this version.
    pub fn current() -> Self {
        Self {
            version: "carla-0.9.14/2".into(),
            instance_encoding: "R = class tag, instance id = G + 256 B; id 0 is stuff; ids are unique within a video \
                                and the same in all cameras and all frames"
                .into(),
            depth_encoding: "metres = 1000 * (R + 256 G + 65536 B) / (256^3 - 1), planar distance along the optical \
                             axis; the sky has the largest value"
                .into(),
            bbox: "[x, y, w, h] in pixels from the top-left corner, tight around the object's pixels, w = xmax - \
                   xmin + 1"
                .into(),
            tags: ClassTag::ALL
                .iter()
                .map(|t| TagLabel { value: t.value(), name: t.name().into(), color: t.color() })
                .collect(),
            classes: ObjectClass::ALL
                .iter()
                .zip(0..)
                .map(|(c, id)| ClassLabel { id, name: c.name().into(), tag: c.tag().value() })
                .collect(),
            object_fields: object_fields(),
            keypoints: KEYPOINTS.map(String::from).to_vec(),
            foot_kpts: FOOT_KEYPOINTS.map(String::from).to_vec(),
            skeleton: KEYPOINT_LIMBS.to_vec(),
            actors: ActorSchema::current(),
        }
    }
}
