//! A grid of streets for tests: signals, stop signs, priority to the right, bends, sidewalks and crossings.
#![allow(dead_code, reason = "each test file uses its part")]

use endless_road::*;
use endless_world::{SignalAspect, SignalId};
use glam::{DVec2, DVec3};

const LANE_M: f64 = 3.5;
const BLOCK_M: f64 = 110.0;
const HALF_M: f64 = 15.0;
const CROSS_AT_M: f64 = HALF_M - 2.5;
const KERB_M: f64 = 0.15;
const DIRECTIONS: [DVec2; 4] = [DVec2::X, DVec2::Y, DVec2::NEG_X, DVec2::NEG_Y];

pub(crate) struct Grid {
    pub(crate) columns: usize,
    pub(crate) rows: usize,
    /// In each direction.
    pub(crate) lanes: usize,
}

impl Grid {
    fn arm(&self, i: usize, j: usize, d: usize) -> Option<(usize, usize)> {
        let (x, y) = match d {
            0 => (i + 1, j),
            1 => (i, j + 1),
            2 => (i.checked_sub(1)?, j),
            _ => (i, j.checked_sub(1)?),
        };
        (x < self.columns && y < self.rows).then_some((x, y))
    }

    fn center(i: usize, j: usize) -> DVec2 {
        DVec2::new(i as f64, j as f64) * BLOCK_M
    }

    fn half_road(&self) -> f64 {
        self.lanes as f64 * LANE_M
    }

    pub(crate) fn raw(&self) -> RoadNetwork {
        let mut n = RoadNetwork::default();
        let at = |i: usize, j: usize| j * self.columns + i;
        // into[junction][direction of the arm][lane], and out of it.
        let mut into = vec![vec![Vec::new(); 4]; self.columns * self.rows];
        let mut out = into.clone();
        for j in 0..self.rows {
            for i in 0..self.columns {
                for d in 0..4 {
                    let Some((x, y)) = self.arm(i, j, d) else { continue };
                    let dir = DIRECTIONS[d];
                    let (from, to) = (Self::center(i, j) + dir * HALF_M, Self::center(x, y) - dir * HALF_M);
                    let first = n.lanes.len() as u32;
                    for k in 0..self.lanes {
                        let shift = dir.perp() * (-(0.5 + k as f64) * LANE_M);
                        let points = (0..=8).map(|q| (from.lerp(to, f64::from(q) / 8.0) + shift).extend(0.0));
                        let id = push(&mut n, Polyline::new(points), None, Turn::Straight);
                        n.lanes[id.index()].left = (k > 0).then(|| LaneId(first + k as u32 - 1));
                        n.lanes[id.index()].right = (k + 1 < self.lanes).then(|| LaneId(first + k as u32 + 1));
                        out[at(i, j)][d].push(id);
                        into[at(x, y)][(d + 2) % 4].push(id);
                    }
                }
            }
        }
        for j in 0..self.rows {
            for i in 0..self.columns {
                self.junction(&mut n, (i, j), &into[at(i, j)], &out[at(i, j)]);
            }
        }
        self.sidewalks(&mut n);
        n
    }

    pub(crate) fn network(&self) -> RoadNetwork {
        self.raw().finish().expect("a sound grid")
    }

    fn junction(&self, n: &mut RoadNetwork, (i, j): (usize, usize), into: &[Vec<LaneId>], out: &[Vec<LaneId>]) {
        let id = JunctionId(n.junctions.len() as u16);
        n.junctions.push(Junction::default());
        let arms = into.iter().filter(|a| !a.is_empty()).count();
        let signalised = arms == 4 && (i + j) % 2 == 0;
        for a in 0..4 {
            for b in (0..4).filter(|&b| b != a) {
                if into[a].is_empty() || out[b].is_empty() {
                    continue;
                }
                let (turn, mut pairs): (Turn, Vec<(usize, usize)>) = match (b + 4 - a) % 4 {
                    2 => (Turn::Straight, (0..self.lanes).map(|k| (k, k)).collect()),
                    1 => (Turn::Right, vec![(self.lanes - 1, self.lanes - 1)]),
                    _ => (Turn::Left, vec![(0, 0)]),
                };
                if arms == 2 {
                    pairs = (0..self.lanes).map(|k| (k, k)).collect();
                }
                for (from, to) in pairs {
                    let (from, to) = (into[a][from], out[b][to]);
                    let curve = bezier(&n.lane(from).centerline, &n.lane(to).centerline);
                    let connector = push(n, curve, Some(id), turn);
                    n.lanes[from.index()].successors.push(connector);
                    n.lanes[connector.index()].successors.push(to);
                    n.junctions[id.index()].lanes.push(connector);
                }
            }
        }
        let base = n.signal_groups;
        if signalised {
            n.signal_groups += 4;
            n.junctions[id.index()].program = Some(program(base, (i * 7 + j * 3) as f64));
        }
        for a in 0..4 {
            let opposite_missing = into[(a + 2) % 4].is_empty();
            for lane in &into[a] {
                n.lanes[lane.index()].end_control = match arms {
                    4 if signalised => TrafficControl::Signal(SignalId(base + (a % 2) as u16)),
                    4 if (i + j) % 3 == 0 => TrafficControl::Stop,
                    3 if opposite_missing => [TrafficControl::Stop, TrafficControl::Yield][(i + j) % 2],
                    _ => TrafficControl::Free,
                };
            }
            if !into[a].is_empty() {
                let c = Self::center(i, j) + DIRECTIONS[a] * CROSS_AT_M;
                let side = DIRECTIONS[a].perp() * self.half_road();
                n.crossings.push(Crossing {
                    ends: [(c - side).extend(0.0), (c + side).extend(0.0)],
                    width_m: 4.0,
                    signal: signalised.then_some(SignalId(base + 2 + (a % 2) as u16)),
                    cuts: Vec::new(),
                });
            }
        }
    }

