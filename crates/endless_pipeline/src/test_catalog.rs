//! Maps for tests of recipes and plans.

use crate::{MapCatalog, MapSource, SimulatorError};
use endless_world::{CameraSite, LensModel, Mount};

/// Three towns of three, four and five cameras.
pub(crate) struct ThreeTowns;

impl MapSource for ThreeTowns {
    fn maps(&self) -> Vec<String> {
        (1..=3).map(|n| format!("Town0{n}")).collect()
    }
}

impl MapCatalog for ThreeTowns {
    fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
        let count = 2 + map.bytes().last().map_or(0, |b| b - b'0');
        let site = |i| CameraSite {
            name: format!("site_{i}"),
            position: [f32::from(i), 0.0, 6.0],
            yaw_rad: 0.0,
            down_tilt_rad: 0.4,
            horizontal_fov_rad: 1.2,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        Ok((0..count).map(site).collect())
    }
}
