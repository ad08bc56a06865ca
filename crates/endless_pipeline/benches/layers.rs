//! What each layer costs to render, ms a camera frame on one thread: frames are rendered with and without it by turns, so
//! that a noisy machine disturbs both alike. `cargo bench -p endless_pipeline --bench layers -- Town01`.

use endless_dataset::RecipeDraft;
use endless_interchange::MapLibrary;
use endless_pipeline::{BuiltinSimulator, MapCatalog, MapUse, Plan, SimulationSession, Simulator, resolve_recipe};
use endless_world::SensorLayers;
use std::time::Instant;

/// With one layer after the other.
fn sets() -> [(&'static str, SensorLayers); 7] {
    let none = SensorLayers::default();
    [
        ("none", none),
        ("normals", SensorLayers { normals: true, ..none }),
        ("albedo", SensorLayers { albedo: true, ..none }),
        ("shadow", SensorLayers { shadow: true, ..none }),
        ("body parts", SensorLayers { body_parts: true, ..none }),
        ("flow", SensorLayers { flow: true, ..none }),
        ("both flows", SensorLayers { flow: true, flow_backward: true, ..none }),
    ]
}

/// Milliseconds that a session's next frame takes, for each camera.
fn next_frame(session: &mut dyn SimulationSession<'_>) -> f64 {
    let step = session.tick().expect("built in");
    let start = Instant::now();
    let cameras = step.task.render(&step.state).expect("built in").len();
    start.elapsed().as_secs_f64() * 1e3 / cameras as f64
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

#[expect(clippy::print_stdout, reason = "a bench is there to print")]
fn main() {
    let town = std::env::args().nth(1).filter(|arg| !arg.starts_with('-')).unwrap_or_else(|| "Town01".to_owned());
    let simulator = BuiltinSimulator::new(MapLibrary::builtin());
    let draft = RecipeDraft {
        videos: Some(1),
        maps: Some(vec![town.clone()]),
        weathers: Some(vec!["clear_sky".into()]),
        times: Some(vec!["afternoon".into()]),
        ..RecipeDraft::default()
    };
    let recipe = resolve_recipe(draft, &simulator).expect("a recipe");
    let plan = Plan::new(&recipe, &simulator).expect("a plan");
    let cameras = simulator.cameras(&town).expect("a town");
    let scene = &plan.scenes[0];
    let map = simulator.load_map(&MapUse { name: &town, cameras: &cameras, videos: &[scene] }).expect("a town");
    let open = |wanted| {
        let mut session = simulator.open_session(&map, scene, wanted).expect("a scene");
        session.prepare().expect("bakes");
        session
    };
    let sets = sets();
    let mut sessions = sets.map(|(_, wanted)| open(wanted));
    let alone = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let mut times = sets.map(|_| Vec::new());
    alone.install(|| {
        for frame in 0..scene.frames as usize {
            for turn in 0..sets.len() {
                let set = (frame + turn) % sets.len();
                times[set].push(next_frame(&mut *sessions[set]));
            }
        }
    });
    println!("{town}: {} frames, {:.1} ms without layers", scene.frames, median(times[0].clone()));
    for ((name, _), with) in sets.iter().zip(&times).skip(1) {
        let more = with.iter().zip(&times[0]).map(|(with, without)| with - without).collect();
        println!("{name:12} {:5.1} ms more", median(more));
    }
}
