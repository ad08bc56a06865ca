//! What lies and stands beside the roads: land, buildings, trees, furniture.

use super::class::metres;
use super::extract::OsmTags;
use super::import_context::ImportContext;
use super::patch::patches;
use crate::{BuildingFootprint, LandUse, LandUseArea, LaneSurface, LaneType, MapObject, MapObjectKind, RoadMap};
use endless_world::math::f64::atan2;
use glam::DVec2;

/// Distance between trees of a row, metres.
const ROW_M: f64 = 8.0;
/// Width of watercourses where nothing is said, metres.
const RIVER_M: f64 = 15.0;
const STREAM_M: f64 = 2.0;
/// Width of a track's bed, metres.
const RAIL_M: f64 = 2.8;

/// Adds what the land is used as.
pub(super) fn land(context: &mut ImportContext<'_>, map: &mut RoadMap) {
    for patch in patches(context, true, |tags| land_use(tags).is_some()) {
        if let Some(kind) = land_use(patch.tags) {
            map.areas.push(LandUseArea { kind, outline: patch.outline, holes: patch.holes });
        }
    }
    // The large ones first: what is drawn later lies on top.
    map.areas.sort_by(|a, b| super::curve::area(&b.outline).total_cmp(&super::curve::area(&a.outline)));
    watercourses(context, map);
}

/// Adds what stands on it, once the roads are there.
pub(super) fn add(context: &mut ImportContext<'_>, map: &mut RoadMap) {
    rails(context, map);
    buildings(context, map);
    map_objects(context, map);
    tree_rows(context, map);
}

fn land_use(tags: &OsmTags) -> Option<LandUse> {
    if tags.get("building").is_some() || below_ground(tags) {
        return None;
    }
    let kind = |key: &str| tags.get(key).unwrap_or("");
    let kind = match (kind("leisure"), kind("landuse"), kind("natural"), kind("amenity")) {
        ("park" | "garden" | "playground" | "dog_park", ..)
        | (_, "cemetery" | "allotments" | "recreation_ground", ..) => LandUse::Park,
        ("pitch" | "golf_course" | "common", ..) => LandUse::Grass,
        ("swimming_pool" | "marina", ..) | (_, "reservoir" | "basin", ..) | (_, _, "water" | "bay", _) => {
            LandUse::Water
        }
        (_, "forest", ..) | (_, _, "wood", _) => LandUse::Wood,
        (_, "farmland" | "orchard" | "vineyard", ..) => LandUse::Farmland,
        (_, "grass" | "meadow" | "village_green" | "flowerbed" | "greenfield", ..)
        | (_, _, "grassland" | "scrub" | "heath" | "shrubbery", _) => LandUse::Grass,
        (.., "parking" | "bicycle_parking") => LandUse::Parking,
        (_, "residential", ..) => LandUse::Residential,
        (_, "commercial" | "retail" | "education" | "religious", ..) => LandUse::Commercial,
        (_, "industrial" | "garages" | "railway" | "port", ..) => LandUse::Industrial,
        (_, "construction" | "brownfield" | "landfill" | "quarry", ..)
        | (_, _, "sand" | "beach" | "bare_rock" | "shingle", _) => LandUse::Bare,
        (.., "marketplace") => LandUse::Plaza,
        _ if tags.is("place", &["square"]) => LandUse::Plaza,
        _ if tags.is("waterway", &["riverbank", "dock"]) => LandUse::Water,
        _ if tags.is("highway", &["pedestrian", "footway"])
            && (tags.is("area", &["yes"]) || tags.is("type", &["multipolygon"])) =>
        {
            LandUse::Plaza
        }
        _ if tags.is("area:highway", &["pedestrian"]) => LandUse::Plaza,
        _ => return None,
    };
    Some(kind)
}

fn below_ground(tags: &OsmTags) -> bool {
    tags.is("location", &["underground", "indoor"])
        || tags.is("parking", &["underground", "multi-storey", "rooftop"])
        || tags.get("indoor").is_some_and(|v| v != "no")
        || tags.get("layer").and_then(|v| v.parse::<f64>().ok()).is_some_and(|l| l < 0.0)
}

