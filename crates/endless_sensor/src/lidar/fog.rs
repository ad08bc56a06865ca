//! Echoes of fog.
//!
//! After Hahner et al.: Fog Simulation on Real LiDAR Point Clouds for 3D Object Detection in Adverse Weather (ICCV 2021), who
//! follow Rasshofer et al. (2011): fog is a soft target, which answers a pulse from all its depth, most from where the
//! receiver's view has come to overlap the beam. Theirs is even, so that all rays would see it at one distance: here each ray
//! has its own density about the mean, as fog drifts in wisps.

use super::echo::Echo;
use endless_world::Stream;
use endless_world::math::exp;

/// Fog that one ray may see.
#[derive(Debug, Clone)]
pub(super) struct FogEchoes {
    /// Sum of weights before the far end of each cell of the ray.
    weight_before: Vec<f32>,
    near_m: f32,
    extinction_per_m: f32,
    /// Strength of an echo at full overlap, without extinction.
    strength: f32,
    /// Signal of the strongest echo in fog of mean density.
    peak_power: f32,
}

/// Half the length of a pulse of 5 ns, metres: as much depth answers at once.
const DEPTH_M: f32 = 0.75;
/// From here on the receiver sees the beam at all, metres (Hahner et al.).
const OVERLAP_BEGINS_M: f32 = 0.9;
/// From here on it sees all of it, metres. Set so that in fog of 150 m a fifth of the rays of an HDL-64E that meet nothing
/// see fog; Hahner et al. have 1 m, and weaken fog by a factor that they fit to their device.
const OVERLAP_FULL_M: f32 = 10.0;
/// No echo of fog comes from farther away, metres.
const FAR_M: f32 = 20.0;
/// Standard deviation of the logarithm of density. By eye.
const WISPS: f64 = 0.5;
const CELLS: usize = 128;

impl FogEchoes {
    /// Of fog with this extinction, seen from `near_m` on; `None` without fog.
    pub(super) fn new(extinction_per_m: f32, near_m: f32) -> Option<Self> {
        let near_m = near_m.max(OVERLAP_BEGINS_M);
        if extinction_per_m <= 0.0 || near_m >= FAR_M {
            return None;
        }
        // Meteorological optical range, where 5 % are left; 0.046 of its inverse scatters back, 1/(m sr).
        let optical_range_m = 2.996 / extinction_per_m;
        let strength = std::f32::consts::PI * 0.046 / optical_range_m * DEPTH_M;
        let mut fog =
            Self { weight_before: Vec::with_capacity(CELLS), near_m, extinction_per_m, strength, peak_power: 0.0 };
        let step = (FAR_M - near_m) / CELLS as f32;
        let mut sum = 0.0;
        for cell in 0..CELLS {
            let power = fog.echo(near_m + (cell as f32 + 0.5) * step, 1.0).power();
            fog.peak_power = fog.peak_power.max(power);
            sum += power * power;
            fog.weight_before.push(sum);
        }
        Some(fog)
    }

    fn echo(&self, distance: f32, density: f32) -> Echo {
        let overlap = ((distance - OVERLAP_BEGINS_M) / (OVERLAP_FULL_M - OVERLAP_BEGINS_M)).clamp(0.0, 1.0);
        Echo { distance, strength: density * self.strength * overlap * exp(-2.0 * self.extinction_per_m * distance) }
    }

    /// The fog along a ray, if its strongest echo is at least `power`.
    pub(super) fn draw(&self, random: &mut Stream, power: f32) -> Option<Echo> {
        let density = exp((WISPS * random.normal()) as f32);
        if density * self.peak_power < power {
            return None;
        }
        let place = random.f32() * self.weight_before[CELLS - 1];
        let cell = self.weight_before.partition_point(|&sum| sum <= place).min(CELLS - 1);
        Some(self.echo(self.near_m + (cell as f32 + random.f32()) * ((FAR_M - self.near_m) / CELLS as f32), density))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// That of 10 % at 50 m.
    const LEAST: f32 = 4e-5;

    fn share(visibility_m: f32) -> f32 {
        let fog = FogEchoes::new(3.912 / visibility_m, 0.9).expect("fog");
        let mut random = Stream::new(8, &[]);
        let drawn: Vec<Echo> = (0..20_000).filter_map(|_| fog.draw(&mut random, LEAST)).collect();
        assert!(drawn.iter().all(|echo| (0.9..20.0).contains(&echo.distance) && echo.strength >= 0.0));
        let mean = drawn.iter().map(|echo| echo.distance).sum::<f32>() / drawn.len() as f32;
        assert!((1.0..5.0).contains(&mean), "{mean}");
        drawn.len() as f32 / 20_000.0
    }

    #[test]
    fn thicker_fog_answers_more_often_from_near() {
        let [thick, usual, thin] = [60.0, 150.0, 300.0].map(share);
        assert!(thick > 0.6 && (0.12..0.3).contains(&usual) && thin < 0.06, "{thick} {usual} {thin}");
        assert!(FogEchoes::new(0.0, 0.9).is_none());
    }
}
