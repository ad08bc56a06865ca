//! The table of building styles, and which of them suits a lot.

use super::kind::BuildingKind;
use super::style::{
    Balconies, BuildingStyle, Entrance, FacadeRelief, GroundFront, GroundWindows, Massing, PlainWindows, RhythmStyle,
    RoofEquipment, RoofForm, WindowDressing, WindowFrames, WindowRecess,
};
use endless_world::Stream;

const fn rhythm(bay: f32, window: [f32; 2], sill: f32, storey: f32) -> RhythmStyle {
    RhythmStyle { bay, window, sill, storey, ground: None }
}

/// A plain building of storeys: what styles differ from.
const PLAIN: BuildingStyle = BuildingStyle {
    name: "",
    kind: BuildingKind::House,
    storeys: 2,
    often_has_shops: false,
    massing: Massing::Storeyed,
    rhythm: rhythm(2.6, [1.25, 1.35], 0.9, 2.8),
    materials: |p, _| [p.plaster, p.plaster, p.grey],
    recess: WindowRecess::Between(0.14, 0.24),
    frames: WindowFrames::Painted,
    plain_windows: PlainWindows::None,
    windows: WindowDressing::None,
    ground_windows: GroundWindows::Bare,
    entrance: Entrance::Canopy,
    door_aside: false,
    front: GroundFront::Usual,
    relief: FacadeRelief::None,
    balconies: Balconies::None,
    roof: RoofForm::Flat,
    on_roof: RoofEquipment::Nothing,
    fire_escape: false,
    downpipes: true,
    cables: false,
    veranda: false,
};

const DEEP: WindowRecess = WindowRecess::Between(0.22, 0.34);

