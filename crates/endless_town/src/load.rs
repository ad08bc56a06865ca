//! Towns by name.

use crate::building::Lot;
use crate::camera::{Relief, Scene, Solid};
use crate::character::{CHARACTERS, Character};
use crate::dressing::{Dresser, Spot};
use crate::plot::Occupied;
use crate::{Placement, Town, TownError, What, building, camera, dressing, network, surface};
use endless_asset::{Catalogue, Mesh, Prop};
use endless_road::RoadNetwork;
use endless_world::CameraSite;
use glam::{Affine3A, DVec2, Vec3};

/// Height of [`Prop::CameraPole`] as it is made, metres.
const CAMERA_POLE_M: f32 = 6.0;

/// The maps there are, in the paper's order.
pub const NAMES: &[&str] = &["Town01", "Town02", "Town03", "Town04", "Town05", "Town06", "Town07", "Town10HD"];

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
    let character = CHARACTERS.iter().find(|c| c.name == name).expect("every name has a character");
    Ok(make(character, catalogue))
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
    let cameras = cameras(&mut dresser, &network, &own, &lots);
    dressing::keep_the_seen(&mut dresser.parked, &cameras);
    own.push((dressing::dress(&mut dresser, &cameras, &lots), Affine3A::IDENTITY));
    let mut placements: Vec<Placement> = own
        .iter()
        .enumerate()
        .map(|(i, &(_, world_from_object))| Placement { what: What::Own(i as u32), world_from_object, signal: None })
        .collect();
    placements.append(&mut dresser.placements);
    let meshes = own.into_iter().map(|(mesh, _)| mesh).collect();
    Town {
        name: character.name.to_owned(),
        summary: character.summary,
        network,
        meshes,
        placements,
        parked: dresser.parked,
        lamps: dresser.lamps,
        cameras,
    }
}

/// Chooses camera sites and puts up their poles.
fn cameras(
    dresser: &mut Dresser<'_>,
    network: &RoadNetwork,
    own: &[(Mesh, Affine3A)],
    lots: &[Lot],
) -> Vec<CameraSite> {
    let relief = Relief::new(network, own);
    let solids: Vec<Solid> = lots.iter().map(Lot::solid).collect();
    let scene = Scene {
        network,
        relief: &relief,
        solids: &solids,
        posts: dresser.placements.iter().map(|p| Vec3::from(p.world_from_object.translation)).collect(),
        parked: dresser.parked.iter().map(|p| p.pose.position).collect(),
    };
    camera::choose(scene, &mut |foot, ground, height, yaw| {
        let scale = Vec3::new(1.0, 1.0, (height as f32 + 0.1) / CAMERA_POLE_M);
        let spot = Spot { z: ground, scale, ..Spot::new(foot, yaw) };
        dresser.put(Prop::CameraPole, spot, DVec2::splat(0.2), None)
    })
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
        assert!(NAMES.iter().all(|n| CHARACTERS.iter().any(|c| c.name == *n)));
    }
}
