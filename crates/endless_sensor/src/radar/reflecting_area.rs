//! How much of a radar's waves surfaces send back.

use endless_scene::Surface;

/// Radar cross-section of a piece of surface, of its area as the radar sees it, at 77 GHz; `facing` is the cosine of the angle
/// of incidence.
///
/// A scattered part, and a mirrored one of facets whose slopes have a normal distribution (Barrick 1968). The numbers are of
/// the order of measured ones: a car has 1 to 100 m² by its side, most when seen straight on, a person 0.1 to 1 m² (Yamada
/// 2005), roads under grazing waves a hundredth of their visible area and less. They are set by eye.
pub(super) fn reflecting_share(surface: Surface, facing: f32) -> f32 {
    /// Scattered, mirrored, spread of the slopes.
    const METAL: (f32, f32, f32) = (0.6, 12.0, 0.12);
    const WALL: (f32, f32, f32) = (0.08, 2.0, 0.1);
    const BODY: (f32, f32, f32) = (0.4, 0.4, 0.3);
    let (scattered, mirrored, slope) = match surface {
        Surface::CarPaint
        | Surface::Metal
        | Surface::Chrome
        | Surface::Painted
        | Surface::Cladding
        | Surface::Plate => METAL,
        Surface::VehicleLight(_) | Surface::SignalLens(_) | Surface::LampLens => (0.4, 2.0, 0.12),
        Surface::WindowGlass | Surface::ShopGlass | Surface::CarGlass => (0.03, 3.0, 0.05),
        Surface::Brick
        | Surface::Plaster
        | Surface::Stone
        | Surface::Concrete
        | Surface::RoofTile
        | Surface::FlatRoof
        | Surface::Kerb => WALL,
        Surface::Wood | Surface::Rubber | Surface::Plastic | Surface::LitSign | Surface::Leather => (0.12, 0.5, 0.15),
        Surface::Skin | Surface::Cloth | Surface::Hair => BODY,
        Surface::Foliage | Surface::Bark => (0.12, 0.0, 0.2),
        Surface::Grass | Surface::Gravel | Surface::Soil => (0.04, 0.2, 0.2),
        Surface::Asphalt | Surface::RoadPaint | Surface::Paving | Surface::Cobbles => (0.01, 1.0, 0.06),
        Surface::Water => (0.001, 3.0, 0.04),
    };
    let facing = facing.clamp(0.0, 1.0);
    let square = facing * facing;
    let tilt = (1.0 - square) / square.max(1e-6);
    scattered * facing + mirrored * endless_world::math::exp(-tilt / (slope * slope)) / square.max(1e-6)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn metal_outshines_cloth_and_cloth_roads() {
        for facing in [1.0, 0.7, 0.2] {
            let of = |surface| reflecting_share(surface, facing);
            assert!(of(Surface::CarPaint) > of(Surface::Cloth) && of(Surface::Cloth) > of(Surface::Foliage));
        }
        assert!(reflecting_share(Surface::Asphalt, 0.05) < 0.01);
        assert!(reflecting_share(Surface::CarPaint, 1.0) > 10.0 * reflecting_share(Surface::CarPaint, 0.8));
        assert!(reflecting_share(Surface::Water, 0.0).is_finite());
    }
}
