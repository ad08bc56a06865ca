//! Exported files are opened by another reader and compared with the town.

use super::{write_item, write_town};
use crate::asset::CatalogueItem;
use endless_asset::{Catalogue, Prop};
use endless_scene::Surface;
use endless_town::{PlacedObject, Town, load};
use endless_world::math;
use glam::{Mat4, Vec3};

fn z_up(v: Vec3) -> Vec3 {
    Vec3::new(v.x, -v.z, v.y)
}

fn opened() -> (Town, Catalogue, gltf::Gltf) {
    let catalogue = Catalogue::builtin();
    let town = load("Town02", &catalogue).expect("a town");
    let bytes = write_town(&town, &catalogue).expect("not too large");
    // Reading validates the document too.
    let file = gltf::Gltf::from_slice(&bytes).expect("valid glTF");
    (town, catalogue, file)
}

/// Every node of the scene with its place in the world, y up.
fn nodes<'a>(file: &'a gltf::Gltf) -> Vec<(gltf::Node<'a>, Mat4)> {
    let scene = file.default_scene().expect("a scene");
    let mut open: Vec<(gltf::Node<'a>, Mat4)> = scene.nodes().map(|n| (n, Mat4::IDENTITY)).collect();
    let mut all = Vec::new();
    while let Some((node, world_from_parent)) = open.pop() {
        let place = world_from_parent * Mat4::from_cols_array_2d(&node.transform().matrix());
        open.extend(node.children().map(|child| (child, place)));
        all.push((node, place));
    }
    all
}

#[test]
fn another_reader_finds_the_same_town() {
    let (town, catalogue, file) = opened();
    let blob = file.blob.as_deref().expect("a binary chunk");
    let all = nodes(&file);

    // Every thing is there once; those that look alike share a mesh.
    let wheels: usize = town.parked.iter().map(|p| catalogue.vehicles()[p.vehicle.model.index()].wheels().len()).sum();
    let shown = all.iter().filter(|(n, _)| n.mesh().is_some()).count();
    assert_eq!(shown, town.placements.len() + town.parked.len() + wheels);
    assert!(file.meshes().len() < shown / 2, "{} meshes for {shown} nodes", file.meshes().len());
    assert_eq!(all.iter().filter(|(n, _)| n.camera().is_some()).count(), town.cameras.len());

    // The triangles of all, and where they lie.
    let mut low = Vec3::INFINITY;
    let mut high = Vec3::NEG_INFINITY;
    let (mut ours, mut ours_low, mut ours_high) = (0, Vec3::INFINITY, Vec3::NEG_INFINITY);
    for placement in &town.placements {
        let PlacedObject::TownMesh(i) = placement.object else { continue };
        let mesh = &town.meshes[i as usize];
        ours += mesh.triangles.len();
        for &p in &mesh.positions {
            let p = placement.world_from_object.transform_point3(p);
            (ours_low, ours_high) = (ours_low.min(p), ours_high.max(p));
        }
    }
    let group = file.nodes().find(|n| n.name() == Some("Town")).expect("a group");
    let mut theirs = 0;
    for node in group.children() {
        let place = Mat4::from_cols_array_2d(&node.transform().matrix());
        let mesh = node.mesh().expect("a mesh");
        for part in mesh.primitives() {
            theirs += part.indices().expect("indices").count() / 3;
        }
        let part = mesh.primitives().next().expect("a part");
        for p in part.reader(|_| Some(blob)).read_positions().expect("positions") {
            let p = z_up(place.transform_point3(p.into()));
            (low, high) = (low.min(p), high.max(p));
        }
    }
    assert_eq!(theirs, ours);
    assert!(low.distance(ours_low) < 1e-2 && high.distance(ours_high) < 1e-2, "{low} {ours_low} {high} {ours_high}");
}

#[test]
fn a_triangle_of_a_lamp_lies_where_the_town_has_it() {
    let (town, catalogue, file) = opened();
    let blob = file.blob.as_deref().expect("a binary chunk");
    let (prop, variant, place) = town
        .placements
        .iter()
        .find_map(|p| match p.object {
            PlacedObject::Prop(prop @ endless_asset::Prop::StreetLamp, variant) => {
                Some((prop, variant, p.world_from_object))
            }
            _ => None,
        })
        .expect("a street lamp");
    let mesh = catalogue.prop(prop, variant);
    let lens = mesh.materials.iter().position(|m| m.surface == Surface::LampLens).expect("a lens");
    let triangle = mesh.triangle_materials.iter().position(|&m| usize::from(m) == lens).expect("of a triangle");
    let expected = mesh.triangles[triangle].map(|i| place.transform_point3(mesh.positions[i as usize]));
    let normal = (expected[1] - expected[0]).cross(expected[2] - expected[0]);
    let found = nodes(&file).into_iter().filter(|(n, _)| n.name().is_some_and(|n| n.starts_with("StreetLamp"))).any(
        |(node, place)| {
            let mesh = node.mesh().expect("a mesh");
            let shines = |p: &gltf::Primitive<'_>| p.material().emissive_factor() != [0.0; 3];
            let part = mesh.primitives().find(shines).expect("a lens");
            let reader = part.reader(|_| Some(blob));
            let positions: Vec<Vec3> = reader.read_positions().expect("positions").map(Vec3::from).collect();
            let indices: Vec<u32> = reader.read_indices().expect("indices").into_u32().collect();
            let corners = [0, 1, 2].map(|k| z_up(place.transform_point3(positions[indices[k] as usize])));
            let same = corners.iter().zip(&expected).all(|(a, b)| a.distance(*b) < 1e-3);
            same && (corners[1] - corners[0]).cross(corners[2] - corners[0]).dot(normal) > 0.0
        },
    );
    assert!(found, "no lamp has its lens at {expected:?}");
}

#[test]
fn cameras_look_as_the_sites_do() {
    let (town, _, file) = opened();
    for site in &town.cameras {
        let (node, place) = nodes(&file)
            .into_iter()
            .find(|(n, _)| n.camera().is_some() && n.name() == Some(&site.name))
            .expect("a camera");
        let at = z_up(place.transform_point3(Vec3::ZERO));
        assert!(at.distance(Vec3::from_array(site.position)) < 1e-3);
        let forward = z_up(place.transform_vector3(Vec3::NEG_Z));
        let (sin_yaw, cos_yaw) = math::sin_cos(site.yaw_rad);
        let (sin_down, cos_down) = math::sin_cos(site.down_tilt_rad);
        let expected = Vec3::new(cos_yaw * cos_down, sin_yaw * cos_down, -sin_down);
        assert!(forward.distance(expected) < 1e-4);
        let camera = node.camera().expect("a camera");
        let gltf::camera::Projection::Perspective(lens) = camera.projection() else {
            panic!("not a perspective camera")
        };
        let wide = 2.0 * math::atan(math::tan(lens.yfov() / 2.0) * lens.aspect_ratio().expect("given"));
        assert!((wide - site.horizontal_fov_rad).abs() < 1e-4);
    }
}

#[test]
fn another_reader_finds_a_single_thing() {
    let catalogue = Catalogue::builtin();
    let bike = Catalogue::draw_vehicle("bicycle.city", 1).expect("a design");
    let rider = bike.rider(5).expect("somebody rides it");
    let triangles = bike.whole().triangles.len() + rider.triangles.len();
    let person = catalogue.person(2);
    let bench = catalogue.prop(Prop::Bench, 0);
    let (persons, benchs) = (person.rest.triangles.len(), bench.triangles.len());
    let things = [
        (CatalogueItem::Vehicle(bike), triangles),
        (CatalogueItem::Person(Box::new(person)), persons),
        (CatalogueItem::Prop(Prop::Bench, 0), benchs),
    ];
    for (thing, wanted) in things {
        let bytes = write_item(&thing, "thing", 5, &catalogue).expect("not too large");
        let file = gltf::Gltf::from_slice(&bytes).expect("valid glTF");
        let shown: usize = nodes(&file)
            .iter()
            .filter_map(|(n, _)| n.mesh())
            .flat_map(|mesh| mesh.primitives().filter_map(|p| p.indices()).collect::<Vec<_>>())
            .map(|indices| indices.count() / 3)
            .sum();
        assert_eq!(shown, wanted);
    }
}
