//! What car glass shows of the inside: seats and who sits on them, the roof's lining, daylight through the windows across,
//! in buses the floor, poles and lamps under the roof. Not modelled but traced through a cabin made up from the body's
//! size (after van Dongen's interior mapping, 2008).

use super::noise;
use crate::scene::SurfaceInteraction;
use endless_world::ClassTag;
use glam::{Vec2, Vec3A};

/// Share of outdoor light that falls on what is inside.
const INDOORS: f32 = 0.6;
/// Half width of a seat, metres.
const SEAT_HALF_M: f32 = 0.23;
/// Radius of the upper corners of its back.
const ROUND_M: f32 = 0.09;
/// Brightness of what lamps under the roof shine on, of their own.
const LAMPS: f32 = 0.55;
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
    /// The ends of the cabin.
    x: [f32; 2],
    /// Whether passengers stand, too: one sees the floor, and poles to hold on to.
    standing: bool,
}

/// What a pane shows.
pub(super) struct CabinView {
    /// Albedo that the pane seems to have.
    pub(super) albedo: Vec3A,
    /// How bright the lamps under the roof make it when they are on, of a lamp's own brightness.
    pub(super) lit: Vec3A,
}

impl Cabin {
    /// Behind a pane at `pane` that looks in the direction `outwards`; object frame.
    fn of(tag: ClassTag, low: Vec3A, high: Vec3A, pane: Vec3A, outwards: Vec3A) -> Option<Self> {
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
                standing: true,
            }),
            // Windows along the sides of a van: rows as far as it goes.
            _ if height > 1.95 && pane.x < high.x - 0.42 * length && outwards.y.abs() > 0.7 => Some(Self {
                front: high.x - (0.25 * length).min(1.7),
                pitch: 0.88,
                rows: ((0.75 * length).max(length - 1.7) / 0.88) as u32,
                cushion: 0.36 * height,
                half_width,
                roof,
                sill: 0.5 * height,
                x: [low.x + 0.1, high.x - 0.3],
                standing: false,
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
                standing: false,
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
                standing: false,
            }),
            _ => None,
        }
    }
}

/// What is behind a glass that lets a share of the light `through`; `None` where there is no cabin.
pub(super) fn behind(point: &SurfaceInteraction<'_>, through: f32) -> Option<CabinView> {
    let instance = point.instance;
    let (low, high) = instance.geometry.posed.blas.bounds();
    let turn = instance.world_from_object.matrix3.transpose();
    let outwards = turn * point.geometric_normal;
    let cabin = Cabin::of(point.tag(), low, high, point.object_position, outwards)?;
    let direction = (turn * point.direction).normalize();
    let key = u32::from(instance.id.0).wrapping_mul(0x9e37_79b1);
    let met = cabin.trace(point.object_position, direction, key, instance.object != u16::MAX);
    // What is outside across is not lit by the cabin's lamps; the lamps themselves are.
    let lit = if met.lamp { Vec3A::ONE } else { met.color * LAMPS };
    Some(CabinView { albedo: met.color * through, lit: if met.outside { Vec3A::ZERO } else { lit * through } })
}

/// The nearest hit so far.
struct CabinHit {
    t: f32,
    color: Vec3A,
    /// Whether it is a lamp under the roof.
    lamp: bool,
    /// Whether it lies beyond the windows across.
    outside: bool,
}

impl CabinHit {
    fn offer(&mut self, t: f32, color: Vec3A) {
        if t > 0.02 && t < self.t {
            *self = Self { t, color, lamp: false, outside: false };
        }
    }
}

