//! Lists what is wrong with the networks made of files: `faults FILE...`, `.xodr` or OpenStreetMap. A line a kind with
//! its number, then up to five faults with their places.
#![expect(clippy::print_stdout, reason = "a program")]

use endless_road::osm::{self, OsmOptions};
use endless_road::{NetworkFault, NetworkFaultKind, opendrive};
use std::collections::BTreeMap;
use std::error::Error;

fn main() -> Result<(), Box<dyn Error>> {
    for file in std::env::args().skip(1) {
        let map = if file.ends_with(".xodr") {
            opendrive::read(&std::fs::read_to_string(&file)?).map_err(|error| format!("{file}: {error}"))?
        } else {
            osm::read(&std::fs::read(&file)?, &OsmOptions::default()).map_err(|error| format!("{file}: {error}"))?
        };
        let network = &map.network;
        let (lanes, spawns) = (network.lanes.len(), network.spawn_points.len());
        let bays = map.lane_surfaces.iter().filter(|s| s.kind == endless_road::LaneType::Parking).count();
        println!("{file}: {lanes} lanes, {spawns} spawn points, {bays} parking strips");
        let mut by_kind: BTreeMap<NetworkFaultKind, Vec<NetworkFault>> = BTreeMap::new();
        for fault in network.faults() {
            by_kind.entry(fault.kind).or_default().push(fault);
        }
        for (kind, faults) in by_kind {
            println!("  {kind:?}: {}", faults.len());
            for fault in faults.iter().take(5) {
                println!("    ({:.1}, {:.1}) {}", fault.place.x, fault.place.y, fault.text);
            }
        }
    }
    Ok(())
}
