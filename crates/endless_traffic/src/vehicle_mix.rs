//! Which vehicles there are: by their frequency in the fleet, which is that of a European city, or as in another part of the
//! world.
//!
//! The shares by class are round figures of city streets, not counts of one street. Of North America they are in the order of
//! the vehicle-miles on urban arterials in FHWA's Highway Statistics (table VM-4); that motorcycles are most of what moves in
//! South-East Asian cities, and a fifth and more in Latin American ones, is told by Bray and Holyoak (2015, "Motorcycles in
//! Developing Asian Cities: A Case Study of Hanoi") and by CAF's Observatory of Urban Mobility.

use endless_world::{LookPool, ObjectClass, Region, TrafficProfile, VehicleSpec};

/// Shares of car, van, truck, bus, motorcycle and bicycle.
const CLASSES: [ObjectClass; 6] = [
    ObjectClass::Car,
    ObjectClass::Van,
    ObjectClass::Truck,
    ObjectClass::Bus,
    ObjectClass::Motorcycle,
    ObjectClass::Bicycle,
];

fn class_shares(region: Region) -> Option<[f64; 6]> {
    match region {
        Region::European => None,
        Region::NorthAmerican => Some([0.87, 0.045, 0.055, 0.012, 0.006, 0.012]),
        Region::LatinAmerican => Some([0.57, 0.07, 0.06, 0.08, 0.2, 0.02]),
        Region::SouthEastAsian => Some([0.29, 0.03, 0.035, 0.025, 0.6, 0.02]),
    }
}

fn regional_factor(region: Region, design: &str) -> Option<f64> {
    Some(match (region, design) {
        (Region::NorthAmerican, "car.pickup" | "car.pickup_large") => 8.0,
        (Region::NorthAmerican, "car.suv_large" | "bus.school") => 4.0,
        (Region::NorthAmerican, "car.suv" | "car.crossover") => 1.6,
        (Region::NorthAmerican, "car.micro" | "car.city" | "car.estate" | "bus.double") => 0.1,
        (Region::NorthAmerican, "truck.semi" | "truck.tractor") => 0.1,
        (Region::LatinAmerican, "car.taxi" | "bus.midi" | "motorcycle.delivery") => 5.0,
        (Region::LatinAmerican, "car.pickup" | "car.city" | "van.minibus") => 2.0,
        (Region::LatinAmerican, "bus.double" | "car.micro") => 0.1,
        (Region::SouthEastAsian, "motorcycle.scooter" | "motorcycle.commuter" | "car.taxi") => 3.0,
        (Region::SouthEastAsian, "car.city" | "car.mpv" | "car.pickup" | "van.minibus") => 2.0,
        (Region::SouthEastAsian, "motorcycle.cruiser" | "car.coupe" | "car.executive" | "bus.double") => 0.2,
        _ => THOUSAND * hardly_european(region).iter().find(|(name, _)| *name == design)?.1,
    })
}

/// How many times as frequent a design is as in Europe, among others of its class.
fn design_factor(region: Region, design: &str) -> f64 {
    regional_factor(region, design).unwrap_or(1.0)
}

/// Designs that European streets hardly have count there as a thousandth.
const THOUSAND: f64 = 1e3;

/// Those that a region does have, with their frequency among the others of their class: three-wheelers, motorcycles for
/// two, cars of several decades, what is loaded and lettered. Round figures, to be met and not to be counted.
fn hardly_european(region: Region) -> &'static [(&'static str, f64)] {
    match region {
        Region::European => &[],
        Region::NorthAmerican => &[
            ("car.saloon_old", 0.4),
            ("car.pickup_old", 1.0),
            ("car.hatchback_worn", 1.0),
            ("car.sedan_worn", 3.0),
            ("van.small_trade", 1.0),
            ("van.panel_trade", 2.0),
            ("truck.conventional", 2.5),
        ],
        Region::LatinAmerican => &[
            ("car.auto_rickshaw", 1.5),
            ("car.saloon_old", 3.0),
            ("car.hatchback_old", 5.0),
            ("car.pickup_old", 2.5),
            ("car.hatchback_worn", 6.0),
            ("car.sedan_worn", 4.0),
            ("van.cargo_tricycle", 0.5),
            ("van.kei", 1.5),
            ("van.cab_over", 3.0),
            ("van.small_trade", 1.0),
            ("van.panel_trade", 1.0),
            ("truck.stake", 2.0),
            ("truck.conventional", 0.4),
            ("bus.colectivo", 3.0),
            ("motorcycle.underbone", 1.5),
            ("motorcycle.underbone_delivery", 0.5),
            ("motorcycle.scooter_for_two", 1.0),
            ("motorcycle.commuter_for_two", 6.0),
        ],
        Region::SouthEastAsian => &[
            ("car.auto_rickshaw", 8.0),
            ("car.saloon_old", 1.0),
            ("car.hatchback_old", 0.8),
            ("car.pickup_old", 2.0),
            ("car.hatchback_worn", 3.0),
            ("car.sedan_worn", 3.0),
            ("van.cargo_tricycle", 1.0),
            ("van.kei", 3.0),
            ("van.cab_over", 4.0),
            ("van.small_trade", 0.5),
            ("van.panel_trade", 0.5),
            ("truck.stake", 2.5),
            ("bus.colectivo", 1.0),
            ("motorcycle.underbone", 16.0),
            ("motorcycle.underbone_delivery", 4.0),
            ("motorcycle.scooter_for_two", 7.0),
            ("motorcycle.commuter_for_two", 2.0),
        ],
    }
}

