//! The sky's radiance in every direction, as a table made once a scene.
//!
//! Clear sky: single scattering in an exponential Rayleigh and Mie atmosphere (Nishita, Sirai, Tadamura, Nakamae 1993),
//! with the air of Bruneton and Neyret 2008 and the aerosols of Preetham, Shirley and Smits 1999, plus a uniform share of
//! the light for the further orders of scattering that the integral leaves out. Overcast sky: the CIE standard overcast luminance distribution
//! (Moon and Spencer 1942). Twilight: its colours are those of [`twilight`]. Radiance in kcd/m² per linear RGB channel.

use super::{clouds::CloudLayer, twilight};
use crate::vec3x8::{Vec3x8, dot, normalize, side_by_side, splat};
use crate::{exact8, math8};
use endless_world::math;
use endless_world::math::UnfusedVec3A;
use glam::Vec3A;
use rayon::prelude::*;
use std::f32::consts::{PI, TAU};
use wide::{f32x8, i32x8};

const WIDTH: usize = 512;
const HEIGHT: usize = 256;
// So that columns wrap with their low bits.
const _: () = assert!(WIDTH.is_power_of_two());

const EARTH_RADIUS_M: f32 = 6_360_000.0;
const ATMOSPHERE_RADIUS_M: f32 = 6_420_000.0;
const RAYLEIGH_SCALE_M: f32 = 8_000.0;
const MIE_SCALE_M: f32 = 1_200.0;
/// Scattering coefficients at sea level for 680, 550 and 440 nm, 1/m.
const RAYLEIGH_BETA: Vec3A = Vec3A::new(5.8e-6, 13.5e-6, 33.1e-6);
/// Ozone absorbs green and red: keeps the twilight sky blue. 1/m at its share of the Rayleigh profile.
const OZONE_BETA: Vec3A = Vec3A::new(0.65e-6, 1.88e-6, 0.085e-6);
const MIE_ANISOTROPY: f32 = 0.76;
/// Share of the light that aerosols take from a ray which they scatter; they absorb the rest.
const MIE_ALBEDO: f32 = 0.9;
/// (wavelength / 1 µm)^-1.3 for 680, 550 and 440 nm: how aerosols' optical depth depends on colour (Ångström 1929).
const ANGSTROM: Vec3A = Vec3A::new(1.651, 2.175, 2.907);
/// Light scattered more than once, as a share of that scattered once.
const FURTHER_ORDERS: f32 = 0.38;
/// Illuminance of the sun outside the atmosphere, klx.
pub(crate) const SOLAR_ILLUMINANCE_KLX: f32 = 128.0;

/// Weights of the channels in luminance.
pub(super) const LUMINANCE: Vec3A = Vec3A::new(0.2126, 0.7152, 0.0722);

/// Sky radiance by direction: equirectangular, upper hemisphere only.
#[derive(Debug, Clone)]
pub(crate) struct Sky {
    table: Vec<Vec3A>,
    /// Mean radiance of the upper hemisphere.
    pub(crate) mean: Vec3A,
}

/// What the sky is made of.
#[derive(Debug, Clone)]
pub(crate) struct SkyParameters {
    /// Towards the sun; below the horizon at night.
    pub(crate) sun_direction: Vec3A,
    /// Linke turbidity: 1 is air without aerosols, 2 very clear, 3 clear, 6 hazy.
    pub(crate) turbidity: f32,
    /// 0: clear sky model only; 1: CIE overcast only.
    pub(crate) overcast: f32,
    /// Horizontal illuminance of the fully overcast sky, klx.
    pub(crate) overcast_klx: f32,
    /// Light that a town throws into its night sky: radiance at the horizon, kcd/m².
    pub(crate) glow: Vec3A,
    /// Broken clouds over the clear part.
    pub(crate) clouds: Option<CloudLayer>,
}

impl Sky {
    /// Tabulates the sky.
    pub(crate) fn new(parameters: &SkyParameters) -> Self {
        let place = |i: usize| direction_of((i % WIDTH) as f32 + 0.5, (i / WIDTH) as f32 + 0.5);
        let eight = |i: usize| parameters.radiance8(&std::array::from_fn(|lane| place(8 * i + lane)));
        let eights = (0..WIDTH * HEIGHT / 8).into_par_iter();
        let table = eights.map(eight).collect::<Vec<[Vec3A; 8]>>().into_flattened();
        let (mut sum, mut solid_angle) = (Vec3A::ZERO, 0.0);
        for (row, line) in table.chunks_exact(WIDTH).enumerate() {
            let weight = math::sin(elevation_of(row as f32 + 1.0)) - math::sin(elevation_of(row as f32));
            sum += line.iter().copied().sum::<Vec3A>() * weight;
            solid_angle += weight * WIDTH as f32;
        }
        Self { table, mean: sum / solid_angle }
    }

