//! Towns: a road network dressed with ground, buildings, trees, furniture, parked cars, lamps and camera sites.
//!
//! There is one way of making a town: a road map, read from a file or written here as the layout of a built-in town
//! (`builtin`), is dressed in named passes (`dressing`) with ground, buildings (`building`), street furniture and plants,
//! and given camera sites (`camera`).

mod building;
mod builtin;
mod camera;
mod dressing;
mod geometry;
mod palette;
mod placement;
mod top_view;
mod town;

pub use building::{building_manners, sample_building};
pub use builtin::{NAMES, canonical_name, load};
pub use dressing::{DetailSource, dress_map};
pub use placement::{PlacedObject, Placement};
pub use top_view::{top_view, top_view_of};
pub use town::{Town, TownError};
