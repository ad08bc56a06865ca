//! Actors of a server in this workspace's terms: class, size, place.

use super::boxes::box_on_ground;
use crate::blueprint::{Blueprint, BlueprintKind, BlueprintLibrary};
use crate::frames;
use crate::wire::{self, Transform};
use endless_annotate::Box3d;
use endless_asset::Catalogue;
use endless_world::{AssetRef, ClassTag, ObjectClass, Outfit, PersonRef, Pose, VehicleRef};
use glam::{Vec2, Vec3};

/// What stays the same of an actor.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ActorBody {
    pub(super) class: ObjectClass,
    /// Somebody sits on it.
    pub(super) is_ridden: bool,
    /// The model of our catalogue that stands for it.
    pub(super) asset: AssetRef,
    /// Length, width and height, metres.
    pub(super) size: Vec3,
    /// From CARLA's place of the actor to ours, in our object frame, metres: of a vehicle, the middle of its box's floor; of a
    /// person, under their hips, about which the box need not be even.
    offset: Vec3,
    /// From our place to the middle of the box's floor.
    box_offset: Vec2,
}

impl ActorBody {
    /// Of a vehicle or person; `None` for others.
    pub(super) fn new(actor: &wire::Actor, library: &BlueprintLibrary, catalogue: &Catalogue) -> Option<Self> {
        let blueprint = library.find(&actor.description.id);
        let class = class(&actor.description)?;
        let bounds = &actor.bounding_box;
        let half = Vec3::new(bounds.extent.x, bounds.extent.y, bounds.extent.z).abs().max(Vec3::splat(0.1));
        let centre = frames::from_carla(&bounds.location);
        let (offset, box_offset) = if class == ObjectClass::Pedestrian {
            // People have their place in their middle.
            (Vec3::Z * (centre.z - half.z), centre.truncate())
        } else {
            (centre.truncate().extend(0.0), Vec2::ZERO)
        };
        let tags = &actor.semantic_tags.0;
        let is_ridden = class.two_wheeled() && (tags.is_empty() || tags.contains(&ClassTag::Rider.value()));
        let asset = asset(actor, class, blueprint, catalogue);
        Some(Self { class, is_ridden, asset, size: 2.0 * half, offset, box_offset })
    }

    /// On the ground, under its middle.
    pub(super) fn pose(&self, transform: &Transform) -> Pose {
        let pose = frames::pose(transform);
        Pose { position: pose.world_from_object().transform_point3(self.offset), ..pose }
    }

    /// Where CARLA has its place for it to stand at a pose.
    pub(super) fn transform(&self, pose: &Pose) -> Transform {
        let position = pose.position - pose.world_from_object().transform_vector3(self.offset);
        frames::transform(&Pose { position, ..*pose })
    }

    /// The box around it.
    pub(super) fn box3d(&self, pose: &Pose) -> Box3d {
        let position = pose.world_from_object().transform_point3(self.box_offset.extend(0.0));
        box_on_ground(&Pose { position, ..*pose }, self.size)
    }
}

/// The class of a blueprint, by CARLA's base type; of those that have none, by their wheels.
pub(super) fn class(description: &wire::ActorDescription) -> Option<ObjectClass> {
    if description.id.starts_with("walker.") {
        return Some(ObjectClass::Pedestrian);
    }
    if !description.id.starts_with("vehicle.") {
        return None;
    }
    let of_type = description.attribute("base_type").and_then(|name| name.to_ascii_lowercase().parse().ok());
    let two_wheels = description.attribute("number_of_wheels") == Some("2");
    Some(of_type.unwrap_or(if two_wheels { ObjectClass::Motorcycle } else { ObjectClass::Car }))
}

