//! What light carriers are loaded with.

use crate::shape::Sculpt;
use endless_scene::{Material, Surface};
use endless_world::{ClassTag, Stream};
use glam::{Vec2, Vec3};

const fn of(surface: Surface, base_color: [f32; 3]) -> Material {
    Material::new(surface, base_color, ClassTag::Car)
}

const SACK: Material = of(Surface::Cloth, [0.46, 0.40, 0.28]);
const CRATES: [Material; 4] = [
    of(Surface::Plastic, [0.34, 0.02, 0.02]),
    of(Surface::Plastic, [0.02, 0.09, 0.32]),
    of(Surface::Plastic, [0.58, 0.36, 0.02]),
    of(Surface::Plastic, [0.02, 0.17, 0.07]),
];
const CARTONS: [Material; 3] = [
    of(Surface::Wood, [0.36, 0.25, 0.14]),
    of(Surface::Wood, [0.30, 0.21, 0.12]),
    of(Surface::Plastic, [0.62, 0.60, 0.55]),
];
const BOTTLES: [Material; 3] = [
    of(Surface::Metal, [0.50, 0.16, 0.02]),
    of(Surface::Metal, [0.04, 0.14, 0.34]),
    of(Surface::Metal, [0.36, 0.37, 0.38]),
];
const FRUIT: [Material; 3] = [
    of(Surface::Foliage, [0.06, 0.16, 0.03]),
    of(Surface::Cloth, [0.55, 0.22, 0.02]),
    of(Surface::Cloth, [0.40, 0.30, 0.03]),
];

/// Kinds of loads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Freight {
    Nothing,
    /// Plastic crates of several colours.
    Crates,
    /// Full sacks.
    Sacks,
    /// Gas bottles, upright.
    Bottles,
    /// A heap of fruit or greens.
    Heap,
    /// Cartons under a net.
    Cartons,
}

impl Freight {
    /// Those that drivers of light carriers have.
    pub(crate) const ALL: [Self; 6] =
        [Self::Nothing, Self::Crates, Self::Sacks, Self::Bottles, Self::Heap, Self::Cartons];

    /// How high it may stand over its floor, of a bed whose walls are so high, metres.
    pub(crate) fn height(self, walls: f32) -> f32 {
        match self {
            Self::Nothing => 0.0,
            Self::Crates | Self::Cartons => 1.5 * walls + 0.2,
            Self::Sacks => 1.3 * walls + 0.1,
            Self::Bottles => 0.62,
            Self::Heap => 1.35 * walls,
        }
    }

    /// The load on a floor.
    pub(crate) fn on(self, low: Vec3, high: Vec2, height: f32, seed: u64) -> Sculpt {
        let mut stream = Stream::named(seed, "freight", &[]);
        let top = low.z + height;
        match self {
            Self::Nothing => Sculpt::new(),
            Self::Crates => stacked(low, high, top, Vec3::new(0.40, 0.30, 0.25), &CRATES, &mut stream),
            Self::Cartons => stacked(low, high, top, Vec3::new(0.46, 0.36, 0.34), &CARTONS, &mut stream),
            Self::Sacks => sacks(low, high, top, &mut stream),
            Self::Bottles => bottles(low, high, &mut stream),
            Self::Heap => heap(low, high, top, &mut stream),
        }
    }
}

/// Boxes in layers, the upper ones with gaps, of which at least one reaches the top.
fn stacked(low: Vec3, high: Vec2, top: f32, unit: Vec3, materials: &[Material], stream: &mut Stream) -> Sculpt {
    let mut s = Sculpt::new();
    let count = |length: f32, unit: f32| ((length / unit) as usize).max(1);
    let (nx, ny) = (count(high.x - low.x, unit.x), count(high.y - low.y, unit.y));
    let layers = (((top - low.z) / unit.z).ceil() as usize).max(1);
    let step = Vec3::new((high.x - low.x) / nx as f32, (high.y - low.y) / ny as f32, (top - low.z) / layers as f32);
    for i in 0..nx {
        for j in 0..ny {
            let least = if (i, j) == (nx / 2, ny / 2) { layers } else { layers.saturating_sub(2).max(1) };
            let many = least + stream.below(layers - least + 1);
            for k in 0..many {
                let at = low + step * Vec3::new(i as f32, j as f32, k as f32);
                s.add(Sculpt::cuboid(
                    at + 0.012,
                    at + step - Vec3::new(0.012, 0.012, 0.0),
                    0.0,
                    *stream.pick(materials),
                ));
            }
        }
    }
    s
}

