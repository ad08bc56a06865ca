//! What rays meet: `cast_ray`, `project_point`, and the client's own `ground_projection`.

use crate::frames;
use crate::rpc::Answer;
use crate::server::call::{Call, CallResult, Method};
use crate::server::call_error::CallError;
use crate::server::world::World;
use crate::wire::{LabelledPoint, Location, Vector3D, Wire};
use endless_render::{Ray, RayCaster};
use glam::{Vec3, Vec3A};
use rmpv::Value;

pub(super) const METHODS: &[(&str, Method)] = &[("cast_ray", cast_ray), ("project_point", project_point)];

/// Most surfaces of one ray.
const MOST: usize = 1000;
/// Behind a surface the ray goes on from here, metres.
const BEHIND_M: f32 = 1e-3;

/// All surfaces between two places.
fn cast_ray(world: &mut World, call: &Call<'_>) -> CallResult {
    let (from, to): (Location, Location) = (call.request.argument(0)?, call.request.argument(1)?);
    let (from, to) = (frames::from_carla(&from), frames::from_carla(&to));
    Ok(Answer::of(&met(world, from, to - from, (to - from).length(), MOST)?))
}

/// The first surface from a place in a direction, within a distance.
fn project_point(world: &mut World, call: &Call<'_>) -> CallResult {
    let (from, direction, distance): (Location, Vector3D, f32) =
        (call.request.argument(0)?, call.request.argument(1)?, call.request.argument(2)?);
    let first = met(world, frames::from_carla(&from), frames::from_carla(&direction), distance, 1)?.pop();
    let found = Value::Boolean(first.is_some());
    Ok(Answer::Value(Value::Array(vec![found, first.unwrap_or_default().to_value()])))
}

/// The first surfaces along a ray, so many at most.
fn met(
    world: &mut World,
    from: Vec3,
    direction: Vec3,
    distance: f32,
    most: usize,
) -> Result<Vec<LabelledPoint>, CallError> {
    let Some(direction) = direction.try_normalize().filter(|_| from.is_finite() && distance.is_finite()) else {
        return Err(CallError::refused("a ray needs a place, a direction and a length that are numbers"));
    };
    world.episode.show_scenery(world.shelf.catalogue());
    let frame = world.sensing.scene(&world.episode, world.shelf.catalogue());
    let caster = RayCaster::new(world.episode.map.scene.static_scene(), &frame);
    let (mut points, mut gone) = (Vec::new(), 0.0);
    while points.len() < most && gone < distance {
        let origin = Vec3A::from(from + direction * gone);
        let ray = Ray { origin, direction: direction.into(), tmax: distance - gone };
        let Some(hit) = caster.closest(&ray) else { break };
        let place = Vec3::from(origin + ray.direction * hit.distance);
        points.push(LabelledPoint { location: frames::to_carla(place), label: hit.tag.value() });
        gone += hit.distance + BEHIND_M;
    }
    Ok(points)
}