/// The looks of a model: as many more as it is more frequent than in Europe, if Europe hardly has it.
pub(crate) fn looks(spec: &VehicleSpec, region: Region) -> LookPool {
    let own = hardly_european(region).iter().any(|(name, _)| *name == spec.name);
    let times = if own { design_factor(region, spec.name) } else { 1.0 };
    LookPool::vehicles(&VehicleSpec { frequency: spec.frequency * times, ..spec.clone() })
}

/// The frequency of each of these models among moving vehicles; they need not sum to 1.
pub(crate) fn frequencies(specs: &[VehicleSpec], profile: &TrafficProfile) -> Vec<f64> {
    let TrafficProfile { region, two_wheelers, bicycles, heavy_vehicles, .. } = *profile;
    let mut weights: Vec<f64> = specs.iter().map(|spec| spec.frequency * design_factor(region, spec.name)).collect();
    if let Some(shares) = class_shares(region) {
        scale_to(specs, &mut weights, |class| CLASSES.iter().position(|&other| other == class), &shares);
    }
    // Of those on two wheels, and of the others.
    let mut set_share = |of_two_wheeled: bool, is: &dyn Fn(ObjectClass) -> bool, share: f64| {
        let group = |class: ObjectClass| (class.two_wheeled() == of_two_wheeled).then(|| usize::from(is(class)));
        let counted = specs.iter().zip(&weights).filter(|(spec, _)| group(spec.class).is_some());
        let all: f64 = counted.map(|(_, weight)| weight).sum();
        scale_to(specs, &mut weights, group, &[all * (1.0 - share), all * share]);
    };
    if let Some(share) = heavy_vehicles {
        set_share(false, &|class| matches!(class, ObjectClass::Truck | ObjectClass::Bus), share);
    }
    if let Some(share) = bicycles {
        set_share(true, &|class| class == ObjectClass::Bicycle, share);
    }
    if let Some(share) = two_wheelers {
        scale_to(specs, &mut weights, |class| Some(usize::from(class.two_wheeled())), &[1.0 - share, share]);
    }
    weights
}