fn sacks(low: Vec3, high: Vec2, top: f32, stream: &mut Stream) -> Sculpt {
    let mut s = Sculpt::new();
    let layers = (((top - low.z) / 0.17).round() as usize).max(1);
    let thick = (top - low.z) / layers as f32;
    let n = (((high.x - low.x) / 0.46) as usize).max(1);
    for k in 0..layers {
        // Each layer lies a little further in than the one below.
        let inset = (0.03 * k as f32).min(0.12);
        let (x0, x1) = (low.x + inset, high.x - inset);
        let (y0, y1) = (low.y + inset, high.y - inset);
        for i in 0..n {
            for (from, to) in [(y0, 0.5 * (y0 + y1)), (0.5 * (y0 + y1), y1)] {
                let x = x0 + (x1 - x0) * (i as f32 + 0.5) / n as f32 + stream.range_f32(-0.015, 0.015);
                let z = low.z + thick * (k as f32 + 0.5);
                let half = Vec2::new(0.5 * (x1 - x0) / n as f32, 0.5 * thick);
                let at = |t: f32, fat: f32| (Vec3::new(x, from + (to - from) * t, z), half * fat);
                let sack = [at(0.01, 0.55), at(0.1, 0.85), at(0.3, 1.0), at(0.7, 1.0), at(0.9, 0.85), at(0.99, 0.55)];
                s.add(Sculpt::sweep(&sack, Vec3::X, 10, 2.6, true, SACK));
            }
        }
    }
    s
}

fn bottles(low: Vec3, high: Vec2, stream: &mut Stream) -> Sculpt {
    let profile = [(0.0, 0.0), (0.13, 0.01), (0.15, 0.06), (0.15, 0.42), (0.09, 0.50), (0.09, 0.62), (0.0, 0.62)];
    let color = *stream.pick(&BOTTLES);
    let mut s = Sculpt::new();
    let count = |length: f32| ((length / 0.33) as usize).max(1);
    let (nx, ny) = (count(high.x - low.x), count(high.y - low.y));
    for i in 0..nx {
        for j in 0..ny {
            if i > 0 && stream.chance(0.25) {
                continue;
            }
            let x = low.x + (high.x - low.x) * (i as f32 + 0.5) / nx as f32;
            let y = low.y + (high.y - low.y) * (j as f32 + 0.5) / ny as f32;
            s.add(Sculpt::lathe(&profile, 12, 40.0, color).at(Vec3::new(x, y, low.z)));
        }
    }
    s
}

fn heap(low: Vec3, high: Vec2, top: f32, stream: &mut Stream) -> Sculpt {
    let color = *stream.pick(&FRUIT);
    let mut s = Sculpt::new();
    let n = 6;
    let rows: Vec<Vec<Vec3>> = (0..=n)
        .map(|j| {
            (0..=n)
                .map(|i| {
                    let (a, b) = (i as f32 / n as f32, j as f32 / n as f32);
                    let bell = |t: f32| 1.0 - (2.0 * t - 1.0) * (2.0 * t - 1.0);
                    let rise = bell(a) * bell(b);
                    let rough = if (0.05..=0.95).contains(&rise) { stream.range_f32(-0.03, 0.03) } else { 0.0 };
                    let z = low.z + 0.02 + (top - low.z - 0.02) * (0.45 + 0.55 * rise) + rough;
                    Vec3::new(low.x + a * (high.x - low.x), low.y + b * (high.y - low.y), z)
                })
                .collect()
        })
        .collect();
    s.grid(&rows, false, color);
    let mut s = s.smooth(60.0);
    // What the heap's edge stands on.
    s.add(Sculpt::cuboid(low, high.extend(low.z + 0.02 + 0.45 * (top - low.z - 0.02)), 0.0, color));
    s
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loads_stay_in_their_bed_and_are_as_high_as_told() {
        let (low, high) = (Vec3::new(-1.5, -0.55, 0.6), Vec2::new(0.1, 0.55));
        for freight in Freight::ALL {
            for seed in 0..20 {
                let height = freight.height(0.4);
                let load = freight.on(low, high, height, seed);
                if freight == Freight::Nothing {
                    assert!(load.faces().is_empty());
                    continue;
                }
                let (from, to) = load.bounds();
                assert!((to.z - low.z - height).abs() < 0.03, "{freight:?} {seed}: {to}, {height} m");
                assert!(from.z > low.z - 0.01, "{freight:?} {seed}: {from}");
                let inside = from.cmpge(low - 0.03).all() && to.truncate().cmple(high + 0.03).all();
                assert!(inside, "{freight:?} {seed}: {from} {to}");
            }
        }
    }
}
