//! Buildings of storeys: houses, terraces, flats, shops, offices, towers, halls and barns share one way of building
//! and differ by their measures.

use super::opening::{Detail, WindowNumbers, door, gate, shop_front, window};
use super::roof::{boxed, chimney, flat, gabled, hipped, plant};
use super::style::Style;
use super::wall::{Hole, Wall, walls};
use crate::character::Kind;
use endless_asset::{Mesh, MeshBuilder};
use endless_world::Stream;

/// The measures of a building. Its frame: x along the front, y into the lot, the front wall at y = 0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measures {
    pub(crate) kind: Kind,
    pub(crate) width: f32,
    pub(crate) depth: f32,
    pub(crate) storeys: u32,
    /// Shops on the ground floor.
    pub(crate) shops: bool,
    /// Whether a neighbour stands right beside its right and its left wall.
    pub(crate) party_walls: [bool; 2],
}

/// The rhythm of a facade.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rhythm {
    bay: f32,
    window: [f32; 2],
    sill: f32,
    storey: f32,
    ground: f32,
}

impl Rhythm {
    pub(super) fn of(kind: Kind, shops: bool, stream: &mut Stream) -> Self {
        let (bay, window, sill, storey) = match kind {
            Kind::House => (2.6, [1.25, 1.3], 0.9, 2.8),
            Kind::Terrace => (2.3, [1.05, 1.65], 0.75, 3.1),
            Kind::Flats => (2.9, [1.6, 1.4], 0.85, 2.85),
            Kind::Shop => (3.0, [1.8, 1.2], 1.0, 3.4),
            Kind::Office => (2.7, [1.7, 1.9], 0.8, 3.5),
            Kind::Tower => (2.9, [2.66, 2.6], 0.55, 3.5),
            Kind::Hall => (5.0, [2.6, 0.9], 1.6, 3.6),
            Kind::Barn => (4.2, [0.8, 0.8], 1.5, 3.2),
        };
        let stretch = stream.range_f32(0.94, 1.1);
        let ground = if shops {
            4.0
        } else if kind == Kind::Tower {
            5.0
        } else {
            storey
        };
        Self { bay: bay * stretch, window, sill, storey, ground }
    }

    /// With storeys of such heights that the eaves are where they are known to be.
    pub(super) fn stretched(self, height: f32, storeys: u32) -> Self {
        let factor = (height / self.height(storeys)).clamp(0.8, 1.5);
        let [w, h] = self.window;
        Self { storey: self.storey * factor, ground: self.ground * factor, window: [w, h * factor.min(1.1)], ..self }
    }

    /// From the ground to the eaves.
    pub(super) fn height(&self, storeys: u32) -> f32 {
        self.ground + self.storey * (storeys.max(1) - 1) as f32
    }
}

/// Makes the mesh of a building.
pub(crate) fn make(measures: &Measures, stream: &mut Stream, numbers: &mut WindowNumbers) -> Mesh {
    let style = Style::draw(measures.kind, stream);
    let rhythm = Rhythm::of(measures.kind, measures.shops, stream);
    make_styled(measures, &style, &rhythm, stream, numbers)
}

/// The same of given materials.
pub(super) fn make_styled(
    measures: &Measures,
    style: &Style,
    rhythm: &Rhythm,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) -> Mesh {
    let mut mesh = MeshBuilder::new();
    let half = measures.width / 2.0;
    let (x, y) = ([-half, half], [0.0, measures.depth]);
    let height = rhythm.height(measures.storeys);
    for (side, wall) in walls(x, y, 0.0).iter().enumerate() {
        add_wall(&mut mesh, wall, side, measures, style, rhythm, stream, numbers);
    }
    add_roof(&mut mesh, measures, (x, y), height, style, stream);
    if matches!(measures.kind, Kind::House) {
        add_porch(&mut mesh, style);
    }
    mesh.finish()
}

