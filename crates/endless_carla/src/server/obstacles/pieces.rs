//! Solid pieces of a prop: a box for each part of it that stands by itself.

use super::band::within_band;
use super::solid::{Part, bit, solid_triangles};
use crate::physics::OrientedBox;
use endless_scene::Mesh;
use endless_world::ClassTag;
use glam::{DVec2, DVec3};

/// Gaps up to this are none, metres.
const GAP_M: f64 = 0.1;

/// A piece while it grows: its smallest and largest corner.
#[derive(Debug, Clone, Copy)]
struct Piece {
    tag: ClassTag,
    classes: u32,
    low: DVec3,
    high: DVec3,
}

impl Piece {
    fn touches(&self, other: &Self) -> bool {
        let (low, high) = (self.low.truncate() - GAP_M, self.high.truncate() + GAP_M);
        low.cmple(other.high.truncate()).all() && other.low.truncate().cmple(high).all()
    }
}

/// The pieces of a prop in its own frame.
pub(super) fn pieces(mesh: &Mesh) -> Vec<Part> {
    let mut pieces: Vec<Piece> = Vec::new();
    for (corners, tag) in solid_triangles(mesh) {
        let polygon = within_band(&corners);
        let Some(&first) = polygon.first() else { continue };
        let (low, high) = polygon.iter().fold((first, first), |(low, high), &at| (low.min(at), high.max(at)));
        let mut grown = Piece { tag, classes: bit(tag), low, high };
        // What it touches becomes one piece with it, and so what that then touches.
        while let Some(place) = pieces.iter().position(|piece| piece.touches(&grown)) {
            let other = pieces.swap_remove(place);
            grown = Piece {
                tag: other.tag,
                classes: grown.classes | other.classes,
                low: grown.low.min(other.low),
                high: grown.high.max(other.high),
            };
        }
        pieces.push(grown);
    }
    pieces.into_iter().map(part).collect()
}

fn part(piece: Piece) -> Part {
    // A sheet without thickness would be passed at once.
    const THIN_M: f64 = 0.03;
    let (middle, half) = ((piece.low + piece.high) * 0.5, (piece.high - piece.low) * 0.5);
    let outline = OrientedBox {
        centre: middle.truncate(),
        half: half.truncate().max(DVec2::splat(THIN_M)),
        along: DVec2::X,
        low_m: 0.0,
        high_m: piece.high.z,
    };
    Part { tag: piece.tag, classes: piece.classes, outline }
}
