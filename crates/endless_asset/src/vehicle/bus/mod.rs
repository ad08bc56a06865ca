//! Buses: city, midi, double-decker, coach, school.

mod colectivo;
mod shape;

pub(crate) use colectivo::colectivo;

use super::assemble::{HitchMeasures, VehicleBlueprint};
use super::car::{CarShape, Grille};
use super::draw::DesignDraw;
use super::paint;
use super::wheel::Rim;
use crate::shape::Sculpt;
use glam::Vec3;
use shape::BusShape;

/// A low-floor city bus of twelve metres.
pub(crate) fn city(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 11.7, 12.2);
    let shape = BusShape {
        length,
        height: draw.range("height", 2.92, 3.05),
        half_width: 1.275,
        floor: 0.30,
        axles_d: vec![2.70, 2.70 + 0.495 * length],
        wheel_radius: 0.48,
        glass_z: [draw.range("glass foot", 0.98, 1.16), draw.range("glass top", 2.25, 2.36)],
        upper_glass_z: None,
        pane: draw.range("pane", 1.25, 1.6),
        doors: if draw.chance("two doors", 0.35) {
            vec![(0.55, 1.25), (5.9, 1.35)]
        } else {
            vec![(0.55, 1.25), (5.6, 1.35), (9.4, 1.25)]
        },
        rake: draw.range("rake", 0.10, 0.24),
        coach: false,
        white_roof: draw.chance("white roof", 0.6),
        ends: [true; 2],
    };
    shape.blueprint()
}

/// Eight to ten metres, for narrow streets.
pub(crate) fn midi(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 8.3, 9.9);
    let shape = BusShape {
        length,
        height: draw.range("height", 2.80, 2.95),
        half_width: draw.range("half width", 1.16, 1.22),
        floor: 0.30,
        axles_d: vec![2.25, 2.25 + 0.48 * length],
        wheel_radius: 0.42,
        glass_z: [draw.range("glass foot", 1.0, 1.15), draw.range("glass top", 2.15, 2.25)],
        upper_glass_z: None,
        pane: draw.range("pane", 1.15, 1.5),
        doors: vec![(0.50, 1.15), (0.48 * length, 1.25)],
        rake: draw.range("rake", 0.14, 0.30),
        coach: false,
        white_roof: draw.chance("white roof", 0.5),
        ends: [true; 2],
    };
    shape.blueprint()
}

/// Two decks.
pub(crate) fn double_decker(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 10.6, 11.1);
    let height = draw.range("height", 4.18, 4.35);
    let shape = BusShape {
        length,
        height,
        half_width: 1.265,
        floor: 0.30,
        axles_d: vec![2.62, 2.62 + 0.49 * length],
        wheel_radius: 0.48,
        glass_z: [1.05, 1.98],
        upper_glass_z: Some([height - 1.46, height - 0.52]),
        pane: draw.range("pane", 1.25, 1.5),
        doors: vec![(0.55, 1.25), (4.9, 1.25)],
        rake: draw.range("rake", 0.16, 0.26),
        coach: false,
        white_roof: draw.chance("white roof", 0.4),
        ends: [true; 2],
    };
    shape.blueprint()
}

/// For long journeys: luggage below, passengers high up.
pub(crate) fn coach(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 11.9, 12.4);
    let height = draw.range("height", 3.38, 3.58);
    let shape = BusShape {
        length,
        height,
        half_width: 1.275,
        floor: 0.34,
        axles_d: vec![2.75, 2.75 + 0.495 * length],
        wheel_radius: 0.51,
        glass_z: [height - 1.80, height - 0.60],
        upper_glass_z: None,
        pane: draw.range("pane", 1.6, 1.95),
        doors: vec![(0.60, 0.95)],
        rake: draw.range("rake", 0.30, 0.50),
        coach: true,
        white_roof: false,
        ends: [true; 2],
    };
    shape.blueprint()
}

