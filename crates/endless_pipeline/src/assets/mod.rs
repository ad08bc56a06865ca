//! What the catalogue holds: listed, drawn, and written to files.

mod folder;
mod place;
mod show;

pub use folder::{AssetFolder, AssetFolderError};
pub(crate) use place::stand_in;

use crate::maps::gltf;
use endless_asset::{Catalogue, ImportedThing, PersonModel, Prop, VehicleModel};
use endless_scene::Mesh;
use endless_town::{building_manners, sample_building};
use endless_world::Image;
use glam::Vec3;
use std::borrow::Borrow;

/// People whose sizes are looked at for the list.
const PEOPLE: u64 = 64;
/// Name of the one body that all people are draws of.
const PERSON: &str = "person";
/// What the names of buildings begin with.
const BUILDING: &str = "building.";
/// Buildings of each manner whose sizes are looked at for the list.
const BUILDINGS: u64 = 12;

/// An asset as it is listed. Sizes are smallest and largest, metres.
#[derive(Debug, Clone, PartialEq)]
pub struct AssetKind {
    /// Name to preview and export it by.
    pub name: String,
    /// Class of its annotations, or `furniture` or `plant`.
    pub class: String,
    /// Along x.
    pub length_m: [f32; 2],
    /// Along y; of vehicles without mirrors.
    pub width_m: [f32; 2],
    /// Height.
    pub height_m: [f32; 2],
    /// Of the variant with the most, wheels and riders included.
    pub triangles: usize,
    /// How many different ones there are (species of trees, codes of signs, ...); `None`: any number.
    pub draws: Option<u32>,
}

/// Why an asset cannot be shown or written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum AssetError {
    /// None of the names.
    #[error("unknown asset '{given}': see `endless assets list`{}", told(similar))]
    Unknown {
        /// What was asked for.
        given: String,
        /// Names that begin alike.
        similar: Vec<String>,
    },
    /// More than a `.glb` can hold.
    #[error("asset '{name}' does not fit into one file")]
    TooLarge {
        /// Which.
        name: String,
    },
}

fn told(similar: &[String]) -> String {
    if similar.is_empty() { String::new() } else { format!(" (there are {})", similar.join(", ")) }
}

/// Names that begin alike, to be told with a name that is none.
fn similar(catalogue: &Catalogue, given: &str) -> Vec<String> {
    let stem = given.split('.').next().unwrap_or(given).to_lowercase();
    names(catalogue).into_iter().filter(|n| n.contains(&stem) && !stem.is_empty()).take(6).collect()
}

/// Something of the catalogue.
#[derive(Debug, Clone)]
pub(crate) enum Thing {
    Vehicle(VehicleModel),
    Person(Box<PersonModel>),
    Prop(Prop, u32),
    Building(Mesh),
    Imported(ImportedThing),
}

fn names(catalogue: &Catalogue) -> Vec<String> {
    let vehicles = Catalogue::vehicle_kinds().into_iter().map(|k| k.name.to_owned());
    let imported = catalogue.imported_vehicles().iter().map(|v| v.name().to_owned());
    let imported = imported.chain(catalogue.imported_things().iter().map(|t| t.name.clone()));
    let buildings = building_manners().into_iter().map(|manner| format!("{BUILDING}{manner}"));
    let props = Prop::ALL.iter().map(|p| p.name());
    vehicles.chain([PERSON.to_owned()]).chain(buildings).chain(props).chain(imported).collect()
}

/// The asset of a name; `variant` counts its draws.
fn find(catalogue: &Catalogue, name: &str, variant: u64) -> Result<Thing, AssetError> {
    if let Some(vehicle) = Catalogue::draw_vehicle(name, variant) {
        return Ok(Thing::Vehicle(vehicle));
    }
    if name == PERSON {
        return Ok(Thing::Person(Box::new(catalogue.person(variant))));
    }
    if let Some(vehicle) = catalogue.imported_vehicles().iter().find(|v| v.name() == name) {
        return Ok(Thing::Vehicle(vehicle.clone()));
    }
    if let Some(thing) = catalogue.imported_things().iter().find(|t| t.name == name) {
        return Ok(Thing::Imported(thing.clone()));
    }
    if let Some(building) = name.strip_prefix(BUILDING).and_then(|manner| sample_building(manner, variant)) {
        return Ok(Thing::Building(building));
    }
    let prop = Prop::ALL.iter().copied().find(|p| p.name() == name);
    let unknown = || AssetError::Unknown { given: name.to_owned(), similar: similar(catalogue, name) };
    let prop = prop.ok_or_else(unknown)?;
    Ok(Thing::Prop(prop, (variant % u64::from(catalogue.prop_variants(prop))) as u32))
}

/// Triangles of a vehicle with its wheels and its rider.
fn triangles(vehicle: &VehicleModel) -> usize {
    let rider = vehicle.rider(0).map_or(0, |r| r.triangles.len());
    let trailer = vehicle.trailer();
    let wheels = vehicle.wheels().len() + trailer.map_or(0, |t| t.wheels.len());
    let bodies = vehicle.body().triangles.len() + trailer.map_or(0, |t| t.body.triangles.len());
    bodies + wheels * vehicle.wheel_mesh().triangles.len() + rider
}

