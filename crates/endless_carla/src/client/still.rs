//! Vehicles and people that are part of a map: a server paints them and does not list them among its actors.

use super::boxes::{box_on_ground, holds};
use crate::frames;
use crate::wire::EnvironmentObject;
use endless_world::{
    Actor, AssetRef, Behaviour, ClassTag, InstanceId, Motion, ObjectClass, Outfit, ParkedVehicle, PersonRef, Pose,
    VehicleModelId, VehicleMotion, VehicleRef, VehicleSpec, WalkerMotion,
};
use glam::Vec3;

/// Classes of CARLA's that such objects have.
pub(super) const LABELS: [ClassTag; 5] =
    [ClassTag::Car, ClassTag::Truck, ClassTag::Bus, ClassTag::Motorcycle, ClassTag::Bicycle];

/// Objects of a map, as its server lists them.
#[derive(Debug, Clone, Default)]
pub(super) struct StillObjects(Vec<StillObject>);

#[derive(Debug, Clone)]
struct StillObject {
    pose: Pose,
    size: Vec3,
}

impl StillObjects {
    /// Of what a server lists.
    pub(super) fn new(objects: &[EnvironmentObject]) -> Self {
        let of = |object: &EnvironmentObject| {
            let bounds = &object.bounding_box;
            let half = Vec3::new(bounds.extent.x, bounds.extent.y, bounds.extent.z).abs();
            let centre = frames::from_carla(&bounds.location);
            let turned = frames::pose(&crate::wire::Transform {
                location: bounds.location.clone(),
                rotation: bounds.rotation.clone(),
            });
            StillObject { pose: Pose { position: centre - Vec3::Z * half.z, ..turned }, size: 2.0 * half }
        };
        Self(objects.iter().map(of).collect())
    }

    /// How many.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// As traffic keeps clear of them: models of a fleet that are about as long.
    pub(super) fn parked(&self, fleet: &[VehicleSpec]) -> Vec<ParkedVehicle> {
        let like = |object: &StillObject| {
            let unlike =
                |spec: &VehicleSpec| (spec.length_m - object.size.x).abs() + (spec.width_m - object.size.y).abs();
            let model = (0..fleet.len()).min_by(|&a, &b| unlike(&fleet[a]).total_cmp(&unlike(&fleet[b])))?;
            let vehicle = VehicleRef { model: VehicleModelId::from_index(model), variant: 0 };
            Some(ParkedVehicle { vehicle, pose: object.pose })
        };
        self.0.iter().filter_map(like).collect()
    }

    /// What is seen at these places, and its size: the object of the list that holds most of them, or else what they span.
    pub(super) fn describe(&self, label: u8, id: InstanceId, points: &[Vec3]) -> (Actor, Vec3) {
        const BESIDE: Vec3 = Vec3::splat(0.4);
        let within = |object: &StillObject| {
            let around = box_on_ground(&object.pose, object.size);
            points.iter().filter(|point| holds(&around, **point, BESIDE)).count()
        };
        let best = self.0.iter().map(|object| (within(object), object)).max_by_key(|(count, _)| *count);
        let (pose, size) = match best {
            Some((count, object)) if 2 * count >= points.len() && count > 0 => (object.pose, object.size),
            _ => span(points),
        };
        (still(class(label), id, pose), size)
    }
}

/// Of what is seen of something.
fn span(points: &[Vec3]) -> (Pose, Vec3) {
    let first = points.first().copied().unwrap_or_default();
    let (low, high) = points.iter().fold((first, first), |(low, high), point| (low.min(*point), high.max(*point)));
    let middle = 0.5 * (low + high);
    (Pose::level(middle.truncate().extend(low.z), 0.0), high - low)
}

fn class(label: u8) -> ObjectClass {
    match ClassTag::from_value(label) {
        Some(ClassTag::Truck) => ObjectClass::Truck,
        Some(ClassTag::Bus) => ObjectClass::Bus,
        Some(ClassTag::Motorcycle) => ObjectClass::Motorcycle,
        Some(ClassTag::Bicycle) => ObjectClass::Bicycle,
        Some(ClassTag::Pedestrians | ClassTag::Rider) => ObjectClass::Pedestrian,
        _ => ObjectClass::Car,
    }
}

fn still(class: ObjectClass, id: InstanceId, pose: Pose) -> Actor {
    let person = class == ObjectClass::Pedestrian;
    let asset: AssetRef = if person {
        PersonRef { outfit: Outfit::Fair, seed: 0 }.into()
    } else {
        VehicleRef { model: VehicleModelId(0), variant: 0 }.into()
    };
    let motion =
        if person { Motion::Walker(WalkerMotion::default()) } else { Motion::Vehicle(VehicleMotion::default()) };
    Actor {
        id,
        rider_id: None,
        class,
        asset,
        pose,
        velocity_mps: Vec3::ZERO,
        motion,
        behaviour: Behaviour::default(),
        parked: true,
    }
}