/// Detached house under a gable, with shutters or without.
static COTTAGE: BuildingStyle = BuildingStyle {
    name: "cottage",
    materials: |p, choice| {
        if choice < 0.7 { [p.plaster, p.plaster, p.shutter] } else { [p.brick, p.brick, p.shutter] }
    },
    windows: WindowDressing::Shutters,
    roof: RoofForm::Gabled,
    ..PLAIN
};
/// Detached house under a hip, with dormers.
static VILLA: BuildingStyle = BuildingStyle {
    name: "villa",
    materials: |p, _| [p.plaster, p.stone, p.white],
    windows: WindowDressing::Surrounds,
    ground_windows: GroundWindows::Surrounds,
    roof: RoofForm::Hipped,
    ..PLAIN
};
/// House of boards with a veranda.
static WEATHERBOARD: BuildingStyle = BuildingStyle {
    name: "weatherboard_house",
    materials: |p, _| [p.light_boards, p.brick, p.white_paint],
    windows: WindowDressing::Surrounds,
    ground_windows: GroundWindows::Surrounds,
    relief: FacadeRelief::CornerBoards,
    roof: RoofForm::Gabled,
    veranda: true,
    ..PLAIN
};
/// Timber frame with filled panels.
static TIMBER_FRAME: BuildingStyle = BuildingStyle {
    name: "timber_frame_house",
    kind: BuildingKind::Terrace,
    storeys: 3,
    rhythm: rhythm(1.9, [0.95, 1.15], 0.95, 2.75),
    materials: |p, choice| [p.white, if choice < 0.5 { p.stone } else { p.white }, p.timber],
    windows: WindowDressing::Shutters,
    relief: FacadeRelief::Timbers,
    roof: RoofForm::Row { dormers: false },
    ..PLAIN
};
/// Narrow brick houses with lintels.
static TERRACED_BRICK: BuildingStyle = BuildingStyle {
    name: "terraced_house",
    kind: BuildingKind::Terrace,
    storeys: 3,
    rhythm: rhythm(2.4, [1.05, 1.6], 0.8, 2.95),
    materials: |p, choice| [p.brick, p.brick, if choice < 0.6 { p.white } else { p.stone }],
    windows: WindowDressing::Lintels { units: false },
    ground_windows: GroundWindows::Lintels,
    entrance: Entrance::Surround,
    door_aside: true,
    relief: FacadeRelief::StringCourse,
    roof: RoofForm::Row { dormers: false },
    ..PLAIN
};
/// Plastered town house with window surrounds, shutters and a cornice.
static OLD_TOWN: BuildingStyle = BuildingStyle {
    name: "old_town_house",
    kind: BuildingKind::Terrace,
    storeys: 4,
    often_has_shops: true,
    rhythm: rhythm(2.3, [1.05, 1.75], 0.75, 3.2),
    materials: |p, choice| {
        if choice < 0.8 { [p.plaster, p.stone, p.white] } else { [p.stone, p.stone, p.stone] }
    },
    recess: DEEP,
    windows: WindowDressing::SurroundsAndShutters,
    ground_windows: GroundWindows::Surrounds,
    entrance: Entrance::Surround,
    relief: FacadeRelief::Cornice,
    roof: RoofForm::Row { dormers: true },
    ..PLAIN
};
/// Brick tenement with iron fire escapes.
static TENEMENT: BuildingStyle = BuildingStyle {
    name: "brick_tenement",
    kind: BuildingKind::Terrace,
    storeys: 5,
    often_has_shops: true,
    rhythm: rhythm(2.2, [1.0, 1.7], 0.75, 3.1),
    materials: |p, choice| [p.brick, if choice < 0.4 { p.stone } else { p.brick }, p.grey],
    windows: WindowDressing::Lintels { units: true },
    ground_windows: GroundWindows::Grilles,
    relief: FacadeRelief::Cornice,
    on_roof: RoofEquipment::WaterBarrel,
    fire_escape: true,
    ..PLAIN
};
/// Low, colourful, with grilles, roof tanks and bars left for another storey.
pub(crate) static LATIN: BuildingStyle = BuildingStyle {
    name: "latin_american_house",
    kind: BuildingKind::Terrace,
    rhythm: rhythm(2.7, [1.15, 1.25], 0.95, 2.8),
    materials: |p, choice| [p.bright, if choice < 0.35 { p.second } else { p.bright }, p.second],
    windows: WindowDressing::GrillesAndUnits,
    ground_windows: GroundWindows::Grilles,
    entrance: Entrance::IronGate,
    relief: FacadeRelief::Coping,
    roof: RoofForm::Unfinished,
    cables: true,
    ..PLAIN
};
/// Plastered flats with balconies, roller blinds and air conditioners.
static BALCONY_FLATS: BuildingStyle = BuildingStyle {
    name: "balcony_flats",
    kind: BuildingKind::Flats,
    storeys: 5,
    rhythm: rhythm(2.9, [1.6, 1.4], 0.85, 2.85),
    materials: |p, choice| {
        if choice < 0.8 { [p.plaster, p.plaster, p.shutter] } else { [p.brick, p.grey, p.shutter] }
    },
    windows: WindowDressing::Flats { blinds: true },
    balconies: Balconies::ByHouse,
    ..PLAIN
};
/// Flats of prefabricated panels with loggias.
static PANEL_FLATS: BuildingStyle = BuildingStyle {
    name: "panel_flats",
    kind: BuildingKind::Flats,
    storeys: 6,
    rhythm: rhythm(3.0, [1.7, 1.4], 0.85, 2.75),
    materials: |p, _| [p.grey, p.grey, p.bright],
    frames: WindowFrames::White,
    windows: WindowDressing::Flats { blinds: true },
    relief: FacadeRelief::PanelJoints,
    balconies: Balconies::Accented,
    ..PLAIN
};
/// Flats of brick with bands of concrete.
static BRICK_FLATS: BuildingStyle = BuildingStyle {
    name: "brick_flats",
    kind: BuildingKind::Flats,
    storeys: 4,
    rhythm: rhythm(2.9, [1.7, 1.35], 0.9, 2.9),
    materials: |p, _| [p.brick, p.brick, p.grey],
    windows: WindowDressing::Flats { blinds: false },
    relief: FacadeRelief::FloorBands,
    ..PLAIN
};
/// Low row of shops with signs and awnings.
static SHOP_ROW: BuildingStyle = BuildingStyle {
    name: "shop_row",
    kind: BuildingKind::Shop,
    storeys: 1,
    rhythm: rhythm(3.0, [1.8, 1.2], 1.0, 3.8),
    materials: |p, choice| {
        if choice < 0.5 { [p.plaster, p.plaster, p.grey] } else { [p.brick, p.brick, p.grey] }
    },
    ..PLAIN
};
/// One large shop with a wide sign.
static SUPERMARKET: BuildingStyle = BuildingStyle {
    name: "supermarket",
    kind: BuildingKind::Shop,
    storeys: 1,
    rhythm: rhythm(4.5, [2.4, 1.0], 2.6, 5.2),
    materials: |p, _| [p.panel, p.panel, p.sign],
    front: GroundFront::Market,
    ..PLAIN
};
/// Pumps under a canopy, a shop behind.
static PETROL_STATION: BuildingStyle = BuildingStyle {
    name: "petrol_station",
    kind: BuildingKind::Shop,
    storeys: 1,
    massing: Massing::PetrolStation,
    rhythm: rhythm(3.0, [1.8, 1.2], 1.0, 3.8),
    materials: |p, _| [p.white_cladding, p.panel, p.sign],
    ..PLAIN
};
/// Office with a stone front and pilasters.
static STONE_OFFICE: BuildingStyle = BuildingStyle {
    name: "stone_office",
    kind: BuildingKind::Office,
    storeys: 5,
    rhythm: rhythm(2.7, [1.6, 2.0], 0.8, 3.5),
    materials: |p, choice| [if choice < 0.75 { p.stone } else { p.brick }, p.stone, p.stone],
    recess: DEEP,
    relief: FacadeRelief::Pilasters,
    ..PLAIN
};
/// Office with ribbons of glass.
static RIBBON_OFFICE: BuildingStyle = BuildingStyle {
    name: "ribbon_office",
    kind: BuildingKind::Office,
    storeys: 6,
    rhythm: rhythm(2.9, [2.78, 1.7], 0.95, 3.5),
    materials: |p, choice| [p.panel, if choice < 0.5 { p.stone } else { p.panel }, p.grey],
    recess: WindowRecess::Fixed(0.12),
    frames: WindowFrames::Metal,
    relief: FacadeRelief::Ribbons,
    downpipes: false,
    ..PLAIN
};
/// Long, low, large windows in groups.
static SCHOOL: BuildingStyle = BuildingStyle {
    name: "school",
    kind: BuildingKind::Flats,
    storeys: 3,
    rhythm: rhythm(3.2, [2.5, 1.8], 0.9, 3.4),
    materials: |p, choice| {
        if choice < 0.5 { [p.brick, p.brick, p.bright] } else { [p.plaster, p.grey, p.bright] }
    },
    frames: WindowFrames::White,
    relief: FacadeRelief::SchoolPiers,
    ..PLAIN
};
/// Open decks of parked cars.
static PARKING_DECK: BuildingStyle = BuildingStyle {
    name: "parking_deck",
    kind: BuildingKind::Office,
    storeys: 4,
    massing: Massing::ParkingDeck,
    rhythm: rhythm(5.0, [4.6, 1.35], 1.05, 2.75),
    materials: |p, _| [p.grey, p.grey, p.grey],
    ..PLAIN
};
/// Tower of glass.
static GLASS_TOWER: BuildingStyle = BuildingStyle {
    name: "glass_tower",
    kind: BuildingKind::Tower,
    storeys: 16,
    rhythm: RhythmStyle { ground: Some(5.0), ..rhythm(2.2, [2.12, 3.1], 0.2, 3.5) },
    materials: |p, _| [p.panel, p.stone, p.steel],
    recess: WindowRecess::Fixed(0.07),
    frames: WindowFrames::Metal,
    plain_windows: PlainWindows::All,
    relief: FacadeRelief::Mullions,
    on_roof: RoofEquipment::Mast,
    downpipes: false,
    ..PLAIN
};
/// Tower of concrete with windows cut into it.
static CONCRETE_TOWER: BuildingStyle = BuildingStyle {
    name: "concrete_tower",
    kind: BuildingKind::Tower,
    storeys: 14,
    rhythm: RhythmStyle { ground: Some(5.0), ..rhythm(3.0, [1.9, 1.75], 0.85, 3.2) },
    materials: |p, _| [p.grey, p.stone, p.grey],
    recess: DEEP,
    windows: WindowDressing::Units,
    relief: FacadeRelief::Piers,
    downpipes: false,
    ..PLAIN
};
/// Warehouse with docks and roller gates.
static WAREHOUSE: BuildingStyle = BuildingStyle {
    name: "warehouse",
    kind: BuildingKind::Hall,
    rhythm: rhythm(5.0, [2.6, 0.9], 1.6, 3.6),
    materials: |p, _| [p.sheet, p.grey, p.warning],
    recess: WindowRecess::Fixed(0.1),
    front: GroundFront::Docks,
    roof: RoofForm::Rooflights,
    ..PLAIN
};
/// Works under a saw-tooth roof.
static WORKS: BuildingStyle = BuildingStyle {
    name: "works",
    kind: BuildingKind::Hall,
    rhythm: rhythm(3.4, [2.3, 1.9], 1.2, 3.6),
    materials: |p, _| [p.brick, p.brick, p.sheet],
    windows: WindowDressing::Lintels { units: false },
    relief: FacadeRelief::WorksPiers,
    roof: RoofForm::SawTooth,
    ..PLAIN
};
/// Barn of boards.
static BARN: BuildingStyle = BuildingStyle {
    name: "barn",
    kind: BuildingKind::Barn,
    storeys: 1,
    rhythm: rhythm(4.2, [0.8, 0.8], 1.5, 3.2),
    materials: |p, _| [p.boards, p.grey, p.pale_wood],
    recess: WindowRecess::Fixed(0.1),
    plain_windows: PlainWindows::OfGroundFloor,
    roof: RoofForm::Barn,
    ..PLAIN
};
/// Church with a tower.
static CHURCH: BuildingStyle = BuildingStyle {
    name: "church",
    kind: BuildingKind::Flats,
    storeys: 3,
    massing: Massing::Church,
    rhythm: rhythm(3.6, [1.3, 4.2], 2.2, 7.5),
    materials: |p, choice| [if choice < 0.6 { p.stone } else { p.white }, p.stone, p.stone],
    recess: DEEP,
    ..PLAIN
};

