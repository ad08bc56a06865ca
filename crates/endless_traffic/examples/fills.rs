//! How maps fill: of thirty vehicles and twenty people that are asked for, how many there are, and how many of the vehicles
//! move in the first second: `cargo run -p endless_traffic --release --example fills -- [FILE...]`, `.xodr` or OpenStreetMap;
//! without any, the towns.
#![expect(clippy::print_stdout, reason = "a report on standard output")]

use endless_asset::Catalogue;
use endless_road::osm::{self, OsmOptions};
use endless_road::{RoadNetwork, opendrive};
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{Actor, Motion};
use std::error::Error;

/// Who comes further than this in a second moves, metres.
const MOVES_M: f32 = 0.2;

fn tell(name: &str, network: &RoadNetwork) -> Result<(), Box<dyn Error>> {
    let catalogue = Catalogue::builtin();
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let mut traffic = Simulation::new(network, &fleet, &[], &TrafficSettings::default())?;
    let before = traffic.state();
    (0..10).for_each(|_| traffic.tick());
    let after = traffic.state();
    let there = |actor: &&Actor| matches!(actor.motion, Motion::Vehicle(_));
    let moves = |actor: &&Actor| {
        let then = after.actors.iter().find(|other| other.id == actor.id);
        then.is_none_or(|then| then.pose.position.distance(actor.pose.position) > MOVES_M)
    };
    let (borders, population) = (network.borders(), traffic.population());
    println!(
        "{:<28} {:>6} {:>8} {:>7} {:>9} {:>9} {:>6} {:>7}",
        name,
        network.lanes.len(),
        borders.entries.len(),
        borders.exits.len(),
        population.vehicle_capacity,
        before.actors.iter().filter(there).count(),
        before.actors.iter().filter(there).filter(moves).count(),
        population.pedestrians_spawned,
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let columns = ["map", "lanes", "entries", "exits", "capacity", "vehicles", "move", "people"];
    let [map, lanes, entries, exits, capacity, vehicles, moving, people] = columns;
    println!("{map:<28} {lanes:>6} {entries:>8} {exits:>7} {capacity:>9} {vehicles:>9} {moving:>6} {people:>7}");
    let files: Vec<String> = std::env::args().skip(1).collect();
    if files.is_empty() {
        let catalogue = Catalogue::builtin();
        for name in endless_town::NAMES {
            tell(name, &endless_town::load(name, &catalogue)?.network)?;
        }
    }
    for file in &files {
        let map = if file.ends_with(".xodr") {
            opendrive::read(&std::fs::read_to_string(file)?)?
        } else {
            osm::read(&std::fs::read(file)?, &OsmOptions::default())?
        };
        let name = file.rsplit('/').next().unwrap_or(file);
        tell(name, &map.network)?;
    }
    Ok(())
}
