//! Every mesh of the catalogue is sound, and has the size of what it stands for.

use endless_asset::{Catalogue, Prop, VehicleModel};
use endless_scene::{Mesh, Surface};
use endless_world::{BodyPart, ClassTag, Gait, ObjectClass, VehicleModelId, VehicleRef, WalkerMotion};
use glam::Vec3;
use proptest::prelude::*;
use std::sync::LazyLock;

static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(Catalogue::builtin);

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
    for &m in &mesh.triangle_materials {
        assert!(usize::from(m) < mesh.materials.len(), "{name}");
    }
    let n = mesh.triangles.len();
    let degenerate = mesh.triangles.iter().filter(|&t| face_normal(mesh, t).length() < 1e-9).count();
    assert!(degenerate * 1000 <= n, "{name}: {degenerate} of {n} degenerate");
    let wrong = facing_away(mesh);
    assert!(wrong * 100 <= n, "{name}: {wrong} of {n} normals point inwards");
}

fn face_normal(mesh: &Mesh, triangle: &[u32; 3]) -> Vec3 {
    let p = triangle.map(|i| mesh.positions[i as usize]);
    (p[1] - p[0]).cross(p[2] - p[0])
}

/// How many triangles are seen from the side from which their normals point away.
fn facing_away(mesh: &Mesh) -> usize {
    let shading = |t: &[u32; 3]| t.iter().map(|&i| mesh.normals[i as usize]).sum::<Vec3>();
    mesh.triangles.iter().filter(|t| face_normal(mesh, t).dot(shading(t)) < 0.0).count()
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

fn assert_measures(v: &VehicleModel) {
    let (low, high) = v.whole().bounds();
    let s = &v.spec;
    let name = s.name;
    assert!((low.x + high.x).abs() < 1e-3, "{name} is not centred: {low} {high}");
    assert!((high.x - low.x - s.length_m).abs() < 1e-3, "{name}: {} long, not {}", high.x - low.x, s.length_m);
    assert!((high.z - s.height_m).abs() < 1e-3, "{name}: {} high, not {}", high.z, s.height_m);
    // Mirrors, and bars of two-wheelers, stand out by at most 35 cm a side.
    let width = high.y - low.y;
    assert!(width > s.width_m - 0.12 && width < s.width_m + 0.70, "{name}: {width} wide, not {}", s.width_m);
    for wheel in v.wheels().iter().chain(v.trailer().iter().flat_map(|t| &t.wheels)) {
        let low = wheel.position.z + v.wheel_mesh().bounds().0.z;
        assert!(low.abs() < 1e-3, "{name}: a wheel {low} m above the road");
    }
    assert!(low.z > -1e-3, "{name} reaches below the road");
    assert!(s.front_axle_m > 0.0 && (s.rear_axle_m < 0.0 || s.trailer.is_some()), "{name}");
    assert_eq!(v.trailer().is_some(), s.trailer.is_some(), "{name}");
    if let (Some(trailer), Some(t)) = (v.trailer(), s.trailer) {
        assert!((trailer.hitch.x - t.hitch_m).abs() < 0.02, "{name}: {} {t:?}", trailer.hitch);
        let (rear, front) = (trailer.body.bounds().0.x, trailer.body.bounds().1.x);
        assert!((front - t.front_m).abs() < 0.03 && (rear + 0.5 * s.length_m).abs() < 1e-3, "{name}: {rear} {front}");
        let towing = v.body().bounds().0.x;
        // Folds that lie about the joint turn with neither.
        assert!(towing > t.towing_rear_m - 1.3 && towing < t.towing_rear_m + 0.03, "{name}: {towing} {t:?}");
        let axles = || trailer.wheels.iter().map(|w| w.position.x);
        let middle = 0.5 * (axles().fold(f32::MIN, f32::max) + axles().fold(f32::MAX, f32::min));
        assert!((middle - t.axle_m).abs() < 0.03 && t.hitch_m - t.axle_m > 1.5, "{name}: {middle} {t:?}");
    }
    let axles = || v.wheels().iter().map(|w| w.position.x);
    assert!((axles().fold(f32::MIN, f32::max) - s.front_axle_m).abs() < 1e-3, "{name}: front axle");
    assert!((axles().fold(f32::MAX, f32::min) - s.rear_axle_m).abs() < 1e-3, "{name}: rear axle");
    for lamp in v.headlights() {
        assert!(lamp.x > 0.4 && lamp.x < high.x + 0.05 && lamp.z > 0.4 && lamp.z < 1.35, "{name}: {lamp}");
    }
}

#[test]
fn vehicles_are_sound_and_measure_what_they_say() {
    for v in CATALOGUE.vehicles() {
        assert_sound(v.body(), v.spec.name);
        assert_sound(v.wheel_mesh(), v.spec.name);
        if let Some(trailer) = v.trailer() {
            assert_sound(&trailer.body, v.spec.name);
        }
        assert!(volume(v.body()) > 0.0 && volume(v.wheel_mesh()) > 0.0, "{}", v.spec.name);
        assert_measures(v);
    }
}

#[test]
fn any_draw_is_sound_and_measures_what_it_says() {
    for (k, kind) in Catalogue::vehicle_designs().iter().enumerate() {
        for i in 0..6 {
            let v = Catalogue::draw_vehicle(kind.name, 100 + 37 * k as u64 + i).expect("a design of the list");
            for mesh in [v.body(), v.wheel_mesh()].into_iter().chain(v.trailer().map(|t| &t.body)) {
                assert_sound(mesh, kind.name);
            }
            assert_measures(&v);
        }
    }
}

#[test]
fn draws_of_a_design_differ() {
    for kind in Catalogue::vehicle_designs() {
        let [a, b] = [1, 2].map(|i| Catalogue::draw_vehicle(kind.name, i).expect("a design of the list"));
        assert_ne!(a.spec.length_m, b.spec.length_m, "{}", kind.name);
        assert!(kind.length_m[1] > 1.02 * kind.length_m[0], "{kind:?}");
    }
}

#[test]
fn vehicles_have_the_sizes_of_their_class() {
    for kind in Catalogue::vehicle_designs() {
        let (length, width, height) = match kind.class {
            ObjectClass::Car => ([2.3, 6.1], [1.45, 2.08], [1.2, 2.1]),
            ObjectClass::Van => ([3.2, 6.5], [1.42, 2.1], [1.7, 2.95]),
            ObjectClass::Truck => ([5.3, 9.5], [1.9, 2.66], [2.0, 3.9]),
            ObjectClass::Bus => ([6.4, 13.0], [2.1, 2.56], [2.8, 4.6]),
            ObjectClass::Motorcycle => ([1.7, 2.4], [0.6, 0.95], [1.05, 1.45]),
            ObjectClass::Bicycle => ([1.0, 2.7], [0.4, 0.8], [0.9, 1.25]),
            ObjectClass::Rider | ObjectClass::Pedestrian => panic!("{} is no vehicle", kind.name),
        };
        let draws = Catalogue::draw_vehicle(kind.name, 0).is_some_and(|v| v.spec.trailer.is_some());
        let three_wheeled = ["car.auto_rickshaw", "van.cargo_tricycle"].contains(&kind.name);
        let (length, width, height) =
            if three_wheeled { ([2.5, 3.4], [1.2, 1.35], [1.25, 2.05]) } else { (length, width, height) };
        let (length, height) = match kind.class {
            ObjectClass::Car if draws => ([7.0, 8.8], height),
            ObjectClass::Truck if draws => ([15.5, 18.6], [3.6, 4.15]),
            ObjectClass::Bus if draws => ([17.5, 18.8], height),
            _ => (length, height),
        };
        let within = |range: [f32; 2], allowed: [f32; 2]| range[0] >= allowed[0] && range[1] <= allowed[1];
        assert!(
            within(kind.length_m, length) && within(kind.width_m, width) && within(kind.height_m, height),
            "{kind:?}"
        );
    }
}

#[test]
fn there_are_fifty_designs_and_the_traffic_mix_is_that_of_a_city() {
    let vehicles = CATALOGUE.vehicles();
    let total: f64 = vehicles.iter().map(|v| v.spec.frequency).sum();
    let share =
        |class| vehicles.iter().filter(|v| v.spec.class == class).map(|v| v.spec.frequency).sum::<f64>() / total;
    for (class, wanted) in [
        (ObjectClass::Car, 0.76),
        (ObjectClass::Van, 0.08),
        (ObjectClass::Truck, 0.05),
        (ObjectClass::Bus, 0.03),
        (ObjectClass::Motorcycle, 0.06),
        (ObjectClass::Bicycle, 0.03),
    ] {
        assert!((share(class) - wanted).abs() < 0.015, "{class}: {}", share(class));
    }
    let kinds = Catalogue::vehicle_designs();
    assert!(kinds.len() >= 50, "{} designs", kinds.len());
    for (i, kind) in kinds.iter().enumerate() {
        assert!(kinds[..i].iter().all(|other| other.name != kind.name), "two are called {}", kind.name);
        assert!(vehicles.iter().any(|v| v.spec.name == kind.name), "no {} in the catalogue", kind.name);
    }
}

#[test]
fn a_third_of_cars_is_white_and_a_fifth_black() {
    let n = 4000;
    let tints: Vec<[f32; 3]> = (0..n).map(|i| CATALOGUE.vehicles()[2].tint(i)).collect();
    let share = |f: &dyn Fn(&[f32; 3]) -> bool| tints.iter().filter(|c| f(c)).count() as f64 / n as f64;
    assert!((share(&|c| c.iter().all(|&v| v > 0.6)) - 0.33).abs() < 0.03);
    assert!((share(&|c| c.iter().all(|&v| v < 0.014)) - 0.20).abs() < 0.03);
}

#[test]
fn what_is_ridden_has_a_rider_and_nothing_else_has() {
    for (i, v) in CATALOGUE.vehicles().iter().enumerate() {
        let model = VehicleModelId::from_index(i);
        assert_eq!(CATALOGUE.rider(VehicleRef { model, variant: 1 }).is_some(), v.spec.ridden, "{}", v.spec.name);
        for variant in 0..12 {
            let Some(rider) = CATALOGUE.rider(VehicleRef { model, variant }) else { continue };
            assert_sound(&rider, v.spec.name);
            let (low, high) = rider.bounds();
            assert!(low.z > 0.02 && high.z > 1.2 && high.z < 2.15, "{}: {low} {high}", v.spec.name);
            assert!(low.x > -0.5 * v.spec.length_m && high.x < 0.5 * v.spec.length_m, "{}: {low} {high}", v.spec.name);
            assert!(rider.materials.iter().all(|m| m.tag == ClassTag::Rider));
        }
    }
}

/// Two on a motorcycle are one rider of twice the surface, where the design has a second seat.
#[test]
fn some_riders_have_somebody_behind_them() {
    let with = |name: &str| {
        let v = Catalogue::draw_vehicle(name, 0).expect("a design of the list");
        let two = (0..200).filter(|&variant| {
            let (mesh, parts) = v.rider_body(variant).expect("it is ridden");
            assert_eq!(mesh.triangles.len(), parts.len(), "{name} {variant}");
            mesh.triangles.iter().zip(&*parts).filter(|(_, part)| **part == BodyPart::Head).count() > 0
                && mesh.positions.len() > 7000
        });
        two.count() as f64 / 200.0
    };
    for name in ["motorcycle.underbone", "motorcycle.scooter_for_two", "motorcycle.commuter_for_two"] {
        assert!((0.2..0.5).contains(&with(name)), "{name}: {}", with(name));
    }
    assert_eq!(with("motorcycle.underbone_delivery"), 0.0);
    assert_eq!(with("motorcycle.commuter"), 0.0);
}

#[test]
fn props_are_sound() {
    for &prop in Prop::ALL {
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
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn people_are_sound(variant: u64, walked_m in 0.0f32..50.0, gait in 0usize..3) {
        let person = CATALOGUE.person(variant);
        assert_sound(&person.rest, "person at rest");
        let gait = [Gait::Stand, Gait::Walk, Gait::Run][gait];
        let pose = person.pose(&WalkerMotion { speed_mps: person.walk_mps, gait, walked_m, time_s: walked_m, footing: None, risen: 0.0 });
        let posed = Mesh { positions: pose.positions, normals: pose.normals, ..(*person.rest).clone() };
        let n = posed.triangles.len();
        prop_assert!((3000..10_500).contains(&n), "{} triangles", n);
        for (p, q) in posed.positions.iter().zip(&posed.normals) {
            prop_assert!(p.is_finite() && (q.length() - 1.0).abs() < 1e-3);
            // Prams reach far ahead, umbrellas far up.
            prop_assert!(p.z > -0.016 && p.z < 2.6 && p.truncate().length() < 1.9);
        }
        // The slowest are small, old and lean on a cane.
        prop_assert!((0.5..2.2).contains(&person.walk_mps), "{} m/s", person.walk_mps);
    }
}

/// Hems are turned by nearly half a circle: normals shared by both sides would point away from one of them.
#[test]
fn both_sides_of_a_hem_have_their_own_normals() {
    for variant in [10_578_108_603_617_675_983, 3_296_443_170_665_396_406].into_iter().chain(0..40) {
        let person = CATALOGUE.person(variant);
        assert_eq!(facing_away(&person.rest), 0, "person {variant}");
    }
}

#[test]
fn the_same_variant_is_the_same_person() {
    assert_eq!(CATALOGUE.person(77), Catalogue::builtin().person(77));
    assert_ne!(CATALOGUE.person(77).rest, CATALOGUE.person(78).rest);
}
