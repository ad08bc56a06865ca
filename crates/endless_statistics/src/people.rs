//! Who is seen, and how often: skin tones, ages, sexes; colours of vehicles.

use crate::Histogram;
use crate::merge::merge_fields;
use crate::scales::AGE_YEARS;
use endless_world::TimeOfDay;
use serde::Serialize;
use std::collections::BTreeMap;

/// How much there is of something.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
pub struct Represented {
    /// Objects of videos that are seen: whoever is seen in two videos counts twice.
    pub objects: u64,
    /// Boxes.
    pub boxes: u64,
}

merge_fields!(Represented { objects, boxes });

/// Numbers by a word.
pub type ByWord = BTreeMap<String, Represented>;

/// People and riders that are seen.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PeopleStatistics {
    /// All of whom something is known.
    pub all: Represented,
    /// By skin tone on the Monk scale, all ten of them.
    pub skin_tone: BTreeMap<u8, Represented>,
    /// Boxes by time of day and skin tone.
    pub boxes_by_time_and_skin_tone: BTreeMap<TimeOfDay, BTreeMap<u8, u64>>,
    /// By age group.
    pub age_group: ByWord,
    /// By sex.
    pub sex: ByWord,
    /// Ages of the people, one value a person of a video.
    pub age_years: Histogram,
}

merge_fields!(PeopleStatistics { all, skin_tone, boxes_by_time_and_skin_tone, age_group, sex, age_years });

/// Age groups and sexes as `actors.json` has them: those of whom nobody is seen are told, too.
const AGE_GROUPS: [&str; 4] = ["child", "teenager", "adult", "senior"];
const SEXES: [&str; 2] = ["female", "male"];

impl Default for PeopleStatistics {
    fn default() -> Self {
        let words = |words: &[&str]| words.iter().map(|word| ((*word).into(), Represented::default())).collect();
        Self {
            all: Represented::default(),
            skin_tone: (1..=10).map(|tone| (tone, Represented::default())).collect(),
            boxes_by_time_and_skin_tone: BTreeMap::new(),
            age_group: words(&AGE_GROUPS),
            sex: words(&SEXES),
            age_years: Histogram::new(&AGE_YEARS),
        }
    }
}

impl PeopleStatistics {
    /// Age groups from young to old, then what other words there are.
    pub(crate) fn age_groups(&self) -> impl Iterator<Item = (&str, Represented)> {
        let place = |word: &str| AGE_GROUPS.iter().position(|known| *known == word).unwrap_or(AGE_GROUPS.len());
        let mut groups: Vec<_> = self.age_group.iter().map(|(word, number)| (word.as_str(), *number)).collect();
        groups.sort_by_key(|(word, _)| place(word));
        groups.into_iter()
    }
}

/// Vehicles that are seen.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize)]
pub struct VehicleStatistics {
    /// By name of the paint.
    pub color: ByWord,
    /// By design.
    pub model: ByWord,
    /// By use or body.
    pub subclass: ByWord,
}

merge_fields!(VehicleStatistics { color, model, subclass });

/// Adds to what a word has.
pub(crate) fn add(to: &mut ByWord, word: &str, number: Represented) {
    use crate::merge::Merge as _;
    match to.get_mut(word) {
        Some(own) => own.absorb(number),
        None => {
            to.insert(word.to_owned(), number);
        }
    }
}
