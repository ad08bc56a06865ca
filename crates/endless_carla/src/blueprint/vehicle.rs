//! Vehicles.

use super::attribute::{choice, fixed, restricted, role_name, switch, word};
use super::entry::Blueprint;
use super::kind::{BlueprintKind, VehicleBlueprint};
use super::vehicle_table::{Equipment, Row, VEHICLES};
use crate::wire::{ActorAttribute, AttributeType, BoundingBox, Color, Vector3D};
use endless_asset::Catalogue;
use endless_world::{ClassTag, Stream, VehicleModelId, VehicleRef, srgb_from_linear};

/// How many of a vehicle's variants are looked at for one of a colour.
const PAINTS_TRIED: usize = 256;

impl VehicleBlueprint {
    /// How many people ride two-wheelers of a model and colour: each has a body of their own, which takes some milliseconds to
    /// make.
    const RIDERS: u32 = 64;

    /// How many looks vehicles of a model and colour have.
    pub const LOOKS: u32 = 4096;

    /// The vehicle of an actor of this id, in the paint of its model that comes nearest to a colour: a police car stays one.
    /// Server and client both ask here, so that they show the same rider.
    pub fn reference(&self, catalogue: &Catalogue, color: Option<Color>, actor: u32) -> VehicleRef {
        let is_ridden = catalogue.vehicle(self.model).is_some_and(|model| model.spec.ridden);
        let seed = u64::from(actor % if is_ridden { Self::RIDERS } else { Self::LOOKS });
        let with = |variant| VehicleRef { model: self.model, variant };
        let Some(color) = color else { return with(seed) };
        let unlike = |variant: u64| {
            let paint = srgb_from_linear(catalogue.vehicle_tint(with(variant)).unwrap_or([1.0; 3]));
            let apart = |a: u8, b: u8| u32::from(a.abs_diff(b)).pow(2);
            apart(paint[0], color.r) + apart(paint[1], color.g) + apart(paint[2], color.b)
        };
        let mut stream = Stream::named(seed, "carla paint", &[]);
        let variants = (0..PAINTS_TRIED).map(|_| stream.next_u64());
        with(variants.min_by_key(|&variant| unlike(variant)).unwrap_or(seed))
    }
}

/// CARLA's vehicles that have a body here: all of them.
pub(super) fn blueprints(catalogue: &Catalogue) -> impl Iterator<Item = Blueprint> {
    let bodies = VEHICLES.iter().filter_map(|row| Some((row, catalogue.carla_vehicle(row.0)?)));
    bodies.enumerate().map(|(number, (row, model))| blueprint(number, row, model))
}

fn blueprint(number: usize, row: &Row, model: VehicleModelId) -> Blueprint {
    let &(id, base_type, special_type, generation, equipment, mass_kg, extent, center) = row;
    let vehicle = VehicleBlueprint {
        model,
        base_type,
        special_type,
        generation,
        wheels: if base_type.two_wheeled() { 2 } else { 4 },
        has_lights: equipment != Equipment::Plain,
        has_dynamic_doors: equipment == Equipment::Doors,
        mass_kg,
    };
    let [location, extent] = [center, extent].map(|[x, y, z]| Vector3D { x, y, z });
    let bounding_box = BoundingBox { location, extent, ..BoundingBox::default() };
    // Unpainted steel has no colours.
    let painted = id != "vehicle.tesla.cybertruck";
    let attributes = attributes(&vehicle, painted.then_some(number));
    let rider = base_type.two_wheeled().then_some(ClassTag::Rider);
    let tags = [base_type.tag()].into_iter().chain(rider).collect();
    Blueprint::new(id, attributes, BlueprintKind::Vehicle(vehicle), bounding_box, tags)
}

/// Paints to choose from: ours, since CARLA's are part of its assets.
const PAINTS: [&str; 9] = [
    "243,243,243",
    "12,12,14",
    "128,130,133",
    "190,192,195",
    "17,37,103",
    "150,12,22",
    "62,92,140",
    "32,66,44",
    "176,152,116",
];

fn attributes(vehicle: &VehicleBlueprint, paint: Option<usize>) -> Vec<ActorAttribute> {
    use AttributeType::{Bool, Int, RgbColor, String};
    let mut attributes = vec![role_name(&["autopilot", "scenario", "ego_vehicle"])];
    if let Some(first) = paint {
        // Another first one for each, so that not all cars of a script that chooses none are of one colour.
        let mut paints = PAINTS;
        paints.rotate_left(first % PAINTS.len());
        attributes.push(choice("color", RgbColor, &paints));
    }
    if vehicle.base_type.two_wheeled() {
        attributes.push(restricted("driver_id", Int, &["1", "2", "3", "4", "5", "6"]));
    }
    attributes.extend([
        switch("sticky_control", true),
        switch("terramechanics", false),
        fixed("object_type", String, ""),
        fixed("base_type", String, vehicle.base_type.name()),
        fixed("special_type", String, vehicle.special_type),
        fixed("number_of_wheels", Int, vehicle.wheels.to_string()),
        fixed("generation", Int, vehicle.generation.to_string()),
        fixed("has_dynamic_doors", Bool, word(vehicle.has_dynamic_doors)),
        fixed("has_lights", Bool, word(vehicle.has_lights)),
    ]);
    attributes
}
