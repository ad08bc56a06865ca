//! Light that spreads in the lens around bright things (Spencer et al. 1995, in broad strokes): a small share of the
//! picture, blurred at three widths, computed at a quarter of the resolution.

use endless_world::ImageSize;
use endless_world::math::UnfusedVec3A;
use glam::Vec3A;

/// Side of the squares of pixels that become one.
pub(super) const REDUCE: usize = 4;
/// (box radius in reduced pixels, share).
const LOBES: [(usize, f32); 3] = [(1, 0.5), (4, 0.3), (13, 0.2)];

/// Mixes a share of blurred light into a picture; gives each pixel's light to `develop`, row by row.
pub(crate) fn with_glare(size: ImageSize, pixels: &[Vec3A], share: f32, mut develop: impl FnMut(Vec3A)) {
    let (width, height) = (size.width as usize, size.height as usize);
    let (w, h) = (width.div_ceil(REDUCE), height.div_ceil(REDUCE));
    let small = reduce(width, height, pixels, w, h);
    let mut glow = vec![Vec3A::ZERO; w * h];
    for (radius, part) in LOBES {
        let blurred = box_blur(&box_blur(&small, w, h, radius), w, h, radius);
        for (g, b) in glow.iter_mut().zip(&blurred) {
            *g += *b * part;
        }
    }
    // Bilinear: rows first, then along the row.
    let place = |i: usize, n: usize| {
        let at = ((i as f32 + 0.5) / REDUCE as f32 - 0.5).clamp(0.0, (n - 1) as f32);
        (at as usize, (at as usize + 1).min(n - 1), at - (at as usize) as f32)
    };
    let columns: Vec<(usize, usize, f32)> = (0..width).map(|x| place(x, w)).collect();
    let mut row = vec![Vec3A::ZERO; w];
    for (y, pixels) in pixels.chunks_exact(width).enumerate() {
        let (y0, y1, v) = place(y, h);
        let (top, bottom) = (&glow[y0 * w..][..w], &glow[y1 * w..][..w]);
        for ((mixed, &a), &b) in row.iter_mut().zip(top).zip(bottom) {
            *mixed = a.lerp_unfused(b, v) * share;
        }
        for (&pixel, &(x0, x1, u)) in pixels.iter().zip(&columns) {
            develop(pixel * (1.0 - share) + row[x0].lerp_unfused(row[x1], u));
        }
    }
}

/// Means of squares of pixels.
pub(super) fn reduce(width: usize, height: usize, pixels: &[Vec3A], w: usize, h: usize) -> Vec<Vec3A> {
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
pub(super) fn box_blur(from: &[Vec3A], w: usize, h: usize, radius: usize) -> Vec<Vec3A> {
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
        let mut spread = Vec::new();
        with_glare(size, &pixels, 0.1, |r| spread.push(r));
        let total: f32 = spread.iter().map(|p| p.x).sum();
        assert!((total - 1000.0).abs() < 60.0, "{total}");
        assert!(spread[23 * 61 + 36].x > spread[5 * 61 + 5].x);
        let flat = vec![Vec3A::ONE; size.pixels()];
        with_glare(size, &flat, 0.1, |r| assert!((r.x - 1.0).abs() < 1e-4));
    }
}
