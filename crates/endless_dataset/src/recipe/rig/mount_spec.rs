//! What carries a sensor.

use endless_world::ObjectClass;
use serde::{Deserialize, Serialize};

/// What carries a sensor, as users write it: metres, seconds and degrees. Angles: `yaw` counter-clockwise (from east, or
/// from the carrier's nose), `pitch` nose up, `roll` left side up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(tag = "on", rename_all = "snake_case", deny_unknown_fields)]
pub enum MountSpec {
    /// One of the map's camera sites, with its direction and, for cameras, its field of view.
    Site {
        /// Its name: `endless maps list --cameras` lists them.
        site: String,
    },
    /// A place that does not move.
    Pose {
        /// What positions are measured from.
        #[serde(default)]
        from: Origin,
        /// East, north and up, metres.
        at: [f64; 3],
        /// Degrees.
        #[serde(default)]
        yaw: f64,
        /// Degrees.
        #[serde(default)]
        pitch: f64,
        /// Degrees.
        #[serde(default)]
        roll: f64,
    },
    /// A pole at a corner of a junction.
    Junction {
        /// Which corner, 0 to 3: north-east, north-west, south-west, south-east.
        corner: u32,
        /// Above the sidewalk, metres.
        height: f64,
        /// Degrees; towards the middle of the junction where not given.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        yaw: Option<f64>,
        /// Degrees; towards the ground in the middle of the junction where not given.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        pitch: Option<f64>,
    },
    /// A vehicle of the traffic.
    Vehicle {
        /// Of which class it is.
        #[serde(default)]
        class: CarrierClass,
        /// Which of them: 0 for the one that gets farthest in the video.
        #[serde(default)]
        number: u32,
        /// Forward, left and up from the middle of the vehicle on the ground, metres.
        at: [f64; 3],
        /// Degrees.
        #[serde(default)]
        yaw: f64,
        /// Degrees.
        #[serde(default)]
        pitch: f64,
        /// Degrees.
        #[serde(default)]
        roll: f64,
    },
    /// A person on foot.
    Pedestrian {
        /// Which of them: 0 for the one that gets farthest in the video.
        #[serde(default)]
        number: u32,
        /// Forward, left and up from the ground under the person, metres.
        at: [f64; 3],
        /// Degrees.
        #[serde(default)]
        yaw: f64,
        /// Degrees.
        #[serde(default)]
        pitch: f64,
        /// Degrees.
        #[serde(default)]
        roll: f64,
    },
    /// A drone that flies around a point on the ground and looks at it.
    Orbit {
        /// What positions are measured from.
        #[serde(default)]
        from: Origin,
        /// The point, east and north, metres.
        #[serde(default)]
        centre: [f64; 2],
        /// Horizontal distance from the point, metres.
        radius: f64,
        /// Above the point, metres.
        height: f64,
        /// Time of one round, counter-clockwise, seconds; below 0 for clockwise.
        period: f64,
        /// Where it begins, counter-clockwise from east, degrees.
        #[serde(default)]
        begin: f64,
    },
    /// A drone, or a camera on rails, that goes from point to point.
    WayPoints {
        /// What positions are measured from.
        #[serde(default)]
        from: Origin,
        /// In the order of their times.
        points: Vec<WayPointSpec>,
    },
    /// A camera that pans, tilts and zooms on a site of the map or at a place.
    PanTiltZoom {
        /// A camera site of the map.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        site: Option<String>,
        /// What `at` is measured from.
        #[serde(default)]
        from: Origin,
        /// East, north and up, metres, where no site is given.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        at: Option<[f64; 3]>,
        /// In the order of their times.
        keys: Vec<PanTiltZoomKey>,
    },
}

impl MountSpec {
    /// The words of `on`.
    pub const WORDS: &[&str] =
        &["site", "pose", "junction", "vehicle", "pedestrian", "orbit", "way_points", "pan_tilt_zoom"];
}

/// What positions are measured from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Origin {
    /// The origin of the map; heights are absolute.
    #[default]
    Map,
    /// The middle of the map's largest junction, on the ground.
    Junction,
}

/// The vehicles among which a carrier is chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum CarrierClass {
    /// Whatever drives.
    #[default]
    Any,
    /// Passenger cars.
    Car,
    /// Vans.
    Van,
    /// Lorries.
    Truck,
    /// Buses.
    Bus,
    /// Motorcycles.
    Motorcycle,
    /// Bicycles.
    Bicycle,
}

impl CarrierClass {
    /// The class; `None` for any.
    pub fn object_class(self) -> Option<ObjectClass> {
        Some(match self {
            Self::Any => return None,
            Self::Car => ObjectClass::Car,
            Self::Van => ObjectClass::Van,
            Self::Truck => ObjectClass::Truck,
            Self::Bus => ObjectClass::Bus,
            Self::Motorcycle => ObjectClass::Motorcycle,
            Self::Bicycle => ObjectClass::Bicycle,
        })
    }
}

/// A place on a way.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WayPointSpec {
    /// Since the video's first frame, seconds.
    pub time: f64,
    /// East, north and up, metres.
    pub at: [f64; 3],
    /// Degrees.
    #[serde(default)]
    pub yaw: f64,
    /// Degrees.
    #[serde(default)]
    pub pitch: f64,
    /// Degrees.
    #[serde(default)]
    pub roll: f64,
}

/// Where a camera looks at a time.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PanTiltZoomKey {
    /// Since the video's first frame, seconds.
    pub time: f64,
    /// Degrees.
    pub yaw: f64,
    /// Degrees.
    pub pitch: f64,
    /// Horizontal field of view, degrees.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fov: Option<f64>,
}
