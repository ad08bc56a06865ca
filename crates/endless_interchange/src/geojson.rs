//! What is known of a map as GeoJSON (RFC 7946): lanes, crossings, sidewalks, signals, buildings and cameras.
//!
//! Coordinates are longitude and latitude (WGS 84) and height where the map says where on Earth it lies; else metres
//! east, north and up, which the member `coordinates` of the collection says.

use crate::signal_cycle::signal_cycle;
use endless_road::{BuildingFootprint, Georeference, RoadNetwork, TrafficControl, Turn, WalkKind};
use endless_town::Town;
use geojson::{Feature, FeatureCollection, Geometry};
use glam::{DVec2, DVec3, Vec3};
use serde_json::{Value, json};

/// A town and what its file says beyond it.
pub(crate) struct GeoJsonSource<'a> {
    pub(crate) town: &'a Town,
    pub(crate) footprints: &'a [BuildingFootprint],
    pub(crate) georeference: Option<&'a str>,
}

/// From the map's metres to the coordinates that are written.
struct CoordinateWriter(Option<Georeference>);

fn rounded(x: f64, per_unit: f64) -> f64 {
    (x * per_unit).round() / per_unit
}

impl CoordinateWriter {
    fn flat(&self, p: DVec2) -> [f64; 2] {
        match self.0 {
            Some(frame) => frame.lon_lat(p).map(|degrees| rounded(degrees, 1e8)),
            None => p.to_array().map(|metres| rounded(metres, 1e3)),
        }
    }

    fn point(&self, p: DVec3) -> [f64; 3] {
        let [x, y] = self.flat(p.truncate());
        [x, y, rounded(p.z, 1e3)]
    }

    fn line(&self, points: impl IntoIterator<Item = DVec3>) -> Geometry {
        Geometry::new_line_string(points.into_iter().map(|p| self.point(p)))
    }

    fn polygon(&self, rings: impl IntoIterator<Item = Vec<DVec2>>) -> Geometry {
        let closed = |ring: Vec<DVec2>| -> Vec<[f64; 2]> {
            let first = ring.first().copied();
            ring.into_iter().chain(first).map(|p| self.flat(p)).collect()
        };
        Geometry::new_polygon(rings.into_iter().map(closed))
    }

    fn at(&self, p: DVec3) -> Geometry {
        Geometry::new_point(self.point(p))
    }
}

/// A feature of these properties, an object.
fn feature(geometry: Geometry, properties: Value) -> Feature {
    let Value::Object(properties) = properties else { unreachable!("properties are written as objects") };
    Feature { geometry: Some(geometry), properties: Some(properties), ..Feature::default() }
}

/// The whole file.
pub(crate) fn write(source: &GeoJsonSource<'_>) -> String {
    let town = source.town;
    let frame = CoordinateWriter(source.georeference.and_then(Georeference::parse));
    let mut features = lanes(&town.network, &frame);
    features.extend(crossings_and_sidewalks(&town.network, &frame));
    features.extend(signals(town, &frame));
    features.extend(source.footprints.iter().map(|f| building(f, &frame)));
    features.extend(cameras(town, &frame));
    let coordinates = match frame.0 {
        Some(_) => "longitude and latitude (WGS 84), degrees; height, metres",
        None => "metres east, north and up in the map's own frame: it does not say where on Earth it lies",
    };
    let members = [("name", town.name.as_str()), ("coordinates", coordinates)];
    let foreign_members = Some(members.map(|(key, text)| (key.to_owned(), Value::from(text))).into_iter().collect());
    format!("{}\n", FeatureCollection { bbox: None, features, foreign_members })
}

fn lanes(network: &RoadNetwork, frame: &CoordinateWriter) -> Vec<Feature> {
    let lanes = network.lanes.iter().map(|lane| {
        let turn = match lane.turn {
            Turn::Straight => "straight",
            Turn::Left => "left",
            Turn::Right => "right",
            Turn::UTurn => "u_turn",
        };
        let (control, signal) = match lane.end_control {
            TrafficControl::Free => ("free", None),
            TrafficControl::Signal(signal) => ("signal", Some(signal.0)),
            TrafficControl::Stop => ("stop", None),
            TrafficControl::Yield => ("yield", None),
        };
        feature(
            frame.line(lane.centerline.points().iter().copied()),
            json!({
                "kind": "lane", "id": lane.id.0, "width_m": rounded(lane.width_m, 1e3),
                "speed_limit_kmh": rounded(lane.speed_limit_mps * 3.6, 10.0), "junction": lane.junction.map(|j| j.0),
                "turn": turn, "end": control, "signal": signal,
                "successors": lane.successors.iter().map(|l| l.0).collect::<Vec<_>>(),
                "left": lane.left.map(|l| l.0), "right": lane.right.map(|l| l.0),
            }),
        )
    });
    lanes.collect()
}

