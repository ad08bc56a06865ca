//! Value noise at many places, found together: eight at a time.

use super::noise::value2x8;
use super::noise_questions::NoiseQuestions;
use wide::f32x8;

/// Most places of a batch.
const MOST: usize = 32;

/// Places at which a material wants noise, all seen by one footprint.
pub(super) struct NoiseBatch {
    footprint_m: f32,
    x: [f32; MOST],
    y: [f32; MOST],
    /// Places are divided by it, metres.
    wavelength: [f32; MOST],
    /// Added after that.
    offset: [f32; MOST],
    amplitude: [f32; MOST],
    /// The footprint takes away what is shorter, metres.
    detail: [f32; MOST],
    salt: [u32; MOST],
    count: usize,
}

/// What was asked of a batch.
#[derive(Clone, Copy)]
pub(super) struct Asked {
    first: usize,
    count: usize,
}

impl NoiseQuestions<f32> for NoiseBatch {
    type Asked = Asked;

    #[inline]
    fn new(footprint_m: f32) -> Self {
        let none = [0.0; MOST];
        let (wavelength, salt) = ([1.0; MOST], [0; MOST]);
        Self { footprint_m, x: none, y: none, wavelength, offset: none, amplitude: none, detail: none, salt, count: 0 }
    }

    #[inline]
    fn value2(&mut self, p: [f32; 2], salt: u32) -> Asked {
        let first = self.count;
        self.push(p, 1.0, 0.0, 1.0, f32::MAX, salt);
        Asked { first, count: self.count - first }
    }

    #[inline]
    fn fbm2_of(&mut self, p: [f32; 2], wavelength_m: f32, octaves: u32) -> Asked {
        let first = self.count;
        let (mut amplitude, mut wavelength) = (0.5, wavelength_m);
        let finest = self.footprint_m.max(1e-4);
        for octave in 0..octaves {
            if wavelength <= finest {
                break;
            }
            self.push(p, wavelength, octave as f32 * 0.7 * 13.7, amplitude, wavelength, octave + 31);
            amplitude *= 0.55;
            wavelength *= 0.47;
        }
        Asked { first, count: self.count - first }
    }

    #[inline]
    fn fbm2(&mut self, p: [f32; 2], wavelength_m: f32, octaves: u32) -> Self::Asked {
        self.fbm2_of(p, wavelength_m, octaves)
    }

    #[inline]
    fn found(&self) -> impl Fn(Asked) -> f32 {
        let values = self.values();
        move |asked| values[asked.first..asked.first + asked.count].iter().fold(0.0, |sum, value| sum + value)
    }
}

impl NoiseBatch {
    #[inline]
    fn push(&mut self, [x, y]: [f32; 2], wavelength: f32, offset: f32, amplitude: f32, detail: f32, salt: u32) {
        let i = self.count;
        assert!(i < MOST, "too much is asked of one batch of noise");
        (self.x[i], self.y[i], self.wavelength[i], self.offset[i]) = (x, y, wavelength, offset);
        (self.amplitude[i], self.detail[i], self.salt[i]) = (amplitude, detail, salt);
        self.count += 1;
    }

    /// What is found at each place, by its number.
    fn values(&self) -> [f32; MOST] {
        let mut values = [0.0; MOST];
        let finest = f32x8::splat(self.footprint_m.max(1e-4));
        for first in (0..self.count).step_by(8) {
            let eight = |of: &[f32; MOST]| f32x8::new(std::array::from_fn(|i| of[first + i]));
            let (wavelength, offset) = (eight(&self.wavelength), eight(&self.offset));
            let half = f32x8::splat(0.5);
            let kept = eight(&self.detail) / finest * half - half;
            let kept = kept.fast_max(f32x8::ZERO).fast_min(f32x8::ONE);
            let salts = std::array::from_fn(|i| self.salt[first + i]);
            let noise = value2x8([&self.x, &self.y].map(|axis| eight(axis) / wavelength + offset), salts);
            let scaled = eight(&self.amplitude) * kept * noise;
            values[first..first + 8].copy_from_slice(scaled.as_array());
        }
        values
    }
}

#[cfg(test)]
mod tests {
    use super::super::noise;
    use super::*;
    use glam::Vec2;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn a_batch_finds_what_single_questions_do(
            x in -1e3f32..1e3, y in -1e3f32..1e3, wavelength_m in 0.02f32..90.0, octaves in 1u32..7,
            footprint_m in 0.0005f32..3.0, salt: u32,
        ) {
            let mut batch = NoiseBatch::new(footprint_m);
            let value = batch.value2([x, y], salt);
            let sums = [0.0, 5.0, 9.0].map(|aside| batch.fbm2([x + aside, y + aside], wavelength_m, octaves));
            let found = batch.found();
            let p = Vec2::new(x, y);
            prop_assert_eq!(found(value), noise::value2(p, salt));
            for (sum, aside) in sums.into_iter().zip([0.0, 5.0, 9.0]) {
                prop_assert_eq!(found(sum), noise::filtered_fbm2(p + aside, wavelength_m, octaves, footprint_m));
            }
        }
    }
}
