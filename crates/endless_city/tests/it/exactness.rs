//! The fixed-camera cache leaves nothing out: frames made with it equal frames traced anew, byte for byte.

use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_render::{CameraBake, Gathering, NeighbourFrames, RenderSettings, render_labels};
use endless_town::Town;
use endless_world::{
    Actor, Behaviour, CameraLook, CameraLookChoice, CameraSite, ClassTag, Distortion, Gait, Image, ImageSize,
    InstanceId, LensModel, Motion, ObjectClass, Outfit, PersonRef, PinholeCamera, Pose, RandomisedPart, RecorderClock,
    SceneRandomisation, SensorFrame, SensorLayers, SignalAspect, SignalState, Stream, TimeOfDay, VehicleLights,
    VehicleModelId, VehicleMotion, VehicleRef, WalkerMotion, Weather, WorldState,
};
use glam::Vec3;
use rayon::prelude::*;
use std::sync::{LazyLock, OnceLock};

pub(crate) const SIZE: ImageSize = ImageSize { width: 129, height: 73 };

/// The shutter is open so long that what moves is blurred.
pub(crate) const BLURRED: CameraLook = CameraLook { shutter_s: 1.0 / 60.0, ..CameraLook::CLEAN };

/// Unit vector of a heading.
fn along(yaw: f32) -> Vec3 {
    let (sin, cos) = endless_world::math::sin_cos(yaw);
    Vec3::new(cos, sin, 0.0)
}

/// Vehicles and people where the camera looks, on lanes and sidewalks, some of them half behind the lens.
fn actors(town: &Town, catalogue: &Catalogue, site: &CameraSite, lights: bool, random: &mut Stream) -> Vec<Actor> {
    let camera = PinholeCamera::new(site, SIZE);
    let near = |p: Vec3| {
        let c = camera.camera_from_world(p);
        c.z > -4.0 && c.length() < 70.0 && c.x.abs() < c.z.max(0.0) + 8.0
    };
    let mut all = Vec::new();
    let mut id = town.parked.len() as u16;
    let mut next = || {
        id += 1;
        InstanceId(id)
    };
    for spawn in &town.network.spawn_points {
        let place = town.network.lane(spawn.lane).centerline.at(spawn.s);
        let position = place.position.as_vec3();
        if !near(position) || all.len() >= 12 || random.chance(0.4) {
            continue;
        }
        let model = VehicleModelId::from_index(random.below(catalogue.vehicles().len()));
        let spec = &catalogue.vehicles()[model.index()].spec;
        let mut lit = VehicleLights::empty();
        if lights {
            lit |= VehicleLights::LOW_BEAM | VehicleLights::POSITION | VehicleLights::INTERIOR;
        }
        lit |= if random.chance(0.5) { VehicleLights::BRAKE } else { VehicleLights::LEFT_BLINKER };
        all.push(Actor {
            id: next(),
            rider_id: spec.ridden.then(&mut next),
            class: spec.class,
            asset: VehicleRef { model, variant: random.next_u64() }.into(),
            pose: Pose::level(position, place.heading_rad as f32 + random.range_f32(-0.2, 0.2)),
            velocity_mps: along(place.heading_rad as f32) * 9.0,
            motion: Motion::Vehicle(VehicleMotion {
                speed_mps: 9.0,
                rolled_m: random.f32() * 9.0,
                steer_rad: 0.2,
                hitch_rad: 0.25,
                lights: lit,
            }),
            behaviour: Behaviour::default(),
            parked: false,
        });
    }
    for edge in &town.network.walk.edges {
        let [a, b] = edge.nodes.map(|n| town.network.walk.nodes[n.index()].as_vec3());
        let position = a.lerp(b, random.f32());
        if !near(position) || all.len() >= 24 {
            continue;
        }
        let (variant, yaw) = (random.next_u64(), random.range_f32(-3.0, 3.0));
        all.push(Actor {
            id: next(),
            rider_id: None,
            class: ObjectClass::Pedestrian,
            asset: PersonRef { outfit: Outfit::Fair, seed: variant }.into(),
            pose: Pose::level(position, yaw),
            velocity_mps: along(yaw) * 1.3,
            motion: Motion::Walker(WalkerMotion {
                speed_mps: 1.3,
                gait: Gait::Walk,
                walked_m: random.f32() * 3.0,
                time_s: 1.0,
                footing: None,
                ..WalkerMotion::default()
            }),
            behaviour: Behaviour::default(),
            parked: false,
        });
    }
    all
}

