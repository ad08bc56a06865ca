//! From a document to a [`RoadMap`].

mod approach;
mod crossings;
mod lane_alignment;
mod lane_links;
mod lane_simplify;
mod lane_surfaces;
mod lane_types;
mod lanes;
mod markings;
mod neighbours;
mod objects;
mod outline;
mod sampled;
mod signal_meaning;
mod signal_program;
mod signals;
mod turnaround;
mod walk;

use super::{OpenDriveDocument, OpenDriveError};
use crate::{RoadMap, RoadNetwork, signal_coordination};
use sampled::SampledDocument;

/// Reads an OpenDRIVE file's text.
///
/// # Errors
/// If it is not well-formed XML or not OpenDRIVE, is larger than a map can be, or has no lane for driving. What can be
/// mended is mended, and an impossible road is left out, with a note: the rest of the map is good.
pub fn read(text: &str) -> Result<RoadMap, OpenDriveError> {
    let mut document = OpenDriveDocument::parse(text)?;
    let in_file = document.roads.len() + document.roads_left_out.len();
    let sections = sampled::sample(&mut document)?;
    let sampled = SampledDocument::new(&document, sections);
    let mut notes = [&document.notes[..], &document.roads_left_out].concat();
    let joins = lane_links::joins(&sampled, &mut notes);
    let mut graph = lanes::LaneGraph::new(&sampled, &joins, &mut notes);
    graph.simplify();
    lane_alignment::mend(&mut graph, &mut notes);
    let loops = turnaround::add(&mut graph, document.junctions.len(), &mut notes);
    let (mut lanes, junctions) = graph.finish(&sampled)?;
    if lanes.is_empty() {
        return Err(OpenDriveError::NoLanes { roads: in_file, why: document.roads_left_out.first().cloned() });
    }
    lane_alignment::drop_unaligned(&mut lanes, &mut notes);
    neighbours::find(&sampled, &graph, &mut lanes);
    let mut crossings = crossings::crossings(&sampled, &lanes, &mut notes);
    if !document.lanes_end_at_stops {
        approach::end_before_crossings(&mut lanes, &crossings);
    }
    let walk = walk::walk(&sampled, &joins, &mut crossings, &mut notes);
    let mut network = RoadNetwork { lanes, junctions, crossings, walk, ..RoadNetwork::default() };
    let governed = signals::governed(&sampled, &graph, &mut notes);
    let groups = signals::apply(&sampled, &governed, &mut network, &mut notes);
    signals::apply_priorities(&sampled, &graph, &mut network);
    let left = document.roads.iter().filter(|road| road.left_hand).count();
    let mut network = network.finish()?;
    signal_coordination::coordinate(&mut network);
    let mut map = RoadMap {
        network,
        lane_surfaces: lane_surfaces::lane_surfaces(&sampled),
        markings: markings::markings(&sampled),
        left_hand: 2 * left > document.roads.len(),
        georeference: document.georeference.clone(),
        notes,
        ..RoadMap::default()
    };
    map.lane_surfaces.extend(loops);
    objects::add(&sampled, &governed, &groups, &mut map);
    let lines = approach::stop_lines(&map.network.lanes, &map.markings);
    map.markings.extend(lines);
    Ok(map)
}
