//! Towns: a road network dressed with ground, buildings, trees, furniture, parked cars, lamps and camera sites.
//!
//! A town is made in named passes over one street plan, each a folder: the network (`network`), its surfaces
//! (`surface`), buildings on lots (`building`), street furniture and plants (`dressing`), camera sites (`camera`).
//! What sets the eight towns apart is one table, `character`. Maps read from files are dressed by `imported`.

mod assemble;
mod building;
mod builtin;
mod camera;
mod character;
mod dressing;
mod imported;
mod load;
mod network;
mod palette;
mod plot;
mod surface;
mod top_view;
mod town;

pub use building::{building_manners, sample_building};
pub use imported::dress_map;
pub use load::{NAMES, canonical_name, load};
pub use top_view::{top_view, top_view_of};
pub use town::{Placement, Town, TownError, What};
