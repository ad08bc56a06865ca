//! CARLA's blueprints: which body of the catalogue stands for each.
//!
//! The ids, classes and sizes are those of CARLA 0.9.15's blueprint library.

use crate::person::{Appearance, Carried};
use endless_world::ObjectClass::{self, Bicycle, Bus, Car, Motorcycle, Truck, Van};
use endless_world::{Outfit, Stream};

/// Id, CARLA's base type, length, width and height of CARLA's bounding box in metres (mirrors and riders included,
/// where CARLA includes them), our design, and the draw of it that comes nearest.
pub(crate) type Blueprint = (&'static str, ObjectClass, [f32; 3], &'static str, u64);

/// All of CARLA's vehicles.
pub(crate) const VEHICLES: &[Blueprint] = &[
    ("vehicle.audi.a2", Car, [3.71, 1.79, 1.55], "car.city", 116),
    ("vehicle.audi.etron", Car, [4.86, 2.03, 1.65], "car.suv_large", 100),
    ("vehicle.audi.tt", Car, [4.18, 1.99, 1.39], "car.coupe", 51),
    ("vehicle.bmw.grandtourer", Car, [4.61, 2.24, 1.67], "car.mpv", 207),
    ("vehicle.chevrolet.impala", Car, [5.36, 2.03, 1.41], "car.executive", 124),
    ("vehicle.citroen.c3", Car, [3.99, 1.85, 1.62], "car.hatchback", 196),
    ("vehicle.dodge.charger_2020", Car, [5.01, 1.88, 1.53], "car.executive", 188),
    ("vehicle.dodge.charger_police", Car, [4.97, 2.04, 1.54], "car.police", 25),
    ("vehicle.dodge.charger_police_2020", Car, [5.24, 1.93, 1.64], "car.police", 156),
    ("vehicle.ford.crown", Car, [5.37, 1.8, 1.57], "car.taxi", 65),
    ("vehicle.ford.mustang", Car, [4.72, 1.89, 1.3], "car.coupe", 46),
    ("vehicle.jeep.wrangler_rubicon", Car, [3.87, 1.91, 1.88], "car.offroad", 56),
    ("vehicle.lincoln.mkz_2017", Car, [4.9, 2.13, 1.51], "car.executive", 120),
    ("vehicle.lincoln.mkz_2020", Car, [4.89, 1.84, 1.49], "car.executive", 59),
    ("vehicle.mercedes.coupe", Car, [5.03, 2.15, 1.65], "car.coupe", 46),
    ("vehicle.mercedes.coupe_2020", Car, [4.67, 1.81, 1.44], "car.coupe", 69),
    ("vehicle.micro.microlino", Car, [2.21, 1.48, 1.38], "car.micro", 76),
    ("vehicle.mini.cooper_s", Car, [3.81, 1.97, 1.48], "car.city", 17),
    ("vehicle.mini.cooper_s_2021", Car, [4.55, 2.1, 1.77], "car.crossover", 54),
    ("vehicle.nissan.micra", Car, [3.63, 1.85, 1.5], "car.city", 210),
    ("vehicle.nissan.patrol", Car, [4.6, 1.93, 1.85], "car.suv", 139),
    ("vehicle.nissan.patrol_2021", Car, [5.57, 2.15, 2.05], "car.suv_large", 168),
    ("vehicle.seat.leon", Car, [4.19, 1.82, 1.47], "car.hatchback", 27),
    ("vehicle.tesla.model3", Car, [4.79, 2.16, 1.49], "car.liftback", 240),
    ("vehicle.toyota.prius", Car, [4.51, 2.01, 1.52], "car.liftback", 245),
    ("vehicle.carlamotors.carlacola", Truck, [5.2, 2.63, 2.47], "truck.box_small", 187),
    ("vehicle.carlamotors.european_hgv", Truck, [7.94, 2.89, 3.46], "truck.box", 44),
    ("vehicle.carlamotors.firetruck", Truck, [8.47, 2.89, 3.83], "truck.fire", 76),
    ("vehicle.tesla.cybertruck", Truck, [6.27, 2.39, 2.1], "car.pickup_large", 162),
    ("vehicle.ford.ambulance", Van, [6.37, 2.35, 2.43], "van.ambulance", 174),
    ("vehicle.mercedes.sprinter", Van, [5.92, 1.99, 2.56], "van.high", 145),
    ("vehicle.volkswagen.t2", Van, [4.48, 2.07, 2.04], "van.camper", 101),
    ("vehicle.volkswagen.t2_2021", Van, [4.44, 1.77, 1.99], "van.camper", 219),
    ("vehicle.mitsubishi.fusorosa", Bus, [10.27, 3.94, 4.25], "bus.midi", 89),
    ("vehicle.harley-davidson.low_rider", Motorcycle, [2.35, 0.77, 1.65], "motorcycle.cruiser", 14),
    ("vehicle.kawasaki.ninja", Motorcycle, [2.04, 0.8, 1.52], "motorcycle.sport", 245),
    ("vehicle.vespa.zx125", Motorcycle, [1.82, 0.87, 1.59], "motorcycle.scooter", 141),
    ("vehicle.yamaha.yzf", Motorcycle, [2.19, 0.87, 1.53], "motorcycle.sport", 137),
    ("vehicle.bh.crossbike", Bicycle, [1.51, 0.87, 1.61], "bicycle.mountain", 161),
    ("vehicle.diamondback.century", Bicycle, [1.66, 0.58, 1.62], "bicycle.road", 22),
    ("vehicle.gazelle.omafiets", Bicycle, [1.84, 0.66, 1.78], "bicycle.city", 36),
];

