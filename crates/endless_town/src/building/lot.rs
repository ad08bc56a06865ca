//! How large buildings are by their kind.

use super::kind::BuildingKind;
use endless_world::Stream;

/// Width and depth, metres.
pub(crate) fn size(kind: BuildingKind, stream: &mut Stream) -> (f64, f64) {
    let (w, d) = match kind {
        BuildingKind::House => ((8.5, 12.5), (8.0, 10.5)),
        BuildingKind::Terrace => ((6.5, 12.0), (10.0, 13.0)),
        BuildingKind::Flats => ((17.0, 27.0), (11.0, 14.0)),
        BuildingKind::Shop => ((13.0, 22.0), (11.0, 17.0)),
        BuildingKind::Office => ((15.0, 24.0), (13.0, 17.0)),
        BuildingKind::Tower => ((18.0, 24.0), (16.0, 20.0)),
        BuildingKind::Hall => ((22.0, 34.0), (16.0, 24.0)),
        BuildingKind::Barn => ((9.0, 12.0), (14.0, 20.0)),
    };
    (stream.range_f64(w.0, w.1), stream.range_f64(d.0, d.1))
}

pub(crate) fn storeys(kind: BuildingKind, low: u32, high: u32, stream: &mut Stream) -> u32 {
    let between = |stream: &mut Stream, a: u32, b: u32| a + stream.below((b - a + 1) as usize) as u32;
    match kind {
        BuildingKind::House => between(stream, 1, 2),
        BuildingKind::Terrace => between(stream, low, high),
        BuildingKind::Flats => between(stream, low + 1, high + 1),
        BuildingKind::Shop => 1 + u32::from(stream.chance(0.25)),
        BuildingKind::Office => between(stream, low.max(3), high + 2),
        BuildingKind::Tower => between(stream, 12, 20),
        BuildingKind::Hall => 2,
        BuildingKind::Barn => 1,
    }
}

/// How far roofs reach beyond the walls; terraces stand wall to wall.
pub(crate) fn eaves(kind: BuildingKind) -> f64 {
    match kind {
        BuildingKind::House | BuildingKind::Barn => 0.55,
        BuildingKind::Terrace => 0.0,
        _ => 0.15,
    }
}
