//! Fire engines.

use super::assemble::VehicleBlueprint;
use super::draw::DesignDraw;
use super::emergency::{beacon, light_bar};
use super::lorry::{BODY_HALF_WIDTH, CAB_TOP, Cab, FRAME_Z, Lorry, rect};
use super::paint;
use crate::shape::{Region, Sculpt};
use glam::{Vec2, Vec3};

const W: f32 = BODY_HALF_WIDTH;

const fn v(x: f32, y: f32, z: f32) -> Vec3 {
    Vec3::new(x, y, z)
}

/// A pumper: crew cab, lockers behind shutters, a ladder on the roof.
pub(crate) fn engine(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 7.2, 7.7);
    let top = CAB_TOP + draw.range("body", 0.05, 0.25);
    let (band, yellow) = (draw.range("band", 0.18, 0.3), draw.chance("yellow band", 0.5));
    let lorry = Lorry { length, cab: Cab::Crew, rear_axles_d: vec![0.71 * length], height: top + 0.36 };
    let blueprint = lorry.blueprint(move |lorry| {
        let (x0, x1) = (-lorry.length, lorry.body_front() + 0.10);
        let z0 = FRAME_Z - 0.42;
        let axle = -lorry.rear_axles_d[0];
        let mut s = Sculpt::cuboid(v(x0, -W, FRAME_Z), v(x1, W, top), 0.05, paint::BODY);
        for (a, b) in [(x0 + 0.02, axle - 0.62), (axle + 0.62, x1)] {
            s.add(Sculpt::cuboid(v(a, 0.6, z0), v(b, W, FRAME_Z + 0.02), 0.03, paint::BODY).both_sides());
        }
        let side = |p: [(f32, f32); 4]| Region::side(&p.map(Vec2::from)).facing(Vec3::Y, 0.9);
        // Shutters in slats; lower down beside the wheels.
        let n = 3;
        let bay = (x1 - x0 - 0.25) / n as f32;
        for i in 0..n {
            let (a, b) = (x0 + 0.15 + bay * i as f32, x0 + 0.05 + bay * (i + 1) as f32);
            let over_wheel = a < axle + 0.62 && b > axle - 0.62;
            let low = if over_wheel { FRAME_Z + 0.30 } else { z0 + 0.12 };
            s.paint_both(&side(rect(a, b, low, top - 0.22)), paint::BRIGHT_STEEL);
            let slats = ((top - 0.22 - low) / 0.11) as usize;
            for k in 0..slats {
                let z = low + 0.11 * k as f32;
                s.paint_both(&side(rect(a, b, z, z + 0.012)), paint::BRAKE);
            }
        }
        let color = if yellow { paint::LIME } else { paint::WHITE };
        s.repaint_both(&side(rect(x0, x1, FRAME_Z + 0.02, FRAME_Z + 0.02 + band)), paint::BODY, color);
        let rear = Region::end(&rect(-W, W, FRAME_Z + 0.02, FRAME_Z + 0.5).map(Vec2::from)).facing(-Vec3::X, 0.8);
        s.repaint(&rear, paint::BODY, color);
        s.add(Sculpt::cuboid(v(x0 - 0.01, -0.6, 1.25), v(x0 + 0.02, 0.6, top - 0.25), 0.0, paint::BRIGHT_STEEL));
        // Ladder on its rack, hose reel, light bars.
        for y in [-0.22, 0.22] {
            let z = top + 0.22;
            s.add(Sculpt::cuboid(v(x0 - 0.02, y - 0.03, z), v(-0.9, y + 0.03, z + 0.10), 0.0, paint::BRIGHT_STEEL));
        }
        let rungs = ((-0.9 - x0) / 0.33) as usize;
        for i in 0..rungs {
            let x = x0 + 0.1 + 0.33 * i as f32;
            s.add(Sculpt::cuboid(v(x, -0.22, top + 0.25), v(x + 0.04, 0.22, top + 0.29), 0.0, paint::BRIGHT_STEEL));
        }
        for x in [x0 + 0.4, x1 - 0.4] {
            s.add(Sculpt::cuboid(v(x, -0.5, top - 0.02), v(x + 0.06, 0.5, top + 0.22), 0.0, paint::STEEL));
        }
        s.add(light_bar(v(-0.62, 0.0, CAB_TOP - 0.01), 0.85, false));
        for y in [-0.95, 0.95] {
            s.add(Sculpt::cuboid(v(x0 + 0.05, y - 0.1, top), v(x0 + 0.2, y + 0.1, top + 0.12), 0.03, beacon(y)));
        }
        s
    });
    // The band goes on along the cab.
    let blueprint = blueprint.with(move |a| {
        let side = Region::side(&rect(-2.9, -0.25, FRAME_Z + 0.02, FRAME_Z + 0.02 + band).map(Vec2::from));
        let color = if yellow { paint::LIME } else { paint::WHITE };
        a.body.repaint_both(&side.facing(Vec3::Y, 0.6).beyond(Vec3::Y, 0.9), paint::BODY, color);
    });
    blueprint.scaled(draw.range("scale", 1.02, 1.06))
}
