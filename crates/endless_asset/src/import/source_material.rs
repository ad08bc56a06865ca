//! glTF materials, translated to the surfaces of the catalogue.

use super::ImportError;
use super::container::GlbFile;
use super::texture::{self, TextureImage};
use endless_scene::Surface;
use endless_world::{ClassTag, math};
use glam::{Vec2, Vec4};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A material of a glTF file.
#[derive(Debug, Clone)]
pub(super) struct SourceMaterial {
    pub(super) name: String,
    pub(super) surface: Surface,
    /// Linear colour and alpha.
    pub(super) color: Vec4,
    /// Class that the file's own extras name.
    pub(super) tag: Option<ClassTag>,
    pub(super) texture: Option<TextureMapping>,
    /// Below this alpha there is nothing.
    pub(super) cutoff: Option<f32>,
}

/// A texture image with its transform (KHR_texture_transform).
#[derive(Debug, Clone)]
pub(super) struct TextureMapping {
    image: Arc<TextureImage>,
    /// Which of the surface coordinates it uses.
    pub(super) set: u32,
    offset: Vec2,
    scale: Vec2,
    turn_rad: f32,
}

impl TextureMapping {
    /// Linear colour and alpha at surface coordinates.
    pub(super) fn at(&self, uv: Vec2) -> Vec4 {
        // KHR_texture_transform: scaled, turned, moved.
        let (sin, cos) = math::sin_cos(self.turn_rad);
        let v = uv * self.scale;
        self.image.at(Vec2::new(cos * v.x + sin * v.y, cos * v.y - sin * v.x) + self.offset)
    }
}

/// The materials of a file in its order, and the default one behind them.
///
/// # Errors
/// When one of their images cannot be had.
pub(super) fn all(opened: &GlbFile<'_>) -> Result<Vec<SourceMaterial>, ImportError> {
    let mut images = BTreeMap::new();
    let mut materials = Vec::new();
    for material in opened.document.materials() {
        materials.push(source_material(opened, &material, &mut images)?);
    }
    materials.push(SourceMaterial {
        name: "default".to_owned(),
        surface: Surface::Painted,
        color: Vec4::new(0.6, 0.6, 0.6, 1.0),
        tag: None,
        texture: None,
        cutoff: None,
    });
    Ok(materials)
}

fn source_material(
    opened: &GlbFile<'_>,
    material: &gltf::Material<'_>,
    images: &mut BTreeMap<usize, Arc<TextureImage>>,
) -> Result<SourceMaterial, ImportError> {
    let pbr = material.pbr_metallic_roughness();
    let name = material.name().unwrap_or_default().to_owned();
    let mut mapping = None;
    if let Some(info) = pbr.base_color_texture() {
        let image = info.texture().source();
        let image = match images.get(&image.index()) {
            Some(known) => Arc::clone(known),
            None => {
                let decoded = Arc::new(texture::decode(opened, &image)?);
                images.insert(image.index(), Arc::clone(&decoded));
                decoded
            }
        };
        let transform = info.texture_transform();
        let placed = transform.as_ref().map_or(([0.0; 2], [1.0; 2], 0.0), |t| (t.offset(), t.scale(), t.rotation()));
        let set = transform.and_then(|t| t.tex_coord()).unwrap_or(info.tex_coord());
        let (offset, scale) = (Vec2::from_array(placed.0), Vec2::from_array(placed.1));
        mapping = Some(TextureMapping { image, set, offset, scale, turn_rad: placed.2 });
    }
    let extras = extras(material);
    let extra = |key: &str| extras.get(key).and_then(|v| v.as_str());
    let tag = extra("class").and_then(|class| class.parse().ok());
    let finite = |v: f32, or: f32| if v.is_finite() { v.clamp(0.0, 1.0) } else { or };
    let color = Vec4::from_array(pbr.base_color_factor().map(|c| finite(c, 0.5)));
    let blended = material.alpha_mode() == gltf::material::AlphaMode::Blend && color.w < 0.75;
    let transmits = material.transmission().is_some_and(|t| t.transmission_factor() > 0.4);
    let finish = PbrFinish {
        clear: blended || transmits,
        metallic: finite(pbr.metallic_factor(), 0.0),
        roughness: finite(pbr.roughness_factor(), 0.5),
    };
    let surface = extra("surface").and_then(Surface::from_name).unwrap_or_else(|| guess(&name, &finish));
    let masked = material.alpha_mode() == gltf::material::AlphaMode::Mask;
    let cutoff = masked.then(|| finite(material.alpha_cutoff().unwrap_or(0.5), 0.5));
    Ok(SourceMaterial { name, surface, color, tag, texture: mapping, cutoff })
}

fn extras(material: &gltf::Material<'_>) -> serde_json::Map<String, serde_json::Value> {
    material.extras().as_ref().and_then(|raw| serde_json::from_str(raw.get()).ok()).unwrap_or_default()
}

struct PbrFinish {
    clear: bool,
    metallic: f32,
    roughness: f32,
}

/// From what people call materials, and how they shine. Nothing that takes its look from its place (brick, asphalt) is
/// guessed: colours of the file come first.
fn guess(name: &str, finish: &PbrFinish) -> Surface {
    let name = name.to_lowercase();
    let called = |words: &[&str]| words.iter().any(|w| name.contains(w));
    if finish.clear || called(&["glass", "windshield", "windscreen", "window"]) {
        Surface::CarGlass
    } else if called(&["tire", "tyre", "rubber"]) {
        Surface::Rubber
    } else if called(&["carpaint", "car_paint", "car paint", "bodypaint"]) {
        Surface::CarPaint
    } else if called(&["leaf", "leaves", "foliage"]) {
        Surface::Foliage
    } else if called(&["plastic"]) {
        Surface::Plastic
    } else if called(&["chrome"]) || (finish.metallic > 0.7 && finish.roughness < 0.25) {
        Surface::Chrome
    } else if finish.metallic > 0.7 {
        Surface::Metal
    } else if finish.roughness > 0.8 {
        Surface::Cloth
    } else {
        Surface::Painted
    }
}
