//! Draws a town or a map file from above:
//! `cargo run -p endless_town --release --example topview -- Town03 out.png [pixels [x y metres]]`.

mod open;

use endless_asset::Catalogue;
use endless_town::{top_view, top_view_of};
use glam::Vec2;
use std::{error::Error, fs::File, io::BufWriter};

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let name = args.first().map_or("Town01", String::as_str);
    let path = args.get(1).map_or("topview.png", String::as_str);
    let number = |i: usize| args.get(i).and_then(|a| a.parse::<f32>().ok());
    let pixels = number(2).map_or(1200, |p| p as u32);
    let catalogue = Catalogue::builtin();
    let town = open::open(name, &catalogue)?;
    let picture = match (number(3), number(4), number(5)) {
        (Some(x), Some(y), Some(metres)) => top_view_of(&town, &catalogue, pixels, Vec2::new(x, y), metres),
        _ => top_view(&town, &catalogue, pixels),
    };
    let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), pixels, pixels);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.write_header()?.write_image_data(&picture.concat())?;
    Ok(())
}
