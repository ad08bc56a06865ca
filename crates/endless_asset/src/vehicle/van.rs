//! Vans and minibuses: cars with a short bonnet and a tall, straight body.

use super::assemble::VehicleBlueprint;
use super::car::{CarShape, Grille};
use super::draw::DesignDraw;
use super::paint;
use super::wheel::Rim;
use crate::shape::{Region, Sculpt};
use glam::{Vec2, Vec3};

fn side(r: Region) -> Region {
    r.facing(Vec3::Y, 0.5).beyond(Vec3::Y, 0.6)
}

impl CarShape {
    /// A rectangle of the side view: distances from the front, heights.
    pub(crate) fn panel(&self, d0: f32, d1: f32, z0: f32, z1: f32) -> Region {
        side(Region::side(&[(self.x(d1), z0), (self.x(d0), z0), (self.x(d0), z1), (self.x(d1), z1)].map(Vec2::from)))
    }

    /// Rub strip, the sliding door with its rail, and the split of the rear doors.
    pub(crate) fn load_doors(&self, body: &mut Sculpt) {
        let (first, last) = (self.doors_d[self.doors_d.len() - 1] + 0.05, self.length - 0.35);
        let belt = self.belt[2].1;
        body.paint_both(&self.panel(first, last, 0.62, 0.72), paint::TRIM);
        body.paint_both(&self.panel(first + 1.2, last, belt + 0.1, belt + 0.135), paint::TRIM);
        let top = self.height() - 0.22;
        for d in [first, first + 1.24] {
            body.paint_both(&self.panel(d, d + 0.014, 0.4, top), paint::DARK);
        }
        let split = Region::end(&[(-0.008, 0.4), (0.008, 0.4), (0.008, top), (-0.008, top)].map(Vec2::from))
            .within(Vec3::X, -0.35 * self.length)
            .facing(-Vec3::X, 0.3);
        body.paint(&split, paint::DARK);
    }
}

/// A delivery van of a car's size.
pub(crate) fn small(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = small_shape().drawn(draw);
    let blind = draw.chance("blind rear doors", 0.5);
    let shape = CarShape { rear_window: !blind, ..shape };
    shape.clone().blueprint().with(move |a| shape.load_doors(&mut a.body))
}

pub(crate) fn panel(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = CarShape { rear_window: draw.chance("rear windows", 0.6), ..panel_shape().drawn(draw) };
    shape.clone().blueprint().with(move |a| shape.load_doors(&mut a.body))
}

/// Longer, and high enough to stand in.
pub(crate) fn high(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = CarShape { rear_window: false, ..high_shape().drawn(draw) };
    shape.clone().blueprint().with(move |a| shape.load_doors(&mut a.body))
}

pub(crate) fn minibus(draw: &DesignDraw) -> VehicleBlueprint {
    minibus_shape().drawn(draw).blueprint()
}

/// A leisure van of the sixties, or one that looks so: the driver over the front axle, in two colours.
pub(crate) fn camper(draw: &DesignDraw) -> VehicleBlueprint {
    let shape = camper_shape().drawn(draw);
    let shape = CarShape { grille: Grille::Closed, rim: Rim::Steel, ..shape };
    shape.clone().blueprint().with(move |a| {
        let upper = Region::all().beyond(Vec3::Z, shape.belt[2].1 - 0.02);
        a.body.repaint(&upper, paint::BODY, paint::WHITE);
    })
}

/// A van for special service: long, high and without windows behind the doors.
pub(crate) fn service_van(draw: &DesignDraw) -> CarShape {
    CarShape { rear_window: true, ..high_shape().drawn(draw) }
}

/// Small and large vans whose load cannot be seen.
pub(crate) fn blind_small(draw: &DesignDraw) -> CarShape {
    CarShape { rear_window: draw.chance("rear windows", 0.4), ..small_shape().drawn(draw) }
}

pub(crate) fn blind_panel(draw: &DesignDraw) -> CarShape {
    CarShape { rear_window: draw.chance("rear windows", 0.4), ..panel_shape().drawn(draw) }
}

/// A minibus for special service.
pub(crate) fn service_bus(draw: &DesignDraw) -> CarShape {
    minibus_shape().drawn(draw)
}