/// Everything there is, vehicles first, what comes from files last.
pub(crate) fn list(catalogue: &Catalogue) -> Vec<AssetKind> {
    let vehicles = Catalogue::vehicle_kinds().into_iter().map(|kind| AssetKind {
        name: kind.name.to_owned(),
        class: kind.class.to_string(),
        length_m: kind.length_m,
        width_m: kind.width_m,
        height_m: kind.height_m,
        triangles: Catalogue::draw_vehicle(kind.name, 0).map_or(0, |v| triangles(&v)),
        draws: None,
    });
    let people: Vec<_> = (0..PEOPLE).map(|v| catalogue.person(v).rest).collect();
    let buildings = building_manners().into_iter().map(|manner| {
        let all: Vec<Mesh> = (0..BUILDINGS).filter_map(|seed| sample_building(manner, seed)).collect();
        measured(format!("{BUILDING}{manner}"), "building", &all, None)
    });
    let props = Prop::ALL.iter().map(|&prop| {
        let all: Vec<Mesh> = (0..catalogue.prop_variants(prop)).map(|v| catalogue.prop(prop, v)).collect();
        measured(prop.name(), set_class(Some(prop)), &all, Some(all.len() as u32))
    });
    let imported = catalogue.imported_vehicles().iter().map(|vehicle| AssetKind {
        name: vehicle.name().to_owned(),
        class: vehicle.spec.class.to_string(),
        length_m: [vehicle.spec.length_m; 2],
        width_m: [vehicle.spec.width_m; 2],
        height_m: [vehicle.spec.height_m; 2],
        triangles: triangles(vehicle),
        draws: Some(1),
    });
    let things = catalogue
        .imported_things()
        .iter()
        .map(|thing| measured(thing.name.clone(), set_class(thing.prop), std::slice::from_ref(&thing.mesh), Some(1)));
    let people = [measured(PERSON.to_owned(), "pedestrian", &people, None)];
    vehicles.chain(people).chain(buildings).chain(props).chain(imported).chain(things).collect()
}

/// What a prop is of, `None` being a building.
fn set_class(prop: Option<Prop>) -> &'static str {
    prop.map_or("building", |p| if p.is_plant() { "plant" } else { "furniture" })
}

fn measured<M: Borrow<Mesh>>(name: String, class: &str, meshes: &[M], draws: Option<u32>) -> AssetKind {
    let meshes = || meshes.iter().map(Borrow::borrow);
    let sizes = || meshes().map(Mesh::bounds).map(|(low, high)| Vec3::new(high.x - low.x, high.y - low.y, high.z));
    let low = sizes().fold(Vec3::INFINITY, Vec3::min);
    let high = sizes().fold(Vec3::ZERO, Vec3::max);
    AssetKind {
        name,
        class: class.to_owned(),
        length_m: [low.x, high.x],
        width_m: [low.y, high.y],
        height_m: [low.z, high.z],
        triangles: meshes().map(|m| m.triangles.len()).max().unwrap_or(0),
        draws,
    }
}

/// A sheet of views from all sides.
///
/// # Errors
/// When there is no such asset.
pub(crate) fn preview(catalogue: &Catalogue, name: &str, variant: u64) -> Result<Image<[u8; 3]>, AssetError> {
    Ok(show::turntable(catalogue, &find(catalogue, name, variant)?, variant))
}

/// A binary glTF file.
///
/// # Errors
/// When there is no such asset, or it is too large.
pub(crate) fn export(catalogue: &Catalogue, name: &str, variant: u64) -> Result<Vec<u8>, AssetError> {
    let too_large = |_: gltf::TooLarge| AssetError::TooLarge { name: name.to_owned() };
    gltf::write_thing(&find(catalogue, name, variant)?, name, variant, catalogue).map_err(too_large)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_listed_name_is_found_and_others_are_told_with_what_is_alike() {
        let catalogue = Catalogue::builtin();
        let listed = list(&catalogue);
        let all: Vec<String> = listed.iter().map(|k| k.name.clone()).collect();
        assert_eq!(all, names(&catalogue));
        for kind in &listed {
            assert!(find(&catalogue, &kind.name, 3).is_ok(), "{}", kind.name);
            assert!(kind.triangles > 50 && kind.height_m[0] <= kind.height_m[1], "{kind:?}");
        }
        let Err(unknown) = find(&catalogue, "car.sedam", 0) else { panic!("there is no car.sedam") };
        assert!(unknown.to_string().contains("car.micro"), "{unknown}");
    }

    #[test]
    fn a_preview_shows_the_thing_from_all_sides() {
        let picture = preview(&Catalogue::builtin(), "motorcycle.scooter", 1).expect("an asset");
        let width = picture.size.width as usize;
        // In the middle of each of the eight views there is something else than the ground of its corner.
        for (row, column) in (0..2).flat_map(|r| (0..4).map(move |c| (r, c))) {
            let at = |x: usize, y: usize| picture.data[(row * 360 + y) * width + column * 480 + x];
            let ground = at(20, 340);
            let differs = |p: [u8; 3]| p.iter().zip(ground).any(|(a, b)| a.abs_diff(b) > 40);
            let differing = (160..320).flat_map(|x| (90..270).map(move |y| (x, y))).filter(|&(x, y)| differs(at(x, y)));
            assert!(differing.count() > 2000, "view {row} {column}");
        }
    }
}
