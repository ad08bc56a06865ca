//! What reads bytes that others made, and what counts as a right answer of each: the targets of fuzzing.
//!
//! A [`FuzzTarget`] judges any bytes and changes a file so that much of it still makes sense. `corpus/NAME` holds files
//! for each: small ones of every kind, and what once broke a reader. `cargo test` reads them all, with a few changes of
//! each. The programs in `fuzz/` at the root of the repository run the same targets under libFuzzer, guided by the code
//! that an input reaches; `CONTRIBUTING.md` says how.
//!
//! ```
//! use endless_fuzz::OPENDRIVE;
//!
//! // To be told what is wrong with a file is a right answer; a panic or a map with holes would be none.
//! assert_eq!((OPENDRIVE.judge)(b"<OpenDRIVE/>"), Ok(()));
//! ```

mod carla;
mod dataset;
mod model;
mod mutate;
mod pbf;
mod recipe;
mod road;
mod target;
mod tracks;

pub use carla::CARLA;
pub use dataset::DATASET;
pub use model::{MANIFEST, MODEL};
pub use pbf::pbf_from_extract;
pub use recipe::{CAMERAS, RECIPE};
pub use road::{OPENDRIVE, OSM, PBF};
pub use target::FuzzTarget;
pub use tracks::TRACKS;

/// All targets.
pub const TARGETS: &[FuzzTarget] = &[OPENDRIVE, OSM, PBF, MODEL, MANIFEST, RECIPE, CAMERAS, DATASET, TRACKS, CARLA];
