//! Buildings of storeys: houses, terraces, flats, shops, offices, towers, halls and barns share one way of building
//! and differ by their measures and their manner.

use super::ground::add_ground_front;
use super::kind::BuildingKind;
use super::manner::Manner;
use super::opening::{Detail, WindowNumbers};
use super::ornament::{cables, downpipe, fire_escape, graffito, posters};
use super::style::Style;
use super::upper::{add_balcony, dress_window};
use super::wall::{Hole, Wall, walls};
use super::{opening, special, top};
use endless_scene::{Mesh, MeshBuilder};
use endless_world::Stream;
use glam::Vec2;

/// The measures of a building. Its frame: x along the front, y into the lot, the front wall at y = 0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Measures {
    pub(crate) kind: BuildingKind,
    /// How it is built, where that is known; drawn otherwise.
    pub(crate) manner: Option<Manner>,
    pub(crate) width: f32,
    pub(crate) depth: f32,
    pub(crate) storeys: u32,
    /// Shops on the ground floor.
    pub(crate) shops: bool,
    /// Whether a neighbour stands right beside its right and its left wall.
    pub(crate) party_walls: [bool; 2],
}

impl Measures {
    /// The manner and the materials.
    pub(super) fn style(&self, stream: &mut Stream) -> Style {
        let drawn = Manner::draw(self.kind, self.storeys, self.shops, stream);
        Style::draw(self.manner.unwrap_or(drawn), stream)
    }
}

/// The rhythm of a facade.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rhythm {
    bay: f32,
    window: [f32; 2],
    sill: f32,
    pub(super) storey: f32,
    pub(super) ground: f32,
}

