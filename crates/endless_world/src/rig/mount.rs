//! What carries a sensor.

use super::rotation_from_angles;
use crate::ObjectClass;
use glam::{DQuat, DVec3};
use serde::{Deserialize, Serialize};

/// Where a sensor sits on what carries it, or stands by itself: its body frame (x forward, y left, z up) in that of the
/// carrier, or in the world.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Placement {
    /// Metres.
    pub position: [f64; 3],
    /// Counter-clockwise from the carrier's nose, or from east; radians.
    pub yaw_rad: f64,
    /// Nose up is positive, radians.
    pub pitch_rad: f64,
    /// Left side up is positive, radians.
    pub roll_rad: f64,
}

impl Placement {
    /// Turns directions of the sensor's body frame into those of its carrier, or of the world.
    pub fn rotation(&self) -> DQuat {
        rotation_from_angles(self.yaw_rad, self.pitch_rad, self.roll_rad)
    }

    /// Its origin, metres.
    pub fn origin(&self) -> DVec3 {
        DVec3::from_array(self.position)
    }
}

/// Who carries a sensor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Carrier {
    /// The class of those among whom one is chosen; `None` for any vehicle.
    pub class: Option<ObjectClass>,
    /// Which of them: 0 for the one that gets farthest in the video, 1 for the next.
    pub number: u32,
}

/// Where a sensor looks at an instant, on a way that was laid out before.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct WayPoint {
    /// Since the video's first frame, seconds.
    pub time_s: f64,
    /// Where the sensor is then.
    pub at: Placement,
    /// Horizontal field of view of a camera whose lens zooms, radians.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub horizontal_fov_rad: Option<f64>,
}

/// What decides where a sensor is at every instant of a video.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "on", rename_all = "snake_case")]
pub enum SensorMount {
    /// It stands still in the world.
    Still {
        /// There.
        at: Placement,
    },
    /// Somebody carries it.
    Carried {
        /// Who.
        by: Carrier,
        /// Where on them.
        at: Placement,
    },
    /// It flies around a point and looks at it.
    Orbit {
        /// The point that it looks at, metres in the world.
        centre: [f64; 3],
        /// Horizontal distance from that point, metres.
        radius_m: f64,
        /// Height above that point, metres.
        height_m: f64,
        /// Time of one round, counter-clockwise, seconds; negative for clockwise.
        period_s: f64,
        /// Where it begins, counter-clockwise from east of the point, radians.
        begin_rad: f64,
    },
    /// It goes from one point to the next, and stays where it began before the first and after the last.
    Way {
        /// In the order of their times.
        points: Vec<WayPoint>,
    },
}

impl SensorMount {
    /// Whether it never moves, turns or zooms.
    pub fn is_still(&self) -> bool {
        matches!(self, Self::Still { .. })
    }

    /// Who carries it.
    pub fn carrier(&self) -> Option<Carrier> {
        match self {
            Self::Carried { by, .. } => Some(*by),
            _ => None,
        }
    }
}
