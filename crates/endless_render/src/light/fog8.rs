//! The air in front of eight things side by side: the bits of [`Fog`]'s functions of one.

use super::Fog;
use crate::exact8;
use crate::vec3x8::{Vec3x8, dot, splat};
use wide::f32x8;

impl Fog {
    /// [`Fog::transmittance`] along eight rays, of whose origins the heights are told and of whose directions the upward parts.
    #[inline]
    pub(crate) fn transmittance8(&self, heights: f32x8, upwards: f32x8, distances_m: f32x8) -> f32x8 {
        let scale_height = f32x8::splat(self.scale_height_m);
        let climb = upwards * distances_m / scale_height;
        let level = climb.abs().simd_lt(f32x8::splat(0.01));
        let series = f32x8::ONE - climb * (f32x8::splat(0.5) - climb / f32x8::splat(6.0));
        let mean = if level.all() { series } else { level.select(series, (f32x8::ONE - exact8::exp(-climb)) / climb) };
        let thinned = exact8::exp((f32x8::splat(self.ground) - heights) / scale_height);
        exact8::exp(-(f32x8::splat(self.extinction) * thinned) * mean * distances_m)
    }

    /// [`Fog::in_scatter`] of eight rays.
    #[inline]
    pub(crate) fn in_scatter8(&self, directions: &Vec3x8, transmittance: f32x8) -> Vec3x8 {
        let sun = splat(self.sun_direction);
        let cosine = dot(directions, &sun).fast_max(f32x8::ZERO);
        let lobe = cosine * cosine;
        let lobe = lobe * lobe * lobe;
        let scattered = f32x8::ONE - transmittance;
        std::array::from_fn(|k| (f32x8::splat(self.airlight[k]) + f32x8::splat(self.sunward[k]) * lobe) * scattered)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec3x8::side_by_side;
    use glam::Vec3A;
    use proptest::prelude::*;

    fn vector(most: f32) -> impl Strategy<Value = Vec3A> {
        (-most..most, -most..most, -most..most).prop_map(Vec3A::from)
    }

    /// A ray and a distance, from near to far; many rays are level.
    fn ray() -> impl Strategy<Value = (f32, Vec3A, f32)> {
        let distance = prop_oneof![Just(0.0), 0.0f32..1.0, 1.0f32..300.0, 300.0f32..1e5];
        (-5f32..80.0, vector(1.0), prop_oneof![Just(0.0), Just(-0.0), -1e-3f32..1e-3, -1f32..1.0], distance)
            .prop_map(|(height, direction, upward, distance)| (height, direction.with_z(upward), distance))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4096))]

        #[test]
        fn the_air_of_eight_is_that_of_one_after_another(
            rays in prop::array::uniform8(ray()), from_one_height: bool, level: bool, visibility in 20f32..30_000.0,
            ground in -3f32..10.0, scale_height_m in 10f32..1500.0, airlight in vector(5.0), sunward in vector(5.0),
            sun_direction in vector(1.0),
        ) {
            let fog = Fog {
                extinction: Fog::extinction_for_visibility(visibility),
                ground,
                scale_height_m,
                glow: 1.0,
                airlight: airlight.abs(),
                sunward: sunward.abs(),
                sun_direction: sun_direction.normalize_or(Vec3A::Z),
            };
            let rays = rays.map(|(height, direction, distance)| {
                let direction = if level { direction.with_z(direction.z * 1e-4) } else { direction };
                (if from_one_height { rays[0].0 } else { height }, direction.normalize_or(Vec3A::X), distance)
            });
            let heights = f32x8::new(rays.map(|(height, ..)| height));
            let directions = side_by_side(rays.map(|(_, direction, _)| direction));
            let left = fog.transmittance8(heights, directions[2], f32x8::new(rays.map(|(.., distance)| distance)));
            let scattered = fog.in_scatter8(&directions, left).map(f32x8::to_array);
            for (i, (height, direction, distance)) in rays.into_iter().enumerate() {
                let one = fog.transmittance(Vec3A::Z * height, direction, distance);
                prop_assert_eq!(left.to_array()[i].to_bits(), one.to_bits());
                let one = fog.in_scatter(direction, one).to_array();
                prop_assert_eq!(scattered.map(|axis| axis[i].to_bits()), one.map(f32::to_bits));
            }
        }
    }
}
