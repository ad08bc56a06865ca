//! The measures of a car that its body is built from.

use crate::vehicle::wheel::Rim;

/// The air intake between the headlamps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Grille {
    /// Framed in chrome, with one bar.
    Framed,
    /// Horizontal bars.
    Bars,
    /// A black slit from lamp to lamp.
    Slit,
    /// Closed: an electric car.
    Closed,
    /// Tall, down to the bumper.
    Tall,
    /// Upright slots, as on off-roaders.
    Slots,
    /// Black from one square lamp to the other, as in the eighties.
    Classic,
}

/// Measures of a car. `d` is the distance from the front bumper backwards, metres.
#[derive(Debug, Clone)]
pub(crate) struct CarShape {
    pub(crate) length: f32,
    pub(crate) half_width: f32,
    pub(crate) clearance: f32,
    pub(crate) wheelbase: f32,
    pub(crate) front_axle_d: f32,
    pub(crate) wheel_radius: f32,
    pub(crate) tyre_width: f32,
    pub(crate) rim: Rim,
    /// Centre line of bonnet and boot: (d, z), from the nose's upper edge to the tail's.
    pub(crate) deck: Vec<(f32, f32)>,
    /// Belt line: (d, z).
    pub(crate) belt: Vec<(f32, f32)>,
    /// Roof's centre line: (d, z).
    pub(crate) roof: Vec<(f32, f32)>,
    /// d of the windscreen's foot, its top, the roof's rear edge, the rear window's foot.
    pub(crate) cabin_d: [f32; 4],
    /// How much narrower the roof's edge is than the body, each side.
    pub(crate) tumblehome: f32,
    /// VehicleBlueprint view: bow and corner radius at front and rear.
    pub(crate) bow: [f32; 2],
    pub(crate) corner: [f32; 2],
    /// How far nose and tail recede from the bumper up to the deck.
    pub(crate) rake: [f32; 2],
    /// d where side glass is divided by pillars, and where it ends.
    pub(crate) pillars_d: Vec<f32>,
    /// Foot and top of the rear end of the side glass.
    pub(crate) glass_end_d: [f32; 2],
    /// d of door gaps.
    pub(crate) doors_d: Vec<f32>,
    /// Black cladding around arches and sills.
    pub(crate) cladding: bool,
    /// Rails along the roof.
    pub(crate) rails: bool,
    /// Tail lamps: upright beside the rear window (true) or flat below the boot lid's edge.
    pub(crate) upright_lamps: bool,
    /// Rear window in the tailgate or behind the cabin; false for blind panels.
    pub(crate) rear_window: bool,
    /// Height range of the tail lamps.
    pub(crate) tail_lamp_z: [f32; 2],
    /// Height range of the headlamps at their inner end.
    pub(crate) head_lamp_z: [f32; 2],
    /// What is between the headlamps.
    pub(crate) grille: Grille,
}

impl CarShape {
    /// x of a distance from the front.
    pub(crate) fn x(&self, d: f32) -> f32 {
        0.5 * self.length - d
    }

    pub(crate) fn axles(&self) -> [f32; 2] {
        [self.x(self.front_axle_d), self.x(self.front_axle_d + self.wheelbase)]
    }

    /// Height of the roof, rails included.
    pub(crate) fn height(&self) -> f32 {
        let roof = self.roof.iter().map(|p| p.1).fold(0.0, f32::max);
        if self.rails { roof + 0.025 } else { roof }
    }
}
