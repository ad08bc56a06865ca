//! Hair, hats and helmets as shells over the head.

use super::appearance::{Hair, Hat};
use super::body::Body;
use super::cage::Cage;
use super::head::Head;
use super::palette;
use super::skeleton::Bone;
use super::skin::{Skin, two};
use crate::shape::{MonotoneCubic, Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::math::{self, lerp, smoothstep};
use glam::{Vec2, Vec3};
use std::f32::consts::{PI, TAU};

/// Hair, then what covers it.
pub(crate) fn add(skin: &mut Skin, body: &Body<'_>, head: &Head<'_>) {
    let covered = match body.appearance.hat {
        Hat::Headscarf | Hat::FullHelmet | Hat::OpenHelmet | Hat::Turban => return hat(skin, body, head),
        Hat::None => 1.0,
        _ => 0.0,
    };
    hair(skin, body, head, covered);
    hat(skin, body, head);
}

/// How high hair stands, and where it begins: height of the hairline by angle from the front.
fn style(hair: Hair) -> (f32, &'static [(f32, f32)]) {
    const CROP: &[(f32, f32)] =
        &[(0.0, 0.80), (0.55, 0.79), (0.95, 0.70), (1.2, 0.47), (1.5, 0.45), (1.85, 0.36), (2.3, 0.22), (PI, 0.13)];
    const RECEDED: &[(f32, f32)] =
        &[(0.0, 0.90), (0.4, 0.95), (0.9, 0.80), (1.2, 0.50), (1.5, 0.45), (1.85, 0.36), (2.3, 0.22), (PI, 0.13)];
    const FULL: &[(f32, f32)] =
        &[(0.0, 0.78), (0.5, 0.75), (0.85, 0.60), (1.05, 0.25), (1.4, 0.12), (1.85, 0.06), (2.3, 0.03), (PI, 0.02)];
    match hair {
        Hair::Bald => (0.0, CROP),
        Hair::Balding => (0.030, RECEDED),
        Hair::Buzz => (0.016, CROP),
        Hair::Short => (0.050, CROP),
        Hair::Parted => (0.075, CROP),
        Hair::Curly => (0.105, CROP),
        Hair::Afro => (0.24, CROP),
        Hair::Bob => (0.085, FULL),
        Hair::Long => (0.080, FULL),
        Hair::Ponytail | Hair::Bun => (0.045, CROP),
    }
}

fn hair(skin: &mut Skin, body: &Body<'_>, head: &Head<'_>, free: f32) {
    let appearance = body.appearance;
    if appearance.hair == Hair::Bald {
        return;
    }
    let (volume, line) = style(appearance.hair);
    let line = MonotoneCubic::new(line);
    let phase = appearance.folds;
    let grow = |z: f32, angle: f32| {
        let a = angle.abs();
        let inside = smoothstep(-0.005, 0.055, z - line.at(a));
        // Hats press hair down.
        let room = lerp(smoothstep(0.72, 0.55, z).max(0.35 * f32::from(volume > 0.03)), 1.0, free);
        let mut v = volume * room;
        match appearance.hair {
            Hair::Balding => v *= 1.0 - 1.5 * smoothstep(0.80, 0.86, z),
            Hair::Parted => {
                v *= 0.75 + 0.45 * smoothstep(-0.9, 0.6, angle) * smoothstep(0.7, 0.9, z);
            }
            Hair::Curly | Hair::Afro => v *= 1.0 + 0.16 * math::sin(9.0 * angle + phase) * math::sin(23.0 * z),
            Hair::Long | Hair::Bob => v *= 0.75 + 0.3 * smoothstep(0.5, 1.5, a),
            _ => v *= 1.0 + 0.10 * math::sin(7.0 * angle + phase + 8.0 * z),
        }
        lerp(-0.02, v.max(if v < 0.0 { -0.02 } else { 0.010 }), inside)
    };
    skin.add_rigid(head.shell(grow, appearance.hair_color), Bone::Head);
    let row = |x: f32, z: f32, ry: f32, rx: f32| (head.at(Vec3::new(x, 0.0, z)), Vec2::new(ry, rx) * head.size);
    match appearance.hair {
        Hair::Long => {
            let length = 0.15 + 0.35 * (0.5 + 0.5 * math::sin(phase));
            let fall = [
                row(-0.20, 0.62, 0.34, 0.26),
                row(-0.25, 0.34, 0.385, 0.25),
                row(-0.29, 0.08, 0.375, 0.20),
                row(-0.33, -0.16, 0.36, 0.15),
                row(-0.345, -0.25 - 0.5 * length, 0.32, 0.11),
                row(-0.345, -0.27 - length, 0.22, 0.06),
            ];
            let (high, low) = (head.at(Vec3::Z * 0.05).z, head.at(-Vec3::Z * 0.35).z);
            skin.add(Sculpt::sweep(&fall, Vec3::Y, 14, 2.3, true, appearance.hair_color), |p| {
                two(Bone::Head, Bone::Chest, 0.9 * smoothstep(high, low, p.z))
            });
        }
        Hair::Ponytail => {
            let tail = [
                row(-0.40, 0.74, 0.07, 0.07),
                row(-0.53, 0.70, 0.10, 0.10),
                row(-0.60, 0.50, 0.11, 0.10),
                row(-0.58, 0.20, 0.09, 0.08),
                row(-0.54, -0.05, 0.03, 0.03),
            ];
            skin.add_rigid(Sculpt::sweep(&tail, Vec3::Y, 8, 2.0, true, appearance.hair_color), Bone::Head);
        }
        Hair::Bun => {
            let centre = head.at(Vec3::new(-0.44, 0.0, 0.78));
            skin.add_rigid(
                Sculpt::ellipsoid(centre, Vec3::splat(0.15 * head.size), 10, appearance.hair_color),
                Bone::Head,
            );
        }
        _ => {}
    }
}

/// A flat brim around the head: height, reach ahead, to the sides, behind, how far it droops.
fn brim(head: &Head<'_>, z: f32, [front, side, back]: [f32; 3], droop: f32, material: Material) -> Sculpt {
    let n = 20;
    let ring = |reach: f32, drop: f32| -> Vec<Vec3> {
        (0..n)
            .map(|j| {
                let angle = TAU * j as f32 / n as f32;
                let cos = math::cos(angle);
                let out = lerp(side, if cos > 0.0 { front } else { back }, cos * cos) * reach;
                let p = head.surface(z, angle, 0.02);
                let direction = Vec3::new(p.x, p.y, 0.0).normalize_or(Vec3::X);
                head.at(Vec3::new(p.x, p.y, z - drop) + direction * out)
            })
            .collect()
    };
    let mut s = Sculpt::new();
    // Under side outwards, rim, upper side back in.
    s.grid(&[ring(0.0, 0.0), ring(1.0, droop), ring(1.0, droop - 0.025), ring(0.0, -0.03)], true, material);
    s.smooth(40.0)
}

/// Cloth around neck and shoulders: a hood's or scarf's lower part.
fn drape(skin: &mut Skin, body: &Body<'_>, ease: f32, material: Material) {
    let rows = body.bust_rows(0.0, ease, &|_| ease);
    let mut cage = Cage::default();
    let middle: [Vec3; 16] = std::array::from_fn(|k| rows[1][k].lerp(rows[2][k], 0.62) * Vec3::new(1.0, 0.9, 1.0));
    let rings = [
        middle.to_vec(),
        rows[2].map(|p| p + Vec3::Z * 0.004 * body.h).to_vec(),
        body.neck_ring(0.1, ease + 0.004).to_vec(),
        body.neck_ring(0.8, ease + 0.006).to_vec(),
        body.neck_ring(1.7, ease + 0.010).to_vec(),
    ];
    let numbers: Vec<Vec<u32>> = rings
        .iter()
        .enumerate()
        .map(|(i, r)| {
            cage.row(
                r,
                |p| if i < 2 { body.bust_weights(p) } else { two(Bone::Chest, Bone::Head, 0.32 * (i - 1) as f32) },
            )
        })
        .collect();
    for pair in numbers.windows(2) {
        cage.strip(&pair[0], &pair[1], true, false, |_| material);
    }
    cage.refined().add_to(skin, |_, _| 0.0, |_| Vec3::ZERO);
}

fn hat(skin: &mut Skin, body: &Body<'_>, head: &Head<'_>) {
    let color = body.appearance.hat_color;
    let above =
        |line: f32, volume: f32| move |z: f32, _: f32| lerp(-0.03, volume, smoothstep(line - 0.05, line + 0.01, z));
    let mut s = Sculpt::new();
    match body.appearance.hat {
        Hat::None => {}
        Hat::Cap => {
            s.add(head.shell(above(0.70, 0.075), color));
            s.add(visor(head, 0.70, 0.30, color));
        }
        Hat::Beanie => s.add(head.shell(above(0.60, 0.085), color)),
        Hat::Brimmed => {
            s.add(head.shell(above(0.70, 0.085), color));
            s.add(brim(head, 0.70, [0.36, 0.36, 0.36], 0.10, color));
        }
        Hat::Fedora => {
            let crown = move |z: f32, angle: f32| {
                let dent = 0.05 * math::cos(angle).powi(2) * smoothstep(0.93, 1.0, z);
                lerp(-0.03, 0.10 + 0.14 * smoothstep(0.75, 0.95, z) - dent, smoothstep(0.66, 0.72, z))
            };
            s.add(head.shell(crown, color));
            s.add(brim(head, 0.71, [0.27, 0.22, 0.27], 0.03, color));
        }
        Hat::Turban => {
            let wraps = move |z: f32, angle: f32| {
                let fold = 0.022 * math::sin(28.0 * z + 2.0 * angle);
                lerp(-0.03, 0.17 + fold - 0.10 * smoothstep(0.9, 1.0, z), smoothstep(0.56, 0.66, z))
            };
            s.add(head.shell(wraps, color));
        }
        Hat::SiteHelmet => {
            s.add(head.shell(above(0.66, 0.135), color));
            s.add(brim(head, 0.68, [0.26, 0.13, 0.13], 0.02, color));
        }
        Hat::PeakedCap => {
            let dark = palette::linear(Surface::Leather, [0.015, 0.015, 0.016]);
            let crown = move |z: f32, _: f32| {
                lerp(
                    -0.03,
                    0.06 + 0.13 * smoothstep(0.74, 0.84, z) - 0.06 * smoothstep(0.9, 1.0, z),
                    smoothstep(0.65, 0.7, z),
                )
            };
            s.add(head.shell(crown, color));
            s.add(visor(head, 0.69, 0.24, dark));
        }
        Hat::Headscarf | Hat::Hood => {
            let hood = body.appearance.hat == Hat::Hood;
            let (volume, width) = if hood { (0.15, 1.12) } else { (0.070, 0.93) };
            let cover = move |z: f32, angle: f32| {
                let e = (angle / width).powi(2) + ((z - 0.40) / 0.46).powi(2);
                lerp(-0.03, volume, smoothstep(0.92, 1.25, e))
            };
            s.add(head.shell(cover, color));
            drape(skin, body, if hood { 0.030 } else { 0.020 }, color);
        }
        Hat::Conical => {
            let cone = [(0.0, 0.55), (0.95, 0.0), (0.96, -0.02), (0.0, 0.50)];
            let profile: Vec<(f32, f32)> = cone.iter().rev().map(|&(r, z)| (r * head.size, z * head.size)).collect();
            s.add(Sculpt::lathe(&profile, 20, 40.0, color).at(head.at(Vec3::new(-0.02, 0.0, 0.74))));
        }
        Hat::FullHelmet => full_helmet(&mut s, head, color),
        Hat::OpenHelmet => {
            let shell = Material { surface: Surface::Plastic, ..color };
            // Down over the ears and the neck, open from the brow to the chin.
            let cover = move |z: f32, angle: f32| {
                let brow = lerp(0.66, 0.16, smoothstep(0.75, 1.15, angle.abs()));
                lerp(-0.03, 0.15, smoothstep(brow - 0.04, brow + 0.03, z))
            };
            s.add(head.shell(cover, shell));
            s.add(visor(head, 0.72, 0.22, shell));
        }
        Hat::CycleHelmet => {
            let shell = Material { surface: Surface::Plastic, ..color };
            let ridges = move |z: f32, angle: f32| {
                let vents = 0.03 * math::sin(6.0 * angle).abs();
                lerp(-0.03, 0.11 + vents, smoothstep(0.66, 0.73, z))
            };
            s.add(head.shell(ridges, shell));
            let strap = palette::linear(Surface::Cloth, [0.02; 3]);
            for y in [-1.0, 1.0] {
                let at = |x: f32, y: f32, z: f32| (head.at(Vec3::new(x, y, z)), 0.012 * head.size);
                s.add(Sculpt::tube(
                    &[at(0.06, 0.345 * y, 0.66), at(0.10, 0.30 * y, 0.2), at(0.18, 0.05 * y, -0.01)],
                    4,
                    strap,
                ));
            }
        }
    }
    if !s.faces().is_empty() {
        skin.add_rigid(s, Bone::Head);
    }
}

/// The peak of a cap.
fn visor(head: &Head<'_>, z: f32, reach: f32, material: Material) -> Sculpt {
    let row = |x: f32, z: f32, ry: f32| (head.at(Vec3::new(x, 0.0, z)), Vec2::new(ry, 0.020) * head.size);
    let path = [
        row(0.22, z + 0.02, 0.32),
        row(0.40 + 0.35 * reach, z, 0.29),
        row(0.40 + 0.85 * reach, z - 0.04, 0.20),
        row(0.40 + reach, z - 0.05, 0.08),
    ];
    Sculpt::sweep(&path, Vec3::Y, 10, 2.4, true, material)
}

fn full_helmet(s: &mut Sculpt, head: &Head<'_>, color: Material) {
    let shell = Material { surface: Surface::Plastic, ..color };
    let visor = palette::linear(Surface::CarGlass, [0.015; 3]);
    let mut helmet =
        Sculpt::ellipsoid(head.at(Vec3::new(0.0, 0.0, 0.50)), Vec3::new(0.62, 0.51, 0.64) * head.size, 20, shell);
    let z = |t: f32| head.at(Vec3::new(0.0, 0.0, t)).z;
    helmet.remove(&Region::all().within(Vec3::Z, z(-0.02)));
    let window = Region::all().beyond(Vec3::Z, z(0.34)).within(Vec3::Z, z(0.72));
    helmet.paint(&window.beyond(Vec3::X, head.at(Vec3::X * 0.16).x), visor);
    s.add(helmet);
}
