//! Materials in glTF's terms: metallic-roughness with emission.

use endless_scene::{Material, Surface};
use gltf::json::{
    self, Index,
    material::{EmissiveFactor, PbrBaseColorFactor, PbrMetallicRoughness, StrengthFactor},
};
use serde_json::value::to_raw_value;

/// The materials met so far, each once.
#[derive(Debug, Default)]
pub(super) struct MaterialTable {
    list: Vec<Material>,
}

impl MaterialTable {
    /// The index of a material; paint of vehicles takes the vehicle's colour.
    pub(super) fn index(&mut self, material: Material, tint: Option<[f32; 3]>) -> Index<json::Material> {
        let mut material = material;
        if let Some(tint) = tint.filter(|_| material.surface == Surface::CarPaint) {
            material.base_color = [0, 1, 2].map(|k| material.base_color[k] * tint[k]);
        }
        let known = self.list.iter().position(|m| *m == material);
        let index = known.unwrap_or_else(|| {
            self.list.push(material);
            self.list.len() - 1
        });
        Index::new(index as u32)
    }

    /// All of them, in order.
    pub(super) fn described(&self) -> Vec<json::Material> {
        self.list.iter().map(describe).collect()
    }
}

/// Metallicness and roughness.
fn finish(surface: Surface) -> (f32, f32) {
    match surface {
        Surface::Chrome => (1.0, 0.12),
        Surface::Metal => (1.0, 0.45),
        Surface::CarPaint => (0.1, 0.28),
        Surface::CarGlass | Surface::WindowGlass | Surface::ShopGlass => (0.0, 0.06),
        Surface::Water => (0.0, 0.04),
        Surface::Painted | Surface::Plastic | Surface::Plate => (0.0, 0.45),
        Surface::VehicleLight(_) | Surface::SignalLens(_) | Surface::LampLens => (0.0, 0.2),
        Surface::RoofTile | Surface::RoadPaint | Surface::Leather | Surface::Skin => (0.0, 0.65),
        _ => (0.0, 0.9),
    }
}

/// What shines of its own, as a share of the base colour.
fn shines(surface: Surface) -> f32 {
    match surface {
        Surface::LampLens | Surface::LitSign => 1.0,
        Surface::SignalLens(_) => 0.6,
        _ => 0.0,
    }
}

fn describe(material: &Material) -> json::Material {
    let (metallic, roughness) = finish(material.surface);
    let color = material.base_color.map(|c| c.clamp(0.0, 1.0));
    let [r, g, b] = color;
    let light = shines(material.surface);
    let extras = serde_json::json!({ "class": material.tag.name(), "surface": material.surface.name() });
    json::Material {
        name: Some(format!("{:?} {}", material.surface, material.tag.name())),
        pbr_metallic_roughness: PbrMetallicRoughness {
            base_color_factor: PbrBaseColorFactor([r, g, b, 1.0]),
            metallic_factor: StrengthFactor(metallic),
            roughness_factor: StrengthFactor(roughness),
            ..PbrMetallicRoughness::default()
        },
        emissive_factor: EmissiveFactor(color.map(|c| c * light)),
        double_sided: material.surface == Surface::Foliage,
        extras: to_raw_value(&extras).ok(),
        ..json::Material::default()
    }
}
