//! Buildings on the footprints of a map.

use crate::building::BuildingKind;
use crate::building::{BuildingDimensions, BuildingOutline, WindowNumbers, house, on_rectangle};
use crate::camera::BuildingPrism;
use crate::dressing::ground::ground_grid::GroundGrid;
use crate::dressing::ground::pavement_index::PavementIndex;
use crate::geometry::{OccupiedSpace, Rect, area, around, inside};
use endless_road::{BuildingFootprint, LaneType};
use endless_scene::Mesh;
use endless_world::Stream;
use endless_world::math::f64::atan2;
use glam::{Affine3A, DVec2, Quat};

/// Footprints smaller than this are kiosks and errors of drawing, m².
const LEAST_M2: f64 = 9.0;
/// Storeys are this high where a height is known but not their number.
const STOREY_M: f64 = 3.1;
/// Most storeys that are believed.
const MOST_STOREYS: f64 = 60.0;

/// A finished building.
pub(crate) struct PlacedBuilding {
    pub(crate) mesh: Mesh,
    pub(crate) place: Affine3A,
    pub(crate) solid: BuildingPrism,
}

/// Builds on all footprints that do not stand on a road.
pub(crate) fn build(
    footprints: &[BuildingFootprint],
    pavement: &PavementIndex,
    land: &GroundGrid,
    occupied: &mut OccupiedSpace,
    numbers: &mut WindowNumbers,
    seed: u64,
) -> Vec<PlacedBuilding> {
    let outlines: Vec<Vec<DVec2>> = footprints.iter().map(|f| cleaned(&f.outline)).collect();
    let dense = FootprintNeighbours::new(&outlines);
    let mut built = Vec::new();
    for (i, (footprint, outline)) in footprints.iter().zip(&outlines).enumerate() {
        if outline.len() < 3 || area(outline) < LEAST_M2 || on_a_road(outline, pavement) {
            continue;
        }
        let mut stream = Stream::named(seed, "town/footprint", &[i as u64]);
        let rect = around(outline);
        occupied.take(rect);
        let blind: Vec<bool> = (0..outline.len()).map(|k| dense.against(&outlines, i, k)).collect();
        let front = front_edge(outline, &blind, pavement);
        let (kind, storeys) = guess(footprint, area(outline), blind.iter().any(|b| *b), &mut stream);
        let shops = matches!(kind, BuildingKind::Terrace | BuildingKind::Flats | BuildingKind::Office)
            && (is_shop(&footprint.kind) || (footprint.kind == "yes" && stream.chance(0.2)));
        let edge = outline[(front + 1) % outline.len()] - outline[front];
        let dimensions = BuildingDimensions {
            kind,
            style: None,
            width: edge.length() as f32,
            depth: (area(outline) / edge.length().max(1.0)) as f32,
            storeys,
            shops,
            party_walls: [false; 2],
        };
        let site = FootprintSite { footprint, outline, front, blind: &blind, rect };
        built.push(raise(&site, dimensions, land, &mut stream, numbers));
    }
    built
}

/// A footprint that is built on.
struct FootprintSite<'a> {
    footprint: &'a BuildingFootprint,
    /// Its outline without doubled points, counter-clockwise.
    outline: &'a [DVec2],
    /// The edge at the street.
    front: usize,
    /// Edges that stand against a neighbour.
    blind: &'a [bool],
    /// The smallest rectangle around it.
    rect: Rect,
}