    /// The sky with its light changed by a factor a channel.
    pub(crate) fn tinted(mut self, factors: Vec3A) -> Self {
        if factors != Vec3A::ONE {
            self.table.iter_mut().for_each(|radiance| *radiance *= factors);
            self.mean *= factors;
        }
        self
    }

    /// Radiance from a direction, kcd/m²; below the horizon, that of the horizon.
    pub(crate) fn radiance(&self, direction: Vec3A) -> Vec3A {
        let azimuth = math::atan2_approx(direction.y, direction.x);
        let level = (direction.x * direction.x + direction.y * direction.y).sqrt();
        let elevation = math::atan2_approx(direction.z.max(0.0), level);
        let x = (azimuth / TAU + 0.5) * WIDTH as f32 - 0.5;
        // Rows crowd at the horizon: row ∝ sqrt(elevation).
        let y = ((elevation / (PI / 2.0)).sqrt() * HEIGHT as f32 - 0.5).clamp(0.0, (HEIGHT - 1) as f32);
        let (x0, y0) = (x.floor(), y.floor());
        let (fx, fy) = (x - x0, y - y0);
        let column = |i: f32| (i as i32).rem_euclid(WIDTH as i32) as usize;
        let (c0, c1) = (column(x0), column(x0 + 1.0));
        let (r0, r1) = (y0 as usize, (y0 as usize + 1).min(HEIGHT - 1));
        let at = |c: usize, r: usize| self.table[r * WIDTH + c];
        at(c0, r0).lerp_unfused(at(c1, r0), fx).lerp_unfused(at(c0, r1).lerp_unfused(at(c1, r1), fx), fy)
    }

    /// [`Self::radiance`] from eight directions.
    pub(crate) fn radiance8(&self, [x, y, z]: &Vec3x8) -> Vec3x8 {
        let level = (*x * *x + *y * *y).sqrt();
        let elevation = exact8::atan2_approx(z.fast_max(f32x8::ZERO), level);
        let half = f32x8::HALF;
        let x = (exact8::atan2_approx(*y, *x) / f32x8::splat(TAU) + half) * f32x8::splat(WIDTH as f32) - half;
        let y = (elevation / f32x8::splat(PI / 2.0)).sqrt() * f32x8::splat(HEIGHT as f32) - half;
        let y = y.fast_clamp(f32x8::ZERO, f32x8::splat((HEIGHT - 1) as f32));
        let (x0, y0) = (x.floor(), y.floor());
        let [fx, fy] = [x - x0, y - y0].map(f32x8::to_array);
        let column = x0.fast_trunc_int();
        let columns = [column, column + i32x8::ONE].map(|c| c & i32x8::splat(WIDTH as i32 - 1));
        let row = y0.fast_trunc_int();
        let rows = [row, (row + i32x8::ONE).min(i32x8::splat(HEIGHT as i32 - 1))];
        let place = |c: usize, r: usize| (rows[r] * i32x8::splat(WIDTH as i32) + columns[c]).to_array();
        let (p00, p10, p01, p11) = (place(0, 0), place(1, 0), place(0, 1), place(1, 1));
        let at = |place: i32| self.table[place as usize];
        side_by_side(std::array::from_fn(|i| {
            let low = at(p00[i]).lerp_unfused(at(p10[i]), fx[i]);
            let high = at(p01[i]).lerp_unfused(at(p11[i]), fx[i]);
            low.lerp_unfused(high, fy[i])
        }))
    }

    /// Illuminance on a horizontal plane, klx, by quadrature over the table.
    #[cfg(test)]
    pub(crate) fn horizontal_illuminance(&self) -> Vec3A {
        let mut sum = Vec3A::ZERO;
        for (row, line) in self.table.chunks_exact(WIDTH).enumerate() {
            let (low, high) = (elevation_of(row as f32), elevation_of(row as f32 + 1.0));
            // ∫ sin cos over the row's elevations.
            let weight = (math::sin(high) * math::sin(high) - math::sin(low) * math::sin(low)) / 2.0;
            sum += line.iter().copied().sum::<Vec3A>() * (weight * TAU / WIDTH as f32);
        }
        sum
    }
}

