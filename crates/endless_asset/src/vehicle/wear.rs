//! What years leave on a car: panels of another colour, dents, dirt, wheels without their caps, stickers.

use super::assemble::Assembly;
use super::car::CarShape;
use super::draw::DesignDraw;
use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Affine3A, Vec2, Vec3};

const fn of(surface: Surface, base_color: [f32; 3]) -> Material {
    Material::new(surface, base_color, ClassTag::Car)
}

/// Primer, filler, and paint of the car that the part came from.
const OTHER_PANELS: [Material; 5] = [
    of(Surface::Painted, [0.20, 0.20, 0.20]),
    of(Surface::Painted, [0.26, 0.10, 0.06]),
    of(Surface::Painted, [0.66, 0.66, 0.64]),
    of(Surface::Painted, [0.03, 0.05, 0.16]),
    of(Surface::Painted, [0.02, 0.02, 0.022]),
];
/// Dust from the road, which covers the paint, and a film of it, which only dulls it.
const DUST: Material = of(Surface::Painted, [0.19, 0.15, 0.11]);
const FILM: Material = of(Surface::CarPaint, [0.72, 0.69, 0.64]);
const CAP: Material = of(Surface::Plastic, [0.30, 0.30, 0.31]);
const STICKERS: [Material; 4] = [paint::WHITE, paint::YELLOW, paint::RED, paint::BLUE];

/// A dent, and where.
#[derive(Debug, Clone, Copy)]
struct Dent {
    centre: Vec3,
    radius: f32,
    depth: f32,
}

/// Wear of a car: each kind of it comes with this probability, more or less.
pub(crate) fn worn(shape: &CarShape, draw: &DesignDraw, much: f64) -> impl FnOnce(&mut Assembly) + 'static {
    let shape = shape.clone();
    let chance = |what: &str, share: f64| draw.chance(what, share * much);
    let other = draw.pick("other panel", &OTHER_PANELS);
    let panel = chance("mismatched panel", 0.6).then(|| draw.pick("which panel", &[0, 1, 2, 3]));
    let on_right = draw.chance("panel side", 0.5);
    let dust_m = if chance("dust", 0.8) { draw.range("dust height", 0.04, 0.16) } else { 0.0 };
    let film_m = if dust_m > 0.0 { draw.range("film height", 0.10, 0.30) } else { 0.0 };
    let caps = if chance("caps", 0.7) { draw.pick("caps left", &[0b0111, 0b1101, 0b0110, 0b1000, 0b1111]) } else { 0 };
    let stickers = if chance("stickers", 0.5) { draw.pick("how many stickers", &[1, 2, 4]) } else { 0 };
    let dent = chance("dent", 0.6).then(|| Dent {
        centre: Vec3::new(
            draw.range("dent x", -0.35, 0.35) * shape.length,
            if draw.chance("dent side", 0.5) { shape.half_width } else { -shape.half_width },
            draw.range("dent z", 0.45, 0.75),
        ),
        radius: draw.range("dent radius", 0.22, 0.42),
        depth: draw.range("dent depth", 0.02, 0.05),
    });
    move |a| {
        if let Some(dent) = dent {
            dent.press(&mut a.body);
        }
        if let Some(which) = panel {
            let region = which_panel(&shape, which);
            let region = if on_right { region.mirrored() } else { region };
            a.body.repaint(&region, paint::BODY, other);
        }
        let low = shape.clearance + 0.10;
        a.body.repaint(&Region::all().within(Vec3::Z, low + dust_m), paint::BODY, DUST);
        if film_m > 0.0 {
            a.body.repaint(&Region::all().within(Vec3::Z, low + dust_m + film_m), paint::BODY, FILM);
        }
        hub_caps(a, caps, shape.tyre_width);
        rear_stickers(&mut a.body, &shape, stickers);
    }
}

/// A front wing, a front door, a bonnet, a rear wing.
fn which_panel(shape: &CarShape, which: i32) -> Region {
    let first = shape.doors_d[0];
    let second = shape.doors_d.get(1).copied().unwrap_or(first + 1.0);
    let (low, belt) = (shape.clearance + 0.08, shape.belt[2].1 + 0.01);
    match which {
        0 => shape.panel(0.06, first, low, belt),
        1 => shape.panel(first, second, low, belt),
        2 => {
            let (x0, x1, y) = (shape.x(shape.cabin_d[0]), shape.x(0.22), shape.half_width - 0.15);
            Region::top(&[(x0, -y), (x1, -y), (x1, y), (x0, y)].map(Vec2::from))
                .facing(Vec3::Z, 0.7)
                .within(Vec3::Z, shape.belt[2].1 + 0.12)
        }
        _ => {
            let last = shape.doors_d[shape.doors_d.len() - 1];
            shape.panel(last.max(second), shape.length - 0.10, low, belt)
        }
    }
}

impl Dent {
    /// Presses the flank in: a smooth hollow, normals turned as its slope is.
    fn press(&self, body: &mut Sculpt) {
        let inward = -self.centre.y.signum();
        for face in body.faces_mut() {
            for k in 0..3 {
                let away = (face.corners[k] - self.centre) / self.radius;
                let left = 1.0 - away.length_squared();
                if left <= 0.0 || face.normals[k].y * inward > -0.3 {
                    continue;
                }
                face.corners[k].y += inward * self.depth * left * left;
                let slope = 4.0 * self.depth / self.radius * left;
                let tilt = Vec3::new(-away.x, 0.0, -away.z) * slope;
                face.normals[k] = (face.normals[k] + tilt).normalize_or(face.normals[k]);
            }
        }
    }
}

/// Caps on those wheels whose bit is set; the others have lost theirs.
fn hub_caps(a: &mut Assembly, which: u32, tyre_width: f32) {
    let wheels: Vec<(Vec3, bool)> = a.wheels.iter().map(|w| (w.position, w.mirrored)).collect();
    let r = 0.62 * a.wheel_radius;
    for (i, (at, mirrored)) in wheels.into_iter().enumerate() {
        if which & (1 << i) == 0 {
            continue;
        }
        // Just outside of the rim.
        let dish = [(r, 0.0), (0.93 * r, 0.018), (0.45 * r, 0.012), (0.40 * r, 0.026), (0.0, 0.030)];
        let turn = Affine3A::from_rotation_x(if mirrored { 1.0 } else { -1.0 } * std::f32::consts::FRAC_PI_2);
        let out = Vec3::Y * (0.43 * tyre_width) * if mirrored { -1.0 } else { 1.0 };
        a.body.add(Sculpt::lathe(&dish, 16, 40.0, CAP).placed(turn).at(at + out));
    }
}

/// Little squares on the rear window.
fn rear_stickers(body: &mut Sculpt, shape: &CarShape, count: i32) {
    let top = shape.roof.last().map_or(1.3, |p| p.1);
    for i in 0..count {
        let (y, z) = ([-0.42, 0.40, -0.10, 0.22][i as usize % 4], top - 0.16 - 0.07 * (i % 2) as f32);
        let square = [(y - 0.055, z - 0.04), (y + 0.055, z - 0.04), (y + 0.055, z + 0.04), (y - 0.055, z + 0.04)];
        let on_glass = Region::end(&square.map(Vec2::from)).facing(-Vec3::X, 0.2).within(Vec3::X, 0.0);
        body.repaint(&on_glass, paint::GLASS, STICKERS[i as usize % 4]);
    }
}