/// Eighteen metres in two pieces, the rear one with an axle of its own.
pub(crate) fn articulated(draw: &DesignDraw) -> VehicleBlueprint {
    /// From the joint to the walls on both sides.
    const GAP_M: f32 = 0.58;
    let (length, behind) = (draw.range("length", 10.2, 10.5), draw.range("rear length", 6.5, 6.9));
    let height = draw.range("height", 2.92, 3.05);
    let glass_z = [draw.range("glass foot", 0.98, 1.16), draw.range("glass top", 2.25, 2.36)];
    let (pane, white_roof) = (draw.range("pane", 1.25, 1.6), draw.chance("white roof", 0.6));
    let shape = move |length: f32, axles_d: Vec<f32>, doors: Vec<(f32, f32)>, rake: f32, ends: [bool; 2]| BusShape {
        length,
        height,
        half_width: 1.275,
        floor: 0.30,
        axles_d,
        wheel_radius: 0.48,
        glass_z,
        upper_glass_z: None,
        pane,
        doors,
        rake,
        coach: false,
        white_roof,
        ends,
    };
    let rake = draw.range("rake", 0.10, 0.24);
    let front = shape(length, vec![2.70, 8.5], vec![(0.55, 1.25), (5.4, 1.35)], rake, [true, false]);
    let rear = shape(behind, vec![4.35], vec![(1.3, 1.35)], 0.02, [false, true]);
    let hitch = front.x(length) - GAP_M;
    let middle = hitch - GAP_M - 0.5 * behind;
    let joint = HitchMeasures { hitch, axle: middle + rear.x(4.35), front: hitch - GAP_M, towing_rear: hitch };
    let end = middle + rear.x(behind) - 0.006;
    let with_bellows = front.blueprint().with(move |a| a.body.add(bellows(Vec3::X * hitch, height)));
    with_bellows.towing(joint, end, height + 0.19, move || {
        let wheel = (middle + rear.x(4.35), rear.half_width - 0.16);
        (rear.build().body.at(Vec3::X * middle), vec![wheel])
    })
}

/// Folds about the joint: a column, so that it fills the gap however the bus is bent.
fn bellows(joint: Vec3, height: f32) -> Sculpt {
    const FOLDS: usize = 26;
    let ring = |z: f32, k: f32| -> Vec<Vec3> {
        (0..2 * FOLDS)
            .map(|i| {
                let (sin, cos) = endless_world::math::sin_cos(std::f32::consts::PI * i as f32 / FOLDS as f32);
                let r = k * if i % 2 == 0 { 1.16 } else { 1.06 };
                joint + Vec3::new(r * cos, r * sin, z)
            })
            .collect()
    };
    let top = height - 0.16;
    let mut s = Sculpt::new();
    s.grid(
        &[ring(0.42, 0.0), ring(0.42, 1.0), ring(top - 0.08, 1.0), ring(top, 0.9), ring(top, 0.0)],
        true,
        paint::GREY,
    );
    s.smooth(25.0)
}

/// A yellow school bus with a bonnet.
pub(crate) fn school(draw: &DesignDraw) -> VehicleBlueprint {
    let length = draw.range("length", 8.6, 9.2);
    let end = length - 0.12;
    let windows = ((end - 2.9) / 0.78) as usize;
    let shape = CarShape {
        length,
        half_width: 1.2,
        clearance: 0.42,
        wheelbase: 0.475 * length,
        front_axle_d: 0.98,
        wheel_radius: 0.46,
        tyre_width: 0.27,
        rim: Rim::Steel,
        deck: vec![(0.10, 1.38), (0.40, 1.48), (1.0, 1.56), (1.62, 1.62), (end, 1.66), (length, 1.64)],
        belt: vec![(0.05, 1.34), (0.40, 1.45), (1.62, 1.56), (3.0, 1.58), (length - 0.02, 1.58)],
        roof: vec![(1.85, 2.72), (2.2, 2.92), (2.9, 2.98), (length - 1.0, 2.98), (end, 2.92)],
        cabin_d: [1.62, 1.86, end, length - 0.05],
        tumblehome: 0.10,
        bow: [0.10, 0.05],
        corner: [0.24, 0.18],
        rake: [0.08, 0.0],
        pillars_d: (0..windows).map(|i| 2.85 + 0.78 * i as f32).collect(),
        glass_end_d: [end - 0.12, end - 0.14],
        doors_d: vec![1.95, 2.80],
        cladding: false,
        rails: false,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [1.05, 1.35],
        head_lamp_z: [1.0, 1.2],
        grille: Grille::Bars,
    };
    let mut blueprint = shape.clone().blueprint();
    blueprint.size.height += 0.01;
    blueprint.with(move |a| {
        // Rub rails, and the lamps that warn when children get on and off.
        for z in [0.78, 1.06, 1.42] {
            a.body.repaint_both(&shape.panel(2.7, length - 0.15, z, z + 0.07), paint::BODY, paint::TRIM);
        }
        let top = shape.height();
        for (x, out) in [(shape.x(2.12), 1.0), (shape.x(length - 0.06), -1.0)] {
            for y in [-0.62f32, -0.36, 0.36, 0.62] {
                let color = if y.abs() > 0.5 { paint::RED_LIGHT } else { paint::AMBER_LIGHT };
                let at = Vec3::new(x, y, top - 0.16);
                let half = Vec3::new(0.05, 0.09, 0.09);
                a.body.add(Sculpt::cuboid(at - half + Vec3::X * 0.02 * out, at + half, 0.03, color));
            }
        }
    })
}