fn elevation_of(row: f32) -> f32 {
    let t = row / HEIGHT as f32;
    t * t * (PI / 2.0)
}

fn direction_of(column: f32, row: f32) -> Vec3A {
    let (sin_azimuth, cos_azimuth) = math::sin_cos((column / WIDTH as f32 - 0.5) * TAU);
    let (sin_elevation, cos_elevation) = math::sin_cos(elevation_of(row));
    Vec3A::new(cos_azimuth * cos_elevation, sin_azimuth * cos_elevation, sin_elevation)
}

impl SkyParameters {
    fn radiance8(&self, directions: &[Vec3A; 8]) -> [Vec3A; 8] {
        let clear = if self.overcast < 1.0 {
            clear_sky(directions, self.sun_direction, self.turbidity)
        } else {
            [Vec3A::ZERO; 8]
        };
        std::array::from_fn(|i| self.over(clear[i], directions[i]))
    }

    /// Radiance from a direction, of which the clear sky's is known.
    fn over(&self, mut clear: Vec3A, direction: Vec3A) -> Vec3A {
        if self.overcast < 1.0
            && let Some(clouds) = &self.clouds
        {
            clear = clouds.over(clear, direction, self.sun_direction);
        }
        // CIE overcast: L = Lz (1 + 2 sin e) / 3, and E = 7 π Lz / 9.
        let zenith = self.overcast_klx * 9.0 / (7.0 * PI);
        let grey = Vec3A::new(0.95, 1.0, 1.08) * (zenith * (1.0 + 2.0 * direction.z) / 3.0);
        let horizon = (1.0 - direction.z).max(0.0);
        clear.lerp_unfused(grey, self.overcast) + self.glow * (0.25 + 0.75 * horizon * horizon * horizon)
    }
}

/// Distances from places in the air to its upper end, metres.
fn to_space(origins: &Vec3x8, directions: &Vec3x8) -> f32x8 {
    let top = f32x8::splat(ATMOSPHERE_RADIUS_M);
    let up = dot(origins, directions);
    let from_centre = dot(origins, origins).sqrt();
    let depth = (top - from_centre) * (top + from_centre);
    let root = (up * up + depth).sqrt();
    // Of the two forms of the root of a quadratic equation, each loses its digits where the other keeps them.
    up.simd_gt(f32x8::ZERO).select(depth / (up + root), root - up)
}

/// Share of the density at sea level that air which thins out by the factor e a scale height has.
fn density(heights_m: f32x8, scale_m: f32) -> f32x8 {
    math8::exp(heights_m * f32x8::splat(-1.0 / scale_m))
}

/// Heights of places above the ground, metres.
fn heights(places: &Vec3x8) -> f32x8 {
    dot(places, places).sqrt() - f32x8::splat(EARTH_RADIUS_M)
}

fn along(origins: &Vec3x8, directions: &Vec3x8, distances: f32x8) -> Vec3x8 {
    std::array::from_fn(|axis| origins[axis] + directions[axis] * distances)
}

/// Columns of air and of aerosols on the way to space, metres at sea-level density.
fn optical_depth(origins: &Vec3x8, directions: &Vec3x8, steps: u32) -> (f32x8, f32x8) {
    let step = to_space(origins, directions) * f32x8::splat(1.0 / steps as f32);
    let (mut rayleigh, mut mie) = (f32x8::ZERO, f32x8::ZERO);
    for i in 0..steps {
        let heights = heights(&along(origins, directions, step * f32x8::splat(i as f32 + 0.5)));
        rayleigh += density(heights, RAYLEIGH_SCALE_M) * step;
        mie += density(heights, MIE_SCALE_M) * step;
    }
    (rayleigh, mie)
}

/// Extinction by aerosols at sea level, 1/m: Ångström's coefficient by turbidity as Preetham et al. give it.
fn mie_extinction(turbidity: f32) -> Vec3A {
    ANGSTROM * ((0.046_08 * turbidity - 0.045_86).max(0.0) / MIE_SCALE_M)
}

/// Share of light left along columns of air and aerosols, metres at sea-level density.
fn extinction(rayleigh: f32x8, mie: f32x8, turbidity: f32) -> Vec3x8 {
    let (air, aerosols) = (RAYLEIGH_BETA + OZONE_BETA, mie_extinction(turbidity));
    [0, 1, 2].map(|k| math8::exp(-(f32x8::splat(air[k]) * rayleigh + f32x8::splat(aerosols[k]) * mie)))
}

