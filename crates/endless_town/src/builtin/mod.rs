//! The built-in towns: each file is the layout of one, in the terms of an OpenStreetMap extract. The road builder reads
//! it and it is dressed like any map.

mod altstadt;
mod camera_table;
mod ladera;
mod layout;
mod layout_geometry;
mod layout_intersection;
mod random_region;
mod random_town;
mod town01;
mod town02;
mod town03;
mod town04;
mod town05;
mod town06;
mod town07;
mod town10hd;

use crate::dressing::{DressOptions, TownPreset, draw_sites, dress};
use crate::{SiteDrawer, Town, TownError};
use endless_asset::Catalogue;
use endless_road::RoadMap;

pub use camera_table::known_cameras;

/// Names of random towns begin so.
const RANDOM: &str = "Random";

type MakeLayout = fn() -> (RoadMap, TownPreset);
type TownMaker = Box<dyn FnOnce() -> (RoadMap, TownPreset)>;

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
pub fn canonical_name(given: &str) -> Result<String, TownError> {
    find(given).map(|(name, _)| name)
}

/// Name of the random town of a number: nobody has drawn it, and the number is all there is of it.
pub fn random_name(number: u32) -> String {
    format!("{RANDOM}{number}")
}

/// The number of a random town, of its name.
pub fn random_number(name: &str) -> Option<u32> {
    let digits = name.strip_prefix(RANDOM)?;
    let number: u32 = digits.parse().ok()?;
    (random_name(number) == name).then_some(number)
}

/// Makes a built-in town. The same name gives the same town everywhere.
///
/// # Errors
/// [`TownError::UnknownMap`] if there is no such town.
pub fn load(name: &str, catalogue: &Catalogue) -> Result<Town, TownError> {
    load_with(name, &DressOptions::default(), catalogue)
}

/// Makes another town on the roads of a built-in one.
///
/// # Errors
/// [`TownError::UnknownMap`] if there is no such town.
pub fn load_with(name: &str, options: &DressOptions<'_>, catalogue: &Catalogue) -> Result<Town, TownError> {
    let (name, make) = find(name)?;
    let (map, preset) = make();
    dress(&name, &map, &preset, options, catalogue)
}

/// Asks a drawer of new camera sites in a built-in town, dressed by a seed or as usual.
///
/// # Errors
/// [`TownError::UnknownMap`] if there is no such town.
pub fn draw_builtin_sites<R>(
    name: &str,
    seed: Option<u64>,
    catalogue: &Catalogue,
    ask: impl FnOnce(&SiteDrawer<'_>) -> R,
) -> Result<R, TownError> {
    let (name, make) = find(name)?;
    let (map, preset) = make();
    draw_sites(&name, &map, &preset, seed, catalogue, ask)
}

/// Of a town the name and what makes its layout.
fn find(given: &str) -> Result<(String, TownMaker), TownError> {
    let plain = given.strip_suffix("_Opt").unwrap_or(given);
    if let Some(number) = random_number(plain) {
        return Ok((plain.to_owned(), Box::new(move || random_town::make(number))));
    }
    let unknown = || TownError::UnknownMap { given: given.to_owned(), known: NAMES.to_vec() };
    let (name, make) = TOWNS.into_iter().find(|(name, _)| *name == plain).ok_or_else(unknown)?;
    Ok((name.to_owned(), Box::new(make)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_found_with_and_without_suffix() {
        assert_eq!(canonical_name("Town01_Opt").as_deref(), Ok("Town01"));
        assert_eq!(canonical_name("Town10HD").as_deref(), Ok("Town10HD"));
        assert_eq!(canonical_name("Random7").as_deref(), Ok("Random7"));
        assert!(["Random", "Random07", "Random-1", "Random99999999999"].map(random_number).iter().all(Option::is_none));
        let error = canonical_name("Town99").expect_err("no such map");
        assert!(error.to_string().contains("Town99") && error.to_string().contains("Town07"));
    }
}
