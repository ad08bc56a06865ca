//! Names and stripes on the sides of vans and lorries, as they look from as far as cameras hang: bars of letters' width.

use super::car::CarShape;
use super::draw::DesignDraw;
use super::paint;
use crate::shape::{Region, Sculpt};
use endless_scene::Material;
use glam::{Vec2, Vec3};

/// Colours of lettering.
pub(crate) const INKS: &[Material] = &[paint::RED, paint::BLUE, paint::TRIM, paint::YELLOW, paint::TEAL];

/// What a firm writes on its vehicles.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sign {
    ink: Material,
    second: Material,
    letters: usize,
    rhythm: f32,
    emblem: bool,
    numbers: bool,
}

impl Sign {
    /// Some firm's.
    pub(crate) fn drawn(draw: &DesignDraw) -> Self {
        Self {
            ink: draw.pick("ink", INKS),
            second: draw.pick("second ink", INKS),
            letters: draw.pick("letters", &[5, 6, 8, 9, 11]),
            rhythm: draw.range("rhythm", 0.0, 10.0),
            emblem: draw.chance("emblem", 0.6),
            numbers: draw.chance("numbers", 0.7),
        }
    }

    /// On both sides of a body, in a field of the side view that goes from x1 back to x0, over these materials.
    pub(crate) fn on_sides(&self, body: &mut Sculpt, [x0, x1]: [f32; 2], [z0, z1]: [f32; 2], over: &[Material]) {
        let high = z1 - z0;
        let mut at = x1;
        if self.emblem {
            let wide = (0.9 * high).min(0.3 * (x1 - x0));
            self.bar(body, [at - wide, at], [z0 + 0.25 * high, z1], self.second, over);
            at -= wide + 0.08;
        }
        self.word(body, [x0, at], [z0 + 0.45 * high, z1], self.letters, over);
        if self.numbers {
            let end = at - 0.7 * (at - x0);
            self.word(body, [end, at], [z0, z0 + 0.25 * high], self.letters + 3, over);
        }
    }

    /// Letters from the front back, as they read on the right side; on the left a word is as long.
    fn word(&self, body: &mut Sculpt, [x0, x1]: [f32; 2], z: [f32; 2], letters: usize, over: &[Material]) {
        let step = ((x1 - x0) / letters as f32).min(1.1 * (z[1] - z[0]));
        for i in 0..letters {
            // Letters differ in width, and words have gaps.
            let wave = endless_world::math::sin(self.rhythm + 2.4 * i as f32);
            if wave < -0.93 {
                continue;
            }
            let wide = step * (0.58 + 0.16 * wave);
            let from = x1 - step * i as f32;
            let low = if wave > 0.6 { z[0] + 0.22 * (z[1] - z[0]) } else { z[0] };
            self.bar(body, [from - wide, from], [low, z[1]], self.ink, over);
        }
    }

    fn bar(&self, body: &mut Sculpt, [x0, x1]: [f32; 2], [z0, z1]: [f32; 2], ink: Material, over: &[Material]) {
        let rectangle = [(x0, z0), (x1, z0), (x1, z1), (x0, z1)].map(Vec2::from);
        let region = Region::side(&rectangle).facing(Vec3::Y, 0.6).beyond(Vec3::Y, 0.5);
        for &under in over {
            body.repaint_both(&region, under, ink);
        }
    }
}

/// A stripe along a car's flanks.
pub(crate) fn stripe(body: &mut Sculpt, shape: &CarShape, ink: Material) {
    let z = 0.5 * (shape.clearance + shape.belt[2].1) + 0.12;
    let along = shape.panel(0.10, shape.length - 0.10, z, z + 0.11);
    body.repaint_both(&along, paint::BODY, ink);
}
