//! Buildings of every style are sound: closed as seen from the street, wound alike, on the ground, of real sizes.

use super::{building_styles, sample_building};
use endless_scene::Mesh;
use endless_world::{Stream, math};
use glam::Vec3;
use std::sync::Mutex;

/// Buildings of each style.
const SEEDS: u64 = 200;
/// And those that are looked at from all sides.
const SEEN: u64 = 12;

/// Some of every style, on two threads.
fn each(seeds: u64, look: impl Fn(&str, u64, &Mesh) + Sync) {
    let styles = building_styles();
    std::thread::scope(|scope| {
        for half in 0..2 {
            let (styles, look) = (&styles, &look);
            scope.spawn(move || {
                for name in styles.iter().skip(half).step_by(2) {
                    for seed in 0..seeds {
                        look(name, seed, &sample_building(name, seed).expect("a style of the list"));
                    }
                }
            });
        }
    });
}

fn corners(mesh: &Mesh) -> Vec<[Vec3; 3]> {
    mesh.triangles.iter().map(|t| t.map(|i| mesh.positions[i as usize])).collect()
}

#[test]
fn there_are_two_dozen_styles_with_names_of_their_own() {
    let names = building_styles();
    assert!(names.len() >= 24);
    for (i, name) in names.iter().enumerate() {
        assert!(!names[..i].contains(name), "{name}");
    }
    assert!(sample_building("castle", 0).is_none());
}

#[test]
fn buildings_are_sound_and_stand_on_the_ground() {
    each(SEEDS, |name, seed, mesh| {
        assert!(mesh.positions.iter().all(|p| p.is_finite()), "{name} {seed}");
        assert!(mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-3), "{name} {seed}");
        let triangles = corners(mesh);
        let area = |[a, b, c]: &[Vec3; 3]| (*b - *a).cross(*c - *a).length();
        let flat = triangles.iter().filter(|t| area(t) < 1e-7).count();
        assert!(flat * 1000 <= triangles.len(), "{name} {seed}: {flat} of {} degenerate", triangles.len());
        let volume: f32 = triangles.iter().map(|[a, b, c]| a.dot(b.cross(*c)) / 6.0).sum();
        assert!(volume > 60.0, "{name} {seed}: {volume} m³");
        let (low, high) = mesh.bounds();
        assert!(low.z > -0.02 && low.z < 0.01, "{name} {seed} begins at {}", low.z);
        let size = high - low;
        assert!((4.0..45.0).contains(&size.x) && (4.0..45.0).contains(&size.y), "{name} {seed}: {size}");
        let (least, most) = match name {
            "glass_tower" | "concrete_tower" => (35.0, 90.0),
            "church" => (14.0, 40.0),
            "shop_row" | "supermarket" | "petrol_station" | "barn" | "latin_american_house" => (3.5, 13.0),
            _ => (6.0, 32.0),
        };
        assert!((least..most).contains(&size.z), "{name} {seed} is {} m high", size.z);
        assert!((200..30_000).contains(&triangles.len()), "{name} {seed}: {} triangles", triangles.len());
    });
}

/// Distance to a triangle and whether it is met from behind (Möller and Trumbore 1997).
fn met([a, b, c]: &[Vec3; 3], from: Vec3, direction: Vec3) -> Option<(f32, bool)> {
    let (e, f) = (*b - *a, *c - *a);
    let p = direction.cross(f);
    let determinant = e.dot(p);
    if determinant.abs() < 1e-12 {
        return None;
    }
    let s = from - *a;
    let u = s.dot(p) / determinant;
    let q = s.cross(e);
    let v = direction.dot(q) / determinant;
    let t = f.dot(q) / determinant;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 1e-4).then_some((t, determinant < 0.0))
}

/// From where cameras may hang, outer sides alone are seen.
#[test]
fn buildings_are_closed_as_seen_from_the_street() {
    const RAYS: usize = 150;
    let open = Mutex::new(Vec::new());
    each(SEEN, |name, seed, mesh| {
        let triangles = corners(mesh);
        let (low, high) = mesh.bounds();
        let mut stream = Stream::named(seed, name, &[]);
        let (mut hits, mut inner) = (0, 0);
        for _ in 0..RAYS {
            let (sin, cos) = math::sin_cos(stream.range_f32(0.0, std::f32::consts::TAU));
            let middle = 0.5 * (low + high);
            let from = Vec3::new(middle.x + 45.0 * cos, middle.y + 45.0 * sin, stream.range_f32(3.0, 14.0));
            let aim = low + (high - low) * Vec3::new(stream.f32(), stream.f32(), stream.f32());
            let direction = (aim - from).normalize();
            let first = triangles.iter().filter_map(|t| met(t, from, direction)).min_by(|a, b| a.0.total_cmp(&b.0));
            if let Some((_, behind)) = first {
                hits += 1;
                inner += usize::from(behind);
            }
        }
        if inner * 40 > hits {
            open.lock().expect("nobody panicked").push(format!("{name} {seed}: {inner} of {hits}"));
        }
    });
    let open = open.into_inner().expect("nobody panicked");
    assert!(open.is_empty(), "{open:#?}");
}
