//! A vehicle in words and measures.

use super::model::VehicleModel;
use endless_world::{ColoredThing, NamedColor, ObjectClass, Reid, VehicleAttributes, Word};

impl VehicleModel {
    /// Describes a variant.
    pub(crate) fn attributes(&self, variant: u64) -> VehicleAttributes {
        let spec = &self.spec;
        let design = self.design_name();
        let towed = self.trailer().map_or(0, |trailer| trailer.wheels.len());
        VehicleAttributes {
            model: Word::from(self.name().to_owned()),
            draw: design.map(|_| spec.draw),
            subclass: design.map(|name| subclass(name).into()),
            color: self.paint(variant).map(|paint| NamedColor::of(ColoredThing::Paint, paint)),
            size: [spec.length_m, spec.width_m, spec.height_m].map(|m| (f64::from(m) * 1e3).round() / 1e3),
            trailer: spec.trailer.is_some(),
            wheels: (self.wheels().len() + towed) as u32,
            base_type: base_type(spec.class).into(),
            special_type: design.and_then(special_type).map(Word::from),
        }
    }

    /// The identity of its look: its model and its paint.
    pub(crate) fn reid(&self, variant: u64) -> Reid {
        let [r, g, b] = self.paint(variant).unwrap_or_default().map(|c| u64::from(c.to_bits()));
        Reid::new("vehicle look", &[self.spec.key(), r, g, b])
    }
}

/// What the draws of a design are used for, where that can be seen, else their body.
fn subclass(design: &str) -> &str {
    match design {
        "car.taxi" | "car.taxi_mpv" => "taxi",
        "car.police" | "car.police_suv" | "van.police" => "police",
        "car.suv_large" => "suv",
        "car.pickup_large" => "pickup",
        "car.trailer" => "estate",
        "truck.box_small" => "box",
        "motorcycle.scooter_delivery" | "motorcycle.delivery" | "motorcycle.underbone_delivery" => "delivery",
        "car.saloon_old" | "car.sedan_worn" => "sedan",
        "car.hatchback_old" | "car.hatchback_worn" => "hatchback",
        "car.pickup_old" => "pickup",
        "van.small_trade" => "small",
        "van.panel_trade" => "panel",
        "motorcycle.scooter_for_two" => "scooter",
        "motorcycle.commuter_for_two" => "commuter",
        _ => design.split_once('.').map_or(design, |(_, body)| body),
    }
}

/// CARLA's word for a class of vehicles.
fn base_type(class: ObjectClass) -> &'static str {
    class.name()
}

/// CARLA's word for vehicles of special service.
fn special_type(design: &str) -> Option<&'static str> {
    match subclass(design) {
        "police" | "ambulance" | "fire" => Some("emergency"),
        "taxi" => Some("taxi"),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Catalogue;
    use crate::vehicle::design::DESIGNS;
    use endless_scene::{LightSlot, Mesh, Surface};
    use endless_world::VehicleRef;
    use rayon::prelude::*;
    use std::{collections::BTreeSet, sync::LazyLock};

    /// Its vehicles are shaped once for all tests.
    static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(Catalogue::builtin);

    /// Area of a mesh's triangles that have one of some surfaces, square metres.
    fn area(mesh: &Mesh, wanted: impl Fn(Surface) -> bool) -> f32 {
        let of = |(t, m): (&[u32; 3], &u16)| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
            let shown = wanted(mesh.materials[usize::from(*m)].surface);
            if shown { 0.5 * (b - a).cross(c - a).length() } else { 0.0 }
        };
        mesh.triangles.iter().zip(&mesh.triangle_materials).map(of).sum()
    }

    #[test]
    fn every_vehicle_wears_the_paint_that_it_is_said_to_have() {
        CATALOGUE.vehicles().par_iter().for_each(|model| {
            let said = model.attributes(7);
            assert!(said.color.is_some(), "{} has no paint", model.name());
            let painted = area(model.body(), |s| s == Surface::CarPaint);
            // Of cars the paint is the largest part of what is neither glass nor underside. Of open ones one sees the floor.
            let rest = area(model.body(), |s| matches!(s, Surface::Painted | Surface::Plate));
            let least = if model.spec.ridden { 0.05 } else { 4.0 };
            assert!(painted > least, "{}: {painted} m² are painted", model.name());
            let closed = matches!(model.spec.class, ObjectClass::Car | ObjectClass::Van) && !model.spec.ridden;
            assert!(!closed || painted > rest, "{}: {painted} m² of paint, {rest} m² of others", model.name());
        });
    }

    #[test]
    fn measures_and_wheels_are_those_of_the_mesh() {
        CATALOGUE.vehicles().par_iter().for_each(|model| {
            let said = model.attributes(3);
            let (low, high) = model.whole().bounds();
            assert!((f64::from(high.x - low.x) - said.size[0]).abs() < 0.002, "{}: {:?}", model.name(), said.size);
            assert!((f64::from(high.z) - said.size[2]).abs() < 0.002, "{}: {:?}", model.name(), said.size);
            let least = if model.spec.ridden { 2 } else { 4 };
            assert!(said.wheels >= least, "{} has {} wheels", model.name(), said.wheels);
            assert_eq!(said.trailer, model.trailer().is_some(), "{}", model.name());
        });
    }

    #[test]
    fn special_service_is_known_by_its_equipment() {
        // Emergency vehicles have beacons and taxis a lit sign on the roof; others of their classes have neither.
        let tells = |surface: Surface| {
            let beacon = Surface::VehicleLight(LightSlot::BeaconLeft);
            surface == Surface::LitSign || surface == beacon
        };
        for design in DESIGNS.iter().filter(|d| matches!(d.class, ObjectClass::Car | ObjectClass::Van)) {
            for index in 0..3 {
                let model = VehicleModel::new(design, index, design.frequency);
                let lit = area(model.body(), tells) > 0.0;
                assert_eq!(lit, model.attributes(0).special_type.is_some(), "{} {index}", design.name);
            }
        }
        let words: BTreeSet<&str> = DESIGNS.iter().map(|d| subclass(d.name)).collect();
        for word in ["taxi", "police", "ambulance", "fire", "delivery", "articulated", "school", "refuse", "sedan"] {
            assert!(words.contains(word), "{words:?}");
        }
    }

    #[test]
    fn a_look_is_a_model_in_a_paint() {
        let reid = |model: usize, variant| {
            let model = endless_world::VehicleModelId::from_index(model);
            CATALOGUE.reid(VehicleRef { model, variant }.into()).expect("in the catalogue")
        };
        assert_eq!(reid(3, 5), reid(3, 5));
        let looks: BTreeSet<Reid> =
            (0..40).flat_map(|model| (0..20).map(move |v| (model, v))).map(|(m, v)| reid(m, v)).collect();
        assert_eq!(looks.len(), 800);
    }
}
