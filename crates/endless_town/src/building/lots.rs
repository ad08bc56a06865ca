//! Lots along streets: which building stands where.

use super::storeyed::Measures;
use crate::camera::Solid;
use crate::character::{Character, Kind};
use crate::network::{KERB_HEIGHT_M, Plan, Street};
use crate::plot::{Occupied, Rect, crosses, inside};
use crate::surface;
use endless_world::{Stream, math};
use glam::DVec2;

/// A building on its lot.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Lot {
    pub(crate) measures: Measures,
    /// Middle of the front wall.
    pub(crate) front: DVec2,
    /// Direction of the front wall, so that the lot lies to its left.
    pub(crate) angle_rad: f64,
    pub(crate) footprint: Rect,
    pub(crate) seed: u64,
    /// From the sidewalk to the front wall.
    pub(crate) set_back: f64,
}

impl Lot {
    /// The building as sight sees it; roofs may rise above its walls.
    pub(crate) fn solid(&self) -> Solid {
        let top = KERB_HEIGHT_M + 3.6 * f64::from(self.measures.storeys) + 1.0;
        Solid { outline: self.footprint.corners().to_vec(), base: KERB_HEIGHT_M, top }
    }
}

/// Distance kept between footprints and sidewalks, metres.
const BEHIND_SIDEWALK_M: f64 = 0.12;
/// Depth of houses' porches.
const PORCH_M: f64 = 1.4;

/// Fills both sides of every street, as far as there is room.
pub(crate) fn lay(character: &Character, plan: &Plan, occupied: &mut Occupied) -> Vec<Lot> {
    let blocks = surface::blocks(plan);
    let outline = surface::outline(plan);
    let mut lots = Vec::new();
    // Main streets first: they take the corners.
    let mut order: Vec<usize> = (0..plan.streets.len()).collect();
    order.sort_by_key(|&i| std::cmp::Reverse(plan.streets[i].profile.priority));
    for index in order {
        let street = &plan.streets[index];
        for side in [1.0, -1.0] {
            let mut stream = Stream::named(character.seed, "town/lots", &[index as u64, (side > 0.0).into()]);
            let mut s = 2.0;
            while s < street.length() - 6.0 {
                let row = Row { character, street, side, blocks: &blocks, outline: &outline };
                match row.next_lot(s, occupied, &mut stream) {
                    Some((lot, end)) => {
                        if let Some(lot) = lot {
                            occupied.take(lot.footprint.grown(eaves(lot.measures.kind)));
                            lots.push(lot);
                        }
                        s = end;
                    }
                    None => s += 2.0,
                }
            }
        }
    }
    for i in 0..lots.len() {
        lots[i].measures.party_walls = [1.0, -1.0].map(|side| has_neighbour(&lots, i, side));
    }
    lots
}

/// Whether another building stands right beside a lot's right (+1) or left (−1) wall.
fn has_neighbour(lots: &[Lot], i: usize, side: f64) -> bool {
    let own = &lots[i].footprint;
    let centre = own.centre + own.axis * (side * (own.half.x + 0.3));
    let beside = Rect { centre, half: DVec2::new(0.25, own.half.y * 0.8), axis: own.axis };
    lots.iter().enumerate().any(|(k, other)| k != i && other.footprint.meets(&beside))
}

struct Row<'a> {
    character: &'a Character,
    street: &'a Street,
    side: f64,
    blocks: &'a [Vec<DVec2>],
    outline: &'a [DVec2],
}

