//! How much traffic there is to see: the moving vehicles and the people with a box, in each camera of each town, by day.
//! `cargo run --release -p endless_pipeline --example visible_traffic -- --vehicles 60 --seeds 3`.
//!
//! Cameras are taken in pairs, as recipes film them. Boxes are those of the labels, counted in instance images of 640 x 360
//! pixels with a quarter of the pixels that recipes ask for: what has a box there has one at 1280 x 720. All other flags are
//! options of a recipe.
#![expect(clippy::print_stdout, reason = "a report on standard output")]

use endless_annotate::ObjectRecord;
use endless_dataset::RecipeDraft;
use endless_interchange::MapLibrary;
use endless_pipeline::{BuiltinSimulator, MapCatalog, MapUse, Plan, SceneBoxes, Simulator, resolve_recipe};
use endless_world::{Actor, ImageSize, Motion, ObjectClass, SceneCamera, SceneSettings};
use rayon::prelude::*;
use std::error::Error;

const SIZE: ImageSize = ImageSize { width: 640, height: 360 };
/// Seconds between the frames that are looked at.
const EVERY_S: f64 = 2.4;
/// Lane in sight of those cameras that see more than a glimpse of a street: a street of two lanes, 75 m of it.
const STREET_M: f64 = 150.0;
/// Slower than this vehicles stand, m/s.
const STANDS_MPS: f32 = 0.5;

/// What one camera sees in one frame.
#[derive(Debug, Clone, Copy, Default)]
struct View {
    vehicles: f64,
    people: f64,
    /// All vehicles of the scene, seen or not.
    there: f64,
    /// Of those seen, how many stand, and the sum of all their speeds, m/s.
    standing: f64,
    speed_sum_mps: f64,
}

/// All frames of one camera.
#[derive(Clone)]
struct CameraViews {
    name: String,
    /// Lane outside junctions that it sees, metres.
    lanes_m: f64,
    frames: Vec<View>,
}

fn view(scene: &SceneBoxes, objects: &[ObjectRecord]) -> View {
    let is_vehicle = |actor: &&Actor| matches!(actor.motion, Motion::Vehicle(_));
    let there = scene.state.actors.iter().filter(is_vehicle).count() as f64;
    let mut view = View { there, ..View::default() };
    for object in objects.iter().filter(|object| !object.parked) {
        match object.class {
            ObjectClass::Pedestrian => view.people += 1.0,
            ObjectClass::Rider => {}
            _ => {
                let actor = scene.state.actors.iter().find(|actor| actor.id == object.id);
                let speed = match actor.map(|actor| actor.motion) {
                    Some(Motion::Vehicle(motion)) => motion.speed_mps,
                    _ => 0.0,
                };
                view.vehicles += 1.0;
                view.standing += f64::from(u8::from(speed < STANDS_MPS));
                view.speed_sum_mps += f64::from(speed);
            }
        }
    }
    view
}

/// The recipe that the flags ask for, of one town, by day unless they say otherwise; and the number of seeds.
fn asked(arguments: &[String]) -> Result<(RecipeDraft, u64), Box<dyn Error>> {
    let (mut draft, mut seeds) = (RecipeDraft::default(), 1);
    for pair in arguments.chunks(2) {
        let [flag, value] = pair else { return Err(format!("{} needs a value", pair[0]).into()) };
        let key = flag.trim_start_matches("--").replace('-', "_");
        match &*key {
            "seeds" => seeds = value.parse()?,
            _ => draft.set(&key, value)?,
        }
    }
    let day = RecipeDraft {
        videos: Some(1),
        weathers: Some(vec!["clear_sky".to_owned()]),
        times: Some(vec!["afternoon".to_owned()]),
        ..RecipeDraft::default()
    };
    Ok((draft.or(day), seeds))
}

/// The scenes of a map: all its cameras, a few at a time.
fn scenes(draft: &RecipeDraft, map: &str, simulator: &BuiltinSimulator) -> Result<Vec<SceneSettings>, Box<dyn Error>> {
    let draft = RecipeDraft { maps: Some(vec![map.to_owned()]), ..draft.clone() };
    let recipe = resolve_recipe(draft, simulator)?;
    let planned = Plan::new(&recipe, simulator)?.scenes.remove(0);
    let sites = simulator.cameras(map)?;
    let look = planned.cameras[0].look;
    let scene = |(number, sites): (u64, &[endless_world::CameraSite])| SceneSettings {
        cameras: sites.iter().map(|site| SceneCamera { site: site.clone(), look }).collect(),
        size: SIZE,
        seed: planned.seed.wrapping_add(number),
        ..planned.clone()
    };
    Ok((0..).zip(sites.chunks(recipe.cameras_per_scene as usize)).map(scene).collect())
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    if values.is_empty() { 0.0 } else { 0.5 * (values[(values.len() - 1) / 2] + values[values.len() / 2]) }
}

