//! Drives a camera along the lane before one of a town's cameras, among actors who stand at its spawn points:
//! `cargo run --release -p endless_city --example drive -- Town03 0 clear_sky afternoon out [1280x720] [frames] [metres a frame]`.

mod staged;

use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_render::{IndirectLight, MovingCamera, RenderSettings};
use endless_town::Town;
use endless_world::math::f64::atan2;
use endless_world::{ImageSize, PinholeCamera, SensorPose, TimeOfDay, Weather, rotation_from_angles};
use glam::DVec3;
use staged::crowd;
use std::{error::Error, path::PathBuf, time::Instant};

/// Of the lens above the lane, metres.
const HEIGHT_M: f64 = 1.5;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [map, camera, weather, time, out, rest @ ..] = arguments.as_slice() else {
        return Err("usage: drive MAP CAMERA WEATHER TIME FOLDER [WIDTHxHEIGHT] [FRAMES] [METRES]".into());
    };
    if std::env::var_os("STAGES").is_some() {
        tracing_subscriber::fmt().with_max_level(tracing::Level::DEBUG).without_time().init();
    }
    let (weather, time): (Weather, TimeOfDay) = (weather.parse()?, time.parse()?);
    let size: ImageSize = rest.first().map_or("1280x720", String::as_str).parse()?;
    let frames: usize = rest.get(1).map_or(Ok(10), |frames| frames.parse())?;
    let step_m: f64 = rest.get(2).map_or(Ok(0.8), |metres| metres.parse())?;
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(map, &catalogue)?;
    let town_scene = TownScene::load(&town, &catalogue)?;
    let still = town_scene.static_scene();
    let near = town.cameras[camera.parse::<usize>()? % town.cameras.len()].position;
    let way: Vec<PinholeCamera> =
        poses(&town, near, frames, step_m).map(|pose| PinholeCamera::at(&pose, size, 80f32.to_radians())).collect();
    let state = crowd(&town, near, &catalogue, time == TimeOfDay::Night || weather == Weather::Rainy);
    let models = ActorModels::new(&catalogue, &state.actors);
    let frame = models.frame_scene(&state);
    let settings = RenderSettings::new(weather, time, 7, size);
    let clock = Instant::now();
    let moving = MovingCamera::new(still, &settings, IndirectLight::Probes, &way);
    eprintln!("light along the way {:.2} s", clock.elapsed().as_secs_f32());
    let clock = Instant::now();
    let pictures: Vec<_> = way.iter().map(|camera| moving.render(still, &frame, camera).rgb).collect();
    eprintln!("frame {:.3} s with all threads", clock.elapsed().as_secs_f64() / frames as f64);
    let folder = PathBuf::from(out);
    std::fs::create_dir_all(&folder)?;
    for (number, picture) in pictures.iter().enumerate() {
        let mut encoder =
            png::Encoder::new(std::fs::File::create(folder.join(format!("{number:03}.png")))?, size.width, size.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_compression(png::Compression::Fast);
        encoder.write_header()?.write_image_data(picture.data.as_flattened())?;
    }
    Ok(())
}

/// Along the lane that is nearest to a place.
fn poses(town: &Town, near: [f32; 3], frames: usize, step_m: f64) -> impl Iterator<Item = SensorPose> {
    let near = DVec3::from_array(near.map(f64::from));
    let distance = |lane: &&endless_road::Lane| {
        let line = &lane.centerline;
        line.position(line.project(near.truncate()).0).distance(near)
    };
    let long = |lane: &&endless_road::Lane| lane.centerline.length() > 30.0;
    let lane = town
        .network
        .lanes
        .iter()
        .filter(long)
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .expect("a town has a lane");
    let line = &lane.centerline;
    (0..frames).map(move |k| {
        let s = (k as f64 * step_m).min(line.length() - 1.0);
        let (here, ahead) = (line.position(s), line.position(s + 1.0));
        let forward = ahead - here;
        let turn = rotation_from_angles(atan2(forward.y, forward.x), 0.0, 0.0);
        SensorPose::still(here + DVec3::Z * HEIGHT_M, turn)
    })
}
