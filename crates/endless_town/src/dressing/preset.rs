//! What sets one dressed map apart from another: lamps, trees, what is built where.

use crate::building::BuildingKind;
use crate::dressing::road_furniture::sign_standard::SignStandard;
use crate::palette::ASPHALT;
use endless_asset::Prop;
use endless_scene::Material;
use glam::DVec2;

/// What is built on a piece of land.
#[derive(Debug, Clone)]
pub(crate) struct BuildingZone {
    pub(crate) outline: Vec<DVec2>,
    pub(crate) kinds: &'static [(BuildingKind, f64)],
    /// Fewest and most.
    pub(crate) storeys: (u32, u32),
    /// Share of lots left open.
    pub(crate) open: f64,
}

/// What people put into streets: shares of the places where there might be some.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct StreetLife {
    pub(crate) vendors: f64,
    pub(crate) works: f64,
    pub(crate) rubbish: f64,
    pub(crate) scaffolds: f64,
    pub(crate) laundry: f64,
}

/// How a map is dressed.
#[derive(Debug, Clone)]
pub(crate) struct TownPreset {
    /// One sentence on the town.
    pub(crate) summary: String,
    /// Street lamps: linear colour and candela.
    pub(crate) lamp_color: [f32; 3],
    pub(crate) lamp_cd: f32,
    /// Shares of conifers and palms among trees.
    pub(crate) conifers: f64,
    pub(crate) palms: f64,
    /// What roads are paved with.
    pub(crate) paving: Material,
    /// What is built where, first come first served; by the roads' density elsewhere.
    pub(crate) zones: Vec<BuildingZone>,
    /// Wires hang on poles along all streets, not just along roads without sidewalks.
    pub(crate) wires: bool,
    /// Low houses have flat roofs and bright colours, which the sun has bleached.
    pub(crate) bright: bool,
    /// Maize grows on the fields.
    pub(crate) maize: bool,
    /// Ground between houses is paved where roads are many.
    pub(crate) yards: bool,
    /// Share of its pieces where something grows instead.
    pub(crate) green_yards: f64,
    /// What is in the streets that no plan has.
    pub(crate) life: StreetLife,
    /// Crossings with signals show them, and a second light stands on the other side of approaches.
    pub(crate) walk_signals: bool,
    pub(crate) signal_repeaters: bool,
    /// What carries lights over roads of several lanes, or over all.
    pub(crate) signal_mast: Prop,
    pub(crate) masts_everywhere: bool,
    /// Whose signs stand in the streets beside those of the map.
    pub(crate) street_signs: Option<SignStandard>,
    /// What stands at the kerbs of corners: rails or bollards.
    pub(crate) kerb_guard: Option<Prop>,
    /// Share of lines that have left traces elsewhere.
    pub(crate) old_paint: f64,
    /// Colour of lanes for buses, if there are any.
    pub(crate) bus_lanes: Option<[f32; 3]>,
    /// Buildings grow along the roads even where the map knows some.
    pub(crate) grows: bool,
}

impl Default for TownPreset {
    /// Of towns with zones of their own.
    fn default() -> Self {
        Self {
            summary: String::new(),
            lamp_color: [1.0, 0.86, 0.66],
            lamp_cd: 4800.0,
            conifers: 0.22,
            palms: 0.0,
            paving: ASPHALT,
            zones: Vec::new(),
            wires: false,
            bright: false,
            maize: false,
            yards: false,
            green_yards: 0.0,
            life: StreetLife::default(),
            walk_signals: false,
            signal_repeaters: false,
            signal_mast: Prop::SignalMast,
            masts_everywhere: false,
            street_signs: None,
            kerb_guard: None,
            old_paint: 0.0,
            bus_lanes: None,
            grows: true,
        }
    }
}
