//! A whole town, or one thing of the catalogue, as a binary glTF 2.0 file (`.glb`): metres, y up, x east, z south.
//!
//! Things that look alike share a mesh; parts of a mesh that differ in material share its vertices. Materials have
//! base colour, metallicness, roughness and emission; their procedural detail is the renderer's and stays behind, and with
//! it the texture coordinates: there are no images.
//! Cameras are cameras.

mod binary;
mod material;
mod scene;

pub(crate) use binary::TooLarge;

use crate::asset::CatalogueItem;
use endless_asset::Catalogue;
use endless_town::Town;
use scene::Scene;

/// A whole town.
///
/// # Errors
/// [`TooLarge`] if it would have more than 4 GiB.
pub(crate) fn write(town: &Town, catalogue: &Catalogue) -> Result<Vec<u8>, TooLarge> {
    let mut scene = Scene::new(catalogue);
    let groups = [scene.ground_and_buildings(town), scene.furniture(town), scene.parked(town)];
    let (seen_from, cameras) = scene.cameras(town);
    let roots: Vec<usize> = groups.into_iter().flatten().chain(seen_from).collect();
    scene.document(&town.name, &roots, &cameras)
}

/// One item of the catalogue, standing at the origin.
///
/// # Errors
/// [`TooLarge`] if it would have more than 4 GiB.
pub(crate) fn write_item(
    item: &CatalogueItem,
    name: &str,
    variant: u64,
    catalogue: &Catalogue,
) -> Result<Vec<u8>, TooLarge> {
    let mut scene = Scene::new(catalogue);
    let root = match item {
        CatalogueItem::Vehicle(vehicle) => scene.single_vehicle(vehicle, variant),
        CatalogueItem::Person(person) => scene.single(name, &person.rest),
        CatalogueItem::Building(mesh) => scene.single(name, mesh),
        CatalogueItem::Imported(thing) => scene.single(name, &thing.mesh),
        CatalogueItem::Prop(prop, variant) => scene.single(name, &catalogue.prop(*prop, *variant)),
    };
    scene.document(name, root.as_slice(), &[])
}

#[cfg(test)]
mod tests;
