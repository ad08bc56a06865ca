//! Places of a junction at which one puts up a pole, and heights of the ground near roads.

use crate::network::{Junction, Lane, RoadNetwork};
use endless_world::math::f64::sin_cos;
use glam::{DVec2, DVec3};

/// A junction as those see it who put something up there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JunctionPlace {
    /// Its middle, on the road surface.
    pub centre: DVec3,
    /// Beside the roadway at its corners: north-east, north-west, south-west, south-east.
    pub corners: [DVec3; 4],
}

/// From the edge of the outermost lane to a pole, metres.
const BESIDE_M: f64 = 1.2;
/// Farthest corner, metres from the middle.
const FARTHEST_M: f64 = 60.0;
/// Farthest road from which the height of the ground is told, metres.
const NEAR_ROAD_M: f64 = 40.0;

impl RoadNetwork {
    /// The junction with the most lanes; `None` where there is no junction.
    pub fn largest_junction(&self) -> Option<JunctionPlace> {
        let largest = self.junctions.iter().enumerate().max_by_key(|(i, junction)| {
            // The first of equal ones.
            (junction.lanes.len(), std::cmp::Reverse(*i))
        })?;
        self.place_of(largest.1)
    }

    fn place_of(&self, junction: &Junction) -> Option<JunctionPlace> {
        let inside = || junction.lanes.iter().flat_map(|&lane| self.lane(lane).centerline.points().iter().copied());
        let (low, high) = (inside().reduce(DVec3::min)?, inside().reduce(DVec3::max)?);
        let centre = (low + high) * 0.5;
        let is_near = |lane: &&Lane| {
            let away = |point: &DVec3| point.truncate().distance(centre.truncate());
            lane.centerline.points().iter().any(|point| away(point) < 2.0 * FARTHEST_M)
        };
        let near: Vec<&Lane> = self.lanes.iter().filter(is_near).collect();
        let corner = |quarter: u32| {
            let middle_deg = 45.0 + 90.0 * f64::from(quarter);
            // The nearest that is free, of bearings towards this corner.
            let bearings = (-8i32..=8).map(|step| (middle_deg + 5.0 * f64::from(step)).to_radians());
            let nearest = bearings
                .map(|bearing| {
                    let (sin, cos) = sin_cos(bearing);
                    let away = (8..=(2.0 * FARTHEST_M) as u32).map(|half_m| 0.5 * f64::from(half_m));
                    let at = |r: f64| centre.truncate() + DVec2::new(cos, sin) * r;
                    let free = away.clone().find(|&r| clearance(&near, at(r)) > BESIDE_M).unwrap_or(FARTHEST_M);
                    (free, at(free))
                })
                .reduce(|a, b| if b.0 < a.0 { b } else { a });
            let at = nearest.map_or(centre.truncate(), |(_, at)| at);
            at.extend(self.ground_near(at).unwrap_or(centre.z))
        };
        Some(JunctionPlace { centre, corners: [0, 1, 2, 3].map(corner) })
    }

    /// Height of the ground at a place, as the nearest lane or sidewalk has it, metres; `None` far from all of them.
    pub fn ground_near(&self, at: DVec2) -> Option<f64> {
        let on_lane = |lane: &Lane| lane.centerline.position(lane.centerline.project(at).0);
        let points = self.lanes.iter().map(on_lane).chain(self.walk.nodes.iter().copied());
        let nearest =
            points.map(|point| (point.truncate().distance(at), point.z)).reduce(|a, b| if b.0 < a.0 { b } else { a });
        nearest.filter(|(away, _)| *away <= NEAR_ROAD_M).map(|(_, z)| z)
    }
}

/// From the edge of the nearest lane, metres; below 0 on a lane.
fn clearance(lanes: &[&Lane], at: DVec2) -> f64 {
    let edge = |lane: &&Lane| {
        let (s, _) = lane.centerline.project(at);
        lane.centerline.position(s).truncate().distance(at) - 0.5 * lane.width_m
    };
    lanes.iter().map(edge).fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opendrive;

    #[test]
    fn poles_stand_beside_the_roads_of_a_crossroads() {
        let map = opendrive::read(include_str!("../tests/data/crossroads.xodr")).expect("a map");
        let network = map.network;
        let JunctionPlace { centre, corners } = network.largest_junction().expect("a junction");
        let lanes: Vec<&Lane> = network.lanes.iter().collect();
        for (corner, quarter) in
            corners.iter().zip([DVec2::ONE, DVec2::new(-1.0, 1.0), -DVec2::ONE, DVec2::new(1.0, -1.0)])
        {
            let away = corner.truncate() - centre.truncate();
            assert!(away.dot(quarter) > 0.0, "{corner} is not towards {quarter}");
            assert!(clearance(&lanes, corner.truncate()) > BESIDE_M && away.length() < FARTHEST_M);
            assert_eq!(network.ground_near(corner.truncate()), Some(corner.z));
        }
        assert_eq!(network.ground_near(DVec2::splat(1e5)), None);
    }
}
