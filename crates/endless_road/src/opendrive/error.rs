//! What can be wrong with an OpenDRIVE file.

use crate::{ImportNote, NetworkError};

/// Why a file was refused. One line, with the place in the file.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum OpenDriveError {
    /// Not well-formed XML.
    #[error("line {line}: not well-formed XML: {what}")]
    Xml {
        /// Line in the file, from 1.
        line: usize,
        /// What is wrong.
        what: String,
    },
    /// Well-formed, but another kind of file.
    #[error("line {line}: <{element}> {what}")]
    Format {
        /// Line in the file, from 1.
        line: usize,
        /// The element.
        element: String,
        /// What is wrong with it.
        what: String,
    },
    /// More than a map can hold.
    #[error("the file has more {what} than {most}")]
    TooMuch {
        /// Of what.
        what: &'static str,
        /// How many there may be.
        most: usize,
    },
    /// Nothing to drive on.
    #[error("the file has no lane for driving (of {roads} roads){}", because(.why.as_ref()))]
    NoLanes {
        /// How many roads it has.
        roads: usize,
        /// Why the first of those that had to be left out was.
        why: Option<ImportNote>,
    },
    /// The network made of it contradicts itself.
    #[error("the network of the file's lanes is not usable: {0}")]
    Network(#[from] NetworkError),
}

fn because(why: Option<&ImportNote>) -> String {
    why.map_or_else(String::new, |note| format!(": {}: {}", note.place, note.text))
}
