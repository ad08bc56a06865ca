//! Plants and street furniture.

use strum::VariantArray as _;

/// What can be placed in a town. Each comes in many variants (a seed).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[derive(strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[strum(serialize_all = "snake_case")]
pub enum Prop {
    /// Round-crowned street tree, about 7 to 11 m.
    BroadleafTree,
    /// Conifer, about 8 to 14 m.
    Conifer,
    /// Palm, about 6 to 10 m.
    Palm,
    /// Bush, about 1 m.
    Bush,
    /// A straight metre of clipped hedge along x, 1 m high, 0.6 m deep.
    Hedge,
    /// A square block of maize of 4 m, rows along x, about 2 m high.
    Corn,
    /// Lamp post, 8 m, arm along +x reaching 2 m; lens at (2, 0, 7.9).
    StreetLamp,
    /// Wooden utility pole, 9 m, cross-arm along y.
    UtilityPole,
    /// Plain steel pole for a camera, 6 m.
    CameraPole,
    /// Traffic-light pole with a vertical three-lens head at 3.2 m facing +x.
    SignalPole,
    /// Traffic-light pole with a mast arm: pole at the origin, arm 5.5 m along −y at 5.8 m height, two heads on the arm
    /// and one on the pole, all facing +x.
    SignalMast,
    /// Pedestrian signal on a pole: head at 2.4 m facing +x.
    WalkSignal,
    /// Octagonal stop sign facing +x.
    StopSign,
    /// Triangular give-way sign facing +x.
    YieldSign,
    /// Round speed-limit sign facing +x.
    SpeedSign,
    /// Blue square crossing sign facing +x.
    CrossingSign,
    /// Bench along y, facing +x.
    Bench,
    /// Litter bin.
    Bin,
    /// Hydrant, a stout one or a pillar.
    Hydrant,
    /// Post box.
    PostBox,
    /// Bollard, about 0.9 m.
    Bollard,
    /// Bus shelter along y, 4 m long, open to +x.
    BusShelter,
    /// Advertising board on two legs, facing +x.
    Billboard,
    /// Planter box with flowers.
    Planter,
    /// Traffic cone.
    Cone,
    /// Kiosk, 2.5 m square, open to +x.
    Kiosk,
    /// Iron railing, 2 m along x, 1.1 m high.
    Railing,
    /// Wooden fence panel, 2 m along x, 1.6 m high.
    FencePanel,
    /// Bicycle rack with a hoop along x.
    BikeRack,
    /// Cafe table with parasol and four chairs.
    CafeTable,
    /// Junction cabinet.
    Cabinet,
    /// Dumpster.
    Dumpster,
    /// Cast-iron lantern of old streets, 4.4 m; lens at (0, 0, 3.75).
    LanternPost,
    /// Globe or disc on a slender post, 3.8 m; lens at (0, 0, 3.6).
    ParkLamp,
    /// Lamp post of wide roads, 10 m, arms along ±x; lenses at (±2.1, 0, 9.9).
    DoubleLamp,
    /// Mast of 20 m with a ring of floodlights.
    HighMast,
    /// Concrete utility pole, 9 m, with a transformer, coils of cable and boxes; cross-arm along y.
    CrowdedPole,
    /// Two poles 14 m apart along y with two traffic-light heads hung from a wire between them, facing +x.
    SpanSignal,
    /// Small traffic light for cyclists at 2.35 m, facing +x.
    CycleSignal,
    /// Traffic sign facing +x; its variants are the codes of [`crate::Catalogue::sign_codes`].
    TrafficSign,
    /// Names of two streets on a post, along y and x.
    StreetName,
    /// Board of directions on two posts, 3.2 m along y, facing +x.
    GuideSign,
    /// Bus stop: a flag with its timetable, facing +x.
    BusStop,
    /// Steel guard rail, 4 m along x, facing −y.
    GuardRail,
    /// Concrete barrier, 3 m along x.
    JerseyBarrier,
    /// Plastic barrier filled with water, 2 m along x.
    WaterBarrier,
    /// Red and white boards about roadworks, 2 m along x.
    WorksBarrier,
    /// Three striped boards that close a road, 1.8 m along x.
    Barricade,
    /// Mesh fence of building sites, 3.5 m along x, 2 m high.
    SiteFence,
    /// Orange traffic drum.
    Drum,
    /// Striped beacon board with a lamp, facing ±x.
    Beacon,
    /// Boom of a car park: arm lowered along +y, 3.2 m.
    BoomGate,
    /// Parking meter, facing +x.
    ParkingMeter,
    /// Ticket machine of a car park, facing +x.
    PayStation,
    /// Telephone box, 2.5 m.
    PhoneBooth,
    /// Boxes for newspapers in a row along y, facing +x.
    NewsBox,
    /// Charging point for cars, facing +x.
    Charger,
    /// Speed camera, facing +x.
    SpeedCamera,
    /// Drinking fountain, facing +x.
    DrinkingFountain,
    /// Round column with posters, 3.5 m.
    AdvertColumn,
    /// Lit poster case, 1.3 m along y, facing ±x.
    CityLight,
    /// Folding board before a shop, facing ±x.
    SandwichBoard,
    /// Flag on a pole of 9 m, blowing towards +y.
    Flagpole,
    /// Three wheeled bins in a row along y, facing +x.
    WheelieBins,
    /// Container for glass, 1.6 m.
    BottleBank,
    /// Builder's skip with rubble, 3.4 m along x.
    Skip,
    /// Heap of rubbish bags.
    RubbishBags,
    /// Stack of pallets.
    Pallets,
    /// Round manhole cover, level with the ground.
    Manhole,
    /// Gully grate, level with the ground.
    Drain,
    /// Table with two benches along x.
    PicnicTable,
    /// Bench of stone along y.
    StoneBench,
    /// Fountain with a basin of 5 m.
    Fountain,
    /// Bronze figure on a plinth, 4.1 m, facing +x.
    Monument,
    /// Market stall, 2.8 m along y, facing +x.
    MarketStall,
    /// Iron grate and guard about a tree.
    TreeGuard,
    /// Stand for five bicycles, 2.4 m along y.
    BikeStand,
    /// Brick wall, 2 m along x, 1.8 m high.
    BrickWall,
    /// Wall of field stones, 2 m along x, 0.8 m high.
    StoneWall,
    /// Wire netting, 2 m along x, 1.8 m high.
    ChainLink,
    /// White picket fence, 2 m along x, 0.95 m high.
    PicketFence,
    /// Cypress, a narrow flame of about 7 to 11 m.
    Cypress,
    /// Broadleaf tree in winter, without leaves.
    BareTree,
    /// Bed of flowers in an edging of stones, 2 m along x.
    FlowerBed,
    /// Tuft of grass, half a metre across.
    GrassTuft,
    /// A square block of wheat of 2 m, rows along x, 0.9 m high.
    Wheat,
    /// Boulder, about 1.5 m across.
    Rock,
    /// Vendor's cart under a parasol or a roof, 1.4 m along x, handle towards −x, facing +y.
    FoodCart,
    /// Flat cart on two wheels, 1.5 m along x, handle towards −x, empty or loaded.
    HandCart,
    /// Goods spread on a blanket, 1.7 m along y, facing +x.
    VendorBlanket,
    /// Plastic crates, one on another.
    CrateStack,
    /// Sand or gravel as it was tipped, 2.4 m across.
    SandHeap,
    /// Bricks or blocks on a pallet.
    BrickPallet,
    /// Concrete pipes, reinforcing bars or sacks of cement, along x.
    BuildingStock,
    /// Bay of a scaffold, 2.5 m along x, its street side towards +y.
    ScaffoldBay,
    /// Clothes on lines between two poles 4 m apart along x.
    LaundryLine,
    /// Railing between sidewalk and carriageway, 2 m along x, 1 m high.
    KerbRail,
    /// Satellite dish on a short mast, looking up towards +x.
    SatelliteDish,
    /// Traffic-light pole that bends over the road along −y, a head under its end 4.2 m from the foot and one on the pole, both
    /// facing +x.
    SignalCurvedMast,
}

