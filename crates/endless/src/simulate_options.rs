//! Values of the flags of `endless simulate`.

use std::{
    path::{Path, PathBuf},
    str::FromStr,
};

/// A file to write, with its format.
#[derive(Debug, Clone)]
pub(crate) struct OutputFile<F> {
    pub(crate) path: PathBuf,
    pub(crate) format: F,
}

/// What a view from above is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum TopViewFormat {
    Picture,
    Video,
}

impl TopViewFormat {
    /// By the file's ending.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        match path.extension()?.to_ascii_lowercase().to_str()? {
            "png" => Some(Self::Picture),
            "mp4" => Some(Self::Video),
            _ => None,
        }
    }
}

/// How many vehicles.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum VehicleCount {
    /// So many, or as many as find room.
    Number(u32),
    /// As many as the map takes and still flow.
    Max,
}

impl FromStr for VehicleCount {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if text == "max" {
            return Ok(Self::Max);
        }
        text.parse().map(Self::Number).or(Err("give a whole number, or max"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_endings_are_understood() {
        assert_eq!("12".parse(), Ok(VehicleCount::Number(12)));
        assert_eq!("max".parse(), Ok(VehicleCount::Max));
        assert!("-1".parse::<VehicleCount>().is_err() && "many".parse::<VehicleCount>().is_err());
        assert_eq!(TopViewFormat::of(Path::new("a.MP4")), Some(TopViewFormat::Video));
        assert_eq!(TopViewFormat::of(Path::new("a/b.png")), Some(TopViewFormat::Picture));
        assert_eq!(TopViewFormat::of(Path::new("png")), None);
    }
}
