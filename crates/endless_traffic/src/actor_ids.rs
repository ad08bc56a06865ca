//! Ids of those who move.

use crate::vehicle::Vehicle;
use endless_world::{InstanceId, InstanceIdAllocator, TooManyInstances};
use std::collections::VecDeque;

/// Ids of the vehicles and people that are there, in their order.
#[derive(Debug, Clone)]
pub(crate) struct ActorIds {
    /// Of each vehicle and of its rider.
    pub(crate) vehicles: Vec<(InstanceId, Option<InstanceId>)>,
    pub(crate) walkers: Vec<InstanceId>,
    fresh: InstanceIdAllocator,
    /// Of those who have left, in that order: they are given again when there is no other left, after many hours.
    left: VecDeque<InstanceId>,
}

impl ActorIds {
    /// Vehicles first, then riders, then people on foot.
    pub(crate) fn new(
        vehicles: &[Vehicle],
        walkers: usize,
        ids: &mut InstanceIdAllocator,
    ) -> Result<Self, TooManyInstances> {
        let own = ids.allocate_many(vehicles.len())?;
        let of_rider = |vehicle: &Vehicle| vehicle.ridden.then(|| ids.allocate()).transpose();
        let riders: Vec<Option<InstanceId>> = vehicles.iter().map(of_rider).collect::<Result<_, _>>()?;
        let walkers = ids.allocate_many(walkers)?;
        Ok(Self {
            vehicles: own.into_iter().zip(riders).collect(),
            walkers,
            fresh: InstanceIdAllocator::default(),
            left: VecDeque::new(),
        })
    }

    /// Those who come later are numbered after these.
    pub(crate) fn go_on_after(&mut self, ids: InstanceIdAllocator) {
        self.fresh = ids;
    }

    /// Numbers a vehicle that comes, behind all others; `false` if there is no id left.
    pub(crate) fn come(&mut self, vehicle: &Vehicle) -> bool {
        let Some(id) = self.next() else { return false };
        let rider = if vehicle.ridden { self.next() } else { None };
        if vehicle.ridden && rider.is_none() {
            self.left.push_front(id);
            return false;
        }
        self.vehicles.push((id, rider));
        true
    }

    /// The vehicle of this number has left; those behind it move up.
    pub(crate) fn leave(&mut self, vehicle: usize) {
        let (id, rider) = self.vehicles.remove(vehicle);
        self.left.extend([Some(id), rider].into_iter().flatten());
    }

    fn next(&mut self) -> Option<InstanceId> {
        self.fresh.allocate().ok().or_else(|| self.left.pop_front())
    }
}
