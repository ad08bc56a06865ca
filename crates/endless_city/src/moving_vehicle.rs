//! A vehicle model that moves: its geometry, its lights and the ground that it covers.

use crate::vehicle::VehicleGeometry;
use endless_asset::Catalogue;
use endless_render::{BeamKind, Footprint, VehicleBeam};
use endless_world::{VehicleLights, VehicleModelId};
use glam::{Affine3A, Mat3A, Vec2, Vec3, Vec3A};

/// A vehicle model that moves.
#[derive(Debug, Clone)]
pub(crate) struct MovingVehicle {
    pub(crate) geometry: VehicleGeometry,
    /// Half length, half width, height.
    pub(crate) extent: Vec3A,
    /// Mid-point between the headlights, in the object frame; `None` without headlights.
    headlight: Option<Vec3A>,
    /// x of the rearmost point of the piece that steers.
    pub(crate) towing_rear: f32,
}

impl MovingVehicle {
    pub(crate) fn new(catalogue: &Catalogue, model: VehicleModelId, parked: VehicleGeometry) -> Option<Self> {
        let entry = catalogue.vehicle(model)?;
        let extent = Vec3A::new(entry.spec.length_m / 2.0, entry.spec.width_m / 2.0, entry.spec.height_m);
        let low = Vec3::new(-extent.x, -extent.y, 0.0);
        let geometry = parked.with_ambient_occlusion(low, extent.into());
        let lenses = entry.headlights();
        let headlight =
            (!lenses.is_empty()).then(|| lenses.iter().map(|&p| Vec3A::from(p)).sum::<Vec3A>() / lenses.len() as f32);
        let towing_rear = entry.spec.trailer.map_or(-extent.x, |t| t.towing_rear_m);
        Some(Self { geometry, extent, headlight, towing_rear })
    }

    /// Headlights in front, and the red glow behind the last piece.
    pub(crate) fn beams(
        &self,
        lights: VehicleLights,
        world_from_object: Affine3A,
        world_from_last: Affine3A,
    ) -> impl Iterator<Item = VehicleBeam> {
        let lens = self.headlight.filter(|_| lights.contains(VehicleLights::LOW_BEAM));
        let half_length = self.extent.x;
        let pair = lens.map(|lens| {
            let Mat3A { x_axis, y_axis, .. } = world_from_object.matrix3;
            let front = Vec3A::new(lens.x.max(half_length) + 0.1, 0.0, lens.z);
            let position = world_from_object.transform_point3a(front);
            let head = VehicleBeam { kind: BeamKind::Head, position, forward: x_axis, left: y_axis };
            let braking = lights.contains(VehicleLights::BRAKE);
            let kind = if braking { BeamKind::Brake } else { BeamKind::Tail };
            let Mat3A { x_axis, y_axis, .. } = world_from_last.matrix3;
            let position = world_from_last.transform_point3a(Vec3A::new(-half_length - 0.1, 0.0, 0.8));
            [head, VehicleBeam { kind, position, forward: -x_axis, left: -y_axis }]
        });
        pair.into_iter().flatten()
    }

    /// Of the piece between two places along its object frame.
    pub(crate) fn footprint(&self, world_from_object: Affine3A, rear: f32, front: f32) -> Footprint {
        Footprint {
            world_from_object,
            ahead_m: 0.5 * (rear + front),
            half_m: Vec2::new(0.5 * (front - rear), self.extent.y),
            height_m: self.extent.z,
        }
    }
}
