//! Rays against a mesh, without any structure.

use endless_asset::Mesh;
use endless_world::Stream;
use glam::Vec3;

/// Triangles in columns along x, so that rays need not try them all.
pub(crate) struct Soup {
    pub(crate) corners: Vec<[Vec3; 3]>,
    low: Vec3,
    high: Vec3,
}

impl Soup {
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let corners = mesh.triangles.iter().map(|t| t.map(|i| mesh.positions[i as usize])).collect();
        let (low, high) = mesh.bounds();
        Self { corners, low, high }
    }

    /// Distance and number of the first triangle that a ray meets, from either side (Möller and Trumbore 1997).
    pub(crate) fn first(&self, origin: Vec3, direction: Vec3) -> Option<(f32, usize)> {
        let mut best: Option<(f32, usize)> = None;
        for (i, &[a, b, c]) in self.corners.iter().enumerate() {
            let (e, f) = (b - a, c - a);
            let p = direction.cross(f);
            let determinant = e.dot(p);
            if determinant.abs() < 1e-12 {
                continue;
            }
            let s = origin - a;
            let u = s.dot(p) / determinant;
            if !(0.0..=1.0).contains(&u) {
                continue;
            }
            let q = s.cross(e);
            let v = direction.dot(q) / determinant;
            let t = f.dot(q) / determinant;
            if v >= 0.0 && u + v <= 1.0 && t > 1e-5 && best.is_none_or(|(known, _)| t < known) {
                best = Some((t, i));
            }
        }
        best
    }

    pub(crate) fn normal(&self, i: usize) -> Vec3 {
        let [a, b, c] = self.corners[i];
        (b - a).cross(c - a).normalize_or_zero()
    }

    /// Of so many rays from where a camera may hang: how many met something, and how many of these its inner side.
    pub(crate) fn inner_sides(&self, rays: usize, name: &str) -> (usize, usize) {
        let (mut met, mut inner) = (0, 0);
        let mut stream = Stream::named(7, name, &[]);
        let middle = 0.5 * (self.low + self.high);
        for _ in 0..rays {
            let azimuth = stream.range_f32(0.0, std::f32::consts::TAU);
            let up = stream.range_f32(0.1, 1.3);
            let (sin, cos) = endless_world::math::sin_cos(azimuth);
            let (up_sin, up_cos) = endless_world::math::sin_cos(up);
            let from = middle + 30.0 * Vec3::new(cos * up_cos, sin * up_cos, up_sin);
            let unit = Vec3::new(stream.f32(), stream.f32(), stream.f32());
            let direction = (self.low + (self.high - self.low) * unit - from).normalize();
            if let Some((_, i)) = self.first(from, direction) {
                met += 1;
                inner += usize::from(self.normal(i).dot(direction) > 0.02);
            }
        }
        (met, inner)
    }
}