/// Our model of an actor: the one that our own server has for it, or else one of its class.
fn asset(actor: &wire::Actor, class: ObjectClass, blueprint: Option<&Blueprint>, catalogue: &Catalogue) -> AssetRef {
    let seed = u64::from(actor.id);
    match blueprint.map(|blueprint| (&blueprint.kind, blueprint)) {
        Some((BlueprintKind::Vehicle(vehicle), blueprint)) => {
            let color = blueprint.attributes(&actor.description).color("color").ok();
            vehicle.reference(catalogue, color, actor.id).into()
        }
        Some((BlueprintKind::Walker(walker), _)) => PersonRef { outfit: Outfit::Fair, seed: walker.person }.into(),
        _ if class == ObjectClass::Pedestrian => PersonRef { outfit: Outfit::Fair, seed }.into(),
        _ => {
            let specs = catalogue.vehicle_specs();
            let model = specs.iter().position(|spec| spec.class == class).unwrap_or(0);
            VehicleRef { model: endless_world::VehicleModelId::from_index(model), variant: seed }.into()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wire::{BoundingBox, Bytes, Vector3D};

    fn actor(id: &str, bounds: BoundingBox) -> wire::Actor {
        let description = wire::ActorDescription { id: id.to_owned(), ..wire::ActorDescription::default() };
        wire::Actor { id: 300, description, bounding_box: bounds, ..wire::Actor::default() }
    }

    #[test]
    fn places_are_told_there_and_back() {
        let library = BlueprintLibrary::new();
        let catalogue = Catalogue::builtin();
        let bounds = BoundingBox {
            location: Vector3D { x: 0.4, y: 0.1, z: 0.8 },
            extent: Vector3D { x: 2.0, y: 0.9, z: 0.8 },
            ..BoundingBox::default()
        };
        for id in ["vehicle.tesla.model3", "walker.pedestrian.0001"] {
            let body = ActorBody::new(&actor(id, bounds.clone()), &library, &catalogue).expect("a body");
            let pose = Pose { pitch_rad: 0.05, ..Pose::level(Vec3::new(10.0, -4.0, 1.0), 0.7) };
            let back = body.pose(&body.transform(&pose));
            assert!(back.position.distance(pose.position) < 1e-4 && (back.yaw_rad - pose.yaw_rad).abs() < 1e-5);
        }
        let person = BoundingBox { extent: Vector3D { x: 0.2, y: 0.2, z: 0.9 }, ..BoundingBox::default() };
        let body = ActorBody::new(&actor("walker.pedestrian.0001", person), &library, &catalogue).expect("a body");
        let feet = body.pose(&Transform { location: Vector3D { x: 0.0, y: 0.0, z: 1.0 }, ..Transform::default() });
        assert!((feet.position.z - 0.1).abs() < 1e-6);
        // Who holds something out to the left stands where they stood; their box reaches farther.
        let person = BoundingBox {
            location: Vector3D { x: 0.0, y: -0.3, z: 0.0 },
            extent: Vector3D { x: 0.2, y: 0.5, z: 0.9 },
            ..BoundingBox::default()
        };
        let body = ActorBody::new(&actor("walker.pedestrian.0001", person), &library, &catalogue).expect("a body");
        let pose = body.pose(&Transform { location: Vector3D { x: 5.0, y: 0.0, z: 0.9 }, ..Transform::default() });
        assert!(pose.position.distance(Vec3::new(5.0, 0.0, 0.0)) < 1e-6, "{pose:?}");
        assert!(body.box3d(&pose).centre.distance(Vec3::new(5.0, 0.3, 0.9)) < 1e-6);
        assert!(ActorBody::new(&actor("sensor.camera.rgb", BoundingBox::default()), &library, &catalogue).is_none());
    }

    #[test]
    fn two_wheelers_have_riders_where_the_server_says_so() {
        let library = BlueprintLibrary::new();
        let catalogue = Catalogue::builtin();
        let mut bike = actor("vehicle.diamondback.century", BoundingBox::default());
        let base_type = wire::ActorAttributeValue {
            id: "base_type".to_owned(),
            value: "bicycle".to_owned(),
            ..wire::ActorAttributeValue::default()
        };
        bike.description.attributes.push(base_type);
        let ridden = |bike: &wire::Actor| ActorBody::new(bike, &library, &catalogue).map(|b| (b.class, b.is_ridden));
        assert_eq!(ridden(&bike), Some((ObjectClass::Bicycle, true)));
        bike.semantic_tags = Bytes(vec![19]);
        assert_eq!(ridden(&bike), Some((ObjectClass::Bicycle, false)));
    }
}
