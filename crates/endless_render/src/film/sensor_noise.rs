//! Noise of a sensor: of photons and of the amplifier, strongest, after the tone curve, in the darker tones.

use crate::material::noise::hash;

/// Places in the table of noise where rows of a picture may start.
const STARTS: usize = 1 << 15;
/// Entries of the table: no row of a picture is longer than what follows the last start.
const ENTRIES: usize = STARTS + (1 << 16);
/// The table's unit, as a share of the standard deviation.
const UNIT: f32 = 1.0 / 64.0;

/// Noise of one camera.
#[derive(Debug, Clone)]
pub(crate) struct SensorNoise {
    /// Red, green and blue of one pixel after another, nearly normal: mostly common to the three.
    table: Vec<[i16; 3]>,
    /// Strength on black, in 2^-20ths of the table's unit, and how much less it is for each step of the value.
    strength: [i32; 2],
    key: u32,
}

impl SensorNoise {
    /// Noise with a standard deviation in middle grey, in 255ths.
    pub(crate) fn new(deviation: f32, seed: u64) -> Self {
        let key = hash(seed as u32 ^ hash((seed >> 32) as u32));
        let table = (0..ENTRIES as u32)
            .map(|i| {
                let own = hash(key ^ i);
                let common = normal(hash(own));
                [0u32, 1, 2].map(|c| {
                    let noise = 0.85 * common + 0.5 * normal(own.rotate_left(11 * c).wrapping_mul(0x9e37_79b1));
                    (noise / UNIT).round() as i16
                })
            })
            .collect();
        let strength = [1.35, 0.7 / 255.0].map(|share| (deviation * share * UNIT * (1 << 20) as f32).round() as i32);
        Self { table, strength, key }
    }

    /// Adds the noise of a frame to a picture.
    pub(crate) fn add(&self, frame: u32, width: usize, rgb: &mut [[u8; 3]]) {
        let key = self.key ^ hash(frame);
        for (y, row) in rgb.chunks_mut(width).enumerate() {
            let start = hash(key ^ y as u32) as usize % STARTS;
            let noise = self.table[start..].as_flattened();
            let [black, less] = self.strength;
            for (value, noise) in row.as_flattened_mut().iter_mut().zip(noise) {
                let strength = black - less * i32::from(*value);
                let change = (strength * i32::from(*noise) + (1 << 19)) >> 20;
                *value = (i32::from(*value) + change).clamp(0, 255) as u8;
            }
        }
    }
}

/// Nearly a standard normal: the sum of four bytes.
fn normal(bits: u32) -> f32 {
    let sum: u32 = bits.to_le_bytes().iter().map(|&b| u32::from(b)).sum();
    (sum as f32 - 510.0) / 147.8
}
