//! Writes every built-in town as OpenDRIVE: `export_opendrive FOLDER`.
#![expect(clippy::print_stdout, reason = "a program")]

use endless_asset::Catalogue;
use endless_road::{RoadMap, opendrive};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1).ok_or("usage: export_opendrive FOLDER")?;
    let catalogue = Catalogue::builtin();
    for name in endless_town::NAMES {
        let town = endless_town::load(name, &catalogue)?;
        let map = RoadMap { network: town.network, ..RoadMap::default() };
        let path = Path::new(&folder).join(format!("{name}.xodr"));
        std::fs::write(&path, opendrive::write(&map, name))?;
        println!("{}: {} lanes", path.display(), map.network.lanes.len());
    }
    Ok(())
}
