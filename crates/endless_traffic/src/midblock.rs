//! Where people could cross a road away from its crossings: straight over, from one sidewalk to the other.

use endless_road::swept::OrientedRectangle;
use endless_road::{Borders, Lane, LaneId, RoadNetwork, WalkEdge, WalkEdgeId, WalkKind};
use endless_world::Stream;
use glam::{DVec2, DVec3};

/// Distance between places along a sidewalk, and from its ends, metres.
const SPACING_M: f64 = 4.0;
const FROM_ENDS_M: f64 = 3.0;
/// The sidewalks are no further apart than this, metres.
const WIDEST_M: f64 = 28.0;
/// Nobody crosses more lanes than this, nor faster roads (60 km/h).
const MOST_LANES: usize = 4;
const FASTEST_MPS: f64 = 60.5 / 3.6;
/// With a crossing within this distance people use it, metres.
const CROSSING_M: f64 = 15.0;
/// Cosine of the largest angle between the sidewalks, and of the smallest between the way and a lane.
const PARALLEL: f64 = 0.95;
const ACROSS: f64 = 0.3;
/// Distance to the ends of lanes: junctions, stop lines, borders, metres.
const LANE_END_M: f64 = 12.0;
/// What lies between a sidewalk and the first lane, or two lanes, is no wider than this, metres.
const GAP_M: f64 = 3.2;
/// Room kept to parked vehicles, metres.
const PARKED_M: f64 = 0.7;
/// Lanes so much higher or lower are on another level, metres.
const STOREY_M: f64 = 2.0;

/// A lane that a way crosses.
#[derive(Debug, Clone, Copy)]
pub(crate) struct MidblockCut {
    pub(crate) lane: LaneId,
    /// On the lane, metres.
    pub(crate) s: f64,
    /// Of the lane's middle, from the way's beginning, metres.
    pub(crate) along_m: f64,
    pub(crate) half_width_m: f64,
    height: f64,
}

/// A way over a road, from the middle of one sidewalk to that of another.
#[derive(Debug, Clone)]
pub(crate) struct MidblockWay {
    /// From the first node of the sidewalk at which it begins, metres.
    pub(crate) edge_m: f64,
    pub(crate) onto: WalkEdgeId,
    /// At the heights of the sidewalks.
    pub(crate) ends: [DVec3; 2],
    /// Where the roadway begins and ends, metres from the first end.
    pub(crate) kerbs_m: [f64; 2],
    /// In the order in which they are crossed.
    pub(crate) cuts: Vec<MidblockCut>,
}

impl MidblockWay {
    pub(crate) fn length_m(&self) -> f64 {
        self.ends[0].truncate().distance(self.ends[1].truncate())
    }

    /// Height of the ground so far along it: of the sidewalks, and between their kerbs of the road.
    pub(crate) fn height(&self, along_m: f64) -> f64 {
        let [a, b] = self.ends.map(|end| end.z);
        let high = a + (b - a) * (along_m / self.length_m()).clamp(0.0, 1.0);
        let road = |m: f64| {
            let (first, last) = (self.cuts[0], self.cuts[self.cuts.len() - 1]);
            let share = (m - first.along_m) / (last.along_m - first.along_m).max(1e-6);
            first.height + (last.height - first.height) * share.clamp(0.0, 1.0)
        };
        let [begin, end] = self.kerbs_m;
        // A step down takes a foot's length.
        let on_road = ((along_m - begin).min(end - along_m) / 0.3 + 0.5).clamp(0.0, 1.0);
        high + (road(along_m) - high) * on_road
    }
}

/// All such ways of a map, by the sidewalk at which they begin.
#[derive(Debug, Clone, Default)]
pub(crate) struct MidblockWays {
    by_edge: Vec<Vec<MidblockWay>>,
}

impl MidblockWays {
    /// Of a map, clear of parked vehicles.
    pub(crate) fn new(network: &RoadNetwork, borders: &Borders, parked: &[OrientedRectangle]) -> Self {
        let map = Map { network, borders, parked };
        let edges = network.walk.edges.iter().enumerate();
        Self { by_edge: edges.map(|(number, edge)| map.ways_from(WalkEdgeId(number as u32), edge)).collect() }
    }

