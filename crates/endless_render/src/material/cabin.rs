//! What car glass shows of the inside: seats and who sits on them, the roof's lining, and daylight through the windows
//! across. Not modelled but traced through a cabin made up from the body's size (after van Dongen's interior mapping,
//! 2008).

use super::noise;
use crate::scene::SurfacePoint;
use endless_world::ClassTag;
use glam::Vec3A;

/// Share of outdoor light that falls on what is inside.
const INDOORS: f32 = 0.6;
/// Half width of a seat's back, metres.
const SEAT_HALF_M: f32 = 0.24;
/// Height of a head's centre above the seat's cushion.
const HEAD_M: f32 = 0.72;

/// Where people sit in a vehicle.
struct Cabin {
    /// Backs of the foremost seats: x in the object frame.
    front: f32,
    /// Distance between rows.
    pitch: f32,
    rows: u32,
    /// Height of the cushions.
    cushion: f32,
    /// Half the inner width, and height of the lining.
    half_width: f32,
    roof: f32,
    /// Lower edge of the windows.
    sill: f32,
    /// The ends of the room.
    x: [f32; 2],
}

impl Cabin {
    fn of(tag: ClassTag, low: Vec3A, high: Vec3A) -> Option<Self> {
        let (length, middle, height) = (high.x - low.x, 0.5 * (low.x + high.x), high.z);
        let half_width = 0.5 * (high.y - low.y).min(2.6) - 0.12;
        let roof = height - 0.10;
        match tag {
            ClassTag::Bus => Some(Self {
                front: high.x - 2.3,
                pitch: 0.85,
                rows: ((length - 3.2) / 0.85) as u32,
                cushion: 0.32 * height + 0.15,
                half_width,
                roof,
                sill: 0.32 * height,
                x: [low.x + 0.2, high.x - 0.15],
            }),
            // Lorries and vans: one row behind the windscreen.
            _ if height > 1.95 => Some(Self {
                front: high.x - (0.25 * length).min(1.7),
                pitch: 1.0,
                rows: 1,
                cushion: 0.42 * height,
                half_width,
                roof,
                sill: 0.5 * height,
                x: [high.x - (0.4 * length).min(2.3), high.x - 0.3],
            }),
            ClassTag::Car | ClassTag::Truck => Some(Self {
                front: middle + 0.02 * length - 0.25,
                pitch: 0.86,
                rows: 2,
                cushion: 0.32 * height,
                half_width,
                roof,
                sill: 0.60 * height,
                x: [middle - 0.48 * length, middle + 0.42 * length],
            }),
            _ => None,
        }
    }
}

/// Albedo that a glass seems to have, `tint` being what the pane lets through; `None` where there is no cabin.
pub(super) fn behind(point: &SurfacePoint<'_>, tint: f32) -> Option<Vec3A> {
    let instance = point.instance;
    let (low, high) = instance.body.blas.bounds();
    let cabin = Cabin::of(point.tag(), low, high)?;
    let turn = instance.world_from_object.matrix3.transpose();
    let direction = (turn * point.direction).normalize();
    let key = u32::from(instance.id.0).wrapping_mul(0x9e37_79b1);
    Some(cabin.trace(point.object_position, direction, key, instance.object != u16::MAX) * tint)
}

/// The nearest thing met so far.
struct Nearest {
    t: f32,
    color: Vec3A,
}

impl Nearest {
    fn offer(&mut self, t: f32, color: Vec3A) {
        if t > 0.02 && t < self.t {
            *self = Self { t, color };
        }
    }
}

