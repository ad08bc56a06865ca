//! Which surfaces have colours of a video's own, and whose colours they are.

use crate::scene::SurfaceInteraction;
use endless_scene::{Material, Surface};
use endless_world::{ClassTag, ColorVariation, InstanceId};
use glam::Vec3A;

/// Trees, by their height, metres: each has its own green. Hedges and fields are made of pieces that look alike.
const TREE_M: f32 = 4.0;

/// The material of a point with its colour varied. What drivers and labels must know by its colour keeps it: paint on the
/// road, signs, signals, lights, and skin and hair.
pub(super) fn varied(colors: &ColorVariation, point: &SurfaceInteraction<'_>) -> Material {
    let material = *point.material;
    if !has_free_color(point) {
        return material;
    }
    let owner = owner(point);
    if material.surface == Surface::CarPaint {
        // The paint is the tint: what is made of several tones of it stays so.
        let tint = point.instance.tint.max(Vec3A::splat(1e-4));
        let painted = Vec3A::from(colors.linear(owner, point.instance.tint.to_array()));
        let base_color = (Vec3A::from(material.base_color) * painted / tint).to_array();
        return Material { base_color, ..material };
    }
    Material { base_color: colors.linear(owner, material.base_color), ..material }
}

fn has_free_color(point: &SurfaceInteraction<'_>) -> bool {
    match point.material.surface {
        Surface::RoadPaint
        | Surface::WindowGlass
        | Surface::ShopGlass
        | Surface::LitSign
        | Surface::CarGlass
        | Surface::Water
        | Surface::VehicleLight(_)
        | Surface::SignalLens(_)
        | Surface::LampLens
        | Surface::Skin
        | Surface::Hair => false,
        // People wear and carry what is dyed, whatever it is made of.
        Surface::Rubber | Surface::Plastic | Surface::Metal | Surface::Chrome | Surface::Leather | Surface::Plate => {
            is_person(point)
        }
        _ => !matches!(point.material.tag, ClassTag::TrafficSigns | ClassTag::TrafficLight),
    }
}

fn is_person(point: &SurfaceInteraction<'_>) -> bool {
    matches!(point.instance.class, Some(ClassTag::Pedestrians | ClassTag::Rider))
}

/// Whose surface it is, in 40 bits: objects are told by their ids, and what is built or planted by where it stands. What
/// covers the ground, and what is made of many pieces, belongs to the whole town.
pub(super) fn owner(point: &SurfaceInteraction<'_>) -> u64 {
    const TOWN: u64 = 1 << 39;
    let instance = point.instance;
    if instance.id != InstanceId::STUFF {
        return u64::from(instance.id.0);
    }
    let (low, high) = instance.geometry.posed.blas.bounds();
    let whole = match point.material.surface {
        Surface::Foliage | Surface::Bark => high.z < TREE_M,
        surface => super::texture::lies_on_ground(surface),
    };
    if whole {
        return TOWN;
    }
    // A quarter of a metre tells neighbours apart.
    let stand = ((instance.world_from_object.translation + low) * 4.0).round();
    let bits = |along: f32| u64::from(along as i32 as u32) & 0x7_ffff;
    TOWN ^ (1 << 38 | bits(stand.x) << 19 | bits(stand.y))
}
