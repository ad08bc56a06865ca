//! The materials of vehicles. They belong to objects with a class of their own; the tag is only a fallback.

use endless_scene::{LightSlot, Material, Surface};
use endless_world::ClassTag;

const fn of(surface: Surface, base_color: [f32; 3]) -> Material {
    Material::new(surface, base_color, ClassTag::Car)
}

/// Body paint, tinted per variant.
pub(crate) const BODY: Material = of(Surface::CarPaint, [1.0; 3]);
pub(crate) const GLASS: Material = of(Surface::CarGlass, [0.02, 0.025, 0.028]);
pub(crate) const RUBBER: Material = of(Surface::Rubber, [0.022; 3]);
/// Unpainted bumpers, cladding, window surrounds.
pub(crate) const TRIM: Material = of(Surface::Plastic, [0.018; 3]);
/// What lies in shadow: wheel wells, underbody, grilles, door gaps.
pub(crate) const DARK: Material = of(Surface::Plastic, [0.006; 3]);
pub(crate) const GREY: Material = of(Surface::Plastic, [0.12; 3]);
pub(crate) const WHITE: Material = of(Surface::Plastic, [0.75; 3]);
pub(crate) const ORANGE: Material = of(Surface::Plastic, [0.75, 0.2, 0.01]);
pub(crate) const SEAT: Material = of(Surface::Leather, [0.02; 3]);
pub(crate) const CHROME: Material = of(Surface::Chrome, [0.75; 3]);
pub(crate) const ALLOY: Material = of(Surface::Chrome, [0.48, 0.49, 0.50]);
pub(crate) const DARK_ALLOY: Material = of(Surface::Metal, [0.09, 0.09, 0.095]);
pub(crate) const STEEL: Material = of(Surface::Metal, [0.35, 0.36, 0.37]);
pub(crate) const BRAKE: Material = of(Surface::Metal, [0.12; 3]);
pub(crate) const ENGINE: Material = of(Surface::Metal, [0.16, 0.16, 0.165]);
pub(crate) const CHASSIS: Material = of(Surface::Painted, [0.03; 3]);
pub(crate) const CARGO_WHITE: Material = of(Surface::Painted, [0.70, 0.70, 0.68]);
pub(crate) const PLATE: Material = of(Surface::Plate, [0.72, 0.72, 0.70]);
pub(crate) const PLATE_INK: Material = of(Surface::Plate, [0.03, 0.03, 0.06]);
pub(crate) const HEAD: Material = of(Surface::VehicleLight(LightSlot::Head), [0.80, 0.82, 0.84]);
pub(crate) const TAIL: Material = of(Surface::VehicleLight(LightSlot::Tail), [0.42, 0.010, 0.008]);
pub(crate) const BRAKE_LIGHT: Material = of(Surface::VehicleLight(LightSlot::Brake), [0.35, 0.01, 0.01]);
pub(crate) const REVERSE: Material = of(Surface::VehicleLight(LightSlot::Reverse), [0.7, 0.7, 0.7]);
pub(crate) const LEFT: Material = of(Surface::VehicleLight(LightSlot::IndicatorLeft), [0.85, 0.30, 0.02]);
pub(crate) const RIGHT: Material = of(Surface::VehicleLight(LightSlot::IndicatorRight), [0.85, 0.30, 0.02]);
/// Of beacons, to the left and to the right, and where those to the right are red.
pub(crate) const BEACON_LEFT: Material = of(Surface::VehicleLight(LightSlot::BeaconLeft), [0.015, 0.07, 0.62]);
pub(crate) const BEACON_RIGHT: Material = of(Surface::VehicleLight(LightSlot::BeaconRight), [0.015, 0.07, 0.62]);
pub(crate) const RED_BEACON_RIGHT: Material = of(Surface::VehicleLight(LightSlot::BeaconRight), [0.60, 0.015, 0.012]);
pub(crate) const RED_LIGHT: Material = of(Surface::LitSign, [0.60, 0.015, 0.012]);
pub(crate) const AMBER_LIGHT: Material = of(Surface::LitSign, [0.80, 0.34, 0.01]);
/// Colours of liveries.
pub(crate) const BLUE: Material = of(Surface::Plate, [0.012, 0.055, 0.30]);
pub(crate) const RED: Material = of(Surface::Plate, [0.48, 0.015, 0.012]);
pub(crate) const LIME: Material = of(Surface::Plate, [0.52, 0.62, 0.03]);
pub(crate) const YELLOW: Material = of(Surface::Plate, [0.72, 0.50, 0.02]);
pub(crate) const BRIGHT_STEEL: Material = of(Surface::Metal, [0.55, 0.56, 0.57]);
pub(crate) const WOOD: Material = of(Surface::Painted, [0.23, 0.16, 0.09]);
pub(crate) const CARTON: Material = of(Surface::Painted, [0.34, 0.24, 0.14]);
pub(crate) const PIPE: Material = of(Surface::Plastic, [0.55, 0.22, 0.06]);
pub(crate) const TEAL: Material = of(Surface::Plate, [0.01, 0.42, 0.36]);
