//! Draws a map (`.xodr`, `.osm`, `.osm.pbf`) from above: `mapview FILE OUT.png [PIXELS [X Y METRES]]`. Strips by kind, paint, lanes with
//! their direction (ways through junctions thinner), stop lines by what governs them, crossings, sidewalks, things.
#![expect(clippy::print_stdout, reason = "a program")]

use endless_road::osm::{self, OsmOptions};
use endless_road::{LaneType, MapObjectKind, RoadMap, TrafficControl, WalkKind, opendrive};
use glam::{DVec2, DVec3};
use std::error::Error;

type Color = [u8; 3];

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let [file, out, rest @ ..] = &args[..] else {
        return Err("usage: mapview FILE OUT.png [PIXELS [X Y METRES]]".into());
    };
    let map = if file.ends_with(".xodr") {
        opendrive::read(&std::fs::read_to_string(file)?).map_err(|error| format!("{file}: {error}"))?
    } else {
        osm::read(&std::fs::read(file)?, &OsmOptions::default()).map_err(|error| format!("{file}: {error}"))?
    };
    let number = |i: usize| rest.get(i).map(|text| text.parse::<f64>()).transpose();
    let pixels = number(0)?.unwrap_or(1400.0);
    let (middle, metres) = match (number(1)?, number(2)?, number(3)?) {
        (Some(x), Some(y), Some(metres)) => (DVec2::new(x, y), metres),
        _ => extent(&map),
    };
    let mut canvas = Canvas::new(pixels as usize, middle, metres);
    draw(&map, &mut canvas);
    canvas.write(out)?;
    for note in &map.notes {
        println!("{}: {}", note.place, note.text);
    }
    Ok(())
}

fn extent(map: &RoadMap) -> (DVec2, f64) {
    let points = || map.network.lanes.iter().flat_map(|lane| lane.centerline.points()).map(|p| p.truncate());
    let low = points().fold(DVec2::INFINITY, DVec2::min);
    let high = points().fold(DVec2::NEG_INFINITY, DVec2::max);
    (low.midpoint(high), (high - low).max_element() * 1.05 + 10.0)
}

fn draw(map: &RoadMap, canvas: &mut Canvas) {
    let mut lane_surfaces: Vec<_> = map.lane_surfaces.iter().collect();
    lane_surfaces.sort_by_key(|strip| (strip.kind == LaneType::Driving, strip.in_junction));
    for strip in lane_surfaces {
        let color = match strip.kind {
            LaneType::Driving if strip.in_junction => [96, 96, 102],
            LaneType::Driving => [80, 80, 86],
            LaneType::Shoulder => [120, 116, 108],
            LaneType::Parking => [90, 90, 130],
            LaneType::Biking => [150, 80, 70],
            LaneType::Sidewalk => [190, 186, 176],
            LaneType::Curb => [220, 220, 220],
            LaneType::Median => [120, 150, 90],
            LaneType::Rail => [130, 90, 60],
        };
        for i in 1..strip.left.len() {
            canvas.quad([strip.left[i - 1], strip.left[i], strip.right[i], strip.right[i - 1]], color);
        }
    }
    for mark in &map.markings {
        let color = if mark.color == endless_road::MarkingColor::Yellow { [240, 200, 40] } else { [250, 250, 250] };
        let length = mark.line.length();
        let [paint, gap] = mark.dash.unwrap_or([length, 0.0]);
        let mut s = 0.0;
        while s < length {
            let n = (paint / 2.0).ceil().max(1.0);
            for k in 0..n as usize {
                let at = |k: f64| mark.line.at((s + paint * k / n).min(length)).position;
                canvas.line(at(k as f64), at(k as f64 + 1.0), mark.width_m, color);
            }
            s += (paint + gap).max(0.5);
        }
    }
    let network = &map.network;
    for crossing in &network.crossings {
        let color = if crossing.signal.is_some() { [120, 220, 255] } else { [255, 255, 255] };
        let [a, b] = crossing.ends;
        let n = (a.distance(b) / 1.2).ceil() as usize;
        for i in 0..n {
            let at = |x: f64| a.lerp(b, (i as f64 + x) / n as f64);
            canvas.line(at(0.2), at(0.8), crossing.width_m, color);
        }
    }
    for edge in &network.walk.edges {
        let [a, b] = edge.nodes.map(|node| network.walk.nodes[node.index()]);
        canvas.line(a, b, 0.5, if edge.kind == WalkKind::Sidewalk { [200, 60, 200] } else { [255, 120, 255] });
    }
    for lane in &network.lanes {
        let (color, width) = match lane.junction {
            Some(_) => ([230, 160, 60], 0.2),
            None if lane.left.is_some() || lane.right.is_some() => ([90, 200, 120], 0.35),
            None => ([70, 150, 230], 0.35),
        };
        for pair in lane.centerline.points().windows(2) {
            canvas.line(pair[0], pair[1], width, color);
        }
        let length = lane.centerline.length();
        let n = (length / 25.0).ceil();
        for i in 0..n as usize {
            let place = lane.centerline.at(length * (i as f64 + 0.5) / n);
            let along = DVec2::from_angle(place.heading_rad);
            let tip = place.position + (along * 1.5).extend(0.0);
            for side in [along.perp(), -along.perp()] {
                canvas.line(tip, place.position + (side * 0.8).extend(0.0), width, color);
            }
        }
        let end = lane.centerline.at(length);
        let across = (DVec2::from_angle(end.heading_rad).perp() * 0.45 * lane.width_m).extend(0.0);
        let color = match lane.end_control {
            TrafficControl::Free if lane.successors.is_empty() => [0, 0, 0],
            TrafficControl::Free => continue,
            TrafficControl::Signal(id) => {
                [[255, 40, 40], [40, 255, 40], [255, 255, 0], [60, 160, 255]][usize::from(id.0) % 4]
            }
            TrafficControl::Stop => [180, 0, 0],
            TrafficControl::Yield => [255, 140, 0],
        };
        canvas.line(end.position - across, end.position + across, 0.8, color);
    }
    for thing in &map.objects {
        let (color, size) = match &thing.kind {
            MapObjectKind::TrafficLight(id) => {
                ([[255, 40, 40], [40, 255, 40], [255, 255, 0], [60, 160, 255]][usize::from(id.0) % 4], 1.6)
            }
            MapObjectKind::Stop | MapObjectKind::Yield => ([200, 0, 0], 1.4),
            MapObjectKind::Tree(_) => ([40, 130, 40], 2.0),
            _ => ([30, 30, 160], 1.2),
        };
        let ahead = (DVec2::from_angle(thing.heading_rad) * 2.0 * size).extend(0.0);
        canvas.line(thing.position, thing.position - ahead, 0.3, color);
        canvas.line(thing.position, thing.position + DVec3::X * 0.01, size, color);
    }
}

