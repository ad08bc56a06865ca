//! From a document to a [`RoadMap`].

mod joins;
mod kind;
mod lanes;
mod mend;
mod sampled;
mod strips;

use super::{Document, OpenDriveError};
use crate::{RoadMap, RoadNetwork};
use sampled::Sampled;

/// Reads an OpenDRIVE file's text.
///
/// # Errors
/// If it is not well-formed XML or not OpenDRIVE, lacks what cannot be guessed, is larger than a map can be, or has
/// no lane for driving. What can be mended is mended, with a note.
pub fn read(text: &str) -> Result<RoadMap, OpenDriveError> {
    let document = Document::parse(text)?;
    let sampled = Sampled::new(&document)?;
    let mut notes = document.notes.clone();
    let joins = joins::joins(&sampled, &mut notes);
    let mut graph = lanes::Graph::new(&sampled, &joins, &mut notes);
    graph.simplify();
    mend::mend(&mut graph, &mut notes);
    let (lanes, junctions) = graph.finish(&sampled);
    if lanes.is_empty() {
        return Err(OpenDriveError::NoLanes { roads: document.roads.len() });
    }
    let network = RoadNetwork { lanes, junctions, ..RoadNetwork::default() };
    let left = document.roads.iter().filter(|road| road.left_hand).count();
    Ok(RoadMap {
        network: network.finish()?,
        strips: strips::strips(&sampled),
        left_hand: 2 * left > document.roads.len(),
        georeference: document.georeference.clone(),
        notes,
        ..RoadMap::default()
    })
}