    pub(crate) fn from(&self, edge: WalkEdgeId) -> &[MidblockWay] {
        self.by_edge.get(edge.index()).map_or(&[], Vec::as_slice)
    }

    /// One of those that begin between two places of an edge, metres from its first node, and lead onto a sidewalk that is
    /// wanted.
    pub(crate) fn draw(
        &self,
        edge: WalkEdgeId,
        range_m: [f64; 2],
        wanted: impl Fn(WalkEdgeId) -> bool,
        stream: &mut Stream,
    ) -> Option<MidblockWay> {
        let within = |way: &&MidblockWay| way.edge_m >= range_m[0] && way.edge_m <= range_m[1] && wanted(way.onto);
        let ways: Vec<&MidblockWay> = self.from(edge).iter().filter(within).collect();
        (!ways.is_empty()).then(|| (*stream.pick(&ways)).clone())
    }
}

struct Map<'a> {
    network: &'a RoadNetwork,
    borders: &'a Borders,
    parked: &'a [OrientedRectangle],
}

/// Where two segments cross, as shares of both.
fn crossing([a, b]: [DVec2; 2], [c, d]: [DVec2; 2]) -> Option<[f64; 2]> {
    let (ab, cd) = (b - a, d - c);
    let turn = ab.perp_dot(cd);
    if turn.abs() < 1e-9 {
        return None;
    }
    let shares = [(c - a).perp_dot(cd) / turn, (c - a).perp_dot(ab) / turn];
    shares.iter().all(|share| (0.0..=1.0).contains(share)).then_some(shares)
}

