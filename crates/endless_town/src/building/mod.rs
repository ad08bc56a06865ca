//! Buildings: walls with openings, roofs, and what stands out from them, as meshes.

mod dimensions;
mod finish;
mod freeform;
mod ground_floor;
mod kind;
mod lot;
mod opening;
mod ornament;
mod palette;
mod relief;
mod roof;
mod roof_form;
mod rooftop;
mod special_buildings;
mod storeyed;
mod style;
mod style_table;
#[cfg(test)]
mod tests;
mod upper_floors;
mod wall;

pub(crate) use dimensions::BuildingDimensions;
pub(crate) use freeform::{BuildingOutline, house, on_rectangle};
pub(crate) use kind::BuildingKind;
pub(crate) use lot::{eaves, size, storeys};
pub(crate) use opening::WindowNumbers;
pub(crate) use style_table::LATIN;

use endless_scene::Mesh;
use endless_world::Stream;
use style::BuildingStyle;

/// Names of the building styles.
pub fn building_styles() -> Vec<&'static str> {
    style_table::STYLES.iter().map(|style| style.name).collect()
}

/// A building of a style by its name, as it might stand on a lot of its own: front along x at y = 0 looking towards
/// −y. `None` if there is no such style.
pub fn sample_building(style: &str, seed: u64) -> Option<Mesh> {
    let style: &BuildingStyle = style_table::STYLES.into_iter().find(|known| known.name == style)?;
    let (kind, usual) = (style.kind, style.storeys);
    let mut stream = Stream::named(seed, "town/sample building", &[]);
    let (width, depth) = lot::size(kind, &mut stream);
    let storeys = if usual > 3 { usual - 1 + stream.below(3) as u32 } else { usual };
    let shops = style.often_has_shops && stream.chance(0.5);
    let (width, depth) = (width as f32, depth as f32);
    let dimensions =
        BuildingDimensions { kind, style: Some(style), width, depth, storeys, shops, party_walls: [false; 2] };
    Some(storeyed::make(&dimensions, &mut stream, &mut WindowNumbers::default()))
}
