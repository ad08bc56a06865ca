//! All cameras of towns on one picture, a town a row, in daylight:
//! `cargo run --release -p endless_city --example contact_sheet -- docs/cameras.jpg 256x144 [Town03 ...]`.

mod staged;

use endless_asset::Catalogue;
use endless_city::TownScene;
use endless_world::{ImageSize, TimeOfDay, Weather};
use staged::{draw::draw, sheet};
use std::error::Error;

/// Frames in a row.
const COLUMNS: usize = 10;

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
        let town = endless_town::load(name, &catalogue)?;
        let town_scene = TownScene::load(&town, &catalogue)?;
        let condition = (Weather::ClearSky, TimeOfDay::Afternoon);
        let of = |site| draw(&town, &town_scene, &catalogue, site, condition, sheet::large(size));
        let mut frames: Vec<Vec<[u8; 3]>> = town.cameras.iter().map(of).collect();
        while frames.len() > COLUMNS {
            let rest = frames.split_off(COLUMNS);
            rows.push(std::mem::replace(&mut frames, rest));
        }
        rows.push(frames);
        eprintln!("{name}: {}", town.cameras.iter().map(|c| c.name.as_str()).collect::<Vec<_>>().join(" "));
    }
    sheet::save(out, &rows, size, 80)
}
