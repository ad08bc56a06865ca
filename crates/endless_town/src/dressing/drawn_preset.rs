//! What a town is like that is dressed anew: its lamps, trees, wires, what is built, and the colours of its grounds.

use super::preset::{StreetLife, TownPreset};
use super::road_furniture::sign_standard::SignStandard;
use endless_asset::Prop;
use endless_scene::{Mesh, Surface};
use endless_world::Stream;
use std::sync::Arc;

/// Light of street lamps: sodium, warm and cool LED, mercury, metal halide; linear colours.
const LAMPS: [[f32; 3]; 5] =
    [[1.0, 0.58, 0.20], [1.0, 0.80, 0.55], [0.95, 1.0, 1.0], [0.80, 1.0, 0.92], [1.0, 0.92, 0.80]];
/// Share of towns with wires along all streets, with low bright houses, with palms.
const WIRED: f64 = 0.4;
const BRIGHT: f64 = 0.22;
const WITH_PALMS: f64 = 0.25;

/// Share of towns with painted lanes for buses, and their colours: red, green, ochre, blue.
const BUS_LANES: f64 = 0.25;
const BUS_LANE_COLORS: [[f32; 3]; 4] = [[0.28, 0.07, 0.05], [0.07, 0.17, 0.10], [0.34, 0.22, 0.07], [0.05, 0.12, 0.28]];

/// Share of towns whose crossings have signals of their own, of those with a second light at each approach, and of those
/// with lights over all roads; poles that bend among what carries these.
const WALK_SIGNALS: f64 = 0.85;
const REPEATERS: f64 = 0.6;
const MASTS_EVERYWHERE: f64 = 0.5;
const CURVED_MASTS: f64 = 0.5;
/// Towns with nothing at the kerbs of corners, with rails, with bollards.
const KERB_GUARDS: [f64; 3] = [0.45, 0.3, 0.25];

/// Share of the ground between houses that is not paved where most is.
const GREEN_YARDS: [f64; 2] = [0.1, 0.8];
/// Share of towns with signs along their streets.
const WITH_SIGNS: f64 = 0.85;

/// A preset that was drawn, and the colours that go with it.
pub(crate) struct DrawnPreset {
    pub(crate) preset: TownPreset,
    pub(crate) tints: GroundTints,
}

impl DrawnPreset {
    /// What a preset becomes by a seed.
    pub(crate) fn new(usual: &TownPreset, seed: u64) -> Self {
        let mut random = Stream::named(seed, "town/drawn preset", &[]);
        let mut preset = usual.clone();
        preset.lamp_color = *random.pick(&LAMPS);
        preset.lamp_cd *= random.range_f32(0.6, 1.5);
        preset.conifers = random.range_f64(0.0, 0.6);
        let palms = usual.palms > 0.0 || random.chance(WITH_PALMS);
        preset.palms = if palms { random.range_f64(0.15, 0.6) } else { 0.0 };
        preset.wires = usual.wires || random.chance(WIRED);
        preset.bright = usual.bright || random.chance(BRIGHT);
        preset.yards = usual.yards || random.chance(0.25);
        preset.green_yards = random.range_f64(GREEN_YARDS[0], GREEN_YARDS[1]);
        // Where wires hang, streets are full of other things, too.
        let full = if preset.wires { 1.6 } else { 1.0 };
        let mut share = |often: f64, most: f64| {
            if random.chance(often) { random.range_f64(0.1, 1.0) * most * full } else { 0.0 }
        };
        preset.life = StreetLife {
            vendors: share(0.6, 0.35),
            works: share(0.6, 0.12),
            rubbish: share(0.7, 0.25),
            scaffolds: share(0.5, 0.1),
            laundry: share(0.4, 0.4),
        };
        preset.old_paint = share(0.6, 0.5);
        preset.walk_signals = random.chance(WALK_SIGNALS);
        preset.signal_repeaters = random.chance(REPEATERS);
        preset.masts_everywhere = random.chance(MASTS_EVERYWHERE);
        if random.chance(CURVED_MASTS) {
            preset.signal_mast = Prop::SignalCurvedMast;
        }
        preset.kerb_guard = [None, Some(Prop::KerbRail), Some(Prop::Bollard)][random.weighted(&KERB_GUARDS)];
        preset.street_signs =
            random.chance(WITH_SIGNS).then(|| *random.pick(&[SignStandard::Vienna, SignStandard::Mutcd]));
        preset.bus_lanes = random.chance(BUS_LANES).then(|| *random.pick(&BUS_LANE_COLORS));
        for zone in &mut preset.zones {
            let (low, high) = zone.storeys;
            let high = (high + random.below(3) as u32).saturating_sub(1);
            let low = low.saturating_sub(random.below(2) as u32).max(1);
            zone.storeys = (low, high.max(low));
            zone.open = (zone.open * random.range_f64(0.5, 2.2)).min(0.9);
        }
        Self { preset, tints: GroundTints::draw(&mut random) }
    }
}

/// Factors of the colours of a town's grounds and walls.
pub(crate) struct GroundTints {
    asphalt: [f32; 3],
    paving: [f32; 3],
    kerb: [f32; 3],
    green: [f32; 3],
    soil: [f32; 3],
    walls: [f32; 3],
    paint: [f32; 3],
}

impl GroundTints {
    fn draw(random: &mut Stream) -> Self {
        // Grey, with a little of a colour.
        let mut tint = |low: f32, high: f32, hue: f32| {
            let grey = random.range_f32(low, high);
            let warm = random.range_f32(-hue, hue);
            [grey * (1.0 + warm), grey, grey * (1.0 - warm)]
        };
        let asphalt = tint(0.55, 2.1, 0.07);
        let paving = tint(0.6, 1.35, 0.12);
        let kerb = tint(0.7, 1.3, 0.05);
        let soil = tint(0.7, 1.5, 0.15);
        let walls = tint(0.82, 1.12, 0.06);
        let paint = tint(0.55, 1.05, 0.03);
        // From lush to dry.
        let dry = random.f32();
        let green = [0.8 + 1.3 * dry, 0.9 + 0.25 * dry, 0.9 + 0.5 * dry];
        Self { asphalt, paving, kerb, green, soil, walls, paint }
    }

    /// A mesh in these colours.
    pub(crate) fn applied(&self, mut mesh: Arc<Mesh>) -> Arc<Mesh> {
        for material in &mut Arc::make_mut(&mut mesh).materials {
            let tint = match material.surface {
                Surface::Asphalt | Surface::Cobbles => self.asphalt,
                Surface::Paving | Surface::Concrete => self.paving,
                Surface::Kerb => self.kerb,
                Surface::Grass => self.green,
                Surface::Soil | Surface::Gravel => self.soil,
                Surface::Plaster | Surface::Brick | Surface::Stone | Surface::Cladding => self.walls,
                Surface::RoadPaint => self.paint,
                _ => continue,
            };
            let [r, g, b] = material.base_color;
            material.base_color = [r * tint[0], g * tint[1], b * tint[2]].map(|c| c.min(0.85));
        }
        mesh
    }
}
