//! Towns: a road network dressed with ground, buildings, trees, furniture, parked cars, lamps and camera sites.
//!
//! There is one way of making a town: a road map, read from a file ([`dress_map`]) or written here as the layout of a
//! built-in town ([`load`]), is dressed in named passes with ground, buildings, street furniture and plants, and given
//! camera sites. What comes out is a [`Town`]: meshes of its own, and [`Placement`]s of these and of the catalogue's
//! props. What is seen from near by alone is made for the cameras that a scene has ([`Town::details_near`]).
//!
//! ```text
//! builtin layouts ─┐
//! imported files ──┴─ RoadMap ── dressing ── Town ── details near cameras
//! ```
//!
//! A straight street of 160 m becomes a town:
//! ```
//! use endless_asset::Catalogue;
//! use endless_road::{Lane, LaneId, Polyline, RoadMap, RoadNetwork};
//! use glam::DVec3;
//!
//! let lane = |id, from: DVec3, to: DVec3| {
//!     let points = (0..=16).map(|k| from.lerp(to, f64::from(k) / 16.0));
//!     Lane::new(LaneId(id), Polyline::new(points), 3.5, 11.0)
//! };
//! let (west, east) = (DVec3::new(0.0, 0.0, 0.0), DVec3::new(160.0, 0.0, 0.0));
//! let aside = DVec3::new(0.0, 1.75, 0.0);
//! let lanes = vec![lane(0, west - aside, east - aside), lane(1, east + aside, west + aside)];
//! let network = RoadNetwork { lanes, ..RoadNetwork::default() }.finish().expect("a consistent network");
//! let map = RoadMap { network, ..RoadMap::default() };
//!
//! let catalogue = Catalogue::builtin();
//! let town = endless_town::dress_map("street", &map, &catalogue)?;
//! assert!(!town.cameras.is_empty() && town.placements.len() > town.meshes.len());
//! let details = town.details_near(&town.cameras[..1], &catalogue);
//! assert_eq!(details, town.details_near(&town.cameras[..1], &catalogue));
//! # Ok::<(), endless_town::TownError>(())
//! ```

mod building;
mod builtin;
mod camera;
mod dressing;
mod geometry;
mod palette;
mod placement;
mod top_view;
mod town;

pub use building::{building_styles, sample_building};
pub use builtin::{NAMES, canonical_name, load};
pub use dressing::{DetailSource, dress_map};
pub use placement::{PlacedObject, Placement};
pub use top_view::{top_view, top_view_of};
pub use town::{Town, TownError};
