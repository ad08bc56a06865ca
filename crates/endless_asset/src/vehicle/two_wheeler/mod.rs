//! Two-wheelers: motorcycles, bicycles, scooters.

mod bicycle;
mod commuter;
mod cruiser;
mod goods;
mod kick_scooter;
mod moped;
mod sport;
mod underbone;

pub(crate) use bicycle::{cargo, city, mountain, road};
pub(crate) use commuter::{commuter, commuter_for_two, delivery};
pub(crate) use cruiser::cruiser;
pub(crate) use kick_scooter::kick_scooter;
pub(crate) use moped::{moped_delivery, scooter, scooter_for_two};
pub(crate) use sport::sport;
pub(crate) use underbone::{underbone, underbone_delivery};

use super::assemble::{Assembly, VehicleBlueprint, VehicleMeasures};
use super::draw::DesignDraw;
use super::paint;
use super::rider_fit::{HelmetKind, PillionFit, RiderFit};
use super::wheel::{Rim, wheel};
use crate::shape::{Region, Sculpt};
use endless_scene::Material;
use endless_world::Outfit;
use glam::{Vec2, Vec3};
use goods::{delivery_box, loaded};

pub(in crate::vehicle) const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// Measures of a two-wheeler: foremost and rearmost point, width, height, axles, wheel radius.
fn size([front, rear]: [f32; 2], width: f32, height: f32, axles: [f32; 2], wheel_radius: f32) -> VehicleMeasures {
    VehicleMeasures { front, rear, width, height, axles, wheel_radius }
}

/// Ridden by two as often as not, and not always with a helmet.
fn for_two(blueprint: VehicleBlueprint, helmet: f64, pillion: PillionFit) -> VehicleBlueprint {
    blueprint.with(move |a| {
        a.fit = a.fit.map(|f| RiderFit {
            helmet,
            helmets: HelmetKind::Open,
            outfit: Outfit::Hot,
            pillion: Some(pillion),
            ..f
        });
    })
}

/// Frames come in sizes.
fn framed(draw: &DesignDraw, blueprint: VehicleBlueprint) -> VehicleBlueprint {
    blueprint.scaled(draw.range("frame", 0.965, 1.04))
}

pub(in crate::vehicle) fn rod(a: Vec3, b: Vec3, radius: f32, material: Material) -> Sculpt {
    Sculpt::tube(&[(a, radius), (b, radius)], 8, material)
}

/// A flat-sided smooth body along a path: half width and half height a point.
pub(in crate::vehicle) fn hull(path: &[(Vec3, f32, f32)], material: Material) -> Sculpt {
    let sections: Vec<(Vec3, Vec2)> = path.iter().map(|&(p, w, h)| (p, Vec2::new(w, h))).collect();
    Sculpt::sweep(&sections, Vec3::Y, 14, 2.6, true, material)
}

/// A curved sheet over a wheel, from one angle to another (0 = ahead, 90 = above).
pub(in crate::vehicle) fn mudguard(
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

pub(in crate::vehicle) fn mirrors_and_bars(s: &mut Sculpt, stem: Vec3, grip: Vec3) {
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

pub(in crate::vehicle) fn indicators(s: &mut Sculpt, at: Vec3) {
    let lens = |m: Material| Sculpt::ellipsoid(at, v(0.03, 0.03, 0.022), 8, m);
    s.add(lens(paint::LEFT));
    s.add(lens(paint::RIGHT).mirrored());
    s.add(rod(v(at.x, 0.02, at.z), at, 0.008, paint::TRIM).both_sides());
}