/// In the layers that are there if wanted.
fn differing_layers(a: &SensorFrame, b: &SensorFrame) -> usize {
    fn count<T: PartialEq>(a: Option<&Image<T>>, b: Option<&Image<T>>) -> usize {
        let (a, b) = (a.into_iter().flat_map(|image| &image.data), b.into_iter().flat_map(|image| &image.data));
        a.zip(b).filter(|(p, q)| p != q).count()
    }
    count(a.normals.as_ref(), b.normals.as_ref())
        + count(a.albedo.as_ref(), b.albedo.as_ref())
        + count(a.shadow.as_ref(), b.shadow.as_ref())
        + count(a.body_parts.as_ref(), b.body_parts.as_ref())
}

pub(crate) fn differing(a: &SensorFrame, b: &SensorFrame) -> usize {
    let rgb = a.rgb.data.iter().zip(&b.rgb.data).filter(|(p, q)| p != q).count();
    let depth = a.depth.data.iter().zip(&b.depth.data).filter(|(p, q)| p.to_bits() != q.to_bits()).count();
    let labels = a.instance.data.iter().zip(&b.instance.data).filter(|(p, q)| p != q).count();
    rgb + depth + labels + differing_layers(a, b)
}

/// Its vehicles are shaped once for all tests.
pub(crate) static CATALOGUE: LazyLock<Catalogue> = LazyLock::new(Catalogue::builtin);

pub(crate) struct LoadedTown {
    pub(crate) town: Town,
    pub(crate) scene: TownScene,
}

impl LoadedTown {
    /// What moves before a camera, and signals in all states.
    pub(crate) fn staged(&self, site: &CameraSite, seed: u64, lights: bool) -> (ActorModels, WorldState) {
        let Self { town, .. } = self;
        let mut random = Stream::named(5, "exactness", &[seed]);
        let actors = actors(town, &CATALOGUE, site, lights, &mut random);
        let aspects = [SignalAspect::Red, SignalAspect::Green, SignalAspect::Yellow, SignalAspect::RedYellow];
        let signals =
            (0..town.network.signal_groups).map(|i| SignalState { aspect: aspects[usize::from(i) % 4] }).collect();
        (ActorModels::new(&CATALOGUE, &actors), WorldState { frame: 4, time_s: 0.1, actors, signals })
    }
}

fn load(map: &str) -> LoadedTown {
    let town = endless_town::load(map, &CATALOGUE).expect("a built-in town");
    let scene = TownScene::load(&town, &CATALOGUE).expect("few parked vehicles");
    LoadedTown { town, scene }
}

/// A town that several tests look at, loaded once.
pub(crate) fn shared(name: &str) -> &'static LoadedTown {
    static TOWNS: [(&str, OnceLock<LoadedTown>); 4] = [
        ("Town02", OnceLock::new()),
        ("Town03", OnceLock::new()),
        ("Town05", OnceLock::new()),
        ("Town10HD", OnceLock::new()),
    ];
    let (_, town) = TOWNS.iter().find(|(known, _)| *known == name).expect("a town that is shared");
    town.get_or_init(|| load(name))
}

/// A camera over a square of Town03 and the street beside it.
const SQUARE: usize = 7;
/// One beside its highway.
const HIGHWAY: usize = 4;

pub(crate) fn town03() -> &'static LoadedTown {
    shared("Town03")
}

