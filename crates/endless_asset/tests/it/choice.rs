//! A vehicle more in the catalogue leaves the other choices as they are.

use endless_asset::Catalogue;
use endless_world::{Stream, VehicleSpec, choose_vehicle};
use std::collections::{BTreeMap, BTreeSet};

const SLOTS: u64 = 3000;

/// The keys of the models that each slot gets.
fn drawn(specs: &[&VehicleSpec]) -> Vec<u64> {
    let slot = |i| {
        let mut stream = Stream::named(11, "slot", &[i]);
        let model = choose_vehicle(&mut stream, specs.iter().map(|s| (*s, s.frequency))).expect("frequencies");
        specs[model.index()].key()
    };
    (0..SLOTS).map(slot).collect()
}

#[test]
fn every_model_has_a_key_of_its_own() {
    let catalogue = Catalogue::builtin();
    let specs: Vec<&VehicleSpec> = catalogue.vehicles().iter().map(|v| &v.spec).filter(|s| s.frequency > 0.0).collect();
    let keys: BTreeSet<u64> = specs.iter().map(|s| s.key()).collect();
    assert_eq!(keys.len(), specs.len());
}

#[test]
fn a_design_less_changes_only_the_slots_that_had_it() {
    let catalogue = Catalogue::builtin();
    let all: Vec<&VehicleSpec> = catalogue.vehicles().iter().map(|v| &v.spec).collect();
    let before = drawn(&all);
    for gone in ["car.hatchback", "car.micro", "van.panel", "truck.semi", "bicycle.kick_scooter"] {
        let fewer: Vec<&VehicleSpec> = all.iter().copied().filter(|s| s.name != gone).collect();
        let had: BTreeSet<u64> = all.iter().filter(|s| s.name == gone).map(|s| s.key()).collect();
        let after = drawn(&fewer);
        let changed = before.iter().zip(&after).filter(|(b, a)| b != a);
        assert!(changed.clone().all(|(b, _)| had.contains(b)), "{gone}: others changed");
        assert_eq!(changed.count(), before.iter().filter(|b| had.contains(b)).count(), "{gone} is still drawn");
    }
}

#[test]
fn the_order_of_the_catalogue_is_of_no_meaning() {
    let catalogue = Catalogue::builtin();
    let all: Vec<&VehicleSpec> = catalogue.vehicles().iter().map(|v| &v.spec).collect();
    let turned: Vec<&VehicleSpec> = all.iter().rev().copied().collect();
    assert_eq!(drawn(&all), drawn(&turned));
}

#[test]
fn models_are_drawn_by_their_frequency() {
    let catalogue = Catalogue::builtin();
    let all: Vec<&VehicleSpec> = catalogue.vehicles().iter().map(|v| &v.spec).collect();
    let total: f64 = all.iter().map(|s| s.frequency).sum();
    let names: BTreeMap<u64, &str> = all.iter().map(|s| (s.key(), s.name)).collect();
    let drawn = drawn(&all);
    for name in ["car.hatchback", "car.sedan", "car.city"] {
        let share: f64 = all.iter().filter(|s| s.name == name).map(|s| s.frequency).sum::<f64>() / total;
        let count = drawn.iter().filter(|key| names[key] == name).count() as f64;
        let expected = share * SLOTS as f64;
        assert!((count - expected).abs() < 4.0 * expected.sqrt(), "{name}: {count} of {expected:.0}");
    }
}
