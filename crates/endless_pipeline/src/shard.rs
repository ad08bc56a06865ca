//! One part of several of a plan.

use std::{fmt, str::FromStr};

/// Part `number` of `of`, both from 1: written `3/8`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Shard {
    number: u32,
    of: u32,
}

impl Shard {
    /// Most parts that there can be.
    pub const MAX: u32 = 100_000;

    /// Part `number` of `of`; none if there is no such part.
    pub fn new(number: u32, of: u32) -> Option<Self> {
        ((1..=of).contains(&number) && of <= Self::MAX).then_some(Self { number, of })
    }

    /// Its number, from 1.
    pub const fn number(self) -> u32 {
        self.number
    }

    /// How many there are.
    pub const fn of(self) -> u32 {
        self.of
    }

    /// As it stands in names of files: `3-of-8`.
    pub(crate) fn file_name(self) -> String {
        format!("{}-of-{}", self.number, self.of)
    }

    /// The part that a name of a file tells.
    pub(crate) fn from_file_name(name: &str) -> Option<Self> {
        let (number, of) = name.split_once("-of-")?;
        Self::new(number.parse().ok()?, of.parse().ok()?)
    }

    /// All parts of so many.
    pub fn all(of: u32) -> impl Iterator<Item = Self> {
        (1..=of.min(Self::MAX)).map(move |number| Self { number, of })
    }
}

impl fmt::Display for Shard {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let numbers = text.split_once('/').map(|(number, of)| (number.parse(), of.parse()));
        let shard = match numbers {
            Some((Ok(number), Ok(of))) => Self::new(number, of),
            _ => None,
        };
        shard.ok_or_else(|| format!("give I/N, such as 3/8, with I from 1 to N and N up to {}", Self::MAX))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn what_is_written_is_read(number in 1u32..200, more in 0u32..200) {
            let shard = Shard::new(number, number + more).expect("there is one");
            prop_assert_eq!(shard.to_string().parse(), Ok(shard));
            prop_assert_eq!(Shard::from_file_name(&shard.file_name()), Some(shard));
            prop_assert_eq!((shard.number(), shard.of()), (number, number + more));
        }

        #[test]
        fn no_text_panics(text in "\\PC*") {
            let _ = (text.parse::<Shard>(), Shard::from_file_name(&text));
        }
    }

    #[test]
    fn what_is_no_shard_is_refused() {
        for text in ["", "3", "0/8", "9/8", "1/0", "-1/8", "1/8/8", "1/100001", "a/b", "1 / 8"] {
            assert!(text.parse::<Shard>().is_err(), "{text}");
        }
        assert_eq!(Shard::all(3).map(|shard| shard.to_string()).collect::<Vec<_>>(), ["1/3", "2/3", "3/3"]);
    }
}
