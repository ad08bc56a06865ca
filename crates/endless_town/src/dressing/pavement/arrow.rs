//! Arrows on lanes before junctions, and dotted lines that lead left turns across large ones.

use crate::dressing::ground::pavement_index::PavementIndex;
use crate::dressing::pavement::crossing;
use crate::dressing::pavement::paint::PAINT_APART_M;
use crate::dressing::pavement::surface::{PAINT_M, quad};
use crate::geometry::unit;
use crate::palette::WHITE_PAINT;
use endless_road::{Crossing, Lane, LaneId, RoadMap, RoadNetwork, TrafficControl, Turn};
use endless_scene::MeshBuilder;
use glam::{DVec2, DVec3, Vec3};

/// Places of arrows before the end of a lane, metres.
const BACK_M: [f64; 2] = [7.0, 31.0];
/// Half the width of shafts, half the width of heads and their length, metres.
const SHAFT_M: f64 = 0.08;
const HEAD_M: [f64; 2] = [0.3, 1.0];
/// Ways through junctions shorter than this need no guide lines, metres; their dashes and gaps.
const LONG_M: f64 = 16.0;
const DASH_M: [f64; 2] = [0.6, 1.2];

/// Paints both.
pub(crate) fn add(mesh: &mut MeshBuilder, map: &RoadMap, pavement: &PavementIndex) {
    let network = &map.network;
    for lane in &network.lanes {
        let several = lane.left.is_some() || lane.right.is_some();
        let governed = !matches!(lane.end_control, TrafficControl::Free);
        if lane.junction.is_none() && several && governed {
            let turns: Vec<Turn> = lane.successors.iter().map(|next| network.lane(*next).turn).collect();
            let length = lane.centerline.length();
            for back in BACK_M.into_iter().filter(|back| length > back + 6.0) {
                ArrowPainter { mesh, pavement, lane, s: length - back }.arrow(&turns);
            }
        }
        let signalled =
            lane.predecessors.iter().any(|p| matches!(network.lane(*p).end_control, TrafficControl::Signal(_)));
        let inner = if map.left_hand { Turn::Right } else { Turn::Left };
        let long = lane.junction.is_some() && lane.turn == inner && lane.centerline.length() > LONG_M;
        if long && signalled && is_outermost_turn(network, lane, map.left_hand) {
            guide_line(mesh, lane, if map.left_hand { 1.0 } else { -1.0 }, pavement, &network.crossings);
        }
    }
}

/// Whether nobody turns the same way from the lane beside, away from the middle of the road.
fn is_outermost_turn(network: &RoadNetwork, way: &Lane, left_hand: bool) -> bool {
    let beside = |from: &LaneId| if left_hand { network.lane(*from).left } else { network.lane(*from).right };
    let turns = |from: LaneId| network.lane(from).successors.iter().any(|next| network.lane(*next).turn == way.turn);
    !way.predecessors.iter().filter_map(beside).any(turns)
}

/// Dots along the outer edge of a way.
fn guide_line(mesh: &mut MeshBuilder, lane: &Lane, side: f64, pavement: &PavementIndex, crossings: &[Crossing]) {
    let length = lane.centerline.length();
    let t = side * (lane.width_m / 2.0 - 0.1);
    let mut s = 3.0;
    while s + DASH_M[0] < length - 3.0 {
        let painter = ArrowPainter { mesh, pavement, lane, s };
        let ends = [0.0, DASH_M[0]].map(|x| painter.place((x, t)));
        let crossed = |crossing| ends.iter().any(|&end| crossing::holds(crossing, end, PAINT_APART_M));
        if !crossings.iter().any(crossed) {
            painter.quad([(0.0, t - 0.05), (DASH_M[0], t - 0.05), (DASH_M[0], t + 0.05), (0.0, t + 0.05)]);
        }
        s += DASH_M[0] + DASH_M[1];
    }
}

/// Paints in the frame of a place on a lane: x ahead, y to the left.
struct ArrowPainter<'a, 'm> {
    mesh: &'m mut MeshBuilder,
    pavement: &'a PavementIndex,
    lane: &'a Lane,
    s: f64,
}

impl ArrowPainter<'_, '_> {
    fn place(&self, (x, y): (f64, f64)) -> DVec3 {
        let at = self.lane.centerline.at(self.s);
        let ahead = unit(at.heading_rad);
        let p = at.position.truncate() + ahead * x + ahead.perp() * y;
        let z = at.position.z + at.grade * x;
        p.extend(self.pavement.height(p, z + 0.1).unwrap_or(z).max(z - 0.3) + PAINT_M)
    }

    /// Corners counter-clockwise.
    fn quad(self, corners: [(f64, f64); 4]) {
        let corners = corners.map(|c| self.place(c));
        quad(self.mesh, corners, corners.map(|p| p.truncate().as_vec2()), WHITE_PAINT);
    }

    fn strip(&mut self, from: DVec2, to: DVec2, half: [f64; 2]) {
        let across = (to - from).normalize_or(DVec2::X).perp();
        let corners = [from - across * half[0], to - across * half[1], to + across * half[1], from + across * half[0]]
            .map(|p| self.place((p.x, p.y)));
        quad(self.mesh, corners, corners.map(|p| p.truncate().as_vec2()), WHITE_PAINT);
    }

    /// A triangle with its tip ahead.
    fn head(&mut self, at: DVec2, direction: DVec2) {
        let across = direction.perp() * HEAD_M[0];
        let corners = [at - across, at + direction * HEAD_M[1], at + across];
        let corners: [Vec3; 3] = corners.map(|p| self.place((p.x, p.y)).as_vec3());
        self.mesh.triangle(corners, corners.map(Vec3::truncate), WHITE_PAINT);
    }

    /// One arrow with a head for every turn.
    fn arrow(mut self, turns: &[Turn]) {
        let has = |turn: Turn| turns.contains(&turn);
        let straight = has(Turn::Straight);
        let reach = if straight { 1.1 } else { 0.35 };
        self.strip(DVec2::new(-2.0, 0.0), DVec2::new(reach, 0.0), [SHAFT_M; 2]);
        if straight {
            self.head(DVec2::new(reach, 0.0), DVec2::X);
        }
        for (turn, side) in [(Turn::Left, 1.0), (Turn::Right, -1.0)] {
            if has(turn) {
                let (bend, end) = (DVec2::new(0.25, 0.0), DVec2::new(0.75, 0.42 * side));
                self.strip(bend, end, [SHAFT_M; 2]);
                self.head(end, DVec2::new(0.5, 0.866 * side));
            }
        }
    }
}