pub(super) fn add_wall(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    side: usize,
    measures: &Measures,
    style: &Style,
    rhythm: &Rhythm,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) {
    let front = side == 0;
    let blind = measures.party_walls[0] && side == 1 || measures.party_walls[1] && side == 3;
    let bays = ((wall.width - 0.8) / rhythm.bay).floor().max(1.0) as usize;
    let pitch = (wall.width - 0.8) / bays as f32;
    let centre = |k: usize| 0.4 + pitch * (k as f32 + 0.5);
    let width = rhythm.window[0].min(pitch - 0.18);
    let detail = if front && measures.storeys <= 6 { Detail::Full } else { Detail::Plain };
    let mut from = 0.0;
    for storey in 0..measures.storeys {
        let height = if storey == 0 { rhythm.ground } else { rhythm.storey };
        let material = if storey == 0 { style.base } else { style.wall };
        let range = [from, from + height];
        let holes: Vec<Hole> = (0..bays)
            .filter(|_| !blind)
            .filter(|k| side == 0 || side == 2 || matches!(measures.kind, Kind::Tower | Kind::Office) || k % 2 == 0)
            .map(|k| {
                let sill = from + rhythm.sill;
                Hole {
                    u: [centre(k) - width / 2.0, centre(k) + width / 2.0],
                    v: [sill, (sill + rhythm.window[1]).min(from + height - 0.25)],
                }
            })
            .collect();
        if front && storey == 0 {
            add_ground_front(mesh, wall, range, measures, style, &holes, numbers);
        } else {
            wall.pierced(mesh, range, &holes, material);
            let sparse = measures.kind == Kind::Barn && storey == 0;
            for hole in &holes {
                window(mesh, wall, hole, &style.joinery, if sparse { Detail::Plain } else { detail }, numbers);
            }
            let balconies = measures.kind == Kind::Flats && storey > 0 && front;
            for (k, hole) in holes.iter().enumerate() {
                if balconies && k % 3 == 1 {
                    add_balcony(mesh, wall, hole, from, style);
                }
                if side == 2 && storey > 0 && stream.chance(0.1) {
                    // An air conditioner below the window.
                    let u = hole.u[0] + 0.1;
                    wall.block(mesh, [u, u + 0.8], [hole.v[0] - 0.72, hole.v[0] - 0.12], [0.02, 0.34], style.trim);
                }
            }
        }
        from += height;
    }
    // A plinth where the ground floor does not open on the street, string courses and a cornice.
    if !(front || blind || measures.kind == Kind::Barn) {
        wall.block(mesh, [0.01, wall.width - 0.01], [0.0, 0.35], [0.0, 0.04], style.trim);
    }
    if front && measures.storeys > 1 && !matches!(measures.kind, Kind::Barn | Kind::Hall | Kind::House) {
        let v = rhythm.ground;
        wall.block(mesh, [0.005, wall.width - 0.005], [v - 0.12, v + 0.1], [0.0, 0.1], style.trim);
        wall.block(mesh, [0.0, wall.width], [from - 0.3, from - 0.02], [0.0, 0.22], style.trim);
    }
    if front && measures.kind == Kind::Office {
        for k in 0..=bays {
            let u = (0.4 + pitch * k as f32 - 0.17).clamp(0.02, wall.width - 0.36);
            wall.block(mesh, [u, u + 0.34], [rhythm.ground + 0.1, from - 0.3], [0.0, 0.12], style.trim);
        }
    }
}

