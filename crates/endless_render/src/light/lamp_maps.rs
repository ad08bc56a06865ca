//! What the static scene hides from each lamp, as a map of distances (Williams 1978): for surfaces whose shadows by lamps
//! need not be sharp, those that move and those in mirrors.

use super::lamps::PointLamp;
use crate::accel::{Ray, Tlas};
use glam::{Vec2, Vec3A};
use rayon::prelude::*;
use std::sync::Arc;

/// Directions along each edge of a map.
const EDGE: usize = 192;
/// What is nearer than this to the surface that the lamp sees is lit, metres.
const BIAS_M: f32 = 0.3;
/// Lamps farther than this from what the camera sees have no map, metres.
const MARGIN_M: f32 = 48.0;

/// Maps of the lamps around one camera's view.
#[derive(Debug, Clone, Default)]
pub(crate) struct LampMaps {
    /// By lamp.
    maps: Vec<Option<Arc<[f32]>>>,
}

impl LampMaps {
    /// Maps the surroundings of the lamps over and around a rectangle of ground.
    pub(crate) fn bake(accel: &Tlas, lamps: &[PointLamp], low: Vec2, high: Vec2, range_m: f32) -> Self {
        let mut maps = Self::default();
        maps.reach(accel, lamps, low, high, range_m);
        maps
    }

    /// Adds those of the same lamps around another rectangle that have none yet.
    pub(crate) fn reach(&mut self, accel: &Tlas, lamps: &[PointLamp], low: Vec2, high: Vec2, range_m: f32) {
        let near = |lamp: &PointLamp| {
            let at = Vec2::new(lamp.position.x, lamp.position.y);
            at.clamp(low, high).distance_squared(at) < MARGIN_M * MARGIN_M
        };
        self.maps.resize(lamps.len(), None);
        self.maps.par_iter_mut().zip(lamps).with_max_len(1).for_each(|(kept, lamp)| {
            if kept.is_none() && near(lamp) {
                *kept = Some(map(accel, lamp.position, range_m).into());
            }
        });
    }

    /// Share of a lamp's light that the town lets pass to a point below it; `None` if the lamp has no map. `to_lamp` is
    /// the unit direction to the lamp.
    pub(crate) fn lit(&self, lamp: usize, to_lamp: Vec3A, distance: f32) -> Option<f32> {
        let map = self.maps.get(lamp)?.as_ref()?;
        let place = (fold(-to_lamp) * EDGE as f32 - 0.5).clamp(Vec2::ZERO, Vec2::splat((EDGE - 1) as f32));
        let (x, y) = ((place.x as usize).min(EDGE - 2), (place.y as usize).min(EDGE - 2));
        let (u, v) = (place.x - x as f32, place.y - y as f32);
        let free = |dx: usize, dy: usize| f32::from(distance < map[(y + dy) * EDGE + x + dx] + BIAS_M);
        let (top, bottom) = (free(0, 0) * (1.0 - u) + free(1, 0) * u, free(0, 1) * (1.0 - u) + free(1, 1) * u);
        Some(top * (1.0 - v) + bottom * v)
    }
}

fn map(accel: &Tlas, position: Vec3A, range_m: f32) -> Vec<f32> {
    let mut map = vec![f32::MAX; EDGE * EDGE];
    for (i, eight) in map.chunks_exact_mut(8).enumerate() {
        let rays: [Ray; 8] = std::array::from_fn(|k| {
            let (x, y) = ((i * 8 + k) % EDGE, (i * 8 + k) / EDGE);
            let direction = unfold(Vec2::new(x as f32 + 0.5, y as f32 + 0.5) / EDGE as f32);
            Ray { origin: position, direction, tmax: range_m }
        });
        for (distance, hit) in eight.iter_mut().zip(accel.closest8(&rays, u8::MAX)) {
            *distance = hit.map_or(f32::MAX, |h| h.t);
        }
    }
    map
}

/// The lower half of the sphere onto the unit square (hemi-octahedral, Cigolle et al. 2014). Directions above the
/// horizon fall onto its edge.
fn fold(direction: Vec3A) -> Vec2 {
    let down = (-direction.z).max(0.0);
    let p = Vec2::new(direction.x, direction.y) / (direction.x.abs() + direction.y.abs() + down).max(1e-9);
    (Vec2::new(p.x + p.y, p.x - p.y) + 1.0) * 0.5
}

fn unfold(place: Vec2) -> Vec3A {
    let q = place * 2.0 - 1.0;
    let p = Vec2::new(q.x + q.y, q.x - q.y) * 0.5;
    Vec3A::new(p.x, p.y, -(1.0 - p.x.abs() - p.y.abs())).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::accel::Blas;
    use glam::{Affine3A, Vec3};
    use proptest::prelude::*;
    use std::sync::Arc;

    proptest! {
        #[test]
        fn folding_and_unfolding_are_inverse(x in 0.001f32..0.999, y in 0.001f32..0.999) {
            let direction = unfold(Vec2::new(x, y));
            prop_assert!(direction.z <= 1e-6 && (direction.length() - 1.0).abs() < 1e-5);
            prop_assert!(fold(direction).distance(Vec2::new(x, y)) < 1e-4);
        }
    }

    #[test]
    fn a_plate_shades_what_is_below_it_and_nothing_else() {
        let plate = [
            Vec3::new(-1.0, -1.0, 4.0),
            Vec3::new(1.0, -1.0, 4.0),
            Vec3::new(1.0, 1.0, 4.0),
            Vec3::new(-1.0, 1.0, 4.0),
        ];
        let blas = Arc::new(Blas::build(&plate, &[[0, 1, 2], [0, 2, 3]]));
        let accel = Tlas::build(vec![(blas, Affine3A::IDENTITY)]);
        let lamp = PointLamp { position: Vec3A::new(0.0, 0.0, 8.0), intensity: Vec3A::ONE };
        let maps = LampMaps::bake(&accel, &[lamp], Vec2::splat(-5.0), Vec2::splat(5.0), 32.0);
        let lit = |p: Vec3A| {
            let to = lamp.position - p;
            maps.lit(0, to.normalize(), to.length())
        };
        assert_eq!(lit(Vec3A::ZERO), Some(0.0));
        assert_eq!(lit(Vec3A::new(0.0, 0.0, 5.0)), Some(1.0));
        assert_eq!(lit(Vec3A::new(4.0, 0.0, 0.0)), Some(1.0));
        assert_eq!(maps.lit(1, Vec3A::Z, 1.0), None);
    }
}
