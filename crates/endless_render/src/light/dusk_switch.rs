//! Which lamps are lit while night falls: one circuit after the other, as dusk switches notice that it is dark.

use crate::material::noise;
use endless_world::math::smoothstep;
use glam::{Vec2, Vec3A};

/// Extent of a circuit, metres: lamps that stand side by side are lit at nearly the same time.
const CIRCUIT_M: f32 = 45.0;
/// How long a lamp takes until it shines with all its power, as a share of the time in which all of them are lit.
const WARM_UP: f32 = 0.35;

/// Power of a lamp at a place, 0 to 1, where this share of all lamps is lit: none at 0, all at 1.
pub(crate) fn lamp_power(place: Vec3A, lamps_lit: f32) -> f32 {
    if lamps_lit >= 1.0 {
        return 1.0;
    }
    // Noise keeps to its middle: stretched, it comes near to an even distribution.
    let turn = smoothstep(-0.6, 0.6, noise::value2(Vec2::new(place.x, place.y) / CIRCUIT_M, 57));
    ((lamps_lit - (1.0 - WARM_UP) * turn) / WARM_UP).clamp(0.0, 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lamps_are_lit_one_after_another_and_stay_lit() {
        let places: Vec<Vec3A> =
            (0..400).map(|i| Vec3A::new((i % 20) as f32 * 25.0, (i / 20) as f32 * 25.0, 8.0)).collect();
        let at = |share: f32| places.iter().map(|&place| lamp_power(place, share)).collect::<Vec<_>>();
        let mut before = at(0.0);
        assert!(before.iter().all(|power| *power == 0.0));
        for step in 1..=20 {
            let now = at(step as f32 / 20.0);
            assert!(now.iter().zip(&before).all(|(now, before)| now >= before));
            if (6..=14).contains(&step) {
                let lit = now.iter().filter(|power| **power > 0.5).count();
                assert!((20..380).contains(&lit), "{lit} of 400 at {step}/20");
            }
            before = now;
        }
        assert!(before.iter().all(|power| *power == 1.0));
    }
}