/// A line on what cameras see.
fn report(name: &str, cameras: &[CameraViews]) {
    let frames = || cameras.iter().flat_map(|camera| &camera.frames);
    let of_each = |what: fn(&View) -> f64| -> Vec<f64> {
        cameras.iter().map(|camera| median(camera.frames.iter().map(what).collect())).collect()
    };
    let [vehicles, people] = [of_each(|v| v.vehicles), of_each(|v| v.people)];
    let reach = |of: &[f64], least: f64| of.iter().filter(|n| **n >= least).count();
    let sum = |what: fn(&View) -> f64| frames().map(what).sum::<f64>();
    let seen = sum(|v| v.vehicles).max(1.0);
    let lanes_m = cameras.iter().map(|camera| camera.lanes_m).sum::<f64>();
    let per_km = 1000.0 * vehicles.iter().sum::<f64>() / lanes_m.max(1.0);
    println!(
        "{name:10} {:3} cameras: vehicles {:4.1} of {:3.0} (least {:4.1}, {:3} with 10 or more, {:3} with 20), people {:4.1} \
         (least {:3.1}, {:3} with 5 or more), {:4.1} m/s, {:2.0}% stand, \
         {per_km:.0} vehicles for each kilometre of lane in sight",
        cameras.len(),
        median(vehicles.clone()),
        sum(|v| v.there) / frames().count().max(1) as f64,
        vehicles.iter().copied().fold(f64::INFINITY, f64::min),
        reach(&vehicles, 10.0),
        reach(&vehicles, 20.0),
        median(people.clone()),
        people.iter().copied().fold(f64::INFINITY, f64::min),
        reach(&people, 5.0),
        sum(|v| v.speed_sum_mps) / seen,
        100.0 * sum(|v| v.standing) / seen,
    );
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (draft, seeds) = asked(&arguments)?;
    let simulator = BuiltinSimulator::new(MapLibrary::user());
    let towns = draft.maps.clone().unwrap_or_else(|| endless_town::NAMES.iter().map(ToString::to_string).collect());
    let mut all: Vec<CameraViews> = Vec::new();
    for town in &towns {
        let mut settings = Vec::new();
        for seed in 0..seeds {
            let draft = RecipeDraft { seed: Some(draft.seed.unwrap_or(0) + seed), ..draft.clone() };
            settings.extend(scenes(&draft, town, &simulator)?);
        }
        let cameras = simulator.cameras(town)?;
        let map = simulator.load_map(&MapUse { name: town, cameras: &cameras, videos: &[] })?;
        let stride = (EVERY_S * settings[0].fps).round().max(1.0) as u32;
        let boxes = |scene: &SceneSettings| simulator.scene_boxes(&map, scene, stride, 50 / 4);
        let boxes: Vec<Vec<SceneBoxes>> = settings.par_iter().map(boxes).collect::<Result<_, _>>()?;
        let name = |site: &endless_world::CameraSite| site.name.clone();
        let mut of_town: Vec<CameraViews> =
            cameras.iter().map(|site| CameraViews { name: name(site), lanes_m: 0.0, frames: Vec::new() }).collect();
        for (scene, frames) in settings.iter().zip(&boxes) {
            let lanes_m = simulator.roads_seen_m(&map, scene);
            for (k, camera) in scene.cameras.iter().enumerate() {
                let views = frames.iter().map(|frame| view(frame, &frame.cameras[k].objects));
                let of = of_town.iter_mut().find(|of| of.name == camera.site.name).expect("a camera of the town");
                of.lanes_m = lanes_m[k];
                of.frames.extend(views);
            }
        }
        for camera in &of_town {
            let each = |what: fn(&View) -> f64| median(camera.frames.iter().map(what).collect());
            let [vehicles, people] = [each(|v| v.vehicles), each(|v| v.people)];
            println!(
                "  {town}/{}: {vehicles} vehicles on {:.0} m of lane, {people} people",
                camera.name, camera.lanes_m
            );
        }
        report(town, &of_town);
        all.extend(of_town);
    }
    report("all", &all);
    let streets: Vec<CameraViews> = all.into_iter().filter(|camera| camera.lanes_m >= STREET_M).collect();
    report("streets", &streets);
    Ok(())
}
