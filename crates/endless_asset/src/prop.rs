//! Plants and street furniture.

/// What can be placed in a town. Each comes in many variants (a seed).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
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
    /// Hydrant.
    Hydrant,
    /// Post box.
    PostBox,
    /// Bollard, 0.9 m.
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
}

impl Prop {
    /// All of them.
    pub const ALL: &'static [Self] = &[
        Self::BroadleafTree,
        Self::Conifer,
        Self::Palm,
        Self::Bush,
        Self::Hedge,
        Self::Corn,
        Self::StreetLamp,
        Self::UtilityPole,
        Self::CameraPole,
        Self::SignalPole,
        Self::SignalMast,
        Self::WalkSignal,
        Self::StopSign,
        Self::YieldSign,
        Self::SpeedSign,
        Self::CrossingSign,
        Self::Bench,
        Self::Bin,
        Self::Hydrant,
        Self::PostBox,
        Self::Bollard,
        Self::BusShelter,
        Self::Billboard,
        Self::Planter,
        Self::Cone,
        Self::Kiosk,
        Self::Railing,
        Self::FencePanel,
        Self::BikeRack,
        Self::CafeTable,
        Self::Cabinet,
        Self::Dumpster,
    ];

    /// Name in lists and files: `street_lamp`.
    pub fn name(self) -> String {
        let mut name = String::new();
        for c in format!("{self:?}").chars() {
            if c.is_uppercase() && !name.is_empty() {
                name.push('_');
            }
            name.push(c.to_ascii_lowercase());
        }
        name
    }

    /// Whether it grows.
    pub const fn is_plant(self) -> bool {
        matches!(
            self,
            Self::BroadleafTree | Self::Conifer | Self::Palm | Self::Bush | Self::Hedge | Self::Corn | Self::Planter
        )
    }
}
