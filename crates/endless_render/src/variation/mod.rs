//! Surfaces as one video varies them: colours and patterns of its own (domain randomisation). Geometry and ids stay.
//!
//! What is drawn depends on the surface's colour and owner alone, so that it is the same in all frames and before all
//! cameras, and nothing has to be kept of it.

mod colors;
mod pattern;
mod texture;

use crate::scene::SurfaceInteraction;
use colors::owner;
use endless_scene::Material;
use endless_world::{ColorVariation, RandomisedPart, SceneRandomisation};
use glam::Vec3A;
pub(crate) use texture::TextureDraw;
use texture::TextureVariation;

/// How the surfaces of a scene vary.
#[derive(Debug, Clone)]
pub(crate) struct SurfaceVariation {
    colors: Option<ColorVariation>,
    textures: Option<TextureVariation>,
}

/// A surface point as it is varied.
pub(crate) struct VariedSurface {
    /// Its material with its colour.
    pub(crate) material: Material,
    /// Its pattern, if that varies.
    pub(crate) texture: Option<TextureDraw>,
}

impl SurfaceVariation {
    /// What a scene's surfaces vary; `None` where they are as they are made.
    pub(crate) fn new(randomised: &SceneRandomisation) -> Option<Self> {
        let colors = randomised.colors();
        let textures = randomised.varies(RandomisedPart::Textures);
        let textures = textures.then(|| TextureVariation::new(randomised.seed, randomised.strength));
        (colors.is_some() || textures.is_some()).then_some(Self { colors, textures })
    }

    /// The surface at a point.
    pub(crate) fn of(&self, point: &SurfaceInteraction<'_>) -> VariedSurface {
        let material = self.colors.as_ref().map_or(*point.material, |colors| colors::varied(colors, point));
        let texture = self.textures.as_ref().and_then(|textures| textures.draw(point, owner(point)));
        VariedSurface { material, texture }
    }
}

impl VariedSurface {
    /// The point with this surface; its pattern is looked up where the texture's scale says.
    pub(crate) fn point<'a>(&'a self, point: &SurfaceInteraction<'a>) -> SurfaceInteraction<'a> {
        let scale = self.texture.as_ref().map_or(1.0, |texture| texture.scale);
        let mut varied = SurfaceInteraction { material: &self.material, ..point.clone() };
        if scale != 1.0 {
            // Heights above the ground decide where dirt lies: they stay.
            varied.position *= Vec3A::new(scale, scale, 1.0);
            if !texture::lies_on_ground(self.material.surface) {
                varied.uv *= scale;
            }
        }
        varied
    }

    /// How much finer than its own pattern the varied one is.
    pub(crate) fn scale(&self) -> f32 {
        self.texture.as_ref().map_or(1.0, |texture| texture.scale)
    }

    /// The albedo that the texture makes of that of the pattern.
    pub(crate) fn albedo(&self, point: &SurfaceInteraction<'_>, albedo: Vec3A, footprint_m: f32) -> Vec3A {
        let base = Vec3A::from_array(self.material.base_color);
        self.texture.as_ref().map_or(albedo, |texture| texture.albedo(point, base, albedo, footprint_m))
    }
}