fn raise(
    site: &FootprintSite<'_>,
    dimensions: BuildingDimensions,
    land: &GroundGrid,
    stream: &mut Stream,
    numbers: &mut WindowNumbers,
) -> PlacedBuilding {
    let FootprintSite { footprint, outline, front, blind, rect } = *site;
    let base = land.level(front_middle(outline, front)).max(land.range(outline).0 + 0.05);
    let n = outline.len();
    let height = footprint.height_m.filter(|h| (2.2..400.0).contains(h)).map(|h| h as f32);
    let color = footprint.color;
    let square = area(outline) > 0.94 * 4.0 * rect.half.x * rect.half.y && footprint.holes.is_empty() && n == 4;
    let pitched = matches!(dimensions.kind, BuildingKind::House | BuildingKind::Terrace | BuildingKind::Barn)
        && dimensions.storeys <= 4;
    let (mesh, place, top) = if square && pitched {
        // In the frame of its front.
        let (a, b) = (outline[front], outline[(front + 1) % n]);
        let angle = atan2((b - a).y, (b - a).x);
        let middle = (a + b) / 2.0;
        let (width, depth) = (a.distance(b), outline[(front + 2) % n].distance(b));
        let dimensions = BuildingDimensions {
            width: width as f32,
            depth: depth as f32,
            // Right and left walls follow the front in the outline.
            party_walls: [blind[(front + 1) % n], blind[(front + 3) % n]],
            ..dimensions
        };
        let half = width / 2.0;
        let local = [(-half, 0.0), (half, 0.0), (half, depth), (-half, depth)].map(|(x, y)| DVec2::new(x, y));
        let block = BuildingOutline { outline: &local, holes: &[], front: 0, blind: &[], color, height };
        let (mesh, top) = on_rectangle(&dimensions, &block, stream, numbers);
        let turn = Quat::from_rotation_z(angle as f32);
        (mesh, Affine3A::from_rotation_translation(turn, middle.extend(base).as_vec3()), top)
    } else {
        let origin = rect.centre;
        let local: Vec<DVec2> = outline.iter().map(|p| *p - origin).collect();
        let holes: Vec<Vec<DVec2>> = footprint.holes.iter().map(|h| h.iter().map(|p| *p - origin).collect()).collect();
        let block = BuildingOutline { outline: &local, holes: &holes, front, blind, color, height };
        let (mesh, top) = house(&dimensions, &block, stream, numbers);
        (mesh, Affine3A::from_translation(origin.extend(base).as_vec3()), top)
    };
    PlacedBuilding { mesh, place, solid: BuildingPrism { outline: outline.to_vec(), base, top: base + f64::from(top) } }
}

/// Without doubled points, counter-clockwise.
fn cleaned(outline: &[DVec2]) -> Vec<DVec2> {
    let mut kept: Vec<DVec2> = Vec::new();
    for &p in outline.iter().filter(|p| p.is_finite()) {
        if kept.last().is_none_or(|last: &DVec2| last.distance(p) > 0.05) {
            kept.push(p);
        }
    }
    while kept.len() > 1 && kept[0].distance(kept[kept.len() - 1]) < 0.05 {
        kept.pop();
    }
    // Points on straight walls would split their windows.
    let n = kept.len();
    let needed = |k: usize| {
        let (a, b, c) = (kept[(k + n - 1) % n], kept[k], kept[(k + 1) % n]);
        (b - a).normalize_or_zero().perp_dot((c - b).normalize_or_zero()).abs() > 0.03
    };
    let mut corners: Vec<DVec2> = (0..n).filter(|&k| n > 3 && needed(k)).map(|k| kept[k]).collect();
    if corners.len() < 3 {
        corners = kept;
    }
    if area(&corners) < 0.0 {
        corners.reverse();
    }
    corners
}

/// Buildings over the carriageway are passages or errors of drawing.
fn on_a_road(outline: &[DVec2], pavement: &PavementIndex) -> bool {
    let n = outline.len();
    let drives = |p: DVec2| pavement.at(p).any(|(piece, _)| piece.kind == LaneType::Driving);
    let centre = outline.iter().sum::<DVec2>() / n as f64;
    let mut samples = vec![centre];
    for k in 0..n {
        let (a, b) = (outline[k], outline[(k + 1) % n]);
        let steps = (a.distance(b) / 2.0).ceil().max(1.0) as usize;
        samples.extend((0..steps).map(|i| a.lerp(b, i as f64 / steps as f64).lerp(centre, 0.02)));
    }
    samples.into_iter().any(drives)
}

fn front_middle(outline: &[DVec2], front: usize) -> DVec2 {
    (outline[front] + outline[(front + 1) % outline.len()]) / 2.0
}

