//! All cameras of towns on one picture, a town a row, in daylight:
//! `cargo run --release -p endless_render --example contact_sheet -- docs/cameras.jpg 256x144 [Town03 ...]`.

mod staged;

use endless_asset::Catalogue;
use endless_render::{CameraBake, Cast, FrameScene, RenderSettings, StaticScene};
use endless_world::{CameraLook, ImageSize, TimeOfDay, Weather};
use staged::crowd;
use std::error::Error;

/// Frames are drawn larger by this much and shrunk: small pictures without jagged edges.
const FINER: u32 = 2;
/// Frames in a row.
const COLUMNS: usize = 10;
/// Between frames, pixels.
const GAP: usize = 2;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [out, size, towns @ ..] = arguments.as_slice() else {
        return Err("usage: contact_sheet OUT.jpg WIDTHxHEIGHT [TOWN ...]".into());
    };
    let size: ImageSize = size.parse()?;
    let names: Vec<&str> =
        if towns.is_empty() { endless_town::NAMES.to_vec() } else { towns.iter().map(String::as_str).collect() };
    let catalogue = Catalogue::builtin();
    let mut rows = Vec::new();
    for name in names {
        let mut frames = draw(name, size, &catalogue)?;
        while frames.len() > COLUMNS {
            let rest = frames.split_off(COLUMNS);
            rows.push(std::mem::replace(&mut frames, rest));
        }
        rows.push(frames);
    }
    let columns = rows.iter().map(Vec::len).max().unwrap_or(1);
    let (wide, tall) = (size.width as usize, size.height as usize);
    let (width, height) = (columns * (wide + GAP) - GAP, rows.len() * (tall + GAP) - GAP);
    let mut sheet = vec![[20u8, 20, 22]; width * height];
    for (y, row) in rows.iter().enumerate() {
        for (x, frame) in row.iter().enumerate() {
            for (line, pixels) in frame.chunks(wide).enumerate() {
                let start = (y * (tall + GAP) + line) * width + x * (wide + GAP);
                sheet[start..start + wide].copy_from_slice(pixels);
            }
        }
    }
    let encoder = jpeg_encoder::Encoder::new_file(out, 80)?;
    encoder.encode(sheet.as_flattened(), width as u16, height as u16, jpeg_encoder::ColorType::Rgb)?;
    Ok(())
}

/// A frame of every camera of a town.
fn draw(name: &str, size: ImageSize, catalogue: &Catalogue) -> Result<Vec<Vec<[u8; 3]>>, Box<dyn Error>> {
    let town = endless_town::load(name, catalogue)?;
    let still = StaticScene::load(&town, catalogue);
    let large = ImageSize { width: size.width * FINER, height: size.height * FINER };
    let mut frames = Vec::new();
    for site in &town.cameras {
        let settings = RenderSettings {
            weather: Weather::ClearSky,
            time_of_day: TimeOfDay::Afternoon,
            seed: 7,
            size: large,
            gather_rays: 1,
            look: CameraLook::CLEAN,
            fps: 30.0,
            keep_irradiance: false,
        };
        let bake = CameraBake::bake(&still, &settings, site);
        let state = crowd(&town, site.position, catalogue, false);
        let cast = Cast::new(catalogue, &state.actors);
        let image = bake.render(&still, &FrameScene::new(&cast, &state));
        frames.push(shrunk(&image.rgb.data, large));
    }
    eprintln!("{name}: {}", town.cameras.iter().map(|c| c.name.as_str()).collect::<Vec<_>>().join(" "));
    Ok(frames)
}

/// Means of squares of pixels.
fn shrunk(pixels: &[[u8; 3]], size: ImageSize) -> Vec<[u8; 3]> {
    let (width, finer) = (size.width as usize, FINER as usize);
    let mean = |x: usize, y: usize, channel: usize| {
        let square = (0..finer * finer).map(|k| pixels[(y * finer + k / finer) * width + x * finer + k % finer]);
        (square.map(|p| usize::from(p[channel])).sum::<usize>() / (finer * finer)) as u8
    };
    (0..size.height as usize / finer)
        .flat_map(|y| (0..width / finer).map(move |x| (x, y)))
        .map(|(x, y)| [0, 1, 2].map(|channel| mean(x, y, channel)))
        .collect()
}
