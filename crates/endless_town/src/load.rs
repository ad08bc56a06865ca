//! Towns by name.

use crate::assemble::{assemble, set_up_cameras};
use crate::building::Lot;
use crate::camera::{Relief, Solid};
use crate::character::{Character, TOWN02};
use crate::dressing::Dresser;
use crate::plot::Occupied;
use crate::{Town, TownError, building, builtin, dressing, network, surface};
use endless_asset::Catalogue;
use glam::Affine3A;

/// The maps there are: the paper's in its order, then two of our own.
pub const NAMES: &[&str] =
    &["Town01", "Town02", "Town03", "Town04", "Town05", "Town06", "Town07", "Town10HD", "Ladera", "Altstadt"];

/// The name of the map that is meant: `Town01_Opt` is `Town01`.
///
/// # Errors
/// [`TownError::UnknownMap`] if there is no such map.
pub fn canonical_name(given: &str) -> Result<&'static str, TownError> {
    let plain = given.strip_suffix("_Opt").unwrap_or(given);
    NAMES
        .iter()
        .copied()
        .find(|&name| name == plain)
        .ok_or_else(|| TownError::UnknownMap { given: given.to_owned(), known: NAMES.to_vec() })
}

/// Makes a town. The same name gives the same town everywhere.
///
/// # Errors
/// [`TownError::UnknownMap`] if there is no such map.
pub fn load(name: &str, catalogue: &Catalogue) -> Result<Town, TownError> {
    let name = canonical_name(name)?;
    if let Some(town) = builtin::load(name, catalogue) {
        return town;
    }
    assert_eq!(name, TOWN02.name, "every other town has a plan");
    Ok(make(&TOWN02, catalogue))
}

fn make(character: &Character, catalogue: &Catalogue) -> Town {
    let (plan, network) = network::build(character);
    let mut occupied = Occupied::default();
    let mut own = vec![(surface::build(character, &plan, &network), Affine3A::IDENTITY)];
    let (lots, buildings) = building::build(character, &plan, &mut occupied);
    own.extend(buildings);
    let mut dresser = Dresser::new(character, &plan, catalogue, occupied);
    dressing::add_signals(&mut dresser);
    dressing::add_lamps(&mut dresser);
    dressing::add_signs(&mut dresser);
    dressing::add_parked(&mut dresser);
    let solids: Vec<Solid> = lots.iter().map(Lot::solid).collect();
    let cameras = set_up_cameras(&mut dresser, &network, &Relief::new(&network, &own), &solids, &[]);
    dressing::keep_the_seen(&mut dresser.parked, &cameras);
    own.push((dressing::dress(&mut dresser, &cameras, &lots), Affine3A::IDENTITY));
    assemble(character.name, character.summary, network, own, dresser.into_stage(), cameras)
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
        let known = |n: &str| builtin::has(n) || TOWN02.name == n;
        assert!(NAMES.iter().all(|n| known(n)));
    }
}
