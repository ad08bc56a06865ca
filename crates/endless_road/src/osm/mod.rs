//! OpenStreetMap: from an extract (`.osm` XML or `.osm.pbf`) to a [`RoadMap`].
//!
//! The steps, each a small file: read (`xml`, `pbf`) into an `extract`; lay it out in metres (`projection`,
//! `context`); ways become stretches with cross-sections (`ways`, `section`), cut and joined to a graph (`graph`),
//! raised on bridges and over the lie of the land (`height`, `relief`), rounded into streets (`plan`) and cut back where
//! they meet (`trim`); rules, crossings and lanes follow (`rules`, `crossing`, `lane`, `movement`, `connector`, `signal`,
//! `walk`), then what lies there (`surface`, `paint`) and stands beside it.
//!
//! Left-hand traffic is built in a `mirror`.

mod class;
mod connector;
mod country;
mod crossing;
mod curve;
mod dual_carriageway;
mod edge;
mod error;
mod extent;
mod extract;
mod formation;
mod graph;
mod height;
mod import_context;
mod junction_surface;
mod lane;
mod lift;
mod mirror;
mod movement;
mod paint;
mod patch;
mod path;
mod pbf;
mod plan;
mod plaza;
mod projection;
mod relief;
mod repair;
mod restriction;
mod ring;
mod rules;
mod section;
mod section_tags;
mod segment_index;
mod sign;
mod signal;
mod street_segment;
mod surface;
mod surroundings;
mod trim;
mod turnaround;
mod walk;
mod ways;
mod xml;

pub use error::OsmError;
pub use extract::{OsmBounds, OsmExtract, OsmMember, OsmMemberKind, OsmNode, OsmRelation, OsmTags, OsmWay};
pub(crate) use projection::{FLATTENING, RADIUS_M, raw as transverse_mercator};

use crate::{Junction, JunctionId, RoadMap, Terrain, signal_coordination};
use endless_world::DrivingSide;
use glam::DVec2;
use height::GroundHeight;
use import_context::ImportContext;
use plan::StreetPlan;

/// Options for reading an extract.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct OsmOptions {
    /// The side of traffic; by the extract's place where `None`.
    pub driving_side: Option<DrivingSide>,
    /// The lie of the land in the map's own frame (metres east and north of the extract's middle); flat where `None`.
    pub terrain: Option<Terrain>,
}

