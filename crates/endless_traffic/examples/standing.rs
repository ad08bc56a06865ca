//! Who stands long, and where: `cargo run -p endless_traffic --release --example standing -- MAP [vehicles] [people]
//! [seconds] [seed] [focus]`; a map is the name of a town or a file, and the focus that many percent on what the first two cameras
//! see. A line for everybody who stood longer than a minute: when and where; of vehicles on which lane, how far from its end, and
//! what governs that end.
#![expect(clippy::print_stdout, reason = "a report on standard output")]

use endless_asset::Catalogue;
use endless_road::osm::{self, OsmOptions};
use endless_road::{RoadNetwork, SignalPhase, TrafficControl, opendrive};
use endless_town::Town;
use endless_traffic::{Fleet, Focus, Simulation, TrafficSettings, View};
use endless_world::{ImageSize, Motion, PinholeCamera};
use glam::DVec2;
use std::error::Error;

const FPS: f64 = 10.0;
const LONG_S: f64 = 60.0;
const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };

fn open(name: &str, catalogue: &Catalogue) -> Result<Town, Box<dyn Error>> {
    let map = if name.ends_with(".xodr") {
        opendrive::read(&std::fs::read_to_string(name)?)?
    } else if name.contains(".osm") {
        osm::read(&std::fs::read(name)?, &OsmOptions::default())?
    } else {
        return Ok(endless_town::load(name, catalogue)?);
    };
    Ok(endless_town::dress_map("map", &map, catalogue)?)
}

/// The lane at a place and what governs its end.
fn place(network: &RoadNetwork, at: DVec2) -> String {
    let nearest =
        network.lanes.iter().map(|l| (l, l.centerline.project(at))).min_by(|a, b| a.1.1.abs().total_cmp(&b.1.1.abs()));
    let Some((lane, (s, t))) = nearest else { return String::new() };
    let control = match lane.end_control {
        TrafficControl::Signal(group) => {
            let shown =
                |phase: &SignalPhase| phase.aspects.iter().find(|(g, _)| *g == group).map(|(_, aspect)| *aspect);
            let programs = network.junctions.iter().filter_map(|j| j.program.as_ref());
            let phases: Vec<_> = programs
                .flat_map(|p| p.phases.iter().filter_map(|phase| Some((phase.duration_s, shown(phase)?))))
                .collect();
            format!("signal {} with phases {phases:?}", group.0)
        }
        other => format!("{other:?}"),
    };
    let next: Vec<u32> = lane.successors.iter().map(|l| l.0).collect();
    format!(
        "lane {} of junction {:?}, {:.1} m before its end, {t:.1} m aside, {:?}, then {next:?}, {control}",
        lane.id.0,
        lane.junction.map(|j| j.0),
        lane.centerline.length() - s,
        lane.turn,
    )
}

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let name = args.first().ok_or("usage: standing MAP [vehicles] [people] [seconds] [seed]")?;
    let number = |i: usize, usual: u32| args.get(i).map_or(Ok(usual), |a| a.parse::<u32>());
    let (vehicles, people, seconds, seed) = (number(1, 30)?, number(2, 20)?, number(3, 240)?, number(4, 0)?);
    let catalogue = Catalogue::builtin();
    let town = open(name, &catalogue)?;
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let views: Vec<View> =
        town.cameras.iter().take(2).map(|site| View::Camera(PinholeCamera::new(site, SIZE))).collect();
    let focus = Focus::new(&town.network, &views, f64::from(number(5, 0)?) / 100.0, &|_, _| true);
    let settings = TrafficSettings {
        vehicles,
        focus,
        pedestrians: people,
        seed: u64::from(seed),
        fps: FPS,
        ..TrafficSettings::default()
    };
    let mut s = Simulation::new(&town.network, &fleet, &town.parked, &settings)?;
    let mut stood = vec![0.0f64; s.state().actors.len()];
    let mut reported = vec![false; stood.len()];
    let mut speed_sum = (0.0, 0.0);
    for _ in 0..(f64::from(seconds) * FPS) as usize {
        if s.state().time_s % 60.0 < 0.5 / FPS && speed_sum.1 > 0.0 {
            println!("{:.0} s: {:.2} m/s in the mean of the minute", s.state().time_s, speed_sum.0 / speed_sum.1);
            speed_sum = (0.0, 0.0);
        }
        s.tick();
        let state = s.state();
        for (k, actor) in state.actors.iter().enumerate() {
            let driven = matches!(actor.motion, Motion::Vehicle(_));
            if driven {
                speed_sum = (speed_sum.0 + f64::from(actor.velocity_mps.length()), speed_sum.1 + 1.0);
            }
            stood[k] = if actor.velocity_mps.length() < 0.1 { stood[k] + 1.0 / FPS } else { 0.0 };
            if stood[k] > LONG_S && !reported[k] {
                reported[k] = true;
                let at = actor.pose.position.as_dvec3().truncate();
                let surface = if driven {
                    place(&town.network, at)
                } else {
                    format!("crossing {:?}, waiting {}", actor.behaviour.crossing, actor.behaviour.waiting)
                };
                println!("{:.0} s: {k}, {:?}, at {at:.1}: {surface}", state.time_s, actor.class);
            }
        }
    }
    let p = s.population();
    let long = reported.iter().filter(|r| **r).count();
    println!("{name}: {} vehicles, {long} stood longer than {LONG_S} s", p.vehicles_spawned);
    Ok(())
}
