//! What moves, at one instant: instances to trace, bodies that shade the ground, lights that sweep it.

use super::{Body, Cast, Instance, Velocity};
use crate::accel::Accel;
use crate::light::{Beam, BeamKind};
use endless_world::{Actor, ClassTag, Motion, SignalAspect, VehicleLights, WorldState};
use glam::{Affine3A, Mat3A, Vec2, Vec3A};
use rayon::prelude::*;
use std::sync::Arc;

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
        // People are posed by all threads.
        let posed: Vec<Option<Arc<Body>>> = state.actors.par_iter().map(|actor| posed(cast, actor)).collect();
        for (actor, body) in state.actors.iter().zip(posed) {
            let first = instances.len();
            let pieces = match actor.motion {
                Motion::Vehicle(_) => add_vehicle(cast, actor, &mut instances, &mut beams),
                Motion::Walker(_) => add_person(cast, actor, body, &mut instances),
            };
            let mut from = first;
            for piece in pieces {
                let until = piece.until;
                for instance in &mut instances[from..until] {
                    instance.object = spans.len() as u16;
                }
                spans.push((from..until, piece));
                from = until;
            }
        }
        let accel = Accel::build(instances.iter().map(Instance::placed).collect());
        let objects = spans
            .into_par_iter()
            .map(|(span, piece)| {
                let (mut low, mut high) = (Vec3A::INFINITY, Vec3A::NEG_INFINITY);
                let mut parts = Vec::new();
                for i in span {
                    let (a, b) = accel.instance_bounds(i);
                    (low, high) = (low.min(a), high.max(b));
                    parts.extend(instances[i].parts());
                }
                let reaches = |beam: &Beam| beam.reaches(low - 0.1, high + 0.1);
                let beams = (0u16..).zip(&beams).filter(|(_, beam)| reaches(beam)).map(|(i, _)| i).collect();
                let forward = piece.world_from_piece.matrix3.x_axis;
                let foot = piece.world_from_piece.transform_point3a(Vec3A::X * piece.ahead);
                MovingObject {
                    low,
                    high,
                    parts,
                    centre: Vec2::new(foot.x, foot.y),
                    along: Vec2::new(forward.x, forward.y).normalize_or(Vec2::X),
                    half: piece.half,
                    ground: foot.z,
                    height: piece.height,
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

/// A rigid part of an actor, with the end of its instances.
struct Piece {
    until: usize,
    world_from_piece: Affine3A,
    /// Middle of its footprint ahead of the origin, metres.
    ahead: f32,
    /// Half extents of its footprint.
    half: Vec2,
    height: f32,
}

/// Adds a vehicle, its rider and its lights, and what it draws; returns its pieces.
fn add_vehicle(cast: &Cast, actor: &Actor, instances: &mut Vec<Instance>, beams: &mut Vec<Beam>) -> Vec<Piece> {
    let Motion::Vehicle(motion) = actor.motion else { return vec![] };
    let Some(named) = actor.asset.vehicle() else { return vec![] };
    let Some(vehicle) = cast.vehicle(named.model) else { return vec![] };
    let world_from_object = actor.pose.world_from_object();
    let first = instances.len();
    let velocity = Velocity::of(actor, vehicle.parts.wheelbase_m());
    let own = first + vehicle.parts.place(instances, world_from_object, &motion, velocity);
    let tint = cast.tint(named);
    for instance in &mut instances[first..] {
        instance.id = actor.id;
        instance.class = Some(actor.class.tag());
        instance.tint = tint;
        instance.lights = motion.lights.0;
    }
    let trailer = vehicle.parts.trailer.as_ref();
    let last = trailer.map_or(world_from_object, |t| world_from_object * t.object_from_straight(motion.hitch_rad));
    if let (Some(rider_id), Some((shape, body))) = (actor.rider_id, cast.rider(named)) {
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
        let behind = last.transform_point3a(Vec3A::new(-vehicle.half_length - 0.1, 0.0, 0.8));
        let Mat3A { x_axis, y_axis, .. } = last.matrix3;
        beams.push(Beam { kind, position: behind, forward: -x_axis, left: -y_axis });
    }
    let (extent, until) = (vehicle.extent, instances.len());
    let piece = |until: usize, world_from_piece: Affine3A, rear: f32, front: f32| Piece {
        until,
        world_from_piece,
        ahead: 0.5 * (rear + front),
        half: Vec2::new(0.5 * (front - rear), extent.y),
        height: extent.z,
    };
    match trailer {
        None => vec![piece(until, world_from_object, -extent.x, extent.x)],
        Some(t) => {
            let towing_rear = vehicle.towing_rear.max(-extent.x);
            vec![piece(own, world_from_object, towing_rear, extent.x), piece(until, last, -extent.x, t.high.x)]
        }
    }
}

/// The body of a person on foot as it stands.
fn posed(cast: &Cast, actor: &Actor) -> Option<Arc<Body>> {
    let Motion::Walker(motion) = &actor.motion else { return None };
    Some(cast.person(actor.asset.person()?)?.posed(motion))
}

/// Adds a person in their pose.
fn add_person(cast: &Cast, actor: &Actor, body: Option<Arc<Body>>, instances: &mut Vec<Instance>) -> Vec<Piece> {
    let (Some(person), Some(body)) = (actor.asset.person().and_then(|p| cast.person(p)), body) else { return vec![] };
    let mut instance = Instance::stuff(Arc::clone(&person.shape), body, actor.pose.world_from_object());
    instance.id = actor.id;
    instance.class = Some(actor.class.tag());
    instance.velocity = Velocity::of(actor, 0.0);
    instances.push(instance);
    vec![Piece {
        until: instances.len(),
        world_from_piece: actor.pose.world_from_object(),
        ahead: 0.0,
        half: Vec2::new(0.2, 0.22),
        height: person.model.height_m,
    }]
}
