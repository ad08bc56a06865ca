//! A server's traffic lights, shown as our traffic's signals are.

use super::error::ClientError;
use super::world::World;
use crate::frames;
use crate::wire::{Actor, Transform};
use endless_road::{RoadNetwork, TrafficControl};
use endless_world::{SignalAspect, SignalId, SignalState};
use glam::{Mat3, Quat, Vec3};

/// A light governs the lanes that end this near to its box, metres.
const NEAR_M: f32 = 9.0;

/// Lights and the signals that they show.
#[derive(Default)]
pub(super) struct TrafficLights {
    lights: Vec<(u32, SignalId)>,
    /// By light.
    shown: Vec<Option<u8>>,
}

impl TrafficLights {
    /// Finds the lights that stand where the signals of a network hold traffic up.
    pub(super) fn new(lights: &[(Actor, Transform)], network: &RoadNetwork) -> Self {
        let ends: Vec<(Vec3, SignalId)> = network
            .lanes
            .iter()
            .filter_map(|lane| match lane.end_control {
                TrafficControl::Signal(signal) => {
                    Some((lane.centerline.position(lane.centerline.length()).as_vec3(), signal))
                }
                _ => None,
            })
            .collect();
        let nearest = |(actor, transform): &(Actor, Transform)| {
            let near = |(at, signal): &(Vec3, SignalId)| (beside(actor, transform, *at), *signal);
            let (apart, signal) = ends.iter().map(near).min_by(|a, b| a.0.total_cmp(&b.0))?;
            (apart < NEAR_M).then_some((actor.id, signal))
        };
        let lights: Vec<_> = lights.iter().filter_map(nearest).collect();
        Self { shown: vec![None; lights.len()], lights }
    }

    /// Shows signals, and stays so until the next call.
    pub(super) fn show(&mut self, world: &mut World, signals: &[SignalState]) -> Result<(), ClientError> {
        for ((light, signal), shown) in self.lights.iter().zip(&mut self.shown) {
            let Some(state) = signals.get(usize::from(signal.0)).map(|state| number(state.aspect)) else { continue };
            if *shown == Some(state) {
                continue;
            }
            if shown.is_none() {
                world.freeze_traffic_light(*light, true)?;
            }
            world.set_traffic_light(*light, state)?;
            *shown = Some(state);
        }
        Ok(())
    }

    /// Lets the server's lights go on as they do by themselves.
    pub(super) fn release(&mut self, world: &mut World) -> Result<(), ClientError> {
        for ((light, _), shown) in self.lights.iter().zip(&mut self.shown) {
            if shown.take().is_some() {
                world.freeze_traffic_light(*light, false)?;
            }
        }
        Ok(())
    }

    /// How many lights are governed.
    pub(super) fn len(&self) -> usize {
        self.lights.len()
    }
}

/// How far a place is from the box in which a light holds vehicles up, metres; up and down does not count.
fn beside(actor: &Actor, transform: &Transform, at: Vec3) -> f32 {
    let to_box = frames::attached(
        transform,
        &Transform { location: actor.bounding_box.location.clone(), rotation: actor.bounding_box.rotation.clone() },
    );
    let axes = Mat3::from_quat(Quat::from_rotation_z(frames::pose(&to_box).yaw_rad));
    let own = axes.transpose() * (at - frames::from_carla(&to_box.location));
    let half = &actor.bounding_box.extent;
    Vec3::new((own.x.abs() - half.x).max(0.0), (own.y.abs() - half.y).max(0.0), 0.0).length()
}

/// CARLA's number of what is shown.
fn number(aspect: SignalAspect) -> u8 {
    match aspect {
        SignalAspect::Red | SignalAspect::RedYellow => 0,
        SignalAspect::Yellow => 1,
        SignalAspect::Green => 2,
    }
}
