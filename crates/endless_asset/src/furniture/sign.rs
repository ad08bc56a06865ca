//! Traffic signs, facing +x.

use super::glyph::{line, text};
use super::lamp::pole;
use super::paint;
use crate::shape::Sculpt;
use endless_scene::Material;
use glam::{Vec2, Vec3};

/// Front of the plates.
pub(crate) const FRONT: f32 = 0.065;
/// One layer of sign film: enough that layers never fight.
pub(crate) const LAYER: f32 = 0.0015;

/// A regular polygon or disc in the (y, z) plane, first corner at this angle from the top.
pub(crate) fn regular(n: usize, radius: f32, first: f32) -> Vec<Vec2> {
    (0..n)
        .map(|i| {
            let (sin, cos) = endless_world::math::sin_cos(first + std::f32::consts::TAU * i as f32 / n as f32);
            Vec2::new(-sin, cos) * radius
        })
        .collect()
}

/// A plate: metal back and edge, and a coloured face.
pub(crate) fn plate(s: &mut Sculpt, outline: &[Vec2], z: f32, color: Material) {
    let at = |x: f32| -> Vec<Vec3> { outline.iter().map(|p| Vec3::new(x, p.x, z + p.y)).collect() };
    // The outline runs clockwise seen from +x when it starts at the top and turns to −y... it is brought into order.
    let area: f32 = (0..outline.len()).map(|i| outline[i].perp_dot(outline[(i + 1) % outline.len()])).sum();
    let order = |mut v: Vec<Vec3>| {
        if area < 0.0 {
            v.reverse();
        }
        v
    };
    let (front, back) = (order(at(FRONT)), order(at(FRONT - 0.012)));
    s.polygon(&front, color);
    s.polygon(&back.iter().rev().copied().collect::<Vec<_>>(), paint::SIGN_BACK);
    s.grid(&[back, front], true, paint::SIGN_BACK);
}

/// A further layer of film on the face.
pub(crate) fn film(s: &mut Sculpt, outline: &[Vec2], z: f32, layer: f32, color: Material) {
    let area: f32 = (0..outline.len()).map(|i| outline[i].perp_dot(outline[(i + 1) % outline.len()])).sum();
    let mut points: Vec<Vec3> = outline.iter().map(|p| Vec3::new(FRONT + layer * LAYER, p.x, z + p.y)).collect();
    if area < 0.0 {
        points.reverse();
    }
    s.polygon(&points, color);
}

pub(crate) fn post(height: f32) -> Sculpt {
    let mut s = pole(height, 0.038, 0.032, paint::POLE);
    for z in [height - 0.16, height - 0.5] {
        s.add(Sculpt::cuboid(Vec3::new(-0.045, -0.06, z), Vec3::new(FRONT - 0.012, 0.06, z + 0.04), 0.0, paint::POLE));
    }
    s
}

/// Octagon, 0.76 m across.
pub(crate) fn stop() -> Sculpt {
    let z = 2.45;
    let eighth = std::f32::consts::PI / 8.0;
    let mut s = post(z + 0.28);
    plate(&mut s, &regular(8, 0.41, eighth), z, paint::WHITE);
    film(&mut s, &regular(8, 0.385, eighth), z, 1.0, paint::RED);
    s.add(text("STOP", Vec3::new(FRONT + 2.0 * LAYER, 0.0, z), 0.25, 0.036, paint::WHITE));
    s
}

/// Triangle on its tip.
pub(crate) fn give_way() -> Sculpt {
    let z = 2.45;
    let mut s = post(z + 0.20);
    let tip = std::f32::consts::PI;
    plate(&mut s, &regular(3, 0.52, tip), z, paint::RED);
    film(&mut s, &regular(3, 0.335, tip), z, 1.0, paint::WHITE);
    s
}

/// Disc with a red ring and the limit in km/h.
pub(crate) fn speed(variant: u32) -> Sculpt {
    let z = 2.4;
    let mut s = post(z + 0.24);
    plate(&mut s, &regular(32, 0.32, 0.0), z, paint::RED);
    film(&mut s, &regular(32, 0.25, 0.0), z, 1.0, paint::WHITE);
    let limit = ["50", "30", "40"][variant as usize % 3];
    s.add(text(limit, Vec3::new(FRONT + 2.0 * LAYER, 0.0, z), 0.25, 0.042, paint::BLACK));
    s
}

/// Blue square, white triangle, walking figure.
pub(crate) fn crossing() -> Sculpt {
    let z = 2.4;
    let mut s = post(z + 0.26);
    let square = |h: f32| [Vec2::new(-h, -h), Vec2::new(h, -h), Vec2::new(h, h), Vec2::new(-h, h)];
    plate(&mut s, &square(0.32), z, paint::WHITE);
    film(&mut s, &square(0.30), z, 1.0, paint::BLUE);
    film(&mut s, &[Vec2::new(-0.25, -0.22), Vec2::new(0.25, -0.22), Vec2::new(0.0, 0.23)], z, 2.0, paint::WHITE);
    let centre = Vec3::new(FRONT + 3.0 * LAYER, 0.0, z);
    for (a, b, w) in [
        ((0.0, 0.02), (0.0, -0.08), 0.05),
        ((0.0, -0.08), (0.05, -0.18), 0.028),
        ((0.0, -0.08), (-0.06, -0.17), 0.028),
        ((0.0, 0.02), (0.07, -0.06), 0.022),
        ((0.0, 0.02), (-0.07, -0.05), 0.022),
    ] {
        line(&mut s, centre, Vec2::from(a), Vec2::from(b), w, paint::BLACK);
    }
    film(
        &mut s,
        &regular(12, 0.028, 0.0).iter().map(|p| *p + Vec2::new(0.0, 0.075)).collect::<Vec<_>>(),
        z,
        3.0,
        paint::BLACK,
    );
    for y in [-0.12, -0.05, 0.05, 0.12] {
        line(&mut s, centre, Vec2::new(y, -0.205), Vec2::new(y + 0.03, -0.205), 0.018, paint::BLACK);
    }
    s
}
