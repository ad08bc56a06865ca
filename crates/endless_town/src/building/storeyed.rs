//! Buildings of storeys: houses, terraces, flats, shops, offices, towers, halls and barns share one way of building
//! and differ by their dimensions and their style.

use super::dimensions::{BuildingDesign, BuildingDimensions, FacadeRhythm};
use super::ground_floor::add_ground_front;
use super::kind::BuildingKind;
use super::opening::{WindowDetail, WindowNumbers};
use super::ornament::fire_escape;
use super::relief::{dirt, relief};
use super::style::{Balconies, Massing, PlainWindows};
use super::upper_floors::{add_balcony, dress_window};
use super::wall::{Wall, WallOpening, walls};
use super::{opening, roof_form, special_buildings};
use endless_scene::{Mesh, MeshBuilder};
use endless_world::Stream;

/// Makes the mesh of a building.
pub(crate) fn make(dimensions: &BuildingDimensions, stream: &mut Stream, numbers: &mut WindowNumbers) -> Mesh {
    let finish = dimensions.finish(stream);
    let rhythm = FacadeRhythm::of(finish.style, dimensions.shops, stream);
    make_designed(BuildingDesign { dimensions, finish: &finish, rhythm: &rhythm }, stream, numbers)
}

/// The same of a given design.
pub(super) fn make_designed(design: BuildingDesign<'_>, stream: &mut Stream, numbers: &mut WindowNumbers) -> Mesh {
    let BuildingDesign { dimensions, finish, rhythm } = design;
    let mut mesh = MeshBuilder::new();
    match finish.style.massing {
        Massing::PetrolStation => special_buildings::petrol_station(&mut mesh, dimensions, finish, stream, numbers),
        Massing::Church => special_buildings::church(&mut mesh, dimensions, finish, numbers),
        Massing::ParkingDeck => special_buildings::parking_deck(&mut mesh, dimensions, finish, rhythm),
        Massing::Storeyed => {
            let half = dimensions.width / 2.0;
            let (x, y) = ([-half, half], [0.0, dimensions.depth]);
            for (side, wall) in walls(x, y, 0.0).iter().enumerate() {
                add_wall(&mut mesh, wall, side, design, stream, numbers);
            }
            roof_form::add_roof(&mut mesh, design, (x, y), stream, numbers);
            if dimensions.kind == BuildingKind::House {
                roof_form::add_porch(&mut mesh, dimensions, finish);
            }
        }
    }
    mesh.finish()
}

/// A wall with all its storeys; `side` 0 is the front, 1 right, 2 back, 3 left.
pub(super) fn add_wall(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    side: usize,
    design: BuildingDesign<'_>,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) {
    let BuildingDesign { dimensions, finish, rhythm } = design;
    let front = side == 0;
    let blind = dimensions.party_walls[0] && side == 1 || dimensions.party_walls[1] && side == 3;
    let bays = ((wall.width - 0.8) / rhythm.bay).floor().max(1.0) as usize;
    let pitch = (wall.width - 0.8) / bays as f32;
    let centre = |k: usize| 0.4 + pitch * (k as f32 + 0.5);
    let width = rhythm.window[0].min(pitch - if rhythm.window[0] > 0.9 * rhythm.bay { 0.06 } else { 0.18 });
    let all_round = matches!(dimensions.kind, BuildingKind::Tower | BuildingKind::Office);
    let balconied = |k: usize, storey: u32| {
        let has_some = finish.style.balconies != Balconies::None;
        has_some && storey > 0 && (front && k % 3 == 1 || side == 2 && k % 6 == 2)
    };
    let mut from = 0.0;
    let mut floors = Vec::new();
    for storey in 0..dimensions.storeys {
        let height = if storey == 0 { rhythm.ground } else { rhythm.storey };
        let material = if storey == 0 { finish.base } else { finish.wall };
        let range = [from, from + height];
        let holes: Vec<WallOpening> = (0..bays)
            .filter(|_| !blind)
            .filter(|k| side == 0 || side == 2 || all_round || k % 2 == 0)
            .map(|k| {
                // Behind balconies there are doors.
                let sill = from + if balconied(k, storey) { 0.04 } else { rhythm.sill };
                let top = from + rhythm.sill + rhythm.window[1];
                WallOpening {
                    u: [centre(k) - width / 2.0, centre(k) + width / 2.0],
                    v: [sill, top.min(from + height - 0.25)],
                }
            })
            .collect();
        if front && storey == 0 {
            add_ground_front(mesh, wall, (range, &holes), design, stream, numbers);
        } else {
            wall.pierced(mesh, range, &holes, material);
            let detail = detail_of(finish.style.plain_windows, front, (storey, dimensions.storeys));
            for (k, hole) in holes.iter().enumerate() {
                opening::window(mesh, wall, hole, &finish.joinery, detail, numbers);
                dress_window(mesh, wall, hole, (pitch - width, side, storey), finish, stream);
                let bay = if side == 0 || side == 2 || all_round { k } else { 2 * k };
                if balconied(bay, storey) {
                    add_balcony(mesh, wall, hole, from, finish);
                }
            }
        }
        if storey > 0 {
            floors.push(from);
        }
        from += height;
    }
    if blind {
        return;
    }
    relief(mesh, wall, (side, bays, pitch), design, from);
    if finish.style.fire_escape && front && dimensions.storeys >= 4 && wall.width > 5.0 {
        fire_escape(mesh, wall, wall.width / 2.0, &floors);
    }
    dirt(mesh, wall, side, design, from, stream);
}

/// Windows that cameras may see from near are modelled in full.
fn detail_of(plain: PlainWindows, front: bool, (storey, storeys): (u32, u32)) -> WindowDetail {
    match plain {
        PlainWindows::All => WindowDetail::Plain,
        PlainWindows::OfGroundFloor if storey == 0 => WindowDetail::Plain,
        _ if front && storey < 5 => WindowDetail::Full,
        _ if storeys <= 2 => WindowDetail::Beside,
        _ => WindowDetail::Plain,
    }
}