/// Renders a scene both ways; returns how many pixels moving things changed, so that a test cannot pass on an empty
/// street.
fn check(loaded: &LoadedTown, camera: usize, weather: Weather, time_of_day: TimeOfDay) -> usize {
    check_through(BLURRED, loaded, camera, weather, time_of_day)
}

fn check_through(
    look: CameraLook,
    loaded: &LoadedTown,
    camera: usize,
    weather: Weather,
    time_of_day: TimeOfDay,
) -> usize {
    let settings = RenderSettings { look, ..RenderSettings::new(weather, time_of_day, 3, SIZE) };
    check_site(&settings, loaded, &loaded.town.cameras[camera], camera as u64)
}

fn check_site(settings: &RenderSettings, loaded: &LoadedTown, site: &CameraSite, seed: u64) -> usize {
    let LoadedTown { town, scene, .. } = loaded;
    let (map, still) = (&town.name, scene.static_scene());
    let settings = RenderSettings {
        gathering: Gathering::Interpolated { rays: 2 },
        keep_irradiance: true,
        layers: SensorLayers::ALL,
        ..settings.clone()
    };
    let look = settings.look;
    let (weather, time_of_day) = (settings.weather.weather, settings.weather.time_of_day);
    let bake = CameraBake::bake(still, &settings, site);
    let lights = time_of_day == TimeOfDay::Night || weather == Weather::Rainy;
    let (models, state) = loaded.staged(site, seed, lights);
    let frame = models.frame_scene(&state);
    let (cached, traced) = (bake.render(still, &frame), bake.render_uncached(still, &frame));
    assert_eq!(differing(&cached, &traced), 0, "{map} {weather} {time_of_day}: pixels that differ");
    let at_once = bake.render_at_once(still, &frame, NeighbourFrames::default());
    assert!(at_once == cached, "{map} {weather} {time_of_day}: by all threads");
    let labels = render_labels(still, &frame, bake.camera(), settings.layers);
    assert!((&labels.depth, &labels.instance) == (&cached.depth, &cached.instance), "{map}: without light");
    assert!((&labels.normals, &labels.body_parts) == (&cached.normals, &cached.body_parts), "{map}: without light");
    let empty = |frame| models.frame_scene(&WorldState { frame, actors: Vec::new(), ..state.clone() });
    let alone = bake.render(still, &empty(state.frame));
    if weather != Weather::Rainy && look.noise == 0.0 && look.clock.is_none() {
        let later = bake.render(still, &empty(state.frame + 1));
        assert_eq!(differing(&alone, &later), 0, "{map} {weather} {time_of_day}: what stands still flickers");
    }
    differing(&cached, &alone)
}

#[test]
fn clear_morning_with_long_shadows() {
    assert!(check(town03(), 0, Weather::ClearSky, TimeOfDay::Morning) > 150);
}

#[test]
fn clear_afternoon() {
    assert!(check_through(CameraLook::CLEAN, town03(), 2, Weather::ClearSky, TimeOfDay::Afternoon) > 150);
    assert!(check(shared("Town10HD"), 1, Weather::ClearSky, TimeOfDay::Afternoon) > 150);
}

#[test]
fn rainy_night_with_headlights_and_mirrors() {
    let wet = CameraLook { droplets: 9, ..BLURRED };
    assert!(check_through(wet, town03(), 0, Weather::Rainy, TimeOfDay::Night) > 150);
}

#[test]
fn clear_night() {
    assert!(check(shared("Town05"), 0, Weather::ClearSky, TimeOfDay::Night) > 150);
}

#[test]
fn after_rain_with_puddles() {
    assert!(check(shared("Town02"), 2, Weather::AfterRain, TimeOfDay::Afternoon) > 150);
}

#[test]
fn foggy_night_with_halos() {
    assert!(check(&load("Town01"), 0, Weather::Foggy, TimeOfDay::Night) > 150);
}

