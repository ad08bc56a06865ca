//! Towns: a road network dressed with ground, buildings, trees, furniture, parked cars, lamps and camera sites.
//!
//! A road map, read from a file ([`dress_map`]) or made of the layout of a built-in town ([`load`]), is dressed in named
//! passes with ground, buildings, street furniture and plants, and given camera sites. The result is a [`Town`]: meshes of
//! its own, and [`Placement`]s of these and of the catalogue's props. Details that are seen only from near are made for
//! cameras that are known later ([`Town::details_near`]).
//!
//! ```text
//! builtin layouts ─┐
//! imported files ──┴─ RoadMap ── dressing ── Town ── details near cameras
//! ```
//!
//! A straight street of 240 m with sidewalks becomes a town:
//! ```
//! use endless_asset::Catalogue;
//! use endless_road::{Lane, LaneId, LaneSurface, LaneType, Polyline, RoadMap, RoadNetwork};
//! use glam::DVec3;
//!
//! let line = |y: f64, z: f64| (0..=24).map(move |k| DVec3::new(10.0 * f64::from(k), y, z));
//! let east = Lane::new(LaneId(0), Polyline::new(line(-1.75, 0.0)), 3.5, 11.0);
//! let west = Lane::new(LaneId(1), Polyline::new(line(1.75, 0.0).rev()), 3.5, 11.0);
//! let network = RoadNetwork { lanes: vec![east, west], ..RoadNetwork::default() }.finish().expect("consistent");
//! let strip = |kind, right: f64, left: f64, z: f64| {
//!     let (left, right) = (line(left, z).collect(), line(right, z).collect());
//!     LaneSurface { kind, left, right, in_junction: false, unpaved: false, bridge: false }
//! };
//! let lane_surfaces = vec![
//!     strip(LaneType::Sidewalk, -6.0, -3.5, 0.15),
//!     strip(LaneType::Driving, -3.5, 0.0, 0.0),
//!     strip(LaneType::Driving, 0.0, 3.5, 0.0),
//!     strip(LaneType::Sidewalk, 3.5, 6.0, 0.15),
//! ];
//! let map = RoadMap { network, lane_surfaces, ..RoadMap::default() };
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
mod street_features;
mod top_view;
mod town;
mod view_check;

pub use building::{building_styles, sample_building};
pub use builtin::{
    NAMES, canonical_name, draw_builtin_sites, known_cameras, load, load_with, random_name, random_number,
};
pub use camera::SiteDrawer;
pub use dressing::{DetailSource, DressOptions, TownSites, draw_map_sites, dress_map, dress_map_with};
pub use placement::{PlacedObject, Placement};
pub use street_features::{PaintedCrosswalk, PaintedMark, PaintedStopLine, SidewalkStrip, StreetFeatures};
pub use top_view::{top_view, top_view_of, whole_town};
pub use town::{Town, TownError};
pub use view_check::ViewCheck;
