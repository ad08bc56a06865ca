//! Echoes of single drops of rain.
//!
//! After Kilic et al.: Lidar Light Scattering Augmentation (LISA), 2021. Drops have the sizes of Marshall and Palmer (1948);
//! one in the beam sends back its Fresnel reflection, by its share of the beam's cross-section. LISA draws all drops of every
//! beam. Here only those are drawn whose echo is strong enough, which have the same distribution: their number is Poisson's,
//! and their distances come from a table.

use super::echo::Echo;
use endless_world::Stream;
use endless_world::math::{exp, ln, pow};

/// Drops that one ray may see in a sweep.
#[derive(Debug, Clone)]
pub(super) struct RainEchoes {
    /// Mean number of drops before the far end of each cell of the ray.
    mean_before: Vec<f32>,
    near_m: f32,
    /// Inverse of the mean diameter, 1/mm.
    slope_per_mm: f32,
    beam_rad: f32,
    extinction_per_m: f32,
    least_power: f32,
}

/// Fresnel reflection of water under perpendicular light, refractive index 1.328.
const REFLECTANCE: f32 = 0.0198;
/// Marshall's and Palmer's number of drops, 1/(m³ mm).
const DROPS: f32 = 8000.0;
/// No echo of a drop comes from farther away, metres.
const FAR_M: f32 = 30.0;
const CELLS: usize = 128;

impl RainEchoes {
    /// Of a beam that widens by this angle, seen from `near_m` on; `None` without rain.
    pub(super) fn new(
        rain_mm_per_h: f32,
        beam_rad: f32,
        near_m: f32,
        extinction_per_m: f32,
        least_power: f32,
    ) -> Option<Self> {
        if rain_mm_per_h <= 0.0 || near_m >= FAR_M {
            return None;
        }
        let slope_per_mm = 4.1 * pow(rain_mm_per_h, -0.21);
        let mut echoes = Self {
            mean_before: Vec::with_capacity(CELLS),
            near_m,
            slope_per_mm,
            beam_rad,
            extinction_per_m,
            least_power,
        };
        let step = (FAR_M - near_m) / CELLS as f32;
        let mut mean = 0.0;
        for cell in 0..CELLS {
            let distance = near_m + (cell as f32 + 0.5) * step;
            let per_m3 = DROPS / slope_per_mm * exp(-slope_per_mm * echoes.least_diameter_mm(distance));
            let width = beam_rad * distance;
            mean += per_m3 * 0.25 * std::f32::consts::PI * width * width * step;
            echoes.mean_before.push(mean);
        }
        Some(echoes)
    }

    /// Diameter of the smallest drop whose echo is strong enough.
    fn least_diameter_mm(&self, distance: f32) -> f32 {
        let needed = self.least_power * distance * distance * exp(2.0 * self.extinction_per_m * distance) / REFLECTANCE;
        1000.0 * self.beam_rad * distance * needed.sqrt()
    }

    /// The strongest drop along a ray, if any is strong enough.
    pub(super) fn draw(&self, random: &mut Stream) -> Option<Echo> {
        let mean = self.mean_before[CELLS - 1];
        let none = exp(-mean);
        let mut chance = random.f32();
        if chance < none {
            return None;
        }
        // Poisson's number by inversion: mostly one.
        let (mut count, mut share) = (0.0, none);
        while chance >= share && count < 100.0 {
            chance -= share;
            count += 1.0;
            share *= mean / count;
        }
        let drops = (0..count as u32).map(|_| self.drop(random));
        drops.max_by(|a, b| a.power().total_cmp(&b.power()))
    }

    fn drop(&self, random: &mut Stream) -> Echo {
        let place = random.f32() * self.mean_before[CELLS - 1];
        let cell = self.mean_before.partition_point(|&mean| mean <= place).min(CELLS - 1);
        let distance = self.near_m + (cell as f32 + random.f32()) * ((FAR_M - self.near_m) / CELLS as f32);
        let diameter = self.least_diameter_mm(distance) - ln(1.0 - random.f32()) / self.slope_per_mm;
        let share = (diameter / (1000.0 * self.beam_rad * distance)).min(1.0);
        let strength = REFLECTANCE * share * share * exp(-2.0 * self.extinction_per_m * distance);
        Echo { distance, strength }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LEAST: f32 = 4e-5;

    fn rain(mm_per_h: f32) -> RainEchoes {
        RainEchoes::new(mm_per_h, 2e-3, 0.9, 3e-3, LEAST).expect("rain")
    }

    #[test]
    fn more_rain_makes_more_echoes_and_all_are_near() {
        let share = |mm_per_h| {
            let (echoes, mut random) = (rain(mm_per_h), Stream::new(3, &[]));
            let drawn: Vec<Echo> = (0..20_000).filter_map(|_| echoes.draw(&mut random)).collect();
            assert!(drawn.iter().all(|echo| (0.9..15.0).contains(&echo.distance)));
            // A cell is a step of the table: its near end may be a little less sensitive than its middle.
            assert!(drawn.iter().all(|echo| echo.power() > 0.99 * LEAST));
            drawn.len() as f32 / 20_000.0
        };
        let [light, heavy] = [1.0, 30.0].map(share);
        assert!(light > 0.001 && heavy > 2.0 * light && heavy < 0.3, "{light} {heavy}");
        assert!(RainEchoes::new(0.0, 2e-3, 0.9, 0.0, LEAST).is_none());
    }

    #[test]
    fn as_many_echoes_are_drawn_as_drops_fall_through_beams() {
        // All drops of a beam, drawn one by one as LISA does.
        let (mut random, slope) = (Stream::new(4, &[]), 4.1 * pow(10.0, -0.21));
        let (beam, far, rays) = (2e-3f32, 12.0f32, 20_000);
        let volume = std::f32::consts::PI * beam * beam * far * far * far / 12.0;
        let mean = DROPS / slope * volume;
        let mut seen = 0;
        for _ in 0..rays {
            let (mut count, mut product) = (0, random.f32());
            while product > exp(-mean) {
                count += 1;
                product *= random.f32();
            }
            let strong = (0..count).any(|_| {
                let distance = far * pow(random.f32(), 1.0 / 3.0);
                let diameter = -ln(1.0 - random.f32()) / slope;
                let share = (diameter / (1000.0 * beam * distance)).min(1.0);
                let power = REFLECTANCE * share * share * exp(-2.0 * 3e-3 * distance) / (distance * distance);
                distance > 0.9 && power >= LEAST
            });
            seen += u32::from(strong);
        }
        let echoes = rain(10.0);
        let drawn = (0..rays).filter(|_| echoes.draw(&mut random).is_some()).count();
        let (seen, drawn) = (seen as f32 / rays as f32, drawn as f32 / rays as f32);
        assert!((seen - drawn).abs() < 0.1 * seen, "{seen} {drawn}");
    }
}
