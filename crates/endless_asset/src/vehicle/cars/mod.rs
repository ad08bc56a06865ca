//! The passenger cars of the catalogue.

mod old;
mod shape;

pub(crate) use old::{old_hatchback, old_pickup, old_saloon};

use super::assemble::{Assembly, VehicleBlueprint};
use super::car::CarShape;
use super::draw::DesignDraw;
use super::paint;
use super::roof_load::RoofLoad;
use super::wear;
use super::wheel::Rim;
use crate::shape::{Region, Sculpt};
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

/// Designs that are nothing but a shape.
macro_rules! plain {
    ($($name:ident),*) => {
        $(pub(crate) fn $name(draw: &DesignDraw) -> VehicleBlueprint { shape::$name().drawn(draw).blueprint() })*
    };
}

plain!(micro, city, hatchback, liftback, sedan, executive, estate, coupe, crossover, suv, large_suv, mpv);

/// A hatchback that nobody has washed or mended for long.
pub(crate) fn worn_hatchback(draw: &DesignDraw) -> VehicleBlueprint {
    worn(draw.pick("base", &[shape::hatchback, shape::city, shape::hatchback])().drawn(draw), draw)
}

/// The same of a sedan.
pub(crate) fn worn_sedan(draw: &DesignDraw) -> VehicleBlueprint {
    worn(shape::sedan().drawn(draw), draw)
}

fn worn(shape: CarShape, draw: &DesignDraw) -> VehicleBlueprint {
    let shape = CarShape { rim: if draw.chance("plain wheels", 0.6) { Rim::Steel } else { shape.rim }, ..shape };
    let worn = wear::worn(&shape, draw, 1.0);
    let rack = draw.chance("roof rack", 0.25).then(|| RoofLoad::drawn(draw));
    let mut blueprint = shape.clone().blueprint();
    if let Some(rack) = rack {
        blueprint.size.height = shape.height() + rack.height();
    }
    blueprint.with(move |a| {
        worn(a);
        if let Some(rack) = rack {
            rack.on(&mut a.body, &shape);
        }
    })
}

/// A sedan or estate for special service.
pub(crate) fn service_car(draw: &DesignDraw) -> CarShape {
    let shapes = [shape::sedan, shape::executive, shape::estate];
    CarShape { rails: false, ..draw.pick("base", &shapes)().drawn(draw) }
}

/// An SUV for special service.
pub(crate) fn service_suv(draw: &DesignDraw) -> CarShape {
    CarShape { rails: false, ..draw.pick("base", &[shape::suv, shape::large_suv])().drawn(draw) }
}

pub(crate) fn taxi(draw: &DesignDraw) -> VehicleBlueprint {
    taxi_of(
        CarShape {
            rails: false,
            ..draw.pick("base", &[shape::sedan, shape::liftback, shape::executive])().drawn(draw)
        },
        draw,
    )
}

pub(crate) fn large_taxi(draw: &DesignDraw) -> VehicleBlueprint {
    taxi_of(CarShape { rails: false, ..shape::mpv().drawn(draw) }, draw)
}

fn taxi_of(shape: CarShape, draw: &DesignDraw) -> VehicleBlueprint {
    let chequered = draw.chance("chequered band", 0.5);
    let top = shape.height();
    let mut blueprint = shape.clone().blueprint();
    blueprint.size.height = top + 0.15;
    blueprint.with(move |assembly| {
        assembly.body.add(taxi_sign(shape.x(shape.cabin_d[1] + 0.4), top));
        if chequered {
            chequer(assembly, &shape);
        }
    })
}

/// A lit box that says TAXI, in bars, on both faces.
fn taxi_sign(x: f32, top: f32) -> Sculpt {
    let lit = Material::new(Surface::LitSign, [0.85, 0.68, 0.12], ClassTag::Car);
    let low = top - 0.005;
    let mut sign = Sculpt::cuboid(Vec3::new(x - 0.09, -0.30, low), Vec3::new(x + 0.09, 0.30, top + 0.15), 0.03, lit);
    for direction in [1.0, -1.0] {
        let (z0, z1) = (low + 0.04, low + 0.12);
        let text = Region::end(&[(-0.22, z0), (0.22, z0), (0.22, z1), (-0.22, z1)].map(Vec2::from))
            .facing(Vec3::X * direction, 0.9);
        for i in 0..4 {
            let y = -0.22 + 0.12 * i as f32;
            sign.paint(&text.clone().beyond(Vec3::Y, y).within(Vec3::Y, y + 0.06), paint::TRIM);
        }
    }
    sign
}

