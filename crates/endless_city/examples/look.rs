//! Renders one frame of a town with actors standing at its spawn points, without traffic:
//! `cargo run --release -p endless_city --example look -- Town03 0 rainy night look.png [WIDTHxHEIGHT] [instance.png]`.

mod staged;

use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_render::{CameraBake, RenderSettings};
use endless_world::{ImageSize, TimeOfDay, Weather};
use staged::crowd;
use std::{error::Error, fs::File, path::Path, time::Instant};

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [map, camera, weather, time, out, ..] = arguments.as_slice() else {
        return Err("usage: look MAP CAMERA WEATHER TIME OUT.png [WIDTHxHEIGHT] [INSTANCE.png]".into());
    };
    let (weather, time): (Weather, TimeOfDay) = (weather.parse()?, time.parse()?);
    let size: ImageSize = arguments.get(5).map_or("960x540", String::as_str).parse()?;
    let catalogue = Catalogue::builtin();
    let clock = Instant::now();
    let town = endless_town::load(map, &catalogue)?;
    eprintln!("town {:.2} s", clock.elapsed().as_secs_f32());
    let clock = Instant::now();
    let town_scene = TownScene::load(&town, &catalogue)?;
    let still = town_scene.static_scene();
    eprintln!("scene {:.2} s, {} triangles", clock.elapsed().as_secs_f32(), still.placed_triangles());
    let site = &town.cameras[camera.parse::<usize>()? % town.cameras.len()];
    let clock = Instant::now();
    let settings = RenderSettings::new(weather, time, 7, size);
    let bake = CameraBake::bake(still, &settings, site);
    eprintln!("bake {:.2} s, {} rays", clock.elapsed().as_secs_f32(), bake.stats().rays());
    let state = crowd(&town, site.position, &catalogue, time == TimeOfDay::Night || weather == Weather::Rainy);
    let models = ActorModels::new(&catalogue, &state.actors);
    let clock = Instant::now();
    let frame = models.frame_scene(&state);
    eprintln!("frame scene {:.4} s", clock.elapsed().as_secs_f32());
    const REPEAT: u32 = 20;
    let before = thread_cpu_seconds();
    for _ in 1..REPEAT {
        std::hint::black_box(bake.render(still, &frame));
    }
    let image = bake.render(still, &frame);
    let each = (thread_cpu_seconds() - before) / f64::from(REPEAT);
    eprintln!("frame {each:.3} s on one core, camera {}", site.name);
    write_png(out, size, image.rgb.data.as_flattened())?;
    if let Some(out) = arguments.get(6) {
        let colors: Vec<[u8; 3]> = image
            .instance
            .data
            .iter()
            .map(|p| {
                let [r, g, b] = p.tag.color();
                let turn = (p.id.0 as u8).wrapping_mul(37);
                if p.id.0 == 0 { [r, g, b] } else { [r ^ turn, g ^ turn.rotate_left(3), b] }
            })
            .collect();
        write_png(out, size, colors.as_flattened())?;
    }
    Ok(())
}

/// Processor time of this thread, where the system tells it.
fn thread_cpu_seconds() -> f64 {
    let nanoseconds = std::fs::read_to_string("/proc/thread-self/schedstat")
        .ok()
        .and_then(|s| s.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.unwrap_or(0.0) * 1e-9
}

fn write_png(path: impl AsRef<Path>, size: ImageSize, data: &[u8]) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(File::create(path)?, size.width, size.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(data)?;
    Ok(())
}