impl Row<'_> {
    /// A building whose front begins at `s` (or an open lot), and where the next may begin; `None` if there is no
    /// room.
    fn next_lot(&self, s: f64, occupied: &Occupied, stream: &mut Stream) -> Option<(Option<Lot>, f64)> {
        let weights: Vec<f64> = self.character.kinds.iter().map(|k| self.weight(s, k.0) * k.1).collect();
        let kind = self.character.kinds[stream.weighted(&weights)].0;
        let (mut width, mut depth) = size(kind, stream);
        let gap = match kind {
            Kind::Terrace => 0.02,
            Kind::House => stream.range_f64(2.5, 5.0),
            Kind::Office | Kind::Tower => stream.range_f64(0.5, 3.0),
            _ => stream.range_f64(3.0, 7.0),
        };
        if stream.chance(self.character.open_lots) {
            return Some((None, s + width + gap));
        }
        let set_back = match kind {
            Kind::Terrace => 0.0,
            Kind::House => stream.range_f64(3.5, 7.5),
            Kind::Flats => stream.range_f64(2.0, 6.0),
            Kind::Shop => stream.range_f64(1.0, 6.0),
            Kind::Office | Kind::Tower => stream.range_f64(0.3, 2.5),
            Kind::Hall | Kind::Barn => stream.range_f64(5.0, 9.0),
        };
        let (low, high) = self.character.storeys;
        let storeys = storeys(kind, low, high, stream);
        let shops = kind == Kind::Terrace && self.street.profile.priority >= 3 && stream.chance(0.8)
            || kind == Kind::Office && stream.chance(0.6);
        let seed = stream.next_u64();
        for _ in 0..3 {
            let lot = self.lot(s, (width, depth), set_back, kind);
            if self.fits(&lot, kind, occupied) {
                let party_walls = [false; 2];
                let (width, depth) = (width as f32, depth as f32);
                let measures = Measures { kind, manner: None, width, depth, storeys, shops, party_walls };
                let (front, footprint, angle_rad) = lot;
                let bulge = if kind == Kind::House { PORCH_M } else { 0.0 };
                let lot =
                    Lot { measures, front, angle_rad, footprint, seed, set_back: set_back + bulge + BEHIND_SIDEWALK_M };
                return Some((Some(lot), s + f64::from(width) + gap));
            }
            width *= 0.86;
            depth *= 0.84;
        }
        None
    }

    /// How well a kind suits this place: high buildings in the middle, houses outside.
    fn weight(&self, s: f64, kind: Kind) -> f64 {
        let out = self.street.point(s, 0.0).length() as f32;
        let central = f64::from(1.0 - math::smoothstep(60.0, 230.0, out));
        match kind {
            Kind::Tower | Kind::Office => 0.25 + 1.4 * central,
            Kind::Terrace | Kind::Shop => 0.5 + central,
            Kind::House | Kind::Barn | Kind::Hall => 1.4 - central,
            Kind::Flats => 1.0,
        }
    }

    fn lot(&self, s: f64, (width, depth): (f64, f64), set_back: f64, kind: Kind) -> (DVec2, Rect, f64) {
        let middle = s + width / 2.0;
        let profile = &self.street.profile;
        let heading = self.street.heading(middle);
        // Seen from the street the lot lies behind its front: turn the right-hand side's fronts about.
        let angle = if self.side > 0.0 { heading } else { heading + std::f64::consts::PI };
        let bulge = if kind == Kind::House { PORCH_M } else { 0.0 };
        let away = profile.back() + BEHIND_SIDEWALK_M + set_back + bulge;
        let front = self.street.point(middle, self.side * away);
        let mut footprint = Rect::new(front, DVec2::new(width / 2.0, depth / 2.0), angle);
        footprint.centre += footprint.axis.perp() * (depth / 2.0);
        (front, footprint, angle)
    }

    fn fits(&self, (_, footprint, _): &(DVec2, Rect, f64), kind: Kind, occupied: &Occupied) -> bool {
        if footprint.half.x < 2.6 || !occupied.is_free(&footprint.grown(eaves(kind))) {
            return false;
        }
        let corners = footprint.corners();
        let clear = |outline: &[DVec2]| !crosses(outline, &footprint.grown(0.1));
        let outside = corners.iter().all(|&c| !inside(self.outline, c));
        if outside {
            return clear(self.outline);
        }
        self.blocks.iter().any(|block| corners.iter().all(|&c| inside(block, c)) && clear(block))
    }
}

/// Width and depth, metres.
pub(crate) fn size(kind: Kind, stream: &mut Stream) -> (f64, f64) {
    let (w, d) = match kind {
        Kind::House => ((8.5, 12.5), (8.0, 10.5)),
        Kind::Terrace => ((6.5, 12.0), (10.0, 13.0)),
        Kind::Flats => ((17.0, 27.0), (11.0, 14.0)),
        Kind::Shop => ((13.0, 22.0), (11.0, 17.0)),
        Kind::Office => ((15.0, 24.0), (13.0, 17.0)),
        Kind::Tower => ((18.0, 24.0), (16.0, 20.0)),
        Kind::Hall => ((22.0, 34.0), (16.0, 24.0)),
        Kind::Barn => ((9.0, 12.0), (14.0, 20.0)),
    };
    (stream.range_f64(w.0, w.1), stream.range_f64(d.0, d.1))
}

pub(crate) fn storeys(kind: Kind, low: u32, high: u32, stream: &mut Stream) -> u32 {
    let between = |stream: &mut Stream, a: u32, b: u32| a + stream.below((b - a + 1) as usize) as u32;
    match kind {
        Kind::House => between(stream, 1, 2),
        Kind::Terrace => between(stream, low, high),
        Kind::Flats => between(stream, low + 1, high + 1),
        Kind::Shop => 1 + u32::from(stream.chance(0.25)),
        Kind::Office => between(stream, low.max(3), high + 2),
        Kind::Tower => between(stream, 12, 20),
        Kind::Hall => 2,
        Kind::Barn => 1,
    }
}

/// How far roofs reach beyond the walls; terraces stand wall to wall.
pub(crate) fn eaves(kind: Kind) -> f64 {
    match kind {
        Kind::House | Kind::Barn => 0.55,
        Kind::Terrace => 0.0,
        _ => 0.15,
    }
}
