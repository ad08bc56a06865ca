//! Plants stand in the ground, have the sizes of their kinds, and crowns through which the sky is seen.

use endless_asset::{Catalogue, Prop};
use endless_scene::{Mesh, Surface};
use endless_world::Stream;
use glam::Vec3;

fn meshes(prop: Prop) -> Vec<Mesh> {
    let catalogue = Catalogue::builtin();
    (0..catalogue.prop_variants(prop)).map(|v| catalogue.prop(prop, v)).collect()
}

#[test]
fn there_are_a_dozen_species_of_trees_no_two_alike() {
    let all: Vec<Mesh> = [Prop::BroadleafTree, Prop::Conifer, Prop::Palm, Prop::Cypress, Prop::BareTree]
        .into_iter()
        .flat_map(meshes)
        .collect();
    assert!(all.len() >= 12);
    for (i, tree) in all.iter().enumerate() {
        assert!(all[..i].iter().all(|other| other != tree), "tree {i}");
    }
}

#[test]
fn plants_have_the_sizes_of_their_kinds() {
    for (prop, low, high) in [
        (Prop::BroadleafTree, 6.0, 13.0),
        (Prop::Conifer, 8.0, 14.0),
        (Prop::Cypress, 7.0, 12.5),
        (Prop::BareTree, 6.0, 13.0),
        (Prop::FlowerBed, 0.2, 0.6),
        (Prop::GrassTuft, 0.2, 0.6),
        (Prop::Wheat, 0.7, 1.1),
        (Prop::Rock, 0.3, 1.3),
    ] {
        for (variant, mesh) in meshes(prop).iter().enumerate() {
            let (foot, top) = mesh.bounds();
            assert!((low..=high).contains(&top.z), "{prop:?} {variant} is {} m high", top.z);
            assert!(foot.z > -0.3 && foot.z < 0.05, "{prop:?} {variant} begins at {}", foot.z);
            assert!(mesh.triangles.len() < 36_000, "{prop:?} {variant}: {}", mesh.triangles.len());
        }
    }
}

/// Of level rays through a crown's middle some pass, and most meet leaves.
#[test]
fn crowns_have_gaps() {
    const RAYS: usize = 160;
    for (variant, mesh) in meshes(Prop::BroadleafTree).iter().enumerate() {
        let leaves: Vec<[Vec3; 3]> = mesh
            .triangles
            .iter()
            .zip(&mesh.triangle_materials)
            .filter(|(_, m)| mesh.materials[usize::from(**m)].surface == Surface::Foliage)
            .map(|(t, _)| t.map(|i| mesh.positions[i as usize]))
            .collect();
        let corners = || leaves.iter().flatten();
        let low = corners().copied().fold(Vec3::INFINITY, Vec3::min);
        let high = corners().copied().fold(Vec3::NEG_INFINITY, Vec3::max);
        let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
        let mut stream = Stream::named(variant as u64, "rays through a crown", &[]);
        let met = (0..RAYS).filter(|_| {
            // Along x, within the inner half of the crown's outline.
            let y = middle.y + half.y * stream.range_f32(-0.5, 0.5);
            let z = middle.z + half.z * stream.range_f32(-0.5, 0.5);
            leaves.iter().any(|t| crosses(t, y, z))
        });
        let share = met.count() as f32 / RAYS as f32;
        assert!((0.35..0.995).contains(&share), "broadleaf {variant}: {share} of the rays met leaves");
    }
}

/// Whether a triangle seen along x covers (y, z).
fn crosses(corners: &[Vec3; 3], y: f32, z: f32) -> bool {
    let side = |a: Vec3, b: Vec3| (b.y - a.y) * (z - a.z) - (b.z - a.z) * (y - a.y);
    let [a, b, c] = *corners;
    let signs = [side(a, b), side(b, c), side(c, a)];
    signs.iter().all(|s| *s >= 0.0) || signs.iter().all(|s| *s <= 0.0)
}