    fn sidewalks(&self, n: &mut RoadNetwork) {
        let away = self.half_road() + 1.5;
        let mut crossing = 0;
        // Node of each junction, arm and side (0 right of the arm's direction, 1 left).
        let mut kerb = vec![[[None; 2]; 4]; self.columns * self.rows];
        for j in 0..self.rows {
            for i in 0..self.columns {
                let here = j * self.columns + i;
                for (a, dir) in DIRECTIONS.iter().enumerate() {
                    for (side, sign) in [(0, -1.0), (1, 1.0)] {
                        let reach = if self.arm(i, j, a).is_some() { CROSS_AT_M } else { away };
                        let p = Self::center(i, j) + *dir * reach + dir.perp() * (sign * away);
                        n.walk.nodes.push(p.extend(KERB_M));
                        kerb[here][a][side] = Some(WalkNodeId(n.walk.nodes.len() as u32 - 1));
                    }
                }
                let node = |a: usize, side: usize| kerb[here][a][side].expect("just made");
                for a in 0..4 {
                    edge(n, node(a, 1), node((a + 1) % 4, 0), WalkKind::Sidewalk);
                    if self.arm(i, j, a).is_some() {
                        edge(n, node(a, 0), node(a, 1), WalkKind::Crossing(CrossingId(crossing)));
                        crossing += 1;
                    } else {
                        edge(n, node(a, 0), node(a, 1), WalkKind::Sidewalk);
                    }
                }
            }
        }
        for j in 0..self.rows {
            for i in 0..self.columns {
                for d in 0..2 {
                    let Some((x, y)) = self.arm(i, j, d) else { continue };
                    let (here, there) = (j * self.columns + i, y * self.columns + x);
                    for side in 0..2 {
                        let (a, b) = (kerb[here][d][side], kerb[there][d + 2][1 - side]);
                        edge(n, a.expect("made"), b.expect("made"), WalkKind::Sidewalk);
                    }
                }
            }
        }
    }
}

fn push(n: &mut RoadNetwork, centerline: Polyline, junction: Option<JunctionId>, turn: Turn) -> LaneId {
    let id = LaneId(n.lanes.len() as u32);
    n.lanes.push(Lane {
        id,
        centerline,
        width_m: LANE_M,
        speed_limit_mps: 13.9,
        successors: Vec::new(),
        predecessors: Vec::new(),
        left: None,
        right: None,
        junction,
        turn,
        end_control: TrafficControl::Free,
    });
    id
}

fn edge(n: &mut RoadNetwork, a: WalkNodeId, b: WalkNodeId, kind: WalkKind) {
    let [p, q] = [a, b].map(|id| n.walk.nodes[id.index()]);
    if p.distance(q) < 0.01 {
        return;
    }
    n.walk.edges.push(WalkEdge { nodes: [a, b], width_m: 2.4, kind });
}

fn bezier(from: &Polyline, to: &Polyline) -> Polyline {
    let (a, b) = (from.at(from.length()), to.at(0.0));
    let unit = |h: f64| {
        let (s, c) = endless_world::math::f64::sin_cos(h);
        DVec3::new(c, s, 0.0)
    };
    let (ta, tb) = (unit(a.heading_rad), unit(b.heading_rad));
    let cos = ta.dot(tb);
    // Handles of a circular arc's approximation.
    let reach = a.position.distance(b.position) * if cos < 0.5 { 0.39 } else { 0.33 };
    let (p, q) = (a.position + ta * reach, b.position - tb * reach);
    let steps = (a.position.distance(b.position) / 0.4).ceil() as usize;
    Polyline::new((0..=steps).map(|i| {
        let t = i as f64 / steps as f64;
        let u = 1.0 - t;
        a.position * (u * u * u) + p * (3.0 * u * u * t) + q * (3.0 * u * t * t) + b.position * (t * t * t)
    }))
}

fn program(base: u16, offset_s: f64) -> SignalProgram {
    use SignalAspect::{Green, Red, Yellow};
    let mut phases = Vec::new();
    for (go, stop) in [(0, 1), (1, 0)] {
        // People cross the arms of the axis that stands.
        let (walk, wait) = (base + 2 + stop, base + 2 + go);
        for (duration_s, car, person) in
            [(9.0, Green, Green), (7.0, Green, Yellow), (3.0, Yellow, Red), (2.0, Red, Red)]
        {
            let aspects = vec![
                (SignalId(base + go), car),
                (SignalId(base + stop), Red),
                (SignalId(walk), person),
                (SignalId(wait), Red),
            ];
            phases.push(SignalPhase { duration_s, aspects });
        }
    }
    SignalProgram { phases, offset_s }
}
