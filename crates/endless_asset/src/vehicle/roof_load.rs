//! Racks on roofs, and what is tied to them.

use super::car::CarShape;
use super::draw::DesignDraw;
use super::freight::Freight;
use super::paint;
use super::two_wheeler::{rod, v};
use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::ClassTag;
use glam::{Vec2, Vec3};

const TARPAULINS: [Material; 3] = [
    Material::new(Surface::Cloth, [0.03, 0.10, 0.28], ClassTag::Car),
    Material::new(Surface::Cloth, [0.10, 0.13, 0.07], ClassTag::Car),
    Material::new(Surface::Cloth, [0.46, 0.44, 0.38], ClassTag::Car),
];

/// What is tied to a rack.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Tied {
    Nothing,
    Ladder,
    Freight(Freight),
    Mattress,
    Tarpaulin(Material),
}

/// A rack with its load.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RoofLoad {
    tied: Tied,
    seed: u64,
    high: f32,
}

/// Of the rack's bars over the roof, metres.
const RACK_M: f32 = 0.09;

impl RoofLoad {
    /// Some load.
    pub(crate) fn drawn(draw: &DesignDraw) -> Self {
        let tarpaulin = Tied::Tarpaulin(draw.pick("tarpaulin", &TARPAULINS));
        let (crates, sacks) = (Tied::Freight(Freight::Cartons), Tied::Freight(Freight::Sacks));
        let tied = draw.pick("roof load", &[Tied::Nothing, Tied::Ladder, crates, sacks, Tied::Mattress, tarpaulin]);
        Self::of(tied, draw)
    }

    /// A ladder or nothing, as craftsmen have it.
    pub(crate) fn of_craftsman(draw: &DesignDraw) -> Self {
        Self::of(draw.pick("roof load", &[Tied::Ladder, Tied::Ladder, Tied::Nothing]), draw)
    }

    fn of(tied: Tied, draw: &DesignDraw) -> Self {
        Self {
            tied,
            seed: draw.range("roof pieces", 0.0, 1e6) as u64,
            high: draw.range("roof load height", 0.24, 0.42),
        }
    }

    /// Height over the roof, metres.
    pub(crate) fn height(&self) -> f32 {
        RACK_M
            + match self.tied {
                Tied::Nothing => 0.0,
                Tied::Ladder => 0.10,
                Tied::Freight(_) | Tied::Tarpaulin(_) => self.high,
                Tied::Mattress => 0.20,
            }
    }

    /// Rack and load on a car's roof.
    pub(crate) fn on(&self, body: &mut Sculpt, shape: &CarShape) {
        let front = shape.x(shape.cabin_d[1] + 0.30);
        let rear = shape.x(shape.cabin_d[2] - 0.12);
        self.between(body, [rear, front], shape.half_width - shape.tumblehome - 0.06, shape.height());
    }

    /// The same on any roof at this height.
    pub(crate) fn between(&self, body: &mut Sculpt, [rear, front]: [f32; 2], half: f32, roof: f32) {
        let z = roof + RACK_M;
        let n = (((front - rear) / 0.7) as usize).max(2);
        for i in 0..=n {
            let x = rear + (front - rear) * i as f32 / n as f32;
            body.add(rod(v(x, -half, z - 0.015), v(x, half, z - 0.015), 0.015, paint::STEEL));
            if i == 0 || i == n || i == n / 2 {
                body.add(rod(v(x, half, roof - 0.07), v(x, half, z - 0.015), 0.016, paint::STEEL).both_sides());
            }
        }
        body.add(rod(v(rear, half, z - 0.015), v(front, half, z - 0.015), 0.015, paint::STEEL).both_sides());
        let (low, high) = (v(rear + 0.05, -half + 0.05, z), Vec2::new(front - 0.05, half - 0.05));
        match self.tied {
            Tied::Nothing => {}
            Tied::Ladder => ladder(body, [rear - 0.2, front + 0.1], -0.3 * half, z),
            Tied::Freight(freight) => body.add(freight.on(low, high, self.high, self.seed)),
            Tied::Mattress => body.add(Sculpt::cuboid(low, high.extend(z + 0.20), 0.05, TARPAULINS[2])),
            Tied::Tarpaulin(cloth) => {
                let (mid, half_y) = (0.5 * (low.y + high.y), 0.5 * (high.y - low.y));
                let at = |x: f32, k: f32, top: f32| {
                    (v(x, mid, z + 0.5 * top * self.high), Vec2::new(half_y * k, 0.5 * top * self.high))
                };
                let lumps = [
                    at(low.x, 0.82, 0.55),
                    at(low.x + 0.12, 0.98, 0.86),
                    at(0.5 * (low.x + high.x), 1.0, 1.0),
                    at(high.x - 0.2, 0.95, 0.80),
                    at(high.x, 0.75, 0.45),
                ];
                body.add(Sculpt::sweep(&lumps, Vec3::Y, 14, 3.2, true, cloth));
            }
        }
    }
}

/// Two rails and rungs, lying.
fn ladder(body: &mut Sculpt, [rear, front]: [f32; 2], y: f32, z: f32) {
    for side in [-0.19, 0.19] {
        let (low, high) = (v(rear, y + side - 0.02, z), v(front, y + side + 0.02, z + 0.10));
        body.add(Sculpt::cuboid(low, high, 0.0, paint::BRIGHT_STEEL));
    }
    let rungs = ((front - rear) / 0.28) as usize;
    for i in 0..rungs {
        let x = rear + 0.14 + 0.28 * i as f32;
        body.add(Sculpt::cuboid(v(x, y - 0.18, z + 0.03), v(x + 0.03, y + 0.18, z + 0.07), 0.0, paint::BRIGHT_STEEL));
    }
}
