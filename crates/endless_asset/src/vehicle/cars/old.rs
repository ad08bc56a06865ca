//! Cars of the eighties: bumpers of their own, steel wheels, and what years have left on them.

use super::{open_bed, shape};
use crate::shape::Sculpt;
use crate::vehicle::assemble::VehicleBlueprint;
use crate::vehicle::car::CarShape;
use crate::vehicle::draw::DesignDraw;
use crate::vehicle::freight::Freight;
use crate::vehicle::paint;
use crate::vehicle::two_wheeler::{rod, v};
use crate::vehicle::wear;
use endless_scene::Material;
use glam::{Vec2, Vec3};

/// How far bumpers stand out, metres.
const BUMPER_M: f32 = 0.055;

pub(crate) fn old_saloon(draw: &DesignDraw) -> VehicleBlueprint {
    old(&shape::old_saloon().drawn(draw), draw)
}

pub(crate) fn old_hatchback(draw: &DesignDraw) -> VehicleBlueprint {
    old(&shape::old_hatchback().drawn(draw), draw)
}

/// Its bed empty or full, some with a cage of steel about it.
pub(crate) fn old_pickup(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = shape::old_pickup().drawn(draw);
    let freight = draw.pick("freight", &Freight::ALL);
    let (cage, seed) = (draw.chance("cage", 0.4), draw.range("pieces", 0.0, 1e6) as u64);
    old(&shape, draw).with(move |a| {
        open_bed(&mut a.body, &shape);
        housings(&mut a.body, &shape);
        let top = shape.deck.last().map_or(1.0, |p| p.1);
        let (x0, x1) = (shape.x(shape.length - 0.16), shape.x(shape.cabin_d[3] + 0.18));
        let y = shape.half_width - 0.15;
        let high = freight.height(0.34).min(shape.height() - top + 0.20);
        // Above the wheels' housings.
        a.body.add(freight.on(v(x0, -y, top - 0.24), Vec2::new(x1, y), high, seed));
        if cage {
            let rim = shape.height() - 0.06;
            let y = shape.half_width - 0.09;
            for i in 0..5 {
                let x = x0 + (x1 - x0) * i as f32 / 4.0;
                a.body.add(rod(v(x, y, top), v(x, y, rim), 0.018, paint::CHASSIS).both_sides());
            }
            for z in [0.5 * (top + rim), rim] {
                a.body.add(rod(v(x0, y, z), v(x1, y, z), 0.018, paint::CHASSIS).both_sides());
            }
            for x in [x0, x1] {
                a.body.add(rod(v(x, -y, rim), v(x, y, rim), 0.018, paint::CHASSIS));
            }
        }
    })
}

/// Sheet over the rear wheels, which stand up into the bed.
fn housings(body: &mut Sculpt, shape: &CarShape) {
    let [_, rear] = shape.axles();
    let r = shape.wheel_radius + 0.08;
    let low = v(rear - r, shape.half_width - 0.39, shape.wheel_radius + 0.1);
    let high = v(rear + r, shape.half_width - 0.128, shape.wheel_radius + r + 0.02);
    body.add(Sculpt::cuboid(low, high, 0.04, paint::TRIM).both_sides());
}

fn old(shape: &CarShape, draw: &DesignDraw) -> VehicleBlueprint {
    let metal = if draw.chance("chrome", 0.5) { paint::CHROME } else { paint::TRIM };
    let strip = draw.chance("rub strip", 0.6);
    let worn = wear::worn(shape, draw, 0.75);
    let mut blueprint = shape.clone().blueprint();
    blueprint.size.front += BUMPER_M;
    blueprint.size.rear -= BUMPER_M;
    let shape = shape.clone();
    blueprint.with(move |a| {
        if strip {
            let z = 0.5 * (shape.clearance + shape.belt[2].1) + 0.04;
            let along = shape.panel(0.12, shape.length - 0.12, z, z + 0.045);
            a.body.repaint_both(&along, paint::BODY, paint::TRIM);
        }
        worn(a);
        let z = shape.clearance + 0.25;
        a.body.add(bumper(shape.x(0.0), 1.0, shape.half_width, z, metal));
        a.body.add(bumper(shape.x(shape.length), -1.0, shape.half_width, z + 0.02, metal));
    })
}

/// A bar around the corners.
fn bumper(x: f32, ahead: f32, half: f32, z: f32, material: Material) -> Sculpt {
    let at = |t: f32, back: f32| (Vec3::new(x + ahead * (BUMPER_M - 0.03 - back), half * t, z), Vec2::new(0.03, 0.05));
    let path = [
        at(-1.02, 0.30),
        at(-1.0, 0.10),
        at(-0.90, 0.025),
        at(-0.4, 0.0),
        at(0.4, 0.0),
        at(0.90, 0.025),
        at(1.0, 0.10),
        at(1.02, 0.30),
    ];
    Sculpt::sweep(&path, Vec3::X, 10, 5.0, true, material)
}
