//! Whole numbers, counted one by one, so that median and extremes are exact.

use crate::merge::Merge;
use serde::{Serialize, Serializer, ser::SerializeStruct as _};
use std::collections::BTreeMap;

/// How often each number occurs.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Tally(BTreeMap<u64, u64>);

impl Tally {
    /// Counts a number.
    pub fn add(&mut self, number: u64) {
        *self.0.entry(number).or_default() += 1;
    }

    /// How many numbers there are.
    pub fn total(&self) -> u64 {
        self.0.values().sum()
    }

    /// How often a number occurs.
    pub fn of(&self, number: u64) -> u64 {
        self.0.get(&number).copied().unwrap_or_default()
    }

    /// The numbers that occur, ascending, each with how often it does.
    pub fn iter(&self) -> impl Iterator<Item = (u64, u64)> {
        self.0.iter().map(|(number, count)| (*number, *count))
    }

    /// The smallest.
    pub fn min(&self) -> Option<u64> {
        self.0.keys().next().copied()
    }

    /// The largest.
    pub fn max(&self) -> Option<u64> {
        self.0.keys().next_back().copied()
    }

    /// The mean.
    pub fn mean(&self) -> Option<f64> {
        let sum: u128 = self.0.iter().map(|(number, count)| u128::from(*number) * u128::from(*count)).sum();
        (self.total() > 0).then(|| sum as f64 / self.total() as f64)
    }

    /// The number in the middle; of an even number of them the mean of the two in the middle.
    pub fn median(&self) -> Option<f64> {
        let total = self.total();
        let low = self.nth(total.checked_sub(1)? / 2)?;
        Some((low as f64 + self.nth(total / 2)? as f64) / 2.0)
    }

    /// The number in this place, from 0, when they are sorted.
    fn nth(&self, place: u64) -> Option<u64> {
        let mut before = 0;
        self.0.iter().find_map(|(number, count)| {
            before += count;
            (place < before).then_some(*number)
        })
    }
}

impl Merge for Tally {
    fn absorb(&mut self, other: Self) {
        self.0.absorb(other.0);
    }
}

impl Serialize for Tally {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut fields = serializer.serialize_struct("Tally", 5)?;
        fields.serialize_field("values", &self.total())?;
        fields.serialize_field("min", &self.min())?;
        fields.serialize_field("median", &self.median())?;
        fields.serialize_field("mean", &self.mean())?;
        fields.serialize_field("max", &self.max())?;
        fields.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_summary_is_that_of_the_sorted_list() {
        let of = |numbers: &[u64]| {
            let mut tally = Tally::default();
            numbers.iter().for_each(|number| tally.add(*number));
            tally
        };
        let odd = of(&[5, 1, 1, 9, 4]);
        assert_eq!((odd.min(), odd.median(), odd.mean(), odd.max()), (Some(1), Some(4.0), Some(4.0), Some(9)));
        assert_eq!(of(&[1, 2, 7, 3]).median(), Some(2.5));
        assert_eq!(of(&[6]).median(), Some(6.0));
        assert_eq!((of(&[]).median(), of(&[]).min(), of(&[]).mean()), (None, None, None));
        let mut both = of(&[1, 2]);
        both.absorb(of(&[2, 7]));
        assert_eq!(both, of(&[1, 2, 2, 7]));
        let text = serde_json::to_string(&both).expect("plain");
        assert_eq!(text, r#"{"values":4,"min":1,"median":2.0,"mean":3.0,"max":7}"#);
    }
}
