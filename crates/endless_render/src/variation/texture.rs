//! Patterns of a video's own: those of a surface at another scale and contrast, or random ones in their place, as Tobin
//! et al. (2017) draw them.

use super::pattern::Pattern;
use crate::scene::SurfaceInteraction;
use endless_scene::Surface;
use endless_world::{ColorVariation, InstanceId, Stream, math};
use glam::Vec3A;

/// How far patterns vary in a video.
#[derive(Debug, Clone)]
pub(super) struct TextureVariation {
    stream: Stream,
    strength: f32,
    /// Of random patterns.
    colors: ColorVariation,
}

/// The pattern of one surface.
pub(crate) struct TextureDraw {
    /// How much finer the surface's own pattern is.
    pub(super) scale: f32,
    /// Of the surface's own pattern, over what it has.
    contrast: f32,
    /// What stands in its place, in two linear colours.
    pattern: Option<(Pattern, [Vec3A; 2])>,
}

impl TextureVariation {
    pub(super) fn new(seed: u64, strength: f32) -> Self {
        let colors = ColorVariation::new(seed ^ 0x7e47, strength);
        Self { stream: Stream::named(seed, "randomised textures", &[]), strength, colors }
    }

    /// The pattern of an owner's surface at a point; `None` where it is as it is made: objects, glass, lights, paint on
    /// the road and signs.
    pub(super) fn draw(&self, point: &SurfaceInteraction<'_>, owner: u64) -> Option<TextureDraw> {
        let surface = point.material.surface;
        if point.instance.id != InstanceId::STUFF || !is_textured(surface) {
            return None;
        }
        let color = point.material.base_color;
        let key = color.iter().fold(owner, |key, c| key.rotate_left(19) ^ u64::from(c.to_bits()));
        let mut random = self.stream.fork(key);
        let strength = self.strength;
        let scale = math::exp2(random.range_f32(-1.4, 1.4) * strength);
        let contrast = 1.0 + (random.range_f32(-1.0, 1.6)) * strength;
        let replaced = random.f32() < strength - 0.2;
        let pattern = replaced.then(|| {
            let colors = [1, 2].map(|n| Vec3A::from(self.colors.linear(owner.rotate_left(7) ^ n, color)));
            (Pattern::draw(&mut random), colors)
        });
        Some(TextureDraw { scale, contrast, pattern })
    }
}

impl TextureDraw {
    /// The albedo in place of that of the surface's own pattern on its base colour.
    pub(super) fn albedo(&self, point: &SurfaceInteraction<'_>, base: Vec3A, own: Vec3A, footprint_m: f32) -> Vec3A {
        match &self.pattern {
            None => (base + (own - base) * self.contrast).max(base * 0.1),
            Some((pattern, [a, b])) => {
                let share = pattern.at(point.position, point.geometric_normal, footprint_m);
                *a + (*b - *a) * share
            }
        }
    }
}

/// Surfaces of the ground, whose patterns lie in the plane of the map.
pub(super) fn lies_on_ground(surface: Surface) -> bool {
    matches!(
        surface,
        Surface::Asphalt
            | Surface::Paving
            | Surface::Cobbles
            | Surface::Kerb
            | Surface::Concrete
            | Surface::Grass
            | Surface::Soil
            | Surface::Gravel
    )
}

fn is_textured(surface: Surface) -> bool {
    lies_on_ground(surface)
        || matches!(
            surface,
            Surface::Brick
                | Surface::Plaster
                | Surface::Stone
                | Surface::Cladding
                | Surface::RoofTile
                | Surface::FlatRoof
                | Surface::Wood
        )
}