fn watercourses(context: &mut ImportContext<'_>, map: &mut RoadMap) {
    let extract = context.extract;
    for way in &extract.ways {
        let usual = match way.tags.get("waterway") {
            Some("river" | "canal") => RIVER_M,
            Some("stream" | "ditch" | "drain") => STREAM_M,
            _ => continue,
        };
        if way.tags.get("tunnel").is_some_and(|v| v != "no") {
            continue;
        }
        let half = 0.5 * way.tags.get("width").and_then(metres).unwrap_or(usual).clamp(0.5, 300.0);
        for (vertices, _) in super::ways::runs(way, &way.tags, context) {
            let points: Vec<_> = vertices.iter().map(|v| v.at.extend(0.0)).collect();
            let (left, right) = super::surface::ribbon(&points, half, -half, 2.0 * half + 5.0);
            let ring: Vec<DVec2> = right.iter().chain(left.iter().rev()).map(|p| p.truncate()).collect();
            if let Some(outline) = super::ring::tidy(&ring, true) {
                map.areas.push(LandUseArea { kind: LandUse::Water, outline, holes: Vec::new() });
            }
        }
    }
}

fn rails(context: &mut ImportContext<'_>, map: &mut RoadMap) {
    let extract = context.extract;
    for way in extract.ways.iter().filter(|w| w.tags.is("railway", &["rail", "tram", "light_rail", "narrow_gauge"])) {
        if way.tags.get("tunnel").is_some_and(|v| v != "no") || below_ground(&way.tags) {
            continue;
        }
        let bridge = way.tags.get("bridge").is_some_and(|v| v != "no");
        for (vertices, _) in super::ways::runs(way, &way.tags, context) {
            let points: Vec<_> = vertices.iter().map(|v| v.at.extend(context.ground(v.at) + 0.02)).collect();
            let (left, right) = super::surface::ribbon(&points, 0.5 * RAIL_M, -0.5 * RAIL_M, 40.0);
            map.lane_surfaces.push(LaneSurface {
                kind: LaneType::Rail,
                left,
                right,
                in_junction: true,
                unpaved: false,
                bridge,
            });
        }
    }
}

fn is_building(tags: &OsmTags) -> bool {
    tags.get("building").is_some_and(|v| v != "no") && !below_ground(tags)
}

/// Where buildings stand.
pub(super) fn outlines_of_buildings(context: &mut ImportContext<'_>) -> Vec<Vec<DVec2>> {
    let noted = context.notes.len();
    let outlines = patches(context, false, is_building).into_iter().map(|patch| patch.outline).collect();
    // They are told of when they are built.
    context.notes.truncate(noted);
    outlines
}

fn buildings(context: &mut ImportContext<'_>, map: &mut RoadMap) {
    for patch in patches(context, false, is_building) {
        let tags = patch.tags;
        let number =
            |key: &str| tags.get(key).and_then(|v| v.split(';').next()).and_then(|v| v.trim().parse::<f64>().ok());
        let levels = number("building:levels").filter(|l| (0.0..=200.0).contains(l)).map(|l| l.max(1.0));
        let roof = tags.get("roof:height").and_then(metres).unwrap_or(0.0);
        let height = tags.get("height").or_else(|| tags.get("building:height")).and_then(metres);
        let height_m = height.map(|h| if h - roof > 2.0 { h - roof } else { h }).filter(|h| *h < 900.0);
        map.footprints.push(BuildingFootprint {
            outline: patch.outline,
            holes: patch.holes,
            height_m,
            levels,
            kind: tags.get("building").unwrap_or("yes").to_owned(),
            color: color(tags),
        });
    }
}

/// Linear colour of walls, from their colour or else their material.
fn color(tags: &OsmTags) -> Option<[f32; 3]> {
    let srgb = tags.get("building:colour").or_else(|| tags.get("building:facade:colour")).and_then(srgb);
    let material = || match tags.get("building:material")? {
        "brick" => Some([150, 84, 66]),
        "concrete" => Some([168, 165, 158]),
        "stone" | "limestone" | "sandstone" => Some([190, 176, 150]),
        "wood" | "timber_framing" => Some([139, 106, 74]),
        "plaster" | "stucco" => Some([222, 212, 194]),
        "glass" | "mirror" => Some([120, 140, 155]),
        "metal" | "steel" => Some([150, 155, 160]),
        "adobe" | "mud" => Some([176, 138, 100]),
        _ => None,
    };
    srgb.or_else(material).map(|c| c.map(linear))
}

fn linear(byte: u8) -> f32 {
    endless_world::math::pow(f32::from(byte) / 255.0, 2.2)
}

