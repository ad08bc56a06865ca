//! Every mesh of the catalogue is sound, and has the size of what it stands for.

use endless_asset::{Catalogue, Mesh, Prop, Surface, VehicleModel};
use endless_world::{ClassTag, Gait, ObjectClass, WalkerMotion};
use glam::Vec3;
use proptest::prelude::*;
use std::sync::LazyLock;

static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(Catalogue::builtin);

const PROPS: &[Prop] = &[
    Prop::BroadleafTree,
    Prop::Conifer,
    Prop::Palm,
    Prop::Bush,
    Prop::Hedge,
    Prop::Corn,
    Prop::StreetLamp,
    Prop::UtilityPole,
    Prop::CameraPole,
    Prop::SignalPole,
    Prop::SignalMast,
    Prop::WalkSignal,
    Prop::StopSign,
    Prop::YieldSign,
    Prop::SpeedSign,
    Prop::CrossingSign,
    Prop::Bench,
    Prop::Bin,
    Prop::Hydrant,
    Prop::PostBox,
    Prop::Bollard,
    Prop::BusShelter,
    Prop::Billboard,
    Prop::Planter,
    Prop::Cone,
    Prop::Kiosk,
    Prop::Railing,
    Prop::FencePanel,
    Prop::BikeRack,
    Prop::CafeTable,
    Prop::Cabinet,
    Prop::Dumpster,
];

/// Finite, indexed in range, unit normals that agree with the faces, hardly any degenerate triangle.
fn assert_sound(mesh: &Mesh, name: &str) {
    assert!(!mesh.triangles.is_empty(), "{name} is empty");
    assert_eq!(mesh.positions.len(), mesh.normals.len(), "{name}");
    assert_eq!(mesh.positions.len(), mesh.uvs.len(), "{name}");
    assert_eq!(mesh.triangles.len(), mesh.triangle_materials.len(), "{name}");
    assert!(mesh.positions.iter().all(|p| p.is_finite()), "{name}: position");
    assert!(mesh.uvs.iter().all(|p| p.is_finite()), "{name}: uv");
    for n in &mesh.normals {
        assert!(n.is_finite() && (n.length() - 1.0).abs() < 1e-3, "{name}: normal {n}");
    }
    for m in &mesh.materials {
        assert!(m.base_color.iter().all(|c| (0.0..=1.0).contains(c)), "{name}: {m:?}");
    }
    let (mut degenerate, mut wrong) = (0, 0);
    for (t, &m) in mesh.triangles.iter().zip(&mesh.triangle_materials) {
        assert!(usize::from(m) < mesh.materials.len(), "{name}");
        let p = t.map(|i| mesh.positions[i as usize]);
        let normal = (p[1] - p[0]).cross(p[2] - p[0]);
        if normal.length() < 1e-9 {
            degenerate += 1;
        }
        let shading: Vec3 = t.iter().map(|&i| mesh.normals[i as usize]).sum();
        if normal.dot(shading) < 0.0 {
            wrong += 1;
        }
    }
    let n = mesh.triangles.len();
    assert!(degenerate * 1000 <= n, "{name}: {degenerate} of {n} degenerate");
    assert!(wrong * 100 <= n, "{name}: {wrong} of {n} normals point inwards");
}

/// Signed volume of what is closed: positive when faces look outward.
fn volume(mesh: &Mesh) -> f32 {
    mesh.triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
            a.dot(b.cross(c)) / 6.0
        })
        .sum()
}

fn whole(vehicle: &VehicleModel) -> (Vec3, Vec3) {
    let (mut low, mut high) = vehicle.body.bounds();
    let (wheel_low, wheel_high) = vehicle.wheel_mesh.bounds();
    for wheel in &vehicle.wheels {
        low = low.min(wheel.position + wheel_low);
        high = high.max(wheel.position + wheel_high);
    }
    (low, high)
}

#[test]
fn vehicles_are_sound() {
    for v in CATALOGUE.vehicles() {
        assert_sound(&v.body, v.spec.name);
        assert_sound(&v.wheel_mesh, v.spec.name);
        assert!(volume(&v.body) > 0.0 && volume(&v.wheel_mesh) > 0.0, "{}", v.spec.name);
    }
}

