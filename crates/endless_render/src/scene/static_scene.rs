//! The town as it stands: everything that is the same in every frame of every video on this map.

use super::{Body, Instance, Shape, Velocity, model::model};
use crate::accel::{Accel, Use};
use crate::light::Lamps;
use endless_asset::{Catalogue, VehicleModel};
use endless_town::{Town, What};
use endless_world::{InstanceId, VehicleModelId, VehicleMotion, math};
use glam::{Affine3A, Mat3A, Vec3A};
use rayon::prelude::*;
use std::{
    collections::{BTreeMap, BTreeSet},
    sync::Arc,
};

/// A town ready to be traced. Load it once a map.
pub struct StaticScene {
    pub(crate) instances: Vec<Instance>,
    pub(crate) accel: Accel,
    pub(crate) lamps: Lamps,
    /// Models of the parked vehicles: the same may drive by.
    pub(super) parked: BTreeMap<VehicleModelId, VehicleParts>,
}

impl StaticScene {
    /// Builds the town's meshes, props and parked vehicles (number i gets instance id i + 1).
    pub fn load(town: &Town, catalogue: &Catalogue) -> Self {
        type Model = Option<Part>;
        type Models = BTreeMap<What, Model>;
        type Parked = BTreeMap<VehicleModelId, VehicleParts>;
        let placed = town.placements.iter().map(|placement| placement.what);
        let used: BTreeSet<What> = placed.filter(|what| matches!(what, What::Prop(..))).collect();
        let made = |what: What| match what {
            What::Prop(prop, variant) => (what, model(catalogue.prop(prop, variant).into(), Use::Still)),
            What::Own(_) => (what, None),
        };
        let parked: BTreeSet<VehicleModelId> = town.parked.iter().map(|p| p.vehicle.model).collect();
        let parts = |model| Some((model, VehicleParts::new(catalogue.vehicle(model)?)));
        // Large meshes and small ones side by side, so that no thread waits for another.
        let (own, (props, vehicles)): (Vec<Model>, (Models, Parked)) = rayon::join(
            || town.meshes.par_iter().map(|mesh| model(Arc::clone(mesh), Use::Still)).collect(),
            || {
                rayon::join(
                    || used.into_par_iter().map(made).collect(),
                    || parked.into_par_iter().filter_map(parts).collect(),
                )
            },
        );
        let mut instances = Vec::new();
        for placement in &town.placements {
            let found = match placement.what {
                What::Own(i) => own.get(i as usize).cloned().flatten(),
                What::Prop(..) => props.get(&placement.what).cloned().flatten(),
            };
            if let Some((shape, body)) = found {
                let mut instance = Instance::stuff(shape, body, placement.world_from_object);
                instance.signal = placement.signal;
                instances.push(instance);
            }
        }
        for (i, parked) in town.parked.iter().enumerate() {
            let Some(entry) = catalogue.vehicle(parked.vehicle.model) else { continue };
            let Some(parts) = vehicles.get(&parked.vehicle.model) else { continue };
            let first = instances.len();
            parts.place(&mut instances, parked.pose.world_from_object(), &VehicleMotion::default(), Velocity::ZERO);
            let tint = Vec3A::from_array(entry.tint(parked.vehicle.variant));
            let id = InstanceId(u16::try_from(i + 1).unwrap_or(u16::MAX));
            for instance in &mut instances[first..] {
                instance.id = id;
                instance.class = Some(entry.spec.class.tag());
                instance.tint = tint;
            }
        }
        let accel = Accel::build(instances.iter().map(Instance::placed).collect());
        Self { instances, accel, lamps: Lamps::new(&town.lamps), parked: vehicles }
    }

    /// Number of triangles as placed, for reports.
    pub fn placed_triangles(&self) -> usize {
        self.instances.iter().map(|i| i.shape.mesh.triangles.len()).sum()
    }
}

/// A mesh that instances share.
type Part = (Arc<Shape>, Arc<Body>);

/// A vehicle's body and wheels.
#[derive(Debug, Clone)]
pub(crate) struct VehicleParts {
    pub(crate) body: Option<Part>,
    pub(crate) wheel: Option<Part>,
    pub(crate) trailer: Option<TrailerParts>,
    wheels: Vec<endless_asset::Wheel>,
    wheel_radius_m: f32,
}

