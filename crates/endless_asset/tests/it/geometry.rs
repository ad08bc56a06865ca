//! What vehicles and people look like from outside: no holes, lamps where they can be seen, sizes that agree.

use crate::soup::Soup;
use endless_asset::{Catalogue, VehicleModel};
use endless_scene::{LightSlot, Mesh, Surface};
use endless_world::{Gait, ObjectClass, WalkerMotion};
use glam::Vec3;
use rayon::prelude::*;

/// Draws of every design: some hundred vehicles in all.
fn draws() -> impl ParallelIterator<Item = VehicleModel> {
    const EACH: u64 = 6;
    let kinds = Catalogue::vehicle_designs();
    assert!(kinds.len() as u64 * EACH >= 300);
    let draw = |(name, i)| Catalogue::draw_vehicle(name, 1000 + i).expect("a design");
    let all: Vec<(&str, u64)> = kinds.into_iter().flat_map(|kind| (0..EACH).map(move |i| (kind.name, i))).collect();
    all.into_par_iter().map(draw)
}

/// Who looks from where a camera may hang meets outer sides only: skins are closed, and wound alike.
fn inner_sides(vehicle: &VehicleModel) -> Option<String> {
    const RAYS: usize = 300;
    let soup = Soup::new(&vehicle.whole());
    let (met, inner) = soup.inner_sides(RAYS, vehicle.spec.name);
    assert!(met > RAYS / 10, "{}: {met} rays met it", vehicle.spec.name);
    // A sheet's edge, the gap of a wheel arch or the rim of a pickup's bed may show its inner side.
    let allowed = if vehicle.spec.ridden { met / 25 } else { met / 40 };
    (inner > allowed).then(|| format!("{}: {inner} of {met} rays met an inner side", vehicle.spec.name))
}

#[test]
fn vehicles_are_closed_as_seen_from_outside_and_their_lights_on_the_surface() {
    let open = draws().filter_map(|vehicle| {
        assert_lights_are_on_the_surface(&vehicle);
        inner_sides(&vehicle)
    });
    let open: Vec<String> = open.collect();
    assert!(open.is_empty(), "{open:#?}");
}

/// The same of people as they move: seams of clothes, necks and cuffs are closed. Hems, hoods and what is carried have
/// an inner side that may be seen.
#[test]
fn people_are_closed_as_seen_from_outside() {
    const RAYS: usize = 200;
    let catalogue = Catalogue::builtin();
    let gaits = [Gait::Stand, Gait::Walk, Gait::Run, Gait::Talk];
    let open: Vec<String> = (0..300)
        .filter_map(|variant| {
            let person = catalogue.person(variant);
            let gait = gaits[variant as usize % gaits.len()];
            let motion = WalkerMotion { gait, walked_m: 0.1 * variant as f32, ..WalkerMotion::default() };
            let pose = person.pose(&motion);
            let mesh = Mesh { positions: pose.positions, normals: pose.normals, ..(*person.rest).clone() };
            let (met, inner) = Soup::new(&mesh).inner_sides(RAYS, &format!("person {variant}"));
            assert!(met > RAYS / 10, "{variant}: {met} rays met them");
            // A pram is open above: one looks in; and under the hem of a skirt that swings.
            let skirt = person.traits.wears.iter().any(|w| ["skirt", "long_skirt", "dress"].contains(w));
            let allowed = met
                / if person.traits.carries == "pram" {
                    10
                } else if skirt {
                    15
                } else {
                    25
                };
            (inner > allowed).then(|| format!("{variant}, {}: {inner} of {met}", person.traits.carries))
        })
        .collect();
    assert!(open.is_empty(), "{open:#?}");
}

