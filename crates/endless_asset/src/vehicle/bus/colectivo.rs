//! Small high-floored buses on a lorry's frame: bands of colour, round lamps, and luggage on the roof.

use super::shape::{BusShape, rect};
use crate::shape::{Region, Sculpt};
use crate::vehicle::assemble::VehicleBlueprint;
use crate::vehicle::draw::DesignDraw;
use crate::vehicle::roof_load::RoofLoad;
use crate::vehicle::two_wheeler::{rod, v};
use crate::vehicle::{lettering, paint};
use endless_scene::Material;
use glam::{Vec2, Vec3};

/// Seven metres, two dozen seats.
pub(crate) fn colectivo(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 6.5, 7.9);
    let height = draw.range("height", 2.66, 2.82);
    let half_width = draw.range("half width", 1.06, 1.14);
    let rack = RoofLoad::drawn(draw);
    let racked = draw.chance("rack", 0.55);
    let bands = [draw.pick("first band", lettering::INKS), draw.pick("second band", lettering::INKS)];
    let shape = BusShape {
        length,
        height,
        half_width,
        floor: 0.42,
        axles_d: vec![1.55, 1.55 + 0.52 * length],
        wheel_radius: 0.40,
        glass_z: [draw.range("glass foot", 1.28, 1.38), draw.range("glass top", 2.08, 2.18)],
        upper_glass_z: None,
        pane: draw.range("pane", 0.85, 1.1),
        doors: vec![(2.05, 0.85)],
        rake: draw.range("rake", 0.08, 0.16),
        coach: false,
        white_roof: draw.chance("white roof", 0.4),
        ends: [true; 2],
    };
    let rear = shape.x(length);
    let front = shape.x(0.0);
    let mut blueprint = shape.blueprint();
    let roof = height + 0.19;
    if racked {
        blueprint.size.height = roof + rack.height();
    }
    blueprint.with(move |a| {
        for (i, ink) in bands.into_iter().enumerate() {
            let z = 0.74 + 0.30 * i as f32;
            band(&mut a.body, half_width, [rear, front], [z, z + 0.13], ink);
        }
        if racked {
            rack.between(&mut a.body, [rear + 0.4, front - 0.9], half_width - 0.22, roof);
            ladder(&mut a.body, rear - 0.03, roof);
        }
    })
}

/// A stripe of colour all around the body below the windows.
fn band(body: &mut Sculpt, half: f32, [rear, front]: [f32; 2], [z0, z1]: [f32; 2], ink: Material) {
    let along = Region::side(&rect(rear - 0.1, front, z0, z1).map(Vec2::from)).facing(Vec3::Y, 0.5);
    body.repaint_both(&along.beyond(Vec3::Y, 0.7 * half), paint::BODY, ink);
    let across = Region::end(&rect(-half, half, z0, z1).map(Vec2::from)).facing(-Vec3::X, 0.5);
    body.repaint(&across.within(Vec3::X, rear + 0.5), paint::BODY, ink);
}

/// Up the rear to the luggage.
fn ladder(body: &mut Sculpt, x: f32, top: f32) {
    for y in [0.38, 0.70] {
        body.add(rod(v(x, y, 0.75), v(x, y, top), 0.014, paint::STEEL));
    }
    for i in 0..6 {
        let z = 0.9 + (top - 1.0) * i as f32 / 5.0;
        body.add(rod(v(x, 0.38, z), v(x, 0.70, z), 0.012, paint::STEEL));
    }
}