#[test]
fn vehicles_measure_what_they_say() {
    for v in CATALOGUE.vehicles() {
        let (low, high) = whole(v);
        let name = v.spec.name;
        assert!((low.x + high.x).abs() < 1e-3, "{name} is not centred: {low} {high}");
        assert!((high.x - low.x - v.spec.length_m).abs() < 1e-3, "{name}");
        assert!((high.z - v.spec.height_m).abs() < 1e-3, "{name}");
        // Mirrors, and bars of two-wheelers, stand out by at most 35 cm a side.
        let width = high.y - low.y;
        assert!(width > v.spec.width_m - 0.12 && width < v.spec.width_m + 0.70, "{name}: {width}");
        let ground: Vec<f32> = v.wheels.iter().map(|w| w.position.z + v.wheel_mesh.bounds().0.z).collect();
        assert!(ground.iter().all(|z| z.abs() < 1e-3), "{name}: {ground:?}");
        assert!(low.z > -1e-3, "{name} reaches below the road");
        assert!(v.spec.front_axle_m > 0.0 && v.spec.rear_axle_m < 0.0, "{name}");
        for lamp in &v.headlights {
            assert!(lamp.x > 0.4 && lamp.x < high.x + 0.05 && lamp.z > 0.4 && lamp.z < 1.2, "{name}: {lamp}");
        }
    }
}

#[test]
fn vehicles_have_the_sizes_of_their_class() {
    for v in CATALOGUE.vehicles() {
        let s = &v.spec;
        let (length, width, height) = match s.class {
            ObjectClass::Car => (3.4..5.5, 1.6..2.0, 1.4..1.95),
            ObjectClass::Van => (4.8..6.5, 1.9..2.1, 1.9..2.8),
            ObjectClass::Truck => (5.5..9.5, 2.2..2.55, 2.3..3.9),
            ObjectClass::Bus => (10.0..13.0, 2.45..2.56, 2.9..3.9),
            ObjectClass::Motorcycle => (1.7..2.2, 0.6..0.9, 1.0..1.4),
            ObjectClass::Bicycle => (1.6..1.9, 0.5..0.7, 0.95..1.15),
            ObjectClass::Rider | ObjectClass::Pedestrian => panic!("{} is no vehicle", s.name),
        };
        assert!(length.contains(&s.length_m) && width.contains(&s.width_m) && height.contains(&s.height_m), "{s:?}");
    }
}

#[test]
fn names_differ_and_the_traffic_mix_is_that_of_a_city() {
    let vehicles = CATALOGUE.vehicles();
    let total: f64 = vehicles.iter().map(|v| v.spec.frequency).sum();
    let share =
        |class| vehicles.iter().filter(|v| v.spec.class == class).map(|v| v.spec.frequency).sum::<f64>() / total;
    for (class, wanted) in [
        (ObjectClass::Car, 0.75),
        (ObjectClass::Van, 0.08),
        (ObjectClass::Truck, 0.05),
        (ObjectClass::Bus, 0.03),
        (ObjectClass::Motorcycle, 0.06),
        (ObjectClass::Bicycle, 0.03),
    ] {
        assert!((share(class) - wanted).abs() < 0.015, "{class}: {}", share(class));
    }
    for (i, v) in vehicles.iter().enumerate() {
        assert!(vehicles[..i].iter().all(|w| w.spec.name != v.spec.name));
    }
}

#[test]
fn a_third_of_cars_is_white_and_a_fifth_black() {
    let n = 4000;
    let tints: Vec<[f32; 3]> = (0..n).map(|i| CATALOGUE.vehicle_tint(1, i)).collect();
    let share = |f: &dyn Fn(&[f32; 3]) -> bool| tints.iter().filter(|c| f(c)).count() as f64 / n as f64;
    assert!((share(&|c| c.iter().all(|&v| v > 0.6)) - 0.33).abs() < 0.03);
    assert!((share(&|c| c.iter().all(|&v| v < 0.014)) - 0.20).abs() < 0.03);
}

#[test]
fn only_two_wheelers_have_riders() {
    for (i, v) in CATALOGUE.vehicles().iter().enumerate() {
        let model = u16::try_from(i).expect("few models");
        assert_eq!(CATALOGUE.rider(model, 1).is_some(), v.spec.ridden, "{}", v.spec.name);
        for variant in 0..12 {
            let Some(rider) = CATALOGUE.rider(model, variant) else { continue };
            assert_sound(&rider, v.spec.name);
            let (low, high) = rider.bounds();
            assert!(low.z > 0.02 && high.z > 1.3 && high.z < 2.05, "{}: {low} {high}", v.spec.name);
            assert!(low.x > -0.5 * v.spec.length_m && high.x < 0.5 * v.spec.length_m, "{}", v.spec.name);
            assert!(rider.materials.iter().all(|m| m.tag == ClassTag::Rider));
        }
    }
}