/// `walker.pedestrian.0001` to this number.
const WALKERS: u32 = 51;

/// Numbers of the children among them, and how tall CARLA's box around them is, metres.
const CHILDREN: &[(u32, f32)] =
    &[(9, 1.1), (10, 1.1), (11, 1.1), (12, 1.3), (13, 1.3), (14, 1.3), (48, 1.1), (49, 1.1)];

/// Ids of all of CARLA's walkers.
pub(crate) fn walkers() -> impl Iterator<Item = String> {
    (1..=WALKERS).map(|n| format!("walker.pedestrian.{n:04}"))
}

fn walker_number(id: &str) -> Option<u32> {
    let n: u32 = id.strip_prefix("walker.pedestrian.").filter(|n| n.len() == 4)?.parse().ok()?;
    (1..=WALKERS).contains(&n).then_some(n)
}

/// The variant of a person on foot that stands for one of CARLA's walkers: a child for a child, of its height.
pub(crate) fn walker(id: &str) -> Option<u64> {
    let n = walker_number(id)?;
    let child = CHILDREN.iter().find(|c| c.0 == n).map(|c| c.1);
    let mut stream = Stream::named(u64::from(n), "carla walker", &[]);
    loop {
        let variant = stream.next_u64();
        let appearance = Appearance::of(variant, Outfit::Fair);
        match child {
            Some(height) if appearance.child() && (appearance.height - height).abs() < 0.06 => return Some(variant),
            None if !appearance.child() && appearance.carried != Carried::Wheelchair => return Some(variant),
            _ => {}
        }
    }
}

/// The variant of a person in a wheelchair that stands for one of CARLA's grown-up walkers when it uses one: of the sex
/// of the one on foot. None for children.
pub(crate) fn walker_in_wheelchair(id: &str) -> Option<u64> {
    let on_foot = Appearance::of(walker(id)?, Outfit::Fair);
    if on_foot.child() {
        return None;
    }
    let mut stream = Stream::named(u64::from(walker_number(id)?), "carla walker in a wheelchair", &[]);
    loop {
        let variant = stream.next_u64();
        let appearance = Appearance::of(variant, Outfit::Fair);
        let like = appearance.carried == Carried::Wheelchair && appearance.female == on_foot.female;
        if like && !appearance.child() {
            return Some(variant);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Catalogue;

    #[test]
    fn every_vehicle_has_a_body_of_its_class_and_size() {
        let catalogue = Catalogue::builtin();
        assert_eq!(VEHICLES.len(), 41);
        for (id, class, [length, width, height], ..) in VEHICLES {
            let model = catalogue.carla_vehicle(id).expect("a vehicle of the list");
            let spec = &catalogue.vehicles()[model.index()].spec;
            assert_eq!(spec.frequency, 0.0, "{id}");
            // CARLA counts one pickup among the lorries.
            assert!(spec.class == *class || *id == "vehicle.tesla.cybertruck", "{id} is a {}", spec.name);
            let off = (spec.length_m / length - 1.0).abs();
            // The box of CARLA's cross bike is shorter than any grown-up's.
            let near = if *id == "vehicle.bh.crossbike" { 0.17 } else { 0.09 };
            assert!(off < near, "{id}: {} is {} m long, not {length}", spec.name, spec.length_m);
            if !spec.ridden {
                // CARLA's boxes hold mirrors, and one bus's doors.
                assert!(spec.width_m < width + 0.1 && spec.width_m > 0.6 * width, "{id}: {} m wide", spec.width_m);
                assert!((spec.height_m / height - 1.0).abs() < 0.30, "{id}: {} m high", spec.height_m);
            }
        }
        assert_eq!(catalogue.carla_vehicle("vehicle.audi.a3"), None);
    }

    #[test]
    fn every_walker_is_a_person_of_its_age() {
        let people: Vec<u64> = walkers().map(|id| walker(&id).expect("a walker of the list")).collect();
        assert_eq!(people.len(), 51);
        for (id, &variant) in walkers().zip(&people) {
            let n: u32 = id[id.len() - 4..].parse().expect("a number");
            let child = CHILDREN.iter().find(|c| c.0 == n);
            let appearance = Appearance::of(variant, Outfit::Fair);
            assert_eq!(appearance.child(), child.is_some(), "{id}");
            assert!(child.is_none_or(|c| (appearance.height - c.1).abs() < 0.07), "{id}: {} m", appearance.height);
        }
        let mut distinct = people.clone();
        distinct.sort_unstable();
        distinct.dedup();
        assert_eq!(distinct.len(), people.len(), "two walkers are the same person");
        for none in ["walker.pedestrian.0000", "walker.pedestrian.0052", "walker.pedestrian.1", "vehicle.audi.a2"] {
            assert_eq!(walker(none), None, "{none}");
        }
    }
}
