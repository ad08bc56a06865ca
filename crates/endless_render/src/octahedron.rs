//! Unit vectors in four bytes (Cigolle et al. 2014, "oct32").

use glam::{Vec2, Vec3A};

/// Packs a unit vector; [`unpack`] gives it back to about 1/20,000.
pub(crate) fn pack(v: Vec3A) -> u32 {
    let p = Vec2::new(v.x, v.y) / (v.x.abs() + v.y.abs() + v.z.abs()).max(1e-9);
    let p = if v.z < 0.0 { over(p) } else { p };
    let [x, y] = [p.x, p.y].map(|c| (c * 32767.0).round() as i16 as u16);
    u32::from(x) | u32::from(y) << 16
}

/// The unit vector that was packed.
pub(crate) fn unpack(packed: u32) -> Vec3A {
    let [x, y] = [packed as u16, (packed >> 16) as u16].map(|c| f32::from(c as i16) / 32767.0);
    let z = 1.0 - x.abs() - y.abs();
    let p = if z < 0.0 { over(Vec2::new(x, y)) } else { Vec2::new(x, y) };
    Vec3A::new(p.x, p.y, z).normalize()
}

/// The lower half folds over the diagonals.
fn over(p: Vec2) -> Vec2 {
    let sign = |c: f32| if c < 0.0 { -1.0 } else { 1.0 };
    Vec2::new((1.0 - p.y.abs()) * sign(p.x), (1.0 - p.x.abs()) * sign(p.y))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::{hammersley, sphere_direction};

    #[test]
    fn what_is_packed_comes_back() {
        for i in 0..10_000 {
            let v = sphere_direction(hammersley(i, 10_000));
            assert!(unpack(pack(v)).distance(v) < 1e-4, "{v}");
        }
        for axis in [Vec3A::X, Vec3A::Y, Vec3A::Z, -Vec3A::X, -Vec3A::Y, -Vec3A::Z] {
            assert_eq!(unpack(pack(axis)), axis);
        }
    }
}
