//! What a ray through a pane shows of a cabin.

use super::{
    hit::CabinHit,
    interior::{pole, seat, sitting},
    layout::Cabin,
};
use crate::material::noise;
use glam::{Vec2, Vec3A};

impl Cabin {
    pub(super) fn trace(&self, origin: Vec3A, direction: Vec3A, key: u32, driven: bool) -> CabinHit {
        let mut nearest = self.shell(origin, direction);
        let fabric = self.fabric(key);
        for place in self.seats() {
            let foot = Vec3A::new(place.x, place.y, self.cushion);
            seat(&mut nearest, origin, direction, foot, fabric);
            if driven && self.is_taken(&place, key) {
                let cushion = foot.with_x(place.x + 0.24);
                sitting(&mut nearest, origin, direction, cushion, key ^ (place.row * 4 + place.place));
            }
        }
        let poles = if self.standing { self.rows } else { 0 };
        for row in (1..poles).step_by(2) {
            for y in [0.2, -0.2] {
                let x = self.front - row as f32 * self.pitch;
                pole(&mut nearest, origin, direction, Vec2::new(x + 0.1, y * self.half_width));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::cabin::interior::HEAD_M;
    use endless_world::ClassTag;

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
