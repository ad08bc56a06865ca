//! Props and buildings.

use super::entry::{AssetClass, AssetEntry};
use super::error::ImportError;
use super::model::SourceModel;
use super::texture_bake::TextureBaker;
use crate::{Prop, prop_mesh};
use endless_scene::Mesh;
use endless_world::ClassTag;
use glam::Vec3;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Width and height may differ this much from what the entry says.
pub(super) const SIZE_TOLERANCE: f32 = 0.12;

/// A prop or a building from a file.
#[derive(Debug, Clone)]
pub struct ImportedStaticModel {
    /// Name in the catalogue.
    pub name: String,
    /// What it stands for: a prop, or `None` for a building.
    pub prop: Option<Prop>,
    /// Share of the places of its class that it takes.
    pub share: f64,
    /// Its front looks along +x; origin on the ground, under the middle of its footprint.
    pub mesh: Arc<Mesh>,
}

/// Brings a model to its real length with its footprint's middle at the origin; returns length, width and height.
///
/// # Errors
/// When it has none.
pub(super) fn stand(model: &mut SourceModel, length_m: f32) -> Result<Vec3, ImportError> {
    let (low, high) = model.bounds();
    let extent = high - low;
    if !(extent.x > 0.0 && extent.is_finite()) {
        return Err(ImportError::Empty);
    }
    let scale = length_m / extent.x;
    let middle = 0.5 * (low + high);
    model.place(scale, -scale * Vec3::new(middle.x, middle.y, low.z));
    let size = extent * scale;
    if size.is_finite() { Ok(size) } else { Err(ImportError::Empty) }
}

pub(super) fn make(
    entry: &AssetEntry,
    kind: AssetClass,
    mut model: SourceModel,
) -> Result<ImportedStaticModel, ImportError> {
    let size = stand(&mut model, entry.size[0])?;
    let off = |k: usize| (size[k] - entry.size[k]).abs() > SIZE_TOLERANCE * entry.size[k] + 0.02;
    if off(1) || off(2) {
        return Err(ImportError::Size { found: size.to_array(), stated: entry.size });
    }
    let prop = if let AssetClass::Prop(prop) = kind { Some(prop) } else { None };
    let tag = prop.map_or(ClassTag::Buildings, |prop| usual_tag(&prop_mesh::prop(prop, 0)));
    let mut baker = TextureBaker::new(&model.materials, tag, true);
    model.parts.iter().for_each(|part| baker.add(part, Vec3::ZERO));
    let mesh = baker.finish();
    if mesh.triangles.is_empty() {
        return Err(ImportError::Empty);
    }
    Ok(ImportedStaticModel { name: entry.asset_name(), prop, share: entry.share, mesh: Arc::new(mesh) })
}

/// The class that most of a mesh's triangles carry.
fn usual_tag(mesh: &Mesh) -> ClassTag {
    let mut counts = BTreeMap::new();
    for &m in &mesh.triangle_materials {
        *counts.entry(mesh.materials[usize::from(m)].tag.value()).or_insert(0u32) += 1;
    }
    let usual = counts.into_iter().max_by_key(|c| c.1).map(|c| c.0);
    usual.and_then(ClassTag::from_value).unwrap_or(ClassTag::Static)
}
