//! Sweeps a town with actors standing at its spawn points with a LiDAR, and prints how many points a second that makes; the
//! points are drawn as a camera sees them from behind and above, coloured by class, drops of rain and fog white:
//! `cargo run --release -p endless_city --example lidar -- Town03 0 rainy afternoon hdl_64e lidar.png [THREADS]`.

mod staged;

use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_render::RayCaster;
use endless_sensor::{Atmosphere, Lidar, SweepInterval};
use endless_world::{Actor, LidarPoint, LidarPreset, LidarSettings, SceneWeather, SensorPose, TimeOfDay, Weather};
use glam::{DQuat, DVec3, Vec3};
use staged::crowd;
use std::{error::Error, fs::File, time::Instant};

const WIDTH: usize = 1280;
const HEIGHT: usize = 720;
/// As on the roof of KITTI's car.
const HEIGHT_M: f64 = 1.73;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [map, spawn, weather, time, preset, out, ..] = arguments.as_slice() else {
        return Err("usage: lidar MAP SPAWN_POINT WEATHER TIME PRESET OUT.png [THREADS]".into());
    };
    let (weather, time): (Weather, TimeOfDay) = (weather.parse()?, time.parse()?);
    let preset: LidarPreset = preset.parse()?;
    let threads = arguments.get(6).map_or(Ok(2), |threads| threads.parse())?;
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(map, &catalogue)?;
    let town_scene = TownScene::load(&town, &catalogue)?;
    let spawn = &town.network.spawn_points[spawn.parse::<usize>()? % town.network.spawn_points.len()];
    let place = town.network.lane(spawn.lane).centerline.at(spawn.s);
    let state = crowd(&town, place.position.as_vec3().to_array(), &catalogue, false);
    let models = ActorModels::new(&catalogue, &state.actors);
    let frame = models.frame_scene(&state);
    // Who stands where the sensor is carries it.
    let near = |actor: &&Actor| actor.pose.position.distance(place.position.as_vec3()) < 1.0;
    let carrier: Vec<_> = state.actors.iter().filter(near).flat_map(|a| [Some(a.id), a.rider_id]).flatten().collect();
    let caster = RayCaster::new(town_scene.static_scene(), &frame).ignoring(&carrier);
    let lidar = Lidar::new(&LidarSettings::of(preset), 7);
    let atmosphere = Atmosphere::from(&SceneWeather::new(weather, time, 7));
    let turn = DQuat::from_rotation_z(place.heading_rad);
    let now = SensorPose::still(place.position + DVec3::Z * HEIGHT_M, turn);
    // At 10 m/s.
    let before = SensorPose { position: now.position - turn * DVec3::X, ..now };
    let interval = |frame| SweepInterval { before, now, sweep_s: 0.1, frame };
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build()?;
    let sweep = pool.install(|| lidar.sweep(&caster, &atmosphere, &interval(0)));
    const REPEAT: u32 = 20;
    let mut best = f64::INFINITY;
    for number in 1..=REPEAT {
        let clock = Instant::now();
        std::hint::black_box(pool.install(|| lidar.sweep(&caster, &atmosphere, &interval(number))));
        best = best.min(clock.elapsed().as_secs_f64());
    }
    let points = sweep.points.len();
    let drops = sweep.points.iter().filter(|point| point.is_false_return()).count();
    eprintln!(
        "{points} points, {drops} of them drops, in {:.1} ms by {threads} threads: {:.2} million a second",
        best * 1e3,
        points as f64 / best / 1e6
    );
    write_png(out, &drawn(&sweep.points))
}

/// The points as seen from 12 m behind the sensor and 9 m above it, nearer ones larger.
fn drawn(points: &[LidarPoint]) -> Vec<[u8; 3]> {
    const FOCAL: f32 = 700.0;
    let mut image = vec![[12u8; 3]; WIDTH * HEIGHT];
    let mut depths = vec![f32::INFINITY; WIDTH * HEIGHT];
    let (sin, cos) = endless_world::math::sin_cos(0.45);
    for point in points {
        let Vec3 { x, y, z } = point.position + Vec3::new(12.0, 0.0, -9.0);
        let (depth, up) = (x * cos - z * sin, x * sin + z * cos);
        if depth < 1.0 {
            continue;
        }
        let column = WIDTH as f32 / 2.0 - FOCAL * y / depth;
        let row = HEIGHT as f32 / 2.0 - FOCAL * up / depth;
        let size = if depth < 25.0 { 2 } else { 1 };
        let color = if point.is_false_return() { [255; 3] } else { point.tag.color() };
        // Dark classes stay visible.
        let color = color.map(|channel| 40 + (u16::from(channel) * 215 / 255) as u8);
        for (dx, dy) in (0..size * size).map(|i| (i % size, i / size)) {
            let (column, row) = (column as i64 + dx, row as i64 + dy);
            if (0..WIDTH as i64).contains(&column) && (0..HEIGHT as i64).contains(&row) {
                let at = row as usize * WIDTH + column as usize;
                if depth < depths[at] {
                    depths[at] = depth;
                    image[at] = color;
                }
            }
        }
    }
    image
}

fn write_png(path: &str, image: &[[u8; 3]]) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(File::create(path)?, WIDTH as u32, HEIGHT as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(image.as_flattened())?;
    Ok(())
}
