//! What moves, at one instant: instances to trace, bodies that shade the ground, lights that sweep it.

use super::{Body, Cast, Instance, Velocity};
use crate::accel::Accel;
use crate::light::{Beam, BeamKind};
use endless_world::{Actor, ClassTag, Motion, SignalAspect, VehicleLights, WorldState};
use glam::{Vec2, Vec3A};
use std::sync::Arc;

/// Boxes as which a large piece of something that moves is known.
const PARTS: usize = 24;

/// One actor as a volume: what its shadows, reflections and contact darkening are bounded by.
#[derive(Debug, Clone)]
pub(crate) struct MovingObject {
    /// World-space bounds of all its instances.
    pub(crate) low: Vec3A,
    pub(crate) high: Vec3A,
    /// World-space boxes, `(low, high)`, that together hold it more closely.
    pub(crate) parts: Vec<(Vec3A, Vec3A)>,
    /// Centre of the footprint, seen from above.
    pub(crate) centre: Vec2,
    /// Unit vector along the body.
    pub(crate) along: Vec2,
    /// Half extents of the footprint along and across the body.
    pub(crate) half: Vec2,
    /// Height of the surface it stands on.
    pub(crate) ground: f32,
    pub(crate) height: f32,
    /// Vehicle lights that may reach it, ascending.
    pub(crate) beams: Vec<u16>,
}

/// The moving part of the scene at one instant. Cheap to make: a millisecond or two.
pub struct FrameScene {
    pub(crate) frame: u32,
    pub(crate) instances: Vec<Instance>,
    pub(crate) accel: Accel,
    pub(crate) objects: Vec<MovingObject>,
    pub(crate) beams: Vec<Beam>,
    pub(crate) signals: Vec<SignalAspect>,
}

impl FrameScene {
    /// Poses the cast.
    pub fn new(cast: &Cast, state: &WorldState) -> Self {
        let mut instances = Vec::new();
        let mut spans = Vec::new();
        let mut beams = Vec::new();
        for actor in &state.actors {
            let first = instances.len();
            let placed = match actor.motion {
                Motion::Vehicle(_) => add_vehicle(cast, actor, &mut instances, &mut beams),
                Motion::Walker(_) => add_person(cast, actor, &mut instances),
            };
            if let Some((half, height)) = placed {
                for instance in &mut instances[first..] {
                    instance.object = spans.len() as u16;
                }
                spans.push((first..instances.len(), actor, half, height));
            }
        }
        let accel = Accel::build(instances.iter().map(Instance::placed).collect());
        let objects = spans
            .into_iter()
            .map(|(span, actor, half, height)| {
                let (mut low, mut high) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
                let mut parts = Vec::new();
                for i in span {
                    let (a, b) = accel.instance_bounds(i);
                    (low, high) = (low.min(a), high.max(b));
                    parts.extend(instances[i].parts(PARTS));
                }
                let reaches = |beam: &Beam| beam.reaches(low - 0.1, high + 0.1);
                let beams = (0u16..).zip(&beams).filter(|(_, beam)| reaches(beam)).map(|(i, _)| i).collect();
                let forward = actor.pose.world_from_object().matrix3.x_axis;
                let position = actor.pose.position;
                MovingObject {
                    low,
                    high,
                    parts,
                    centre: Vec2::new(position.x, position.y),
                    along: Vec2::new(forward.x, forward.y).normalize_or(Vec2::X),
                    half,
                    ground: position.z,
                    height,
                    beams,
                }
            })
            .collect();
        Self {
            frame: state.frame,
            instances,
            accel,
            objects,
            beams,
            signals: state.signals.iter().map(|s| s.aspect).collect(),
        }
    }

    /// Vehicle lights that may reach an instance of what moves.
    pub(crate) fn beams_on(&self, instance: &Instance) -> &[u16] {
        self.objects.get(usize::from(instance.object)).map_or(&[], |object| &object.beams)
    }
}

/// Adds a vehicle, its rider and its lights; returns the half extents of its footprint and its height.
fn add_vehicle(
    cast: &Cast,
    actor: &Actor,
    instances: &mut Vec<Instance>,
    beams: &mut Vec<Beam>,
) -> Option<(Vec2, f32)> {
    let Motion::Vehicle(motion) = actor.motion else { return None };
    let vehicle = cast.vehicle(actor.asset.model)?;
    let world_from_object = actor.pose.world_from_object();
    let first = instances.len();
    let velocity = Velocity::of(actor, vehicle.parts.wheelbase_m());
    vehicle.parts.place(instances, world_from_object, &motion, velocity);
    let tint = cast.tint(actor.asset);
    for instance in &mut instances[first..] {
        instance.id = actor.id;
        instance.class = Some(actor.class.tag());
        instance.tint = tint;
        instance.lights = motion.lights.0;
    }
    if let (Some(rider_id), Some((shape, body))) = (actor.rider_id, cast.rider(actor.asset)) {
        let mut rider = Instance::stuff(Arc::clone(shape), Arc::clone(body), world_from_object);
        rider.id = rider_id;
        rider.class = Some(ClassTag::Rider);
        rider.velocity = velocity;
        instances.push(rider);
    }
    if motion.lights.has(VehicleLights::LOW_BEAM)
        && let Some(lens) = vehicle.headlight
    {
        let forward = world_from_object.matrix3.x_axis;
        let left = world_from_object.matrix3.y_axis;
        let at = |x: f32, z: f32| world_from_object.transform_point3a(Vec3A::new(x, 0.0, z));
        let front = lens.x.max(vehicle.half_length) + 0.1;
        beams.push(Beam { kind: BeamKind::Head, position: at(front, lens.z), forward, left });
        let braking = motion.lights.has(VehicleLights::BRAKE);
        let kind = if braking { BeamKind::Brake } else { BeamKind::Tail };
        let behind = at(-vehicle.half_length - 0.1, 0.8);
        beams.push(Beam { kind, position: behind, forward: -forward, left: -left });
    }
    Some((Vec2::new(vehicle.extent.x, vehicle.extent.y), vehicle.extent.z))
}

/// Adds a person in their pose; returns the half extents of their footprint and their height.
fn add_person(cast: &Cast, actor: &Actor, instances: &mut Vec<Instance>) -> Option<(Vec2, f32)> {
    let Motion::Walker(motion) = actor.motion else { return None };
    let person = cast.person(actor.asset)?;
    let pose = person.model.pose(&motion);
    let mut blas = (*person.rest.blas).clone();
    blas.refit(&pose.positions);
    let body = Body { positions: pose.positions, normals: pose.normals, blas: Arc::new(blas) };
    let mut instance = Instance::stuff(Arc::clone(&person.shape), Arc::new(body), actor.pose.world_from_object());
    instance.id = actor.id;
    instance.class = Some(actor.class.tag());
    instance.velocity = Velocity::of(actor, 0.0);
    instances.push(instance);
    Some((Vec2::new(0.2, 0.22), person.model.height_m))
}
