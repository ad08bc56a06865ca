//! Collars, lapels, ties, scarves and belts.

use super::body::Body;
use super::cage::Cage;
use super::clothes::{Collar, Garment, GarmentTop};
use super::palette;
use super::skin::Skin;
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::math::lerp;
use glam::Vec3;

/// What a garment has at its neck.
pub(crate) fn add(skin: &mut Skin, body: &Body<'_>, g: &Garment) {
    let e = g.ease;
    let dip = if let GarmentTop::Neck { dip, .. } = g.upper { dip } else { 0.0 };
    match g.collar {
        Collar::None => {}
        Collar::Shirt => {
            band(skin, body, &[(-0.10, e + 0.014), (0.10, e + 0.011), (0.28, 0.7 * e + 0.005)], dip, g.material);
        }
        Collar::Stand => {
            band(skin, body, &[(-0.06, 0.7 * e + 0.008), (0.42, 0.5 * e + 0.008), (0.36, 0.3 * e)], dip, g.material);
        }
        Collar::Hood => {
            ring(skin, body, &[(-0.12, e + 0.006), (0.08, e + 0.026), (0.32, e + 0.020), (0.25, 0.004)], g.material);
            let at = body.neck_ring(0.1, 0.0)[8];
            let lump = Sculpt::ellipsoid(
                at - Vec3::new(0.034, 0.0, 0.030) * body.h,
                Vec3::new(0.040, 0.062, 0.040) * body.h,
                10,
                g.material,
            );
            skin.add(lump, |p| body.trunk_weights(p));
        }
        Collar::Scarf => {
            ring(skin, body, &[(-0.25, e + 0.016), (0.05, e + 0.034), (0.40, e + 0.026), (0.5, 0.006)], g.accent);
        }
        Collar::Lapels { tie } => {
            lapels(skin, body, g);
            if tie {
                necktie(skin, body, g.accent);
            }
        }
    }
}

/// A band around the neck, open in front where the neckline dips.
fn band(skin: &mut Skin, body: &Body<'_>, rows: &[(f32, f32)], dip: f32, material: Material) {
    let mut cage = Cage::default();
    let spread = 0.010 + 0.022 * dip;
    let numbers: Vec<Vec<u32>> = rows
        .iter()
        .map(|&(up, ease)| {
            let ring = body.neck_ring(up, ease);
            let mut open: Vec<Vec3> = ring.to_vec();
            open.push(ring[0]);
            open[0].y += spread * body.h;
            open[16].y -= spread * body.h;
            open[0].z -= 0.010 * body.h;
            open[16].z -= 0.010 * body.h;
            cage.row(&open, |p| body.trunk_weights(p))
        })
        .collect();
    for pair in numbers.windows(2) {
        cage.strip(&pair[0], &pair[1], false, false, |_| material);
    }
    cage.add_to(skin, |_, _| 0.0, |_| Vec3::ZERO);
}

/// A closed roll around the neck.
fn ring(skin: &mut Skin, body: &Body<'_>, rows: &[(f32, f32)], material: Material) {
    let mut cage = Cage::default();
    let numbers: Vec<Vec<u32>> =
        rows.iter().map(|&(up, ease)| cage.row(&body.neck_ring(up, ease), |p| body.trunk_weights(p))).collect();
    for pair in numbers.windows(2) {
        cage.strip(&pair[0], &pair[1], true, false, |_| material);
    }
    cage.add_to(skin, |_, _| 0.0, |_| Vec3::ZERO);
}

/// A point of the front at a height and this far to the left, both over the body's measures.
fn front(body: &Body<'_>, t: f32, y: f32, ease: f32) -> Vec3 {
    let place = |row: &[Vec3; 16]| {
        let wanted = y * body.h;
        let k = (1..5).find(|&k| row[k].y >= wanted).unwrap_or(4);
        let (a, b) = (row[k - 1], row[k]);
        let s = ((wanted - a.y) / (b.y - a.y).max(1e-4)).clamp(0.0, 1.0);
        a.lerp(b, s)
    };
    if t <= 0.776 {
        return place(&body.trunk_ring(t, ease));
    }
    let rows = body.bust_rows(0.0, 0.0, &|_| ease);
    let (low, high) = (place(&rows[1]), place(&rows[2]));
    low.lerp(high, (t - 0.776) / 0.030)
}

fn lapels(skin: &mut Skin, body: &Body<'_>, g: &Garment) {
    let h = body.h;
    let gap = g.gap.map_or(0.004, |gap| gap.1);
    let mut s = Sculpt::new();
    let rows = 6;
    // From the neck down to the button: inner edge, outer edge.
    let line = |i: usize, lift: f32| {
        let k = i as f32 / rows as f32;
        let t = lerp(0.806, 0.665, k);
        let wide = 0.036 * (1.0 - k) * if i == 0 { 0.6 } else { 1.0 } + 0.003;
        let inner = lerp(gap.max(0.030), gap.min(0.014), k);
        let out = Vec3::X * lift * h;
        [front(body, t, inner, g.ease) + out, front(body, t, inner + wide, g.ease) + out]
    };
    for i in 0..rows {
        let ([a, b], [c, d]) = (line(i, 0.006), line(i + 1, 0.006));
        s.quad([c, d, b, a], g.material);
        let ([e, f], [p, q]) = (line(i, 0.001), line(i + 1, 0.001));
        s.quad([d, q, f, b], g.material);
        let _ = (e, p);
    }
    skin.add(s.smooth(40.0).both_sides(), |p| body.trunk_weights(p));
}

fn necktie(skin: &mut Skin, body: &Body<'_>, material: Material) {
    let rows: Vec<Vec<Vec3>> =
        [(0.60f32, 0.004f32), (0.615, 0.017), (0.70, 0.014), (0.78, 0.010), (0.806, 0.009), (0.815, 0.012)]
            .iter()
            .map(|&(t, half)| {
                let p = front(body, t, 0.0, 0.012) + Vec3::X * 0.006 * body.h;
                [-1.0, 1.0].map(|k| p + Vec3::Y * k * half * body.h).to_vec()
            })
            .collect();
    let mut s = Sculpt::new();
    s.grid(&rows, false, material);
    skin.add(s.smooth(60.0), |p| body.trunk_weights(p));
}

/// A belt over tucked-in cloth.
pub(crate) fn belt(skin: &mut Skin, body: &Body<'_>, ease: f32) {
    let leather = palette::linear(Surface::Leather, [0.022, 0.017, 0.014]);
    let mut cage = Cage::default();
    let rows = [(0.584, ease + 0.001), (0.584, ease + 0.005), (0.602, ease + 0.005), (0.602, ease - 0.002)];
    let numbers: Vec<Vec<u32>> =
        rows.iter().map(|&(t, e)| cage.row(&body.trunk_ring(t, e), |p| body.trunk_weights(p))).collect();
    for pair in numbers.windows(2) {
        cage.strip(&pair[0], &pair[1], true, false, |_| leather);
    }
    cage.add_to(skin, |_, _| 0.0, |_| Vec3::ZERO);
}
