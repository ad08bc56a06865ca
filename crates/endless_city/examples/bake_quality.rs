//! Bakes cameras in all conditions, or those named, and compares gathering where light varies with gathering at every
//! sample: seconds of both, and how far the pictures are, 255ths in the mean, from one gathered at every sample with
//! sixteen times the rays.
//!
//! ```text
//! cargo run --release -p endless_city --example bake_quality -- 320x180 Town02:0,Altstadt:1,Town07:2 [clear_sky:morning,…] [FOLDER]
//! ```
//! A size followed by `-` leaves the comparison out and times alone. In the folder, if one is named, the pictures are put.
#![expect(clippy::print_stdout, reason = "a table is what it is for")]

use endless_asset::Catalogue;
use endless_city::{ActorModels, TownScene};
use endless_render::{CameraBake, Gathering, RenderSettings, StaticScene};
use endless_world::{CameraSite, ImageSize, SensorFrame, TimeOfDay, Weather, WorldState};
use std::{error::Error, fs::File, path::Path, time::Instant};

/// How many times today's rays the reference has.
const REFERENCE: u32 = 16;

struct Pictures<'a> {
    still: &'a StaticScene,
    site: &'a CameraSite,
    settings: RenderSettings,
}

impl Pictures<'_> {
    /// The still picture, and the seconds of its bake.
    fn baked(&self, gathering: Gathering) -> (SensorFrame, f64) {
        let start = Instant::now();
        let bake = CameraBake::bake(self.still, &RenderSettings { gathering, ..self.settings.clone() }, self.site);
        let seconds = start.elapsed().as_secs_f64();
        let nothing = WorldState { frame: 0, time_s: 0.0, actors: Vec::new(), signals: Vec::new() };
        let frame = ActorModels::new(&Catalogue::builtin(), &[]).frame_scene(&nothing);
        (bake.render(self.still, &frame), seconds)
    }
}

fn difference(a: &SensorFrame, b: &SensorFrame) -> f64 {
    let pairs = a.rgb.data.as_flattened().iter().zip(b.rgb.data.as_flattened());
    pairs.map(|(a, b)| f64::from(a.abs_diff(*b))).sum::<f64>() / (3 * a.rgb.data.len()) as f64
}

fn main() -> Result<(), Box<dyn Error>> {
    tracing_subscriber::fmt().with_max_level(tracing::Level::DEBUG).with_writer(std::io::stderr).init();
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [size, cameras, rest @ ..] = arguments.as_slice() else {
        return Err("usage: bake_quality WIDTHxHEIGHT[-] TOWN:CAMERA,… [WEATHER:TIME,…] [FOLDER]".into());
    };
    let size_only = size.trim_end_matches('-');
    let (compares, size) = (size_only == size, size_only.parse::<ImageSize>()?);
    let conditions = conditions(rest.first().map_or("all", String::as_str))?;
    let catalogue = Catalogue::builtin();
    println!("town camera condition  seconds  at every sample  error  at every sample");
    for camera in cameras.split(',') {
        let (name, index) = camera.split_once(':').ok_or("a camera is TOWN:NUMBER")?;
        let town = endless_town::load(name, &catalogue)?;
        let scene = TownScene::load(&town, &catalogue)?;
        let site = &town.cameras[index.parse::<usize>()? % town.cameras.len()];
        for &(weather, time) in &conditions {
            let settings = RenderSettings::new(weather, time, 7, size);
            let pictures = Pictures { still: scene.static_scene(), site, settings };
            let (fast, seconds) = pictures.baked(Gathering::default());
            print!("{name} {index} {weather} {time}  {seconds:.2}");
            if compares {
                let Gathering::EverySample { rays } = Gathering::EVERY_SAMPLE else { unreachable!("so it is defined") };
                let (plain, slow) = pictures.baked(Gathering::EVERY_SAMPLE);
                let (reference, _) = pictures.baked(Gathering::EverySample { rays: rays * REFERENCE });
                let errors = [&fast, &plain].map(|picture| difference(picture, &reference));
                print!("  {slow:.2}  {:.3}  {:.3}", errors[0], errors[1]);
                if let Some(folder) = rest.get(1) {
                    for (kind, picture) in [("fast", &fast), ("plain", &plain), ("reference", &reference)] {
                        write_png(&Path::new(folder).join(format!("{name}_{weather}_{time}_{kind}.png")), picture)?;
                    }
                }
            }
            println!();
        }
    }
    Ok(())
}

fn conditions(text: &str) -> Result<Vec<(Weather, TimeOfDay)>, Box<dyn Error>> {
    if text == "all" {
        return Ok(Weather::ALL.iter().flat_map(|w| TimeOfDay::ALL.iter().map(|t| (*w, *t))).collect());
    }
    let one = |pair: &str| {
        let (weather, time) = pair.split_once(':').ok_or("a condition is WEATHER:TIME")?;
        Ok((weather.parse()?, time.parse()?))
    };
    text.split(',').map(one).collect()
}

fn write_png(path: &Path, frame: &SensorFrame) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(File::create(path)?, frame.rgb.size.width, frame.rgb.size.height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.write_header()?.write_image_data(frame.rgb.data.as_flattened())?;
    Ok(())
}
