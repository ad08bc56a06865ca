use super::*;
use crate::{Focus, TrafficMap};
use endless_road::{RoadNetwork, WalkEdge, WalkNetwork};
use endless_world::math::f64::{exp, sin_cos};
use std::f64::consts::TAU;

const STEP_S: f64 = 1.0 / 30.0;

/// People on ways without roads.
struct Crowd {
    roads: Roads,
    graph: WalkGraph,
    walkers: Vec<Walker>,
    /// Of the walkable surface, square metres.
    area: f64,
}

/// Where people go in a corridor.
#[derive(Debug, Clone, Copy)]
enum Directions {
    One,
    /// Half of them each way, on their right.
    Sorted,
    /// Half of them each way, anywhere.
    Mixed,
}

/// What a crowd did.
#[derive(Debug)]
struct Seen {
    /// Of all people at all looks, m/s.
    mean_mps: f64,
    /// Share of looks at which somebody hardly moved.
    standing: f64,
    /// Least distance between two, metres.
    nearest_m: f64,
    /// Furthest that a body was over the edge of its ways, metres.
    outside_m: f64,
}

fn ways(walk: WalkNetwork) -> (Roads, WalkGraph) {
    let network = RoadNetwork { walk, ..RoadNetwork::default() }.finish().expect("ways alone");
    let graph = WalkGraph::new(&network.walk);
    (Roads::new(&TrafficMap::new(network, &[]), &Focus::default(), &[]), graph)
}

impl Crowd {
    fn put(&mut self, stream: &mut Stream, edge: u32, turned: bool, position: DVec2) {
        let mut nodes = self.roads.network.walk.edges[edge as usize].nodes;
        if turned {
            nodes.reverse();
        }
        let spec = PedestrianSpec {
            walk_mps: (1.34 + 0.2 * stream.normal()).clamp(0.9, 1.9) as f32,
            ..PedestrianSpec::default()
        };
        let own = stream.fork(self.walkers.len() as u64);
        let mut walker = Walker::new(&self.roads, &spec, (WalkEdgeId(edge), nodes), position, own);
        walker.side = stream.range_f64(0.15, 0.85);
        walker.plan(&self.roads, &self.graph);
        self.walkers.push(walker);
    }

    /// A corridor of 3.5 m that closes on itself, with people evenly spread.
    fn corridor(density: f64, directions: Directions) -> Self {
        Self::corridor_of(3.5, density, directions)
    }

    /// The same of a width, metres.
    fn corridor_of(width_m: f64, density: f64, directions: Directions) -> Self {
        const SIDES: u32 = 20;
        const RADIUS_M: f64 = 10.0;
        const FILE_M: f64 = 0.58;
        let files = ((width_m - 2.0 * BODY_M) / FILE_M) as usize + 1;
        let node = |k: u32| {
            let (sin, cos) = sin_cos(TAU * f64::from(k) / f64::from(SIDES));
            DVec3::new(RADIUS_M * cos, RADIUS_M * sin, 0.0)
        };
        let edge = |k: u32| WalkEdge {
            nodes: [WalkNodeId(k), WalkNodeId((k + 1) % SIDES)],
            width_m,
            kind: WalkKind::Sidewalk,
        };
        let (roads, graph) =
            ways(WalkNetwork { nodes: (0..SIDES).map(node).collect(), edges: (0..SIDES).map(edge).collect() });
        let area = TAU * RADIUS_M * width_m;
        let mut crowd = Self { roads, graph, walkers: Vec::new(), area };
        let mut stream = Stream::named(3, "test.corridor", &[]);
        let people = (density * area).round() as usize;
        let ranks = people.div_ceil(files);
        for i in 0..people {
            let along = (i / files) as f64 / ranks as f64 * f64::from(SIDES);
            let edge = along as u32;
            let [a, b] = [edge, (edge + 1) % SIDES].map(|k| node(k).truncate());
            let out = a.lerp(b, along.fract()).normalize();
            let beside = FILE_M * ((i % files) as f64 - 0.5 * (files - 1) as f64);
            let turned = match directions {
                Directions::One => false,
                Directions::Sorted => beside < 0.0,
                Directions::Mixed => stream.chance(0.5),
            };
            crowd.put(&mut stream, edge, turned, a.lerp(b, along.fract()) + out * beside);
        }
        crowd
    }

