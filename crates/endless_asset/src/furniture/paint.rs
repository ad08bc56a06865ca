//! Materials of street furniture.

use endless_scene::{LensAspect, Material, Surface};
use endless_world::ClassTag;

pub(crate) const POLE: Material = Material::new(Surface::Metal, [0.34, 0.35, 0.36], ClassTag::Poles);
pub(crate) const DARK_POLE: Material = Material::new(Surface::Painted, [0.045, 0.05, 0.05], ClassTag::Poles);
pub(crate) const TIMBER_POLE: Material = Material::new(Surface::Wood, [0.16, 0.12, 0.09], ClassTag::Poles);
pub(crate) const HOUSING: Material = Material::new(Surface::Plastic, [0.016, 0.018, 0.016], ClassTag::TrafficLight);
pub(crate) const RED_LENS: Material =
    Material::new(Surface::SignalLens(LensAspect::Red), [0.30, 0.012, 0.010], ClassTag::TrafficLight);
pub(crate) const YELLOW_LENS: Material =
    Material::new(Surface::SignalLens(LensAspect::Yellow), [0.36, 0.18, 0.008], ClassTag::TrafficLight);
pub(crate) const GREEN_LENS: Material =
    Material::new(Surface::SignalLens(LensAspect::Green), [0.010, 0.20, 0.09], ClassTag::TrafficLight);
pub(crate) const LAMP: Material = Material::new(Surface::LampLens, [0.80, 0.80, 0.76], ClassTag::Poles);
pub(crate) const SIGN_BACK: Material = Material::new(Surface::Metal, [0.36, 0.37, 0.38], ClassTag::TrafficSigns);

/// A retro-reflective sign face.
pub(crate) const fn face(color: [f32; 3]) -> Material {
    Material::new(Surface::Plate, color, ClassTag::TrafficSigns)
}

pub(crate) const WHITE: Material = face([0.80, 0.80, 0.80]);
pub(crate) const BLACK: Material = face([0.015, 0.015, 0.015]);
pub(crate) const RED: Material = face([0.55, 0.016, 0.02]);
pub(crate) const BLUE: Material = face([0.012, 0.085, 0.42]);

/// Something that simply stands there.
pub(crate) const fn fixed(surface: Surface, color: [f32; 3]) -> Material {
    Material::new(surface, color, ClassTag::Static)
}

pub(crate) const STEEL: Material = fixed(Surface::Metal, [0.38, 0.39, 0.40]);
pub(crate) const DARK_STEEL: Material = fixed(Surface::Painted, [0.03, 0.033, 0.035]);
pub(crate) const SLATS: Material = fixed(Surface::Wood, [0.25, 0.145, 0.075]);
pub(crate) const CONCRETE: Material = fixed(Surface::Concrete, [0.42, 0.41, 0.39]);
pub(crate) const GLASS: Material = fixed(Surface::CarGlass, [0.10, 0.13, 0.13]);
pub(crate) const DARK: Material = fixed(Surface::Plastic, [0.012, 0.012, 0.012]);
