//! Imported props and buildings stand in towns where others of their class would: each takes the places of a share of
//! them, as far as it has room there.

use endless_asset::{Catalogue, ImportedStaticModel, Prop};
use endless_scene::Mesh;
use endless_town::{PlacedObject, Placement, Town};
use endless_world::{ClassTag, Stream, fnv1a};
use glam::{Affine3A, Quat, Vec3};
use std::collections::BTreeMap;
use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

/// A building takes a lot that is at most this many times as wide and deep as it is.
const LOOSE: f32 = 1.8;
/// And may be this much higher than what stood there, metres: cameras look past what stands.
const HIGHER_M: f32 = 2.0;
/// Fronts of the town's buildings lie at y = 0, but for steps and bays, metres.
const FRONT_M: f32 = 2.0;

/// Replaces props and buildings of a town by imported ones.
pub(crate) fn stand_in(town: &mut Town, catalogue: &Catalogue) {
    let models = catalogue.imported_static_models();
    if models.is_empty() {
        return;
    }
    let seed = fnv1a(town.name.bytes());
    let mut own: BTreeMap<usize, u32> = BTreeMap::new();
    let mut placements = std::mem::take(&mut town.placements);
    for (number, placement) in placements.iter_mut().enumerate() {
        let (prop, lot) = match placement.object {
            PlacedObject::Prop(prop, _) => (Some(prop), None),
            PlacedObject::TownMesh(mesh) => match Lot::of(town.meshes.get(mesh as usize).map(|mesh| &**mesh)) {
                Some(lot) => (None, Some(lot)),
                None => continue,
            },
        };
        let fits = |t: &ImportedStaticModel| t.prop == prop && lot.as_ref().is_none_or(|lot| lot.holds(&t.mesh));
        let candidates: Vec<usize> = (0..models.len()).filter(|&k| fits(&models[k])).collect();
        let Some(total) = candidates.iter().map(|&k| models[k].share).reduce(|a, b| a + b) else { continue };
        let mut stream = Stream::named(seed, "assets/stand in", &[number as u64]);
        if !stream.chance(total.min(1.0)) {
            continue;
        }
        let shares: Vec<f64> = candidates.iter().map(|&k| models[k].share).collect();
        let chosen = candidates[stream.weighted(&shares)];
        let mesh = *own.entry(chosen).or_insert_with(|| {
            town.meshes.push(Arc::clone(&models[chosen].mesh));
            (town.meshes.len() - 1) as u32
        });
        let turned = lot.map_or(Affine3A::IDENTITY, |lot| lot.object_from(&models[chosen].mesh));
        let level = upright(placement, prop);
        *placement =
            Placement { object: PlacedObject::TownMesh(mesh), world_from_object: level * turned, ..placement.clone() };
    }
    town.placements = placements;
}

/// The placement without the scale of plants and poles: an imported model has its real size.
fn upright(placement: &Placement, prop: Option<Prop>) -> Affine3A {
    if prop.is_none() {
        return placement.world_from_object;
    }
    let (_, turn, at) = placement.world_from_object.to_scale_rotation_translation();
    Affine3A::from_rotation_translation(turn, at)
}

/// A lot of a building whose front lies along x, looking towards −y.
struct Lot {
    middle_x: f32,
    size: Vec3,
}

impl Lot {
    /// The lot under a mesh, if it is such a building.
    fn of(mesh: Option<&Mesh>) -> Option<Self> {
        let mesh = mesh?;
        let walls = mesh.triangle_materials.iter().filter(|&&m| {
            let tag = mesh.materials[usize::from(m)].tag;
            tag == ClassTag::Buildings
        });
        if 2 * walls.count() <= mesh.triangles.len() {
            return None;
        }
        let (low, high) = mesh.bounds();
        let in_front = low.y > -FRONT_M && high.y > FRONT_M;
        let about_the_middle = (low.x + high.x).abs() < 0.25 * (high.x - low.x);
        let size = Vec3::new(high.x - low.x, high.y, high.z);
        (in_front && about_the_middle).then_some(Self { middle_x: 0.5 * (low.x + high.x), size })
    }

    /// Whether a building fits and does not look lost.
    fn holds(&self, mesh: &Mesh) -> bool {
        let (low, high) = mesh.bounds();
        let (deep, wide) = (high.x - low.x, high.y - low.y);
        let fits = |needed: f32, there: f32| needed <= there && there <= LOOSE * needed;
        fits(wide, self.size.x) && fits(deep, self.size.y) && high.z < self.size.z + HIGHER_M
    }

    /// From the building's frame, front along +x, to the lot's.
    fn object_from(&self, mesh: &Mesh) -> Affine3A {
        let (_, high) = mesh.bounds();
        let turn = Quat::from_rotation_z(-FRAC_PI_2);
        Affine3A::from_rotation_translation(turn, Vec3::new(self.middle_x, high.x, 0.0))
    }
}
