//! Junctions and their connections.

use super::road::ContactPoint;

/// Type of a junction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum JunctionType {
    /// By connecting roads.
    #[default]
    Default,
    /// Road to road, such as motorway exits.
    Direct,
    /// A place beside a road that goes on.
    Virtual,
    /// Roads or rails cross without turning.
    Crossing,
}

/// A junction.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct JunctionRecord {
    /// Id.
    pub id: String,
    /// Line in the file.
    pub line: usize,
    /// Name, may be empty.
    pub name: String,
    /// Its type.
    pub kind: JunctionType,
    /// Paths through it.
    pub connections: Vec<JunctionConnection>,
    /// Road of higher and road of lower priority.
    pub priorities: Vec<(String, String)>,
    /// Controllers used here, with their place in the sequence.
    pub controllers: Vec<(String, u32)>,
}

/// A path through a junction (OpenDRIVE's `connection`).
#[derive(Debug, Clone, PartialEq)]
pub struct JunctionConnection {
    /// Line in the file.
    pub line: usize,
    /// The road that leads in.
    pub incoming: String,
    /// The road that leads on: the connecting road, or in a direct junction the linked road.
    pub connecting: String,
    /// The end of that road where it is entered.
    pub contact: ContactPoint,
    /// Lanes of the incoming and the connecting road.
    pub lane_links: Vec<(i32, i32)>,
}
