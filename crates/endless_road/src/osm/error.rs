//! Why a file is no map.

/// Errors in OpenStreetMap files, with their positions.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum OsmError {
    /// The XML is malformed or ends too early.
    #[error("line {line}, column {column}: {reason}")]
    Xml {
        /// Counted from 1.
        line: usize,
        /// Counted from 1, in bytes.
        column: usize,
        /// What is wrong.
        reason: String,
    },
    /// The PBF is malformed, ends too early, or uses what cannot be read.
    #[error("byte {offset}: {reason}")]
    Pbf {
        /// Of the blob in the file.
        offset: usize,
        /// What is wrong.
        reason: String,
    },
    /// Neither `.osm` nor `.osm.pbf`.
    #[error("this is neither OpenStreetMap XML nor PBF: it begins with {beginning:?}")]
    Unknown {
        /// The first bytes.
        beginning: String,
    },
    /// No road for vehicles in it.
    #[error("no road for vehicles in {ways} ways and {nodes} nodes")]
    NoRoads {
        /// How many ways there are.
        ways: usize,
        /// How many nodes there are.
        nodes: usize,
    },
    /// More than a network can number.
    #[error("too large: {count} {what}, at most {most} can be numbered; cut a smaller extract")]
    TooLarge {
        /// What there are too many of.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many there may be.
        most: usize,
    },
    /// A road reaches further than any town.
    #[error(
        "too large: node {node} of way {way} ({lat:.5}, {lon:.5}) lies {km:.0} km from the middle of the roads, at most \
         {most_km:.0} km are read; cut a smaller extract, or mend the node"
    )]
    TooWide {
        /// The way's id.
        way: i64,
        /// The node's id.
        node: i64,
        /// Of the node, degrees.
        lat: f64,
        /// Of the node, degrees.
        lon: f64,
        /// Its distance, kilometres.
        km: f64,
        /// The farthest that is read, kilometres.
        most_km: f64,
    },
    /// More road than a city has.
    #[error("too large: with way {way} there are more than {most_km:.0} km of roads; cut a smaller extract")]
    TooLong {
        /// The way's id.
        way: i64,
        /// The most that is read, kilometres.
        most_km: f64,
    },
    /// More roads meet at a node than anywhere on Earth.
    #[error("node {node} ({lat:.5}, {lon:.5}): {arms} roads meet here, at most {most} are read as a junction")]
    Crowded {
        /// The node's id.
        node: i64,
        /// Of the node, degrees.
        lat: f64,
        /// Of the node, degrees.
        lon: f64,
        /// How many roads end at it or pass through, each way counted.
        arms: usize,
        /// How many there may be.
        most: usize,
    },
    /// The network made from it contradicts itself.
    #[error("the network made from this file is wrong: {0}")]
    Network(#[from] crate::NetworkError),
}
