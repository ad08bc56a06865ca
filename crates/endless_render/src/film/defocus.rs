//! A lens out of focus: the picture is blurred, alike at all distances.

use endless_world::{ImageSize, math};
use glam::Vec3A;

/// Blurs a picture by a Gaussian of this standard deviation, pixels; the border is repeated.
pub(super) fn blurred(size: ImageSize, picture: &[Vec3A], deviation: f32) -> Vec<Vec3A> {
    let kernel = kernel(deviation);
    let (width, height) = (size.width as usize, size.height as usize);
    let reach = kernel.len() - 1;
    let mix = |at: &dyn Fn(usize) -> Vec3A, i: usize, n: usize| {
        (1..=reach)
            .fold(at(i) * kernel[0], |sum, k| sum + (at(i.saturating_sub(k)) + at((i + k).min(n - 1))) * kernel[k])
    };
    let mut across = Vec::with_capacity(picture.len());
    for row in picture.chunks_exact(width) {
        across.extend((0..width).map(|x| mix(&|x| row[x], x, width)));
    }
    let column = |x: usize| move |y: usize| y * width + x;
    let mut through = Vec::with_capacity(picture.len());
    for y in 0..height {
        through.extend((0..width).map(|x| mix(&|y| across[column(x)(y)], y, height)));
    }
    through
}

/// Weights of the middle and of each distance from it, of sum 1 with both sides.
fn kernel(deviation: f32) -> Vec<f32> {
    let reach = (3.0 * deviation).ceil().max(1.0) as usize;
    let weight = |k: usize| math::exp(-0.5 * (k as f32 / deviation) * (k as f32 / deviation));
    let weights: Vec<f32> = (0..=reach).map(weight).collect();
    let sum = weights[0] + 2.0 * weights[1..].iter().sum::<f32>();
    weights.into_iter().map(|weight| weight / sum).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_point_spreads_and_no_light_is_lost() {
        let size = ImageSize { width: 41, height: 31 };
        let mut picture = vec![Vec3A::ZERO; size.pixels()];
        picture[15 * 41 + 20] = Vec3A::ONE;
        let through = blurred(size, &picture, 1.5);
        let sum: f32 = through.iter().map(|p| p.x).sum();
        assert!((sum - 1.0).abs() < 1e-4, "{sum}");
        let second: f32 = (0..41)
            .map(|x| (x as f32 - 20.0) * (x as f32 - 20.0) * (0..31).map(|y| through[y * 41 + x].x).sum::<f32>())
            .sum();
        assert!((1.9..2.4).contains(&second), "variance {second} of a deviation of 1.5");
        assert_eq!(blurred(size, &vec![Vec3A::ONE; size.pixels()], 0.7).len(), size.pixels());
    }
}
