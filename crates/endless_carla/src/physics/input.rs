//! A client's control, made fit for use.

use super::sane::within_f32;
use crate::wire::VehicleControl;

/// Pedals and gear; nothing in it is not finite.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Input {
    /// 0 to 1.
    pub(super) throttle: f64,
    /// -1 to 1, to the right is positive.
    pub(super) steer: f64,
    /// 0 to 1.
    pub(super) brake: f64,
    pub(super) hand_brake: bool,
    pub(super) reverse: bool,
    /// The gear that the driver has chosen.
    pub(super) gear: Option<i32>,
}

impl From<&VehicleControl> for Input {
    fn from(control: &VehicleControl) -> Self {
        Self {
            throttle: within_f32(control.throttle, 0.0, 1.0, 0.0),
            steer: within_f32(control.steer, -1.0, 1.0, 0.0),
            brake: within_f32(control.brake, 0.0, 1.0, 0.0),
            hand_brake: control.hand_brake,
            reverse: control.reverse,
            gear: control.manual_gear_shift.then_some(control.gear),
        }
    }
}
