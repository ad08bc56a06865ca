//! Manners of building: what sets one facade apart from another on lots of the same kind.

use super::kind::BuildingKind;
use endless_world::Stream;

/// A manner of building.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Manner {
    /// Detached house under a gable, with shutters or without.
    Cottage,
    /// Detached house under a hip, with dormers.
    Villa,
    /// House of boards with a veranda.
    Weatherboard,
    /// Timber frame with filled panels.
    TimberFrame,
    /// Narrow brick houses with bay windows and lintels.
    TerracedBrick,
    /// Plastered town house with window surrounds, shutters and a cornice.
    OldTown,
    /// Brick tenement with iron fire escapes.
    Tenement,
    /// Low, colourful, with grilles, roof tanks and bars left for another storey.
    Latin,
    /// Plastered flats with balconies, roller blinds and air conditioners.
    Balconies,
    /// Flats of prefabricated panels with loggias.
    Panels,
    /// Flats of brick with bands of concrete.
    BrickFlats,
    /// Low row of shops with signs and awnings.
    ShopRow,
    /// One large shop with a wide sign.
    Supermarket,
    /// Petrol station: pumps under a canopy, a shop behind.
    Petrol,
    /// Office with a stone front and pilasters.
    StoneOffice,
    /// Office with ribbons of glass.
    RibbonOffice,
    /// School: long, low, large windows in groups.
    School,
    /// Open decks of parked cars.
    ParkingDeck,
    /// Tower of glass.
    GlassTower,
    /// Tower of concrete with windows cut into it.
    ConcreteTower,
    /// Warehouse with docks and roller gates.
    Warehouse,
    /// Works under a saw-tooth roof.
    Works,
    /// Barn of boards.
    Barn,
    /// Church with a tower.
    Church,
}

use Manner::{
    Balconies, Barn, BrickFlats, Church, ConcreteTower, Cottage, GlassTower, Latin, OldTown, Panels, ParkingDeck,
    Petrol, RibbonOffice, School, ShopRow, StoneOffice, Supermarket, Tenement, TerracedBrick, TimberFrame, Villa,
    Warehouse, Weatherboard, Works,
};

impl Manner {
    /// All, with the kind of lot that each belongs on and its usual storeys.
    pub(crate) const ALL: [(Self, BuildingKind, u32); 24] = [
        (Cottage, BuildingKind::House, 2),
        (Villa, BuildingKind::House, 2),
        (Weatherboard, BuildingKind::House, 2),
        (TimberFrame, BuildingKind::Terrace, 3),
        (TerracedBrick, BuildingKind::Terrace, 3),
        (OldTown, BuildingKind::Terrace, 4),
        (Tenement, BuildingKind::Terrace, 5),
        (Latin, BuildingKind::Terrace, 2),
        (Balconies, BuildingKind::Flats, 5),
        (Panels, BuildingKind::Flats, 6),
        (BrickFlats, BuildingKind::Flats, 4),
        (ShopRow, BuildingKind::Shop, 1),
        (Supermarket, BuildingKind::Shop, 1),
        (Petrol, BuildingKind::Shop, 1),
        (StoneOffice, BuildingKind::Office, 5),
        (RibbonOffice, BuildingKind::Office, 6),
        (School, BuildingKind::Flats, 3),
        (ParkingDeck, BuildingKind::Office, 4),
        (GlassTower, BuildingKind::Tower, 16),
        (ConcreteTower, BuildingKind::Tower, 14),
        (Warehouse, BuildingKind::Hall, 2),
        (Works, BuildingKind::Hall, 2),
        (Barn, BuildingKind::Barn, 1),
        (Church, BuildingKind::Flats, 3),
    ];

    /// Name in lists: `glass_tower`.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Cottage => "cottage",
            Villa => "villa",
            Weatherboard => "weatherboard_house",
            TimberFrame => "timber_frame_house",
            TerracedBrick => "terraced_house",
            OldTown => "old_town_house",
            Tenement => "brick_tenement",
            Latin => "latin_american_house",
            Balconies => "balcony_flats",
            Panels => "panel_flats",
            BrickFlats => "brick_flats",
            ShopRow => "shop_row",
            Supermarket => "supermarket",
            Petrol => "petrol_station",
            StoneOffice => "stone_office",
            RibbonOffice => "ribbon_office",
            School => "school",
            ParkingDeck => "parking_deck",
            GlassTower => "glass_tower",
            ConcreteTower => "concrete_tower",
            Warehouse => "warehouse",
            Works => "works",
            Barn => "barn",
            Church => "church",
        }
    }

    /// A manner that suits a lot.
    pub(crate) fn draw(kind: BuildingKind, storeys: u32, shops: bool, stream: &mut Stream) -> Self {
        let x = stream.f64();
        let of = |shares: &[(Self, f64)]| {
            let mut left = x * shares.iter().map(|s| s.1).sum::<f64>();
            let found = shares.iter().find(|s| {
                left -= s.1;
                left < 0.0
            });
            found.unwrap_or(&shares[0]).0
        };
        match kind {
            BuildingKind::House => of(&[(Cottage, 5.0), (Villa, 2.5), (Weatherboard, 2.5)]),
            BuildingKind::Terrace if storeys <= 3 => {
                of(&[(TerracedBrick, if shops { 2.0 } else { 3.5 }), (OldTown, 4.0), (TimberFrame, 1.0)])
            }
            BuildingKind::Terrace => of(&[(OldTown, 5.0), (Tenement, 3.5), (TerracedBrick, 1.0)]),
            BuildingKind::Flats if storeys <= 3 => of(&[(Balconies, 4.0), (BrickFlats, 2.0), (School, 0.7)]),
            BuildingKind::Flats => of(&[(Balconies, 4.0), (Panels, 3.0), (BrickFlats, 2.0)]),
            BuildingKind::Shop if storeys > 1 => ShopRow,
            BuildingKind::Shop => of(&[(ShopRow, 4.0), (Supermarket, 2.5), (Petrol, 1.2)]),
            BuildingKind::Office if !shops && storeys <= 6 => {
                of(&[(StoneOffice, 4.0), (RibbonOffice, 3.0), (ParkingDeck, 1.2)])
            }
            BuildingKind::Office => of(&[(StoneOffice, 4.0), (RibbonOffice, 3.0)]),
            BuildingKind::Tower => of(&[(GlassTower, 3.0), (ConcreteTower, 2.0)]),
            BuildingKind::Hall => of(&[(Warehouse, 3.0), (Works, 1.5)]),
            BuildingKind::Barn => Barn,
        }
    }
}
