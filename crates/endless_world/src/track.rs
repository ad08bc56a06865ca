//! Motion that was recorded elsewhere, to be played as it was.

use crate::ObjectClass;
use glam::DVec2;
use serde::{Deserialize, Serialize};

/// The motion of one road user, as a file tells it.
#[derive(Debug, Clone, PartialEq)]
pub struct Track {
    /// Its name in the file.
    pub name: String,
    /// What the file calls its kind: a model is looked for whose name shares words with it.
    pub kind: String,
    /// Its class; of who rides a two-wheeler that of the two-wheeler.
    pub class: ObjectClass,
    /// From front to rear, metres, if the file says so: a model of about this length is chosen.
    pub length_m: Option<f64>,
    /// The point that the positions are of.
    pub point: TrackPoint,
    /// Stretches of time in which it is there, one after the other; none is empty.
    pub pieces: Vec<Vec<TrackSample>>,
}

/// The point of a road user that a track follows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TrackPoint {
    /// The middle of its front.
    Front,
    /// Its centre.
    Centre,
}

/// Where a road user is at an instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TrackSample {
    /// Seconds, on the file's clock.
    pub time_s: f64,
    /// Metres, x east, y north, in the file's frame.
    pub position: DVec2,
    /// Metres. It tells which of several roads above one another is meant.
    pub height_m: Option<f64>,
    /// Heading, counter-clockwise from east, radians.
    pub yaw_rad: f64,
    /// Forward speed, m/s; `None` if it follows from the positions.
    pub speed_mps: Option<f64>,
}

/// How a scene plays the tracks of a file.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct TrackPlayback {
    /// When the video begins on the file's clock, seconds.
    pub begin_s: f64,
    /// Position in the file of the map's origin, metres.
    pub offset_m: [f64; 2],
    /// Which models and looks are drawn: the same in all videos of a recipe.
    pub seed: u64,
}

impl Track {
    /// The first and the last instant at which it is there, seconds; `None` without samples.
    pub fn ends_s(&self) -> Option<[f64; 2]> {
        Some([self.pieces.first()?.first()?.time_s, self.pieces.last()?.last()?.time_s])
    }
}
