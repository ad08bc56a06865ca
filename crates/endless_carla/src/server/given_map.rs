//! The map of an OpenDRIVE text that a client has sent.

use super::call_error::CallError;
use endless_interchange::MapLibrary;
use endless_town::Town;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Its name, by which clients load it.
pub(super) const NAME: &str = "OpenDriveMap";
/// Longest text, bytes: cities have some ten million.
const MOST_BYTES: usize = 64 << 20;

/// What has become of the text.
pub(super) struct DressedText {
    pub(super) town: Town,
    /// Its roads as our own writer has them.
    pub(super) opendrive: String,
    /// It has a mesh on which people find their way.
    pub(super) has_walkers: bool,
}

/// Makes a town of a text.
///
/// # Errors
/// When it is no map or cannot be a town.
pub(super) fn dress(maps: &MapLibrary, text: &str, has_walkers: bool) -> Result<DressedText, CallError> {
    if text.len() > MOST_BYTES {
        return Err(refused(&format!("it is longer than {} MiB", MOST_BYTES >> 20)));
    }
    // What is made here is thrown away if a road that nobody has thought of breaks the dressing: the server goes on.
    let made = catch_unwind(AssertUnwindSafe(|| maps.town_of_opendrive(NAME, text)));
    match made {
        Ok(Ok((town, opendrive))) => Ok(DressedText { town, opendrive, has_walkers }),
        Ok(Err(error)) => Err(refused(&error.to_string())),
        Err(_) => Err(refused("its roads cannot be dressed")),
    }
}

/// The words with which CARLA begins.
fn refused(reason: &str) -> CallError {
    CallError::refused(format!("opendrive could not be correctly parsed: {reason}"))
}
