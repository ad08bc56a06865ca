//! Lamps that an entry names: surfaces of materials, or small lenses laid on the body.

use super::source_material::SourceMaterial;
use super::{AssetEntry, ImportError, LampPlaces};
use endless_scene::{LightSlot, Material, Mesh, Surface};
use endless_world::{ClassTag, math};
use glam::{Vec2, Vec3};
use std::f32::consts::TAU;

/// Radius of a lens and how far it stands out, metres.
const RADIUS_M: f32 = 0.055;
const OUT_M: f32 = 0.004;
const SIDES: u32 = 12;
/// Lenses lie on the surface; further than this from it they are a mistake, metres.
const NEAR_M: f32 = 0.6;

fn color(slot: LightSlot) -> [f32; 3] {
    match slot {
        LightSlot::Head | LightSlot::Reverse => [0.75, 0.76, 0.78],
        LightSlot::Tail | LightSlot::Brake => [0.45, 0.012, 0.012],
        LightSlot::IndicatorLeft | LightSlot::IndicatorRight => [0.62, 0.24, 0.02],
        LightSlot::BeaconLeft | LightSlot::BeaconRight => [0.015, 0.07, 0.62],
    }
}

/// Finds a material by its name.
pub(super) fn named(materials: &[SourceMaterial], name: &str, field: &'static str) -> Result<Vec<usize>, ImportError> {
    let found: Vec<usize> = (0..materials.len()).filter(|&k| materials[k].name == name).collect();
    if found.is_empty() {
        let mut known: Vec<&str> = materials.iter().map(|c| c.name.as_str()).take(8).collect();
        known.dedup();
        let (name, known) = (name.chars().take(60).collect(), known.join(", "));
        return Err(ImportError::NoMaterial { field, name, known });
    }
    Ok(found)
}

/// Makes lamps of the materials that an entry names.
pub(super) fn of_materials(entry: &AssetEntry, materials: &mut [SourceMaterial]) -> Result<(), ImportError> {
    for (&slot, places) in &entry.lights {
        let LampPlaces::Materials(names) = places else { continue };
        for name in names {
            for k in named(materials, name, "lights")? {
                materials[k].surface = Surface::VehicleLight(slot);
                materials[k].texture = None;
            }
        }
    }
    Ok(())
}

/// Lays lenses on the body.
///
/// # Errors
/// [`ImportError::LampOffBody`].
pub(super) fn at_places(entry: &AssetEntry, body: &mut Mesh, tag: ClassTag) -> Result<(), ImportError> {
    for (&slot, places) in &entry.lights {
        let LampPlaces::Places(places) = places else { continue };
        for &at in places {
            let place = Vec3::from_array(at);
            let outwards = if place.x >= 0.0 { 1.0 } else { -1.0 };
            let x = met(body, place, outwards).filter(|x| (x - place.x).abs() < NEAR_M);
            let x = x.ok_or(ImportError::LampOffBody { at })?;
            let lens = Material::new(Surface::VehicleLight(slot), color(slot), tag);
            disc(body, Vec3::new(x + outwards * OUT_M, place.y, place.z), outwards, lens);
        }
    }
    Ok(())
}

/// x where a line along x meets the body from outside.
fn met(body: &Mesh, place: Vec3, outwards: f32) -> Option<f32> {
    if !place.is_finite() {
        return None;
    }
    let at = Vec2::new(place.y, place.z);
    let crossing = |t: &[u32; 3]| {
        let corners = t.map(|i| body.positions[i as usize]);
        let [a, b, c] = corners.map(|p| Vec2::new(p.y, p.z));
        let whole = (b - a).perp_dot(c - a);
        if whole == 0.0 {
            return None;
        }
        let (u, v) = ((at - a).perp_dot(c - a) / whole, (b - a).perp_dot(at - a) / whole);
        let inside = u >= 0.0 && v >= 0.0 && u + v <= 1.0;
        inside.then(|| corners[0].x + u * (corners[1].x - corners[0].x) + v * (corners[2].x - corners[0].x))
    };
    body.triangles.iter().filter_map(crossing).max_by(|p, q| (p * outwards).total_cmp(&(q * outwards)))
}

fn disc(body: &mut Mesh, middle: Vec3, outwards: f32, material: Material) {
    let base = body.positions.len() as u32;
    let m = body.material_index(material);
    for k in 0..=SIDES {
        let rim = if k == 0 { (0.0, 0.0) } else { math::sin_cos(TAU * (k - 1) as f32 / SIDES as f32) };
        body.positions.push(middle + RADIUS_M * Vec3::new(0.0, rim.1, rim.0));
        body.normals.push(Vec3::X * outwards);
        body.uvs.push(Vec2::ZERO);
    }
    for k in 0..SIDES {
        let (p, q) = (base + 1 + k, base + 1 + (k + 1) % SIDES);
        body.triangles.push(if outwards > 0.0 { [base, p, q] } else { [base, q, p] });
        body.triangle_materials.push(m);
    }
}
