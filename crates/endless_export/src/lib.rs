//! Exports of a dataset to the formats of others: COCO, YOLO, MOTChallenge, KITTI and more.
//!
//! [`export`] opens a dataset's complete videos, divides them into parts such that no scene is in two of them ([`SplitShares`],
//! [`SplitBy`]), and has the exporter of a [`Format`] write one video after another, frame by frame: memory holds a few frames,
//! however many there are. What was interrupted goes on with the first video that is not done.
//!
//! ```text
//!  OUT ──► SourceDataset ──► Sequence a camera and video ──► LabelledFrame a frame ──► exporter of the format ──► DIR
//!              dataset.json        classes, stride                boxes, images            parts, then whole files
//! ```
//!
//! ```no_run
//! use endless_export::{ClassMapping, ExportOptions, Format, Placing, SplitBy, export};
//!
//! let options = ExportOptions {
//!     format: Format::Coco,
//!     to: "coco".into(),
//!     split: Some("train=0.8,val=0.1,test=0.1".parse()?),
//!     by: SplitBy::Map,
//!     classes: ClassMapping::default(),
//!     min_visibility: 0.2,
//!     stride: 10,
//!     placing: Placing::Link,
//!     progress: None,
//! };
//! println!("{} frames", export("out".as_ref(), &options)?.frames);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod ai_city;
mod camera;
mod cityscapes;
mod classes;
mod coco;
mod cvat;
mod error;
mod export;
mod exporter;
mod format;
mod frame;
mod frame_list;
mod hugging_face;
mod instance_pool;
mod job;
mod kitti;
mod label_studio;
mod mot;
mod nuscenes;
mod open_images;
mod outline;
mod parquet_tables;
mod parts;
mod pictures;
mod placing;
mod png;
mod reid;
mod sequence;
mod sink;
mod source;
mod split;
mod target;
mod tfrecord;
mod voc;
mod web_dataset;
mod xml;
mod yolo;

pub use classes::{ClassMapping, ExportClass};
pub use error::ExportError;
pub use export::{ExportOptions, ExportReport, export};
pub use format::{Format, FormatEntry};
pub use frame::{Label, LabelledFrame};
pub use instance_pool::PooledInstance;
pub use parts::parts;
pub use placing::Placing;
pub use sequence::Sequence;
pub use source::SourceDataset;
pub use split::{SplitBy, SplitShares};
