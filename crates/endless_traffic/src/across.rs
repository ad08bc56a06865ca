//! The part of a lane's width that a body takes.

use endless_world::Side;

/// From its right side to its left, metres to the left of the lane's middle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Across {
    pub(crate) right_m: f64,
    pub(crate) left_m: f64,
}

impl Across {
    /// All of a lane: nobody is beside it.
    pub(crate) const WHOLE: Self = Self { right_m: f64::NEG_INFINITY, left_m: f64::INFINITY };

    /// Of a body of this half width that is at one of these places or on the way from one to the other.
    pub(crate) fn between(middle_m: f64, other_m: f64, half_width_m: f64) -> Self {
        Self { right_m: middle_m.min(other_m) - half_width_m, left_m: middle_m.max(other_m) + half_width_m }
    }

    /// Whether there is so much room, metres, between the two.
    pub(crate) fn is_clear_of(&self, other: &Self, room_m: f64) -> bool {
        self.right_m >= other.left_m + room_m || other.right_m >= self.left_m + room_m
    }

    /// The same as seen from the lane beside on a side, whose middle is so far away, metres.
    pub(crate) fn seen_beside(&self, side: Side, away_m: f64) -> Self {
        let shift_m = match side {
            Side::Left => -away_m,
            Side::Right => away_m,
        };
        Self { right_m: self.right_m + shift_m, left_m: self.left_m + shift_m }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bodies_side_by_side_are_clear_of_one_another_and_nobody_is_of_a_whole_lane() {
        let car = Across::between(0.1, 0.1, 0.9);
        let rider = Across::between(1.6, 1.6, 0.4);
        assert!(car.is_clear_of(&rider, 0.19) && rider.is_clear_of(&car, 0.19) && !rider.is_clear_of(&car, 0.21));
        assert!(!Across::between(0.0, 1.6, 0.4).is_clear_of(&car, 0.0), "it comes from behind it");
        assert!(!Across::WHOLE.is_clear_of(&rider, 0.0) && !rider.is_clear_of(&Across::WHOLE, 0.0));
        let beside = rider.seen_beside(Side::Left, 3.2);
        assert!((beside.right_m + 2.0).abs() < 1e-9 && (beside.left_m + 1.2).abs() < 1e-9);
        assert_eq!(beside.seen_beside(Side::Right, 3.2), rider);
    }
}
