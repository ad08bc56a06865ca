//! How far the roads of an extract may reach: further, a node is misplaced, or the extract is of a country.

use super::OsmError;
use super::import_context::ImportContext;
use super::street_segment::StreetSegment;

/// Roads lie within this distance of their middle, north or south, east or west, metres.
const REACH_M: f64 = 25_000.0;
/// All of them together are no longer than this, metres.
const LENGTH_M: f64 = 3_000_000.0;

/// Checks all stretches.
///
/// # Errors
/// [`OsmError::TooWide`] with the farthest node, [`OsmError::TooLong`] with the way at which the roads were too long.
pub(super) fn check(stretches: &[StreetSegment], context: &ImportContext<'_>) -> Result<(), OsmError> {
    let median = |along: fn(&glam::DVec2) -> f64| {
        let mut values: Vec<f64> = stretches.iter().flat_map(|s| &s.vertices).map(|v| along(&v.at)).collect();
        values.sort_by(f64::total_cmp);
        values.get(values.len() / 2).copied().unwrap_or(0.0)
    };
    let middle = glam::DVec2::new(median(|p| p.x), median(|p| p.y));
    let mut length = 0.0;
    for stretch in stretches {
        for vertex in &stretch.vertices {
            let away = (vertex.at - middle).abs().max_element();
            if away > REACH_M {
                let node = context.extract.nodes.get(&vertex.node);
                return Err(OsmError::TooWide {
                    way: stretch.ways[0],
                    node: vertex.node,
                    lat: node.map_or(f64::NAN, |n| n.lat),
                    lon: node.map_or(f64::NAN, |n| n.lon),
                    km: away / 1000.0,
                    most_km: REACH_M / 1000.0,
                });
            }
        }
        length += stretch.length();
        if length > LENGTH_M {
            return Err(OsmError::TooLong { way: stretch.ways[0], most_km: LENGTH_M / 1000.0 });
        }
    }
    Ok(())
}
