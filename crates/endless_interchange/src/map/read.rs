//! Reads map files of both formats.

use super::{MapError, stored_map::MapFormat};
use endless_road::{RoadMap, opendrive, osm};
use endless_world::DrivingSide;
use std::{fs::File, io::Read, path::Path};

/// Longest file that is read, bytes: the extract of a large country. Maps end at city size long before.
pub(super) const MOST_BYTES: u64 = 2 << 30;

/// The content of a file.
pub(super) fn read_bytes(path: &Path) -> Result<Vec<u8>, MapError> {
    let unreadable = |cause| MapError::Unreadable { path: path.to_owned(), cause };
    let file = File::open(path).map_err(unreadable)?;
    if file.metadata().map_err(unreadable)?.len() > MOST_BYTES {
        return Err(MapError::TooLong { path: path.to_owned() });
    }
    let mut bytes = Vec::new();
    // It may grow meanwhile.
    file.take(MOST_BYTES).read_to_end(&mut bytes).map_err(unreadable)?;
    Ok(bytes)
}

/// Reads a map file that is not kept.
pub(crate) fn read_map(path: &Path) -> Result<RoadMap, MapError> {
    let bytes = read_bytes(path)?;
    parse(&bytes, format_of(&bytes, path)?, None, path)
}

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
