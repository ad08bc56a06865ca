//! The formats, an entry each.

use crate::{
    ai_city::AiCity,
    cityscapes::Cityscapes,
    coco::{CocoDetection, CocoKeypoints, CocoPanoptic},
    cvat::Cvat,
    exporter::Exporter,
    hugging_face::HuggingFace,
    kitti::{KittiObject, KittiRaw, KittiTracking},
    label_studio::LabelStudio,
    mot::{Mot, Mots},
    nuscenes::NuScenes,
    open_images::OpenImages,
    parquet_tables::ParquetTables,
    reid::{Market, Veri},
    tfrecord::TfRecord,
    voc::PascalVoc,
    web_dataset::WebDataset,
    yolo::{Yolo, YoloTask},
};
use endless_dataset::Layer;
use endless_world::UnknownName;
use serde::{Deserialize, Serialize};
use std::fmt;
use strum::VariantArray as _;

/// A format that datasets can be exported to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[derive(strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum Format {
    /// COCO's instances, masks as run lengths.
    Coco,
    /// COCO's instances, masks as polygons.
    CocoPolygons,
    /// COCO's person keypoints.
    CocoKeypoints,
    /// COCO's panoptic segmentation.
    CocoPanoptic,
    /// COCO's instances as Roboflow imports them.
    Roboflow,
    /// YOLO, boxes.
    Yolo,
    /// YOLO, polygons.
    YoloSegment,
    /// YOLO, keypoints.
    YoloPose,
    /// YOLO, oriented boxes.
    YoloObb,
    /// MOTChallenge.
    Mot,
    /// MOTS.
    Mots,
    /// KITTI's object benchmark.
    KittiObject,
    /// KITTI's tracking benchmark.
    KittiTracking,
    /// KITTI's raw data.
    KittiRaw,
    /// nuScenes' tables.
    #[serde(rename = "nuscenes")]
    #[strum(serialize = "nuscenes")]
    NuScenes,
    /// Cityscapes.
    Cityscapes,
    /// Pascal VOC.
    PascalVoc,
    /// AI City Challenge, multi-camera tracking.
    AiCity,
    /// Market-1501.
    #[serde(rename = "market1501")]
    #[strum(serialize = "market1501")]
    Market1501,
    /// VeRi-776.
    Veri,
    /// CVAT for images.
    Cvat,
    /// Label Studio.
    LabelStudio,
    /// Open Images.
    OpenImages,
    /// WebDataset.
    #[serde(rename = "webdataset")]
    #[strum(serialize = "webdataset")]
    WebDataset,
    /// Parquet.
    Parquet,
    /// Hugging Face image folder.
    #[serde(rename = "huggingface")]
    #[strum(serialize = "huggingface")]
    HuggingFace,
    /// TFRecord.
    #[serde(rename = "tfrecord")]
    #[strum(serialize = "tfrecord")]
    TfRecord,
}

/// What is to be known of a format.
pub struct FormatEntry {
    /// What it is for, in a line.
    pub about: &'static str,
    /// Its page in `docs/export`, without an ending.
    pub page: &'static str,
    /// Layers that it needs.
    pub layers: &'static [Layer],
    pub(crate) exporter: fn() -> Box<dyn Exporter>,
}

impl fmt::Debug for FormatEntry {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FormatEntry").field("about", &self.about).field("layers", &self.layers).finish_non_exhaustive()
    }
}

const NOTHING: &[Layer] = &[];
const PICTURES: &[Layer] = &[Layer::Rgb];
const MASKS: &[Layer] = &[Layer::Rgb, Layer::Instance];

impl Format {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The word used on the command line.
    pub fn name(self) -> &'static str {
        self.into()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("format", given, Self::ALL)
    }

    /// The format's entry.
    pub const fn entry(self) -> &'static FormatEntry {
        macro_rules! entry {
            ($page:literal, $about:literal, $layers:expr, $exporter:expr) => {
                &FormatEntry { page: $page, about: $about, layers: $layers, exporter: || Box::new($exporter) }
            };
        }
        match self {
            Self::Coco => {
                entry!("coco", "COCO instances: boxes, masks as run lengths", MASKS, CocoDetection::RUN_LENGTHS)
            }
            Self::CocoPolygons => {
                entry!("coco", "COCO instances: boxes, masks as polygons", MASKS, CocoDetection::POLYGONS)
            }
            Self::CocoKeypoints => entry!("coco", "COCO person keypoints", MASKS, CocoKeypoints),
            Self::CocoPanoptic => entry!("coco", "COCO panoptic segmentation", MASKS, CocoPanoptic),
            Self::Roboflow => entry!("coco", "COCO instances as Roboflow imports them", MASKS, CocoDetection::ROBOFLOW),
            Self::Yolo => entry!("yolo", "YOLO boxes (Ultralytics)", PICTURES, Yolo(YoloTask::Detect)),
            Self::YoloSegment => entry!("yolo", "YOLO polygons", MASKS, Yolo(YoloTask::Segment)),
            Self::YoloPose => entry!("yolo", "YOLO keypoints of people and riders", PICTURES, Yolo(YoloTask::Pose)),
            Self::YoloObb => entry!("yolo", "YOLO oriented boxes", MASKS, Yolo(YoloTask::OrientedBoxes)),
            Self::Mot => entry!("mot", "MOTChallenge: boxes with tracks", PICTURES, Mot),
            Self::Mots => entry!("mot", "MOTS: masks with tracks", MASKS, Mots),
            Self::KittiObject => entry!("kitti", "KITTI object detection, boxes in space", PICTURES, KittiObject),
            Self::KittiTracking => entry!("kitti", "KITTI tracking", PICTURES, KittiTracking),
            Self::KittiRaw => entry!("kitti", "KITTI raw data: pictures, times, calibration", PICTURES, KittiRaw),
            Self::NuScenes => entry!("nuscenes", "nuScenes tables: boxes in space with tracks", PICTURES, NuScenes),
            Self::Cityscapes => entry!("cityscapes", "Cityscapes: semantic and instance images", MASKS, Cityscapes),
            Self::PascalVoc => entry!("pascal_voc", "Pascal VOC: boxes in XML", PICTURES, PascalVoc),
            Self::AiCity => entry!("ai_city", "AI City: tracks through all cameras of a scene", NOTHING, AiCity),
            Self::Market1501 => entry!("reid", "Market-1501: crops of people", PICTURES, Market::default()),
            Self::Veri => entry!("reid", "VeRi-776: crops of vehicles", PICTURES, Veri::default()),
            Self::Cvat => entry!("cvat", "CVAT for images 1.1", PICTURES, Cvat),
            Self::LabelStudio => entry!("label_studio", "Label Studio tasks", PICTURES, LabelStudio),
            Self::OpenImages => entry!("open_images", "Open Images CSV", PICTURES, OpenImages),
            Self::WebDataset => entry!("webdataset", "WebDataset shards of all stored layers", PICTURES, WebDataset),
            Self::Parquet => entry!("parquet", "Parquet tables of frames and objects", NOTHING, ParquetTables),
            Self::HuggingFace => {
                entry!("huggingface", "Hugging Face image folder with a dataset card", PICTURES, HuggingFace)
            }
            Self::TfRecord => entry!("tfrecord", "TFRecord of the Object Detection API", PICTURES, TfRecord),
        }
    }
}
