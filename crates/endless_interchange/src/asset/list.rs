//! The list of all assets.

use super::item::{BUILDING, PERSON};
use endless_asset::{Catalogue, Prop, VehicleModel};
use endless_scene::Mesh;
use endless_town::{building_styles, sample_building};
use glam::Vec3;
use std::borrow::Borrow;

/// People whose sizes are looked at for the list.
const PEOPLE: u64 = 64;
/// Buildings of each style whose sizes are looked at for the list.
const BUILDINGS: u64 = 12;

/// An asset as it is listed. Sizes are smallest and largest, metres.
#[derive(Debug, Clone, PartialEq)]
pub struct AssetListing {
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

/// Triangles of a vehicle with its wheels and its rider.
fn triangles(vehicle: &VehicleModel) -> usize {
    let rider = vehicle.rider(0).map_or(0, |r| r.triangles.len());
    let trailer = vehicle.trailer();
    let wheels = vehicle.wheels().len() + trailer.map_or(0, |t| t.wheels.len());
    let bodies = vehicle.body().triangles.len() + trailer.map_or(0, |t| t.body.triangles.len());
    bodies + wheels * vehicle.wheel_mesh().triangles.len() + rider
}

/// Everything that a catalogue holds, vehicles first, what comes from files last.
pub fn list_assets(catalogue: &Catalogue) -> Vec<AssetListing> {
    let vehicles = Catalogue::vehicle_designs().into_iter().map(|kind| AssetListing {
        name: kind.name.to_owned(),
        class: kind.class.to_string(),
        length_m: kind.length_m,
        width_m: kind.width_m,
        height_m: kind.height_m,
        triangles: Catalogue::draw_vehicle(kind.name, 0).map_or(0, |v| triangles(&v)),
        draws: None,
    });
    let people: Vec<_> = (0..PEOPLE).map(|v| catalogue.person(v).rest).collect();
    let buildings = building_styles().into_iter().map(|style| {
        let all: Vec<Mesh> = (0..BUILDINGS).filter_map(|seed| sample_building(style, seed)).collect();
        measured(format!("{BUILDING}{style}"), "building", &all, None)
    });
    let props = Prop::ALL.iter().map(|&prop| {
        let all: Vec<Mesh> = (0..catalogue.prop_variants(prop)).map(|v| catalogue.prop(prop, v)).collect();
        measured(prop.name().to_owned(), set_class(Some(prop)), &all, Some(all.len() as u32))
    });
    let imported = catalogue.imported_vehicles().iter().map(|vehicle| AssetListing {
        name: vehicle.name().to_owned(),
        class: vehicle.spec.class.to_string(),
        length_m: [vehicle.spec.length_m; 2],
        width_m: [vehicle.spec.width_m; 2],
        height_m: [vehicle.spec.height_m; 2],
        triangles: triangles(vehicle),
        draws: Some(1),
    });
    let models = catalogue
        .imported_static_models()
        .iter()
        .map(|thing| measured(thing.name.clone(), set_class(thing.prop), std::slice::from_ref(&thing.mesh), Some(1)));
    let people = [measured(PERSON.to_owned(), "pedestrian", &people, None)];
    vehicles.chain(people).chain(buildings).chain(props).chain(imported).chain(models).collect()
}

/// What a prop is of, `None` being a building.
fn set_class(prop: Option<Prop>) -> &'static str {
    prop.map_or("building", |p| if p.is_plant() { "plant" } else { "furniture" })
}

fn measured<M: Borrow<Mesh>>(name: String, class: &str, meshes: &[M], draws: Option<u32>) -> AssetListing {
    let meshes = || meshes.iter().map(Borrow::borrow);
    let sizes = || meshes().map(Mesh::bounds).map(|(low, high)| Vec3::new(high.x - low.x, high.y - low.y, high.z));
    let low = sizes().fold(Vec3::INFINITY, Vec3::min);
    let high = sizes().fold(Vec3::ZERO, Vec3::max);
    AssetListing {
        name,
        class: class.to_owned(),
        length_m: [low.x, high.x],
        width_m: [low.y, high.y],
        height_m: [low.z, high.z],
        triangles: meshes().map(|m| m.triangles.len()).max().unwrap_or(0),
        draws,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::asset::item::{find, names};

    #[test]
    fn every_listed_name_is_found_and_others_are_told_with_what_is_alike() {
        let catalogue = Catalogue::builtin();
        let listed = list_assets(&catalogue);
        let all: Vec<String> = listed.iter().map(|k| k.name.clone()).collect();
        assert_eq!(all, names(&catalogue));
        for kind in &listed {
            assert!(find(&catalogue, &kind.name, 3).is_ok(), "{}", kind.name);
            assert!(kind.triangles > 50 && kind.height_m[0] <= kind.height_m[1], "{kind:?}");
        }
        let Err(unknown) = find(&catalogue, "car.sedam", 0) else { panic!("there is no car.sedam") };
        assert!(unknown.to_string().contains("car.micro"), "{unknown}");
    }
}
