//! Reads map files of both formats.

use super::{MapError, stored_map::MapFormat};
use endless_road::{RoadMap, opendrive, osm};
use endless_world::DrivingSide;
use std::path::Path;

/// The format of a file, by its content.
pub(super) fn format_of(bytes: &[u8], path: &Path) -> Result<MapFormat, MapError> {
    let head = String::from_utf8_lossy(&bytes[..bytes.len().min(4096)]);
    let name = path.file_name().unwrap_or_default().to_string_lossy().to_ascii_lowercase();
    if head.contains("<OpenDRIVE") || name.ends_with(".xodr") {
        Ok(MapFormat::OpenDrive)
    } else if head.contains("<osm") || name.ends_with(".pbf") || name.ends_with(".osm") {
        Ok(MapFormat::Osm)
    } else {
        Err(MapError::Format { path: path.to_owned() })
    }
}

/// Reads a map from a file's content.
pub(super) fn parse(
    bytes: &[u8],
    format: MapFormat,
    side: Option<DrivingSide>,
    path: &Path,
) -> Result<RoadMap, MapError> {
    match format {
        MapFormat::OpenDrive => {
            let map = opendrive::read(&String::from_utf8_lossy(bytes))
                .map_err(|cause| MapError::OpenDrive { path: path.to_owned(), cause })?;
            let says = if map.left_hand { DrivingSide::Left } else { DrivingSide::Right };
            if side.is_some_and(|side| side != says) {
                return Err(MapError::DrivingSide { path: path.to_owned(), side: says.name() });
            }
            Ok(map)
        }
        MapFormat::Osm => osm::read(bytes, &osm::OsmOptions { driving_side: side, ..osm::OsmOptions::default() })
            .map_err(|cause| MapError::Osm { path: path.to_owned(), cause }),
    }
}
