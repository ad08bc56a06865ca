//! Statistics of datasets: how much there is of what.
//!
//! [`DatasetStatistics::of_dataset`] reads the labels of a dataset line by line and counts: what the paper's Table 2 and Figures
//! 9 to 12 tell, and boxes, tracks, speeds, people and looks. [`DatasetStatistics::of_coco`] counts what a detection dataset in
//! COCO form tells of the same. [`Comparison`] lays datasets side by side. Both can be written as text and as one web page;
//! the JSON is that of the structures themselves. `docs/stats.md` explains each figure.
//!
//! All counts are whole numbers that are added up, so that they do not depend on who counts which video first.
//! [`distributions`] lists the shares of everything under one form, from which charts, tables and comparisons are made.
//!
//! ```no_run
//! use endless_statistics::{Comparison, CocoClasses, DatasetStatistics, GatherOptions, Report};
//!
//! let ours = DatasetStatistics::of_dataset("out".as_ref(), &GatherOptions::default())?;
//! let text = Report::of_dataset(&ours).text();
//! let real = DatasetStatistics::of_coco("instances_val2017.json".as_ref(), &CocoClasses::default())?;
//! let page = Report::of_comparison(&Comparison::new(vec![ours, real])).page();
//! # Ok::<(), endless_statistics::StatisticsError>(())
//! ```

mod boxes;
mod camera_count;
mod coco;
mod coco_classes;
mod comparison;
mod distribution;
mod distributions;
mod error;
mod gather;
mod heat_map;
mod histogram;
mod label_line;
mod line_reader;
mod looks;
mod merge;
mod motion;
mod people;
mod report;
mod scales;
mod scenes;
mod statistics;
mod tally;
mod video_count;

pub use boxes::{BoxStatistics, Sizes};
pub use coco_classes::CocoClasses;
pub use comparison::{Comparison, NumberRow, ShareTable, Side};
pub use distribution::Distribution;
pub use distributions::distributions;
pub use error::StatisticsError;
pub use gather::GatherOptions;
pub use heat_map::HeatMap;
pub use histogram::{Histogram, Scale};
pub use looks::{LookStatistics, Looks};
pub use motion::{MotionStatistics, Motions, TrackStatistics};
pub use people::{ByWord, PeopleStatistics, Represented, VehicleStatistics};
pub use report::{Chart, HeatMapFigure, Item, Report, Section, Series, Table, Tile};
pub use scenes::{Conditions, EventStatistics, Filmed, SceneStatistics, ViewStatistics};
pub use statistics::{CocoStatistics, DatasetStatistics, Miniset, ObjectStatistics, Totals, WorldStatistics};
pub use tally::Tally;
