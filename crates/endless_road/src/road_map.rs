//! A map as a file describes it: what traffic drives on, the surfaces that lie there, and what is known of the
//! surroundings. Importers make it; a town is dressed from it.

use crate::{Polyline, RoadNetwork, Terrain};
use endless_world::SignalId;
use glam::{DVec2, DVec3};

/// A map read from a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RoadMap {
    /// Lanes, junctions, signals, crossings and sidewalks, finished.
    pub network: RoadNetwork,
    /// Everything that is paved or lies between pavements, one strip a lane (connectors included).
    pub strips: Vec<Strip>,
    /// Asphalt where roads meet and no strips say what lies there: outlines on the surface, counter-clockwise, not
    /// closed. Importers whose connectors cover their junctions leave it empty; strips in a junction may overlap it.
    pub junction_areas: Vec<Vec<DVec3>>,
    /// Paint on the road.
    pub marks: Vec<Mark>,
    /// What the land beside the roads is.
    pub areas: Vec<Area>,
    /// Buildings.
    pub footprints: Vec<BuildingFootprint>,
    /// Things that stand at a place.
    pub objects: Vec<MapObject>,
    /// The lie of the land beside the roads, where known.
    pub terrain: Option<Terrain>,
    /// Whether traffic keeps to the left.
    pub left_hand: bool,
    /// PROJ string or WGS 84 origin of the local frame, as the file gives it.
    pub georeference: Option<String>,
    /// What in the file was not understood or had to be mended.
    pub notes: Vec<ImportNote>,
}

/// What the surface of a strip is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum StripKind {
    /// Driven on, inside and outside junctions.
    Driving,
    /// Hard shoulder, border, stop: asphalt that nobody drives on.
    Shoulder,
    /// Parking lane or bays.
    Parking,
    /// Cycle lane or path.
    Biking,
    /// For walking; its height says whether it is raised.
    Sidewalk,
    /// Kerb stone.
    Curb,
    /// Between carriageways: grass or paving.
    Median,
    /// Tracks.
    Rail,
}

/// The area between two lines that run in the same direction, on the surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Strip {
    /// What it is for.
    pub kind: StripKind,
    /// The border to the left, seen along the lines.
    pub left: Vec<DVec3>,
    /// The border to the right; as many points as `left`.
    pub right: Vec<DVec3>,
    /// Whether it lies in a junction, where strips may overlap one another.
    pub in_junction: bool,
    /// Unpaved (gravel, earth, grass).
    pub unpaved: bool,
    /// On a bridge: the ground is somewhere below.
    pub bridge: bool,
}

/// Colour of paint.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Paint {
    /// White.
    White,
    /// Yellow.
    Yellow,
}

/// A painted line along a curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// The middle of the line, on the surface.
    pub line: Polyline,
    /// Metres.
    pub width_m: f64,
    /// Length of paint and of the gap after it, metres; `None` for an unbroken line.
    pub dash: Option<[f64; 2]>,
    /// Colour.
    pub paint: Paint,
}

/// What land is used as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum AreaKind {
    /// Lawns, trees and paths.
    Park,
    /// Dense trees.
    Wood,
    /// Fields.
    Farmland,
    /// Meadow, verge, scrub.
    Grass,
    /// Rivers, lakes, sea.
    Water,
    /// Paved square.
    Plaza,
    /// Car park.
    Parking,
    /// Homes and gardens.
    Residential,
    /// Shops and offices.
    Commercial,
    /// Works and sheds.
    Industrial,
    /// Bare earth, construction.
    Bare,
}

/// A piece of land.
#[derive(Debug, Clone, PartialEq)]
pub struct Area {
    /// Its use.
    pub kind: AreaKind,
    /// Outline, counter-clockwise, not closed.
    pub outline: Vec<DVec2>,
    /// Holes, clockwise.
    pub holes: Vec<Vec<DVec2>>,
}

/// A building seen from above.
#[derive(Debug, Clone, PartialEq)]
pub struct BuildingFootprint {
    /// Outline, counter-clockwise, not closed.
    pub outline: Vec<DVec2>,
    /// Courtyards, clockwise.
    pub holes: Vec<Vec<DVec2>>,
    /// Metres from the ground to the eaves, where known.
    pub height_m: Option<f64>,
    /// Storeys, where known.
    pub levels: Option<f64>,
    /// What it is, in the words of OpenStreetMap's `building` tag (`apartments`, `retail`, `church`, `yes`...).
    pub kind: String,
    /// Linear colour of the walls, where known.
    pub color: Option<[f32; 3]>,
}

/// What stands at a place.
#[derive(Debug, Clone, PartialEq)]
pub enum MapObjectKind {
    /// A traffic light for vehicles; faces against `heading_rad`'s direction of travel.
    TrafficLight(SignalId),
    /// A traffic light for people.
    WalkLight(SignalId),
    /// A stop sign.
    Stop,
    /// A give-way sign.
    Yield,
    /// A speed limit, km/h.
    SpeedLimit(u16),
    /// Any other sign, by its code in the file (country, type, subtype).
    Sign(String),
    /// A tree; height in metres where known.
    Tree(Option<f64>),
    /// A street lamp.
    StreetLamp,
    /// A bench.
    Bench,
    /// A bus stop.
    BusStop,
    /// A bollard.
    Bollard,
    /// A rubbish bin.
    Bin,
    /// A hydrant.
    Hydrant,
    /// A power or telephone pole.
    UtilityPole,
    /// A bump across the road, to slow traffic down; its heading is the road's.
    SpeedBump,
}

/// Something that stands at a place.
#[derive(Debug, Clone, PartialEq)]
pub struct MapObject {
    /// What.
    pub kind: MapObjectKind,
    /// Its foot.
    pub position: DVec3,
    /// Direction of the traffic that it is for, or that it looks at; counter-clockwise from east, radians.
    pub heading_rad: f64,
}

/// Something to tell the user about a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportNote {
    /// Where in the file: line, element, id.
    pub place: String,
    /// What.
    pub text: String,
}