fn srgb(text: &str) -> Option<[u8; 3]> {
    if let Some(hex) = text.strip_prefix('#').filter(|h| h.is_ascii()) {
        let byte = |i: usize| u8::from_str_radix(hex.get(i..i + 2)?, 16).ok();
        let nibble = |i: usize| u8::from_str_radix(hex.get(i..=i)?, 16).ok().map(|n| n * 17);
        return match hex.len() {
            6 => Some([byte(0)?, byte(2)?, byte(4)?]),
            3 => Some([nibble(0)?, nibble(1)?, nibble(2)?]),
            _ => None,
        };
    }
    Some(match text {
        "white" => [240, 240, 236],
        "black" => [40, 40, 40],
        "gray" | "grey" => [150, 150, 150],
        "lightgray" | "lightgrey" | "silver" => [200, 200, 200],
        "darkgray" | "darkgrey" => [95, 95, 95],
        "red" => [170, 60, 50],
        "brown" => [125, 85, 60],
        "maroon" => [110, 40, 40],
        "orange" => [210, 130, 60],
        "yellow" => [225, 200, 110],
        "beige" | "cream" | "ivory" => [225, 215, 190],
        "tan" => [205, 180, 140],
        "green" => [100, 140, 95],
        "blue" => [90, 120, 165],
        "pink" => [225, 170, 165],
        _ => return None,
    })
}

fn map_objects(context: &ImportContext<'_>, map: &mut RoadMap) {
    for (&id, node) in &context.extract.nodes {
        let Some(kind) = object_kind(&node.tags) else { continue };
        let Some(at) = context.place(id).filter(|&p| context.inside(p)) else { continue };
        let heading_rad = facing(map, at, &kind);
        map.objects.push(MapObject { kind, position: at.extend(context.ground(at)), heading_rad });
    }
}

fn object_kind(tags: &OsmTags) -> Option<MapObjectKind> {
    let height = || tags.get("height").and_then(metres).filter(|h| *h < 80.0);
    Some(if tags.is("natural", &["tree"]) {
        MapObjectKind::Tree(height())
    } else if tags.is("highway", &["street_lamp"]) {
        MapObjectKind::StreetLamp
    } else if tags.is("highway", &["bus_stop"]) {
        MapObjectKind::BusStop
    } else if tags.is("amenity", &["bench"]) {
        MapObjectKind::Bench
    } else if tags.is("amenity", &["waste_basket"]) {
        MapObjectKind::Bin
    } else if tags.is("barrier", &["bollard"]) {
        MapObjectKind::Bollard
    } else if tags.is("emergency", &["fire_hydrant"]) && !tags.is("fire_hydrant:type", &["underground", "wall"]) {
        MapObjectKind::Hydrant
    } else if tags.is("power", &["pole"]) || tags.is("man_made", &["utility_pole"]) {
        MapObjectKind::UtilityPole
    } else if tags.is("traffic_calming", &["bump", "hump"]) {
        MapObjectKind::SpeedBump
    } else {
        return None;
    })
}

/// Towards the nearest road; for stops the direction of the traffic beside them.
fn facing(map: &RoadMap, at: DVec2, kind: &MapObjectKind) -> f64 {
    if matches!(kind, MapObjectKind::Tree(_)) {
        return 0.0;
    }
    let mut best = (f64::INFINITY, 0.0);
    for lane in map.network.lanes.iter().filter(|l| l.junction.is_none()) {
        let points = lane.centerline.points();
        let near = points.windows(2).any(|w| {
            let reach = 60.0 + w[0].distance(w[1]);
            w[0].truncate().distance_squared(at) < reach * reach
        });
        if !near {
            continue;
        }
        let (s, t) = lane.centerline.project(at);
        if t.abs() < best.0 {
            let on = lane.centerline.at(s);
            let to = on.position.truncate() - at;
            best = (
                t.abs(),
                if matches!(kind, MapObjectKind::BusStop | MapObjectKind::SpeedBump) {
                    on.heading_rad
                } else {
                    atan2(to.y, to.x)
                },
            );
        }
    }
    best.1
}

fn tree_rows(context: &mut ImportContext<'_>, map: &mut RoadMap) {
    let extract = context.extract;
    for way in extract.ways.iter().filter(|w| w.tags.is("natural", &["tree_row"])) {
        for (vertices, _) in super::ways::runs(way, &way.tags, context) {
            let line = super::curve::line_through(vertices.iter().map(|v| v.at.extend(0.0)).collect());
            let n = (line.length() / ROW_M).round().clamp(1.0, 2000.0) as usize;
            for k in 0..=n {
                let at = line.at(line.length() * k as f64 / n as f64).position.truncate();
                let at = at.extend(context.ground(at));
                let taken = map
                    .objects
                    .iter()
                    .any(|t| matches!(t.kind, MapObjectKind::Tree(_)) && t.position.distance_squared(at) < 9.0);
                if !taken {
                    map.objects.push(MapObject { kind: MapObjectKind::Tree(None), position: at, heading_rad: 0.0 });
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_read() {
        assert_eq!(srgb("#fff"), Some([255; 3]));
        assert_eq!(srgb("#10ff00"), Some([16, 255, 0]));
        assert_eq!(srgb("#1€0"), None);
        assert_eq!(srgb("mauve-ish"), None);
    }
}