impl Map<'_> {
    fn ends(&self, edge: &WalkEdge) -> [DVec3; 2] {
        edge.nodes.map(|node| self.network.walk.nodes[node.index()])
    }

    fn ways_from(&self, number: WalkEdgeId, edge: &WalkEdge) -> Vec<MidblockWay> {
        let [a, b] = self.ends(edge);
        let length = a.truncate().distance(b.truncate());
        if edge.kind != WalkKind::Sidewalk || length < 2.0 * FROM_ENDS_M {
            return Vec::new();
        }
        let ahead = (b - a).truncate() / length;
        let middle = 0.5 * (a + b).truncate();
        let reach = |[c, d]: [DVec2; 2]| 0.5 * (c.distance(d) + length) + WIDEST_M;
        let opposite: Vec<(WalkEdgeId, &WalkEdge)> = (0..)
            .map(WalkEdgeId)
            .zip(&self.network.walk.edges)
            .filter(|(other, there)| {
                let ends = self.ends(there).map(DVec3::truncate);
                let near = (0.5 * (ends[0] + ends[1])).distance(middle) < reach(ends);
                let parallel = (ends[1] - ends[0]).normalize_or_zero().dot(ahead).abs() > PARALLEL;
                *other != number && there.kind == WalkKind::Sidewalk && near && parallel
            })
            .collect();
        if opposite.is_empty() {
            return Vec::new();
        }
        let lanes: Vec<&Lane> = self
            .network
            .lanes
            .iter()
            .filter(|lane| {
                let points = lane.centerline.points().iter().map(|p| p.truncate());
                let (low, high) =
                    points.fold((DVec2::INFINITY, DVec2::NEG_INFINITY), |(low, high), p| (low.min(p), high.max(p)));
                let room = DVec2::splat(0.5 * length + WIDEST_M);
                (middle + room).cmpge(low).all() && (middle - room).cmple(high).all()
            })
            .collect();
        let places = ((length - 2.0 * FROM_ENDS_M) / SPACING_M) as u32;
        let mut ways = Vec::new();
        for place in 0..=places {
            let along = FROM_ENDS_M + SPACING_M * f64::from(place);
            let from = a.lerp(b, along / length);
            for side in [ahead.perp(), -ahead.perp()] {
                let to = from.truncate() + side * WIDEST_M;
                let hits = opposite.iter().filter_map(|&(other, there)| {
                    let [c, d] = self.ends(there);
                    let [share, along_there] = crossing([from.truncate(), to], [c.truncate(), d.truncate()])?;
                    let room = along_there.min(1.0 - along_there) * c.distance(d);
                    Some((share, other, there, c.lerp(d, along_there), room))
                });
                let Some((_, onto, there, end, room)) = hits.min_by(|x, y| x.0.total_cmp(&y.0)) else { continue };
                let edges_m = [edge, there].map(|edge| 0.5 * edge.width_m);
                if room < FROM_ENDS_M {
                    continue;
                }
                if let Some((kerbs_m, cuts)) = self.roadway([from, end], edges_m, &lanes) {
                    ways.push(MidblockWay { edge_m: along, onto, ends: [from, end], kerbs_m, cuts });
                }
            }
        }
        ways
    }

    /// The roadway between two sidewalks with these half widths, metres: where it begins and ends, and its lanes.
    fn roadway(
        &self,
        [from, to]: [DVec3; 2],
        half_widths_m: [f64; 2],
        lanes: &[&Lane],
    ) -> Option<([f64; 2], Vec<MidblockCut>)> {
        let way = [from, to].map(DVec3::truncate);
        let length = way[0].distance(way[1]);
        let across = (way[1] - way[0]) / length.max(1e-6);
        let mut cuts = Vec::new();
        for lane in lanes {
            let points = lane.centerline.points();
            for (number, pair) in points.windows(2).enumerate() {
                let Some([share, u]) = crossing(way, [pair[0].truncate(), pair[1].truncate()]) else { continue };
                let at = pair[0].lerp(pair[1], u);
                if (at.z - from.z).abs() > STOREY_M {
                    continue;
                }
                let s = lane.centerline.station(number) + u * pair[0].distance(pair[1]);
                let heading = (pair[1] - pair[0]).truncate().normalize_or_zero();
                let border = |lanes: &[LaneId]| lanes.binary_search(&lane.id).is_ok();
                let unfit = lane.junction.is_some()
                    || heading.dot(across).abs() > ACROSS
                    || s < LANE_END_M
                    || s > lane.centerline.length() - LANE_END_M
                    || lane.speed_limit_mps > FASTEST_MPS
                    || border(&self.borders.entries)
                    || border(&self.borders.exits);
                if unfit {
                    return None;
                }
                let along_m = share * length;
                cuts.push(MidblockCut { lane: lane.id, s, along_m, half_width_m: 0.5 * lane.width_m, height: at.z });
            }
        }
        cuts.sort_by(|a, b| a.along_m.total_cmp(&b.along_m).then(a.lane.cmp(&b.lane)));
        if cuts.is_empty() || cuts.len() > MOST_LANES {
            return None;
        }
        let kerbs_m = [half_widths_m[0], length - half_widths_m[1]];
        // Nothing but lanes between the kerbs: a parking strip at most.
        let mut reached = kerbs_m[0];
        for cut in &cuts {
            if cut.along_m - cut.half_width_m - reached > GAP_M {
                return None;
            }
            reached = cut.along_m + cut.half_width_m;
        }
        let narrow = kerbs_m[1] - kerbs_m[0] < 2.0;
        let crossing_near = self.network.crossings.iter().any(|crossing| {
            let ends = crossing.ends.map(DVec3::truncate);
            ends.iter().any(|end| way.iter().any(|at| at.distance(*end) < CROSSING_M))
        });
        let body = OrientedRectangle {
            center: 0.5 * (way[0] + way[1]),
            axis: across,
            half: DVec2::new(0.5 * length, PARKED_M),
        };
        let barred = self.parked.iter().any(|parked| parked.overlaps(&body));
        (kerbs_m[1] - reached <= GAP_M && !narrow && !crossing_near && !barred).then_some((kerbs_m, cuts))
    }
}