#[test]
fn randomised_scenes_before_cameras_askew() {
    let town = town03();
    for (camera, time) in (0..).zip([TimeOfDay::Afternoon, TimeOfDay::Night]) {
        let randomised = SceneRandomisation::new(RandomisedPart::ALL, 1.0, time, 9);
        let settings = RenderSettings { randomised, ..RenderSettings::new(Weather::AfterRain, time, 3, SIZE) };
        let site = CameraSite { roll_rad: 0.09, ..town.town.cameras[camera].clone() };
        assert!(check_site(&settings, town, &site, 1) > 150);
    }
}

#[test]
fn all_other_conditions() {
    use TimeOfDay::{Afternoon, Morning, Night};
    use Weather::{AfterRain, Cloudy, Foggy, Rainy};
    let towns = [
        ("Town04", [(Cloudy, Morning), (Rainy, Afternoon), (AfterRain, Morning)]),
        ("Town06", [(Cloudy, Afternoon), (Foggy, Morning), (AfterRain, Night)]),
        ("Ladera", [(Cloudy, Night), (Rainy, Morning), (Foggy, Afternoon)]),
    ];
    towns.into_par_iter().for_each(|(map, conditions)| {
        let loaded = load(map);
        for (camera, (weather, time)) in (1..).zip(conditions) {
            // Fog may hide all that moves.
            assert!(check(&loaded, camera, weather, time) > 30, "{map} {weather} {time}");
        }
    });
}

#[test]
fn through_lenses_that_distort() {
    for (seed, (loaded, camera)) in (0..).zip([(town03(), 0), (town03(), 2), (shared("Town10HD"), 1)]) {
        let mut random = Stream::named(seed, "camera look", &[]);
        let clock = RecorderClock::new(TimeOfDay::Afternoon, None, &mut random);
        let look = CameraLook::new(CameraLookChoice::Random, TimeOfDay::Afternoon, clock, &mut random);
        let look = CameraLook { distortion: Distortion::barrel(-0.25), ..look };
        assert!(check_through(look, loaded, camera, Weather::ClearSky, TimeOfDay::Afternoon) > 150);
    }
}

#[test]
fn a_fisheye_of_more_than_half_of_all_directions() {
    let lens = LensModel::Fisheye { k: [-0.01, 0.002, 0.0, 0.0] };
    for (camera, weather, time) in [(0, Weather::ClearSky, TimeOfDay::Morning), (2, Weather::Rainy, TimeOfDay::Night)] {
        let site =
            CameraSite { lens, horizontal_fov_rad: 190f32.to_radians(), ..town03().town.cameras[camera].clone() };
        assert!(check_behind(&site, weather, time) > 60, "{weather} {time}");
    }
}

#[test]
fn all_round_the_camera() {
    let (lens, horizontal_fov_rad) = (LensModel::Equirectangular, 360f32.to_radians());
    for (camera, weather, time) in [(0, Weather::ClearSky, TimeOfDay::Afternoon), (1, Weather::Foggy, TimeOfDay::Night)]
    {
        // Turned, so that what the picture's edges cut lies on the street.
        let site = town03().town.cameras[camera].clone();
        let site = CameraSite { lens, horizontal_fov_rad, yaw_rad: site.yaw_rad + 3.0, down_tilt_rad: 0.1, ..site };
        assert!(check_behind(&site, weather, time) > 20, "{weather} {time}");
    }
}

#[test]
fn parallel_rays_from_above() {
    let lens = LensModel::Orthographic { width_m: 70.0 };
    for (tilt, weather, time) in [
        (std::f32::consts::FRAC_PI_2, Weather::ClearSky, TimeOfDay::Morning),
        (1.1, Weather::AfterRain, TimeOfDay::Night),
        (0.9, Weather::Rainy, TimeOfDay::Afternoon),
    ] {
        let site = town03().town.cameras[0].clone();
        let [x, y, z] = site.position;
        let ahead = along(site.yaw_rad) * if tilt > 1.5 { 25.0 } else { 0.0 };
        let site = CameraSite { lens, down_tilt_rad: tilt, position: [x + ahead.x, y + ahead.y, z + 30.0], ..site };
        assert!(check_behind(&site, weather, time) > 60, "{tilt} {weather} {time}");
    }
}