/// Where one stands, from the Earth's centre.
fn ground() -> Vec3x8 {
    [0.0, 0.0, EARTH_RADIUS_M + 10.0].map(f32x8::splat)
}

/// Share of the sunlight that reaches the ground, per channel.
pub(crate) fn sun_transmittance(sun_direction: Vec3A, turbidity: f32) -> Vec3A {
    let (rayleigh, mie) = optical_depth(&ground(), &splat(sun_direction), 32);
    let [r, g, b] = extinction(rayleigh, mie, turbidity).map(|channel| channel.to_array()[0]);
    Vec3A::new(r, g, b)
}

/// Radiance of the sky without clouds.
fn clear_sky(directions: &[Vec3A; 8], sun: Vec3A, turbidity: f32) -> [Vec3A; 8] {
    let dusk = twilight::share(sun);
    let mut light = if dusk < 1.0 { single_scattering(directions, sun, turbidity) } else { [Vec3A::ZERO; 8] };
    if dusk > 0.0 {
        let raised = single_scattering(&directions.map(twilight::above_rim), sun, turbidity);
        for (i, light) in light.iter_mut().enumerate() {
            let hue = twilight::hue(directions[i], sun);
            let coloured = hue * (raised[i].dot(LUMINANCE) / hue.dot(LUMINANCE));
            *light = light.lerp_unfused(coloured, dusk);
        }
    }
    light
}

