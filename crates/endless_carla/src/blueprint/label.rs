//! CARLA's semantic labels that actors bear.

pub(super) const TRAFFIC_LIGHT: u8 = 7;
pub(super) const TRAFFIC_SIGNS: u8 = 8;
pub(super) const VEGETATION: u8 = 9;
pub(super) const PEDESTRIANS: u8 = 12;
pub(super) const RIDER: u8 = 13;
pub(super) const CAR: u8 = 14;
pub(super) const TRUCK: u8 = 15;
pub(super) const BUS: u8 = 16;
pub(super) const MOTORCYCLE: u8 = 18;
pub(super) const BICYCLE: u8 = 19;
/// What does not move: benches, fountains, bus shelters.
pub(super) const STATIC: u8 = 20;
/// What somebody may move: bins, bags, cones.
pub(super) const DYNAMIC: u8 = 21;
