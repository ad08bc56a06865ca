//! Identities for re-identification: looks that come back in other videos.
//!
//! People and vehicles of traffic are taken from pools that are the same for all datasets, so that the same person or car
//! is met again in other videos, by other cameras, in other towns. Within a video nobody is met twice as long as the pool
//! suffices.

use crate::{Stream, VehicleSpec};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de::Error};
use std::fmt;

/// A look: equal for objects that look the same, whatever video they are in. Sixteen hexadecimal digits in files, because
/// JSON's numbers have 53 bits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Reid(u64);

impl Reid {
    /// The identity of what these keys make look as it does.
    pub fn new(kind: &str, keys: &[u64]) -> Self {
        Self(Stream::named(0, kind, keys).next_u64())
    }

    /// Its number, as a key of what follows from it.
    pub const fn key(self) -> u64 {
        self.0
    }
}

impl fmt::Display for Reid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0)
    }
}

impl Serialize for Reid {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for Reid {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let digits = text.len() == 16 && text.bytes().all(|b| matches!(b, b'0'..=b'9' | b'a'..=b'f'));
        let number = u64::from_str_radix(&text, 16).ok().filter(|_| digits);
        number.map(Self).ok_or_else(|| D::Error::custom("an identity has 16 hexadecimal digits"))
    }
}

/// Seeds of looks, by number: a person of traffic, or the paint (and rider) of a vehicle model, is one of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LookPool {
    key: u64,
    size: usize,
}

/// Persons that there are.
const PEOPLE: usize = 2000;
/// Vehicles of all models together that there are, about, for each part of frequency (all models have about 100), and of
/// a model at least.
const VEHICLES_PER_FREQUENCY: f64 = 20.0;
const LEAST_OF_A_MODEL: usize = 16;

impl LookPool {
    /// All people on foot.
    pub const fn people() -> Self {
        Self { key: 0, size: PEOPLE }
    }

    /// The vehicles of a model: the more, the more frequent it is.
    pub fn vehicles(spec: &VehicleSpec) -> Self {
        let size = ((VEHICLES_PER_FREQUENCY * spec.frequency).ceil() as usize).max(LEAST_OF_A_MODEL);
        Self { key: spec.key(), size }
    }

    /// How many there are.
    pub const fn size(self) -> usize {
        self.size
    }

    /// Seed of look number `index`.
    pub fn seed(self, index: usize) -> u64 {
        Stream::named(self.key, "look", &[index as u64]).next_u64()
    }

    /// The look that a draw takes: any one that is not taken yet; any one at all if all are.
    pub fn draw(self, draw: u64, taken: impl Fn(u64) -> bool) -> u64 {
        let first = Stream::new(draw, &[]).below(self.size);
        let mut seeds = (0..self.size).map(|step| self.seed((first + step) % self.size));
        seeds.find(|seed| !taken(*seed)).unwrap_or_else(|| self.seed(first))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn nobody_is_drawn_twice_before_everybody_is() {
        let pool = LookPool::people();
        let mut taken = BTreeSet::new();
        for draw in 0..pool.size() as u64 {
            let seed = pool.draw(draw, |seed| taken.contains(&seed));
            assert!(taken.insert(seed), "draw {draw}");
        }
        assert!(taken.contains(&pool.draw(9, |seed| taken.contains(&seed))), "then somebody comes again");
    }

    #[test]
    fn every_look_of_a_pool_is_drawn_and_models_share_none() {
        let car = VehicleSpec::default();
        let other = VehicleSpec { draw: 1, ..VehicleSpec::default() };
        let [a, b] = [LookPool::vehicles(&car), LookPool::vehicles(&other)];
        assert_eq!(a.size(), 20);
        let drawn = |pool: LookPool| (0..2000).map(|draw| pool.draw(draw, |_| false)).collect::<BTreeSet<u64>>();
        assert_eq!(drawn(a).len(), a.size());
        assert!(drawn(a).is_disjoint(&drawn(b)));
        let rare = VehicleSpec { frequency: 0.01, ..car };
        assert_eq!(LookPool::vehicles(&rare).size(), LEAST_OF_A_MODEL);
    }

    #[test]
    fn identities_are_sixteen_digits() {
        for (kind, keys) in [("person", vec![7]), ("vehicle", vec![3, 4])] {
            let text = Reid::new(kind, &keys).to_string();
            assert!(text.len() == 16 && text.bytes().all(|b| b.is_ascii_hexdigit()), "{text}");
        }
        assert_ne!(Reid::new("person", &[7]), Reid::new("person", &[8]));
        assert_ne!(Reid::new("person", &[7]), Reid::new("vehicle", &[7]));
    }
}
