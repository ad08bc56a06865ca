//! Cars of one shape that differ as models of different makers do.

use super::shape::{CarShape, Grille};
use crate::vehicle::draw::DesignDraw;
use crate::vehicle::wheel::Rim;

/// Stretches distances from the front so that the axles come to lie elsewhere.
fn stretch(d: f32, from: [f32; 3], to: [f32; 3]) -> f32 {
    let mut start = (0.0, 0.0);
    for (&a, &b) in from.iter().zip(&to) {
        if d <= a || a == from[2] {
            return start.1 + (d - start.0) * (b - start.1) / (a - start.0);
        }
        start = (a, b);
    }
    d
}

impl CarShape {
    /// A car of this shape whose overhangs, wheelbase, width, height, corners, wheels and face are drawn from the ranges
    /// that cars of its segment have.
    pub(crate) fn drawn(mut self, draw: &DesignDraw) -> Self {
        let rear_axle = self.front_axle_d + self.wheelbase;
        let from = [self.front_axle_d, rear_axle, self.length];
        self.front_axle_d *= draw.range("front overhang", 0.96, 1.05);
        self.wheelbase *= draw.range("wheelbase", 0.975, 1.035);
        let to_rear = self.front_axle_d + self.wheelbase;
        self.length = to_rear + (self.length - rear_axle) * draw.range("rear overhang", 0.93, 1.06);
        let to = [self.front_axle_d, to_rear, self.length];
        let along = |d: f32| stretch(d, from, to);

        let belt = self.belt.iter().map(|p| p.1).sum::<f32>() / self.belt.len() as f32;
        let (body, glass) = (draw.range("body height", 0.975, 1.03), draw.range("glass height", 0.93, 1.05));
        for (d, z) in self.deck.iter_mut().chain(&mut self.belt) {
            (*d, *z) = (along(*d), *z * body);
        }
        for (d, z) in &mut self.roof {
            (*d, *z) = (along(*d), belt * body + (*z - belt) * glass);
        }
        self.cabin_d = self.cabin_d.map(along);
        self.glass_end_d = self.glass_end_d.map(along);
        self.pillars_d = self.pillars_d.iter().map(|&d| along(d)).collect();
        self.doors_d = self.doors_d.iter().map(|&d| along(d)).collect();
        self.tail_lamp_z = self.tail_lamp_z.map(|z| z * body);
        self.head_lamp_z = self.head_lamp_z.map(|z| z * body);

        self.half_width *= draw.range("width", 0.98, 1.02);
        self.tumblehome *= draw.range("tumblehome", 0.93, 1.06);
        self.wheel_radius *= draw.range("wheel", 0.965, 1.045);
        self.bow = self.bow.map(|b| b * draw.range("bow", 0.85, 1.2));
        self.corner = self.corner.map(|c| c * draw.range("corner", 0.8, 1.15));
        self.rake = self.rake.map(|r| r * draw.range("rake", 0.75, 1.3));
        self.clearance += draw.range("clearance", -0.012, 0.015);
        if let Rim::Alloy(_) = self.rim {
            let rims = [5, 5, 6, 7, 9, 10].map(Rim::Alloy);
            self.rim = if draw.chance("steel rims", 0.12) { Rim::Steel } else { draw.pick("rims", &rims) };
        }
        if !matches!(self.grille, Grille::Slots | Grille::Classic) {
            use Grille::{Bars, Closed, Framed, Slit, Tall};
            self.grille = draw.pick("grille", &[Framed, Bars, Bars, Slit, Tall, Closed]);
        }
        // Lamps have become slimmer.
        let slim = draw.range("lamps", 0.75, 1.1);
        let middle = 0.5 * (self.head_lamp_z[0] + self.head_lamp_z[1]);
        self.head_lamp_z = self.head_lamp_z.map(|z| middle + (z - middle) * slim);
        self
    }
}