#[test]
fn props_are_sound() {
    for &prop in PROPS {
        for variant in 0..CATALOGUE.prop_variants(prop) {
            let mesh = CATALOGUE.prop(prop, variant);
            assert_sound(&mesh, &format!("{prop:?} {variant}"));
            let (low, _) = mesh.bounds();
            assert!(low.z > -0.35, "{prop:?}: {low}");
            assert!(mesh.triangles.len() < 45_000, "{prop:?}: {}", mesh.triangles.len());
        }
    }
}

#[test]
fn props_stand_as_documented() {
    let bounds = |p| CATALOGUE.prop(p, 0).bounds();
    let centre = |prop, wanted: fn(Surface) -> bool| {
        let mesh = CATALOGUE.prop(prop, 0);
        let points: Vec<Vec3> = mesh
            .triangles
            .iter()
            .zip(&mesh.triangle_materials)
            .filter(|(_, m)| wanted(mesh.materials[usize::from(**m)].surface))
            .flat_map(|(t, _)| t.map(|i| mesh.positions[i as usize]))
            .collect();
        let low = points.iter().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = points.iter().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        0.5 * (low + high)
    };
    let lamp = centre(Prop::StreetLamp, |s| s == Surface::LampLens);
    assert!((lamp - Vec3::new(2.0, 0.0, 7.9)).length() < 0.05, "{lamp}");
    let head = centre(Prop::SignalPole, |s| matches!(s, Surface::SignalLens(_)));
    assert!((head.z - 3.2).abs() < 0.02 && head.x > 0.0, "{head}");
    let walk = centre(Prop::WalkSignal, |s| matches!(s, Surface::SignalLens(_)));
    assert!((walk.z - 2.4).abs() < 0.02, "{walk}");
    let (low, high) = bounds(Prop::SignalMast);
    assert!(low.y < -5.4 && low.y > -5.7 && high.z > 5.8, "{low} {high}");
    let height = |p, from: f32, to: f32| {
        let z = bounds(p).1.z;
        assert!((from..=to).contains(&z), "{p:?}: {z}");
    };
    height(Prop::BroadleafTree, 6.5, 12.0);
    height(Prop::Conifer, 8.0, 14.0);
    height(Prop::Palm, 6.0, 10.0);
    height(Prop::Bush, 0.7, 1.6);
    height(Prop::Hedge, 0.9, 1.15);
    height(Prop::Corn, 1.7, 2.8);
    height(Prop::UtilityPole, 8.9, 9.1);
    height(Prop::CameraPole, 5.9, 6.1);
    height(Prop::Bollard, 0.89, 0.91);
    height(Prop::Railing, 1.0, 1.15);
    height(Prop::FencePanel, 1.5, 1.65);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 40, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn people_are_sound(variant: u64, walked_m in 0.0f32..50.0, gait in 0usize..3) {
        let person = CATALOGUE.person(variant);
        assert_sound(&person.rest, "person at rest");
        let gait = [Gait::Stand, Gait::Walk, Gait::Run][gait];
        let pose = person.pose(&WalkerMotion { speed_mps: person.walk_mps, gait, walked_m, time_s: walked_m });
        let posed = Mesh { positions: pose.positions, normals: pose.normals, ..person.rest.clone() };
        let n = posed.triangles.len();
        prop_assert!((1200..8000).contains(&n), "{} triangles", n);
        for (p, q) in posed.positions.iter().zip(&posed.normals) {
            prop_assert!(p.is_finite() && (q.length() - 1.0).abs() < 1e-3);
            prop_assert!(p.z > -0.01 && p.z < 2.2 && p.truncate().length() < 1.3);
        }
        prop_assert!((0.7..2.2).contains(&person.walk_mps));
    }
}

#[test]
fn the_same_variant_is_the_same_person() {
    assert_eq!(CATALOGUE.person(77), Catalogue::builtin().person(77));
    assert_ne!(CATALOGUE.person(77).rest, CATALOGUE.person(78).rest);
}