    /// A square of 40 m, criss-crossed by wide ways.
    fn square(people: usize) -> Self {
        const SIDE: u32 = 5;
        const CELL_M: f64 = 8.0;
        let node = |k: u32| DVec3::new(f64::from(k % SIDE), f64::from(k / SIDE), 0.0) * CELL_M;
        let mut edges = Vec::new();
        for k in 0..SIDE * SIDE {
            let right = (k % SIDE + 1 < SIDE).then_some(k + 1);
            let up = (k / SIDE + 1 < SIDE).then_some(k + SIDE);
            edges.extend([right, up].into_iter().flatten().map(|other| WalkEdge {
                nodes: [WalkNodeId(k), WalkNodeId(other)],
                width_m: CELL_M,
                kind: WalkKind::Sidewalk,
            }));
        }
        let numbers = 0..edges.len();
        let (roads, graph) = ways(WalkNetwork { nodes: (0..SIDE * SIDE).map(node).collect(), edges });
        let area = (f64::from(SIDE) * CELL_M) * (f64::from(SIDE) * CELL_M);
        let mut crowd = Self { roads, graph, walkers: Vec::new(), area };
        let mut stream = Stream::named(3, "test.square", &[]);
        while crowd.walkers.len() < people {
            let edge = stream.below(numbers.len()) as u32;
            let [a, b] = crowd.roads.network.walk.edges[edge as usize]
                .nodes
                .map(|node| crowd.roads.network.walk.nodes[node.index()].truncate());
            let at = a.lerp(b, stream.f64()) + (b - a).normalize().perp() * stream.range_f64(-3.5, 3.5);
            if crowd.walkers.iter().all(|walker| walker.position.distance(at) > 0.55) {
                let turned = stream.chance(0.5);
                crowd.put(&mut stream, edge, turned, at);
            }
        }
        crowd
    }

    /// Lets them walk, and looks at them for a time at the end of it, seconds.
    fn walk(&mut self, seconds: f64, look_s: f64) -> Seen {
        let mut seen = Seen { mean_mps: 0.0, standing: 0.0, nearest_m: f64::INFINITY, outside_m: 0.0 };
        let mut looks = 0.0;
        for step_number in 0..(seconds / STEP_S) as u32 {
            let view = WalkerView {
                roads: &self.roads,
                graph: &self.graph,
                signals: &[],
                roadway: &Roadway::default(),
                others: &[],
            };
            step(&view, &mut self.walkers, &mut [], STEP_S);
            let left_s = seconds - f64::from(step_number) * STEP_S;
            if step_number % 10 != 0 || left_s > look_s {
                continue;
            }
            for (i, walker) in self.walkers.iter().enumerate() {
                let before = self.walkers[..i].iter().map(|other| other.position.distance(walker.position));
                seen.nearest_m = before.fold(seen.nearest_m, f64::min);
                seen.outside_m = seen.outside_m.max(self.outside(walker.position));
                seen.mean_mps += walker.velocity.length();
                seen.standing += f64::from(walker.velocity.length() < 0.1);
                looks += 1.0;
            }
        }
        seen.mean_mps /= looks;
        seen.standing /= looks;
        seen
    }