/// The wall that looks at the nearest pavement.
fn front_edge(outline: &[DVec2], blind: &[bool], pavement: &PavementIndex) -> usize {
    let n = outline.len();
    let cost = |k: usize| {
        let (a, b) = (outline[k], outline[(k + 1) % n]);
        let length = a.distance(b);
        let out = -(b - a).normalize_or(DVec2::X).perp();
        let middle = (a + b) / 2.0;
        let street = (1..24).map(f64::from).find(|&d| pavement.is_paved(middle + out * d)).unwrap_or(40.0);
        street - 0.6 * length.min(20.0) + if blind[k] || length < 3.0 { 60.0 } else { 0.0 }
    };
    (0..n).min_by(|&a, &b| cost(a).total_cmp(&cost(b))).unwrap_or(0)
}

fn is_shop(kind: &str) -> bool {
    matches!(kind, "retail" | "commercial" | "supermarket" | "kiosk" | "shop" | "mall" | "hotel")
}

/// What a building is, and its storeys, from what the map says and its size.
fn guess(footprint: &BuildingFootprint, m2: f64, terraced: bool, stream: &mut Stream) -> (BuildingKind, u32) {
    let known = footprint.levels.or(footprint.height_m.map(|h| h / STOREY_M)).map(|l| l.clamp(1.0, MOST_STOREYS));
    let between = |stream: &mut Stream, low: u32, high: u32| low + stream.below((high - low + 1) as usize) as u32;
    let (kind, usual) = match footprint.kind.as_str() {
        "house" | "detached" | "semidetached_house" | "bungalow" | "villa" | "cabin" => {
            (BuildingKind::House, between(stream, 1, 2))
        }
        "terrace" => (BuildingKind::Terrace, between(stream, 2, 3)),
        "apartments" | "residential" | "dormitory" | "hotel" => (BuildingKind::Flats, between(stream, 3, 5)),
        "retail" | "supermarket" | "kiosk" | "shop" | "mall" => (BuildingKind::Shop, between(stream, 1, 2)),
        "commercial" | "office" | "bank" | "government" | "civic" | "public" | "school" | "university" | "hospital"
        | "college" | "church" => (BuildingKind::Office, between(stream, 2, 4)),
        "industrial" | "warehouse" | "hangar" | "manufacture" | "depot" => (BuildingKind::Hall, 2),
        "barn" | "farm" | "farm_auxiliary" | "stable" | "cowshed" => (BuildingKind::Barn, 1),
        "garage" | "garages" | "shed" | "roof" | "hut" | "service" | "carport" => (BuildingKind::Hall, 1),
        _ if m2 < 45.0 => (BuildingKind::House, 1),
        _ if terraced && m2 < 600.0 => (BuildingKind::Terrace, between(stream, 2, 3)),
        _ if m2 < 170.0 => (BuildingKind::House, between(stream, 1, 2)),
        _ if m2 < 900.0 => (BuildingKind::Flats, between(stream, 2, 4)),
        _ => (BuildingKind::Shop, between(stream, 1, 2)),
    };
    let storeys = known.map_or(usual, |l| l.round().max(1.0) as u32);
    let kind = match kind {
        BuildingKind::House if storeys > 3 => BuildingKind::Flats,
        BuildingKind::Flats | BuildingKind::Office if storeys > 13 => BuildingKind::Tower,
        BuildingKind::Shop if storeys > 3 => BuildingKind::Office,
        other => other,
    };
    (kind, storeys)
}

/// Which footprints are near to which.
struct FootprintNeighbours {
    centres: Vec<(DVec2, f64)>,
}

impl FootprintNeighbours {
    fn new(outlines: &[Vec<DVec2>]) -> Self {
        let centres = outlines.iter().map(|o| {
            let centre = o.iter().sum::<DVec2>() / o.len().max(1) as f64;
            (centre, o.iter().map(|p| p.distance(centre)).fold(0.0, f64::max))
        });
        Self { centres: centres.collect() }
    }

    /// Whether edge `k` of footprint `i` stands against another building.
    fn against(&self, outlines: &[Vec<DVec2>], i: usize, k: usize) -> bool {
        let (a, b) = (outlines[i][k], outlines[i][(k + 1) % outlines[i].len()]);
        let Some(way) = (b - a).try_normalize() else { return false };
        let p = (a + b) / 2.0 - way.perp() * 0.5;
        self.centres
            .iter()
            .enumerate()
            .any(|(j, (centre, radius))| j != i && centre.distance(p) < *radius && inside(&outlines[j], p))
    }
}
