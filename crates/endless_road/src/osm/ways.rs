//! Ways for vehicles: which there are, what they are, and where they lie.

use super::class::{RoadClass, speed_mps};
use super::country::Country;
use super::extract::{Extract, Tags, Way};
use super::section::{self, Said, Section};
use super::site::Site;
use glam::DVec2;

/// No two nodes of a way that follow one another are this far apart, metres: one of them is elsewhere by mistake.
const FARTHEST_M: f64 = 20_000.0;

/// A point of a way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Vertex {
    /// The node's id; below `i64::MIN / 2` where a way was cut at the extract's edge.
    pub(super) node: i64,
    pub(super) at: DVec2,
}

/// Above or below the ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct Level {
    pub(super) bridge: bool,
    pub(super) tunnel: bool,
    pub(super) layer: i8,
}

/// A stretch of road between two places.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Stretch {
    pub(super) vertices: Vec<Vertex>,
    /// One a segment.
    pub(super) levels: Vec<Level>,
    pub(super) section: Section,
    pub(super) class: RoadClass,
    pub(super) link: bool,
    pub(super) roundabout: bool,
    pub(super) speed_mps: f64,
    /// The way at its beginning and at its end.
    pub(super) ways: [i64; 2],
    /// A driveway or an aisle: paved, but no way to anywhere.
    pub(super) yard: bool,
}

impl Stretch {
    pub(super) fn length(&self) -> f64 {
        self.vertices.windows(2).map(|v| v[0].at.distance(v[1].at)).sum()
    }

    pub(super) fn reversed(mut self) -> Self {
        self.vertices.reverse();
        self.levels.reverse();
        self.section = self.section.reversed();
        self.ways.reverse();
        self
    }

    pub(super) fn end_node(&self, end: usize) -> i64 {
        if end == 0 { self.vertices[0].node } else { self.vertices[self.vertices.len() - 1].node }
    }

    /// The part between two vertices, both included.
    pub(super) fn part(&self, from: usize, to: usize) -> Self {
        Self {
            vertices: self.vertices[from..=to].to_vec(),
            levels: self.levels[from..to].to_vec(),
            section: self.section.clone(),
            ..*self
        }
    }
}

fn level(tags: &Tags) -> Level {
    let layer = tags.get("layer").and_then(|v| v.trim().parse::<f64>().ok()).unwrap_or(0.0).clamp(-5.0, 5.0) as i8;
    let bridge = tags.get("bridge").is_some_and(|v| v != "no");
    let tunnel = tags.get("tunnel").is_some_and(|v| !matches!(v, "no" | "building_passage"));
    let layer = if layer == 0 { i8::from(bridge) - i8::from(tunnel) } else { layer };
    Level { bridge, tunnel, layer }
}

/// 1 along the way, −1 against it, 0 for both directions.
fn direction(tags: &Tags, class: RoadClass, link: bool) -> i8 {
    match tags.get("oneway") {
        Some("yes" | "true" | "1") => 1,
        Some("-1" | "reverse") => -1,
        Some("no" | "false" | "0") => 0,
        _ if is_roundabout(tags) || class == RoadClass::Motorway => 1,
        _ if link && matches!(class, RoadClass::Trunk) => 1,
        _ => 0,
    }
}

fn is_roundabout(tags: &Tags) -> bool {
    tags.is("junction", &["roundabout", "circular"])
}

/// All stretches of all ways for vehicles, cut at the edge of the site, and not yet at junctions.
pub(super) fn collect(extract: &Extract, site: &mut Site<'_>) -> Vec<Stretch> {
    let mut stretches = Vec::new();
    for way in &extract.ways {
        let tags = site.tags(&way.tags);
        let Some((class, link)) = RoadClass::of(&tags) else { continue };
        let direction = direction(&tags, class, link);
        for (vertices, levels) in runs(way, &tags, site) {
            let stretch = stretch(way, &tags, class, link, direction, vertices, levels, site);
            stretches.push(stretch);
        }
    }
    stretches
}

fn stretch(
    way: &Way,
    tags: &Tags,
    class: RoadClass,
    link: bool,
    direction: i8,
    vertices: Vec<Vertex>,
    levels: Vec<Level>,
    site: &Site<'_>,
) -> Stretch {
    let middle = vertices[vertices.len() / 2].at;
    let said = Said {
        tags,
        class,
        link,
        oneway: direction != 0,
        roundabout: is_roundabout(tags),
        built_up: site.built_up(middle),
    };
    let country: &Country = &site.country;
    let yard = class == RoadClass::Service
        && (tags.is("service", &["driveway", "parking_aisle", "drive-through", "emergency_access", "slipway"])
            || tags.is("access", &["private", "customers", "delivery", "no"])
            || tags.is("highway", &["services", "rest_area"]));
    let stretch = Stretch {
        vertices,
        levels,
        section: section::of(&said),
        class,
        link,
        roundabout: said.roundabout,
        speed_mps: speed_mps(tags, class, link, country),
        ways: [way.id; 2],
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
pub(super) fn runs(way: &Way, tags: &Tags, site: &mut Site<'_>) -> Vec<(Vec<Vertex>, Vec<Level>)> {
    let level = level(tags);
    let mut runs: Vec<Vec<Vertex>> = vec![Vec::new()];
    let mut before: Option<Vertex> = None;
    for &node in &way.nodes {
        let Some(at) = site.place(node) else {
            site.missing(way.id, node);
            runs.push(Vec::new());
            before = None;
            continue;
        };
        let vertex = Vertex { node, at };
        if let Some(last) = before
            && last.at.distance(at) > FARTHEST_M
        {
            let km = last.at.distance(at) / 1000.0;
            site.note(format!("way {}", way.id), format!("two of its nodes are {km:.0} km apart: it is cut there"));
            runs.push(Vec::new());
            before = None;
        }
        if let Some(last) = before
            && site.inside(last.at) != site.inside(at)
        {
            let cut = site.cut(last.at, at);
            let run = runs.last_mut().expect("never empty");
            if run.last().is_none_or(|last| last.at.distance(cut.at) > 0.05) {
                run.push(cut);
            }
            if !site.inside(at) {
                runs.push(Vec::new());
            }
        }
        before = Some(vertex);
        if site.inside(at) {
            let run = runs.last_mut().expect("never empty");
            if run.last().is_none_or(|last| last.at.distance(at) > 0.05 && last.node != node) {
                run.push(vertex);
            } else if let Some(last) = run.last_mut() {
                // Two nodes at one place: the later one may be where others join.
                *last = Vertex { node, at: last.at };
            }
        }
    }
    runs.retain(|run| run.len() >= 2);
    runs.into_iter().map(|run| (run.clone(), vec![level; run.len() - 1])).collect()
}
