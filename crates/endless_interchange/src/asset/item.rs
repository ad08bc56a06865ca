//! Items of the catalogue by name.

use endless_asset::{Catalogue, ImportedStaticModel, PersonModel, Prop, VehicleModel};
use endless_scene::Mesh;
use endless_town::{building_styles, sample_building};

/// Name of the one body that all people are draws of.
pub(super) const PERSON: &str = "person";
/// What the names of buildings begin with.
pub(super) const BUILDING: &str = "building.";

/// Why an asset cannot be shown or written.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum AssetError {
    /// None of the names.
    #[error("unknown asset '{given}': see `endless assets list`{}", suggestion(similar))]
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

fn suggestion(similar: &[String]) -> String {
    if similar.is_empty() { String::new() } else { format!(" (there are {})", similar.join(", ")) }
}

/// Names that begin alike, to be told with a name that is none.
fn similar(catalogue: &Catalogue, given: &str) -> Vec<String> {
    let stem = given.split('.').next().unwrap_or(given).to_lowercase();
    names(catalogue).into_iter().filter(|n| n.contains(&stem) && !stem.is_empty()).take(6).collect()
}

/// Anything that the catalogue holds, looked up by its name.
#[derive(Debug, Clone)]
pub(crate) enum CatalogueItem {
    Vehicle(VehicleModel),
    Person(Box<PersonModel>),
    Prop(Prop, u32),
    Building(Mesh),
    Imported(ImportedStaticModel),
}

pub(super) fn names(catalogue: &Catalogue) -> Vec<String> {
    let vehicles = Catalogue::vehicle_designs().into_iter().map(|k| k.name.to_owned());
    let imported = catalogue.imported_vehicles().iter().map(|v| v.name().to_owned());
    let imported = imported.chain(catalogue.imported_static_models().iter().map(|t| t.name.clone()));
    let buildings = building_styles().into_iter().map(|style| format!("{BUILDING}{style}"));
    let props = Prop::ALL.iter().map(|p| p.name().to_owned());
    vehicles.chain([PERSON.to_owned()]).chain(buildings).chain(props).chain(imported).collect()
}

/// The asset of a name; `variant` counts its draws.
pub(crate) fn find(catalogue: &Catalogue, name: &str, variant: u64) -> Result<CatalogueItem, AssetError> {
    if let Some(vehicle) = Catalogue::draw_vehicle(name, variant) {
        return Ok(CatalogueItem::Vehicle(vehicle));
    }
    if name == PERSON {
        return Ok(CatalogueItem::Person(Box::new(catalogue.person(variant))));
    }
    if let Some(vehicle) = catalogue.imported_vehicles().iter().find(|v| v.name() == name) {
        return Ok(CatalogueItem::Vehicle(vehicle.clone()));
    }
    if let Some(thing) = catalogue.imported_static_models().iter().find(|t| t.name == name) {
        return Ok(CatalogueItem::Imported(thing.clone()));
    }
    if let Some(building) = name.strip_prefix(BUILDING).and_then(|style| sample_building(style, variant)) {
        return Ok(CatalogueItem::Building(building));
    }
    let unknown = |_| AssetError::Unknown { given: name.to_owned(), similar: similar(catalogue, name) };
    let prop: Prop = name.parse().map_err(unknown)?;
    Ok(CatalogueItem::Prop(prop, (variant % u64::from(catalogue.prop_variants(prop))) as u32))
}
