//! Maps from files: where they are kept, what is known of a map, and pictures of it.

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
pub use statistics::MapStatistics;
pub use store::MapStore;
pub use stored_map::{ImportOptions, MapFormat, StoredMap};
