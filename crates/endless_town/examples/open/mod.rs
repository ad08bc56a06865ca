//! Opens a town by its name, or dresses a map file.

use endless_asset::Catalogue;
use endless_town::{Town, dress_map, load};
use std::{error::Error, fs, io::Write};

pub(crate) fn open(map: &str, catalogue: &Catalogue) -> Result<Town, Box<dyn Error>> {
    if !map.contains('.') {
        return Ok(load(map, catalogue)?);
    }
    let read = if map.ends_with(".xodr") {
        endless_road::opendrive::read(&fs::read_to_string(map)?)?
    } else {
        endless_road::osm::read(&fs::read(map)?, &endless_road::osm::OsmOptions::default())?
    };
    let town = dress_map(map, &read, catalogue)?;
    let triangles: usize = town.meshes.iter().map(|m| m.triangles.len()).sum();
    let (meshes, placements, cameras) = (town.meshes.len(), town.placements.len(), town.cameras.len());
    writeln!(std::io::stderr(), "{}", town.summary)?;
    writeln!(std::io::stderr(), "{meshes} meshes of {triangles} triangles, {placements} placed, {cameras} cameras")?;
    Ok(town)
}