/// A chequered band along the doors.
fn chequer(assembly: &mut Assembly, shape: &CarShape) {
    let (from, to) = (shape.doors_d[0] + 0.05, shape.doors_d[shape.doors_d.len() - 1]);
    let z = shape.head_lamp_z[1] - 0.02;
    let n = ((to - from) / 0.1) as usize;
    for i in 0..n {
        let x = shape.x(from + 0.1 * i as f32);
        let row = z + (i % 2) as f32 * 0.07;
        let square = [(x - 0.1, row), (x, row), (x, row + 0.07), (x - 0.1, row + 0.07)].map(Vec2::from);
        let region = Region::side(&square).facing(Vec3::Y, 0.5).beyond(Vec3::Y, 0.6);
        assembly.body.repaint_both(&region, paint::BODY, paint::TRIM);
    }
}

/// With its spare wheel on the tailgate.
pub(crate) fn offroad(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = shape::offroad().drawn(draw);
    let (r, z) = (0.97 * shape.wheel_radius, shape.belt[0].1 - 0.08);
    let rear = shape.x(shape.length);
    let mut blueprint = shape.blueprint();
    blueprint.size.rear = rear - 0.19;
    blueprint.with(move |assembly| {
        let turn = glam::Quat::from_rotation_y(-std::f32::consts::FRAC_PI_2);
        let place = glam::Affine3A::from_rotation_translation(turn, Vec3::new(rear + 0.04, 0.12, z));
        assembly.body.add(Sculpt::post(Vec3::ZERO, 0.22, r, 0.96 * r, 24, paint::RUBBER).placed(place));
        let hub = glam::Affine3A::from_rotation_translation(turn, Vec3::new(rear - 0.185, 0.12, z));
        assembly.body.add(Sculpt::post(Vec3::ZERO, 0.006, 0.6 * r, 0.55 * r, 20, paint::DARK_ALLOY).placed(hub));
    })
}

pub(crate) fn pickup(draw: &DesignDraw) -> VehicleBlueprint {
    pickup_of(shape::pickup().drawn(draw))
}

pub(crate) fn large_pickup(draw: &DesignDraw) -> VehicleBlueprint {
    pickup_of(shape::large_pickup().drawn(draw))
}

fn pickup_of(shape: CarShape) -> VehicleBlueprint {
    shape.clone().blueprint().with(move |assembly| open_bed(&mut assembly.body, &shape))
}

/// Opens the deck behind the cabin and sets a box into it.
fn open_bed(body: &mut Sculpt, shape: &CarShape) {
    let top = shape.deck.last().map_or(1.1, |p| p.1);
    let (x0, x1, y) = (shape.x(shape.length - 0.12), shape.x(shape.cabin_d[3] + 0.14), shape.half_width - 0.13);
    let bed = Region::top(&[(x0, -y), (x1, -y), (x1, y), (x0, y)].map(Vec2::from))
        .beyond(Vec3::Z, top - 0.22)
        .facing(Vec3::Z, 0.3);
    body.remove(&bed);
    let liner = Sculpt::cuboid(Vec3::new(x0, -y, top - 0.42), Vec3::new(x1, y, top + 0.005), 0.0, paint::TRIM);
    let mut inside = Sculpt::new();
    for face in liner.faces().iter().filter(|f| f.normals[0].z < 0.5) {
        let [a, b, c] = face.corners;
        inside.triangle([a, c, b], paint::TRIM);
    }
    body.add(inside);
    // A cap over the rim, where bed and body meet.
    let cap = |from: Vec2, to: Vec2| {
        Sculpt::cuboid((from - 0.02).extend(top - 0.05), (to + 0.03).extend(top + 0.035), 0.0, paint::TRIM)
    };
    body.add(cap(Vec2::new(x0, y), Vec2::new(x1, y)).both_sides());
    body.add(cap(Vec2::new(x0 - 0.01, -y), Vec2::new(x0, y)));
    body.add(cap(Vec2::new(x1, -y), Vec2::new(x1 + 0.01, y)));
    // Gap between cabin and bed.
    let x = shape.x(shape.cabin_d[3] + 0.07);
    let strip = [(x, 0.4), (x + 0.02, 0.4), (x + 0.02, top + 0.1), (x, top + 0.1)].map(Vec2::from);
    body.paint_both(&Region::side(&strip).facing(Vec3::Y, 0.3).beyond(Vec3::Y, 0.6), paint::DARK);
}