    /// How far a place is outside of the usable width of all ways, their ends round, metres.
    fn outside(&self, at: DVec2) -> f64 {
        let walk = &self.roads.network.walk;
        let off = |edge: &WalkEdge| {
            let [a, b] = edge.nodes.map(|node| walk.nodes[node.index()].truncate());
            let share = ((at - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            at.distance(a.lerp(b, share)) - (0.5 * edge.width_m - BODY_M)
        };
        walk.edges.iter().map(off).fold(f64::INFINITY, f64::min)
    }
}

/// Weidmann's speed of people at a density, m/s, for who walks at 1.34 m/s where nobody is.
fn weidmann_mps(density: f64) -> f64 {
    1.34 * (1.0 - exp(-1.913 * (1.0 / density - 1.0 / 5.4)))
}

/// Speeds over Weidmann's by density, after half a minute.
fn over_weidmann(densities: &[f64], directions: Directions) -> Vec<f64> {
    let share = |density: &f64| {
        let mut crowd = Crowd::corridor(*density, directions);
        assert!((crowd.walkers.len() as f64 / crowd.area / density - 1.0).abs() < 0.05);
        let seen = crowd.walk(40.0, 10.0);
        assert!(seen.nearest_m > SIDEWAYS_APART_M && seen.outside_m < BODY_M, "{density} {directions:?}: {seen:?}");
        seen.mean_mps / weidmann_mps(*density)
    };
    densities.iter().map(share).collect()
}

#[test]
fn speed_falls_with_density_as_weidmann_has_it() {
    let shares = over_weidmann(&[0.1, 0.5, 1.0, 1.5, 2.0, 2.5], Directions::One);
    assert!(shares.iter().all(|share| (0.8..1.2).contains(share)), "{shares:?}");
}

#[test]
fn so_it_does_where_people_come_the_other_way() {
    let shares = over_weidmann(&[0.1, 0.5, 1.0, 1.5, 2.0], Directions::Sorted);
    assert!(shares.iter().all(|share| (0.75..1.25).contains(share)), "{shares:?}");
    let shares = over_weidmann(&[2.5], Directions::Sorted);
    assert!(shares[0] > 0.4, "{shares:?}");
    let shares = over_weidmann(&[0.25, 0.5, 1.0], Directions::Mixed);
    assert!(shares.iter().all(|share| (0.75..1.25).contains(share)), "{shares:?}");
}

/// Where so many meet that nobody gets past with their shoulders square, they turn them: streams get on for all that.
#[test]
fn opposed_crowds_squeeze_past_one_another() {
    for density in [1.5, 2.0] {
        let seen = Crowd::corridor(density, Directions::Mixed).walk(90.0, 30.0);
        assert!(seen.mean_mps > 0.6 * weidmann_mps(density) && seen.standing < 0.2, "{density}: {seen:?}");
    }
}

/// Two files pass one another where two bodies just fit beside one another, and nobody blocks the way for ever.
#[test]
fn people_pass_on_a_narrow_sidewalk() {
    for (density, directions) in [(0.6, Directions::Sorted), (0.4, Directions::Mixed)] {
        let seen = Crowd::corridor_of(1.25, density, directions).walk(60.0, 20.0);
        assert!(seen.mean_mps > 0.9 && seen.standing < 0.05, "{directions:?}: {seen:?}");
    }
}

#[test]
fn five_hundred_on_a_square_keep_moving() {
    let mut crowd = Crowd::square(500);
    let seen = crowd.walk(60.0, 30.0);
    assert!(seen.mean_mps > 1.0 && seen.standing < 0.02, "{seen:?}");
    assert!(seen.nearest_m > SIDEWAYS_APART_M && seen.outside_m < 0.01, "{seen:?}");
}

#[test]
fn whom_a_vehicle_keeps_on_the_road_goes_back() {
    let nodes = [-20.0, 0.0, 10.0, 30.0].map(|y| DVec3::new(0.0, y, 0.0));
    let edge = |k: u32, kind| WalkEdge { nodes: [WalkNodeId(k), WalkNodeId(k + 1)], width_m: 3.0, kind };
    let kinds = [WalkKind::Sidewalk, WalkKind::Crossing(CrossingId(0)), WalkKind::Sidewalk];
    let edges = (0..).zip(kinds).map(|(k, kind)| edge(k, kind)).collect();
    let line = endless_road::Polyline::new([-40.0, 0.0, 40.0].map(|x| DVec3::new(x, 7.0, 0.0)));
    let network = RoadNetwork {
        lanes: vec![endless_road::Lane::new(endless_road::LaneId(0), line, 3.5, 10.0)],
        walk: WalkNetwork { nodes: nodes.to_vec(), edges },
        crossings: vec![endless_road::Crossing {
            ends: [nodes[1], nodes[2]],
            width_m: 3.0,
            signal: None,
            cuts: Vec::new(),
        }],
        ..RoadNetwork::default()
    };
    let network = network.finish().expect("a crossing and its sidewalks");
    let graph = WalkGraph::new(&network.walk);
    let roads = Roads::new(&TrafficMap::new(network, &[]), &Focus::default(), &[]);
    let stream = Stream::named(3, "test.crossing", &[]);
    let ends = [WalkNodeId(0), WalkNodeId(1)];
    let walker = Walker::new(&roads, &PedestrianSpec::default(), (WalkEdgeId(0), ends), DVec2::new(0.0, -3.0), stream);
    let mut walkers = [walker];
    walkers[0].way.extend([(WalkEdgeId(1), WalkNodeId(2)), (WalkEdgeId(2), WalkNodeId(3))]);
    // A car stands on the far lane for ever.
    let mut crossings = [CrossingState { occupied: true, taken: vec![(7.0, 2.5)], ..CrossingState::default() }];
    let view = WalkerView { roads: &roads, graph: &graph, signals: &[], roadway: &Roadway::default(), others: &[] };
    let (mut furthest, mut on_road_s) = (f64::NEG_INFINITY, 0.0);
    for _ in 0..(30.0 / STEP_S) as u32 {
        step(&view, &mut walkers, &mut crossings, STEP_S);
        furthest = furthest.max(walkers[0].position.y);
        on_road_s += if walkers[0].position.y > 0.0 { STEP_S } else { 0.0 };
        // Once they are back they stay there: drivers go.
        crossings[0].danger = on_road_s > 5.0;
    }
    assert!(furthest > 3.0 && furthest < 4.5, "the near lane is free, the far one is not: {furthest} m");
    assert!(walkers[0].position.y < 0.5, "still at {} m", walkers[0].position.y);
    assert!(on_road_s > HELD_UP_S && on_road_s < HELD_UP_S + 10.0, "{on_road_s} s on the road");
}
