//! How large buildings are by their kind.

use super::kind::Kind;
use endless_world::Stream;

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
