//! Maps from files: their store, statistics and previews.

mod error;
mod label;
mod name;
mod preview;
mod read;
mod statistics;
mod store;
mod stored_map;

pub use error::MapError;
pub(crate) use preview::preview;
pub(crate) use read::read_map;
pub use statistics::MapStatistics;
pub use store::MapStore;
pub use stored_map::{ImportOptions, MapFormat, StoredMap};
