//! Light that spreads in the lens around bright things (Spencer et al. 1995, in broad strokes): a small share of the
//! picture, blurred at three widths, computed at a quarter of the resolution.

use endless_world::ImageSize;
use glam::Vec3A;

const REDUCE: usize = 4;
/// (box radius in reduced pixels, share).
const LOBES: [(usize, f32); 3] = [(1, 0.5), (4, 0.3), (13, 0.2)];

/// Mixes a share of blurred light into a picture.
pub(crate) fn add_glare(size: ImageSize, pixels: &mut [Vec3A], share: f32) {
    let (width, height) = (size.width as usize, size.height as usize);
    let (w, h) = (width.div_ceil(REDUCE), height.div_ceil(REDUCE));
    let small = reduce(width, height, pixels, w, h);
    let mut glow = vec![Vec3A::ZERO; w * h];
    for (radius, part) in LOBES {
        let mut blurred = small.clone();
        for _ in 0..2 {
            blurred = box_blur(&blurred, w, h, radius);
        }
        for (g, b) in glow.iter_mut().zip(&blurred) {
            *g += *b * part;
        }
    }
    for y in 0..height {
        let v = ((y as f32 + 0.5) / REDUCE as f32 - 0.5).clamp(0.0, (h - 1) as f32);
        let (y0, fy) = (v as usize, v - (v as usize) as f32);
        let y1 = (y0 + 1).min(h - 1);
        for x in 0..width {
            let u = ((x as f32 + 0.5) / REDUCE as f32 - 0.5).clamp(0.0, (w - 1) as f32);
            let (x0, fx) = (u as usize, u - (u as usize) as f32);
            let x1 = (x0 + 1).min(w - 1);
            let top = glow[y0 * w + x0].lerp(glow[y0 * w + x1], fx);
            let bottom = glow[y1 * w + x0].lerp(glow[y1 * w + x1], fx);
            let pixel = &mut pixels[y * width + x];
            *pixel = *pixel * (1.0 - share) + top.lerp(bottom, fy) * share;
        }
    }
}

fn reduce(width: usize, height: usize, pixels: &[Vec3A], w: usize, h: usize) -> Vec<Vec3A> {
    let mut small = vec![Vec3A::ZERO; w * h];
    for y in 0..height {
        for x in 0..width {
            small[(y / REDUCE) * w + x / REDUCE] += pixels[y * width + x];
        }
    }
    for (i, s) in small.iter_mut().enumerate() {
        let columns = REDUCE.min(width - (i % w) * REDUCE);
        let rows = REDUCE.min(height - (i / w) * REDUCE);
        *s /= (columns * rows) as f32;
    }
    small
}

/// Box filter along rows, then along columns; the border is repeated.
fn box_blur(from: &[Vec3A], w: usize, h: usize, radius: usize) -> Vec<Vec3A> {
    let mut rows = vec![Vec3A::ZERO; w * h];
    for y in 0..h {
        blur_line(|i| from[y * w + i], |i, v| rows[y * w + i] = v, w, radius);
    }
    let mut out = vec![Vec3A::ZERO; w * h];
    for x in 0..w {
        blur_line(|i| rows[i * w + x], |i, v| out[i * w + x] = v, h, radius);
    }
    out
}

fn blur_line(get: impl Fn(usize) -> Vec3A, mut set: impl FnMut(usize, Vec3A), n: usize, radius: usize) {
    let at = |i: isize| get(i.clamp(0, n as isize - 1) as usize);
    let r = radius as isize;
    let mut sum: Vec3A = (-r..=r).map(at).sum();
    let scale = 1.0 / (2 * radius + 1) as f32;
    for i in 0..n {
        set(i, sum * scale);
        let i = i as isize;
        sum = (sum + at(i + r + 1) - at(i - r)).max(Vec3A::ZERO);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn glare_spreads_but_keeps_the_light() {
        let size = ImageSize { width: 61, height: 47 };
        let mut pixels = vec![Vec3A::ZERO; size.pixels()];
        pixels[23 * 61 + 30] = Vec3A::splat(1000.0);
        add_glare(size, &mut pixels, 0.1);
        let total: f32 = pixels.iter().map(|p| p.x).sum();
        assert!((total - 1000.0).abs() < 60.0, "{total}");
        assert!(pixels[23 * 61 + 36].x > pixels[5 * 61 + 5].x);
        let mut flat = vec![Vec3A::ONE; size.pixels()];
        add_glare(size, &mut flat, 0.1);
        assert!(flat.iter().all(|p| (p.x - 1.0).abs() < 1e-4));
    }
}
