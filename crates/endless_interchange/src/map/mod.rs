//! Maps from files: where they are kept, what is known of a map, and pictures of it.

mod about;
mod error;
mod label;
mod preview;
mod store;

pub use about::About;
pub use error::MapError;
pub(crate) use preview::preview;
pub use store::{DrivingSide, ImportOptions, MapFormat, MapStore, StoredMap};
