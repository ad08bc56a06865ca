//! Who drives close behind whom.

use super::moment::Moment;
use crate::occupancy::Leader;
use crate::vehicle::Vehicle;
use endless_world::math::f64::wrap_angle;

/// Which pairs are looked for.
pub(super) struct FollowingPairs {
    /// The gap between them, metres.
    pub(super) gap_m: [f64; 2],
    /// The follower is at least so fast, m/s.
    pub(super) least_mps: f64,
    /// Where their headings differ by more is a bend, radians.
    pub(super) straight: f64,
}

/// One behind the other.
pub(super) struct FollowingPair<'a> {
    pub(super) follower: (usize, &'a Vehicle),
    pub(super) leader: Leader,
    pub(super) ahead: &'a Vehicle,
}

impl FollowingPairs {
    /// Those outside junctions, both of them `free`, whose follower is looked at.
    pub(super) fn of<'a>(
        &'a self,
        moment: &'a Moment<'_>,
        free: impl Fn(&Vehicle) -> bool + 'a,
    ) -> impl Iterator<Item = FollowingPair<'a>> + 'a {
        moment.watched().filter_map(move |(i, follower)| {
            if follower.speed < self.least_mps || !free(follower) {
                return None;
            }
            let leader = moment.occupancy.leader(moment.roads, moment.vehicles, i, self.gap_m[1]);
            let leader = leader.filter(|leader| (self.gap_m[0]..self.gap_m[1]).contains(&leader.gap))?;
            let ahead = moment.vehicles.get(leader.vehicle).filter(|ahead| free(ahead))?;
            let outside = [ahead, follower].iter().all(|vehicle| moment.roads.table(vehicle.lane()).junction.is_none());
            let straight = wrap_angle(ahead.yaw - follower.yaw).abs() <= self.straight;
            (outside && straight).then_some(FollowingPair { follower: (i, follower), leader, ahead })
        })
    }
}
