//! Every town, written as OpenDRIVE and read back, is the same network.
#![expect(clippy::unwrap_used, reason = "tests")]

use endless_road::{Lane, RoadMap, RoadNetwork, TrafficControl, Turn, opendrive};
use glam::DVec3;
use std::collections::BTreeSet;

/// Distance from a point to a lane's centre line, in space.
fn off(lane: &Lane, p: DVec3) -> f64 {
    let distance = |pair: &[DVec3]| {
        let along = pair[1] - pair[0];
        let t = ((p - pair[0]).dot(along) / along.length_squared()).clamp(0.0, 1.0);
        p.distance(pair[0] + along * t)
    };
    lane.centerline.points().windows(2).map(distance).fold(f64::INFINITY, f64::min)
}

/// How far two lanes are from one another where they are farthest, looking from both.
fn apart(a: &Lane, b: &Lane) -> f64 {
    let from = |x: &Lane, y: &Lane| x.centerline.points().iter().map(|&p| off(y, p)).fold(0.0, f64::max);
    from(a, b).max(from(b, a))
}

/// For every lane the lane of the other network that begins and ends where it does.
fn matching(ours: &RoadNetwork, theirs: &RoadNetwork) -> Vec<usize> {
    let ends = |lane: &Lane| {
        let points = lane.centerline.points();
        (points[0], points[points.len() - 1])
    };
    let find = |lane: &Lane| {
        let (start, end) = ends(lane);
        let distance = |other: &Lane| {
            let (a, b) = ends(other);
            a.distance(start) + b.distance(end)
        };
        let nearest = theirs.lanes.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
        assert!(distance(nearest) < 0.02, "lane {:?} has no match", lane.id);
        nearest.id.index()
    };
    ours.lanes.iter().map(find).collect()
}

#[test]
fn towns_come_back_as_they_went_out() {
    for town in crate::towns() {
        let name = &town.name;
        let map = RoadMap { network: town.network.clone(), ..RoadMap::default() };
        let text = opendrive::write(&map, name);
        let back = opendrive::read(&text).unwrap_or_else(|error| panic!("{name}: {error}"));
        assert!(back.notes.is_empty(), "{name}: {:?}", back.notes);
        let (a, b) = (&map.network, &back.network);
        assert_eq!(a.lanes.len(), b.lanes.len(), "{name}");
        let place = matching(a, b);
        assert_eq!(place.iter().collect::<BTreeSet<_>>().len(), place.len(), "{name}: one to one");
        let mut farthest = 0.0f64;
        for lane in &a.lanes {
            let other = &b.lanes[place[lane.id.index()]];
            farthest = farthest.max(apart(lane, other));
            let seen = |ids: &[endless_road::LaneId]| ids.iter().map(|id| place[id.index()]).collect::<BTreeSet<_>>();
            let got = |ids: &[endless_road::LaneId]| ids.iter().map(|id| id.index()).collect::<BTreeSet<_>>();
            assert_eq!(seen(&lane.successors), got(&other.successors), "{name} {:?}", lane.id);
            assert_eq!(seen(lane.left.as_slice()), got(other.left.as_slice()), "{name} {:?} left", lane.id);
            assert_eq!(seen(lane.right.as_slice()), got(other.right.as_slice()), "{name} {:?} right", lane.id);
            assert_eq!(lane.junction.is_some(), other.junction.is_some());
            assert!((lane.width_m - other.width_m).abs() < 1e-6, "{name} {:?}", lane.id);
            // The file does not say what turns off and what goes on: only left and right are never confused.
            let either = [lane.turn, other.turn].contains(&Turn::Straight);
            assert!(lane.turn == other.turn || either, "{name} {:?}: {:?}", lane.id, lane.turn);
            assert!((lane.speed_limit_mps - other.speed_limit_mps).abs() < 1e-6);
            let kind = |control: TrafficControl| match control {
                TrafficControl::Free => 0,
                TrafficControl::Signal(_) => 1,
                TrafficControl::Stop => 2,
                TrafficControl::Yield => 3,
            };
            assert_eq!(kind(lane.end_control), kind(other.end_control), "{name} {:?}", lane.id);
        }
        println!("{name}: {} lanes, at most {:.4} m apart", a.lanes.len(), farthest);
        assert!(farthest < 0.01, "{name}: {farthest}");
    }
}
