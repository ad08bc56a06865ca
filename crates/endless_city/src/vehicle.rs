//! A vehicle's geometry: body, wheels, and trailer.

use crate::velocity;
use endless_asset::{Trailer, VehicleModel, Wheel};
use endless_render::{Geometry, Instance, RigidVelocity};
use endless_world::{VehicleMotion, math};
use glam::{Affine3A, Mat3A, Vec3, Vec3A};
use std::sync::Arc;

/// The rigid pieces of a vehicle model, which all vehicles of this model share.
#[derive(Debug, Clone)]
pub(crate) struct VehicleGeometry {
    towing: AxledGeometry,
    pub(crate) trailer: Option<TrailerGeometry>,
    wheel: Geometry,
    wheel_radius_m: f32,
}

/// A rigid body on wheels.
#[derive(Debug, Clone)]
struct AxledGeometry {
    body: Geometry,
    wheels: Vec<Wheel>,
}

/// What a vehicle draws.
#[derive(Debug, Clone)]
pub(crate) struct TrailerGeometry {
    drawn: AxledGeometry,
    hitch: Vec3A,
    /// From the hitch to the axle, metres.
    drawbar_m: f32,
    /// Smallest and largest corner, straight on.
    pub(crate) low: Vec3,
    pub(crate) high: Vec3,
}

impl TrailerGeometry {
    fn new(entry: &VehicleModel, trailer: &Trailer) -> Option<Self> {
        let spec = entry.spec.trailer?;
        let (low, high) = trailer.body.bounds();
        let body = Geometry::rigid(Arc::clone(&trailer.body));
        Some(Self {
            drawn: AxledGeometry { body, wheels: trailer.wheels.clone() },
            hitch: Vec3A::from(trailer.hitch),
            drawbar_m: (spec.hitch_m - spec.axle_m).max(0.5),
            low,
            high,
        })
    }

    /// Where it stands: turned about the hitch.
    pub(crate) fn object_from_straight(&self, hitch_rad: f32) -> Affine3A {
        let turn = Mat3A::from_rotation_z(hitch_rad);
        Affine3A { matrix3: turn, translation: self.hitch - turn * self.hitch }
    }
}

/// Instances of a vehicle's pieces.
pub(crate) struct PlacedVehicle {
    pub(crate) towing: Vec<Instance>,
    pub(crate) trailer: Vec<Instance>,
}

impl VehicleGeometry {
    pub(crate) fn new(entry: &VehicleModel) -> Self {
        Self {
            towing: AxledGeometry { body: Geometry::rigid(Arc::clone(entry.body())), wheels: entry.wheels().to_vec() },
            trailer: entry.trailer().and_then(|trailer| TrailerGeometry::new(entry, trailer)),
            wheel: Geometry::rigid(Arc::clone(entry.wheel_mesh())),
            wheel_radius_m: entry.spec.wheel_radius_m,
        }
    }

    /// With the ambient occlusion of vehicles that move; the vehicle without a trailer lies between these corners.
    pub(crate) fn with_ambient_occlusion(mut self, low: Vec3, high: Vec3) -> Self {
        self.towing.body = self.towing.body.with_ambient_occlusion(low, high);
        self.wheel = self.wheel.with_ambient_occlusion(low, high);
        if let Some(trailer) = &mut self.trailer {
            trailer.drawn.body = trailer.drawn.body.clone().with_ambient_occlusion(trailer.low, trailer.high);
        }
        self
    }

    /// Distance between the axles that are farthest apart.
    pub(crate) fn wheelbase_m(&self) -> f32 {
        let along = || self.towing.wheels.iter().map(|w| w.position.x);
        (along().fold(f32::MIN, f32::max) - along().fold(f32::MAX, f32::min)).max(0.0)
    }

    /// The body and its wheels, rolled and steered, and behind them what it draws.
    pub(crate) fn place(
        &self,
        world_from_object: Affine3A,
        motion: &VehicleMotion,
        velocity: RigidVelocity,
    ) -> PlacedVehicle {
        let towing = self.place_axled(&self.towing, world_from_object, motion, velocity);
        let trailer = self.trailer.as_ref().map(|trailer| {
            let world_from_trailer = world_from_object * trailer.object_from_straight(motion.hitch_rad);
            let hitch = world_from_object.transform_point3a(trailer.hitch);
            let turn_radps = -motion.speed_mps * math::sin(motion.hitch_rad) / trailer.drawbar_m;
            let velocity = velocity::of_trailer(velocity, hitch, turn_radps);
            self.place_axled(&trailer.drawn, world_from_trailer, motion, velocity)
        });
        PlacedVehicle { towing, trailer: trailer.unwrap_or_default() }
    }

    fn place_axled(
        &self,
        piece: &AxledGeometry,
        world_from_object: Affine3A,
        &VehicleMotion { speed_mps, rolled_m, steer_rad, .. }: &VehicleMotion,
        velocity: RigidVelocity,
    ) -> Vec<Instance> {
        let body = Instance::new(&piece.body, world_from_object).with_velocity(velocity);
        let wheels = piece.wheels.iter().map(|wheel| {
            let steer = if wheel.steered { steer_rad } else { 0.0 };
            let radius = self.wheel_radius_m.max(0.05);
            let roll = rolled_m / radius;
            let mirror = if wheel.mirrored { -1.0 } else { 1.0 };
            let turned = Mat3A::from_rotation_z(steer)
                * Mat3A::from_rotation_y(roll)
                * Mat3A::from_diagonal(Vec3::new(1.0, mirror, 1.0));
            let object_from_wheel = Affine3A { matrix3: turned, translation: Vec3A::from(wheel.position) };
            let hub = world_from_object.transform_point3a(Vec3A::from(wheel.position));
            let axle = world_from_object.transform_vector3a(Mat3A::from_rotation_z(steer) * Vec3A::Y);
            Instance::new(&self.wheel, world_from_object * object_from_wheel).with_velocity(velocity::of_wheel(
                velocity,
                hub,
                axle,
                speed_mps / radius,
            ))
        });
        std::iter::once(body).chain(wheels).collect()
    }
}
