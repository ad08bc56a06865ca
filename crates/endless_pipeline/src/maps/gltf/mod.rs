//! A whole town as one binary glTF 2.0 file (`.glb`): metres, y up, x east, z south.
//!
//! Things that look alike share a mesh; parts of a mesh that differ in material share its vertices. Materials have
//! base colour, metallicness, roughness and emission; their procedural detail is the renderer's and stays behind.
//! Cameras are cameras.

mod binary;
mod material;
mod scene;

pub(crate) use binary::TooLarge;

use binary::Binary;
use endless_asset::Catalogue;
use endless_town::Town;
use material::Materials;
use scene::Scene;
use serde_json::json;

/// The file.
///
/// # Errors
/// [`TooLarge`] if it would have more than 4 GiB.
pub(crate) fn write(town: &Town, catalogue: &Catalogue) -> Result<Vec<u8>, TooLarge> {
    let mut scene =
        Scene { catalogue, binary: Binary::default(), materials: Materials::default(), meshes: vec![], nodes: vec![] };
    let groups = [scene.ground_and_buildings(town), scene.furniture(town), scene.parked(town)];
    let (seen_from, cameras) = scene.cameras(town);
    let mut roots: Vec<usize> = groups.into_iter().flatten().collect();
    roots.extend(seen_from);
    let Scene { binary, materials, meshes, nodes, .. } = scene;
    let mut document = json!({
        "asset": { "version": "2.0", "generator": concat!("endless ", env!("CARGO_PKG_VERSION")) },
        "scene": 0,
        "scenes": [{ "name": town.name, "nodes": roots }],
        "nodes": nodes,
        "meshes": meshes,
        "materials": materials.described(),
    });
    if !cameras.is_empty() {
        document["cameras"] = json!(cameras);
    }
    binary.container(document)
}

#[cfg(test)]
mod tests;
