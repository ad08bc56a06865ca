//! Obstacle detectors: what a ball meets first that is sent ahead.

use super::contact::thing;
use crate::physics::{Obstacle, OrientedBox};
use crate::server::actor::{Body, ObstacleSettings};
use crate::server::episode::Episode;
use crate::server::obstacles::upright;
use crate::stream::SensorHeader;
use crate::wire::{Actor, Wire};
use endless_world::{ClassTag, SensorPose};
use glam::{DVec2, DVec3};
use rmpv::Value;

/// `[who carries the sensor, what is ahead, metres until the ball meets it]`; `None` if nothing is.
pub(super) fn message(
    header: &SensorHeader,
    episode: &Episode,
    [sensor, carrier]: [u32; 2],
    settings: &ObstacleSettings,
    pose: &SensorPose,
) -> Option<Vec<u8>> {
    let sweep = Sweep { from: pose.position, ahead: pose.world_from_sensor * DVec3::X, settings };
    let own = episode.actors.get(&carrier).or_else(|| episode.actors.get(&sensor))?;
    let bodies = episode.actors.values().filter(|actor| actor.told.id != carrier).filter_map(|actor| {
        let outline = match &actor.body {
            Body::Vehicle(vehicle) => whole(&vehicle.body.outline(), vehicle.body.place().position.z),
            Body::Walker(walker) => whole(&walker.body.outline(), walker.body.place().position.z),
            Body::Prop(_) if !settings.only_dynamics => upright(&actor.transform, &actor.told.bounding_box),
            _ => return None,
        };
        Some((sweep.meets(&outline)?, actor.told.clone()))
    });
    let first = bodies.chain(sweep.things(episode)).min_by(|(a, _), (b, _)| a.total_cmp(b));
    let (distance_m, other) = first?;
    let payload = Value::Array(vec![own.told.to_value(), other.to_value(), Value::F32(distance_m as f32)]);
    Some(header.with_msgpack(&payload))
}

/// From the ground on: what bodies drive over is left out of their outlines.
fn whole(outline: &OrientedBox, low_m: f64) -> OrientedBox {
    OrientedBox { low_m, ..*outline }
}

/// A ball on its way.
struct Sweep<'a> {
    from: DVec3,
    /// Unit vector.
    ahead: DVec3,
    settings: &'a ObstacleSettings,
}

impl Sweep<'_> {
    /// The way to a box, metres. No point is nearer to it than the ball can go on without a look (Hart 1996, "Sphere
    /// tracing").
    fn meets(&self, outline: &OrientedBox) -> Option<f64> {
        /// So near is met, metres.
        const NEAR_M: f64 = 1e-3;
        const STEPS: usize = 256;
        let mut gone_m = 0.0;
        for _ in 0..STEPS {
            let free_m = outline.distance_m(self.from + self.ahead * gone_m) - self.settings.hit_radius_m;
            if free_m < NEAR_M {
                return Some(gone_m);
            }
            gone_m += free_m;
            if gone_m > self.settings.distance_m {
                return None;
            }
        }
        None
    }

    /// The things of the map that it meets.
    fn things(&self, episode: &Episode) -> Vec<(f64, Actor)> {
        let mut near: Vec<Obstacle> = Vec::new();
        let (here, there) = (self.from, self.from + self.ahead * self.settings.distance_m);
        let reach = DVec2::splat(self.settings.hit_radius_m);
        let (low, high) = (here.truncate().min(there.truncate()), here.truncate().max(there.truncate()));
        if !self.settings.only_dynamics {
            episode.map.obstacles.near(low - reach, high + reach, &mut near);
        }
        let met = near.into_iter().filter_map(|obstacle| {
            let tag = episode.map.obstacles.tag(obstacle.id).unwrap_or(ClassTag::Unlabeled);
            Some((self.meets(&obstacle.outline)?, thing(tag)))
        });
        met.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_ball_meets_what_a_ray_passes_by() {
        let outline = OrientedBox {
            centre: DVec2::new(8.0, 1.0),
            half: DVec2::splat(0.5),
            along: DVec2::X,
            low_m: 0.0,
            high_m: 2.0,
        };
        let meets = |radius, height, reach| {
            let settings = ObstacleSettings { distance_m: reach, hit_radius_m: radius, only_dynamics: false };
            Sweep { from: DVec3::Z * height, ahead: DVec3::X, settings: &settings }.meets(&outline)
        };
        assert_eq!(meets(0.4, 1.0, 20.0), None);
        let met = meets(0.6, 1.0, 20.0).expect("met");
        // The edge is 0.5 m aside: the ball's side meets it so much before its nose would.
        assert!((met - (7.5 - 0.11f64.sqrt())).abs() < 0.01, "{met}");
        assert_eq!(meets(0.6, 1.0, 7.0), None);
        assert_eq!(meets(0.6, 2.7, 20.0), None);
    }
}
