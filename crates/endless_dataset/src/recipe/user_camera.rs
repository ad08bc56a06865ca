//! Cameras that users give in place of a map's own.

use serde::{Deserialize, Serialize};

/// A camera as users write it: metres, degrees.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UserCamera {
    /// The map in which it hangs.
    pub map: String,
    /// Unique in the map.
    pub name: String,
    /// East, north and up, metres, as in `endless maps list --cameras`.
    pub position: [f64; 3],
    /// Counter-clockwise from east, degrees.
    pub yaw: f64,
    /// Below the horizon, degrees.
    pub down: f64,
    /// Horizontal field of view, degrees.
    #[serde(default = "usual_fov")]
    pub fov: f64,
}

fn usual_fov() -> f64 {
    70.0
}
