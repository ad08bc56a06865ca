//! Videos in which weather or time changes: as exact as others, and without jumps.

use crate::exactness::{BLURRED, LoadedTown, SIZE, differing, shared, town03};
use endless_render::{CameraBake, Gathering, NeighbourFrames, RenderSettings};
use endless_world::{
    ActorDensity, ConditionChange, SceneSettings, SceneWeather, SensorFrame, SensorLayers, TimeOfDay, TrafficProfile,
    Weather, WeatherTimeline, WorldState,
};

use TimeOfDay::{Afternoon, Morning, Night};
use Weather::{AfterRain, ClearSky, Foggy, Rainy};

/// As many as a video has by default.
const FRAMES: u32 = 150;

type Named = (Weather, TimeOfDay);

fn timeline(from: Named, to: Named) -> WeatherTimeline {
    WeatherTimeline::of(&SceneSettings {
        video: 0,
        map: "Town03".into(),
        town_seed: None,
        drawn_sites: false,
        weather: from.0,
        time_of_day: from.1,
        sun_elevation_deg: None,
        changing_to: Some(ConditionChange { weather: to.0, time_of_day: to.1 }),
        randomised: None,
        playback: None,
        sensors: Vec::new(),
        cameras: Vec::new(),
        vehicles: 0,
        pedestrians: 0,
        density: ActorDensity::default(),
        focus: 0.8,
        profile: TrafficProfile::default(),
        jaywalking: 0.0,
        groups: 0.0,
        events: Vec::new(),
        size: SIZE,
        fps: 30.0,
        frames: FRAMES,
        seed: 3,
    })
}

fn settings(weather: SceneWeather) -> RenderSettings {
    RenderSettings {
        weather,
        gathering: Gathering::Interpolated { rays: 2 },
        look: BLURRED,
        keep_irradiance: true,
        layers: SensorLayers::ALL,
        ..RenderSettings::new(ClearSky, Afternoon, 3, SIZE)
    }
}

/// Between two key frames: rendered with the cache and without.
fn check(loaded: &LoadedTown, camera: usize, timeline: &WeatherTimeline, key: u32) {
    let (still, site) = (loaded.scene.static_scene(), &loaded.town.cameras[camera]);
    let [before, after] = [key, key + 1].map(|key| CameraBake::bake(still, &settings(timeline.at_key(key)), site));
    let (models, state) = loaded.staged(site, camera as u64, true);
    let frame = models.frame_scene(&state);
    let cached = before.render_changing((&after, 0.4), still, &frame, NeighbourFrames::default());
    assert_eq!(differing(&cached, &before.render_changing_uncached((&after, 0.4), still, &frame)), 0);
    let [first, last] = [&before, &after].map(|bake| bake.render(still, &frame));
    assert!(differing(&cached, &first) > 1000 && differing(&cached, &last) > 1000, "nothing changes");
    assert_eq!(differing(&before.render_changing((&after, 0.0), still, &frame, NeighbourFrames::default()), &first), 0);
    assert_eq!((cached.depth, cached.instance), (last.depth, last.instance));
}

#[test]
fn nightfall_with_headlights_and_some_of_the_lamps_is_exact() {
    let dusk = timeline((ClearSky, Afternoon), (ClearSky, Night));
    let lamps = |key: u32| dusk.at_key(key).lamps_lit;
    let key = (0..dusk.intervals()).find(|&key| lamps(key) > 0.2).expect("lamps are lit");
    assert!(lamps(key + 1) < 1.0, "not all of them at once");
    check(town03(), 0, &dusk, key);
}

#[test]
fn rain_that_sets_in_is_exact() {
    let rain = timeline((ClearSky, Morning), (Rainy, Morning));
    let key = (0..rain.intervals()).find(|&key| rain.at_key(key).rain > 0.3).expect("it rains");
    check(town03(), 2, &rain, key);
}

fn mean_change(a: &SensorFrame, b: &SensorFrame) -> f64 {
    let values = a.rgb.data.as_flattened().iter().zip(b.rgb.data.as_flattened());
    values.map(|(&a, &b)| f64::from(a.abs_diff(b))).sum::<f64>() / (3 * SIZE.pixels()) as f64
}

/// The most that a still picture changes from a frame to the next, in 255ths. Between key frames it changes evenly.
fn fastest(loaded: &LoadedTown, camera: usize, timeline: &WeatherTimeline) -> f64 {
    let (still, site) = (loaded.scene.static_scene(), &loaded.town.cameras[camera]);
    let (models, state) = loaded.staged(site, camera as u64, true);
    let nothing = models.frame_scene(&WorldState { actors: Vec::new(), ..state });
    let settings = |key: u32| RenderSettings {
        keep_irradiance: false,
        layers: SensorLayers::default(),
        ..settings(timeline.at_key(key))
    };
    // As a video is baked.
    let (_, hits) = CameraBake::bake_keeping(still, &settings(0), site);
    let picture = |key: u32| CameraBake::bake_reusing(still, &settings(key), site, &hits).render(still, &nothing);
    let pictures: Vec<SensorFrame> = (0..=timeline.intervals()).map(picture).collect();
    let per_frame = f64::from(timeline.intervals()) / f64::from(FRAMES - 1);
    pictures.windows(2).map(|pair| mean_change(&pair[0], &pair[1]) * per_frame).fold(0.0, f64::max)
}

/// Pictures follow each other, and do change.
fn jumps_nowhere(loaded: &LoadedTown, camera: usize, from: Named, to: Named) {
    let change = fastest(loaded, camera, &timeline(from, to));
    assert!((0.05..1.5).contains(&change), "{from:?} to {to:?}: {change}");
}

#[test]
fn nightfall_jumps_nowhere() {
    jumps_nowhere(town03(), 0, (ClearSky, Afternoon), (ClearSky, Night));
}

#[test]
fn fog_that_lifts_jumps_nowhere() {
    jumps_nowhere(shared("Town02"), 1, (Foggy, Morning), (ClearSky, Morning));
}

#[test]
fn rain_that_sets_in_jumps_nowhere() {
    jumps_nowhere(town03(), 1, (ClearSky, Afternoon), (Rainy, Afternoon));
}

#[test]
fn daybreak_in_fog_jumps_nowhere() {
    jumps_nowhere(shared("Town02"), 2, (AfterRain, Night), (Foggy, Morning));
}
