//! What a building style is: everything that sets one facade apart from another on lots of the same kind.

use super::kind::BuildingKind;
use super::palette::Palette;
use endless_scene::Material;

/// How buildings of one style are made. Lengths are metres.
#[derive(Debug)]
pub(crate) struct BuildingStyle {
    /// Name in lists: `glass_tower`.
    pub(crate) name: &'static str,
    /// The lots that it belongs on.
    pub(crate) kind: BuildingKind,
    /// Its usual storeys.
    pub(crate) storeys: u32,
    /// Whether some have shops below where they stand alone.
    pub(crate) often_has_shops: bool,
    pub(super) massing: Massing,
    pub(super) rhythm: RhythmStyle,
    /// Materials of walls, ground floor and accents, from a building's colours and a number in 0..1.
    pub(super) materials: fn(&Palette, f64) -> [Material; 3],
    pub(super) recess: WindowRecess,
    pub(super) frames: WindowFrames,
    pub(super) plain_windows: PlainWindows,
    pub(super) windows: WindowDressing,
    pub(super) ground_windows: GroundWindows,
    pub(super) entrance: Entrance,
    /// The door is in the first bay, not in the middle.
    pub(super) door_aside: bool,
    pub(super) front: GroundFront,
    pub(super) relief: FacadeRelief,
    pub(super) balconies: Balconies,
    pub(super) roof: RoofForm,
    pub(super) on_roof: RoofEquipment,
    /// Iron stairs before fronts of four storeys and more.
    pub(super) fire_escape: bool,
    pub(super) downpipes: bool,
    /// Cables along the front.
    pub(super) cables: bool,
    /// A veranda over the whole front in place of a porch.
    pub(super) veranda: bool,
}

/// Bays and storeys of a facade.
#[derive(Debug, Clone, Copy)]
pub(super) struct RhythmStyle {
    pub(super) bay: f32,
    /// Width and height.
    pub(super) window: [f32; 2],
    pub(super) sill: f32,
    pub(super) storey: f32,
    /// Height of the ground floor, where it differs.
    pub(super) ground: Option<f32>,
}

/// The overall form of a building.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Massing {
    /// Walls with storeys of windows under a roof.
    Storeyed,
    PetrolStation,
    Church,
    ParkingDeck,
}

/// How deep windows lie in the wall.
#[derive(Debug, Clone, Copy)]
pub(super) enum WindowRecess {
    Fixed(f32),
    Between(f32, f32),
}

/// What window frames are made of.
#[derive(Debug, Clone, Copy)]
pub(super) enum WindowFrames {
    /// A colour of the house's own.
    Painted,
    White,
    Metal,
}

/// Windows that are never modelled in full.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum PlainWindows {
    None,
    OfGroundFloor,
    All,
}

/// What windows of upper storeys have about them.
#[derive(Debug, Clone, Copy)]
pub(super) enum WindowDressing {
    None,
    /// Surrounds of plaster, with shutters or flower boxes.
    SurroundsAndShutters,
    /// Stones over windows; units of air conditioners in some, if `units`.
    Lintels {
        units: bool,
    },
    Shutters,
    Surrounds,
    GrillesAndUnits,
    /// Units, dishes and flowers; roller blinds at the front, if `blinds`.
    Flats {
        blinds: bool,
    },
    Units,
}

/// What windows of the ground floor have about them.
#[derive(Debug, Clone, Copy)]
pub(super) enum GroundWindows {
    Bare,
    Grilles,
    Surrounds,
    Lintels,
}

/// What a door has about it.
#[derive(Debug, Clone, Copy)]
pub(super) enum Entrance {
    /// A slab over it, but for houses.
    Canopy,
    /// A fine surround.
    Surround,
    /// A gate of iron before it.
    IronGate,
}

/// The street side of ground floors that differ from the usual.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum GroundFront {
    /// Gates of halls and barns, shops, or windows about a door.
    Usual,
    /// The glass front of a supermarket.
    Market,
    /// Gates over docks.
    Docks,
}

/// What stands out from a wall as a whole.
#[derive(Debug, Clone, Copy)]
pub(super) enum FacadeRelief {
    None,
    /// A string course, quoins and a cornice on brackets.
    Cornice,
    /// A string course and a plain cornice.
    StringCourse,
    Pilasters,
    Ribbons,
    Mullions,
    Piers,
    PanelJoints,
    FloorBands,
    /// Piers under a deep cornice.
    SchoolPiers,
    WorksPiers,
    Timbers,
    Coping,
    CornerBoards,
}

/// Balconies of upper storeys.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Balconies {
    None,
    /// With bars, or solid, as the house has it.
    ByHouse,
    /// Solid in the colour of what stands out.
    Accented,
}

/// The shape of a roof.
#[derive(Debug, Clone, Copy)]
pub(super) enum RoofForm {
    Hipped,
    Gabled,
    /// A gable along the street up to four storeys, flat above; with dormers always, or sometimes.
    Row {
        dormers: bool,
    },
    Barn,
    SawTooth,
    /// Flat with long rooflights.
    Rooflights,
    /// Flat with tanks and bars left for another storey.
    Unfinished,
    Flat,
}

/// Equipment on flat roofs, beyond what every flat roof has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum RoofEquipment {
    Nothing,
    /// A barrel of water on legs over four storeys and more.
    WaterBarrel,
    Mast,
}