/// The street side of the ground floor: shops under a sign and an awning, or windows about a door, or gates.
fn add_ground_front(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    range: [f32; 2],
    measures: &Measures,
    style: &Style,
    holes: &[Hole],
    numbers: &mut WindowNumbers,
) {
    let height = range[1] - range[0];
    match measures.kind {
        Kind::Hall | Kind::Barn => {
            let gates = if measures.kind == Kind::Barn { 1 } else { (wall.width / 9.0).floor().max(1.0) as usize };
            let top = (height - 0.3).min(3.1);
            let pitch = wall.width / gates as f32;
            let openings: Vec<Hole> = (0..gates)
                .map(|k| {
                    let middle = pitch * (k as f32 + 0.5);
                    Hole { u: [middle - 1.9, middle + 1.9], v: [0.02, top] }
                })
                .collect();
            wall.pierced(mesh, range, &openings, style.base);
            for hole in &openings {
                gate(mesh, wall, hole, &style.joinery);
            }
        }
        _ if measures.shops || measures.kind == Kind::Shop => {
            add_shops(mesh, wall, range, measures, style, numbers);
        }
        _ => {
            // The middle window gives way to the door.
            let mut openings = holes.to_vec();
            let entrance = openings.len() / 2;
            let mut door_hole = None;
            if let Some(hole) = openings.get_mut(entrance) {
                let middle = (hole.u[0] + hole.u[1]) / 2.0;
                let wide = if matches!(measures.kind, Kind::House | Kind::Terrace) { 0.52 } else { 0.95 };
                *hole = Hole { u: [middle - wide, middle + wide], v: [0.05, 2.5] };
                door_hole = Some(*hole);
            }
            wall.pierced(mesh, range, &openings, style.base);
            for (k, hole) in openings.iter().enumerate() {
                if k == entrance {
                    door(mesh, wall, hole, &style.joinery, numbers);
                } else {
                    window(mesh, wall, hole, &style.joinery, Detail::Full, numbers);
                }
            }
            if let (Some(hole), false) = (door_hole, measures.kind == Kind::House) {
                let u = [hole.u[0] - 0.35, hole.u[1] + 0.35];
                wall.block(mesh, u, [2.62, 2.74], [0.0, 0.7], style.trim);
            }
        }
    }
}

fn add_shops(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    range: [f32; 2],
    measures: &Measures,
    style: &Style,
    numbers: &mut WindowNumbers,
) {
    let shops = (wall.width / 9.0).round().max(1.0) as usize;
    let pitch = wall.width / shops as f32;
    let openings: Vec<Hole> = (0..shops)
        .map(|k| Hole { u: [pitch * k as f32 + 0.35, pitch * (k + 1) as f32 - 0.35], v: [0.02, 2.75] })
        .collect();
    wall.pierced(mesh, range, &openings, style.base);
    for (k, hole) in openings.iter().enumerate() {
        shop_front(mesh, wall, hole, &style.joinery, numbers);
        wall.block(mesh, [hole.u[0] - 0.1, hole.u[1] + 0.1], [2.95, 3.55], [0.0, 0.16], style.sign);
        if (k + measures.storeys as usize).is_multiple_of(2) {
            add_awning(mesh, wall, hole, style);
        }
    }
}

/// A sloping awning over a shop front, both sides of the cloth.
fn add_awning(mesh: &mut MeshBuilder, wall: &Wall, hole: &Hole, style: &Style) {
    let (u0, u1) = (hole.u[0] - 0.05, hole.u[1] + 0.05);
    let (back, front) = (2.9, 2.42);
    let reach = 1.1;
    let p = |u: f32, v: f32, out: f32| wall.at(u, v, out);
    let top = [p(u0, front, reach), p(u1, front, reach), p(u1, back, 0.01), p(u0, back, 0.01)];
    let drop = 0.03;
    let below =
        [p(u1, front - drop, reach), p(u0, front - drop, reach), p(u0, back - drop, 0.01), p(u1, back - drop, 0.01)];
    let uv = [[0.0, 0.0], [u1 - u0, 0.0], [u1 - u0, 1.2], [0.0, 1.2]].map(glam::Vec2::from_array);
    mesh.quad(top, uv, style.awning);
    mesh.quad(below, uv, style.awning);
    wall.panel(mesh, [u0, u1], [front - 0.25, front], reach, style.awning);
}

