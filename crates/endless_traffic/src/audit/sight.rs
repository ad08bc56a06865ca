//! What is seen of a frame.

use endless_road::{Lane, LaneId, RoadNetwork};
use endless_world::math::f64::sin_cos;
use endless_world::{Actor, InstanceId, Motion, VehicleMotion, VehicleSpec, WorldState};
use glam::DVec2;

/// One frame, and who was where in the one before.
pub(super) struct Sight<'a> {
    pub(super) network: &'a RoadNetwork,
    pub(super) specs: &'a [VehicleSpec],
    pub(super) state: &'a WorldState,
    /// Time since the frame before, seconds.
    pub(super) frame_s: f64,
    /// Whether it is the first frame.
    pub(super) first: bool,
    /// Who was there in the frame before and is not any more.
    pub(super) vanished: Vec<Actor>,
    pub(super) glances: Vec<Glance<'a>>,
}

impl<'a> Sight<'a> {
    /// Who has this id in this frame.
    pub(super) fn of(&self, id: InstanceId) -> Option<&Glance<'a>> {
        let place = self.glances.binary_search_by_key(&id, |glance| glance.actor.id).ok()?;
        Some(&self.glances[place])
    }
}

/// Somebody in the frame before.
#[derive(Debug, Clone, Copy)]
pub(super) struct Past {
    pub(super) actor: Actor,
    /// Unit vector ahead.
    pub(super) ahead: DVec2,
}

/// One road user.
#[derive(Clone, Copy)]
pub(super) struct Glance<'a> {
    pub(super) actor: &'a Actor,
    pub(super) before: Option<Past>,
    pub(super) at: DVec2,
    /// Unit vector ahead.
    pub(super) ahead: DVec2,
    /// Of a vehicle.
    pub(super) driven: Option<(VehicleMotion, &'a VehicleSpec)>,
}

impl<'a> Glance<'a> {
    pub(super) fn new(actor: &'a Actor, before: Option<Past>, specs: &'a [VehicleSpec]) -> Self {
        let driven = match actor.motion {
            Motion::Vehicle(motion) => {
                Some((motion, &specs[actor.asset.vehicle().expect("what drives is a vehicle").model.index()]))
            }
            Motion::Walker(_) => None,
        };
        let (sin, cos) = sin_cos(f64::from(actor.pose.yaw_rad));
        Self { actor, before, at: actor.pose.position.as_dvec3().truncate(), ahead: DVec2::new(cos, sin), driven }
    }

    /// Number in tables by id.
    pub(super) fn place(&self) -> usize {
        usize::from(self.actor.id.0)
    }

    /// Metres since the frame before.
    pub(super) fn moved_m(&self) -> Option<f64> {
        let before = self.before?.actor.pose.position.as_dvec3().truncate();
        Some(self.at.distance(before))
    }

    /// Its lane, and its place on it.
    pub(super) fn lane<'n>(&self, network: &'n RoadNetwork) -> Option<(&'n Lane, f64)> {
        let place = self.actor.behaviour.lane?;
        Some((network.lane(LaneId(place.lane)), f64::from(place.s_m)))
    }

    /// When, who and where, for people to read.
    pub(super) fn told(&self, sight: &Sight<'_>) -> String {
        let behaviour = self.actor.behaviour;
        let lane = behaviour.lane.map(|place| format!(", lane {} at {:.1} m", place.lane, place.s_m));
        let crossing = behaviour.crossing.map(|crossing| format!(", on crossing {crossing}"));
        format!(
            "{:.1} s: {} {} at ({:.1}, {:.1}){}",
            sight.state.time_s,
            self.actor.class,
            self.actor.id,
            self.at.x,
            self.at.y,
            lane.or(crossing).unwrap_or_default()
        )
    }
}

/// The entry of a table by id, which grows as needed.
pub(super) fn entry<T: Default>(table: &mut Vec<T>, place: usize) -> &mut T {
    if table.len() <= place {
        table.resize_with(place + 1, T::default);
    }
    &mut table[place]
}
