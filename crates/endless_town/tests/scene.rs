//! What stands in the towns: sound meshes, cameras that see, nothing on the carriageways.

use endless_asset::{Catalogue, Mesh, Prop};
use endless_town::{NAMES, Town, What, load};
use endless_world::ClassTag;

fn towns() -> Vec<Town> {
    let catalogue = Catalogue::builtin();
    NAMES.iter().map(|n| load(n, &catalogue).expect("known")).collect()
}

fn volume(mesh: &Mesh) -> f64 {
    let sum: f64 = mesh
        .triangles
        .iter()
        .map(|t| {
            let [a, b, c] = t.map(|i| mesh.positions[i as usize].as_dvec3());
            a.dot(b.cross(c)) / 6.0
        })
        .sum();
    sum
}

#[test]
fn meshes_are_sound() {
    for town in towns() {
        let mut total = 0;
        for (m, mesh) in town.meshes.iter().enumerate() {
            assert_eq!(mesh.triangles.len(), mesh.triangle_materials.len());
            assert!(mesh.positions.iter().all(|p| p.is_finite()), "{}: mesh {m}", town.name);
            assert!(mesh.uvs.iter().all(|p| p.is_finite()), "{}: mesh {m}", town.name);
            assert!(mesh.normals.iter().all(|n| (n.length() - 1.0).abs() < 1e-3), "{}: mesh {m}", town.name);
            let flat = mesh
                .triangles
                .iter()
                .filter(|t| {
                    let [a, b, c] = t.map(|i| mesh.positions[i as usize]);
                    (b - a).cross(c - a).length() < 1e-7
                })
                .count();
            assert!(flat * 1000 <= mesh.triangles.len(), "{}: mesh {m} has {flat} flat triangles", town.name);
            let building = mesh.materials.iter().any(|m| m.tag == ClassTag::Buildings);
            let bounds = mesh.bounds();
            let size = (bounds.1 - bounds.0).as_dvec3();
            let filled = volume(mesh) / (size.x * size.y * size.z).max(1e-9);
            assert!(!building || filled > 0.2, "{}: building {m} is {filled} full", town.name);
            total += mesh.triangles.len();
        }
        assert!((20_000..1_500_000).contains(&total), "{}: {total} triangles", town.name);
    }
}

#[test]
fn the_ground_faces_up() {
    for town in towns() {
        let ground = &town.meshes[0];
        for (t, &m) in ground.triangles.iter().zip(&ground.triangle_materials) {
            let [a, b, c] = t.map(|i| ground.positions[i as usize]);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            assert!(normal.z > -1e-3, "{}: {:?} at {a} faces down", town.name, ground.materials[m as usize]);
        }
    }
}

#[test]
fn cameras_are_many_and_hang_as_asked() {
    for town in towns() {
        assert!(town.cameras.len() >= 5, "{}: {} cameras", town.name, town.cameras.len());
        for (i, camera) in town.cameras.iter().enumerate() {
            assert!((6.0..=10.0).contains(&camera.position[2]), "{}: {camera:?}", town.name);
            assert!((15.0..=35.0).contains(&camera.down_tilt_rad.to_degrees()), "{}: {camera:?}", town.name);
            assert!((60.0..=90.0).contains(&camera.horizontal_fov_rad.to_degrees()), "{}: {camera:?}", town.name);
            assert!(town.cameras[..i].iter().all(|c| c.name != camera.name), "{}: {}", town.name, camera.name);
        }
    }
}

#[test]
fn props_keep_off_the_carriageway() {
    for town in towns() {
        for placement in &town.placements {
            let What::Prop(prop, _) = placement.what else { continue };
            let at = placement.world_from_object.translation.truncate().as_dvec2();
            for lane in &town.network.lanes {
                let (_, t) = lane.centerline.project(at);
                // An island's trees stand between lanes, not on them.
                assert!(t.abs() > lane.width_m / 2.0 + 0.2, "{}: {prop:?} at {at} on {:?}", town.name, lane.id);
            }
        }
        let poles = town.placements.iter().filter(|p| p.what == What::Prop(Prop::CameraPole, 0)).count();
        assert!(poles <= town.cameras.len());
    }
}
