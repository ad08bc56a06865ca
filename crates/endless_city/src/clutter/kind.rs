//! The things that stand about: furniture of the catalogue, and geometric solids in any colour.

use super::solid::{SolidForm, solid};
use crate::SharedModels;
use endless_asset::{Catalogue, Prop};
use endless_render::Geometry;
use endless_scene::{Material, Surface};
use endless_town::PlacedObject;
use endless_world::{ClassTag, Stream};
use glam::Vec3;
use std::ops::Range;

/// Furniture that may stand anywhere. Signs, signals, and what marks roadworks to drivers, mean something: they are left out.
const PROPS: [Prop; 14] = [
    Prop::Bench,
    Prop::Bin,
    Prop::PostBox,
    Prop::Planter,
    Prop::Cone,
    Prop::Cabinet,
    Prop::NewsBox,
    Prop::SandwichBoard,
    Prop::WheelieBins,
    Prop::RubbishBags,
    Prop::Pallets,
    Prop::Drum,
    Prop::Rock,
    Prop::ParkingMeter,
];

/// Diagonal of what is slim, metres.
const SLIM_M: f32 = 0.6;
/// Share of solids among all.
const SOLIDS: f64 = 0.55;

/// Models of what may stand about.
pub(super) struct ClutterModels {
    props: Vec<Geometry>,
}

/// One thing.
pub(super) struct DrawnThing {
    pub(super) geometry: Geometry,
    pub(super) scale: Vec3,
    /// Of the box that holds it about its foot, metres.
    pub(super) size: Vec3,
}

impl ClutterModels {
    pub(super) fn new(shared: &SharedModels, catalogue: &Catalogue) -> Self {
        let variants = |prop| (0..catalogue.prop_variants(prop).min(4)).map(move |n| PlacedObject::Prop(prop, n));
        let props = shared.props(PROPS.into_iter().flat_map(variants).collect(), catalogue);
        Self { props: props.into_values().collect() }
    }

    /// Something that finds room between a kerb and those who walk.
    pub(super) fn draw_slim(&self, random: &mut Stream) -> DrawnThing {
        let thing = self.draw(random);
        let widest = thing.size.truncate().length();
        if widest < SLIM_M { thing } else { draw_solid(random, 0.14..0.5 * SLIM_M, 0.5..1.9) }
    }

    /// Any of them.
    pub(super) fn draw(&self, random: &mut Stream) -> DrawnThing {
        if random.chance(SOLIDS) {
            return draw_solid(random, 0.25..1.0, 0.3..1.7);
        }
        let geometry = random.pick(&self.props).clone();
        let (low, high) = geometry.mesh().bounds();
        let half = low.truncate().abs().max(high.truncate().abs());
        DrawnThing { geometry, scale: Vec3::ONE, size: (2.0 * half).extend(high.z) }
    }
}

/// A solid of a width and a height within these, metres.
fn draw_solid(random: &mut Stream, widths_m: Range<f32>, heights_m: Range<f32>) -> DrawnThing {
    let form = *random.pick(&SolidForm::ALL);
    let size = if form == SolidForm::Ball {
        Vec3::splat(random.range_f32(widths_m.start, 1.1 * widths_m.end))
    } else {
        let width = random.range_f32(widths_m.start, widths_m.end);
        Vec3::new(width, width * random.range_f32(0.5, 1.0), random.range_f32(heights_m.start, heights_m.end))
    };
    let color = std::array::from_fn(|_| random.range_f32(0.02, 0.85));
    let surface = *random.pick(&[Surface::Plastic, Surface::Painted, Surface::Cloth]);
    let mesh = solid(form, Material::new(surface, color, ClassTag::Dynamic));
    DrawnThing { geometry: Geometry::new(mesh), scale: size, size }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_of_an_annotated_class_nor_of_meaning_to_drivers_stands_about() {
        let models = ClutterModels::new(&SharedModels::default(), &Catalogue::builtin());
        assert!(models.props.len() >= PROPS.len());
        let mut random = Stream::new(1, &[]);
        for _ in 0..200 {
            let thing = models.draw(&mut random);
            for material in &thing.geometry.mesh().materials {
                let tag = material.tag;
                assert!(
                    matches!(tag, ClassTag::Static | ClassTag::Dynamic | ClassTag::Vegetation | ClassTag::Terrain),
                    "{tag:?}"
                );
            }
            assert!(thing.size.min_element() > 0.1 && thing.size.max_element() < 4.0, "{}", thing.size);
            assert!(models.draw_slim(&mut random).size.truncate().length() < SLIM_M);
        }
    }
}