/// Scales weights so that each group has its share of their sum.
fn scale_to(specs: &[VehicleSpec], weights: &mut [f64], group: impl Fn(ObjectClass) -> Option<usize>, shares: &[f64]) {
    let mut sums = vec![0.0; shares.len()];
    for (spec, weight) in specs.iter().zip(&*weights) {
        if let Some(place) = group(spec.class) {
            sums[place] += weight;
        }
    }
    for (spec, weight) in specs.iter().zip(weights) {
        if let Some(place) = group(spec.class)
            && sums[place] > 0.0
        {
            *weight *= shares[place] / sums[place];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_asset::Catalogue;

    fn share(profile: TrafficProfile, is: impl Fn(&VehicleSpec) -> bool) -> f64 {
        let specs = Catalogue::builtin().vehicle_specs();
        let weights = frequencies(&specs, &profile);
        let of = |is: &dyn Fn(&VehicleSpec) -> bool| -> f64 {
            specs.iter().zip(&weights).filter(|(spec, _)| is(spec)).map(|(_, weight)| weight).sum()
        };
        of(&is) / of(&|_| true)
    }

    #[test]
    fn the_usual_mix_is_that_of_the_fleet() {
        let specs = Catalogue::builtin().vehicle_specs();
        let fleet: Vec<f64> = specs.iter().map(|spec| spec.frequency).collect();
        assert_eq!(frequencies(&specs, &TrafficProfile::default()), fleet);
    }

    #[test]
    fn regions_have_their_shares_by_class() {
        for &region in Region::ALL {
            let Some(shares) = class_shares(region) else { continue };
            assert!((shares.iter().sum::<f64>() - 1.0).abs() < 1e-9, "{region}");
            let profile = TrafficProfile { region, ..TrafficProfile::default() };
            for (class, wanted) in CLASSES.into_iter().zip(shares) {
                let is = share(profile, |spec| spec.class == class);
                assert!((is - wanted).abs() < 1e-9, "{region} {class:?}: {is}");
            }
        }
    }

    #[test]
    fn two_wheelers_have_the_share_that_is_asked_for() {
        for &region in Region::ALL {
            for wanted in [0.0, 0.4, 1.0] {
                let profile = TrafficProfile { region, two_wheelers: Some(wanted), ..TrafficProfile::default() };
                assert!((share(profile, |spec| spec.class.two_wheeled()) - wanted).abs() < 1e-9, "{region}");
            }
        }
    }

    #[test]
    fn heavy_vehicles_have_the_share_that_is_asked_for_beside_that_of_two_wheelers() {
        let heavy = |spec: &VehicleSpec| matches!(spec.class, ObjectClass::Truck | ObjectClass::Bus);
        for &region in Region::ALL {
            for (wanted, two_wheelers) in [(0.0, 0.0), (0.25, 0.4), (1.0, 0.5)] {
                let profile = TrafficProfile {
                    region,
                    two_wheelers: Some(two_wheelers),
                    heavy_vehicles: Some(wanted),
                    ..TrafficProfile::default()
                };
                assert!((share(profile, heavy) - wanted * (1.0 - two_wheelers)).abs() < 1e-9, "{region}");
                assert!((share(profile, |spec| spec.class.two_wheeled()) - two_wheelers).abs() < 1e-9, "{region}");
            }
        }
    }

    #[test]
    fn bicycles_have_the_share_of_two_wheelers_that_is_asked_for() {
        for &region in Region::ALL {
            for (wanted, two_wheelers) in [(0.0, 0.3), (0.7, 0.4), (1.0, 1.0)] {
                let profile = TrafficProfile {
                    region,
                    two_wheelers: Some(two_wheelers),
                    bicycles: Some(wanted),
                    ..TrafficProfile::default()
                };
                let bicycles = share(profile, |spec| spec.class == ObjectClass::Bicycle);
                assert!((bicycles - wanted * two_wheelers).abs() < 1e-9, "{region}");
            }
        }
    }

    #[test]
    fn three_wheelers_are_of_the_south() {
        let three_wheelers = |region| {
            share(TrafficProfile { region, ..TrafficProfile::default() }, |spec| {
                ["car.auto_rickshaw", "van.cargo_tricycle"].contains(&spec.name)
            })
        };
        assert!(three_wheelers(Region::European) < 1e-4);
        assert!((0.005..0.03).contains(&three_wheelers(Region::LatinAmerican)));
        assert!((0.01..0.06).contains(&three_wheelers(Region::SouthEastAsian)));
    }

    #[test]
    fn a_region_has_only_what_the_catalogue_has() {
        let specs = Catalogue::builtin().vehicle_specs();
        for &region in Region::ALL {
            for (name, _) in hardly_european(region) {
                let total: f64 = specs.iter().filter(|spec| spec.name == *name).map(|spec| spec.frequency).sum();
                assert!((THOUSAND * total - 1.0).abs() < 1e-9, "{region}: {name} {total}");
            }
        }
    }

    #[test]
    fn what_is_frequent_looks_in_many_ways() {
        let specs = Catalogue::builtin().vehicle_specs();
        let underbone = specs.iter().find(|spec| spec.name == "motorcycle.underbone").expect("in the catalogue");
        let looks = |region| looks(underbone, region).size();
        assert!(looks(Region::SouthEastAsian) > 5 * looks(Region::European));
    }

    #[test]
    fn pickups_are_north_american() {
        let pickups = |region| {
            share(TrafficProfile { region, ..TrafficProfile::default() }, |spec| spec.name.starts_with("car.pickup"))
        };
        assert!(pickups(Region::NorthAmerican) > 4.0 * pickups(Region::European));
    }
}
