//! Models of glTF and their manifests: an asset whose triangles can be drawn, or an error of one line.

use crate::mutate;
use crate::target::{FuzzTarget, one_line};
use endless_asset::{AssetEntry, AssetManifest, ImportedAsset};
use endless_scene::Mesh;

/// A `.glb` file, taken for a car, for a bicycle, for a bench and for a building.
pub const MODEL: FuzzTarget = FuzzTarget { name: "model", judge: model, mutate: mutate::binary };
/// The manifest of a folder of models, all of which are one box.
pub const MANIFEST: FuzzTarget = FuzzTarget { name: "manifest", judge: manifest, mutate: mutate::text };

const ENTRIES: &str = include_str!("../corpus/manifest/four-classes.toml");
const BOX: &[u8] = include_bytes!("../corpus/model/box-with-wheels.glb");

fn model(bytes: &[u8]) -> Result<(), String> {
    let manifest = AssetManifest::parse(ENTRIES).map_err(|error| format!("our own manifest: {error}"))?;
    manifest.assets.iter().try_for_each(|entry| import(entry, bytes))
}

fn manifest(bytes: &[u8]) -> Result<(), String> {
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(()) };
    match AssetManifest::parse(text) {
        // A few are enough: each takes the time of a whole import.
        Ok(manifest) => manifest.assets.iter().take(4).try_for_each(|entry| import(entry, BOX)),
        Err(error) => one_line(&error),
    }
}

fn import(entry: &AssetEntry, bytes: &[u8]) -> Result<(), String> {
    match entry.import(bytes, &|_| None) {
        Ok(ImportedAsset::Vehicle(vehicle)) => sound(&vehicle.whole()),
        Ok(ImportedAsset::StaticModel(model)) => sound(&model.mesh),
        Err(error) => one_line(&error),
    }
}

fn sound(mesh: &Mesh) -> Result<(), String> {
    let corners = mesh.triangles.iter().flatten();
    let rules = [
        ("a place that is no place", mesh.positions.iter().all(|p| p.is_finite())),
        ("a normal of another length than 1", mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-3)),
        ("a triangle without its corners", corners.clone().all(|&i| (i as usize) < mesh.positions.len())),
        ("a triangle without a material", mesh.triangle_materials.len() == mesh.triangles.len()),
        ("a material that there is not", {
            mesh.triangle_materials.iter().all(|&m| usize::from(m) < mesh.materials.len())
        }),
    ];
    rules.iter().find(|(_, holds)| !holds).map_or(Ok(()), |(wrong, _)| Err((*wrong).to_owned()))
}
