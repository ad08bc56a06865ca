//! Three cameras in all fifteen conditions on one picture, a weather a row, morning, afternoon and night side by side:
//! `cargo run --release -p endless_city --example conditions -- docs/conditions.jpg 256x144 [Town02:park ...]`.

mod staged;

use endless_asset::Catalogue;
use endless_city::TownScene;
use endless_world::{ImageSize, TimeOfDay, Weather};
use staged::{draw::draw, sheet};
use std::error::Error;

/// A street, a junction and a square that differ much.
const CAMERAS: [&str; 3] = ["Town02:0", "Town05:1", "Town10HD:5"];

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [out, size, cameras @ ..] = arguments.as_slice() else {
        return Err("usage: conditions OUT.jpg WIDTHxHEIGHT [TOWN:CAMERA ...]".into());
    };
    let size: ImageSize = size.parse()?;
    let cameras: Vec<&str> =
        if cameras.is_empty() { CAMERAS.to_vec() } else { cameras.iter().map(String::as_str).collect() };
    let catalogue = Catalogue::builtin();
    let mut rows = vec![vec![Vec::new(); cameras.len() * TimeOfDay::ALL.len()]; Weather::ALL.len()];
    for (c, camera) in cameras.iter().enumerate() {
        let (map, name) = camera.split_once(':').ok_or("a camera is TOWN:NAME or TOWN:NUMBER")?;
        let town = endless_town::load(map, &catalogue)?;
        let town_scene = TownScene::load(&town, &catalogue)?;
        let number = name.parse().ok().or_else(|| town.cameras.iter().position(|site| site.name == name));
        let site = number.and_then(|n: usize| town.cameras.get(n)).ok_or("no such camera")?;
        for (row, weather) in rows.iter_mut().zip(Weather::ALL) {
            for (t, time) in TimeOfDay::ALL.iter().enumerate() {
                let frame = draw(&town, &town_scene, &catalogue, site, (*weather, *time), sheet::large(size));
                row[t * cameras.len() + c] = frame;
            }
        }
    }
    sheet::save(out, &rows, size, 80)
}
