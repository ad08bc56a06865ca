//! The lane-level road network: lanes, junctions, signals, crossings and sidewalks, with routing on them.
//!
//! Frame: world (right-handed, metres, z up), double precision. A lane's `s` runs along its centre line in the
//! direction of travel, from 0 to its length; `t` is positive to the left, as in OpenDRIVE.
//!
//! A map is read from a file ([`opendrive::read`], [`osm::read`]) into a [`RoadMap`], or a generator fills a
//! [`RoadNetwork`] and calls [`RoadNetwork::finish`], which derives the rest from the geometry: predecessors, conflict areas
//! inside junctions, the lanes that each crossing cuts, spawn points.
//!
//! ```
//! use endless_road::opendrive;
//!
//! let text = r#"<OpenDRIVE><header revMajor="1" revMinor="6"/>
//!   <road id="1" length="100" junction="-1">
//!     <planView><geometry s="0" x="0" y="0" hdg="0" length="100"><line/></geometry></planView>
//!     <lanes><laneSection s="0">
//!       <center><lane id="0" type="none"/></center>
//!       <right><lane id="-1" type="driving"><width sOffset="0" a="3.5" b="0" c="0" d="0"/></lane></right>
//!     </laneSection></lanes>
//!   </road></OpenDRIVE>"#;
//! let map = opendrive::read(text)?;
//! let lane = &map.network.lanes[0];
//! assert_eq!(lane.width_m, 3.5);
//! // Lane -1 lies to the right of the reference line, and traffic on it runs along.
//! let middle = lane.centerline.at(50.0);
//! assert!((middle.position.y + 1.75).abs() < 1e-9 && middle.heading_rad.abs() < 1e-9);
//! # Ok::<(), opendrive::OpenDriveError>(())
//! ```

mod border;
mod conflict;
mod cut;
mod error;
mod finish;
mod geographic;
mod junction_place;
mod line_numbers;
mod network;
mod network_fault;
pub mod opendrive;
pub mod osm;
mod polyline;
mod road_map;
mod route;
mod signal_coordination;
mod spawn;
pub mod swept;
mod terrain;
mod walk;
mod yellow;

pub use border::Borders;
pub use conflict::{gives_way, near_ranges, swept_overlap};
pub use error::NetworkError;
pub use geographic::Georeference;
pub use junction_place::JunctionPlace;
pub use line_numbers::LineNumbers;
pub use network::{
    Crossing, CrossingId, Junction, JunctionId, Lane, LaneConflict, LaneCut, LaneId, RoadNetwork, SignalPhase,
    SignalProgram, SpawnPoint, TrafficControl, Turn, WalkEdge, WalkEdgeId, WalkKind, WalkNetwork, WalkNodeId,
};
pub use network_fault::{NetworkFault, NetworkFaultKind};
pub use polyline::{Polyline, PolylinePoint};
pub use road_map::{
    BuildingFootprint, ImportNote, LandUse, LandUseArea, LaneSurface, LaneType, MapObject, MapObjectKind, MarkingColor,
    RoadMap, RoadMarking,
};
pub use route::likelihood_of;
pub use terrain::Terrain;
pub use walk::WalkGraph;