impl Prop {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    /// Name in lists and files: `street_lamp`.
    pub fn name(self) -> &'static str {
        self.into()
    }

    /// Whether it shows the state of a signal program to those who drive.
    pub const fn is_vehicle_signal(self) -> bool {
        matches!(self, Self::SignalPole | Self::SignalMast | Self::SignalCurvedMast | Self::SpanSignal)
    }

    /// Whether it shows the state of a signal program.
    pub const fn is_signal(self) -> bool {
        self.is_vehicle_signal() || matches!(self, Self::WalkSignal | Self::CycleSignal)
    }

    /// Whether it is a traffic sign with a code: no names of streets, no directions.
    pub const fn is_traffic_sign(self) -> bool {
        matches!(self, Self::StopSign | Self::YieldSign | Self::SpeedSign | Self::CrossingSign | Self::TrafficSign)
    }

    /// Whether it lights streets.
    pub const fn is_street_lamp(self) -> bool {
        matches!(self, Self::StreetLamp | Self::LanternPost | Self::ParkLamp | Self::DoubleLamp | Self::HighMast)
    }

    /// Whether a town buys many of one model.
    pub const fn is_municipal(self) -> bool {
        self.is_signal()
            || matches!(
                self,
                Self::StreetLamp
                    | Self::ParkLamp
                    | Self::Bin
                    | Self::Bollard
                    | Self::Hydrant
                    | Self::PostBox
                    | Self::PhoneBooth
                    | Self::StreetName
                    | Self::KerbRail
            )
    }

    /// Whether it is of nature: what grows, and rocks.
    pub const fn is_plant(self) -> bool {
        matches!(
            self,
            Self::BroadleafTree
                | Self::Conifer
                | Self::Palm
                | Self::Bush
                | Self::Hedge
                | Self::Corn
                | Self::Planter
                | Self::Cypress
                | Self::BareTree
                | Self::FlowerBed
                | Self::GrassTuft
                | Self::Wheat
                | Self::Rock
        )
    }
}
