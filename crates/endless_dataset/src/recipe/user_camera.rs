//! Cameras that users give in place of a map's own.

use endless_world::LensModel;
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
    /// Horizontal field of view, degrees: 70 where not given, 180 of a fisheye, 360 of an equirectangular lens.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fov: Option<f64>,
    /// Lens: `"pinhole"` where not given, `"fisheye"`, `"equirectangular"` or `"orthographic"`, or a table with its numbers.
    #[serde(default, skip_serializing_if = "LensModel::is_pinhole")]
    pub lens: LensModel,
}
