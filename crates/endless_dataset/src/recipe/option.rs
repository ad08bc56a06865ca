//! What an option of a recipe is: all that flags, files, help, schema and checks need to know of it.

use super::{rig::SensorSpec, user_camera::UserCamera};
use endless_world::{ImageSize, UnknownName};
use std::{path::PathBuf, str::FromStr};
use strum::VariantArray;

/// A value that an option cannot have.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum OptionError {
    /// A word that is not in the list.
    #[error(transparent)]
    Unknown(#[from] UnknownName),
    /// A number outside its range.
    #[error("{} cannot be {given}: {rule}", field.replace('_', "-"))]
    OutOfRange {
        /// The option's key.
        field: &'static str,
        /// What was given.
        given: String,
        /// What can be given.
        rule: String,
    },
    /// A list without entries.
    #[error("{field} is empty: name at least one of {}", known.join(", "))]
    EmptyList {
        /// The option's key.
        field: &'static str,
        /// What can be named.
        known: Vec<String>,
    },
}

/// One option of a recipe, declared in `options.rs` and nowhere else.
#[derive(Debug, Clone, Copy)]
pub struct RecipeOption {
    /// Its key in a TOML file.
    pub key: &'static str,
    /// What it means, in one or two sentences.
    pub help: &'static str,
    /// What can be given.
    pub kind: OptionKind,
    /// What holds where nothing is given.
    pub default: OptionDefault,
}

/// What an option can be given.
#[derive(Debug, Clone, Copy)]
pub enum OptionKind {
    /// A whole number within these bounds.
    Whole {
        /// The lowest.
        least: u64,
        /// The highest.
        most: u64,
    },
    /// A number within these bounds.
    Number {
        /// The lowest.
        least: f64,
        /// The highest.
        most: f64,
    },
    /// `WIDTHxHEIGHT`.
    Size {
        /// The longest side, pixels.
        longest: u32,
    },
    /// One of these words.
    Word(Vocabulary),
    /// A list of these words, at least one.
    Words(Vocabulary),
    /// A list of these words, which may be empty or `none`.
    WordsOrNone(Vocabulary),
    /// A list of maps, at least one.
    Maps,
    /// Cameras of the user's own: a file on the command line, a list in a recipe.
    Cameras,
    /// Sensors of a rig: a file on the command line (`--rig`), `[[sensor]]` tables in a recipe.
    Rig,
    /// Lines on the ground.
    Lines,
    /// A folder.
    Folder,
    /// A file.
    File,
    /// A place on the plane, metres.
    Place,
    /// Any word: who uses it knows which there are.
    Text,
    /// Given or not.
    Switch,
}

/// What holds where an option is not given.
#[derive(Debug, Clone, Copy)]
pub enum OptionDefault {
    /// This value, as one writes it on the command line.
    Value(&'static str),
    /// Something that depends, in words.
    Described(&'static str),
}

impl OptionDefault {
    /// As help and documents say it.
    pub const fn text(self) -> &'static str {
        match self {
            Self::Value(text) | Self::Described(text) => text,
        }
    }
}

/// The words that an option knows, in their canonical order.
#[derive(Debug, Clone, Copy)]
pub struct Vocabulary {
    /// All of them.
    pub words: fn() -> Vec<&'static str>,
    /// The word that is meant, or the words there are.
    pub parse: fn(&str) -> Result<&'static str, UnknownName>,
}

impl Vocabulary {
    /// The words of an enumeration.
    pub(super) const fn of<T>() -> Self
    where
        T: VariantArray + Copy + Into<&'static str> + FromStr<Err = UnknownName>,
    {
        Self {
            words: || T::VARIANTS.iter().map(|&word| word.into()).collect(),
            parse: |word| word.parse::<T>().map(Into::into),
        }
    }
}

impl RecipeOption {
    /// Its name on the command line, without the dashes.
    pub fn flag(&self) -> String {
        match self.kind {
            OptionKind::Rig => "rig".to_owned(),
            _ => self.key.replace('_', "-"),
        }
    }

    /// What it means, with the words that it knows.
    pub fn help_with_words(&self) -> String {
        let words = match self.kind {
            OptionKind::Word(v) | OptionKind::Words(v) | OptionKind::WordsOrNone(v) => (v.words)(),
            _ => Vec::new(),
        };
        if words.iter().all(|word| self.help.contains(word)) {
            return self.help.to_owned();
        }
        format!("{}: {}.", self.help.trim_end_matches('.'), words.join(", "))
    }

    fn out_of_range(&self, given: &impl ToString, rule: String) -> OptionError {
        OptionError::OutOfRange { field: self.key, given: given.to_string(), rule }
    }

    fn check_whole(&self, given: i128) -> Result<(), OptionError> {
        match self.kind {
            OptionKind::Whole { least, most } if !(i128::from(least)..=i128::from(most)).contains(&given) => {
                Err(self.out_of_range(&given, format!("write a whole number from {least} to {most}")))
            }
            _ => Ok(()),
        }
    }
}

/// Largest coordinate of a place, metres.
const FARTHEST_M: f64 = 1e7;

/// A value of an option.
pub(super) trait OptionValue: Sized {
    /// From what follows the flag.
    fn from_flag(text: &str) -> Result<Self, String>;

