//! Left-hand traffic is right-hand traffic in a mirror: the map is mirrored when it is read, built, and mirrored back.

use super::extract::OsmTags;
use crate::{BuildingFootprint, LandUseArea, Lane, LaneSurface, MapObject, Polyline, RoadMap, RoadMarking, Turn};
use endless_world::math::f64::wrap_angle;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// A road's tags as seen in a mirror: left is right, and lanes are counted from the other side.
pub(super) fn tags(tags: &OsmTags) -> OsmTags {
    let mut mirrored = OsmTags::default();
    for (key, value) in tags.iter() {
        let words: Vec<&str> = key.split(':').map(side).collect();
        let by_lane = words.contains(&"lanes") && value.contains('|');
        let value = if by_lane { value.rsplit('|').map(turned).collect::<Vec<_>>().join("|") } else { turned(value) };
        mirrored.set(words.join(":"), value);
    }
    mirrored
}

fn side(word: &str) -> &str {
    match word {
        "left" => "right",
        "right" => "left",
        other => other,
    }
}

fn turned(value: &str) -> String {
    let word = |w: &str| {
        let mut swapped = String::with_capacity(w.len());
        let parts: Vec<&str> = w.split('_').map(side).collect();
        swapped.push_str(&parts.join("_"));
        swapped
    };
    value.split(';').map(word).collect::<Vec<_>>().join(";")
}

fn flip(p: DVec3) -> DVec3 {
    DVec3::new(-p.x, p.y, p.z)
}

fn line(of: &Polyline) -> Polyline {
    Polyline::new(of.points().iter().copied().map(flip))
}

/// An outline keeps its sense of rotation.
fn outline(of: &mut [DVec2]) {
    of.reverse();
    of.iter_mut().for_each(|p| p.x = -p.x);
}

/// The finished map, back from the mirror.
pub(super) fn map(map: &mut RoadMap) {
    let network = &mut map.network;
    for lane in &mut network.lanes {
        let Lane { centerline, left, right, turn, .. } = lane;
        *centerline = line(centerline);
        std::mem::swap(left, right);
        *turn = match *turn {
            Turn::Left => Turn::Right,
            Turn::Right => Turn::Left,
            other => other,
        };
    }
    network.crossings.iter_mut().for_each(|c| c.ends = c.ends.map(flip));
    network.walk.nodes.iter_mut().for_each(|n| *n = flip(*n));
    for LaneSurface { left, right, .. } in &mut map.lane_surfaces {
        std::mem::swap(left, right);
        left.iter_mut().chain(right).for_each(|p| *p = flip(*p));
    }
    for RoadMarking { line: paint, .. } in &mut map.markings {
        *paint = line(paint);
    }
    for area in &mut map.junction_areas {
        area.reverse();
        area.iter_mut().for_each(|p| *p = flip(*p));
    }
    for LandUseArea { outline: o, holes, .. } in &mut map.areas {
        outline(o);
        holes.iter_mut().for_each(|h| outline(h));
    }
    for BuildingFootprint { outline: o, holes, .. } in &mut map.footprints {
        outline(o);
        holes.iter_mut().for_each(|h| outline(h));
    }
    for MapObject { position, heading_rad, .. } in &mut map.objects {
        *position = flip(*position);
        *heading_rad = wrap_angle(PI - *heading_rad);
    }
    map.left_hand = true;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_swap_their_sides() {
        let mut given = OsmTags::default();
        for (k, v) in
            [("turn:lanes", "left|through;right"), ("sidewalk", "left"), ("cycleway:left", "lane"), ("name", "x")]
        {
            given.set(k.into(), v.into());
        }
        let seen = tags(&given);
        assert_eq!(seen.get("turn:lanes"), Some("through;left|right"));
        assert_eq!(seen.get("sidewalk"), Some("right"));
        assert_eq!(seen.get("cycleway:right"), Some("lane"));
        assert_eq!(tags(&seen), given);
    }
}