fn single_scattering(directions: &[Vec3A; 8], sun: Vec3A, turbidity: f32) -> [Vec3A; 8] {
    if sun.z < -0.12 {
        return [Vec3A::ZERO; 8];
    }
    const STEPS: u32 = 16;
    let lane = |axis: usize| f32x8::new(directions.map(|direction| direction[axis]));
    let directions = normalize([lane(0), lane(1), lane(2).fast_max(f32x8::splat(0.004))]);
    let (origin, sun) = (ground(), splat(sun));
    let length = to_space(&origin, &directions);
    let cosine = dot(&directions, &sun);
    let [one, g] = [1.0, MIE_ANISOTROPY].map(f32x8::splat);
    let symmetric = one + cosine * cosine;
    let rayleigh_phase = f32x8::splat(3.0 / (16.0 * PI)) * symmetric;
    let mie_beta = mie_extinction(turbidity) * MIE_ALBEDO;
    let spread = (one + g * g - f32x8::splat(2.0) * g * cosine).fast_max(f32x8::splat(1e-4));
    let mie_phase = f32x8::splat(3.0 / (8.0 * PI)) * (one - g * g) * symmetric
        / ((f32x8::splat(2.0) + g * g) * spread * spread.sqrt());
    // Further orders are nearly isotropic.
    let multiple_phase = f32x8::splat(FURTHER_ORDERS / (4.0 * PI));
    let (mut depth_rayleigh, mut depth_mie) = (f32x8::ZERO, f32x8::ZERO);
    let mut in_scattered = [f32x8::ZERO; 3];
    let mut from = f32x8::ZERO;
    for i in 0..STEPS {
        // Steps grow with distance: air is dense near the ground.
        let t = (i + 1) as f32 / STEPS as f32;
        let to = length * f32x8::splat(t * t);
        let (step, middle) = (to - from, (to + from) * f32x8::splat(0.5));
        from = to;
        let points = along(&origin, &directions, middle);
        let heights = heights(&points).fast_max(f32x8::ZERO);
        let (rho_rayleigh, rho_mie) = (density(heights, RAYLEIGH_SCALE_M) * step, density(heights, MIE_SCALE_M) * step);
        depth_rayleigh += rho_rayleigh;
        depth_mie += rho_mie;
        let (sun_rayleigh, sun_mie) = optical_depth(&points, &sun, 6);
        let light = extinction(depth_rayleigh + sun_rayleigh, depth_mie + sun_mie, turbidity);
        for (k, sum) in in_scattered.iter_mut().enumerate() {
            let scattered = f32x8::splat(RAYLEIGH_BETA[k]) * rho_rayleigh * (rayleigh_phase + multiple_phase)
                + f32x8::splat(mie_beta[k]) * rho_mie * (mie_phase + multiple_phase);
            *sum += light[k] * scattered;
        }
    }
    let [r, g, b] = in_scattered.map(|channel| (channel * f32x8::splat(SOLAR_ILLUMINANCE_KLX)).to_array());
    std::array::from_fn(|i| Vec3A::new(r[i], g[i], b[i]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::{hammersley, sphere_direction};

    fn clear(elevation_rad: f32) -> SkyParameters {
        SkyParameters {
            sun_direction: Vec3A::new(math::cos(elevation_rad), 0.0, math::sin(elevation_rad)),
            turbidity: 2.0,
            overcast: 0.0,
            overcast_klx: 0.0,
            glow: Vec3A::ZERO,
            clouds: None,
        }
    }

    fn luminance(c: Vec3A) -> f32 {
        c.dot(LUMINANCE)
    }

    /// Horizontal daylight of a clear sky, klx: (sun, sky), by the sun's elevation (IES RP-21-84; Robbins and Hunter).
    fn published(elevation: f32) -> (f32, f32) {
        let sine = math::sin(elevation);
        (127.5 * math::exp(-0.21 / sine) * sine, 0.8 + 15.5 * sine.sqrt())
    }

    #[test]
    fn daylight_is_as_published() {
        for degrees in [15f32, 30.0, 60.0] {
            let elevation = degrees.to_radians();
            let parameters = clear(elevation);
            let direct = sun_transmittance(parameters.sun_direction, parameters.turbidity) * SOLAR_ILLUMINANCE_KLX;
            let sun = luminance(direct) * math::sin(elevation);
            let sky = luminance(Sky::new(&parameters).horizontal_illuminance());
            let (published_sun, published_sky) = published(elevation);
            let of_published = |ours: f32, published: f32| ours / published - 1.0;
            let total = of_published(sun + sky, published_sun + published_sky);
            assert!(total.abs() < 0.08, "{degrees}: sun and sky {total}");
            assert!(of_published(sky, published_sky).abs() < 0.12, "{degrees}: sky {sky} {published_sky}");
        }
    }

    #[test]
    fn low_sun_is_warm_and_weak() {
        let high = sun_transmittance(Vec3A::new(0.0, 0.5, 0.87), 2.0);
        let low = sun_transmittance(Vec3A::new(0.0, 0.98, 0.2).normalize(), 2.0);
        assert!(luminance(low) < luminance(high) && low.x / low.z > high.x / high.z * 1.3);
    }

    #[test]
    fn overcast_sky_gives_its_illuminance() {
        let sky = Sky::new(&SkyParameters { overcast: 1.0, overcast_klx: 10.0, ..clear(0.5) });
        assert!((luminance(sky.horizontal_illuminance()) - 10.0).abs() < 0.2);
    }

    #[test]
    fn twilight_darkens_without_a_jump_and_has_no_black_rim() {
        let mean = |degrees: f32| luminance(Sky::new(&clear(degrees.to_radians())).mean);
        for degrees in [3.0, 1.0, 0.0, -2.0, -5.0] {
            let [before, after] = [mean(degrees + 0.3), mean(degrees)];
            assert!((0.6..1.0).contains(&(after / before)), "{degrees}: {before} {after}");
        }
        let sky = Sky::new(&clear(-3f32.to_radians()));
        let [rim, above] = [0.01, 0.3].map(|z| luminance(sky.radiance(Vec3A::new(0.0, 1.0, z).normalize())));
        assert!(rim > 0.6 * above, "{rim} {above}");
    }

    #[test]
    fn the_blue_sky_is_blue() {
        let sky = Sky::new(&clear(0.9));
        let zenith = sky.radiance(Vec3A::Z);
        assert!(zenith.z > zenith.y && zenith.y > zenith.x);
    }

    #[test]
    fn eight_places_shine_as_one_after_another() {
        let sky = Sky::new(&clear(0.3));
        let n = 40_000;
        let axes = [Vec3A::X, Vec3A::Y, Vec3A::Z].map(|axis| [axis, -axis]);
        let near = [1e-3, 1e-6, 1e-20, -1e-6].map(|aside| [Vec3A::new(-1.0, aside, 0.3), Vec3A::new(aside, 0.0, 1.0)]);
        let mut directions: Vec<Vec3A> = (0..n).map(|i| sphere_direction(hammersley(i, n))).collect();
        directions
            .extend(axes.as_flattened().iter().chain(near.as_flattened()).chain(&[Vec3A::new(-1.0, -0.0, -0.0); 2]));
        let (eights, rest) = directions.as_chunks();
        assert!(rest.is_empty());
        for eight in eights {
            let found = sky.radiance8(&side_by_side(*eight)).map(f32x8::to_array);
            for (i, direction) in eight.iter().enumerate() {
                let one = sky.radiance(*direction).to_array();
                assert_eq!(found.map(|channel| channel[i].to_bits()), one.map(f32::to_bits), "{direction}");
            }
        }
    }
}
