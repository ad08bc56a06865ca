//! Depth as colour: near is warm, far is cold, the sky is dark.

use endless_dataset::depth_from_rgb;
use endless_world::{FAR_PLANE_M, Image, math};

/// Depth of the first and of the last colour, metres.
const NEAR_M: f32 = 2.0;
const FAR_M: f32 = 200.0;
const SKY: [u8; 3] = [24, 16, 32];

/// A stored depth image in colours, by the logarithm of the depth.
pub(crate) fn depth_in_color(stored: &Image<[u8; 3]>) -> Image<[u8; 3]> {
    let depth = depth_from_rgb(stored);
    let table: Vec<[u8; 3]> = (0..=255).map(|i| turbo(i as f32 / 255.0)).collect();
    let scale = 255.0 / math::log2(FAR_M / NEAR_M);
    let color = |&metres: &f32| {
        if metres >= 0.999 * FAR_PLANE_M {
            return SKY;
        }
        let step = math::log2(metres.clamp(NEAR_M, FAR_M) / NEAR_M) * scale;
        table[255 - (step.round() as usize).min(255)]
    };
    Image { size: depth.size, data: depth.data.iter().map(color).collect() }
}

/// The colour map Turbo (Mikhailov 2019) by polynomials.
fn turbo(x: f32) -> [u8; 3] {
    const RED: [f32; 6] = [0.135_721_38, 4.615_392_6, -42.660_32, 132.131_08, -152.942_4, 59.286_38];
    const GREEN: [f32; 6] = [0.091_402_61, 2.194_188_4, 4.842_966_6, -14.185_033, 4.277_298_6, 2.829_566];
    const BLUE: [f32; 6] = [0.106_673_3, 12.641_946, -60.582_047, 110.362_77, -89.903_11, 27.348_25];
    let value = |factors: [f32; 6]| factors.iter().rev().fold(0.0, |sum, factor| sum * x + factor);
    [RED, GREEN, BLUE].map(|factors| (255.0 * value(factors).clamp(0.0, 1.0)).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_dataset::rgb_from_depth;
    use endless_world::ImageSize;

    #[test]
    fn near_is_red_far_is_blue_and_the_sky_is_dark() {
        let depths = vec![1.0, 20.0, 100.0, 200.0, 900.0, FAR_PLANE_M];
        let stored = rgb_from_depth(&Image { size: ImageSize { width: 6, height: 1 }, data: depths });
        let colors = depth_in_color(&stored).data;
        let [r, g, b] = colors[0];
        assert!(r > 100 && g < 40 && b < 40, "{:?}", colors[0]);
        assert!(colors[1][1] > 200, "{:?}", colors[1]);
        assert!(colors[2][2] > 150 && colors[2][0] < 90, "{:?}", colors[2]);
        assert_eq!(colors[3], colors[4], "as far as colours go");
        assert_eq!(colors[5], SKY);
    }
}
