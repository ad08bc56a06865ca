//! A map as a file describes it: the lane network, the paved surfaces and road markings, and what the file says of land
//! use, buildings and objects beside the roads. Importers make it; a town is dressed from it.

use crate::{Polyline, RoadNetwork, Terrain};
use endless_world::SignalId;
use glam::{DVec2, DVec3};

/// A map read from a file.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RoadMap {
    /// Lanes, junctions, signals, crossings and sidewalks, finished.
    pub network: RoadNetwork,
    /// Paved surfaces and medians, one for each lane (connectors included).
    pub lane_surfaces: Vec<LaneSurface>,
    /// Asphalt of junctions that no lane surfaces cover: outlines on the surface, counter-clockwise, not closed.
    /// Importers whose connectors cover their junctions leave it empty; lane surfaces in a junction may overlap it.
    pub junction_areas: Vec<Vec<DVec3>>,
    /// Painted lines.
    pub markings: Vec<RoadMarking>,
    /// Land use beside the roads.
    pub areas: Vec<LandUseArea>,
    /// Buildings.
    pub footprints: Vec<BuildingFootprint>,
    /// Signs, lights, trees and street furniture.
    pub objects: Vec<MapObject>,
    /// Relief, where known.
    pub terrain: Option<Terrain>,
    /// Whether traffic keeps to the left.
    pub left_hand: bool,
    /// PROJ string or WGS 84 origin of the local frame, as the file gives it.
    pub georeference: Option<String>,
    /// What in the file was not understood or had to be mended.
    pub notes: Vec<ImportNote>,
}

/// What a lane is for, in the words of OpenDRIVE's lane types.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LaneType {
    /// For vehicles, inside and outside junctions.
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

/// The paved surface of a lane: the area between its left and right border.
#[derive(Debug, Clone, PartialEq)]
pub struct LaneSurface {
    /// Type of the lane.
    pub kind: LaneType,
    /// The left border, seen in the direction of its points.
    pub left: Vec<DVec3>,
    /// The right border; as many points as `left`.
    pub right: Vec<DVec3>,
    /// Whether it lies in a junction, where surfaces may overlap one another.
    pub in_junction: bool,
    /// Unpaved (gravel, earth, grass).
    pub unpaved: bool,
    /// On a bridge, above the ground.
    pub bridge: bool,
}

/// Colour of a road marking.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum MarkingColor {
    /// White.
    White,
    /// Yellow.
    Yellow,
}

/// A painted line, solid or broken. (OpenDRIVE's own record of lines at a lane's edge is
/// [`opendrive::RoadMark`](crate::opendrive::RoadMark).)
#[derive(Debug, Clone, PartialEq)]
pub struct RoadMarking {
    /// The middle of the line, on the surface.
    pub line: Polyline,
    /// Metres.
    pub width_m: f64,
    /// Length of paint and of the gap after it, metres; `None` for an unbroken line.
    pub dash: Option<[f64; 2]>,
    /// Colour.
    pub color: MarkingColor,
}

/// Land use, as OpenStreetMap's `landuse`, `natural` and `leisure` tags tell it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LandUse {
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

/// A piece of land of one use.
#[derive(Debug, Clone, PartialEq)]
pub struct LandUseArea {
    /// Its use.
    pub kind: LandUse,
    /// Outline, counter-clockwise, not closed.
    pub outline: Vec<DVec2>,
    /// Holes, clockwise.
    pub holes: Vec<Vec<DVec2>>,
}

/// The footprint of a building and what is known of it.
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

/// Kind of a map object.
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

/// An object at a point of the map.
#[derive(Debug, Clone, PartialEq)]
pub struct MapObject {
    /// Its kind.
    pub kind: MapObjectKind,
    /// Its base, on the ground.
    pub position: DVec3,
    /// Direction of the traffic that it is for, or that it looks at; counter-clockwise from east, radians.
    pub heading_rad: f64,
}

/// A note to the user about a file: what was not understood, mended or left out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ImportNote {
    /// Where in the file: line, element, id.
    pub place: String,
    /// The note.
    pub text: String,
}