impl Rhythm {
    pub(super) fn of(manner: Manner, shops: bool, stream: &mut Stream) -> Self {
        let (bay, window, sill, storey) = match manner {
            Manner::Cottage | Manner::Villa | Manner::Weatherboard => (2.6, [1.25, 1.35], 0.9, 2.8),
            Manner::TimberFrame => (1.9, [0.95, 1.15], 0.95, 2.75),
            Manner::TerracedBrick => (2.4, [1.05, 1.6], 0.8, 2.95),
            Manner::OldTown => (2.3, [1.05, 1.75], 0.75, 3.2),
            Manner::Tenement => (2.2, [1.0, 1.7], 0.75, 3.1),
            Manner::Latin => (2.7, [1.15, 1.25], 0.95, 2.8),
            Manner::Balconies => (2.9, [1.6, 1.4], 0.85, 2.85),
            Manner::Panels => (3.0, [1.7, 1.4], 0.85, 2.75),
            Manner::BrickFlats => (2.9, [1.7, 1.35], 0.9, 2.9),
            Manner::ShopRow | Manner::Petrol => (3.0, [1.8, 1.2], 1.0, 3.8),
            Manner::Supermarket => (4.5, [2.4, 1.0], 2.6, 5.2),
            Manner::StoneOffice => (2.7, [1.6, 2.0], 0.8, 3.5),
            Manner::RibbonOffice => (2.9, [2.78, 1.7], 0.95, 3.5),
            Manner::School => (3.2, [2.5, 1.8], 0.9, 3.4),
            Manner::ParkingDeck => (5.0, [4.6, 1.35], 1.05, 2.75),
            Manner::GlassTower => (2.2, [2.12, 3.1], 0.2, 3.5),
            Manner::ConcreteTower => (3.0, [1.9, 1.75], 0.85, 3.2),
            Manner::Warehouse => (5.0, [2.6, 0.9], 1.6, 3.6),
            Manner::Works => (3.4, [2.3, 1.9], 1.2, 3.6),
            Manner::Barn => (4.2, [0.8, 0.8], 1.5, 3.2),
            Manner::Church => (3.6, [1.3, 4.2], 2.2, 7.5),
        };
        let stretch = stream.range_f32(0.94, 1.1);
        let ground = match manner {
            _ if shops => 4.0,
            Manner::GlassTower | Manner::ConcreteTower => 5.0,
            _ => storey,
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
    let style = measures.style(stream);
    let rhythm = Rhythm::of(style.manner, measures.shops, stream);
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
    match style.manner {
        Manner::Petrol => special::petrol_station(&mut mesh, measures, style, stream, numbers),
        Manner::Church => special::church(&mut mesh, measures, style, numbers),
        Manner::ParkingDeck => special::parking_deck(&mut mesh, measures, style, rhythm),
        _ => {
            let half = measures.width / 2.0;
            let (x, y) = ([-half, half], [0.0, measures.depth]);
            let height = rhythm.height(measures.storeys);
            for (side, wall) in walls(x, y, 0.0).iter().enumerate() {
                add_wall(&mut mesh, wall, side, measures, style, rhythm, stream, numbers);
            }
            top::add_roof(&mut mesh, measures, (x, y), height, style, stream, numbers);
            if measures.kind == BuildingKind::House {
                top::add_porch(&mut mesh, measures, style);
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
    let width = rhythm.window[0].min(pitch - if rhythm.window[0] > 0.9 * rhythm.bay { 0.06 } else { 0.18 });
    let all_round = matches!(measures.kind, BuildingKind::Tower | BuildingKind::Office);
    let balconied = |k: usize, storey: u32| {
        let manner = matches!(style.manner, Manner::Balconies | Manner::Panels);
        manner && storey > 0 && (front && k % 3 == 1 || side == 2 && k % 6 == 2)
    };
    let mut from = 0.0;
    let mut floors = Vec::new();
    for storey in 0..measures.storeys {
        let height = if storey == 0 { rhythm.ground } else { rhythm.storey };
        let material = if storey == 0 { style.base } else { style.wall };
        let range = [from, from + height];
        let holes: Vec<Hole> = (0..bays)
            .filter(|_| !blind)
            .filter(|k| side == 0 || side == 2 || all_round || k % 2 == 0)
            .map(|k| {
                // Behind balconies there are doors.
                let sill = from + if balconied(k, storey) { 0.04 } else { rhythm.sill };
                let top = from + rhythm.sill + rhythm.window[1];
                Hole { u: [centre(k) - width / 2.0, centre(k) + width / 2.0], v: [sill, top.min(from + height - 0.25)] }
            })
            .collect();
        if front && storey == 0 {
            add_ground_front(mesh, wall, range, measures, style, &holes, stream, numbers);
        } else {
            wall.pierced(mesh, range, &holes, material);
            let detail = detail_of(style.manner, front, (storey, measures.storeys));
            for (k, hole) in holes.iter().enumerate() {
                opening::window(mesh, wall, hole, &style.joinery, detail, numbers);
                dress_window(mesh, wall, hole, (pitch - width, side, storey), style, stream);
                let bay = if side == 0 || side == 2 || all_round { k } else { 2 * k };
                if balconied(bay, storey) {
                    add_balcony(mesh, wall, hole, from, style);
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
    relief(mesh, wall, (side, bays, pitch), (measures, style, rhythm), from);
    if style.manner == Manner::Tenement && front && measures.storeys >= 4 && wall.width > 5.0 {
        fire_escape(mesh, wall, wall.width / 2.0, &floors);
    }
    dirt(mesh, wall, side, measures, style, from, stream);
}

/// Windows that cameras may see from near are modelled in full.
fn detail_of(manner: Manner, front: bool, (storey, storeys): (u32, u32)) -> Detail {
    match manner {
        Manner::GlassTower => Detail::Plain,
        Manner::Barn if storey == 0 => Detail::Plain,
        _ if front && storey < 5 => Detail::Full,
        _ if storeys <= 2 => Detail::Beside,
        _ => Detail::Plain,
    }
}

/// What stands out from a wall as a whole: plinth, string courses, cornice, pilasters, fins, frames of timber.
fn relief(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (side, bays, pitch): (usize, usize, f32),
    (measures, style, rhythm): (&Measures, &Style, &Rhythm),
    top: f32,
) {
    let front = side == 0;
    if !(front || measures.kind == BuildingKind::Barn) {
        wall.block(mesh, [0.01, wall.width - 0.01], [0.0, 0.35], [0.0, 0.04], style.trim);
    }
    let string = |mesh: &mut MeshBuilder, v: [f32; 2], out: f32| {
        wall.block(mesh, [0.005, wall.width - 0.005], v, [0.0, out], style.accent);
    };
    let pier = |mesh: &mut MeshBuilder, half: f32, v: [f32; 2], out: f32| {
        for k in 0..=bays {
            let u = (0.4 + pitch * k as f32 - half).clamp(0.02, wall.width - 2.0 * half - 0.02);
            wall.block(mesh, [u, u + 2.0 * half], v, [0.0, out], style.accent);
        }
    };
    let ground = rhythm.ground;
    match style.manner {
        Manner::OldTown | Manner::Tenement if front => {
            string(mesh, [ground - 0.12, ground + 0.1], 0.1);
            wall.block(mesh, [0.0, wall.width], [top - 0.34, top - 0.22], [0.0, 0.14], style.accent);
            wall.block(mesh, [0.0, wall.width], [top - 0.12, top - 0.01], [0.0, 0.34], style.accent);
            for k in 0..(wall.width / 0.45) as usize {
                let u = 0.12 + 0.45 * k as f32;
                wall.block(mesh, [u, u + 0.16], [top - 0.22, top - 0.12], [0.0, 0.28], style.accent);
            }
            for u in [0.0, wall.width - 0.42] {
                for k in 0..((top - ground - 0.6) / 0.6) as usize {
                    let (v, w) = (ground + 0.14 + 0.6 * k as f32, if k % 2 == 0 { 0.42 } else { 0.28 });
                    let from = if u == 0.0 { 0.0 } else { wall.width - w };
                    wall.block(mesh, [from, from + w], [v, v + 0.52], [0.0, 0.03], style.accent);
                }
            }
        }
        Manner::TerracedBrick if front => {
            string(mesh, [ground - 0.05, ground + 0.1], 0.06);
            wall.block(mesh, [0.0, wall.width], [top - 0.25, top - 0.02], [0.0, 0.16], style.accent);
        }
        Manner::StoneOffice => {
            string(mesh, [ground - 0.15, ground + 0.15], 0.12);
            string(mesh, [top - 0.35, top - 0.02], 0.26);
            if measures.storeys > 1 {
                pier(mesh, 0.2, [ground + 0.15, top - 0.35], 0.14);
            }
        }
        Manner::RibbonOffice => {
            for storey in 1..measures.storeys {
                let v = ground + rhythm.storey * (storey - 1) as f32;
                string(mesh, [v + 0.06, v + 0.14], 0.10);
                string(mesh, [v + 0.72, v + 0.80], 0.10);
            }
        }
        Manner::GlassTower => {
            pier(mesh, 0.035, [ground, top], 0.16);
            for storey in 1..measures.storeys {
                let v = ground + rhythm.storey * (storey - 1) as f32;
                wall.block(mesh, [0.0, wall.width], [v - 0.08, v + 0.08], [0.0, 0.05], style.accent);
            }
        }
        Manner::ConcreteTower => pier(mesh, 0.28, [ground, top], 0.22),
        Manner::Panels => joints(mesh, wall, (bays, pitch), (ground, rhythm.storey), top, style),
        Manner::BrickFlats => {
            for storey in 0..measures.storeys {
                let v = ground + rhythm.storey * storey as f32;
                string(mesh, [(v - 0.2).min(top - 0.22), (v + 0.02).min(top - 0.01)], 0.03);
            }
        }
        Manner::School => {
            string(mesh, [top - 0.4, top - 0.02], 0.2);
            pier(mesh, 0.14, [2.2, top - 0.4], 0.10);
        }
        Manner::Works => pier(mesh, 0.22, [2.2, top - 0.1], 0.11),
        Manner::TimberFrame => timbers(mesh, wall, (bays, pitch), (ground, rhythm.storey), top, style),
        Manner::Latin if front => string(mesh, [top - 0.15, top - 0.01], 0.12),
        Manner::Villa | Manner::Cottage | Manner::Weatherboard => {
            let w = if style.manner == Manner::Weatherboard { 0.12 } else { 0.0 };
            for u in [0.0, wall.width - w].into_iter().filter(|_| w > 0.0) {
                wall.block(mesh, [u, u + w], [0.0, top], [0.0, 0.03], style.accent);
            }
        }
        _ => {}
    }
}

/// The dark joints between prefabricated panels, and coloured fields below some windows.
fn joints(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (bays, pitch): (usize, f32),
    (ground, storey): (f32, f32),
    top: f32,
    style: &Style,
) {
    let seal = endless_scene::Material { base_color: [0.16, 0.155, 0.15], ..style.wall };
    for k in 0..=bays {
        let u = 0.4 + pitch * k as f32;
        wall.block(mesh, [u - 0.012, u + 0.012], [0.35, top], [0.0, 0.008], seal);
    }
    let mut v = ground;
    let mut number = 0;
    while v < top - 0.5 {
        wall.block(mesh, [0.0, wall.width], [v - 0.012, v + 0.012], [0.0, 0.009], seal);
        for k in (0..bays).filter(|k| (k + number) % 3 == 0) {
            let u = 0.4 + pitch * k as f32;
            wall.block(mesh, [u + 0.1, u + pitch - 0.1], [v + 0.06, v + 0.76], [0.0, 0.03], style.accent);
        }
        v += storey;
        number += 1;
    }
}

/// Posts, rails and braces of dark timber.
fn timbers(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    (bays, pitch): (usize, f32),
    (ground, storey): (f32, f32),
    top: f32,
    style: &Style,
) {
    let out = [0.0, 0.035];
    let mut v = ground;
    while v < top - 0.3 {
        let high = (v + storey).min(top);
        for y in [v - 0.09, v + 0.80, high - 0.22] {
            wall.block(mesh, [0.0, wall.width], [y, y + 0.17], out, style.accent);
        }
        for k in 0..=bays {
            let u = 0.4 + pitch * k as f32;
            wall.block(mesh, [u - 0.08, u + 0.08], [v, high], out, style.accent);
            // Braces in the fields below windows.
            if k < bays && k % 2 == 0 {
                let (a, b) = (Vec2::new(u + 0.1, v + 0.1), Vec2::new(u + pitch - 0.1, v + 0.80));
                wall.bar(mesh, (a, b), 0.13, [0.0, 0.03], style.accent);
                wall.bar(mesh, (Vec2::new(a.x, b.y), Vec2::new(b.x, a.y)), 0.13, [0.0, 0.028], style.accent);
            }
        }
        for u in [0.02, wall.width - 0.2] {
            wall.block(mesh, [u, u + 0.18], [v, high], out, style.accent);
        }
        v += storey;
    }
}

/// Pipes, cables, posters and tags.
fn dirt(
    mesh: &mut MeshBuilder,
    wall: &Wall,
    side: usize,
    measures: &Measures,
    style: &Style,
    top: f32,
    stream: &mut Stream,
) {
    let street = !matches!(measures.kind, BuildingKind::House | BuildingKind::Barn);
    let piped = !matches!(style.manner, Manner::GlassTower | Manner::RibbonOffice | Manner::ConcreteTower);
    if piped && (side == 0 || side == 2) && wall.width > 3.0 {
        downpipe(mesh, wall, 0.03, top - 0.05);
        if wall.width > 14.0 {
            downpipe(mesh, wall, wall.width - 0.14, top - 0.05);
        }
    }
    if style.manner == Manner::Latin && side == 0 {
        cables(mesh, wall, 2.7, stream);
    }
    let blank_foot = side != 0 && street && wall.width > 5.0;
    if blank_foot && measures.storeys <= 6 && stream.chance(0.16) {
        graffito(mesh, wall, wall.width * stream.range_f32(0.05, 0.5), stream);
    } else if blank_foot && stream.chance(0.10) {
        posters(mesh, wall, 0.5, stream);
    }
}
