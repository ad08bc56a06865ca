//! What lots are built on with.

/// How lots are built on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BuildingKind {
    /// Detached house with a pitched roof and a garden.
    House,
    /// Party-wall town house, shops below where the street is busy.
    Terrace,
    /// Free-standing block of flats.
    Flats,
    /// Low shop or supermarket with a flat roof.
    Shop,
    /// Office block with a stone or panel front.
    Office,
    /// Glass tower.
    Tower,
    /// Warehouse or workshop.
    Hall,
    /// Barn.
    Barn,
}
