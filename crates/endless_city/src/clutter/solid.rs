//! Geometric solids that stand on the ground, one metre in each direction.

use endless_scene::{Material, Mesh, MeshBuilder};
use endless_world::math;
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// The form of a solid.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum SolidForm {
    Box,
    Cylinder,
    Cone,
    Pyramid,
    Prism,
    Ball,
}

impl SolidForm {
    /// All of them.
    pub(super) const ALL: [Self; 6] = [Self::Box, Self::Cylinder, Self::Cone, Self::Pyramid, Self::Prism, Self::Ball];
}

/// Its mesh: from −0.5 to 0.5 across, from 0 to 1 up.
pub(super) fn solid(form: SolidForm, material: Material) -> Mesh {
    // Radii at heights, from the bottom up, about a ring of so many corners.
    let (corners, outline): (u32, Vec<Vec2>) = match form {
        SolidForm::Box => {
            let mut mesh = MeshBuilder::new();
            mesh.cuboid(Vec3::new(-0.5, -0.5, 0.0), Vec3::new(0.5, 0.5, 1.0), material);
            return mesh.finish();
        }
        SolidForm::Cylinder => (20, vec![Vec2::new(0.5, 0.0), Vec2::new(0.5, 1.0), Vec2::new(0.0, 1.0)]),
        SolidForm::Cone => (20, vec![Vec2::new(0.5, 0.0), Vec2::new(0.0, 1.0)]),
        SolidForm::Pyramid => (4, vec![Vec2::new(0.5, 0.0), Vec2::new(0.0, 1.0)]),
        SolidForm::Prism => (6, vec![Vec2::new(0.5, 0.0), Vec2::new(0.5, 1.0), Vec2::new(0.0, 1.0)]),
        SolidForm::Ball => {
            let ring = |i: u32| {
                let (sin, cos) = math::sin_cos(PI * i as f32 / 10.0);
                Vec2::new(0.5 * sin, 0.5 - 0.5 * cos)
            };
            (20, (0..=10).map(ring).collect())
        }
    };
    let at = |i: u32, ring: Vec2| {
        let (sin, cos) = math::sin_cos(TAU * (i % corners) as f32 / corners as f32);
        Vec3::new(ring.x * cos, ring.x * sin, ring.y)
    };
    let mut mesh = MeshBuilder::new();
    for rings in outline.windows(2) {
        let [low, high] = [rings[0], rings[1]];
        for i in 0..corners {
            if low.x > 1e-4 {
                mesh.triangle([at(i, low), at(i + 1, low), at(i, high)], [Vec2::ZERO; 3], material);
            }
            if high.x > 1e-4 {
                mesh.triangle([at(i + 1, low), at(i + 1, high), at(i, high)], [Vec2::ZERO; 3], material);
            }
        }
    }
    mesh.finish()
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_scene::Surface;
    use endless_world::ClassTag;

    #[test]
    fn solids_stand_on_the_ground_and_face_outwards() {
        for form in SolidForm::ALL {
            let mesh = solid(form, Material::new(Surface::Plastic, [0.5; 3], ClassTag::Dynamic));
            let (low, high) = mesh.bounds();
            assert!(low.z.abs() < 1e-5 && (high.z - 1.0).abs() < 1e-5, "{form:?}");
            assert!(low.x >= -0.5001 && high.y <= 0.5001 && high.x > 0.4, "{form:?}");
            let middle = Vec3::new(0.0, 0.0, 0.4);
            for triangle in &mesh.triangles {
                let [a, b, c] = triangle.map(|i| mesh.positions[i as usize]);
                let normal = (b - a).cross(c - a);
                assert!(normal.length() > 1e-6 && normal.dot((a + b + c) / 3.0 - middle) > 0.0, "{form:?}");
            }
        }
    }
}
