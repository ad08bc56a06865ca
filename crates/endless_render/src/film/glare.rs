//! Light that spreads in the lens around bright things (Spencer et al. 1995, in broad strokes): a small share of the
//! picture, blurred at three widths, computed at a quarter of the resolution.

use endless_world::ImageSize;
use endless_world::math::UnfusedVec3A;
use glam::Vec3A;

/// Side of the squares of pixels that become one.
pub(super) const REDUCE: usize = 4;
/// (box radius in reduced pixels, share).
const LOBES: [(usize, f32); 3] = [(1, 0.5), (4, 0.3), (13, 0.2)];

/// Mixes a share of blurred light into a picture; gives each row's light to `develop`.
pub(crate) fn with_glare(size: ImageSize, pixels: &[Vec3A], share: f32, mut develop: impl FnMut(&[Vec3A])) {
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
    let mut lit = Vec::with_capacity(width);
    for (y, pixels) in pixels.chunks_exact(width).enumerate() {
        let (y0, y1, v) = place(y, h);
        let (top, bottom) = (&glow[y0 * w..][..w], &glow[y1 * w..][..w]);
        for ((mixed, &a), &b) in row.iter_mut().zip(top).zip(bottom) {
            *mixed = a.lerp_unfused(b, v) * share;
        }
        lit.clear();
        let glow = |&(x0, x1, u): &(usize, usize, f32)| row[x0].lerp_unfused(row[x1], u);
        lit.extend(pixels.iter().zip(&columns).map(|(&pixel, column)| pixel * (1.0 - share) + glow(column)));
        develop(&lit);
    }
}

/// Means of squares of pixels.
pub(super) fn reduce(width: usize, height: usize, pixels: &[Vec3A], w: usize, h: usize) -> Vec<Vec3A> {
    let mut small = vec![Vec3A::ZERO; w * h];
    for (y, row) in pixels.chunks_exact(width).take(height).enumerate() {
        for (sum, square) in small[(y / REDUCE) * w..][..w].iter_mut().zip(row.chunks(REDUCE)) {
            *sum = square.iter().fold(*sum, |sum, &pixel| sum + pixel);
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
    // Columns of the first are rows of the second.
    blur_rows(&blur_rows(from, w, h, radius), h, w, radius)
}

/// Box filter along rows, several of which go together; what were rows of `from` are columns of what comes out.
fn blur_rows(from: &[Vec3A], w: usize, h: usize, radius: usize) -> Vec<Vec3A> {
    /// Rows whose sums do not wait for each other.
    const TOGETHER: usize = 8;
    let scale = 1.0 / (2 * radius + 1) as f32;
    let r = radius as isize;
    let mut turned = vec![Vec3A::ZERO; w * h];
    for first in (0..h).step_by(TOGETHER) {
        // The last group goes over its last row again and again.
        let rows: [&[Vec3A]; TOGETHER] = std::array::from_fn(|k| &from[(first + k).min(h - 1) * w..][..w]);
        let at = |k: usize, i: isize| rows[k][i.clamp(0, w as isize - 1) as usize];
        let mut sums: [Vec3A; TOGETHER] = std::array::from_fn(|k| (-r..=r).map(|i| at(k, i)).sum());
        for (i, column) in turned.chunks_exact_mut(h).enumerate() {
            for (out, sum) in column[first..].iter_mut().zip(&sums) {
                *out = *sum * scale;
            }
            let i = i as isize;
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum = (*sum + at(k, i + r + 1) - at(k, i - r)).max(Vec3A::ZERO);
            }
        }
    }
    turned
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
        with_glare(size, &pixels, 0.1, |row| spread.extend_from_slice(row));
        let total: f32 = spread.iter().map(|p| p.x).sum();
        assert!((total - 1000.0).abs() < 60.0, "{total}");
        assert!(spread[23 * 61 + 36].x > spread[5 * 61 + 5].x);
        let flat = vec![Vec3A::ONE; size.pixels()];
        with_glare(size, &flat, 0.1, |row| assert!(row.iter().all(|r| (r.x - 1.0).abs() < 1e-4)));
    }
}