/// Reads the elements of a file, `.osm` or `.osm.pbf` by its content.
///
/// # Errors
/// [`OsmError`] with the place in the file where it is malformed, cut off or of another format.
pub fn read_extract(bytes: &[u8]) -> Result<OsmExtract, OsmError> {
    if pbf::looks_like(bytes) {
        return pbf::read(bytes);
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if text.trim_ascii_start().first() != Some(&b'<') {
        let beginning = String::from_utf8_lossy(&bytes[..bytes.len().min(16)]).into_owned();
        return Err(OsmError::Unknown { beginning });
    }
    xml::read(text)
}

/// Reads a map from a file, `.osm` or `.osm.pbf` by its content.
///
/// # Errors
/// [`OsmError`]: the file is malformed (with the place), has no roads, or too many.
pub fn read(bytes: &[u8], options: &OsmOptions) -> Result<RoadMap, OsmError> {
    map_from(&read_extract(bytes)?, options)
}

/// Makes a map of an extract.
///
/// # Errors
/// [`OsmError::NoRoads`], [`OsmError::TooLarge`], [`OsmError::TooWide`], [`OsmError::TooLong`], [`OsmError::Crowded`].
pub fn map_from(extract: &OsmExtract, options: &OsmOptions) -> Result<RoadMap, OsmError> {
    let mut context = ImportContext::new(extract, options.driving_side.map(|side| side == DrivingSide::Left));
    let ways = ways::collect(extract, &mut context);
    extent::check(&ways, &context)?;
    let stretches = graph::split(&graph::without_duplicates(&ways, &mut context));
    let (roads, yards) = graph::part_yards(stretches);
    if roads.is_empty() {
        return Err(OsmError::NoRoads { ways: extract.ways.len(), nodes: extract.nodes.len() });
    }
    let roads = rules::split_at_lights(graph::merge(graph::without_scraps(roads)), &context);
    let side = if context.mirrored { -1.0 } else { 1.0 };
    let natural = options.terrain.as_ref().map(|terrain| move |p: DVec2| terrain.height(DVec2::new(side * p.x, p.y)));
    let ground = natural.as_ref().map(|natural| natural as GroundHeight<'_>);
    let mut plan = StreetPlan::new(roads, ground);
    check_arms(&plan, &context)?;
    dual_carriageway::find(&mut plan);
    edge::open_ends(&mut plan, &context);
    turnaround::join_dead_ends(&mut plan);
    trim::trim(&mut plan);
    check_count("junctions", plan.intersections.len())?;
    if let Some(ground) = ground {
        context.formation = Some(relief::formation(&plan, ground));
    }
    let mut map = build(&mut plan, &mut context)?;
    surface::yards(&plan, &context, &yards, &mut map);
    surroundings::add(&mut context, &mut map);
    map.terrain.clone_from(&options.terrain);
    map.georeference = Some(context.projection.georeference());
    if context.mirrored {
        mirror::map(&mut map);
    }
    map.notes = context.into_notes();
    Ok(map)
}

/// No junction has more arms than any on Earth.
fn check_arms(plan: &StreetPlan, context: &ImportContext<'_>) -> Result<(), OsmError> {
    let Some(intersection) = plan.intersections.iter().find(|intersection| intersection.arms.len() > trim::MOST_ARMS)
    else {
        return Ok(());
    };
    let node = intersection.nodes[0];
    let [lat, lon] = context.extract.nodes.get(&node).map_or([f64::NAN; 2], |n| [n.lat, n.lon]);
    Err(OsmError::Crowded { node, lat, lon, arms: intersection.arms.len(), most: trim::MOST_ARMS })
}

fn check_count(what: &'static str, count: usize) -> Result<(), OsmError> {
    let most = usize::from(u16::MAX);
    if count > most { Err(OsmError::TooLarge { what, count, most }) } else { Ok(()) }
}

/// Lanes, signals, crossings, walks, surfaces and paint of a plan.
fn build(plan: &mut StreetPlan, context: &mut ImportContext<'_>) -> Result<RoadMap, OsmError> {
    let mut map = RoadMap::default();
    let network = &mut map.network;
    let mut groups = 0;
    rules::decide(plan, context, &mut groups);
    crossing::decide(plan, context);
    signal::number_walks(plan, &mut groups);
    check_count("signal groups", groups)?;
    check_count("crossings", plan.streets.iter().map(|s| s.crossings.len()).sum())?;
    network.signal_groups = groups as u16;
    lane::add(plan, network);
    walk::add(plan, network);
    let paths = path::add(plan, context, network);
    let restrictions = restriction::Restrictions::new(context.extract);
    let mut surfaces = RoadMap::default();
    for intersection in 0..plan.intersections.len() {
        if plan.intersections[intersection].arms.is_empty() {
            continue;
        }
        let junction = JunctionId(network.junctions.len() as u16);
        network.junctions.push(Junction::default());
        let movements = connector::sensible(plan, &movement::movements(plan, intersection, &restrictions));
        let lanes = connector::add(plan, network, junction, &movements);
        if let Some(formation) = &context.formation {
            for lane in &lanes {
                formation.lay(&mut network.lanes[lane.index()].centerline);
            }
        }
        network.junctions[junction.index()].program = signal::program(plan, intersection, &movements);
        let lanes: Vec<_> = lanes.iter().map(|&l| network.lane(l)).collect();
        if movements.len() == lanes.len() {
            let ways: Vec<_> = movements.iter().copied().zip(lanes.iter().copied()).collect();
            paint::through(plan, intersection, &ways, &mut surfaces);
        }
        junction_surface::intersection(plan, intersection, &movements, &lanes, &mut surfaces);
        junction_surface::connectors(plan, &lanes, &movements, &mut surfaces);
    }
    if let Some(formation) = &context.formation {
        surfaces.junction_areas = surfaces.junction_areas.iter().flat_map(|o| formation.pieces(o)).collect();
    }
    surroundings::land(context, &mut surfaces);
    plaza::add(&surfaces.areas, &surroundings::outlines_of_buildings(context), context, network);
    repair::mend(network, context);
    map.network = std::mem::take(&mut map.network).finish()?;
    signal_coordination::coordinate(&mut map.network);
    surface::streets(plan, &mut map);
    map.lane_surfaces.extend(surfaces.lane_surfaces);
    map.markings.extend(surfaces.markings);
    map.lane_surfaces.extend(paths.lane_surfaces);
    map.areas = surfaces.areas;
    map.junction_areas = surfaces.junction_areas;
    paint::streets(plan, &context.country, &mut map);
    sign::add(plan, &mut map);
    Ok(map)
}
