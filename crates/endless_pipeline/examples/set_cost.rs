//! What the models and the set cost: building all of one scene, moving it, and its memory. A map or two, say:
//! `cargo run --release -p endless_pipeline --example set_cost -- Town02 Town03`.
#![expect(clippy::print_stdout, reason = "it says what it measured")]

use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{Condition, TimeOfDay, Weather};
use std::{error::Error, fs, time::Instant};

/// A scene as people ask for, and a crowded one.
const SCENE: [u32; 2] = [30, 20];
const CROWD: [u32; 2] = [100, 60];
const TICKS: u32 = 150;
const FPS: f64 = 30.0;

fn main() -> Result<(), Box<dyn Error>> {
    let mut maps: Vec<String> = std::env::args().skip(1).collect();
    if maps.is_empty() {
        maps = endless_town::NAMES.iter().map(ToString::to_string).collect();
    }
    for map in &maps {
        of_map(map)?;
    }
    Ok(())
}

fn of_map(map: &str) -> Result<(), Box<dyn Error>> {
    let condition = Condition::of(Weather::ClearSky, TimeOfDay::Morning).into();
    let mut stage = StageCost::begin();
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(map, &catalogue)?;
    let town_cost = stage.next();
    let town_scene = TownScene::load(&town, &catalogue)?;
    let still = town_scene.static_scene();
    let still_cost = stage.next();
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let crowd = |[vehicles, pedestrians]: [u32; 2]| {
        let settings =
            TrafficSettings { vehicles, pedestrians, seed: 1, fps: FPS, condition, ..TrafficSettings::default() };
        Simulation::new(&town.network, &fleet, &town.parked, &settings).expect("few enough")
    };
    let scene = crowd(SCENE);
    stage.next();
    let models = ActorModels::in_town(&town_scene, &catalogue, &scene.state().actors);
    let cast_cost = stage.next();
    let built = [town_cost, still_cost, cast_cost].iter().fold([0.0, 0.0], |a, b| [a[0] + b[0], a[1] + b[1]]);
    let told = |[wall, processors]: [f64; 2]| format!("{wall:.2} s ({processors:.2} s of processors)");
    println!(
        "{map}: {} built: town {}, its geometry {} ({:.1} M triangles placed), models of {} {}; {} MiB at most",
        told(built),
        told(town_cost),
        told(still_cost),
        still.placed_triangles() as f64 / 1e6,
        scene.state().actors.len(),
        told(cast_cost),
        most_memory_mib(),
    );
    drop((scene, models));

    let mut traffic = crowd(CROWD);
    let models = ActorModels::in_town(&town_scene, &catalogue, &traffic.state().actors);
    let (mut moving, mut posing) = ([0.0; 2], [0.0; 2]);
    stage.next();
    for _ in 0..TICKS {
        traffic.tick();
        let state = traffic.state();
        let cost = stage.next();
        std::hint::black_box(models.frame_scene(&state));
        let posed = stage.next();
        for k in 0..2 {
            moving[k] += cost[k];
            posing[k] += posed[k];
        }
    }
    let ms = |seconds: f64| seconds * 1e3 / f64::from(TICKS);
    let population = traffic.population();
    println!(
        "{map}: {} vehicles and {} people: {:.2} ms a tick to move, {:.2} ms to pose ({:.2} and {:.2} ms of processors)",
        population.vehicles_spawned,
        population.pedestrians_spawned,
        ms(moving[0]),
        ms(posing[0]),
        ms(moving[1]),
        ms(posing[1]),
    );
    Ok(())
}

/// Wall time and processor time of stages, seconds.
struct StageCost {
    wall: Instant,
    processors: f64,
}

impl StageCost {
    fn begin() -> Self {
        Self { wall: Instant::now(), processors: processor_seconds() }
    }

    /// Since the last call.
    fn next(&mut self) -> [f64; 2] {
        let now = Self::begin();
        let cost = [(now.wall - self.wall).as_secs_f64(), now.processors - self.processors];
        *self = now;
        cost
    }
}

/// Processor time of all threads, where the system tells it.
fn processor_seconds() -> f64 {
    let of = |thread: fs::DirEntry| -> Option<f64> {
        let told = fs::read_to_string(thread.path().join("schedstat")).ok()?;
        told.split(' ').next()?.parse::<f64>().ok()
    };
    let threads = fs::read_dir("/proc/self/task").into_iter().flatten().flatten();
    threads.filter_map(of).sum::<f64>() / 1e9
}

/// Most memory that was held at once, where the system tells it.
fn most_memory_mib() -> u64 {
    let told = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = told.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    line.and_then(|l| l.trim().split(' ').next()?.parse::<u64>().ok()).unwrap_or(0) / 1024
}
