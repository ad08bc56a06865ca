//! A halt at the kerb: a vehicle indicates, pulls in as far as its lane allows, stands for a while, indicates to the road and
//! drives on. It keeps to its lane meanwhile; those behind it wait, or change lanes. Who parks leaves the lane for a bay beside it.

use crate::bay_way::BayWay;
use crate::driver::Driver;
use crate::incident::Drift;
use crate::roads::fastest_before;
use endless_road::LaneId;
use endless_world::{Parking, Side};

/// Pulling in ends so far before the place, metres.
pub(crate) const STRAIGHT_M: f64 = 3.0;
/// Nobody pulls in or out along less than this, metres.
pub(crate) const LEAST_DRIFT_M: f64 = 12.0;
/// Indicators show from this far before the place, metres, and for so long before the vehicle goes on, seconds.
const INDICATES_M: f64 = 45.0;
pub(crate) const INDICATES_S: f64 = 2.0;
/// A door takes so long to close, seconds.
const CLOSES_S: f64 = 1.0;
/// A line that is never passed, so near ahead of who stands, metres.
const HOLDS_M: f64 = 0.06;
/// What a driver's braking leaves to the line on average, metres.
pub(crate) const LEAVES_M: f64 = 0.6;
/// Braking before a halt, m/s²: people stand in buses.
const BRAKING_MPS2: f64 = 1.2;
/// Speeds into a bay and out of it, m/s.
const INTO_BAY_MPS: f64 = 3.2;
const OUT_OF_BAY_MPS: f64 = 4.0;
/// Who has parked for so long has turned off all lamps, seconds.
const SWITCHES_OFF_S: f64 = 2.0;

/// How far a vehicle is with it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Phase {
    Coming,
    /// Until it goes on, seconds.
    Standing {
        left_s: f64,
    },
    /// On the way back to its usual place in the lane.
    Leaving,
}

/// A halt to come or under way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct KerbHalt {
    /// Where the front bumper is to stand.
    pub(crate) lane: LaneId,
    pub(crate) front_s: f64,
    pub(crate) side: Side,
    /// The bus stop at which people get on and off.
    pub(crate) stop: Option<usize>,
    /// The bay in which it parks, off the lane.
    pub(crate) bay: Option<BayWay>,
    /// Whether its hazard lights are on while it stands.
    pub(crate) hazards: bool,
    /// For how long it has stood, seconds.
    pub(crate) stood_s: f64,
    /// How far to the left of its usual place it stands, metres.
    pub(crate) left_m: f64,
    /// How long it stands, seconds.
    pub(crate) stands_s: f64,
    pub(crate) phase: Phase,
    pub(crate) drift: Option<Drift>,
    /// From the front bumper to the place, metres.
    pub(crate) ahead_m: f64,
}

impl KerbHalt {
    /// `left_m`: where it stands, `lateral_m`: where it drives, metres to the left of the lane's middle.
    pub(crate) fn new(
        lateral_m: f64,
        (lane, front_s, ahead_m): (LaneId, f64, f64),
        (side, left_m): (Side, f64),
        stands_s: f64,
    ) -> Self {
        let (front_s, ahead_m) = (front_s + LEAVES_M, ahead_m + LEAVES_M);
        let left_m = left_m - lateral_m;
        Self {
            lane,
            front_s,
            side,
            stop: None,
            bay: None,
            hazards: false,
            stood_s: 0.0,
            left_m,
            stands_s,
            phase: Phase::Coming,
            drift: None,
            ahead_m,
        }
    }

    /// In a bay.
    pub(crate) fn in_bay(self, way: BayWay) -> Self {
        Self { bay: Some(way), ..self }
    }

    /// At which people get on and off.
    pub(crate) fn for_stop(self, stop: Option<usize>) -> Self {
        Self { stop, ..self }
    }

    pub(crate) fn with_hazard_lights(self) -> Self {
        Self { hazards: true, ..self }
    }

