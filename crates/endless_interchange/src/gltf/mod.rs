//! A whole town, or one asset of the catalogue, as a binary glTF 2.0 file (`.glb`): metres, y up, x east, z south.
//!
//! Things that look alike share a mesh; parts of a mesh that differ in material share its vertices. Materials have
//! base colour, metallicness, roughness and emission; their procedural detail is the renderer's and stays behind, and with
//! it the texture coordinates: there are no images.
//! Cameras are cameras.

mod buffer;
mod document;
mod material;
mod town;
mod vehicle;

pub(crate) use document::TooLarge;

use crate::asset::CatalogueItem;
use document::GltfDocument;
use endless_asset::Catalogue;
use endless_town::Town;

/// A whole town.
///
/// # Errors
/// [`TooLarge`] if it would have more than 4 GiB.
pub(crate) fn write_town(town: &Town, catalogue: &Catalogue) -> Result<Vec<u8>, TooLarge> {
    let mut document = GltfDocument::new(catalogue);
    let groups = [document.ground_and_buildings(town), document.furniture(town), document.parked(town)];
    let cameras = document.cameras(town);
    document.finish(&town.name, groups.into_iter().flatten().chain(cameras).collect())
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
    let mut document = GltfDocument::new(catalogue);
    let root = match item {
        CatalogueItem::Vehicle(vehicle) => document.single_vehicle(vehicle, variant),
        CatalogueItem::Person(person) => document.single(name, &person.rest),
        CatalogueItem::Building(mesh) => document.single(name, mesh),
        CatalogueItem::Imported(thing) => document.single(name, &thing.mesh),
        CatalogueItem::Prop(prop, variant) => document.single(name, &catalogue.prop(*prop, *variant)),
    };
    document.finish(name, root.into_iter().collect())
}

#[cfg(test)]
mod tests;
