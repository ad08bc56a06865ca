//! Errors of simulators.

use endless_interchange::MapError;
use endless_town::TownError;
use std::{error::Error, path::PathBuf, time::Duration};

/// What a simulator says when it cannot do what it is asked. Every message is one line that says what to do.
#[derive(Debug, thiserror::Error)]
pub enum SimulatorError {
    /// A rig, of a simulator that has none.
    #[error("this simulator has no sensors of rigs: leave out --rig and [[sensor]], or use another --simulator")]
    NoRigs,
    /// Nobody to carry a sensor.
    #[error(
        "video {video}: sensor {sensor} rides on {wanted}, and there is none on {map}: ask for more traffic or another carrier"
    )]
    NoCarrier {
        /// The video.
        video: u32,
        /// The map.
        map: String,
        /// The sensor.
        sensor: String,
        /// Whom it rides on.
        wanted: String,
    },
    /// Nobody who could carry a sensor outside the body.
    #[error(
        "video {video}: sensor {sensor} rides on {wanted}, and of {candidates} on {map} only {fitting} have it outside their \
         bodies with a free view: mount it higher or farther out, or on another class"
    )]
    NoCarrierFits {
        /// The video.
        video: u32,
        /// The map.
        map: String,
        /// The sensor.
        sensor: String,
        /// Whom it rides on.
        wanted: String,
        /// Those of the class who are there.
        candidates: usize,
        /// Those of them who can carry it.
        fitting: u32,
    },
    /// A map that there is not.
    #[error("unknown map '{map}': use one of {}", known.join(", "))]
    UnknownMap {
        /// What was asked for.
        map: String,
        /// The names there are.
        known: Vec<String>,
    },
    /// A map that cannot be made.
    #[error(transparent)]
    Map(MapError),
    /// A folder for what bakes share that cannot be used.
    #[error("cannot write to the folder {} of --cache: name another one", path.display())]
    CacheFolder {
        /// The folder.
        path: PathBuf,
        /// Why not.
        #[source]
        source: std::io::Error,
    },
    /// A map that cannot be shown.
    #[error("the simulator cannot load the map {map}")]
    LoadMap {
        /// The map.
        map: String,
        /// Why not.
        #[source]
        source: Box<dyn Error + Send + Sync>,
    },
    /// A scene that cannot be made.
    #[error("the simulator cannot make scene {video} in {map}")]
    Scene {
        /// Number of the video.
        video: u32,
        /// The map.
        map: String,
        /// Why not.
        #[source]
        source: Box<dyn Error + Send + Sync>,
    },
    /// Tracks that do not lie on the map.
    #[error(
        "of the tracks none comes near a road of {map}: say with --traffic-offset X,Y where the map's origin is in their \
         file, which for SUMO is the netOffset in the net's <location> ({places})"
    )]
    TracksOffMap {
        /// The map.
        map: String,
        /// Where the tracks lie with the offset that was given, and where the roads.
        places: String,
    },
    /// The simulator went away.
    #[error("the connection to the simulator at {address} is lost: start it again and run the same command")]
    ConnectionLost {
        /// Where it was.
        address: String,
        /// What was noticed.
        #[source]
        source: std::io::Error,
    },
    /// The simulator does not answer.
    #[error("the simulator did not {action} within {} s: start it again and run the same command", limit.as_secs_f64())]
    Timeout {
        /// What it was asked to do, as in "load the map".
        action: &'static str,
        /// How long it was waited for.
        limit: Duration,
    },
    /// Another frame than the next one.
    #[error(
        "the simulator gave frame {got} in place of frame {expected}, so that frames are missing: run the same command \
         again, which begins the video again"
    )]
    FramesDropped {
        /// The frame that was asked for.
        expected: u32,
        /// The frame that came.
        got: u32,
    },
    /// What a simulator elsewhere said or did.
    #[error("the simulator at {address}: {reason}")]
    Remote {
        /// Where it is.
        address: String,
        /// What is wrong.
        reason: String,
        /// Whether the same may go well another time.
        passing: bool,
    },
    /// What a simulator cannot make.
    #[error("this simulator makes no {what}: {instead}")]
    Unsupported {
        /// What was asked for.
        what: String,
        /// What to do.
        instead: &'static str,
    },
    /// The user wants to stop.
    #[error("stopped: what is complete stays, the same command goes on")]
    Interrupted,
    /// Fewer or more pictures than there are cameras.
    #[error("the simulator gave pictures of {got} cameras in place of {expected} for frame {frame}")]
    CamerasMissing {
        /// The frame.
        frame: u32,
        /// Cameras of the scene.
        expected: usize,
        /// Cameras of which pictures came.
        got: usize,
    },
}

impl SimulatorError {
    /// Whether the same may go well another time: a connection broke, frames were lost, nothing came in time.
    pub fn is_passing(&self) -> bool {
        match self {
            Self::ConnectionLost { .. }
            | Self::Timeout { .. }
            | Self::FramesDropped { .. }
            | Self::CamerasMissing { .. } => true,
            Self::Remote { passing, .. } => *passing,
            _ => false,
        }
    }
}

impl From<MapError> for SimulatorError {
    fn from(error: MapError) -> Self {
        match error {
            MapError::Town(TownError::UnknownMap { given, known }) => {
                Self::UnknownMap { map: given, known: known.into_iter().map(str::to_owned).collect() }
            }
            other => Self::Map(other),
        }
    }
}
