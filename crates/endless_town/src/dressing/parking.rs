//! Vehicles parked in the strips along streets.

use super::dresser::Dresser;
use crate::plot::Rect;
use crate::surface;
use endless_world::{CameraSite, ParkedVehicle, Pose, VehicleModelId, VehicleRef};
use glam::{DVec2, Vec3};
use std::f64::consts::PI;

/// Most vehicles parked along the streets of a town.
const MOST: usize = 160;

pub(crate) fn add_parked(dresser: &mut Dresser<'_>) {
    let models = dresser.catalogue.vehicles();
    let weights: Vec<f64> = models.iter().map(|m| if m.spec.parks { m.spec.frequency } else { 0.0 }).collect();
    if weights.iter().sum::<f64>() <= 0.0 {
        return;
    }
    let plan = dresser.plan;
    for (i, street) in plan.streets.iter().enumerate() {
        let mut stream = dresser.stream(4000 + i as u64);
        let profile = &street.profile;
        for s in surface::bays(street) {
            for side in [1.0, -1.0] {
                let model = stream.weighted(&weights);
                let (along, across) = (stream.normal() * 0.12, stream.normal() * 0.035);
                let turn = stream.normal() * 0.018;
                let variant = stream.next_u64();
                let spec = &models[model].spec;
                if !stream.chance(dresser.character.parked) || f64::from(spec.length_m) > surface::BAY_M - 0.4 {
                    continue;
                }
                let s = s + along.clamp(-0.3, 0.3);
                // Close to the kerb, as people park.
                let t = side * (profile.kerb() - 0.32 - f64::from(spec.width_m) / 2.0 + across.clamp(-0.08, 0.08));
                let at = street.point(s, t);
                let yaw = street.heading(s) + if side > 0.0 { PI } else { 0.0 } + turn.clamp(-0.035, 0.035);
                let half = DVec2::new(f64::from(spec.length_m), f64::from(spec.width_m)) / 2.0;
                if dresser.occupied.try_take(Rect::new(at, half.map(|h| h + 0.05), yaw)) {
                    let vehicle = VehicleRef { model: VehicleModelId::from_index(model), variant };
                    let pose = Pose::level(at.extend(0.0).as_vec3(), yaw as f32);
                    dresser.parked.push(ParkedVehicle { vehicle, pose });
                }
            }
        }
    }
}

/// Keeps the vehicles parked nearest to cameras: no others are ever seen large.
pub(crate) fn keep_the_seen(parked: &mut Vec<ParkedVehicle>, sites: &[CameraSite]) {
    let far = |p: &ParkedVehicle| {
        let of = |s: &CameraSite| Vec3::from_array(s.position).distance(p.pose.position);
        sites.iter().map(of).fold(f32::INFINITY, f32::min)
    };
    parked.sort_by(|a, b| far(a).total_cmp(&far(b)));
    parked.truncate(MOST);
}