fn crossings_and_sidewalks(network: &RoadNetwork, frame: &CoordinateWriter) -> Vec<Feature> {
    let crossings = network.crossings.iter().enumerate().map(|(id, crossing)| {
        let signal = crossing.signal.map(|s| s.0);
        let properties =
            json!({ "kind": "crossing", "id": id, "width_m": rounded(crossing.width_m, 1e3), "signal": signal });
        feature(frame.line(crossing.ends), properties)
    });
    let walk = &network.walk;
    let sidewalks = walk.edges.iter().filter(|e| e.kind == WalkKind::Sidewalk).map(|edge| {
        let properties = json!({ "kind": "sidewalk", "width_m": rounded(edge.width_m, 1e3) });
        feature(frame.line(edge.nodes.map(|n| walk.nodes[n.index()])), properties)
    });
    crossings.chain(sidewalks).collect()
}

/// Compass bearing of a direction, degrees clockwise from north.
fn bearing(direction: Vec3) -> f64 {
    let angle = endless_world::math::f64::atan2(f64::from(direction.x), f64::from(direction.y));
    rounded(angle.to_degrees().rem_euclid(360.0), 100.0)
}

fn signals(town: &Town, frame: &CoordinateWriter) -> Vec<Feature> {
    let heads = town.placements.iter().filter_map(|p| Some((p.signal?, p.world_from_object)));
    let heads = heads.map(|(signal, place)| {
        let faces = bearing(place.transform_vector3(Vec3::X));
        let properties = json!({ "kind": "signal", "signal": signal.0, "faces_deg": faces, "cycle": signal_cycle(&town.network, signal) });
        feature(frame.at(Vec3::from(place.translation).as_dvec3()), properties)
    });
    heads.collect()
}

fn building(footprint: &BuildingFootprint, frame: &CoordinateWriter) -> Feature {
    let rings = std::iter::once(footprint.outline.clone()).chain(footprint.holes.iter().cloned());
    let properties = json!({
        "kind": "building", "building": footprint.kind, "height_m": footprint.height_m, "levels": footprint.levels,
    });
    feature(frame.polygon(rings), properties)
}

fn cameras(town: &Town, frame: &CoordinateWriter) -> Vec<Feature> {
    let cameras = town.cameras.iter().map(|site| {
        let [x, y, z] = site.position.map(f64::from);
        let (sin, cos) = endless_world::math::sin_cos(site.yaw_rad);
        let degrees = |radians: f32| rounded(f64::from(radians).to_degrees(), 100.0);
        let properties = json!({
            "kind": "camera", "name": site.name, "bearing_deg": bearing(Vec3::new(cos, sin, 0.0)),
            "down_tilt_deg": degrees(site.down_tilt_rad), "horizontal_fov_deg": degrees(site.horizontal_fov_rad),
            "mount": site.mount,
        });
        feature(frame.at(DVec3::new(x, y, z)), properties)
    });
    cameras.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_asset::Catalogue;

    fn written(georeference: Option<&str>) -> (Town, Value) {
        let town = endless_town::load("Town02", &Catalogue::builtin()).expect("a town");
        let outline = vec![DVec2::new(10.0, 10.0), DVec2::new(20.0, 10.0), DVec2::new(20.0, 25.0)];
        let (height_m, kind) = (Some(7.5), "house".to_owned());
        let footprints = [BuildingFootprint { outline, holes: vec![], height_m, levels: None, kind, color: None }];
        let text = write(&GeoJsonSource { town: &town, footprints: &footprints, georeference });
        let value = serde_json::from_str(&text).expect("JSON");
        (town, value)
    }

    fn of<'a>(file: &'a Value, kind: &str) -> Vec<&'a Value> {
        let features = file["features"].as_array().expect("features");
        features.iter().filter(|f| f["properties"]["kind"] == kind).collect()
    }

    #[test]
    fn everything_is_there_in_metres() {
        let (town, file) = written(None);
        assert!(file["coordinates"].as_str().expect("said").starts_with("metres"));
        let lanes = of(&file, "lane");
        assert_eq!(lanes.len(), town.network.lanes.len());
        let first = town.network.lanes[0].centerline.points()[0];
        let there = &lanes[0]["geometry"]["coordinates"][0];
        assert!((there[0].as_f64().expect("x") - first.x).abs() < 1e-3);
        assert_eq!(of(&file, "crossing").len(), town.network.crossings.len());
        assert_eq!(of(&file, "camera").len(), town.cameras.len());
        assert!(!of(&file, "signal").is_empty() && !of(&file, "sidewalk").is_empty());
        let ring = of(&file, "building")[0]["geometry"]["coordinates"][0].as_array().expect("a ring");
        assert_eq!((ring.len(), &ring[0]), (4, &ring[3]));
    }

    #[test]
    fn a_georeferenced_map_is_in_degrees() {
        let (_, file) = written(Some("+proj=tmerc +lat_0=48 +lon_0=11 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m"));
        let corner = &of(&file, "building")[0]["geometry"]["coordinates"][0][0];
        let (lon, lat) = (corner[0].as_f64().expect("lon"), corner[1].as_f64().expect("lat"));
        assert!((lat - (48.0 + 10.0 / 111_200.0)).abs() < 1e-6 && (lon - (11.0 + 10.0 / 74_540.0)).abs() < 1e-6);
    }
}