/// What a vehicle draws.
#[derive(Debug, Clone)]
pub(crate) struct TrailerParts {
    pub(crate) body: Option<Part>,
    wheels: Vec<endless_asset::Wheel>,
    hitch: Vec3A,
    /// From the hitch to the axle, metres.
    bar_m: f32,
    /// Smallest and largest corner, straight on.
    pub(crate) low: Vec3A,
    pub(crate) high: Vec3A,
}

impl TrailerParts {
    fn of(entry: &VehicleModel) -> Option<Self> {
        let (trailer, spec) = (entry.trailer()?, entry.spec.trailer?);
        let (low, high) = trailer.body.bounds();
        Some(Self {
            body: model(Arc::clone(&trailer.body), Use::Rigid),
            wheels: trailer.wheels.clone(),
            hitch: Vec3A::from(trailer.hitch),
            bar_m: (spec.hitch_m - spec.axle_m).max(0.5),
            low: Vec3A::from(low),
            high: Vec3A::from(high),
        })
    }

    /// Where it stands: turned about the hitch.
    pub(crate) fn object_from_straight(&self, hitch_rad: f32) -> Affine3A {
        let turn = Mat3A::from_rotation_z(hitch_rad);
        Affine3A { matrix3: turn, translation: self.hitch - turn * self.hitch }
    }
}

impl VehicleParts {
    pub(crate) fn new(entry: &VehicleModel) -> Self {
        Self {
            body: model(Arc::clone(entry.body()), Use::Rigid),
            wheel: model(Arc::clone(entry.wheel_mesh()), Use::Rigid),
            trailer: TrailerParts::of(entry),
            wheels: entry.wheels().to_vec(),
            wheel_radius_m: entry.spec.wheel_radius_m,
        }
    }

    /// Distance between the axles that are farthest apart.
    pub(crate) fn wheelbase_m(&self) -> f32 {
        let along = || self.wheels.iter().map(|w| w.position.x);
        (along().fold(f32::MIN, f32::max) - along().fold(f32::MAX, f32::min)).max(0.0)
    }

    /// Adds the body and its wheels, rolled and steered, and behind them what it draws; returns how many instances
    /// are its own.
    pub(crate) fn place(
        &self,
        to: &mut Vec<Instance>,
        world_from_object: Affine3A,
        motion: &VehicleMotion,
        velocity: Velocity,
    ) -> usize {
        let begin = to.len();
        self.place_piece(to, (&self.body, &self.wheels), world_from_object, motion, velocity);
        let own = to.len() - begin;
        if let Some(trailer) = &self.trailer {
            let world_from_trailer = world_from_object * trailer.object_from_straight(motion.hitch_rad);
            let hitch = world_from_object.transform_point3a(trailer.hitch);
            let turn = -motion.speed_mps * math::sin(motion.hitch_rad) / trailer.bar_m;
            let velocity = velocity.of_drawn(hitch, turn);
            self.place_piece(to, (&trailer.body, &trailer.wheels), world_from_trailer, motion, velocity);
        }
        own
    }

    fn place_piece(
        &self,
        to: &mut Vec<Instance>,
        (body, wheels): (&Option<Part>, &[endless_asset::Wheel]),
        world_from_object: Affine3A,
        &VehicleMotion { speed_mps, rolled_m, steer_rad, .. }: &VehicleMotion,
        velocity: Velocity,
    ) {
        if let Some((shape, body)) = body {
            let still = Instance::stuff(Arc::clone(shape), Arc::clone(body), world_from_object);
            to.push(Instance { velocity, ..still });
        }
        let Some((shape, body)) = &self.wheel else { return };
        for wheel in wheels {
            let steer = if wheel.steered { steer_rad } else { 0.0 };
            let radius = self.wheel_radius_m.max(0.05);
            let roll = rolled_m / radius;
            let mirror = if wheel.mirrored { -1.0 } else { 1.0 };
            let turned = Mat3A::from_rotation_z(steer)
                * Mat3A::from_rotation_y(roll)
                * Mat3A::from_diagonal(glam::Vec3::new(1.0, mirror, 1.0));
            let object_from_wheel = Affine3A { matrix3: turned, translation: Vec3A::from(wheel.position) };
            let still = Instance::stuff(Arc::clone(shape), Arc::clone(body), world_from_object * object_from_wheel);
            let hub = world_from_object.transform_point3a(Vec3A::from(wheel.position));
            let axle = world_from_object.transform_vector3a(Mat3A::from_rotation_z(steer) * Vec3A::Y);
            to.push(Instance { velocity: velocity.of_wheel(hub, axle, speed_mps / radius), ..still });
        }
    }
}
