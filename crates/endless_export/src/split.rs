//! Parts for training, validation and test: which video belongs to which, so that no scene is in two of them.

use crate::{ExportError, Sequence};
use endless_world::{Stream, UnknownName};
use serde::{Deserialize, Serialize};
use std::{collections::BTreeMap, str::FromStr};
use strum::VariantArray as _;

/// What stays together when videos are divided.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[derive(strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum SplitBy {
    /// Each video by itself.
    Video,
    /// All videos of a camera; and, as a scene is never divided, those of cameras that film a scene together.
    Camera,
    /// All videos of a map.
    Map,
    /// All videos of a weather at a time of day.
    Condition,
}

impl SplitBy {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// The word used on the command line.
    pub fn name(self) -> &'static str {
        self.into()
    }

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("way to split", given, Self::ALL)
    }
}

/// Names of the parts and the share that each has, as in `train=0.8,val=0.1,test=0.1`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SplitShares(Vec<(String, f64)>);

/// Shares may differ from one in all by so much.
const TOLERANCE: f64 = 1e-6;

impl Default for SplitShares {
    fn default() -> Self {
        Self(vec![("train".into(), 0.8), ("val".into(), 0.2)])
    }
}

impl FromStr for SplitShares {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let mut shares: Vec<(String, f64)> = Vec::new();
        for entry in text.split(',') {
            let (name, share) = entry.split_once('=').ok_or_else(|| format!("write {entry:?} as name=share"))?;
            let name = name.trim();
            if name.is_empty() || !name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_') {
                return Err(format!("the name of a part has letters, digits and underscores only, not {name:?}"));
            }
            let share: f64 = share.trim().parse().map_err(|_not_a_number| format!("{share:?} is no share"))?;
            if !(share > 0.0 && share <= 1.0) {
                return Err(format!("the share of {name} is above 0 and at most 1, not {share}"));
            }
            if shares.iter().any(|(other, _)| other == name) {
                return Err(format!("{name} is there twice"));
            }
            shares.push((name.into(), share));
        }
        let sum: f64 = shares.iter().map(|(_, share)| share).sum();
        if (sum - 1.0).abs() > TOLERANCE {
            return Err(format!("the shares add up to {sum:.4}, not to 1"));
        }
        Ok(Self(shares))
    }
}

impl SplitShares {
    /// All in `train`.
    pub(crate) fn whole() -> Self {
        Self(vec![("train".into(), 1.0)])
    }

    /// The names of the parts, in order.
    pub fn names(&self) -> Vec<String> {
        self.0.iter().map(|(name, _)| name.clone()).collect()
    }

    /// The part of each sequence, by place in [`Self::names`]. The same seed and videos give the same parts; each part has
    /// at least one group.
    ///
    /// # Errors
    /// When there are fewer groups than parts.
    pub(crate) fn divide(&self, sequences: &[Sequence], by: SplitBy, seed: u64) -> Result<Vec<usize>, ExportError> {
        let groups = groups(sequences, by);
        let mut names: Vec<&String> = groups.iter().collect();
        names.sort();
        names.dedup();
        if names.len() < self.0.len() {
            let together =
                if by == SplitBy::Camera { ", as cameras that film a scene together stay together" } else { "" };
            return Err(ExportError::Split(format!(
                "{} parts need as many groups of videos, and by {} there is no more than {}{together}: ask for fewer with --split, \
                 or for another --by ({})",
                self.0.len(),
                by.name(),
                names.len(),
                SplitBy::ALL.iter().map(|by| by.name()).collect::<Vec<_>>().join(", ")
            )));
        }
        let rank = |name: &str| Stream::named(seed, &format!("export.split.{name}"), &[]).next_u64();
        names.sort_by_key(|name| (rank(name), (*name).clone()));
        let counts = self.counts(names.len());
        let places = counts.iter().enumerate().flat_map(|(place, &count)| std::iter::repeat_n(place, count));
        let part: BTreeMap<&String, usize> = names.into_iter().zip(places).collect();
        Ok(groups.iter().map(|group| part[group]).collect())
    }

