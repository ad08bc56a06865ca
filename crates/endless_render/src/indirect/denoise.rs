//! Edge-avoiding à-trous wavelet filter (Dammertz, Sewtz, Hanika, Lensch 2010) of irradiance, guided by planes.

use glam::Vec3A;
use rayon::prelude::*;

/// What a sample lies on.
#[derive(Debug, Clone, Copy)]
pub(crate) struct DenoiseGuide {
    pub(crate) position: Vec3A,
    /// Zero for the sky, which is left alone.
    pub(crate) normal: Vec3A,
    /// How far light may spread along the surface, metres: a few pixels.
    pub(crate) reach_m: f32,
}

impl DenoiseGuide {
    /// Nothing to light.
    pub(crate) const SKY: Self = Self { position: Vec3A::ZERO, normal: Vec3A::ZERO, reach_m: 1.0 };
}

/// How much two samples, `steps` times the reach apart in the picture, lie on one surface: 1 on a plane.
pub(crate) fn surface_weight(here: &DenoiseGuide, there: &DenoiseGuide, steps: f32) -> f32 {
    let facing = here.normal.dot(there.normal).max(0.0);
    let facing = facing * facing;
    let facing = facing * facing;
    let off_plane = (there.position - here.position).dot(here.normal) / (here.reach_m * steps);
    let plane = 1.0 / (1.0 + 4.0 * off_plane * off_plane);
    let apart = (there.position - here.position).length_squared() / (here.reach_m * here.reach_m);
    let near = 1.0 / (1.0 + apart / (64.0 * (steps * steps)));
    facing * facing * plane * plane * near
}

/// Weights of a sample and its neighbours in a row or a column.
pub(crate) const KERNEL: [f32; 3] = [0.25, 0.5, 0.25];

/// Filters an image of irradiance; rows in parallel, the result independent of the number of threads.
pub(crate) fn denoise(width: usize, guides: &[DenoiseGuide], mut light: Vec<Vec3A>, levels: u32) -> Vec<Vec3A> {
    let height = guides.len() / width.max(1);
    for level in 0..levels {
        let step = 1isize << level;
        let mut next = vec![Vec3A::ZERO; light.len()];
        next.par_chunks_mut(width).enumerate().for_each(|(y, row)| {
            for (x, out) in row.iter_mut().enumerate() {
                *out = filter_one(width, height, guides, &light, x, y, step);
            }
        });
        light = next;
    }
    light
}

fn filter_one(
    width: usize,
    height: usize,
    guides: &[DenoiseGuide],
    light: &[Vec3A],
    x: usize,
    y: usize,
    step: isize,
) -> Vec3A {
    let centre = y * width + x;
    let here = &guides[centre];
    if here.normal == Vec3A::ZERO {
        return light[centre];
    }
    let (mut sum, mut total) = (Vec3A::ZERO, 0.0);
    for j in -1isize..=1 {
        let row = y as isize + j * step;
        if row < 0 || row >= height as isize {
            continue;
        }
        for i in -1isize..=1 {
            let column = x as isize + i * step;
            if column < 0 || column >= width as isize {
                continue;
            }
            let other = row as usize * width + column as usize;
            let there = &guides[other];
            let weight = KERNEL[(i + 1) as usize] * KERNEL[(j + 1) as usize] * surface_weight(here, there, step as f32);
            sum += light[other] * weight;
            total += weight;
        }
    }
    sum / total.max(1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::noise::cell1;

    fn plane(width: usize, height: usize, bend: bool) -> Vec<DenoiseGuide> {
        (0..width * height)
            .map(|i| DenoiseGuide {
                position: Vec3A::new((i % width) as f32, (i / width) as f32, 0.0) * 0.1,
                normal: if bend && i % width >= width / 2 { Vec3A::X } else { Vec3A::Z },
                reach_m: 0.1,
            })
            .collect()
    }

    #[test]
    fn noise_goes_and_the_mean_stays() {
        let guides = plane(64, 64, false);
        let noisy: Vec<Vec3A> = (0..64 * 64).map(|i| Vec3A::splat(cell1(i, 3) * 2.0)).collect();
        let clean = denoise(64, &guides, noisy, 4);
        let inner: Vec<f32> = (16..48).flat_map(|y| (16..48).map(move |x| y * 64 + x)).map(|i| clean[i].x).collect();
        let mean = inner.iter().sum::<f32>() / inner.len() as f32;
        let deviation = (inner.iter().map(|v| (v - mean).powi(2)).sum::<f32>() / inner.len() as f32).sqrt();
        assert!((mean - 1.0).abs() < 0.05 && deviation < 0.08, "{mean} {deviation}");
    }

    #[test]
    fn light_does_not_leak_round_an_edge() {
        let guides = plane(64, 8, true);
        let light: Vec<Vec3A> = (0..64 * 8).map(|i| Vec3A::splat(if i % 64 < 32 { 1.0 } else { 5.0 })).collect();
        let clean = denoise(64, &guides, light, 4);
        assert!((clean[4 * 64 + 31].x - 1.0).abs() < 1e-3 && (clean[4 * 64 + 32].x - 5.0).abs() < 1e-3);
    }
}
