//! Maps for tests of recipes and plans.

use crate::{MapCatalog, MapSource, SimulatorError, SiteRequest};
use endless_world::{CameraSite, LensModel, Mount};

/// Three towns of three, four and five cameras.
pub(crate) struct ThreeTowns;

impl MapSource for ThreeTowns {
    fn maps(&self) -> Vec<String> {
        (1..=3).map(|n| format!("Town0{n}")).collect()
    }

    fn random_map(&self, number: u32) -> Option<String> {
        Some(format!("Random{number}"))
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

    /// Cameras that hang where their seeds say.
    fn draw_sites(&self, scenes: &[SiteRequest]) -> Result<Vec<Option<Vec<CameraSite>>>, SimulatorError> {
        let draw = |scene: &SiteRequest| {
            let site = self.cameras(&scene.map)?.swap_remove(0);
            let seed = scene.seed ^ scene.town_seed.unwrap_or(0);
            let part = |bits: u32| f32::from((seed >> bits) as u16);
            let camera = |camera: u32| CameraSite {
                name: format!("drawn_{camera}"),
                position: [part(0), part(16), 6.0 + camera as f32],
                ..site.clone()
            };
            Ok(Some((0..scene.cameras).map(camera).collect()))
        };
        scenes.iter().map(draw).collect()
    }
}
