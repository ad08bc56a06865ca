//! Files of recorded motion: SUMO's FCD (floating car data) as XML, and CSV. `docs/clone.md` describes both.

mod csv;
mod error;
mod fcd;
mod gather;
mod kind;
mod row;

pub use error::{TrackFault, TrackFileError};

use crate::content_hash::content_hash;
use endless_world::Track;
use gather::Gatherer;
use std::{fs::File, io::Read, path::Path};

/// Longest file, bytes: it is kept in memory while it is read.
const MOST_BYTES: u64 = 2 << 30;

/// The tracks of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct TrackFile {
    /// BLAKE3 of its bytes.
    pub content_hash: String,
    /// In the order in which they begin in the file.
    pub tracks: Vec<Track>,
    /// What had to be guessed or left out: one line for each kind of thing.
    pub notes: Vec<String>,
    /// The first instant that the file tells of, seconds.
    pub begin_s: f64,
    /// The last one.
    pub end_s: f64,
}

impl TrackFile {
    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read, is longer than 2 GiB, or has no tracks.
    pub fn read(path: &Path) -> Result<Self, TrackFileError> {
        let unreadable = |cause| TrackFileError::Unreadable { path: path.to_owned(), cause };
        let mut bytes = Vec::new();
        File::open(path).and_then(|file| file.take(MOST_BYTES + 1).read_to_end(&mut bytes)).map_err(unreadable)?;
        if bytes.len() as u64 > MOST_BYTES {
            return Err(TrackFileError::TooLong { path: path.to_owned() });
        }
        Self::from_bytes(&bytes).map_err(|fault| TrackFileError::Faulty { path: path.to_owned(), fault })
    }

    /// Reads a file's bytes: XML if they begin with `<`, else CSV.
    ///
    /// # Errors
    /// What is wrong, and in which line.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, TrackFault> {
        let text = std::str::from_utf8(bytes).map_err(|error| {
            let line = 1 + bytes[..error.valid_up_to()].iter().filter(|&&byte| byte == b'\n').count();
            TrackFault::Line { line, what: "this is no text in UTF-8".to_owned() }
        })?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        let mut gatherer = Gatherer::default();
        if text.trim_start().starts_with('<') {
            fcd::read(text, &mut gatherer)?;
        } else {
            csv::read(text, &mut gatherer)?;
        }
        let (tracks, notes) = gatherer.finish()?;
        let ends: Vec<[f64; 2]> = tracks.iter().filter_map(Track::ends_s).collect();
        Ok(Self {
            content_hash: content_hash(bytes),
            begin_s: ends.iter().map(|ends| ends[0]).fold(f64::INFINITY, f64::min),
            end_s: ends.iter().map(|ends| ends[1]).fold(f64::NEG_INFINITY, f64::max),
            tracks,
            notes,
        })
    }
}

#[cfg(test)]
mod tests;
