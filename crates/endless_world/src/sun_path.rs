//! The sun's way across the sky while the time of day changes.

use crate::math::lerp;
use crate::{Condition, TimeOfDay, Weather};

/// Where the sun of a night stands while it comes up or has gone down, degrees.
const DARK_SUN_DEG: f32 = -9.0;
/// The lowest and the highest sun of an afternoon that comes to its end, degrees.
const EVENING_SUN_DEG: [f32; 2] = [14.0, 22.0];
/// Its azimuths, degrees: around west.
const EVENING_AZIMUTH_DEG: [f32; 2] = [180.0, 220.0];
/// The sun's way from morning to afternoon along the horizon, degrees.
const FORENOON_DEG: f32 = 50.0;
/// Shares of the time of a dusk, and the sun's elevations at them, degrees, after it has come down to the first: pictures
/// change most while lamps are lit, least while the sun is up, and so an equal share of their change takes an equal time.
const DUSK: [[f32; 2]; 7] =
    [[0.28, 5.0], [0.39, 2.0], [0.49, -1.0], [0.56, -2.5], [0.83, -5.5], [0.93, -7.0], [1.0, DARK_SUN_DEG]];

/// Azimuth, counter-clockwise from east, and elevation, degrees.
type Place = [f32; 2];

/// The way from one time of day to another.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum SunPath {
    /// It stays.
    Still(Place),
    /// By day.
    Day { from: Place, to: Place },
    /// It sets.
    Dusk { from: Place },
    /// It rises.
    Dawn { to: Place },
}

impl SunPath {
    /// Between two times of day, given where the sun of a video would stand in each.
    pub(crate) fn new([from_time, to_time]: [TimeOfDay; 2], [from, to]: [Place; 2]) -> Self {
        match (from_time, to_time) {
            _ if from_time == to_time => Self::Still(from),
            (TimeOfDay::Afternoon, TimeOfDay::Night) => Self::Dusk { from: evening(from) },
            (_, TimeOfDay::Night) => Self::Dusk { from },
            (TimeOfDay::Night, _) => Self::Dawn { to },
            (TimeOfDay::Morning, _) => Self::Day { from, to: [from[0] - FORENOON_DEG, to[1]] },
            _ => Self::Day { from, to },
        }
    }

    /// Whether it moves.
    pub(crate) fn moves(&self) -> bool {
        !matches!(self, Self::Still(_))
    }

    /// Where the sun stands at a share of the time, 0 to 1.
    pub(crate) fn at(&self, share: f32) -> Place {
        match *self {
            Self::Still(place) => place,
            Self::Day { from, to } => [0, 1].map(|k| lerp(from[k], to[k], share)),
            Self::Dusk { from } => {
                let elevation = at_dusk(from[1], share);
                [from[0] + elevation - from[1], elevation]
            }
            Self::Dawn { to } => {
                let elevation = at_dusk(to[1], 1.0 - share);
                [to[0] + to[1] - elevation, elevation]
            }
        }
    }
}

/// Azimuth and elevation of the sun of an afternoon, late in it.
fn evening([azimuth, elevation]: Place) -> Place {
    let usual = Condition::of(Weather::ClearSky, TimeOfDay::Afternoon);
    let within = |value: f32, low: f32, high: f32| ((value - low) / (high - low)).clamp(0.0, 1.0);
    let late = |[low, high]: [f32; 2], share: f32| lerp(low, high, share);
    let [azimuths, elevations] = [usual.sun_azimuth_deg, usual.sun_elevation_deg];
    [
        late(EVENING_AZIMUTH_DEG, within(azimuth, azimuths.low, azimuths.high)),
        late(EVENING_SUN_DEG, within(elevation, elevations.low, elevations.high)),
    ]
}

/// The elevation of a sun that sets, from one above that of [`DUSK`].
fn at_dusk(from: f32, share: f32) -> f32 {
    let mut before = [0.0, from];
    for knot in DUSK {
        if share <= knot[0] {
            return lerp(before[1], knot[1], (share - before[0]) / (knot[0] - before[0]));
        }
        before = knot;
    }
    DARK_SUN_DEG
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_sets_in_the_west_and_rises_in_the_east() {
        let [morning, afternoon, night] = [[10.0, 15.0], [250.0, 50.0], [100.0, -40.0]];
        let dusk = SunPath::new([TimeOfDay::Afternoon, TimeOfDay::Night], [afternoon, night]);
        let dawn = SunPath::new([TimeOfDay::Night, TimeOfDay::Morning], [night, morning]);
        assert!((130.0..230.0).contains(&dusk.at(1.0)[0]) && dusk.at(1.0)[1] == DARK_SUN_DEG);
        assert_eq!(dawn.at(1.0), morning);
        assert!(dawn.at(0.0)[0] > morning[0] && dawn.at(0.0)[1] == DARK_SUN_DEG);
        for path in [dusk, dawn] {
            for i in 1..=100 {
                let (before, now) = (path.at((i - 1) as f32 / 100.0), path.at(i as f32 / 100.0));
                assert!((before[1] - now[1]).abs() < 0.8 && (before[0] > now[0]), "{path:?} {i}");
            }
        }
    }
}
