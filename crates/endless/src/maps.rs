//! `endless maps`.

use anyhow::Result;
use endless_pipeline::MapCatalog;
use std::{io::Write, process::ExitCode};

pub(crate) fn run(catalog: &dyn MapCatalog) -> Result<ExitCode> {
    let mut out = std::io::stdout().lock();
    for map in catalog.maps() {
        writeln!(out, "{map}  {}", catalog.summary(&map)?)?;
        for camera in catalog.cameras(&map)? {
            let [x, y, z] = camera.position;
            let (yaw, down) = (camera.yaw_rad.to_degrees(), camera.down_tilt_rad.to_degrees());
            let fov = camera.horizontal_fov_rad.to_degrees();
            writeln!(
                out,
                "  {:<24} at ({x:.1}, {y:.1}, {z:.1}) m, yaw {yaw:.0}°, {down:.0}° down, field of view {fov:.0}°",
                camera.name
            )?;
        }
    }
    Ok(ExitCode::SUCCESS)
}
