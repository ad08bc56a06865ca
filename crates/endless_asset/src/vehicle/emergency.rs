//! Police, ambulances: ordinary bodies with light bars and liveries.

use super::assemble::VehicleBlueprint;
use super::car::CarShape;
use super::draw::DesignDraw;
use super::{cars, paint, van};
use crate::shape::{Region, Sculpt};
use endless_scene::Material;
use glam::{Vec2, Vec3};

/// How high a light bar stands above the roof.
const BAR_M: f32 = 0.115;

/// A light bar across the roof: blue at the ends, or red and blue.
pub(crate) fn light_bar(centre: Vec3, half_width: f32, two_coloured: bool) -> Sculpt {
    let lens = |y0: f32, y1: f32, m| {
        let (low, high) = (centre + Vec3::new(-0.13, y0, 0.015), centre + Vec3::new(0.13, y1, BAR_M));
        Sculpt::cuboid(low, high, 0.03, m)
    };
    let mut bar = lens(0.25 * half_width, half_width, paint::BEACON_LEFT);
    let other = if two_coloured { paint::RED_BEACON_RIGHT } else { paint::BEACON_RIGHT };
    bar.add(lens(-half_width, -0.25 * half_width, other));
    bar.add(lens(-0.24 * half_width, 0.24 * half_width, paint::GREY));
    bar.add(Sculpt::cuboid(
        centre + Vec3::new(-0.10, -half_width, -0.02),
        centre + Vec3::new(0.10, half_width, 0.02),
        0.0,
        paint::TRIM,
    ));
    bar
}

/// The lens of a beacon beside the middle of the roof.
pub(crate) fn beacon(y: f32) -> Material {
    if y > 0.0 { paint::BEACON_LEFT } else { paint::BEACON_RIGHT }
}

fn marked(shape: CarShape, draw: &DesignDraw) -> VehicleBlueprint {
    let (american, band) = (draw.chance("red and blue", 0.4), draw.range("band", 0.14, 0.26));
    let top = shape.height();
    let mut blueprint = shape.clone().blueprint();
    blueprint.size.height = top + BAR_M;
    blueprint.with(move |a| {
        let half = shape.half_width - shape.tumblehome - 0.12;
        a.body.add(light_bar(Vec3::new(shape.x(shape.cabin_d[1] + 0.35), 0.0, top - 0.01), half, american));
        let z = shape.head_lamp_z[1];
        let (first, last) = (shape.doors_d[0], shape.doors_d[shape.doors_d.len() - 1]);
        if american {
            // White doors on whatever the paint is.
            let doors = shape.panel(first, last, shape.clearance + 0.1, shape.belt[2].1 + 0.4);
            a.body.repaint_both(&doors, paint::BODY, paint::WHITE);
        } else {
            let along = shape.panel(0.15, shape.length - 0.15, z - band, z);
            a.body.repaint_both(&along, paint::BODY, paint::BLUE);
            let thin = shape.panel(0.15, shape.length - 0.15, z + 0.015, z + 0.05);
            a.body.repaint_both(&thin, paint::BODY, paint::LIME);
        }
    })
}

pub(crate) fn police_car(draw: &DesignDraw) -> VehicleBlueprint {
    marked(cars::service_car(draw), draw)
}

pub(crate) fn police_suv(draw: &DesignDraw) -> VehicleBlueprint {
    marked(cars::service_suv(draw), draw)
}

pub(crate) fn police_van(draw: &DesignDraw) -> VehicleBlueprint {
    marked(van::service_bus(draw), draw)
}

/// A high van with a chequered band, a window in its side and lights all round.
pub(crate) fn ambulance(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = van::service_van(draw);
    let (red, chequered) = (draw.chance("red", 0.6), draw.chance("chequered", 0.55));
    let top = shape.height();
    let mut blueprint = shape.clone().blueprint();
    blueprint.size.height = top + BAR_M;
    blueprint.with(move |a| {
        let body = &mut a.body;
        let (color, z) = (if red { paint::RED } else { paint::LIME }, shape.head_lamp_z[1] + 0.05);
        let (front, rear) = (shape.doors_d[0] - 0.4, shape.length - 0.2);
        if chequered {
            let n = 11;
            let width = (rear - front) / n as f32;
            for i in 0..n {
                for row in 0..2 {
                    let (d, low) = (front + width * i as f32, z + 0.22 * row as f32);
                    let color = if (i + row) % 2 == 0 { color } else { paint::BLUE };
                    body.repaint_both(&shape.panel(d, d + width, low, low + 0.22), paint::BODY, color);
                }
            }
        } else {
            body.repaint_both(&shape.panel(front, rear, z, z + 0.24), paint::BODY, color);
        }
        // A frosted window, and the star or cross on bonnet and flank.
        let d = shape.length - 2.1;
        body.repaint_both(&shape.panel(d, d + 0.85, z + 0.62, z + 1.0), paint::BODY, paint::TRIM);
        body.paint_both(&shape.panel(d + 0.02, d + 0.83, z + 0.64, z + 0.98), paint::GLASS);
        let cross = d + 1.35;
        for (w, h) in [(0.06, 0.2), (0.2, 0.06)] {
            let bar = shape.panel(cross - w, cross + w, z + 0.8 - h, z + 0.8 + h);
            body.repaint_both(&bar, paint::BODY, color);
        }
        let back = Region::end(&[(-0.8, z), (0.8, z), (0.8, z + 0.24), (-0.8, z + 0.24)].map(Vec2::from))
            .within(Vec3::X, shape.x(shape.length - 0.5))
            .facing(-Vec3::X, 0.4);
        body.repaint(&back, paint::BODY, color);
        let half = shape.half_width - shape.tumblehome - 0.1;
        body.add(light_bar(Vec3::new(shape.x(shape.cabin_d[1] + 0.45), 0.0, top - 0.06), half, false));
        for y in [-0.45, 0.45] {
            let at = Vec3::new(shape.x(shape.length - 0.35), y, top - 0.03);
            body.add(Sculpt::cuboid(
                at - Vec3::new(0.06, 0.14, 0.0),
                at + Vec3::new(0.06, 0.14, 0.09),
                0.02,
                beacon(y),
            ));
        }
    })
}
