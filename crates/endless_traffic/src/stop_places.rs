//! Where people wait for buses: on the sidewalk at the kerb, beside the stop's sign.

use endless_road::{RoadNetwork, WalkEdge, WalkEdgeId, WalkKind};
use endless_world::BusStop;
use glam::{DVec2, DVec3};

/// Places along the kerb from the sign, metres: the nearest first, and none in its post.
const ALONG_M: [f64; 10] = [0.9, -0.9, 1.7, -1.7, 2.5, -2.5, 3.3, -3.3, 4.1, -4.1];
/// Sidewalks on which people wait leave room to pass: half their usable width, metres.
const ROOMY_M: f64 = 0.6;
/// Room to the edge of the sidewalk, beside bodies, metres.
const EDGE_M: f64 = 0.05;
/// A sign is no further than this beside its sidewalk, metres, and a place so far from the ends of a piece of it.
const BESIDE_M: f64 = 1.5;
const FROM_ENDS_M: f64 = 0.2;
/// Signs and sidewalks further above or below are on another level, metres.
const STOREY_M: f64 = 2.5;

/// A place at a stop.
#[derive(Debug, Clone, Copy)]
pub(crate) struct StopPlace {
    /// Of the stop, in the list of all.
    pub(crate) stop: usize,
    pub(crate) edge: WalkEdgeId,
    /// Where somebody stands.
    pub(crate) at: DVec2,
    /// Unit vector towards the road.
    pub(crate) road: DVec2,
}

/// All of them, by sidewalk; of a stop, the nearest to its sign first.
#[derive(Debug, Clone, Default)]
pub(crate) struct StopPlaces(Vec<StopPlace>);

impl StopPlaces {
    /// For bodies of this radius, metres.
    pub(crate) fn new(network: &RoadNetwork, stops: &[BusStop], body_m: f64) -> Self {
        let of_stop = |(stop, at): (usize, &BusStop)| places(network, stop, at.position.as_dvec3(), body_m);
        let mut all: Vec<StopPlace> = stops.iter().enumerate().flat_map(of_stop).collect();
        all.sort_by_key(|place| (place.edge.index(), place.stop));
        Self(all)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Those of a stop.
    pub(crate) fn at(&self, stop: usize) -> impl Iterator<Item = &StopPlace> {
        self.0.iter().filter(move |place| place.stop == stop)
    }

    pub(crate) fn on(&self, edge: WalkEdgeId) -> &[StopPlace] {
        let from = self.0.partition_point(|place| place.edge.index() < edge.index());
        let number = self.0[from..].partition_point(|place| place.edge == edge);
        &self.0[from..from + number]
    }
}

/// A sidewalk beside a point.
struct Beside {
    edge: WalkEdgeId,
    from: DVec2,
    along: DVec2,
    /// Of the point, along it, metres.
    s: f64,
    half_width: f64,
}

fn places(network: &RoadNetwork, stop: usize, sign: DVec3, body_m: f64) -> Vec<StopPlace> {
    let lanes = network.lanes.iter().filter(|lane| lane.junction.is_none());
    let nearest = lanes.map(|lane| {
        let (s, t) = lane.centerline.project(sign.truncate());
        (t.abs(), lane.centerline.position(s).truncate(), lane.centerline.direction(s))
    });
    let Some((_, lane, along)) = nearest.min_by(|a, b| a.0.total_cmp(&b.0)) else { return Vec::new() };
    let place = |off: &f64| {
        let on = beside(network, sign + (along * *off).extend(0.0), body_m)?;
        let middle = on.from + on.along * on.s;
        let road = on.along.perp() * on.along.perp_dot(lane - middle).signum();
        Some(StopPlace { stop, edge: on.edge, at: middle + road * (on.half_width - EDGE_M), road })
    };
    ALONG_M.iter().filter_map(place).collect()
}

/// The nearest sidewalk on which people may wait.
fn beside(network: &RoadNetwork, at: DVec3, body_m: f64) -> Option<Beside> {
    let walk = &network.walk;
    let found = |(number, edge): (usize, &WalkEdge)| {
        let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()]);
        let level = (0.5 * (a.z + b.z) - at.z).abs() < STOREY_M + 0.5 * (a.z - b.z).abs();
        let [from, to] = [a, b].map(DVec3::truncate);
        let along = (to - from).normalize_or_zero();
        let (s, t) = ((at.truncate() - from).dot(along), along.perp_dot(at.truncate() - from));
        let half_width = 0.5 * edge.width_m - body_m;
        let inside = s > FROM_ENDS_M && s < from.distance(to) - FROM_ENDS_M;
        let fits = edge.kind == WalkKind::Sidewalk && half_width > ROOMY_M && level && inside;
        let beside = Beside { edge: WalkEdgeId(number as u32), from, along, s, half_width };
        (fits && t.abs() < 0.5 * edge.width_m + BESIDE_M).then_some((t.abs(), beside))
    };
    let edges = walk.edges.iter().enumerate().filter_map(found);
    edges.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, beside)| beside)
}