impl Cabin {
    fn trace(&self, origin: Vec3A, direction: Vec3A, key: u32, driven: bool) -> CabinHit {
        let mut nearest = self.shell(origin, direction);
        let fabric = self.fabric(key);
        let seats: &[f32] = if self.half_width > 1.0 { &[0.82, 0.36, -0.36, -0.82] } else { &[0.42, -0.42] };
        for row in 0..self.rows {
            let x = self.front - row as f32 * self.pitch;
            for (i, &place) in seats.iter().enumerate() {
                let y = place * self.half_width / if self.half_width > 1.0 { 1.0 } else { 0.75 };
                let cushion = Vec3A::new(x + 0.24, y, self.cushion);
                seat(&mut nearest, origin, direction, Vec3A::new(x, y, self.cushion), fabric);
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
            if self.standing && row % 2 == 1 {
                for y in [0.2, -0.2] {
                    pole(&mut nearest, origin, direction, Vec2::new(x + 0.1, y * self.half_width));
                }
            }
        }
        nearest
    }

    /// Colour of the seats: dark cloth or leather, in buses the operator's own.
    fn fabric(&self, key: u32) -> Vec3A {
        const OPERATORS: [[f32; 3]; 5] =
            [[0.07, 0.13, 0.36], [0.32, 0.06, 0.07], [0.09, 0.25, 0.20], [0.24, 0.12, 0.30], [0.34, 0.22, 0.07]];
        let worn = noise::cell1(key, 1);
        if self.standing {
            Vec3A::from_array(OPERATORS[(5.0 * noise::cell1(key, 3)) as usize % 5]) * (0.7 + 0.5 * worn)
        } else {
            Vec3A::splat(0.03 + 0.16 * worn * noise::cell1(key, 2))
        }
    }

    /// The cabin itself: lining, doors, dashboard, floor, and the opposite windows.
    fn shell(&self, origin: Vec3A, direction: Vec3A) -> CabinHit {
        let outside = Vec3A::new(0.23, 0.25, 0.27);
        let dark = Vec3A::splat(0.025);
        let mut nearest = CabinHit { t: 40.0, color: dark, lamp: false, outside: false };
        let to = |plane: f32, o: f32, d: f32| if d.abs() < 1e-4 { -1.0 } else { (plane - o) / d };
        let height = |t: f32| origin.z + direction.z * t;
        let walls = |nearest: &mut CabinHit, t: f32| {
            let open = height(t) > self.sill;
            nearest.offer(t, if open { outside } else { dark * 1.4 });
            nearest.outside |= nearest.t == t && open;
        };
        // Across, past the pane that is looked through.
        let side = if direction.y > 0.0 { self.half_width } else { -self.half_width };
        walls(&mut nearest, to(side, origin.y, direction.y));
        let end = if direction.x > 0.0 { self.x[1] } else { self.x[0] };
        walls(&mut nearest, to(end, origin.x, direction.x));
        if direction.z > 0.0 {
            let t = to(self.roof, origin.z, direction.z);
            nearest.offer(t, Vec3A::splat(if self.standing { 0.22 } else { 0.12 }));
            // Two rows of lamps along the roof.
            let aside = (origin.y + direction.y * t).abs() / self.half_width;
            nearest.lamp = self.standing && nearest.t == t && (0.42..0.56).contains(&aside);
        } else if self.standing {
            // The aisle, and the wheel boxes and frames that carry the seats.
            let t = to(self.cushion - 0.45, origin.z, direction.z);
            let aisle = (origin.y + direction.y * t).abs() < 0.22 * self.half_width;
            nearest.offer(t, Vec3A::new(0.10, 0.11, 0.13) * if aisle { 1.0 } else { 0.45 });
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

/// An empty seat: a cushion, a back with rounded corners and darker bolsters, a headrest. `at` is the foot of the back,
/// as high as the cushion.
fn seat(nearest: &mut CabinHit, origin: Vec3A, direction: Vec3A, at: Vec3A, fabric: Vec3A) {
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
fn pole(nearest: &mut CabinHit, origin: Vec3A, direction: Vec3A, at: Vec2) {
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
fn sitting(nearest: &mut CabinHit, origin: Vec3A, direction: Vec3A, cushion: Vec3A, key: u32) {
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

    /// Behind a side window at x.
    fn cabin_of(tag: ClassTag, high: Vec3A, x: f32) -> Option<Cabin> {
        Cabin::of(tag, high * Vec3A::new(-1.0, -1.0, 0.0), high, high.with_x(x), Vec3A::Y)
    }

    fn cabin() -> Cabin {
        cabin_of(ClassTag::Car, Vec3A::new(2.2, 0.9, 1.45), 0.0).expect("cars have cabins")
    }

    #[test]
    fn a_driver_sits_behind_the_windscreen_of_what_is_driven() {
        let cabin = cabin();
        let from = Vec3A::new(3.0, 0.42, 1.6);
        let head = Vec3A::new(cabin.front + 0.14, 0.39, cabin.cushion + HEAD_M);
        let look = |driven| {
            (0..40u32).map(|key| cabin.trace(from, (head - from).normalize(), key * 77, driven).color).sum::<Vec3A>()
        };
        assert!((look(true) - look(false)).length() > 0.1, "{} {}", look(true), look(false));
    }

    #[test]
    fn one_can_look_through_from_side_to_side() {
        let cabin = cabin();
        let from = Vec3A::new(-0.15, 0.78, 1.15);
        let across = cabin.trace(from, Vec3A::new(0.25, -1.0, 0.0).normalize(), 1, false).color;
        let down = cabin.trace(from, Vec3A::new(0.1, -0.6, -1.0).normalize(), 1, false).color;
        assert!(across.y > 3.0 * down.y, "{across} {down}");
    }

    #[test]
    fn buses_have_lamps_under_the_roof_and_seats_to_the_rear() {
        let bus = cabin_of(ClassTag::Bus, Vec3A::new(6.0, 1.27, 3.2), 0.0).expect("buses have cabins");
        let from = Vec3A::new(-2.0, 1.15, 1.6);
        let up = (0..60).map(|k| Vec3A::new(0.1, -1.0, 0.4 + 0.03 * k as f32).normalize());
        assert!(up.into_iter().any(|d| bus.trace(from, d, 5, true).lamp));
        let down = bus.trace(from, Vec3A::new(0.12, -1.0, -0.3).normalize(), 5, false);
        assert!(!down.lamp && !down.outside && down.color.max_element() > 0.02, "{}", down.color);
    }

    #[test]
    fn vans_have_rows_behind_windows_along_the_side_alone() {
        let high = Vec3A::new(2.9, 1.0, 2.5);
        let rows = |x| cabin_of(ClassTag::Car, high, x).map(|cabin| cabin.rows);
        assert_eq!(rows(1.6), Some(1));
        assert!(rows(-1.0) >= Some(4), "{:?}", rows(-1.0));
    }
}
