//! Ends of surfaces that are hardly seen: both sides are of one material without a coat, about as far away, and the
//! light of sun and sky falls on them alike. Nothing between the centres of such pixels is worth a ray.

use super::sparse_centre::{Centre, SunSeen};
use crate::light::Environment;
use crate::octahedron;
use endless_scene::Surface;
use glam::Vec3A;
use std::f32::consts::PI;

/// Largest difference of light, as a share of the larger one: at most 4 of 255 in a pixel of which one side covers half.
const FAINT: f32 = 0.12;
/// Largest difference of distances, as a share.
const NEAR: f32 = 0.3;

/// The light of a day, as bright as it falls on a surface in the open.
pub(super) struct DayLight {
    /// Of the sky, klx over π.
    sky: f32,
    /// Towards the sun, and its illuminance, klx.
    sun: (Vec3A, f32),
}

impl DayLight {
    /// `None` at night: lamps shine on each place from elsewhere.
    pub(super) fn of(environment: &Environment) -> Option<Self> {
        let mean = |light: Vec3A| light.element_sum() / 3.0;
        let sun = environment.sun.as_ref().map_or((Vec3A::ZERO, 0.0), |sun| (sun.direction, mean(sun.illuminance)));
        (!environment.night).then(|| Self { sky: mean(environment.sky.mean), sun })
    }

    fn on(&self, normal: Vec3A, is_lit: bool) -> f32 {
        let (direction, sun) = self.sun;
        let direct = if is_lit { sun * normal.dot(direction).max(0.0) } else { 0.0 };
        self.sky * PI * (0.35 + 0.25 * normal.z) + direct
    }

    /// Whether the end of a surface is hardly seen towards another of the same instance and material.
    pub(super) fn is_faint(&self, own: &Centre, other: &Centre) -> bool {
        let is_lit = own.sun == SunSeen::Lit;
        let is_near = (own.distance - other.distance).abs() < NEAR * own.distance;
        if !own.is_plain || !is_near || is_lit != (other.sun == SunSeen::Lit) {
            return false;
        }
        let [a, b] = [own, other].map(|side| self.on(octahedron::unpack(side.normals.shading), is_lit));
        (a - b).abs() < FAINT * a.max(b)
    }
}

/// Whether a surface neither mirrors nor lets light through, and is no finer than pixels.
pub(super) fn is_plain(surface: Surface) -> bool {
    matches!(
        surface,
        Surface::Asphalt
            | Surface::RoadPaint
            | Surface::Paving
            | Surface::Cobbles
            | Surface::Kerb
            | Surface::Concrete
            | Surface::Grass
            | Surface::Soil
            | Surface::Gravel
            | Surface::Brick
            | Surface::Plaster
            | Surface::Stone
            | Surface::Cladding
            | Surface::RoofTile
            | Surface::FlatRoof
            | Surface::Wood
            | Surface::Plastic
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cache::packed_hit::PackedHit;
    use crate::cache::primary_hits::PackedNormals;

    fn centre(distance: f32, normal: Vec3A, sun: SunSeen) -> Centre {
        let packed = octahedron::pack(normal.normalize());
        let normals = PackedNormals { geometric: packed, shading: packed };
        Centre { distance, hit: PackedHit::of(0, 0, [0; 2]), normals, is_plain: true, sun, ..Centre::SKY }
    }

    #[test]
    fn ends_are_faint_where_light_and_distance_hardly_differ() {
        let light = DayLight { sky: 8.0, sun: (Vec3A::new(0.6, 0.0, 0.8), 90.0) };
        let wall = centre(10.0, Vec3A::X, SunSeen::Shaded);
        let bent = Vec3A::new(1.0, 0.3, 0.0);
        assert!(light.is_faint(&wall, &centre(10.1, bent, SunSeen::Never)), "a corner in the shade");
        assert!(!light.is_faint(&wall, &centre(15.0, bent, SunSeen::Shaded)), "something farther away");
        assert!(!light.is_faint(&wall, &centre(10.1, Vec3A::Z, SunSeen::Shaded)), "a sill, which the sky lights more");
        assert!(!light.is_faint(&wall, &centre(10.1, bent, SunSeen::Lit)), "the edge of a shadow");
        // In the sun a bend shows sooner.
        let [lit, turned] = [Vec3A::X, Vec3A::new(1.0, 0.0, 0.3)].map(|normal| centre(10.0, normal, SunSeen::Lit));
        assert!(light.is_faint(&lit, &lit) && !light.is_faint(&lit, &turned));
        let mirror = Centre { is_plain: false, ..wall };
        assert!(!light.is_faint(&mirror, &mirror), "what it mirrors is not known");
    }
}