/// In the town of the site.
fn check_behind(site: &CameraSite, weather: Weather, time: TimeOfDay) -> usize {
    let settings = RenderSettings { look: BLURRED, ..RenderSettings::new(weather, time, 3, SIZE) };
    check_site(&settings, town03(), site, 1)
}

#[test]
fn the_shutter_blurs_light_and_nothing_else() {
    let LoadedTown { town, scene } = shared("Town05");
    let still = scene.static_scene();
    let settings = RenderSettings {
        gathering: Gathering::Interpolated { rays: 2 },
        ..RenderSettings::new(Weather::Cloudy, TimeOfDay::Morning, 3, SIZE)
    };
    let actors = actors(town, &CATALOGUE, &town.cameras[HIGHWAY], false, &mut Stream::named(5, "blur", &[]));
    let models = ActorModels::new(&CATALOGUE, &actors);
    let state = WorldState { frame: 0, time_s: 0.0, actors, signals: Vec::new() };
    let frame = models.frame_scene(&state);
    let image = |look| {
        let settings = RenderSettings { look, ..settings.clone() };
        CameraBake::bake(still, &settings, &town.cameras[HIGHWAY]).render(still, &frame)
    };
    let (sharp, blurred) = (image(CameraLook::CLEAN), image(CameraLook { shutter_s: 1.0 / 30.0, ..CameraLook::CLEAN }));
    let differ = |n: usize| sharp.rgb.data[n] != blurred.rgb.data[n];
    assert!((0..SIZE.pixels()).filter(|&n| differ(n)).count() > 100);
    assert_eq!(sharp.instance.data, blurred.instance.data);
    assert_eq!(sharp.depth.data, blurred.depth.data);
    // What moves out of its pixels gives as much light as it had: no ghosts, no holes.
    let mean = |f: &SensorFrame| f.rgb.data.iter().flatten().map(|&v| f64::from(v)).sum::<f64>() / SIZE.pixels() as f64;
    assert!((mean(&sharp) - mean(&blurred)).abs() < 1.5, "{} {}", mean(&sharp), mean(&blurred));
}

#[test]
fn labels_of_moving_things_are_theirs() {
    let LoadedTown { town, scene } = town03();
    let still = scene.static_scene();
    let settings = RenderSettings {
        gathering: Gathering::Interpolated { rays: 2 },
        ..RenderSettings::new(Weather::Cloudy, TimeOfDay::Afternoon, 3, SIZE)
    };
    let bake = CameraBake::bake(still, &settings, &town.cameras[SQUARE]);
    let mut random = Stream::named(5, "labels", &[]);
    let actors = actors(town, &CATALOGUE, &town.cameras[SQUARE], false, &mut random);
    let models = ActorModels::new(&CATALOGUE, &actors);
    let state = WorldState { frame: 0, time_s: 0.0, actors, signals: Vec::new() };
    let image = bake.render(still, &models.frame_scene(&state));
    let mut seen = 0;
    for (label, depth) in image.instance.data.iter().zip(&image.depth.data) {
        let actor = state.actors.iter().find(|a| a.id == label.id);
        let rider = state.actors.iter().find(|a| a.rider_id == Some(label.id));
        match (actor, rider) {
            (Some(actor), _) => assert_eq!(label.tag, actor.class.tag()),
            (None, Some(_)) => assert_eq!(label.tag, ClassTag::Rider),
            (None, None) => assert!(usize::from(label.id.0) <= town.parked.len()),
        }
        seen += usize::from(actor.is_some());
        assert!(*depth > 0.0 && *depth <= endless_world::FAR_PLANE_M);
        assert_eq!(label.tag == ClassTag::Sky, *depth == endless_world::FAR_PLANE_M);
    }
    assert!(seen > 40, "{seen}");
}