/// All styles.
pub(crate) static STYLES: [&BuildingStyle; 24] = [
    &COTTAGE,
    &VILLA,
    &WEATHERBOARD,
    &TIMBER_FRAME,
    &TERRACED_BRICK,
    &OLD_TOWN,
    &TENEMENT,
    &LATIN,
    &BALCONY_FLATS,
    &PANEL_FLATS,
    &BRICK_FLATS,
    &SHOP_ROW,
    &SUPERMARKET,
    &PETROL_STATION,
    &STONE_OFFICE,
    &RIBBON_OFFICE,
    &SCHOOL,
    &PARKING_DECK,
    &GLASS_TOWER,
    &CONCRETE_TOWER,
    &WAREHOUSE,
    &WORKS,
    &BARN,
    &CHURCH,
];

impl BuildingStyle {
    /// A style that suits a lot.
    pub(crate) fn draw(kind: BuildingKind, storeys: u32, shops: bool, stream: &mut Stream) -> &'static Self {
        let x = stream.f64();
        let of = |shares: &[(&'static Self, f64)]| {
            let mut left = x * shares.iter().map(|s| s.1).sum::<f64>();
            let found = shares.iter().find(|s| {
                left -= s.1;
                left < 0.0
            });
            found.unwrap_or(&shares[0]).0
        };
        match kind {
            BuildingKind::House => of(&[(&COTTAGE, 5.0), (&VILLA, 2.5), (&WEATHERBOARD, 2.5)]),
            BuildingKind::Terrace if storeys <= 3 => {
                of(&[(&TERRACED_BRICK, if shops { 2.0 } else { 3.5 }), (&OLD_TOWN, 4.0), (&TIMBER_FRAME, 1.0)])
            }
            BuildingKind::Terrace => of(&[(&OLD_TOWN, 5.0), (&TENEMENT, 3.5), (&TERRACED_BRICK, 1.0)]),
            BuildingKind::Flats if storeys <= 3 => of(&[(&BALCONY_FLATS, 4.0), (&BRICK_FLATS, 2.0), (&SCHOOL, 0.7)]),
            BuildingKind::Flats => of(&[(&BALCONY_FLATS, 4.0), (&PANEL_FLATS, 3.0), (&BRICK_FLATS, 2.0)]),
            BuildingKind::Shop if storeys > 1 => &SHOP_ROW,
            BuildingKind::Shop => of(&[(&SHOP_ROW, 4.0), (&SUPERMARKET, 2.5), (&PETROL_STATION, 1.2)]),
            BuildingKind::Office if !shops && storeys <= 6 => {
                of(&[(&STONE_OFFICE, 4.0), (&RIBBON_OFFICE, 3.0), (&PARKING_DECK, 1.2)])
            }
            BuildingKind::Office => of(&[(&STONE_OFFICE, 4.0), (&RIBBON_OFFICE, 3.0)]),
            BuildingKind::Tower => of(&[(&GLASS_TOWER, 3.0), (&CONCRETE_TOWER, 2.0)]),
            BuildingKind::Hall => of(&[(&WAREHOUSE, 3.0), (&WORKS, 1.5)]),
            BuildingKind::Barn => &BARN,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_style_is_drawn_or_asked_for() {
        let mut seen: Vec<&str> = vec![CHURCH.name, LATIN.name];
        for style in STYLES {
            for storeys in [1, 2, 3, 5, 8, 14] {
                for seed in 0..40 {
                    let mut stream = Stream::named(seed, "manner", &[]);
                    seen.push(BuildingStyle::draw(style.kind, storeys, seed % 2 == 0, &mut stream).name);
                }
            }
        }
        for style in STYLES {
            assert!(seen.contains(&style.name), "{}", style.name);
        }
    }
}
