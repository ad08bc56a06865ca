//! Looks that come back: how many different people and vehicles there are to learn from.

use crate::merge::{Merge, merge_fields};
use endless_world::Reid;
use serde::{Serialize, Serializer, ser::SerializeStruct as _};
use std::collections::BTreeMap;

/// Where a look is met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
struct LookUse {
    objects: u64,
    videos: u64,
    twins: u64,
}

merge_fields!(LookUse { objects, videos, twins });

/// How often each look is seen.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct LookStatistics(BTreeMap<Reid, LookUse>);

impl LookStatistics {
    /// Counts the looks of the objects that are seen in one video.
    pub(crate) fn add_video(&mut self, looks: impl IntoIterator<Item = Reid>) {
        let mut objects: BTreeMap<Reid, u64> = BTreeMap::new();
        for look in looks {
            *objects.entry(look).or_default() += 1;
        }
        for (look, objects) in objects {
            let twins = if objects > 1 { objects } else { 0 };
            self.0.entry(look).or_default().absorb(LookUse { objects, videos: 1, twins });
        }
    }

    /// Objects that are seen; one that is seen in two videos counts twice.
    pub fn objects(&self) -> u64 {
        self.0.values().map(|used| used.objects).sum()
    }

    /// Different looks.
    pub fn distinct(&self) -> u64 {
        self.0.len() as u64
    }

    /// Objects that look like another one that is seen in the same video.
    pub fn twins_within_videos(&self) -> u64 {
        self.0.values().map(|used| used.twins).sum()
    }

    /// Looks that are seen in more than one video.
    pub fn in_several_videos(&self) -> u64 {
        self.0.values().filter(|used| used.videos > 1).count() as u64
    }

    /// Numbers of looks by the number of videos in which they are seen.
    pub fn looks_by_videos(&self) -> BTreeMap<u64, u64> {
        let mut numbers = BTreeMap::new();
        for used in self.0.values() {
            *numbers.entry(used.videos).or_default() += 1;
        }
        numbers
    }
}

impl Merge for LookStatistics {
    fn absorb(&mut self, other: Self) {
        self.0.absorb(other.0);
    }
}

impl Serialize for LookStatistics {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("LookStatistics", 5)?;
        fields.serialize_field("objects", &self.objects())?;
        fields.serialize_field("distinct", &self.distinct())?;
        fields.serialize_field("twins_within_videos", &self.twins_within_videos())?;
        fields.serialize_field("in_several_videos", &self.in_several_videos())?;
        fields.serialize_field("looks_by_videos", &self.looks_by_videos())?;
        fields.end()
    }
}

/// Looks by who has them.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct Looks {
    /// People on foot: who they are and what they wear.
    pub people: LookStatistics,
    /// Riders of two-wheelers.
    pub riders: LookStatistics,
    /// Vehicles of traffic.
    pub vehicles: LookStatistics,
    /// Vehicles that stand parked for the whole video: they belong to the map and come back with it.
    pub parked_vehicles: LookStatistics,
    /// People and riders, whatever they wear.
    pub persons: LookStatistics,
}

merge_fields!(Looks { people, riders, vehicles, parked_vehicles, persons });

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn twins_and_those_who_come_back_are_told_apart() {
        let [a, b, c] = [1, 2, 3].map(|key| Reid::new("test", &[key]));
        let mut looks = LookStatistics::default();
        looks.add_video([a, b, b]);
        let mut others = LookStatistics::default();
        others.add_video([a, c]);
        others.add_video([a]);
        looks.absorb(others);
        assert_eq!((looks.objects(), looks.distinct()), (6, 3));
        assert_eq!((looks.twins_within_videos(), looks.in_several_videos()), (2, 1));
        assert_eq!(looks.looks_by_videos(), BTreeMap::from([(1, 2), (3, 1)]));
    }
}
