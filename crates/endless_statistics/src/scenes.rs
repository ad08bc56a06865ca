//! What was filmed: maps, conditions, views, events.

use crate::HeatMap;
use crate::merge::merge_fields;
use endless_world::{TimeOfDay, Weather};
use serde::{Serialize, Serializer};
use std::{collections::BTreeMap, fmt};

/// How much was filmed of something.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Filmed {
    /// Videos; of one whose condition changes the condition in which it begins, as in the paper's figures.
    pub videos: u64,
    /// Frames of all cameras; of videos whose condition changes, by the condition of the frame.
    pub camera_frames: u64,
    /// Boxes in these frames.
    pub boxes: u64,
}

merge_fields!(Filmed { videos, camera_frames, boxes });

/// Weather and time of day together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Conditions {
    /// The weather.
    pub weather: Weather,
    /// The time of day.
    pub time_of_day: TimeOfDay,
}

impl fmt::Display for Conditions {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}_{}", self.weather, self.time_of_day)
    }
}

impl Serialize for Conditions {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

/// A view: one camera of a map, or of a rig.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct ViewStatistics {
    /// How much it filmed.
    #[serde(flatten)]
    pub filmed: Filmed,
    /// Where in its picture the middles of boxes are.
    pub heat_map: HeatMap,
}

merge_fields!(ViewStatistics { filmed, heat_map });

/// Events by kind.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct EventStatistics {
    /// Staged: `incidents` of `scene.json`.
    pub staged: BTreeMap<String, u64>,
    /// Asked for, but not to be had.
    pub missed: BTreeMap<String, u64>,
    /// Happened in the scenes, seen by a camera or not: `events` of `frames.jsonl`.
    pub happened: BTreeMap<String, u64>,
}

merge_fields!(EventStatistics { staged, missed, happened });

/// The paper's Figures 9 to 12, and more of the kind.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct SceneStatistics {
    /// By map (Figure 9).
    pub maps: BTreeMap<String, Filmed>,
    /// By weather, all of the paper's five (Figure 10).
    pub weathers: BTreeMap<Weather, Filmed>,
    /// By time of day, all three (Figure 11).
    pub times: BTreeMap<TimeOfDay, Filmed>,
    /// By both, all fifteen (Figure 12).
    pub conditions: BTreeMap<Conditions, Filmed>,
    /// By view, `map/camera`.
    pub views: BTreeMap<String, ViewStatistics>,
    /// Events.
    pub events: EventStatistics,
}

merge_fields!(SceneStatistics { maps, weathers, times, conditions, views, events });

impl Default for SceneStatistics {
    fn default() -> Self {
        let each = |weather: &Weather| {
            let weather = *weather;
            TimeOfDay::ALL.iter().map(move |time_of_day| Conditions { weather, time_of_day: *time_of_day })
        };
        Self {
            maps: BTreeMap::new(),
            weathers: Weather::ALL.iter().map(|weather| (*weather, Filmed::default())).collect(),
            times: TimeOfDay::ALL.iter().map(|time| (*time, Filmed::default())).collect(),
            conditions: Weather::ALL.iter().flat_map(each).map(|both| (both, Filmed::default())).collect(),
            views: BTreeMap::new(),
            events: EventStatistics::default(),
        }
    }
}

impl SceneStatistics {
    /// Adds to a condition and to its two parts.
    pub(crate) fn add(&mut self, conditions: Conditions, filmed: Filmed) {
        use crate::merge::Merge as _;
        self.weathers.entry(conditions.weather).or_default().absorb(filmed);
        self.times.entry(conditions.time_of_day).or_default().absorb(filmed);
        self.conditions.entry(conditions).or_default().absorb(filmed);
    }
}