    /// Whether the option can be this, and its canonical form.
    fn check(&mut self, option: &RecipeOption) -> Result<(), OptionError>;
}

impl OptionValue for i64 {
    fn from_flag(text: &str) -> Result<Self, String> {
        text.parse().map_err(|e: std::num::ParseIntError| e.to_string())
    }

    fn check(&mut self, option: &RecipeOption) -> Result<(), OptionError> {
        option.check_whole((*self).into())
    }
}

impl OptionValue for u64 {
    fn from_flag(text: &str) -> Result<Self, String> {
        text.parse().map_err(|e: std::num::ParseIntError| e.to_string())
    }

    fn check(&mut self, option: &RecipeOption) -> Result<(), OptionError> {
        option.check_whole((*self).into())
    }
}

impl OptionValue for f64 {
    fn from_flag(text: &str) -> Result<Self, String> {
        text.parse().map_err(|e: std::num::ParseFloatError| e.to_string())
    }

    fn check(&mut self, option: &RecipeOption) -> Result<(), OptionError> {
        match option.kind {
            // NaN is in no range.
            OptionKind::Number { least, most } if !(least..=most).contains(self) => {
                Err(option.out_of_range(self, format!("write a number from {least} to {most}")))
            }
            _ => Ok(()),
        }
    }
}

impl OptionValue for String {
    fn from_flag(text: &str) -> Result<Self, String> {
        Ok(text.to_owned())
    }

    fn check(&mut self, option: &RecipeOption) -> Result<(), OptionError> {
        match option.kind {
            OptionKind::Size { longest } => {
                let side = 1..=longest;
                let size = ImageSize::from_str(self).ok();
                if size.is_none_or(|size| !side.contains(&size.width) || !side.contains(&size.height)) {
                    let rule = format!("write WIDTHxHEIGHT, each from 1 to {longest}, for example 1280x720");
                    return Err(option.out_of_range(self, rule));
                }
            }
            OptionKind::Word(vocabulary) => *self = (vocabulary.parse)(self)?.to_owned(),
            _ => {}
        }
        Ok(())
    }
}

impl OptionValue for Vec<String> {
    fn from_flag(text: &str) -> Result<Self, String> {
        Ok(text.split(',').map(str::to_owned).collect())
    }

    /// Words in the vocabulary's order, without repetition.
    fn check(&mut self, option: &RecipeOption) -> Result<(), OptionError> {
        let vocabulary = match option.kind {
            OptionKind::WordsOrNone(_) if self.is_empty() || *self == ["none"] => {
                self.clear();
                return Ok(());
            }
            OptionKind::Words(vocabulary) | OptionKind::WordsOrNone(vocabulary) => vocabulary,
            _ => return Ok(()),
        };
        let words = (vocabulary.words)();
        if self.is_empty() {
            let known = words.iter().map(ToString::to_string).collect();
            return Err(OptionError::EmptyList { field: option.key, known });
        }
        let given = self.iter().map(|word| (vocabulary.parse)(word.trim())).collect::<Result<Vec<_>, _>>()?;
        *self = words.into_iter().filter(|word| given.contains(word)).map(str::to_owned).collect();
        Ok(())
    }
}

impl OptionValue for PathBuf {
    fn from_flag(text: &str) -> Result<Self, String> {
        Ok(text.into())
    }

    fn check(&mut self, _option: &RecipeOption) -> Result<(), OptionError> {
        Ok(())
    }
}

impl OptionValue for [f64; 2] {
    fn from_flag(text: &str) -> Result<Self, String> {
        let numbers: Option<Vec<f64>> = text.split(',').map(|number| number.trim().parse().ok()).collect();
        let place = numbers.and_then(|numbers| numbers.try_into().ok());
        place.ok_or_else(|| "write X,Y in metres, for example 340.00,261.83".to_owned())
    }

    fn check(&mut self, option: &RecipeOption) -> Result<(), OptionError> {
        if self.iter().all(|number| number.abs() <= FARTHEST_M) {
            return Ok(());
        }
        let given = self.map(|number| number.to_string()).join(",");
        Err(option.out_of_range(&given, format!("write two numbers of at most {FARTHEST_M:e} metres")))
    }
}

impl OptionValue for bool {
    fn from_flag(text: &str) -> Result<Self, String> {
        text.parse().map_err(|e: std::str::ParseBoolError| e.to_string())
    }

    fn check(&mut self, _option: &RecipeOption) -> Result<(), OptionError> {
        Ok(())
    }
}

impl OptionValue for Vec<UserCamera> {
    fn from_flag(_text: &str) -> Result<Self, String> {
        Err("a list of cameras is a file".into())
    }

    /// Cameras are checked against their maps, by their own code.
    fn check(&mut self, _option: &RecipeOption) -> Result<(), OptionError> {
        Ok(())
    }
}

impl OptionValue for Vec<SensorSpec> {
    fn from_flag(_text: &str) -> Result<Self, String> {
        Err("a rig is a file".into())
    }

    /// Sensors are checked with all of the recipe, by their own code.
    fn check(&mut self, _option: &RecipeOption) -> Result<(), OptionError> {
        Ok(())
    }
}
