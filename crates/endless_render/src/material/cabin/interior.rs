//! Seats, people on them and poles, as simple bodies.

use super::hit::{CabinHit, INDOORS};
use crate::material::noise;
use glam::{Vec2, Vec3A};

/// Half width of a seat, metres.
const SEAT_HALF_M: f32 = 0.23;
/// Radius of the upper corners of its back.
const ROUND_M: f32 = 0.09;
/// Height of a head's centre above the seat's cushion.
pub(super) const HEAD_M: f32 = 0.72;

/// An empty seat: a cushion, a back with rounded corners and darker bolsters, a headrest. `at` is the foot of the back,
/// as high as the cushion.
pub(super) fn seat(nearest: &mut CabinHit, origin: Vec3A, direction: Vec3A, at: Vec3A, fabric: Vec3A) {
    let fabric = fabric * INDOORS;
    let half = Vec3A::new(0.05, SEAT_HALF_M, 0.41);
    let back = at + Vec3A::new(-0.02, 0.0, 0.21);
    if let Some((t, axis)) = slab(origin, direction, back, half) {
        let from = origin + direction * t - back;
        let (aside, up) = (from.y.abs(), from.z);
        let corner = Vec2::new(aside - SEAT_HALF_M + ROUND_M, up - half.z + ROUND_M).max(Vec2::ZERO);
        if axis != 0 || corner.length() < ROUND_M {
            let bolster = if aside > 0.15 { 0.72 } else { 1.0 };
            let seam = if (up - 0.02).abs() < 0.012 { 0.6 } else { 1.0 };
            // Less light reaches down between the rows.
            let low = 0.55 + 0.45 * ((up + half.z) / (2.0 * half.z)).clamp(0.0, 1.0);
            nearest.offer(t, fabric * if axis == 0 { bolster * seam * low } else { 0.65 * low });
        }
    }
    let rest = at + Vec3A::new(-0.03, 0.0, 0.74);
    if let Some((t, normal)) = ellipsoid(origin, direction, rest, Vec3A::new(0.06, 0.14, 0.11)) {
        nearest.offer(t, fabric * (0.95 + 0.25 * normal.z));
    }
    let cushion = at + Vec3A::new(0.26, 0.0, -0.07);
    if let Some((t, axis)) = slab(origin, direction, cushion, Vec3A::new(0.23, SEAT_HALF_M, 0.07)) {
        nearest.offer(t, fabric * if axis == 2 { 0.8 } else { 0.45 });
    }
}

/// A yellow pole from floor to roof.
pub(super) fn pole(nearest: &mut CabinHit, origin: Vec3A, direction: Vec3A, at: Vec2) {
    const RADIUS_M: f32 = 0.018;
    let (from, way) = (at - Vec2::new(origin.x, origin.y), Vec2::new(direction.x, direction.y));
    let t = from.dot(way) / way.length_squared().max(1e-6);
    if (from - way * t).length_squared() < RADIUS_M * RADIUS_M {
        nearest.offer(t, Vec3A::new(0.62, 0.44, 0.04) * INDOORS);
    }
}

/// Where a ray enters a box, and through the sides across which axis.
fn slab(origin: Vec3A, direction: Vec3A, centre: Vec3A, half: Vec3A) -> Option<(f32, usize)> {
    let (middle, reach) = ((centre - origin) / direction, (half / direction).abs());
    let near = middle - reach;
    let t = near.max_element();
    (t <= (middle + reach).min_element()).then(|| (t, near.max_position()))
}

/// Somebody on a seat: a head with hair, shoulders, a chest.
pub(super) fn sitting(nearest: &mut CabinHit, origin: Vec3A, direction: Vec3A, cushion: Vec3A, key: u32) {
    let clothes = noise::cell1(key, 61);
    let hue = noise::cell1(key, 62);
    let cloth = Vec3A::new(0.5 - 0.35 * hue, 0.42 - 0.2 * (hue - 0.5).abs(), 0.2 + 0.35 * hue)
        * (0.08 + 0.7 * clothes * clothes);
    let skin = Vec3A::new(0.55, 0.36, 0.27) * (0.25 + 0.75 * noise::cell1(key, 63));
    let hair = Vec3A::new(0.06, 0.045, 0.035) * (0.4 + noise::cell1(key, 64));
    let head = cushion + Vec3A::new(-0.10, 0.0, HEAD_M - 0.02);
    if let Some((t, normal)) = ellipsoid(origin, direction, head, Vec3A::new(0.10, 0.08, 0.125)) {
        let color = if normal.x > 0.15 && normal.z < 0.55 { skin } else { hair };
        nearest.offer(t, color * (INDOORS * (0.7 + 0.3 * normal.z)));
    }
    let chest = cushion + Vec3A::new(-0.14, 0.0, 0.30);
    if let Some((t, normal)) = ellipsoid(origin, direction, chest, Vec3A::new(0.14, 0.23, 0.33)) {
        nearest.offer(t, cloth * (INDOORS * (0.65 + 0.35 * normal.z)));
    }
}

/// Where a ray enters an ellipsoid, and the direction outwards there in the ellipsoid's own proportions.
fn ellipsoid(origin: Vec3A, direction: Vec3A, centre: Vec3A, radii: Vec3A) -> Option<(f32, Vec3A)> {
    let (o, d) = ((origin - centre) / radii, direction / radii);
    let (a, b, c) = (d.length_squared(), o.dot(d), o.length_squared() - 1.0);
    let root = b * b - a * c;
    (root > 0.0).then(|| {
        let t = (-b - root.sqrt()) / a;
        (t, o + d * t)
    })
}
