//! What is checked, and the limits.

/// One thing that traffic must keep to. Each is a number that must not be above its limit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum AuditCheck {
    /// Times that the footprints of two vehicles began to overlap, parked ones included.
    Collisions,
    /// Times that a person on foot, a disc of 0.25 m, began to touch a vehicle.
    PeopleHit,
    /// Times that two people on foot began to touch.
    PeopleTouch,
    /// Longest time that a vehicle stayed within half a metre, seconds in which no signal ahead of it held it.
    VehicleStands,
    /// Longest time that somebody on foot stayed within a metre, seconds in which no signal held them.
    PersonStands,
    /// Furthest that the middle of an axle was outside of the vehicle's lane, metres.
    OffLane,
    /// Furthest that somebody on foot was outside of all sidewalks and crossings, metres.
    OffSidewalk,
    /// Share of walking time spent more than 0.1 m outside of them.
    OffSidewalkShare,
    /// Times that somebody sat down elsewhere than on the seat of a bench.
    BesideSeat,
    /// Furthest that a corner of somebody who parked during the recording was outside of all bays at kerbs, metres.
    BesideBay,
    /// Times that somebody got further in a frame than their speed allows, or backwards.
    Jumps,
    /// Times that somebody appeared or vanished elsewhere than at an end of the map's roads or ways.
    Vanishings,
    /// Largest change of a vehicle's speed, m/s².
    Acceleration,
    /// Share of driving time with more than 8 m/s².
    HardAcceleration,
    /// Largest change of a vehicle's acceleration, m/s³.
    Jerk,
    /// Share of driving time with more than 30 m/s³.
    HardJerk,
    /// Largest speed of a rear axle across its wheels, m/s.
    Slip,
    /// Largest yaw rate of a vehicle, rad/s.
    YawRate,
    /// Furthest that the middle between a vehicle's axles was beside the middle of its lane without changing lanes,
    /// two-wheelers apart, metres.
    LaneError,
    /// Share of driving time with more than half a metre of that.
    LaneErrorShare,
    /// Furthest that the side of a two-wheeler was outside of its lane, metres: where in the lane they keep is their choice. Over
    /// the line to a lane of the same direction it may be by its width.
    TwoWheelersOut,
    /// Vehicles that passed a light that had been red for a second, or for four if they had waited at the line to turn.
    RedLights,
    /// People who set out to cross at a light that was not green, nor in the frame before.
    PeopleAtRed,
    /// Vehicles that passed a stop sign without stopping.
    StopSigns,
    /// Most that a vehicle was faster than the boldest driver may be on its lane, m/s.
    Speeding,
}

impl AuditCheck {
    /// All of them, in the order of the report.
    pub const ALL: &[Self] = &[
        Self::Collisions,
        Self::PeopleHit,
        Self::PeopleTouch,
        Self::VehicleStands,
        Self::PersonStands,
        Self::OffLane,
        Self::OffSidewalk,
        Self::OffSidewalkShare,
        Self::LaneError,
        Self::LaneErrorShare,
        Self::TwoWheelersOut,
        Self::BesideSeat,
        Self::BesideBay,
        Self::Jumps,
        Self::Vanishings,
        Self::Acceleration,
        Self::HardAcceleration,
        Self::Jerk,
        Self::HardJerk,
        Self::Slip,
        Self::YawRate,
        Self::RedLights,
        Self::PeopleAtRed,
        Self::StopSigns,
        Self::Speeding,
    ];

    /// In a few words.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Collisions => "collisions between vehicles",
            Self::PeopleHit => "people touched by vehicles",
            Self::PeopleTouch => "people who touch one another",
            Self::VehicleStands => "longest stand of a vehicle, red lights apart",
            Self::PersonStands => "longest stand of a person, red lights apart",
            Self::OffLane => "axle outside of its lane",
            Self::OffSidewalk => "person off sidewalks and crossings",
            Self::OffSidewalkShare => "time more than 0.1 m off them",
            Self::BesideSeat => "people who sit beside a seat",
            Self::BesideBay => "parked outside of bays",
            Self::Jumps => "jumps",
            Self::Vanishings => "appeared or vanished inside the map",
            Self::Acceleration => "largest acceleration",
            Self::HardAcceleration => "time with more than 8 m/s²",
            Self::Jerk => "largest jerk",
            Self::HardJerk => "time with more than 30 m/s³",
            Self::Slip => "rear axle sideways",
            Self::YawRate => "largest yaw rate",
            Self::LaneError => "beside the lane's middle",
            Self::LaneErrorShare => "time more than 0.5 m beside the middle",
            Self::TwoWheelersOut => "two-wheeler's side outside of its lane",
            Self::RedLights => "red lights run",
            Self::PeopleAtRed => "people who set out at red",
            Self::StopSigns => "stop signs passed without a stop",
            Self::Speeding => "faster than the boldest driver may be",
        }
    }

    /// What it is measured in; empty for numbers of times.
    pub const fn unit(self) -> &'static str {
        match self {
            Self::Collisions
            | Self::PeopleHit
            | Self::PeopleTouch
            | Self::BesideSeat
            | Self::Jumps
            | Self::Vanishings
            | Self::RedLights
            | Self::PeopleAtRed
            | Self::StopSigns => "",
            Self::VehicleStands | Self::PersonStands => "s",
            Self::OffLane | Self::OffSidewalk | Self::LaneError | Self::TwoWheelersOut | Self::BesideBay => "m",
            Self::Acceleration => "m/s²",
            Self::Jerk => "m/s³",
            Self::HardAcceleration | Self::HardJerk | Self::LaneErrorShare | Self::OffSidewalkShare => "%",
            Self::Slip | Self::Speeding => "m/s",
            Self::YawRate => "rad/s",
        }
    }

    /// What must not be exceeded, in its unit.
    pub const fn limit(self) -> f64 {
        match self {
            Self::Collisions
            | Self::PeopleHit
            | Self::PeopleTouch
            | Self::BesideSeat
            | Self::Jumps
            | Self::Vanishings
            | Self::RedLights
            | Self::PeopleAtRed
            | Self::StopSigns
            | Self::OffLane
            | Self::TwoWheelersOut => 0.0,
            Self::VehicleStands | Self::PersonStands => 180.0,
            Self::OffSidewalk => 0.5,
            // Between two bays there is as much.
            Self::BesideBay => 0.2,
            Self::Acceleration => 8.0,
            Self::Jerk => 60.0,
            Self::HardAcceleration | Self::HardJerk | Self::OffSidewalkShare => 0.1,
            // Long vehicles cut corners that are tight for them.
            Self::LaneErrorShare => 2.0,
            Self::Slip => 0.35,
            Self::YawRate => 2.0,
            Self::LaneError => 1.2,
            Self::Speeding => 1.0,
        }
    }
}
