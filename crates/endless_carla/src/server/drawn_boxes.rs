//! Boxes of vehicles and people that hold what is drawn of them.
//!
//! CARLA's own are of its models, and those of its people hold neither arms nor legs.

use crate::wire::{BoundingBox, Vector3D};
use endless_asset::{Catalogue, VehicleModel};
use endless_world::{Gait, PersonRef, VehicleModelId, VehicleRef, WalkerMotion};
use glam::Vec3;
use std::collections::BTreeMap;

/// Instants of each gait, metres of way (or seconds of standing) apart: two steps are in them.
const INSTANTS: u8 = 24;
const APART: f32 = 0.08;
/// Speeds of walking and of hurrying, m/s.
const PACES: [(Gait, f32); 3] = [(Gait::Stand, 0.0), (Gait::Walk, 1.4), (Gait::Hurry, 2.1)];

/// Low and high corner in the object's frame: metres; forwards, left, up.
type Bounds = (Vec3, Vec3);

/// What has been found of those who were spawned.
#[derive(Default)]
pub(super) struct DrawnBoxes {
    /// By model, and by variant where somebody rides it.
    vehicles: BTreeMap<(VehicleModelId, u64), Bounds>,
    people: BTreeMap<PersonRef, Bounds>,
}

impl DrawnBoxes {
    /// Of a vehicle with its wheels straight, its rider and what it draws.
    pub(super) fn vehicle(&mut self, catalogue: &Catalogue, vehicle: VehicleRef) -> Option<BoundingBox> {
        let model = catalogue.vehicle(vehicle.model)?;
        let variant = if model.spec.ridden { vehicle.variant } else { 0 };
        let bounds = self.vehicles.entry((vehicle.model, variant)).or_insert_with(|| vehicle_bounds(model, variant));
        Some(bounding_box(*bounds, 0.0))
    }

    /// Of a person who stands or walks, whose actor's place is so high above the soles: runners reach out of it.
    pub(super) fn person(&mut self, catalogue: &Catalogue, person: PersonRef, origin_height_m: f32) -> BoundingBox {
        let bounds = self.people.entry(person).or_insert_with(|| person_bounds(catalogue, person));
        bounding_box(*bounds, origin_height_m)
    }
}

fn joined(a: Bounds, b: Bounds) -> Bounds {
    (a.0.min(b.0), a.1.max(b.1))
}

fn vehicle_bounds(model: &VehicleModel, variant: u64) -> Bounds {
    let whole = model.whole().bounds();
    model.rider(variant).map_or(whole, |rider| joined(whole, rider.bounds()))
}

fn person_bounds(catalogue: &Catalogue, person: PersonRef) -> Bounds {
    let model = catalogue.dressed_person(person);
    let mut positions = vec![Vec3::ZERO; model.rest.positions.len()];
    let mut bounds = (Vec3::MAX, Vec3::MIN);
    for (gait, speed_mps) in PACES {
        for instant in 0..INSTANTS {
            let gone = f32::from(instant) * APART;
            let motion = WalkerMotion { speed_mps, gait, walked_m: gone, time_s: gone, footing: None, risen: 0.0 };
            model.place(&model.stance(&motion), &mut positions);
            bounds = positions.iter().fold(bounds, |(low, high), &place| (low.min(place), high.max(place)));
        }
    }
    bounds
}

/// CARLA's y is to the right, and its people's place is in their middle.
fn bounding_box((low, high): Bounds, origin_height_m: f32) -> BoundingBox {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    BoundingBox {
        location: Vector3D { x: middle.x, y: -middle.y, z: middle.z - origin_height_m },
        extent: Vector3D { x: half.x, y: half.y, z: half.z },
        ..BoundingBox::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blueprint::{BlueprintKind, BlueprintLibrary};
    use endless_world::Outfit;

    #[test]
    fn people_have_room_for_their_steps() {
        let catalogue = Catalogue::builtin();
        let mut boxes = DrawnBoxes::default();
        let library = BlueprintLibrary::new();
        let Some(BlueprintKind::Walker(walker)) = library.find("walker.pedestrian.0002").map(|found| found.kind) else {
            panic!("a walker")
        };
        let person = PersonRef { outfit: Outfit::Fair, seed: walker.person };
        let bounds = boxes.person(&catalogue, person, walker.origin_height_m);
        let (middle, half) = (&bounds.location, &bounds.extent);
        assert!((0.3..0.7).contains(&half.x) && (0.2..0.6).contains(&half.y), "{half:?}");
        // From the soles to the hair.
        let soles = middle.z - half.z + walker.origin_height_m;
        assert!(soles.abs() < 0.05, "{soles}");
        assert!((1.4..2.1).contains(&(2.0 * half.z)), "{half:?}");
        // Between two instants that were looked at they reach hardly farther.
        let model = catalogue.dressed_person(person);
        for step in 0..40u8 {
            let walked_m = 0.037 + 0.05 * f32::from(step);
            let motion = WalkerMotion {
                speed_mps: 1.2,
                gait: Gait::Walk,
                walked_m,
                time_s: walked_m,
                footing: None,
                risen: 0.0,
            };
            for place in model.pose(&motion).positions {
                let aside = [place.x - middle.x, -place.y - middle.y];
                assert!(aside[0].abs() < half.x + 0.02 && aside[1].abs() < half.y + 0.02, "{place} of {bounds:?}");
            }
        }
    }

    #[test]
    fn riders_are_in_the_box_of_what_they_ride() {
        let catalogue = Catalogue::builtin();
        let mut boxes = DrawnBoxes::default();
        let of = |id: &str| VehicleRef { model: catalogue.carla_vehicle(id).expect("a body"), variant: 5 };
        let bike = of("vehicle.bh.crossbike");
        let bounds = boxes.vehicle(&catalogue, bike).expect("a bicycle");
        let head = catalogue.rider(bike).expect("a rider").bounds().1.z;
        assert!((bounds.location.z + bounds.extent.z - head).abs() < 0.01, "{bounds:?} {head}");
        let car = boxes.vehicle(&catalogue, of("vehicle.lincoln.mkz_2020")).expect("a car");
        assert!((2.0..3.0).contains(&car.extent.x) && (0.8..1.3).contains(&car.extent.y), "{car:?}");
    }
}
