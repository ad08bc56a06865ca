//! Boxes, lathes, tubes, ellipsoids and lofts.

use super::Sculpt;
use endless_scene::Material;
use endless_world::math;
use glam::{Vec2, Vec3};
use std::f32::consts::{FRAC_PI_2, PI, TAU};

impl Sculpt {
    /// A box with bevelled edges; `bevel` 0 makes it sharp.
    pub(crate) fn cuboid(low: Vec3, high: Vec3, bevel: f32, material: Material) -> Self {
        let size = high - low;
        let b = bevel.min(0.49 * size.min_element());
        let mut s = Self::new();
        if b <= 0.0 {
            let c = |x: bool, y: bool, z: bool| Vec3::select(glam::BVec3::new(x, y, z), high, low);
            let (o, i) = (false, true);
            s.quad([c(o, o, o), c(i, o, o), c(i, o, i), c(o, o, i)], material);
            s.quad([c(i, o, o), c(i, i, o), c(i, i, i), c(i, o, i)], material);
            s.quad([c(i, i, o), c(o, i, o), c(o, i, i), c(i, i, i)], material);
            s.quad([c(o, i, o), c(o, o, o), c(o, o, i), c(o, i, i)], material);
            s.quad([c(o, o, i), c(i, o, i), c(i, i, i), c(o, i, i)], material);
            s.quad([c(o, i, o), c(i, i, o), c(i, o, o), c(o, o, o)], material);
            return s;
        }
        // Rounded in plan and in section: rings of a rounded rectangle.
        let ring = |inset: f32, z: f32| -> Vec<Vec3> {
            let (l, h) = (low + Vec3::splat(inset), high - Vec3::splat(inset));
            let k = (b - inset).max(b * 0.3) * 0.6;
            [
                (l.x + k, l.y),
                (h.x - k, l.y),
                (h.x, l.y + k),
                (h.x, h.y - k),
                (h.x - k, h.y),
                (l.x + k, h.y),
                (l.x, h.y - k),
                (l.x, l.y + k),
            ]
            .map(|(x, y)| Vec3::new(x, y, z))
            .to_vec()
        };
        let rows = [
            ring(b, low.z),
            ring(b * 0.3, low.z + b * 0.3),
            ring(0.0, low.z + b),
            ring(0.0, high.z - b),
            ring(b * 0.3, high.z - b * 0.3),
            ring(b, high.z),
        ];
        s.grid(&rows, true, material);
        s.polygon(&rows[5], material);
        s.polygon(&rows[0].iter().rev().copied().collect::<Vec<_>>(), material);
        s.smooth(50.0)
    }

    /// A surface of revolution about z: profile of (radius, z) from bottom to top as seen on the outside.
    pub(crate) fn lathe(profile: &[(f32, f32)], segments: usize, crease_deg: f32, material: Material) -> Self {
        let rows: Vec<Vec<Vec3>> = profile
            .iter()
            .map(|&(r, z)| {
                (0..segments)
                    .map(|i| {
                        let (sin, cos) = math::sin_cos(TAU * i as f32 / segments as f32);
                        Vec3::new(r * cos, r * sin, z)
                    })
                    .collect()
            })
            .collect();
        let mut s = Self::new();
        s.grid(&rows, true, material);
        s.smooth(crease_deg)
    }

    /// An upright cylinder or cone frustum with both caps.
    pub(crate) fn post(base: Vec3, height: f32, r0: f32, r1: f32, segments: usize, material: Material) -> Self {
        Self::lathe(&[(0.0, 0.0), (r0, 0.0), (r1, height), (0.0, height)], segments, 40.0, material).at(base)
    }

    /// An ellipsoid with these semi-axes.
    pub(crate) fn ellipsoid(centre: Vec3, radii: Vec3, segments: usize, material: Material) -> Self {
        let n = segments / 2;
        let profile: Vec<(f32, f32)> = (0..=n)
            .map(|i| {
                let (sin, cos) = math::sin_cos(-FRAC_PI_2 + PI * i as f32 / n as f32);
                (cos.max(0.0), sin)
            })
            .collect();
        Self::lathe(&profile, segments, 180.0, material).placed(glam::Affine3A::from_scale_rotation_translation(
            radii,
            glam::Quat::IDENTITY,
            centre,
        ))
    }

