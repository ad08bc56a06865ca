//! All that is counted of a dataset.

use crate::merge::{Merge, merge_fields};
use crate::{
    BoxStatistics, HeatMap, Looks, Motions, PeopleStatistics, SceneStatistics, Tally, TrackStatistics,
    VehicleStatistics,
};
use endless_world::ObjectClass;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// A row of the paper's Table 2: a dataset, or one of those that make a dataset together.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Miniset {
    /// Name of its folder or file.
    pub name: String,
    /// Complete videos.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub videos: Option<u64>,
    /// Videos that are planned and not complete: nothing is counted of them.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub incomplete_videos: Option<u64>,
    /// Frames of all cameras.
    pub camera_frames: u64,
    /// Boxes.
    pub boxes: u64,
    /// Most moving vehicles that were placed in one of its scenes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_vehicles: Option<u64>,
    /// Most people that were placed in one of its scenes.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub max_pedestrians: Option<u64>,
}

/// How much there is.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Totals {
    /// Videos, each one scene filmed by all its cameras.
    pub videos: u64,
    /// Sequences: a camera of a video is one.
    pub sequences: u64,
    /// Frames of the scenes: instants.
    pub instants: u64,
    /// Frames of all cameras: pictures.
    pub camera_frames: u64,
    /// Those of them that were looked at: one of `stride`.
    pub camera_frames_read: u64,
    /// Length of all scenes, milliseconds.
    pub scene_ms: u64,
    /// Length of all sequences, milliseconds.
    pub sequence_ms: u64,
    /// Pictures by size, `640x360`.
    pub sizes: BTreeMap<String, u64>,
    /// Pictures by frames a second.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub fps: BTreeMap<String, u64>,
    /// Boxes in each picture.
    pub boxes_per_frame: Tally,
    /// Boxes in them.
    pub boxes: u64,
    /// Pictures without a box.
    pub empty_frames: u64,
}

merge_fields!(Totals {
    videos,
    sequences,
    instants,
    camera_frames,
    camera_frames_read,
    scene_ms,
    sequence_ms,
    sizes,
    fps,
    boxes_per_frame,
    boxes,
    empty_frames,
});

/// Objects that are seen, by class.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct ObjectStatistics {
    /// Objects of videos that at least one camera sees.
    pub seen: u64,
    /// Those that at least two cameras see.
    pub seen_by_several_cameras: u64,
}

merge_fields!(ObjectStatistics { seen, seen_by_several_cameras });

/// What only datasets of this program tell.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct WorldStatistics {
    /// What was filmed.
    pub scenes: SceneStatistics,
    /// Objects by class.
    pub objects: BTreeMap<ObjectClass, ObjectStatistics>,
    /// Tracks by class.
    pub tracks: BTreeMap<ObjectClass, TrackStatistics>,
    /// Speeds.
    pub motion: Motions,
    /// People.
    pub people: PeopleStatistics,
    /// Vehicles.
    pub vehicles: VehicleStatistics,
    /// Looks that come back.
    pub looks: Looks,
}

merge_fields!(WorldStatistics { scenes, objects, tracks, motion, people, vehicles, looks });

/// What a COCO file has that is not counted.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct CocoStatistics {
    /// Categories that became classes.
    pub categories: BTreeMap<String, ObjectClass>,
    /// Boxes of categories that are none of our classes, by category.
    pub other_boxes: BTreeMap<String, u64>,
    /// Boxes around crowds (`iscrowd`).
    pub crowd_boxes: u64,
    /// Boxes without width or height, or of pictures that the file does not list.
    pub broken_boxes: u64,
}

/// Everything that is counted of a dataset.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct DatasetStatistics {
    /// Version of these fields.
    pub format: u32,
    /// One frame of so many was looked at.
    pub stride: u32,
    /// The datasets, one or more (Table 2).
    pub datasets: Vec<Miniset>,
    /// How much there is.
    pub totals: Totals,
    /// All boxes.
    pub boxes: BoxStatistics,
    /// Boxes by class; every class that the dataset can have.
    pub classes: BTreeMap<ObjectClass, BoxStatistics>,
    /// Where in the pictures the middles of boxes are.
    pub heat_map: HeatMap,
    /// What COCO's files do not tell.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub world: Option<WorldStatistics>,
    /// What is left out of a COCO file.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub coco: Option<CocoStatistics>,
}

impl DatasetStatistics {
    /// Version of the fields that this program writes.
    pub const FORMAT: u32 = 1;

    /// A name for all datasets together.
    pub fn name(&self) -> String {
        self.datasets.iter().map(|set| set.name.as_str()).collect::<Vec<_>>().join(" + ")
    }

    /// The classes that the dataset can have.
    pub fn vocabulary(&self) -> BTreeSet<ObjectClass> {
        self.classes.keys().copied().collect()
    }

    /// Adds up the classes.
    pub(crate) fn finish(mut self) -> Self {
        self.boxes = BoxStatistics::default();
        for boxes in self.classes.values() {
            self.boxes.absorb(boxes.clone());
        }
        self
    }

    /// Two datasets as one, whose rows are those of both.
    #[must_use]
    pub fn and(mut self, other: Self) -> Self {
        self.datasets.extend(other.datasets);
        self.totals.absorb(other.totals);
        self.boxes.absorb(other.boxes);
        self.classes.absorb(other.classes);
        self.heat_map.absorb(other.heat_map);
        self.world.absorb(other.world);
        self
    }
}