    /// So many groups for each part: by largest remainders, and at least one.
    fn counts(&self, groups: usize) -> Vec<usize> {
        let wanted: Vec<f64> = self.0.iter().map(|(_, share)| share * groups as f64).collect();
        let mut counts: Vec<usize> = wanted.iter().map(|w| (*w as usize).max(1)).collect();
        while counts.iter().sum::<usize>() != groups {
            let missing = counts.iter().sum::<usize>() < groups;
            let lack = |place: usize| wanted[place] - counts[place] as f64;
            let may = |&place: &usize| missing || counts[place] > 1;
            let by_lack = |a: &usize, b: &usize| lack(*a).total_cmp(&lack(*b)).then(b.cmp(a));
            let places = (0..counts.len()).filter(may);
            let Some(place) = (if missing { places.max_by(by_lack) } else { places.min_by(by_lack) }) else { break };
            if missing { counts[place] += 1 } else { counts[place] -= 1 }
        }
        counts
    }
}

/// The group of each sequence; all sequences of a video are of one.
fn groups(sequences: &[Sequence], by: SplitBy) -> Vec<String> {
    let own = |sequence: &Sequence| match by {
        SplitBy::Video => sequence.video.name.clone(),
        SplitBy::Camera => format!("{}/{}", sequence.video.map, sequence.site),
        SplitBy::Map => sequence.video.map.clone(),
        SplitBy::Condition => format!("{}/{}", sequence.video.weather, sequence.video.time_of_day),
    };
    let mut names: Vec<String> = sequences.iter().map(own).collect();
    // Whatever shares a video gets one name, until nothing changes: the smallest of them.
    let mut changed = true;
    while std::mem::take(&mut changed) {
        let mut least: BTreeMap<u32, String> = BTreeMap::new();
        for (sequence, name) in sequences.iter().zip(&names) {
            let entry = least.entry(sequence.video.video).or_insert_with(|| name.clone());
            if name < entry {
                *entry = name.clone();
            }
        }
        let renamed: BTreeMap<String, String> = sequences
            .iter()
            .zip(&names)
            .filter(|(sequence, name)| **name != least[&sequence.video.video])
            .map(|(sequence, name)| (name.clone(), least[&sequence.video.video].clone()))
            .collect();
        for name in &mut names {
            if let Some(other) = renamed.get(name) {
                *name = other.clone();
                changed = true;
            }
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sequence::tests::sequence;
    use proptest::prelude::*;

    fn parts(by: SplitBy, sequences: &[Sequence], shares: &str) -> Result<Vec<usize>, ExportError> {
        shares.parse::<SplitShares>().expect("shares").divide(sequences, by, 7)
    }

    #[test]
    fn shares_that_are_none_are_refused() {
        let wrong = |text: &str| text.parse::<SplitShares>().expect_err("no shares");
        assert_eq!(wrong("train=0.8,val=0.1"), "the shares add up to 0.9000, not to 1");
        assert!(wrong("train").contains("name=share"));
        assert!(wrong("a=0.5,a=0.5").contains("twice"));
        assert!(wrong("../x=1").contains("letters"));
        assert!(wrong("a=-1,b=2").contains("above 0"));
        assert!(wrong("a=NaN").contains("above 0"));
    }

    #[test]
    fn cameras_of_one_scene_stay_together() {
        // Video 0 is filmed by a and b, 1 by b and c, 2 by d and e: a, b and c hang together.
        let shot = |video, camera, site| sequence(video, "Town01", camera, site);
        let all =
            [shot(0, 0, "a"), shot(0, 1, "b"), shot(1, 0, "b"), shot(1, 1, "c"), shot(2, 0, "d"), shot(2, 1, "e")];
        let place = parts(SplitBy::Camera, &all, "train=0.5,val=0.5").expect("two groups");
        assert!(place[..4].iter().all(|&p| p == place[0]) && place[4] == place[5] && place[4] != place[0]);
        let error = parts(SplitBy::Camera, &all, "a=0.4,b=0.3,c=0.3").expect_err("two groups").to_string();
        assert!(error.contains("by camera there is no more than 2"), "{error}");
    }

    proptest! {
        #[test]
        fn every_part_has_its_share_and_scenes_are_whole(videos in 3u32..60, seed: u64) {
            let all: Vec<Sequence> =
                (0..videos).flat_map(|v| [0, 1].map(|c| sequence(v, "Town01", c, &format!("s{v}{c}")))).collect();
            let shares: SplitShares = "train=0.8,val=0.1,test=0.1".parse().expect("shares");
            let place = shares.divide(&all, SplitBy::Video, seed).expect("enough videos");
            prop_assert!(place.chunks(2).all(|pair| pair[0] == pair[1]));
            for (part, share) in [0.8, 0.1, 0.1].into_iter().enumerate() {
                let count = place.iter().filter(|&&p| p == part).count() / 2;
                prop_assert!(count >= 1 && (count as f64 - share * f64::from(videos)).abs() < 2.0);
            }
        }
    }
}
