//! What a frame of a planned scene costs, on one thread, and a fingerprint of its pixels:
//! `cargo run --release -p endless_pipeline --example frame_cost -- OUT/scenes/0001.json [FRAMES] [STRIDE]`.

use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_render::{CameraBake, Gathering, RenderSettings};
use endless_traffic::{Fleet, Focus, Simulation, TrafficSettings, View};
use endless_world::{Condition, PinholeCamera, SceneCamera, SceneSettings};
use std::{error::Error, hash::Hasher, time::Duration};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [scene, rest @ ..] = arguments.as_slice() else {
        return Err("usage: frame_cost SCENE.json [FRAMES] [STRIDE]".into());
    };
    let number = |i: usize, otherwise: u32| rest.get(i).map_or(Ok(otherwise), |n| n.parse());
    let (frames, stride) = (number(0, 10)?, number(1, 15)?);
    let settings: SceneSettings = serde_json::from_str(&std::fs::read_to_string(scene)?)?;
    let SceneSettings { weather, time_of_day, vehicles, pedestrians, seed, fps, size, .. } = settings;
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(&settings.map, &catalogue)?;
    let town_scene = TownScene::load(&town, &catalogue)?;
    let still = town_scene.static_scene();
    // One gathered ray: the light is noisy, the cost of a frame is the same.
    let bake = |SceneCamera { site, look }: &SceneCamera| {
        let render = RenderSettings {
            gathering: Gathering::Interpolated { rays: 2 },
            look: *look,
            fps,
            ..RenderSettings::new(weather, time_of_day, seed, size)
        };
        CameraBake::bake(still, &render, site)
    };
    let baked: Vec<CameraBake> = settings.cameras.iter().map(bake).collect();
    let views: Vec<View> =
        settings.usual_sites().map(|site| View::Camera(PinholeCamera::new(site, settings.size))).collect();
    let focus = Focus::new(&town.network, &views, settings.focus, &|_, _| true);
    let condition = Condition::of(weather, time_of_day).into();
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let asked = TrafficSettings { vehicles, pedestrians, seed, fps, condition, focus, ..TrafficSettings::default() };
    let mut traffic = Simulation::new(&town.network, &fleet, &town.parked, &asked)?;
    let models = ActorModels::in_town(&town_scene, &catalogue, &traffic.state().actors);
    let (mut scene_time, mut times) = (Duration::ZERO, vec![Duration::ZERO; baked.len()]);
    let mut print = std::hash::DefaultHasher::new();
    for _ in 0..frames {
        for _ in 0..stride {
            traffic.tick();
        }
        let state = traffic.state();
        let begin = processor_time();
        let frame = models.frame_scene(&state);
        scene_time += processor_time().saturating_sub(begin);
        for (camera, time) in baked.iter().zip(&mut times) {
            let image = camera.render(still, &frame);
            print.write(image.rgb.data.as_flattened());
            // The least of five: other programs only add to it.
            let again = (0..5).map(|_| {
                let begin = processor_time();
                camera.render(still, &frame);
                processor_time().saturating_sub(begin)
            });
            *time += again.min().unwrap_or_default();
        }
    }
    let each = |t: Duration| t.as_secs_f64() * 1e3 / f64::from(frames);
    let cameras: Vec<String> = times.into_iter().map(|time| format!("{:.1}", each(time))).collect();
    eprintln!(
        "{} {weather} {time_of_day}: scene {:.1} ms, cameras {} ms a frame, pixels {:016x}",
        settings.map,
        each(scene_time),
        cameras.join(" and "),
        print.finish()
    );
    Ok(())
}

/// Processor time of this thread, where the system tells it.
fn processor_time() -> Duration {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    Duration::from_nanos(told.and_then(|s| s.split(' ').next()?.parse().ok()).unwrap_or(0))
}