/// Lamps of each kind are there, on the right side, and most of them can be seen from where they shine.
fn assert_lights_are_on_the_surface(vehicle: &VehicleModel) {
    let name = vehicle.spec.name;
    let front = Soup::new(vehicle.body());
    // The tail is that of what is drawn, if anything is.
    let towed = vehicle.trailer().map(|towed| (Soup::new(&towed.body), &towed.body));
    let front = (front, vehicle.body());
    for rear in [false, true] {
        let (soup, body) = towed.as_ref().filter(|_| rear).unwrap_or(&front);
        let surface = |i: usize| body.materials[usize::from(body.triangle_materials[i])].surface;
        let lens = |slot: LightSlot| -> Vec<usize> {
            (0..soup.corners.len()).filter(|&i| surface(i) == Surface::VehicleLight(slot)).collect()
        };
        let centre = |i: usize| soup.corners[i].iter().copied().sum::<Vec3>() / 3.0;
        let area = |i: usize| {
            let [a, b, c] = soup.corners[i];
            (b - a).cross(c - a).length() / 2.0
        };
        let motor = vehicle.spec.class != ObjectClass::Bicycle;
        let (four, whole) = (motor && !vehicle.spec.ridden, vehicle.trailer().is_none());
        let is_emergency = |name: &str| ["police", "ambulance", "fire"].iter().any(|what| name.contains(what));
        // Whether it must have them, and whether it may.
        let slots = [
            (LightSlot::Tail, -Vec3::X, [true; 2]),
            (LightSlot::Brake, -Vec3::X, [false, four]),
            (LightSlot::Reverse, -Vec3::X, [four && whole, four]),
            (LightSlot::Head, Vec3::X, [motor; 2]),
            (LightSlot::IndicatorLeft, Vec3::Y, [motor; 2]),
            (LightSlot::IndicatorRight, -Vec3::Y, [motor; 2]),
            (LightSlot::BeaconLeft, Vec3::Y, [is_emergency(name); 2]),
            (LightSlot::BeaconRight, -Vec3::Y, [is_emergency(name); 2]),
        ];
        for (slot, towards, [must, may]) in slots.into_iter().filter(|s| (s.1 == -Vec3::X) == rear) {
            let parts = lens(slot);
            let wanted = !parts.is_empty();
            assert!(wanted || !must, "{name} has no {slot:?}");
            assert!(may || !wanted, "{name} has {slot:?}");
            let (mut open, mut all) = (0.0, 0.0);
            for &i in &parts {
                let side = centre(i).dot(towards) > 0.0;
                assert!(side, "{name}: {slot:?} at {}", centre(i));
                let normal = soup.normal(i);
                if normal.dot(towards) < 0.2 && towards.x != 0.0 {
                    continue;
                }
                all += area(i);
                let blocked = soup.first(centre(i) + normal * 0.003, normal).is_some_and(|(t, _)| t < 0.25);
                open += if blocked { 0.0 } else { area(i) };
            }
            if wanted {
                assert!(all > 2e-4, "{name}: {slot:?} has {all} m²");
                assert!(open > 0.5 * all, "{name}: {open} of {all} m² of {slot:?} can be seen");
            }
        }
        for &lamp in vehicle.headlights().iter().filter(|_| !rear) {
            let near = lens(LightSlot::Head).iter().map(|&i| centre(i).distance(lamp)).fold(f32::INFINITY, f32::min);
            assert!(near < 0.30, "{name}: a headlight {near} m from its lens");
        }
    }
}

#[test]
fn hundreds_of_draws_of_every_design_have_measures_that_agree() {
    for kind in Catalogue::vehicle_designs() {
        for i in 0..300 {
            let v = Catalogue::draw_vehicle(kind.name, i).expect("a design");
            let s = &v.spec;
            let half = 0.5 * s.length_m;
            assert!(s.front_axle_m + s.wheel_radius_m <= half + 1e-4, "{s:?}");
            assert!(-s.rear_axle_m + s.wheel_radius_m <= half + 1e-4, "{s:?}");
            let wheelbase = s.front_axle_m - s.rear_axle_m;
            let rigid = s.trailer.map_or(s.length_m, |t| half - t.towing_rear_m);
            assert!(wheelbase > 0.4 * rigid && wheelbase < 0.85 * rigid, "{s:?}");
            assert!(s.width_m <= 2.56, "{s:?} is wider than roads allow");
            let within = |x: f32, [low, high]: [f32; 2]| x > low - 0.05 * high && x < high * 1.05;
            assert!(within(s.length_m, kind.length_m) && within(s.height_m, kind.height_m), "{s:?}");
        }
    }
}
