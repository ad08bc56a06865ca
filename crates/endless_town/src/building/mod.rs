//! Buildings: real geometry on lots along the streets.

mod freeform;
mod lots;
mod opening;
mod roof;
mod storeyed;
mod style;
mod wall;

pub(crate) use freeform::{Block, house, on_rectangle};
pub(crate) use lots::{Lot, eaves, size, storeys};
pub(crate) use opening::WindowNumbers;
pub(crate) use storeyed::Measures;

use crate::character::Character;
use crate::network::{KERB_HEIGHT_M, Plan};
use crate::plot::Occupied;
use endless_asset::Mesh;
use endless_world::Stream;
use glam::{Affine3A, Quat};

/// Builds on the lots of a town; each mesh with its place in the world.
pub(crate) fn build(character: &Character, plan: &Plan, occupied: &mut Occupied) -> (Vec<Lot>, Vec<(Mesh, Affine3A)>) {
    let lots = lots::lay(character, plan, occupied);
    let mut numbers = WindowNumbers::default();
    let meshes = lots
        .iter()
        .map(|lot| {
            let mesh = storeyed::make(&lot.measures, &mut Stream::named(lot.seed, "town/building", &[]), &mut numbers);
            let place = Affine3A::from_rotation_translation(
                Quat::from_rotation_z(lot.angle_rad as f32),
                lot.front.extend(KERB_HEIGHT_M).as_vec3(),
            );
            (mesh, place)
        })
        .collect();
    (lots, meshes)
}
