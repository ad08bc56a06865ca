//! Errors of track files. Every message is one line that says what to do.

use std::path::PathBuf;

/// A file of tracks that cannot be played.
#[derive(Debug, thiserror::Error)]
pub enum TrackFileError {
    /// It cannot be read.
    #[error("cannot read the tracks: {cause}: {}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why not.
        cause: std::io::Error,
    },
    /// A file of which nobody needs the whole.
    #[error("the file of tracks is longer than 2 GiB: cut the time out of it that is to be filmed: {}", path.display())]
    TooLong {
        /// The file.
        path: PathBuf,
    },
    /// It is not what it should be.
    #[error("{}: {fault}", path.display())]
    Faulty {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        fault: TrackFault,
    },
}

/// What is wrong with the content of a file of tracks.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum TrackFault {
    /// Something in one line.
    #[error("line {line}: {what}")]
    Line {
        /// From 1.
        line: usize,
        /// What is wrong there, and what should be.
        what: String,
    },
    /// Another kind of file.
    #[error(
        "this is neither SUMO's FCD (<fcd-export>) nor CSV with a header that has time,id,class,x,y,yaw: see docs/clone.md"
    )]
    Format,
    /// Nobody is in it.
    #[error("there is nobody in the file who could be played: write it with vehicles or people")]
    Empty,
    /// Longitudes and latitudes.
    #[error(
        "positions hardly change where speeds say that all drive: write them in metres (SUMO: without --fcd-output.geo)"
    )]
    Geographic,
}