impl Cabin {
    fn trace(&self, origin: Vec3A, direction: Vec3A, key: u32, driven: bool) -> Vec3A {
        let mut nearest = self.shell(origin, direction);
        let fabric = Vec3A::splat(0.03 + 0.16 * noise::cell1(key, 1) * noise::cell1(key, 2));
        let seats: &[f32] = if self.half_width > 1.0 { &[0.82, 0.36, -0.36, -0.82] } else { &[0.42, -0.42] };
        for row in 0..self.rows {
            let x = self.front - row as f32 * self.pitch;
            for (i, &place) in seats.iter().enumerate() {
                let y = place * self.half_width / if self.half_width > 1.0 { 1.0 } else { 0.75 };
                let cushion = Vec3A::new(x + 0.24, y, self.cushion);
                // A back and its headrest: flat, facing forward.
                let t = (x - origin.x) / direction.x;
                let at = origin + direction * t;
                let aside = (at.y - y).abs();
                let back = aside < SEAT_HALF_M && at.z < self.cushion + 0.62 && at.z > self.cushion - 0.2;
                let rest = aside < 0.13 && at.z < self.cushion + 0.82 && at.z > self.cushion;
                if back || rest {
                    let worn = if rest { 1.15 } else { 1.0 - 0.5 * (at.z < self.cushion + 0.08) as u8 as f32 };
                    nearest.offer(t, fabric * (worn * INDOORS));
                }
                let taken = match (row, i) {
                    (0, 0) => driven,
                    (0, _) => driven && noise::cell1(key, 20 + i as u32) < 0.3,
                    _ => {
                        driven && noise::cell1(key, 40 + row * 8 + i as u32) < if seats.len() > 2 { 0.4 } else { 0.12 }
                    }
                };
                if taken {
                    sitting(&mut nearest, origin, direction, cushion, key ^ (row * 4 + i as u32));
                }
            }
        }
        nearest.color
    }

    /// The room itself: lining, doors, dashboard, floor, and the windows across.
    fn shell(&self, origin: Vec3A, direction: Vec3A) -> Nearest {
        let outside = Vec3A::new(0.23, 0.25, 0.27);
        let dark = Vec3A::splat(0.025);
        let mut nearest = Nearest { t: 40.0, color: dark };
        let to = |plane: f32, o: f32, d: f32| if d.abs() < 1e-4 { -1.0 } else { (plane - o) / d };
        let height = |t: f32| origin.z + direction.z * t;
        let through = |t: f32| if height(t) > self.sill { outside } else { dark * 1.4 };
        // Across, past the pane that is looked through.
        let side = if direction.y > 0.0 { self.half_width } else { -self.half_width };
        let t = to(side, origin.y, direction.y);
        nearest.offer(t, through(t));
        let end = if direction.x > 0.0 { self.x[1] } else { self.x[0] };
        let t = to(end, origin.x, direction.x);
        nearest.offer(t, through(t));
        if direction.z > 0.0 {
            nearest.offer(to(self.roof, origin.z, direction.z), Vec3A::splat(0.12));
        } else {
            nearest.offer(to(self.cushion - 0.02, origin.z, direction.z), dark);
            // The dashboard.
            let t = to(self.cushion + 0.45, origin.z, direction.z);
            if origin.x + direction.x * t > self.front + 0.8 {
                nearest.offer(t, dark * 2.2);
            }
        }
        nearest
    }
}

/// Somebody on a seat: a head with hair, shoulders, a chest.
fn sitting(nearest: &mut Nearest, origin: Vec3A, direction: Vec3A, cushion: Vec3A, key: u32) {
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

#[cfg(test)]
mod tests {
    use super::*;

    fn cabin() -> Cabin {
        Cabin::of(ClassTag::Car, Vec3A::new(-2.2, -0.9, 0.0), Vec3A::new(2.2, 0.9, 1.45)).expect("cars have cabins")
    }

    #[test]
    fn a_driver_sits_behind_the_windscreen_of_what_is_driven() {
        let cabin = cabin();
        let from = Vec3A::new(3.0, 0.42, 1.6);
        let head = Vec3A::new(cabin.front + 0.14, 0.39, cabin.cushion + HEAD_M);
        let look = |driven| {
            (0..40u32).map(|key| cabin.trace(from, (head - from).normalize(), key * 77, driven)).sum::<Vec3A>()
        };
        assert!((look(true) - look(false)).length() > 0.1, "{} {}", look(true), look(false));
    }

    #[test]
    fn one_can_look_through_from_side_to_side() {
        let cabin = cabin();
        let from = Vec3A::new(-0.15, 0.78, 1.15);
        let across = cabin.trace(from, Vec3A::new(0.25, -1.0, 0.0).normalize(), 1, false);
        let down = cabin.trace(from, Vec3A::new(0.1, -0.6, -1.0).normalize(), 1, false);
        assert!(across.y > 3.0 * down.y, "{across} {down}");
    }
}
