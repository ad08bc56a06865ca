//! Buildings: walls with openings, roofs, and what stands out from them, as meshes.

mod freeform;
mod ground;
mod kind;
mod lot;
mod manner;
mod opening;
mod ornament;
mod roof;
mod rooftop;
mod special;
mod storeyed;
mod style;
#[cfg(test)]
mod tests;
mod top;
mod upper;
mod wall;

pub(crate) use freeform::{Block, house, on_rectangle};
pub(crate) use kind::BuildingKind;
pub(crate) use lot::{eaves, size, storeys};
pub(crate) use manner::Manner;
pub(crate) use opening::WindowNumbers;
pub(crate) use storeyed::Measures;

use endless_scene::Mesh;
use endless_world::Stream;

/// Names of the manners of building.
pub fn building_manners() -> Vec<&'static str> {
    Manner::ALL.iter().map(|m| m.0.name()).collect()
}

/// A building of a manner by its name, as it might stand on a lot of its own: front along x at y = 0 looking towards
/// −y. `None` if there is no such manner.
pub fn sample_building(manner: &str, seed: u64) -> Option<Mesh> {
    let (manner, kind, usual) = Manner::ALL.into_iter().find(|m| m.0.name() == manner)?;
    let mut stream = Stream::named(seed, "town/sample building", &[]);
    let (width, depth) = lot::size(kind, &mut stream);
    let storeys = if usual > 3 { usual - 1 + stream.below(3) as u32 } else { usual };
    let shops = matches!(manner, Manner::OldTown | Manner::Tenement) && stream.chance(0.5);
    let (width, depth) = (width as f32, depth as f32);
    let measures = Measures { kind, manner: Some(manner), width, depth, storeys, shops, party_walls: [false; 2] };
    Some(storeyed::make(&measures, &mut stream, &mut WindowNumbers::default()))
}