fn small_shape() -> CarShape {
    CarShape {
        length: 4.42,
        half_width: 0.91,
        clearance: 0.17,
        wheelbase: 2.72,
        front_axle_d: 0.88,
        wheel_radius: 0.32,
        tyre_width: 0.195,
        deck: vec![(0.10, 0.80), (0.30, 0.90), (0.65, 1.01), (0.98, 1.09), (4.3, 1.10), (4.42, 1.08)],
        belt: vec![(0.05, 0.78), (0.35, 0.89), (0.98, 1.0), (2.0, 1.03), (4.38, 1.05)],
        roof: vec![(1.55, 1.73), (1.95, 1.82), (2.5, 1.84), (3.6, 1.845), (4.3, 1.83)],
        cabin_d: [0.98, 1.78, 4.28, 4.38],
        tumblehome: 0.13,
        corner: [0.24, 0.10],
        pillars_d: vec![1.46],
        glass_end_d: [2.36, 2.34],
        doors_d: vec![1.28, 2.40],
        tail_lamp_z: [0.78, 1.16],
        head_lamp_z: [0.66, 0.82],
        ..panel_shape()
    }
}

fn panel_shape() -> CarShape {
    CarShape {
        length: 5.45,
        half_width: 1.0,
        clearance: 0.22,
        wheelbase: 3.28,
        front_axle_d: 0.96,
        wheel_radius: 0.345,
        tyre_width: 0.225,
        rim: Rim::Steel,
        deck: vec![(0.10, 0.98), (0.30, 1.08), (0.60, 1.20), (0.86, 1.30), (5.3, 1.28), (5.45, 1.26)],
        belt: vec![(0.05, 0.95), (0.35, 1.06), (0.86, 1.19), (2.0, 1.22), (5.4, 1.22)],
        roof: vec![(1.45, 2.14), (1.9, 2.26), (2.5, 2.30), (4.0, 2.31), (5.3, 2.28)],
        cabin_d: [0.84, 1.62, 5.30, 5.40],
        tumblehome: 0.145,
        bow: [0.17, 0.05],
        corner: [0.26, 0.10],
        rake: [0.08, 0.0],
        pillars_d: vec![1.38],
        glass_end_d: [2.36, 2.34],
        doors_d: vec![1.20, 2.42],
        cladding: false,
        rails: false,
        upright_lamps: true,
        rear_window: true,
        tail_lamp_z: [0.80, 1.25],
        head_lamp_z: [0.78, 0.98],
        grille: Grille::Bars,
    }
}

fn high_shape() -> CarShape {
    CarShape {
        length: 6.02,
        wheelbase: 3.66,
        deck: vec![(0.10, 0.98), (0.30, 1.08), (0.60, 1.20), (0.86, 1.30), (5.9, 1.28), (6.02, 1.26)],
        belt: vec![(0.05, 0.95), (0.35, 1.06), (0.86, 1.19), (2.0, 1.22), (5.98, 1.22)],
        roof: vec![(1.45, 2.36), (1.95, 2.58), (2.5, 2.66), (4.4, 2.67), (5.9, 2.63)],
        cabin_d: [0.84, 1.70, 5.88, 5.97],
        ..panel_shape()
    }
}

fn minibus_shape() -> CarShape {
    CarShape {
        length: 5.90,
        wheelbase: 3.62,
        half_width: 1.005,
        roof: vec![(1.45, 2.36), (1.9, 2.52), (2.5, 2.58), (4.4, 2.59), (5.75, 2.55)],
        deck: vec![(0.10, 0.98), (0.30, 1.08), (0.60, 1.20), (0.86, 1.30), (5.75, 1.28), (5.90, 1.26)],
        belt: vec![(0.05, 0.95), (0.35, 1.06), (0.86, 1.19), (2.0, 1.22), (5.85, 1.22)],
        cabin_d: [0.84, 1.68, 5.75, 5.85],
        pillars_d: vec![1.38, 2.44, 3.55, 4.65],
        glass_end_d: [5.67, 5.63],
        doors_d: vec![1.20, 2.44, 3.60],
        ..panel_shape()
    }
}

fn camper_shape() -> CarShape {
    CarShape {
        length: 4.50,
        half_width: 0.87,
        clearance: 0.21,
        wheelbase: 2.42,
        front_axle_d: 0.98,
        wheel_radius: 0.325,
        tyre_width: 0.185,
        deck: vec![(0.02, 1.04), (0.10, 1.08), (0.20, 1.10), (4.3, 1.12), (4.5, 1.10)],
        belt: vec![(0.02, 1.02), (0.10, 1.05), (0.20, 1.07), (2.0, 1.08), (4.45, 1.08)],
        roof: vec![(0.50, 1.86), (0.85, 1.95), (1.6, 1.985), (3.2, 1.985), (4.2, 1.92)],
        cabin_d: [0.10, 0.48, 4.22, 4.42],
        tumblehome: 0.13,
        bow: [0.24, 0.14],
        corner: [0.26, 0.22],
        rake: [0.02, 0.02],
        pillars_d: vec![1.30, 2.30, 3.20],
        glass_end_d: [4.12, 4.06],
        doors_d: vec![0.52, 1.36, 2.36],
        tail_lamp_z: [0.72, 0.98],
        head_lamp_z: [0.66, 0.84],
        ..panel_shape()
    }
}
