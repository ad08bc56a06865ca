//! What moves has no visible grain: pictures made with other patterns of rays hardly differ there.

use crate::exactness::{CATALOGUE, LoadedTown, shared};
use endless_city::ActorModels;
use endless_render::{CameraBake, RenderSettings};
use endless_world::{
    Actor, Behaviour, CameraSite, ImageSize, InstanceId, LensModel, Motion, Mount, ObjectClass, Pose, TimeOfDay,
    VehicleLights, VehicleModelId, VehicleMotion, VehicleRef, Weather, WorldState,
};
use glam::Vec3;

const SIZE: ImageSize = ImageSize { width: 96, height: 54 };
const PATTERNS: u32 = 8;

/// Standard deviation over patterns of the pixels of a car under a camera, 255ths, in the mean.
fn grain(weather: Weather, time_of_day: TimeOfDay) -> f64 {
    let LoadedTown { town, scene } = shared("Town02");
    let still = scene.static_scene();
    let spawn = town.network.spawn_points[7];
    let place = town.network.lane(spawn.lane).centerline.at(spawn.s);
    let yaw = place.heading_rad as f32;
    let (sin, cos) = endless_world::math::sin_cos(yaw);
    let car = place.position.as_vec3();
    // In front of the car and to its right, six metres up.
    let site = CameraSite {
        name: "close".to_owned(),
        position: (car + Vec3::new(7.0 * cos + 4.0 * sin, 7.0 * sin - 4.0 * cos, 6.0)).to_array(),
        yaw_rad: yaw + std::f32::consts::PI - 0.52,
        down_tilt_rad: 0.6,
        horizontal_fov_rad: 0.9,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    };
    let model = CATALOGUE.vehicles().iter().position(|v| v.spec.class == ObjectClass::Car).expect("a car");
    let model = VehicleModelId::from_index(model);
    let id = InstanceId(60_000);
    let actor = Actor {
        id,
        rider_id: None,
        class: ObjectClass::Car,
        asset: VehicleRef { model, variant: 5 }.into(),
        pose: Pose::level(car, yaw),
        velocity_mps: Vec3::ZERO,
        motion: Motion::Vehicle(VehicleMotion {
            lights: VehicleLights::LOW_BEAM | VehicleLights::POSITION,
            ..VehicleMotion::default()
        }),
        behaviour: Behaviour::default(),
        parked: false,
    };
    let state = WorldState { frame: 0, time_s: 0.0, actors: vec![actor], signals: Vec::new() };
    let models = ActorModels::new(&CATALOGUE, &state.actors);
    let frame = models.frame_scene(&state);
    let images: Vec<_> = (0..PATTERNS)
        .map(|pattern| {
            let settings = RenderSettings { pattern, ..RenderSettings::new(weather, time_of_day, 4, SIZE) };
            CameraBake::bake(still, &settings, &site).render(still, &frame)
        })
        .collect();
    // Not the cars parked around it, which are still.
    let pixels: Vec<usize> = (0..SIZE.pixels()).filter(|&i| images[0].instance.data[i].id == id).collect();
    assert!(pixels.len() > 300, "the car covers {} pixels", pixels.len());
    assert!(images.iter().any(|image| image.rgb != images[0].rgb), "patterns that change nothing prove nothing");
    let deviation = |i: usize, channel: usize| {
        let values: Vec<f64> = images.iter().map(|image| f64::from(image.rgb.data[i][channel])).collect();
        let mean = values.iter().sum::<f64>() / values.len() as f64;
        (values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / (values.len() - 1) as f64).sqrt()
    };
    pixels.iter().flat_map(|&i| [0, 1, 2].map(|c| deviation(i, c))).sum::<f64>() / (3 * pixels.len()) as f64
}

#[test]
fn by_day() {
    let grain = grain(Weather::ClearSky, TimeOfDay::Afternoon);
    assert!(grain < 1.5, "{grain}");
}

#[test]
fn at_night() {
    let grain = grain(Weather::Rainy, TimeOfDay::Night);
    assert!(grain < 1.0, "{grain}");
}
