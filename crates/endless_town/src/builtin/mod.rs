//! The built-in towns: each file is the layout of one, in the terms of an OpenStreetMap extract. The road builder reads
//! it and it is dressed like any map.

mod altstadt;
mod camera_table;
mod ladera;
mod layout;
mod layout_geometry;
mod layout_intersection;
mod town01;
mod town02;
mod town03;
mod town04;
mod town05;
mod town06;
mod town07;
mod town10hd;

use crate::dressing::{TownPreset, dress};
use crate::{Town, TownError};
use endless_asset::Catalogue;
use endless_road::RoadMap;

pub use camera_table::known_cameras;

type MakeLayout = fn() -> (RoadMap, TownPreset);

/// CARLA's towns in the paper's order, then two of our own.
const TOWNS: [(&str, MakeLayout); 10] = [
    ("Town01", town01::make),
    ("Town02", town02::make),
    ("Town03", town03::make),
    ("Town04", town04::make),
    ("Town05", town05::make),
    ("Town06", town06::make),
    ("Town07", town07::make),
    ("Town10HD", town10hd::make),
    ("Ladera", ladera::make),
    ("Altstadt", altstadt::make),
];

const fn names() -> [&'static str; TOWNS.len()] {
    let mut names = [""; TOWNS.len()];
    let mut i = 0;
    while i < names.len() {
        names[i] = TOWNS[i].0;
        i += 1;
    }
    names
}

/// Names of the built-in towns.
pub const NAMES: &[&str] = &names();

/// The built-in town that is meant: `Town01_Opt` is `Town01`.
///
/// # Errors
/// [`TownError::UnknownMap`] if there is no such town.
pub fn canonical_name(given: &str) -> Result<&'static str, TownError> {
    find(given).map(|(name, _)| name)
}

/// Makes a built-in town. The same name gives the same town everywhere.
///
/// # Errors
/// [`TownError::UnknownMap`] if there is no such town.
pub fn load(name: &str, catalogue: &Catalogue) -> Result<Town, TownError> {
    let (name, make) = find(name)?;
    let (map, preset) = make();
    dress(name, &map, &preset, catalogue)
}

fn find(given: &str) -> Result<(&'static str, MakeLayout), TownError> {
    let plain = given.strip_suffix("_Opt").unwrap_or(given);
    let unknown = || TownError::UnknownMap { given: given.to_owned(), known: NAMES.to_vec() };
    TOWNS.into_iter().find(|(name, _)| *name == plain).ok_or_else(unknown)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_with_and_without_suffix() {
        assert_eq!(canonical_name("Town01_Opt"), Ok("Town01"));
        assert_eq!(canonical_name("Town10HD"), Ok("Town10HD"));
        let error = canonical_name("Town99").expect_err("no such map");
        assert!(error.to_string().contains("Town99") && error.to_string().contains("Town07"));
    }
}