    /// Whether its hazard lights are on.
    pub(crate) fn warns(&self) -> bool {
        self.hazards && self.stands()
    }

    /// The bus stop at which it stands with its door open, and for how long it has, seconds.
    pub(crate) fn at_stop(&self) -> Option<(usize, f64)> {
        self.stop.filter(|_| matches!(self.phase, Phase::Standing { .. })).map(|stop| (stop, self.stood_s))
    }

    /// It waits for somebody who gets on or off.
    pub(crate) fn held(self) -> Self {
        match self.phase {
            Phase::Standing { left_s } => {
                Self { phase: Phase::Standing { left_s: left_s.max(INDICATES_S + CLOSES_S) }, ..self }
            }
            _ => self,
        }
    }

    /// Whether it stands parked, off the lane.
    pub(crate) fn is_parked(&self) -> bool {
        self.bay.is_some() && matches!(self.phase, Phase::Standing { .. })
    }

    /// How far it is with parking.
    pub(crate) fn parking(&self) -> Option<Parking> {
        self.bay?;
        match self.phase {
            Phase::Coming => self.drift.map(|_| Parking::PullingIn),
            Phase::Standing { .. } => Some(Parking::Parked),
            Phase::Leaving => Some(Parking::PullingOut),
        }
    }

    /// Whether it stands parked without a lamp lit.
    pub(crate) fn is_dark(&self) -> bool {
        self.is_parked() && self.stands() && self.stood_s > SWITCHES_OFF_S
    }

    /// A vehicle this fast can come to a comfortable halt from so far, metres.
    pub(crate) fn least_ahead_m(speed_mps: f64) -> f64 {
        speed_mps * speed_mps / (2.0 * BRAKING_MPS2) + LEAST_DRIFT_M + STRAIGHT_M
    }

    /// Whether it stands, and does not go yet.
    pub(crate) fn stands(&self) -> bool {
        matches!(self.phase, Phase::Standing { left_s } if left_s > INDICATES_S)
    }

    /// The acceleration of somebody who would like to have that one, m/s².
    pub(crate) fn wanted(&self, wanted: f64, driver: &Driver, speed_mps: f64) -> f64 {
        let pace = |mps: f64| wanted.min(driver.free(speed_mps, mps));
        let wanted = match (self.bay, self.phase) {
            (Some(way), Phase::Coming) => {
                pace(fastest_before(INTO_BAY_MPS, (self.ahead_m - LEAVES_M - way.begins_m()).max(0.0)))
            }
            (Some(_), Phase::Leaving) => pace(OUT_OF_BAY_MPS),
            _ => wanted,
        };
        let gap_m = match self.phase {
            Phase::Coming => self.ahead_m,
            Phase::Standing { .. } => HOLDS_M,
            Phase::Leaving => return wanted,
        };
        let gently = Driver { brake: driver.brake.min(BRAKING_MPS2), ..*driver };
        wanted.min(gently.stop_at(speed_mps, gap_m.max(HOLDS_M)))
    }

    /// Metres to the left of the usual place in the lane, and the slope to there.
    pub(crate) fn aside(&self, rolled_m: f64) -> (f64, f64) {
        self.drift.map_or((0.0, 0.0), |drift| drift.at(rolled_m))
    }

    /// Where the indicators show.
    pub(crate) fn indicates(&self) -> Option<Side> {
        let road = if self.side == Side::Left { Side::Right } else { Side::Left };
        match self.phase {
            Phase::Coming => (self.ahead_m < INDICATES_M).then_some(self.side),
            Phase::Standing { left_s } => (left_s < INDICATES_S).then_some(road),
            Phase::Leaving => Some(road),
        }
    }

    /// Whether the vehicle halts before a line so far ahead of its front bumper, metres, so that it needs no right of way beyond.
    pub(crate) fn is_before(&self, to_line_m: f64) -> bool {
        self.phase != Phase::Leaving && self.ahead_m < to_line_m
    }
}