/// A slab with a railing of bars in front of a window.
fn add_balcony(mesh: &mut MeshBuilder, wall: &Wall, hole: &Hole, floor: f32, style: &Style) {
    let u = [hole.u[0] - 0.5, hole.u[1] + 0.5];
    let reach = 1.2;
    wall.block(mesh, u, [floor - 0.16, floor], [0.0, reach], style.trim);
    let rail = style.joinery.frame;
    wall.block(mesh, u, [floor + 1.0, floor + 1.05], [reach - 0.06, reach - 0.01], rail);
    wall.block(mesh, u, [floor + 0.08, floor + 0.12], [reach - 0.05, reach - 0.02], rail);
    for end in [u[0], u[1] - 0.05] {
        wall.block(mesh, [end, end + 0.05], [floor + 1.0, floor + 1.05], [0.0, reach - 0.06], rail);
    }
    let bars = ((u[1] - u[0]) / 0.28) as usize;
    for k in 0..=bars {
        let at = u[0] + (u[1] - u[0] - 0.03) * k as f32 / bars as f32;
        wall.block(mesh, [at, at + 0.03], [floor + 0.0, floor + 1.0], [reach - 0.05, reach - 0.02], rail);
    }
}

fn add_roof(
    mesh: &mut MeshBuilder,
    measures: &Measures,
    (x, y): ([f32; 2], [f32; 2]),
    height: f32,
    style: &Style,
    stream: &mut Stream,
) {
    match measures.kind {
        Kind::House => {
            let span = measures.depth.min(measures.width);
            let rise = span * stream.range_f32(0.3, 0.42);
            if stream.chance(0.3) {
                hipped(mesh, (x, y), height, rise, (style.roof, style.trim));
            } else {
                let along = measures.width >= measures.depth || stream.chance(0.4);
                let across = if along { measures.depth } else { measures.width };
                let rise = across * stream.range_f32(0.3, 0.42);
                gabled(mesh, (x, y), height, rise, (along, 0.45, 0.3), (style.roof, style.wall));
            }
            let cx = measures.width * stream.range_f32(-0.3, 0.3);
            chimney(mesh, cx, measures.depth * 0.58, height + 0.2, height + rise + 0.7);
        }
        Kind::Terrace if measures.storeys <= 4 && stream.chance(0.75) => {
            let rise = measures.depth * stream.range_f32(0.26, 0.36);
            gabled(mesh, (x, y), height, rise, (true, 0.3, 0.0), (style.roof, style.wall));
            chimney(mesh, x[0] + 0.6, measures.depth * 0.62, height + 0.3, height + rise + 0.6);
        }
        Kind::Barn => {
            let rise = measures.width * 0.42;
            gabled(mesh, (x, y), height, rise, (false, 0.5, 0.4), (style.roof, style.wall));
        }
        Kind::Hall => {
            flat(mesh, (x, y), height, 0.35, (style.wall, style.trim));
            for k in 1..4 {
                let cx = x[0] + measures.width * k as f32 / 4.0;
                boxed(mesh, [cx - 0.9, cx + 0.9], [3.0, measures.depth - 3.0], [height, height + 0.45], style.trim);
            }
        }
        _ => {
            flat(mesh, (x, y), height, stream.range_f32(0.45, 1.0), (style.wall, style.trim));
            plant(mesh, (x, y), height, stream);
        }
    }
}

/// A step and a little roof on two posts before a house's door.
fn add_porch(mesh: &mut MeshBuilder, style: &Style) {
    boxed(mesh, [-0.9, 0.9], [-1.2, -0.01], [0.0, 0.05], style.trim);
    boxed(mesh, [-1.0, 1.0], [-1.3, -0.01], [2.6, 2.72], style.trim);
    for x in [-0.9, 0.8] {
        boxed(mesh, [x, x + 0.1], [-1.2, -1.1], [0.05, 2.6], style.joinery.frame);
    }
}