struct Canvas {
    size: usize,
    pixels: Vec<u8>,
    corner: DVec2,
    scale: f64,
}

impl Canvas {
    fn new(size: usize, middle: DVec2, metres: f64) -> Self {
        let corner = middle + DVec2::new(-0.5, 0.5) * metres;
        Self { size, pixels: [226, 232, 214].repeat(size * size), corner, scale: size as f64 / metres }
    }

    fn pixel_of(&self, p: DVec3) -> DVec2 {
        DVec2::new(p.x - self.corner.x, self.corner.y - p.y) * self.scale
    }

    fn line(&mut self, a: DVec3, b: DVec3, width_m: f64, color: Color) {
        let along = (b - a).truncate().normalize_or(DVec2::X);
        let half = along * 0.5 * width_m.max(1.0 / self.scale);
        let (side, ahead) = (half.perp().extend(0.0), if a.distance(b) < 0.1 { half.extend(0.0) } else { DVec3::ZERO });
        self.quad([a + side - ahead, b + side + ahead, b - side + ahead, a - side - ahead], color);
    }

    /// Fills a quadrangle, whichever way round.
    fn quad(&mut self, corners: [DVec3; 4], color: Color) {
        let p = corners.map(|corner| self.pixel_of(corner));
        for [a, b, c] in [[p[0], p[1], p[2]], [p[0], p[2], p[3]]] {
            let low = a.min(b).min(c).floor().max(DVec2::ZERO);
            let high = a.max(b).max(c).ceil().min(DVec2::splat(self.size as f64));
            let area = (b - a).perp_dot(c - a);
            for y in low.y as usize..high.y.max(0.0) as usize {
                for x in low.x as usize..high.x.max(0.0) as usize {
                    let q = DVec2::new(x as f64 + 0.5, y as f64 + 0.5);
                    let inside = |u: DVec2, v: DVec2| (v - u).perp_dot(q - u) * area >= 0.0;
                    if inside(a, b) && inside(b, c) && inside(c, a) {
                        let at = 3 * (y * self.size + x);
                        self.pixels[at..at + 3].copy_from_slice(&color);
                    }
                }
            }
        }
    }

    fn write(&self, path: &str) -> Result<(), Box<dyn Error>> {
        let size = self.size as u32;
        let mut encoder = png::Encoder::new(std::fs::File::create(path)?, size, size);
        encoder.set_color(png::ColorType::Rgb);
        encoder.write_header()?.write_image_data(&self.pixels)?;
        Ok(())
    }
}