    /// A round tube along a path, radius a point; the ends are closed.
    pub(crate) fn tube(path: &[(Vec3, f32)], segments: usize, material: Material) -> Self {
        let sections: Vec<(Vec3, Vec2)> = path.iter().map(|&(p, r)| (p, Vec2::splat(r))).collect();
        Self::sweep(&sections, Vec3::ZERO, segments, 2.0, true, material)
    }

    /// Superelliptic sections swept along a path. `sideways` is the direction of the first semi-axis (zero: any); the
    /// exponent is 2 for ellipses and grows towards boxes.
    pub(crate) fn sweep(
        sections: &[(Vec3, Vec2)],
        sideways: Vec3,
        segments: usize,
        exponent: f32,
        caps: bool,
        material: Material,
    ) -> Self {
        let n = sections.len();
        let mut side = sideways;
        let mut rows = Vec::with_capacity(n);
        for i in 0..n {
            let before = sections[i.saturating_sub(1)].0;
            let after = sections[(i + 1).min(n - 1)].0;
            let forward = (after - before).normalize_or(Vec3::Z);
            if side == Vec3::ZERO {
                side = forward.any_orthonormal_vector();
            }
            let u = (side - forward * side.dot(forward)).normalize_or(forward.any_orthonormal_vector());
            if sideways == Vec3::ZERO {
                side = u;
            }
            let v = forward.cross(u);
            let (centre, radii) = sections[i];
            rows.push(
                (0..segments)
                    .map(|k| {
                        let (sin, cos) = math::sin_cos(TAU * k as f32 / segments as f32);
                        let bend =
                            |c: f32| if exponent == 2.0 { c } else { c.signum() * math::pow(c.abs(), 2.0 / exponent) };
                        centre + u * radii.x * bend(cos) + v * radii.y * bend(sin)
                    })
                    .collect::<Vec<_>>(),
            );
        }
        let mut s = Self::new();
        s.grid(&rows, true, material);
        if caps {
            s.polygon(&rows[n - 1], material);
            s.polygon(&rows[0].iter().rev().copied().collect::<Vec<_>>(), material);
        }
        s.smooth(55.0)
    }

    /// A prism over a polygon in the (x, z) plane from y = `from` to y = `to`. The polygon is given counter-clockwise
    /// as seen from −y (x to the right, z up).
    pub(crate) fn slab(polygon: &[Vec2], from: f32, to: f32, crease_deg: f32, material: Material) -> Self {
        let near: Vec<Vec3> = polygon.iter().map(|p| Vec3::new(p.x, from, p.y)).collect();
        let far: Vec<Vec3> = polygon.iter().map(|p| Vec3::new(p.x, to, p.y)).collect();
        let mut s = Self::new();
        s.polygon(&near, material);
        s.polygon(&far.iter().rev().copied().collect::<Vec<_>>(), material);
        s.grid(&[far, near], true, material);
        s.smooth(crease_deg)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_scene::Surface;
    use endless_world::ClassTag;

    fn volume(s: &Sculpt) -> f32 {
        s.faces.iter().map(|f| f.corners[0].dot(f.corners[1].cross(f.corners[2])) / 6.0).sum()
    }

    #[test]
    fn solids_are_closed_and_face_outwards() {
        let m = Material::new(Surface::Metal, [0.5; 3], ClassTag::Static);
        let v = |s: Sculpt| volume(&s);
        assert!((v(Sculpt::cuboid(Vec3::ZERO, Vec3::ONE, 0.0, m)) - 1.0).abs() < 1e-5);
        let bevelled = v(Sculpt::cuboid(Vec3::ZERO, Vec3::ONE, 0.05, m));
        assert!(bevelled > 0.95 && bevelled < 1.0, "{bevelled}");
        assert!((v(Sculpt::ellipsoid(Vec3::ONE, Vec3::splat(1.0), 48, m)) - 4.0 / 3.0 * PI).abs() < 0.05);
        assert!((v(Sculpt::post(Vec3::X, 2.0, 1.0, 1.0, 48, m)) - TAU).abs() < 0.05);
        let pipe = Sculpt::tube(&[(Vec3::ZERO, 0.5), (Vec3::X, 0.5), (Vec3::new(2.0, 0.0, 0.0), 0.5)], 32, m);
        assert!((v(pipe) - PI * 0.5).abs() < 0.02);
        let square = [Vec2::ZERO, Vec2::X, Vec2::ONE, Vec2::Y];
        assert!((v(Sculpt::slab(&square, 1.0, 3.0, 30.0, m)) - 2.0).abs() < 1e-5);
    }
}
