//! How much of a LiDAR's light surfaces send back.

use endless_render::RayHit;
use endless_scene::Surface;

/// Reflection at 905 nm towards where the light came from.
struct Reflection {
    /// Diffuse reflectance, 0 to 1.
    diffuse: f32,
    /// Standard deviation of the slope of its facets, radians.
    roughness_rad: f32,
    /// What beads or prisms send back on top, of what a white surface that faces the sensor does.
    retro: f32,
}

/// Of a kind of surface with a colour of this mean, 0 to 1. Reflectances are of the order of those that the ECOSTRESS spectral
/// library (Meerdink et al. 2019) has at 0.9 µm; leaves are bright there, and dyes of cloth clear. Paint is as bright as it
/// looks. Roughness is set by eye.
fn reflection_of(surface: Surface, color: f32) -> Reflection {
    let (diffuse, roughness_rad, retro) = match surface {
        Surface::Asphalt => (0.18, 0.6, 0.0),
        Surface::RoadPaint => (0.45, 0.5, 0.3),
        Surface::Paving | Surface::Kerb | Surface::Concrete => (0.32, 0.5, 0.0),
        Surface::Cobbles | Surface::Stone => (0.28, 0.6, 0.0),
        Surface::Grass => (0.45, 0.7, 0.0),
        Surface::Soil => (0.28, 0.6, 0.0),
        Surface::Gravel => (0.26, 0.7, 0.0),
        Surface::Brick | Surface::RoofTile => (0.38, 0.5, 0.0),
        Surface::Plaster => (0.3 + 0.4 * color, 0.4, 0.0),
        Surface::FlatRoof => (0.15, 0.5, 0.0),
        Surface::Wood => (0.45, 0.3, 0.0),
        Surface::Cladding | Surface::Painted | Surface::Plastic | Surface::LitSign => (0.1 + 0.65 * color, 0.2, 0.0),
        Surface::CarPaint => (0.05 + 0.7 * color, 0.1, 0.0),
        // Most goes through, or away as in a mirror.
        Surface::WindowGlass | Surface::ShopGlass | Surface::CarGlass => (0.04, 0.0, 0.0),
        Surface::Rubber => (0.05, 0.4, 0.0),
        Surface::Metal => (0.4, 0.3, 0.0),
        Surface::Chrome => (0.15, 0.1, 0.0),
        Surface::Cloth => (0.4 + 0.3 * color, 0.5, 0.0),
        Surface::Skin => (0.55, 0.3, 0.0),
        Surface::Hair => (0.25, 0.6, 0.0),
        Surface::Leather => (0.3, 0.4, 0.0),
        Surface::Bark => (0.35, 0.6, 0.0),
        Surface::Foliage => (0.5, 0.5, 0.0),
        Surface::Water => (0.02, 0.0, 0.0),
        Surface::Plate => (0.5, 0.2, 20.0),
        Surface::VehicleLight(_) | Surface::SignalLens(_) => (0.2, 0.0, 0.5),
        Surface::LampLens => (0.3, 0.0, 0.0),
    };
    Reflection { diffuse, roughness_rad, retro }
}

/// Light that a hit sends back to the sensor, of what a white surface that faces it does; above 1 for retroreflectors.
///
/// `facing` is the cosine of the angle of incidence. The diffuse part is the model of Oren and Nayar (1994) seen from where
/// the light comes from: Lambert's cosine for what is smooth, while what is rough, such as a road, stays visible under a
/// grazing ray. Wet ground is half as bright (Lekner and Dorf 1988), and mirrors what grazes it.
pub(super) fn returned_share(hit: &RayHit, facing: f32, wetness: f32) -> f32 {
    let Reflection { diffuse, roughness_rad, retro } = reflection_of(hit.surface, hit.base_color.element_sum() / 3.0);
    let variance = roughness_rad * roughness_rad;
    let (level, grazing) = (1.0 - 0.5 * variance / (variance + 0.33), 0.45 * variance / (variance + 0.09));
    let wet = if is_ground(hit) { wetness } else { 0.0 };
    let rough = level * facing + grazing * (1.0 - facing * facing) * (1.0 - 0.7 * wet);
    (diffuse * rough + retro) * (1.0 - 0.5 * wet)
}

fn is_ground(hit: &RayHit) -> bool {
    hit.normal.z > 0.7
        && matches!(
            hit.surface,
            Surface::Asphalt
                | Surface::RoadPaint
                | Surface::Paving
                | Surface::Kerb
                | Surface::Concrete
                | Surface::Cobbles
                | Surface::Stone
                | Surface::Soil
                | Surface::Gravel
        )
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{ClassTag, InstanceId};
    use glam::Vec3A;

    fn hit(surface: Surface, color: f32) -> RayHit {
        RayHit {
            distance: 10.0,
            tag: ClassTag::Static,
            id: InstanceId::STUFF,
            normal: Vec3A::Z,
            surface,
            base_color: Vec3A::splat(color),
            velocity_mps: Vec3A::ZERO,
        }
    }

    #[test]
    fn what_faces_the_sensor_is_brightest_and_roads_are_seen_under_grazing_rays() {
        let share = |surface, facing| returned_share(&hit(surface, 0.5), facing, 0.0);
        for surface in [Surface::Asphalt, Surface::CarPaint, Surface::Foliage, Surface::WindowGlass] {
            let mut last = f32::INFINITY;
            for step in 0..=20 {
                let now = share(surface, 1.0 - 0.05 * step as f32);
                assert!(now <= last + 1e-3 && now >= 0.0, "{surface:?} {step}");
                last = now;
            }
        }
        assert!(share(Surface::Asphalt, 0.03) > 0.3 * share(Surface::Asphalt, 1.0));
        assert!(share(Surface::WindowGlass, 0.03) < 0.05 * share(Surface::WindowGlass, 1.0));
    }

    #[test]
    fn paint_counts_and_signs_shine() {
        let share = |surface, color| returned_share(&hit(surface, color), 0.8, 0.0);
        assert!(share(Surface::CarPaint, 0.9) > 5.0 * share(Surface::CarPaint, 0.02));
        assert!(share(Surface::Plate, 0.5) > 10.0);
        assert!(share(Surface::RoadPaint, 0.7) > 1.5 * share(Surface::Asphalt, 0.1));
    }

    #[test]
    fn wet_ground_is_darker_and_walls_are_not() {
        let wet = returned_share(&hit(Surface::Asphalt, 0.1), 0.1, 1.0);
        assert!(wet < 0.4 * returned_share(&hit(Surface::Asphalt, 0.1), 0.1, 0.0));
        let wall = RayHit { normal: Vec3A::X, ..hit(Surface::Concrete, 0.4) };
        assert_eq!(returned_share(&wall, 0.5, 1.0), returned_share(&wall, 0.5, 0.0));
    }
}
