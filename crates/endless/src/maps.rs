//! `endless maps`: lists, previews, imports and exports maps.

use crate::args::{ExportFiles, MapsArgs, MapsCommand};
use crate::file::write;
use anyhow::Result;
use endless_interchange::{ImportOptions, ImportedMap, MapLibrary, MapStatistics};
use std::{io::Write, path::Path, process::ExitCode};

/// Notes on an imported file that are printed; the rest are counted.
const NOTES: usize = 8;

pub(crate) fn run(library: &MapLibrary, args: MapsArgs) -> Result<ExitCode> {
    match args.command.unwrap_or(MapsCommand::List { maps: Vec::new(), cameras: false }) {
        MapsCommand::List { maps, cameras } => list(library, &maps, cameras)?,
        MapsCommand::Preview { map, out } => preview(library, &map, &out)?,
        MapsCommand::Import { file, name, driving_side, replace } => {
            import(library, &file, &ImportOptions { name: name.as_deref(), driving_side, replace })?;
        }
        MapsCommand::Export { map, files } => export(library, &map, &files)?,
    }
    Ok(ExitCode::SUCCESS)
}

fn list(library: &MapLibrary, maps: &[String], cameras: bool) -> Result<()> {
    let mut out = std::io::stdout().lock();
    let all = || library.builtin_names().into_iter().chain(library.imported_names()).collect();
    for map in if maps.is_empty() { all() } else { maps.to_vec() } {
        // One damaged map must not hide the others.
        let town = match library.town(&map) {
            Ok(town) => town,
            Err(error) => {
                writeln!(out, "{map:<16} {error}")?;
                continue;
            }
        };
        writeln!(out, "{}", row(&MapStatistics::of(&town)))?;
        writeln!(out, "{:<16} {}", "", town.summary)?;
        for camera in town.cameras.iter().filter(|_| cameras) {
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
    Ok(())
}

fn row(statistics: &MapStatistics) -> String {
    format!(
        "{:<16} {:.2} km², {} lanes ({:.1} km), {} cameras, {}",
        statistics.name,
        statistics.area_km2,
        statistics.lanes,
        statistics.lane_km,
        statistics.cameras,
        statistics.features.join(", ")
    )
}

fn preview(library: &MapLibrary, map: &str, out: &Path) -> Result<()> {
    let picture = library.preview(map)?;
    write(out, &endless_dataset::encode_png(&picture))
}

fn import(library: &MapLibrary, file: &Path, options: &ImportOptions<'_>) -> Result<()> {
    let ImportedMap { stored, statistics, notes } = library.import(file, options)?;
    let own = file.file_name().is_some_and(|f| f.to_string_lossy().starts_with(&format!("{}.", stored.name)));
    if options.name.is_none() && !own {
        eprintln!("note: the map is called {} (give another with --name)", stored.name);
    }
    for note in notes.iter().take(NOTES) {
        eprintln!("note: {note}");
    }
    if notes.len() > NOTES {
        eprintln!("note: and {} more of the file's parts were not understood or were mended", notes.len() - NOTES);
    }
    let mut out = std::io::stdout().lock();
    writeln!(out, "{}", row(&statistics))?;
    writeln!(out, "film it with: endless generate OUT --maps {}", stored.name)?;
    Ok(())
}

fn export(library: &MapLibrary, map: &str, files: &ExportFiles) -> Result<()> {
    if let Some(path) = &files.opendrive {
        write(path, library.opendrive(map)?.as_bytes())?;
    }
    if let Some(path) = &files.gltf {
        write(path, &library.gltf(map)?)?;
    }
    if let Some(path) = &files.geojson {
        write(path, library.geojson(map)?.as_bytes())?;
    }
    Ok(())
}
