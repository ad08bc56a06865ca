//! Two-wheelers: motorcycles, bicycles, scooters.

mod bicycle;
mod commuter;
mod cruiser;
mod kick_scooter;
mod moped;
mod sport;

pub(crate) use bicycle::{cargo, city, mountain, road};
pub(crate) use commuter::{commuter, delivery};
pub(crate) use cruiser::cruiser;
pub(crate) use kick_scooter::kick_scooter;
pub(crate) use moped::{moped_delivery, scooter};
pub(crate) use sport::sport;

use super::assemble::{Assembly, VehicleBlueprint, VehicleMeasures};
use super::draw::DesignDraw;
use super::paint;
use super::rider_fit::RiderFit;
use super::wheel::{Rim, wheel};
use crate::shape::{Region, Sculpt};
use endless_scene::Material;
use glam::{Vec2, Vec3};

pub(super) const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// Measures of a two-wheeler: foremost and rearmost point, width, height, axles, wheel radius.
fn size([front, rear]: [f32; 2], width: f32, height: f32, axles: [f32; 2], wheel_radius: f32) -> VehicleMeasures {
    VehicleMeasures { front, rear, width, height, axles, wheel_radius }
}

/// Frames come in sizes.
fn framed(draw: &DesignDraw, blueprint: VehicleBlueprint) -> VehicleBlueprint {
    blueprint.scaled(draw.range("frame", 0.965, 1.04))
}

/// The box of who delivers meals, behind the rider.
fn delivery_box(draw: &DesignDraw, at: Vec3) -> impl FnOnce(&mut Assembly) + 'static {
    let color = draw.pick("box", &[paint::ORANGE, paint::RED, paint::YELLOW, paint::LIME, paint::TEAL, paint::TRIM]);
    let half = Vec3::new(0.20, draw.range("box width", 0.20, 0.235), draw.range("box height", 0.19, 0.23));
    move |a| {
        let middle = at + Vec3::Z * half.z;
        let mut case = Sculpt::cuboid(middle - half, middle + half, 0.03, color);
        let label = Region::all().within(Vec3::Z, at.z + 1.45 * half.z).beyond(Vec3::Z, at.z + 0.6 * half.z);
        for (face, along) in [(Vec3::Y, Vec3::X), (-Vec3::Y, Vec3::X), (-Vec3::X, Vec3::Y)] {
            let patch = label.clone().within(along, at.dot(along) + 0.13).beyond(along, at.dot(along) - 0.13);
            case.paint(&patch.facing(face, 0.9), paint::WHITE);
        }
        a.body.add(case);
        a.body.add(Sculpt::cuboid(
            at - Vec3::new(0.16, 0.12, 0.03),
            at + Vec3::new(0.16, 0.12, 0.01),
            0.0,
            paint::CHASSIS,
        ));
    }
}

pub(super) fn rod(a: Vec3, b: Vec3, radius: f32, material: Material) -> Sculpt {
    Sculpt::tube(&[(a, radius), (b, radius)], 8, material)
}

/// A flat-sided smooth body along a path: half width and half height a point.
pub(super) fn hull(path: &[(Vec3, f32, f32)], material: Material) -> Sculpt {
    let sections: Vec<(Vec3, Vec2)> = path.iter().map(|&(p, w, h)| (p, Vec2::new(w, h))).collect();
    Sculpt::sweep(&sections, Vec3::Y, 14, 2.6, true, material)
}

/// A curved sheet over a wheel, from one angle to another (0 = ahead, 90 = above).
pub(super) fn mudguard(
    centre: Vec3,
    radius: f32,
    half_width: f32,
    from_deg: f32,
    to_deg: f32,
    material: Material,
) -> Sculpt {
    let n = 8;
    let path: Vec<(Vec3, Vec2)> = (0..=n)
        .map(|i| {
            let angle = (from_deg + (to_deg - from_deg) * i as f32 / n as f32).to_radians();
            let (sin, cos) = endless_world::math::sin_cos(angle);
            (centre + v(cos, 0.0, sin) * radius, Vec2::new(half_width, 0.012))
        })
        .collect();
    Sculpt::sweep(&path, Vec3::Y, 8, 2.0, true, material)
}

pub(super) fn mirrors_and_bars(s: &mut Sculpt, stem: Vec3, grip: Vec3) {
    let bend = v(stem.x + 0.02, 0.16, grip.z + 0.015);
    s.add(Sculpt::tube(&[(stem, 0.013), (bend, 0.013), (grip, 0.013)], 8, paint::CHROME).both_sides());
    s.add(rod(grip - v(-0.02, 0.07, 0.0), grip + v(-0.02, 0.07, 0.0), 0.019, paint::RUBBER).both_sides());
    s.add(rod(grip + v(0.05, -0.05, -0.01), grip + v(0.05, 0.08, -0.02), 0.006, paint::STEEL).both_sides());
    let top = grip + v(0.02, 0.03, 0.22);
    s.add(rod(grip + v(0.02, -0.10, 0.0), top, 0.006, paint::TRIM).both_sides());
    let mut glass = Sculpt::ellipsoid(top + v(0.0, 0.02, 0.02), v(0.022, 0.062, 0.042), 10, paint::TRIM);
    glass.paint(&Region::all().facing(-Vec3::X, 0.75), paint::CHROME);
    s.add(glass.both_sides());
}

pub(super) fn indicators(s: &mut Sculpt, at: Vec3) {
    let lens = |m: Material| Sculpt::ellipsoid(at, v(0.03, 0.03, 0.022), 8, m);
    s.add(lens(paint::LEFT));
    s.add(lens(paint::RIGHT).mirrored());
    s.add(rod(v(at.x, 0.02, at.z), at, 0.008, paint::TRIM).both_sides());
}
