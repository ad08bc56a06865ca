//! Where vehicles stand parked: out of the way of all who drive by, and no others because a design was added.

use crate::towns;
use endless_asset::{Catalogue, ImportedAsset, VehicleModel};
use endless_road::swept::{DesignVehicle, OrientedRectangle, SweptPath, fits, smallest_radius_m};
use endless_town::{Town, load};
use endless_world::{ObjectClass, VehicleSpec};
use glam::{DVec2, Vec3};

/// Beside the middle of their lanes drivers keep within this, metres: those of lorries and buses, and others.
const HEAVY_ASIDE_M: f64 = 0.05;
const ASIDE_M: f64 = 0.15;

/// Parked vehicles seen from above, with their heights.
fn standing(town: &Town, specs: &[VehicleSpec]) -> Vec<(OrientedRectangle, f64)> {
    let print = |parked: &endless_world::ParkedVehicle| {
        let (at, spec) = (parked.pose.position.as_dvec3(), &specs[parked.vehicle.model.index()]);
        (OrientedRectangle::new(spec, at.truncate(), f64::from(parked.pose.yaw_rad), 0.0), at.z)
    };
    town.parked.iter().map(print).collect()
}

/// Those near a lane.
fn beside(line: &endless_road::Polyline, standing: &[(OrientedRectangle, f64)]) -> Vec<(OrientedRectangle, f64)> {
    let points = line.points().iter().map(|p| p.truncate());
    let (low, high) = points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
    let near = |p: DVec2| p.cmpgt(low - 16.0).all() && p.cmplt(high + 16.0).all();
    standing.iter().copied().filter(|(print, _)| near(print.center)).collect()
}

#[test]
fn nobody_who_drives_by_touches_a_parked_vehicle() {
    let catalogue = Catalogue::builtin();
    let specs = catalogue.vehicle_specs();
    for town in towns() {
        let name = &town.name;
        let standing = standing(town, &specs);
        for lane in &town.network.lanes {
            let beside = beside(&lane.centerline, &standing);
            if beside.is_empty() {
                continue;
            }
            let radius_m = smallest_radius_m(&lane.centerline);
            for spec in specs.iter().filter(|spec| spec.frequency > 0.0 && fits(&town.network, lane, radius_m, spec)) {
                let heavy = matches!(spec.class, ObjectClass::Truck | ObjectClass::Bus);
                let body = DesignVehicle::around([spec], if heavy { HEAVY_ASIDE_M } else { ASIDE_M });
                let swept = SweptPath::along(&town.network, lane, body);
                for (print, z) in swept.footprints() {
                    let hit = beside.iter().find(|(other, height)| (z - height).abs() < 3.0 && print.overlaps(other));
                    let at = print.center;
                    assert!(hit.is_none(), "{name}: a {} at {at} on {:?} touches {hit:?}", spec.name, lane.id);
                }
            }
        }
    }
}

/// A vehicle of this design that the catalogue does not hold, as often met as one that it does.
fn another(name: &str, catalogue: &Catalogue) -> VehicleModel {
    let mut model = Catalogue::draw_vehicle(name, 5000).expect("a design");
    let alike = catalogue.vehicles().iter().find(|v| v.spec.name == name && v.spec.frequency > 0.0);
    model.spec.frequency = alike.expect("in the catalogue").spec.frequency;
    model
}

#[test]
fn a_design_more_changes_only_the_bays_that_it_stands_in() {
    let catalogue = Catalogue::builtin();
    for name in ["Town02", "Town05"] {
        let before = load(name, &catalogue).expect("known");
        for (added, parks) in [("car.hatchback", true), ("bus.articulated", false)] {
            let more = catalogue.clone().with([ImportedAsset::Vehicle(another(added, &catalogue))]);
            let after = load(name, &more).expect("known");
            assert_eq!(before.parked.len(), after.parked.len(), "{name}");
            let mut changed = 0;
            for (b, a) in before.parked.iter().zip(&after.parked) {
                let new = a.vehicle.model.index() == catalogue.vehicles().len();
                assert!(new || a == b, "{name}: {b:?} became {a:?}");
                assert_eq!(a.pose, b.pose, "{name}");
                changed += usize::from(new);
            }
            assert_eq!(changed > 0, parks, "{name}: {added}");
            assert_eq!((&before.cameras, &before.placements), (&after.cameras, &after.placements), "{name}");
        }
    }
}

#[test]
fn vehicles_park_along_all_streets_and_not_where_cameras_look() {
    const NEAR_M: f32 = 90.0;
    let (mut all, mut far) = (0, 0);
    for town in towns() {
        let seen = |at: Vec3| town.cameras.iter().any(|site| Vec3::from_array(site.position).distance(at) < NEAR_M);
        println!("{}: {} parked", town.name, town.parked.len());
        all += town.parked.len();
        far += town.parked.iter().filter(|p| !seen(p.pose.position)).count();
    }
    assert!(far * 3 > all, "{far} of {all} parked vehicles are far from all cameras");
}

#[test]
fn a_share_of_the_parked_vehicles_is_kept() {
    let town = towns().first().expect("a town");
    let kept = |share: f64| {
        let mut town = town.clone();
        town.keep_parked(share);
        town.parked
    };
    let (all, few, none) = (kept(1.0), kept(0.4), kept(0.0));
    assert_eq!((all.len(), none.len()), (town.parked.len(), 0));
    let share = few.len() as f64 / all.len() as f64;
    assert!((0.3..0.5).contains(&share), "{share}");
    assert!(few.iter().all(|parked| kept(0.7).contains(parked)), "more are left with a larger share");
}
