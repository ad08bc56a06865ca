//! Ways for vehicles: which there are, what they are, and where they lie.

use super::class::{RoadClass, speed_mps};
use super::country::CountryRules;
use super::extract::{OsmExtract, OsmTags, OsmWay};
use super::import_context::ImportContext;
use super::section_tags::{self, RoadTags};
use super::street_segment::{StreetSegment, StructureLevel, WayVertex};

/// No two nodes of a way that follow one another are this far apart, metres: one of them is elsewhere by mistake.
const FARTHEST_M: f64 = 20_000.0;

fn level(tags: &OsmTags) -> StructureLevel {
    let layer = tags.get("layer").and_then(|v| v.trim().parse::<f64>().ok()).unwrap_or(0.0).clamp(-5.0, 5.0) as i8;
    let bridge = tags.get("bridge").is_some_and(|v| v != "no");
    let tunnel = tags.get("tunnel").is_some_and(|v| !matches!(v, "no" | "building_passage"));
    let layer = if layer == 0 { i8::from(bridge) - i8::from(tunnel) } else { layer };
    StructureLevel { bridge, tunnel, layer }
}

/// 1 along the way, −1 against it, 0 for both directions.
fn direction(tags: &OsmTags, class: RoadClass, link: bool) -> i8 {
    match tags.get("oneway") {
        Some("yes" | "true" | "1") => 1,
        Some("-1" | "reverse") => -1,
        Some("no" | "false" | "0") => 0,
        _ if is_roundabout(tags) || class == RoadClass::Motorway => 1,
        _ if link && matches!(class, RoadClass::Trunk) => 1,
        _ => 0,
    }
}

fn is_roundabout(tags: &OsmTags) -> bool {
    tags.is("junction", &["roundabout", "circular"])
}

/// All stretches of all ways for vehicles, cut at the edge of the site, and not yet at junctions.
pub(super) fn collect(extract: &OsmExtract, context: &mut ImportContext<'_>) -> Vec<StreetSegment> {
    let mut stretches = Vec::new();
    for way in &extract.ways {
        let tags = context.tags(&way.tags);
        let Some((class, link)) = RoadClass::of(&tags) else { continue };
        for run in runs(way, &tags, context) {
            stretches.push(stretch((way.id, &tags), (class, link), run, context));
        }
    }
    stretches
}

fn stretch(
    (way, tags): (i64, &OsmTags),
    (class, link): (RoadClass, bool),
    (vertices, levels): (Vec<WayVertex>, Vec<StructureLevel>),
    context: &ImportContext<'_>,
) -> StreetSegment {
    let direction = direction(tags, class, link);
    let middle = vertices[vertices.len() / 2].at;
    let road = RoadTags {
        tags,
        class,
        link,
        oneway: direction != 0,
        roundabout: is_roundabout(tags),
        built_up: context.built_up(middle),
    };
    let country: &CountryRules = &context.country;
    let yard = class == RoadClass::Service
        && (tags.is("service", &["driveway", "parking_aisle", "drive-through", "emergency_access", "slipway"])
            || tags.is("access", &["private", "customers", "delivery", "no"])
            || tags.is("highway", &["services", "rest_area"]));
    let stretch = StreetSegment {
        vertices,
        levels,
        section: section_tags::of(&road),
        class,
        link,
        roundabout: road.roundabout,
        speed_mps: speed_mps(tags, class, link, country),
        ways: [way; 2],
        yard,
    };
    if direction >= 0 {
        return stretch;
    }
    // Against the way: the section was made as seen by who drives there.
    let section = stretch.section.clone();
    let mut turned = stretch.reversed();
    turned.section = section;
    turned
}

/// The runs of a way's nodes that exist and lie inside the site.
pub(super) fn runs(
    way: &OsmWay,
    tags: &OsmTags,
    context: &mut ImportContext<'_>,
) -> Vec<(Vec<WayVertex>, Vec<StructureLevel>)> {
    let level = level(tags);
    let mut runs: Vec<Vec<WayVertex>> = vec![Vec::new()];
    let mut before: Option<WayVertex> = None;
    for &node in &way.nodes {
        let Some(at) = context.place(node) else {
            context.missing(way.id, node);
            runs.push(Vec::new());
            before = None;
            continue;
        };
        let vertex = WayVertex { node, at };
        if let Some(last) = before
            && last.at.distance(at) > FARTHEST_M
        {
            let km = last.at.distance(at) / 1000.0;
            context.note(format!("way {}", way.id), format!("two of its nodes are {km:.0} km apart: it is cut there"));
            runs.push(Vec::new());
            before = None;
        }
        if let Some(last) = before
            && context.inside(last.at) != context.inside(at)
        {
            let cut = context.cut(last.at, at);
            let run = runs.last_mut().expect("never empty");
            if run.last().is_none_or(|last| last.at.distance(cut.at) > 0.05) {
                run.push(cut);
            }
            if !context.inside(at) {
                runs.push(Vec::new());
            }
        }
        before = Some(vertex);
        if context.inside(at) {
            let run = runs.last_mut().expect("never empty");
            if run.last().is_none_or(|last| last.at.distance(at) > 0.05 && last.node != node) {
                run.push(vertex);
            } else if let Some(last) = run.last_mut() {
                // Two nodes at one place: the later one may be where others join.
                *last = WayVertex { node, at: last.at };
            }
        }
    }
    runs.retain(|run| run.len() >= 2);
    runs.into_iter().map(|run| (run.clone(), vec![level; run.len() - 1])).collect()
}
