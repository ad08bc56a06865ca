//! The files of a dataset: layout, encodings, writers, readers, video and validation.
//!
//! Every file is written under a temporary name and renamed: a file with its final name is complete. The file that marks a
//! video as complete is written when all other files of the video are on the disk. Every writer has a reader, and [`check`]
//! reopens a whole dataset with them.
//!
//! [`DatasetLayout`] gives the paths, [`Manifest`] is `dataset.json`, [`Layer`] describes the kinds of images,
//! [`VideoEncoder`] writes videos, and [`Recipe`] holds everything that decides the bytes. Writing and reading an image:
//!
//! ```
//! use endless_dataset::{Layer, RgbFormat, depth_from_rgb, encode_png, read_rgb, rgb_from_depth, write_atomic};
//! use endless_world::{Image, ImageSize};
//!
//! let folder = tempfile::tempdir()?;
//! let path = folder.path().join("000000.png");
//! let depth_m = Image::filled(ImageSize { width: 4, height: 3 }, 12.5);
//! write_atomic(&path, &encode_png(&rgb_from_depth(&depth_m)))?;
//! // Depth is exact, so it is PNG also where the recipe wants JPEG.
//! let stored = read_rgb(&path, Layer::Depth.format(RgbFormat::Jpg))?;
//! assert!((depth_from_rgb(stored.rgb8()?).data[0] - 12.5).abs() < 1e-4);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod actor_schema;
mod actors;
mod atomic;
mod body_parts;
mod build_identity;
mod camera_output;
mod camera_record;
mod card;
mod check;
mod durable;
mod encoding;
mod error;
mod flow;
mod frame_reader;
mod instance_reader;
mod json_lines;
mod labels;
mod layer;
mod layout;
mod listing;
mod manifest;
mod mp4;
mod normals;
mod object_fields;
mod objects;
mod pixel_events;
mod planes;
mod png_encoder;
mod point_cloud;
mod pose_line;
mod preview;
mod raster;
mod recipe;
mod rgb_format;
mod scene_record;
mod sensor_files;
mod sensor_record;
mod shared_files;
mod stored_image;
mod temporary;
mod video;
mod video_builds;

pub use actor_schema::ActorSchema;
pub use actors::{read_actors, write_actors};
pub use atomic::{AtomicFile, remove_temporaries, write_atomic, write_durable};
pub use build_identity::BuildIdentity;
pub use camera_output::CameraOutput;
pub use camera_record::CameraRecord;
pub use card::{Card, CardFacts, recipe_toml, size_category};
pub use check::{CheckOptions, CheckReport, Finding, check, check_with};
pub use durable::sync_tree;
pub use encoding::{
    depth_from_rgb, instance_from_rgb, metres_from_rgb, rgb_from_depth, rgb_from_instance, rgb_from_metres,
};
pub use error::DatasetError;
pub use frame_reader::{CameraFrames, FrameReader, FrameSelection};
pub use instance_reader::InstanceReader;
pub use json_lines::{LinesWriter, read_lines};
pub use labels::LabelSchema;
pub use layer::{Layer, LayerEntry};
pub use layout::{CameraLayout, DatasetLayout, VideoLayout};
pub use manifest::{Manifest, VideoEntry, VideoState};
pub use mp4::{Mp4Info, Mp4Writer, read_mp4};
pub use object_fields::FieldLabel;
pub use objects::{ObjectsWriter, read_objects};
pub use pixel_events::{decode_pixel_events, encode_pixel_events};
pub use planes::{Plane, PlaneValues};
pub use png_encoder::LastPng;
pub use point_cloud::{
    PointLabel, bin_from_points, csv_from_detections, detections_from_csv, kitti_pose_line, label_from_points,
    pcd_from_points, ply_from_points, point_labels, points_from_bin, points_from_pcd, points_from_ply,
};
pub use pose_line::PoseLine;
pub use preview::{depth_preview, instance_preview};
pub use raster::{encode_jpg, encode_png};
pub use recipe::{
    CameraSpec, CarrierClass, EventCameraSpec, LidarSpec, MAX_CAMERAS, ModelSpec, MountSpec, OptionDefault,
    OptionError, OptionKind, Origin, PanTiltZoomKey, PointCloudFormat, Preset, Recipe, RecipeDraft, RecipeOption,
    SensorSpec, UserCamera, Vocabulary, WayPointSpec, recipe_schema,
};
pub use rgb_format::{RgbFormat, RgbFormatEntry, read_rgb};
pub use scene_record::{SceneRecord, SpawnCounts, read_json, write_json, write_json_durable, write_json_line};
pub use sensor_files::FrameFolder;
pub use sensor_record::SensorRecord;
pub use shared_files::SharedFiles;
pub use stored_image::StoredImage;
pub use video::{VideoEncoder, Yuv, yuv_from_rgb};
