//! Noise of a sensor: of photons and of the amplifier, strongest, after the tone curve, in the darker tones.

use crate::material::noise::hash;

/// Entries of the table of noise; rows of a picture start in it at random.
const ENTRIES: usize = 1 << 15;
/// The table's unit, as a share of the standard deviation.
const UNIT: f32 = 1.0 / 64.0;

/// Noise of one camera.
#[derive(Debug, Clone)]
pub(crate) struct Grain {
    /// Red, green and blue of one pixel after another, nearly normal: mostly common to the three.
    table: Vec<[i16; 3]>,
    /// Strength by the value that it is added to, in 256ths of the table's unit.
    strength: [i32; 256],
    key: u32,
}

impl Grain {
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
        let strength =
            std::array::from_fn(|v| (deviation * (1.35 - 0.7 * v as f32 / 255.0) * UNIT * 65_536.0).round() as i32);
        Self { table, strength, key }
    }

    /// Adds the noise of a frame to a picture.
    pub(crate) fn add(&self, frame: u32, width: usize, rgb: &mut [[u8; 3]]) {
        let key = self.key ^ hash(frame);
        for (y, row) in rgb.chunks_mut(width).enumerate() {
            let start = hash(key ^ y as u32) as usize % ENTRIES;
            let noise = self.table[start..].iter().chain(self.table.iter().cycle());
            for (pixel, noise) in row.iter_mut().zip(noise) {
                for (value, noise) in pixel.iter_mut().zip(noise) {
                    let change = (self.strength[usize::from(*value)] * i32::from(*noise) + 32_768) >> 16;
                    *value = (i32::from(*value) + change).clamp(0, 255) as u8;
                }
            }
        }
    }
}

/// Nearly a standard normal: the sum of four bytes.
fn normal(bits: u32) -> f32 {
    let sum: u32 = bits.to_le_bytes().iter().map(|&b| u32::from(b)).sum();
    (sum as f32 - 510.0) / 147.8
}
