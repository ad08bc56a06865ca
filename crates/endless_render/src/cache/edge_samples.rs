//! Samples at edges, on leaves and wires: the few of a picture on whose surface no points lie that gather light.

use crate::indirect::{DenoiseGuide, KERNEL, surface_weight};
use crate::sampling::SAMPLES;
use glam::Vec3A;
use rayon::prelude::*;

/// Steps of the filter: the last reaches sixteen pixels away.
const LEVELS: u32 = 5;

/// Samples of a picture, and where they are.
pub(super) struct EdgeSamples<'a> {
    size: [isize; 2],
    /// Pixel times [`SAMPLES`] plus the number in the pixel, ascending.
    samples: &'a [usize],
    guides: Vec<DenoiseGuide>,
    /// By sample of the picture: its place among these, plus one; 0 if it is none of them.
    places: Vec<u32>,
}

impl<'a> EdgeSamples<'a> {
    /// These samples of a picture, each with its guide.
    pub(super) fn new(width: usize, height: usize, samples: &'a [usize], guides: Vec<DenoiseGuide>) -> Self {
        let mut places = vec![0u32; width * height * SAMPLES];
        for (place, &sample) in (1..).zip(samples) {
            places[sample] = place;
        }
        Self { size: [width as isize, height as isize], samples, guides, places }
    }

    /// Edge-avoiding à-trous filter (Dammertz, Sewtz, Hanika, Lensch 2010) of their light: first among all samples of
    /// neighbouring pixels, then among those that have the same place in theirs.
    pub(super) fn denoise(&self, mut light: Vec<Vec3A>) -> Vec<Vec3A> {
        for level in 0..LEVELS {
            light = (0..light.len()).into_par_iter().map(|place| self.filtered(&light, place, level)).collect();
        }
        light
    }

    fn filtered(&self, light: &[Vec3A], place: usize, level: u32) -> Vec3A {
        let [width, height] = self.size;
        let step = 1 << level;
        let (pixel, number) = ((self.samples[place] / SAMPLES) as isize, self.samples[place] % SAMPLES);
        let numbers = if level == 0 { 0..SAMPLES } else { number..number + 1 };
        let (mut sum, mut total) = (Vec3A::ZERO, 0.0);
        for (j, down) in (-1..=1).zip(KERNEL) {
            for (i, across) in (-1..=1).zip(KERNEL) {
                let (x, y) = (pixel % width + i * step, pixel / width + j * step);
                if !(0..width).contains(&x) || !(0..height).contains(&y) {
                    continue;
                }
                let samples = &self.places[(y * width + x) as usize * SAMPLES..][numbers.clone()];
                for there in samples.iter().filter_map(|place| place.checked_sub(1)) {
                    let there = there as usize;
                    let alike = surface_weight(&self.guides[place], &self.guides[there], step as f32);
                    sum += light[there] * (down * across * alike);
                    total += down * across * alike;
                }
            }
        }
        sum / total
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::material::noise::cell1;

    /// A picture of 32 by 32 pixels a decimetre apart, of which every third column is a fence of edges.
    #[test]
    fn noise_goes_and_two_surfaces_stay_apart() {
        let samples: Vec<usize> =
            (0..32 * 32 * SAMPLES).filter(|sample| (sample / SAMPLES).is_multiple_of(3)).collect();
        let guide = |&sample: &usize| {
            let (x, y) = (sample / SAMPLES % 32, sample / SAMPLES / 32);
            let normal = if y < 16 { Vec3A::Y } else { Vec3A::Z };
            DenoiseGuide { position: Vec3A::new(x as f32, y as f32, 0.0) * 0.1, normal, reach_m: 0.1 }
        };
        let above = |sample: &usize| sample / SAMPLES < 16 * 32;
        let noisy = samples.iter().map(|s| Vec3A::splat(cell1(*s as u32, 5) + if above(s) { 0.0 } else { 3.0 }));
        let edges = EdgeSamples::new(32, 32, &samples, samples.iter().map(guide).collect());
        let clean = edges.denoise(noisy.collect());
        let errors: Vec<f32> =
            samples.iter().zip(clean).map(|(s, light)| light.x - if above(s) { 0.5 } else { 3.5 }).collect();
        let mean_square = errors.iter().map(|e| e * e).sum::<f32>() / errors.len() as f32;
        // That of the noise is 1/12.
        assert!(mean_square < 1.0 / 60.0, "{mean_square}");
        assert!(errors.iter().all(|e| e.abs() < 0.5), "light of one surface leaks to the other");
    }
}
