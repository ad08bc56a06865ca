//! Aligns the ends of consecutive lanes, so that they meet exactly and without a kink.
//!
//! Files are inexact: lane borders of neighbouring roads differ by centimetres, sometimes decimetres, and reference
//! lines by a degree or two. All ends that are joined are moved to one place and given one direction; the way through
//! a junction bends more readily than the road before it.

use super::lanes::LaneGraph;
use crate::{ImportNote, Lane, LaneId};
use endless_world::math::f64::{sin_cos, wrap_angle};
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Ends nearer than this to where they should be are moved without a word, metres.
const QUIET_M: f64 = 0.1;
/// Directions that differ less than this are left alone, radians.
const QUIET_KINK: f64 = 0.03;
/// A lane's end is bent over this length, metres.
const BEND_M: f64 = 6.0;

/// What a network accepts, and a little less: metres, radians.
const MOST_GAP_M: f64 = 0.045;
const MOST_KINK: f64 = 0.13;

/// Joined ends: (node, whether its end rather than its start).
type LaneJoint = Vec<(usize, bool)>;

pub(super) fn mend(graph: &mut LaneGraph, notes: &mut Vec<ImportNote>) {
    let mut moved = 0;
    let mut farthest = 0.0f64;
    for joint in joints(graph) {
        let (place, direction) = agreed(graph, &joint);
        for (node, at_end) in joint {
            let distance = pull(graph, node, at_end, place, direction);
            if distance > QUIET_M {
                moved += 1;
                farthest = farthest.max(distance);
            }
        }
    }
    if moved > 0 {
        let text = format!("{moved} ends of lanes were moved to meet others, by up to {farthest:.2} m");
        notes.push(ImportNote { place: "file".to_owned(), text });
    }
}

/// Lanes that still do not meet what follows them do not lead there.
pub(super) fn drop_unaligned(lanes: &mut [Lane], notes: &mut Vec<ImportNote>) {
    for i in 0..lanes.len() {
        let end = lanes[i].centerline.at(lanes[i].centerline.length());
        let meets = |next: &LaneId| {
            let start = lanes[next.index()].centerline.at(0.0);
            let kink = wrap_angle(start.heading_rad - end.heading_rad).abs();
            end.position.distance(start.position) < MOST_GAP_M && kink < MOST_KINK
        };
        let met: Vec<LaneId> = lanes[i].successors.iter().copied().filter(meets).collect();
        if met.len() < lanes[i].successors.len() {
            let p = end.position;
            let place = format!("lane that ends at ({:.1}, {:.1})", p.x, p.y);
            notes.push(ImportNote { place, text: "is linked to a lane that it does not meet: not joined".to_owned() });
            lanes[i].successors = met;
        }
    }
}

/// Groups of ends and starts that meet.
fn joints(graph: &LaneGraph) -> Vec<LaneJoint> {
    // Union-find over 2 × nodes: ends are odd.
    let mut parent: Vec<usize> = (0..2 * graph.nodes.len()).collect();
    fn root(parent: &mut [usize], mut i: usize) -> usize {
        while parent[i] != i {
            parent[i] = parent[parent[i]];
            i = parent[i];
        }
        i
    }
    for (node, lane) in graph.nodes.iter().enumerate().filter(|(_, lane)| !lane.gone) {
        for &next in &lane.next {
            let (a, b) = (root(&mut parent, 2 * node + 1), root(&mut parent, 2 * next));
            parent[a.max(b)] = a.min(b);
        }
    }
    let mut groups: BTreeMap<usize, LaneJoint> = BTreeMap::new();
    for i in 0..parent.len() {
        if !graph.nodes[i / 2].gone {
            let at = root(&mut parent, i);
            groups.entry(at).or_default().push((i / 2, i % 2 == 1));
        }
    }
    groups.into_values().filter(|group| group.len() > 1).collect()
}

/// Where the ends should meet and in which direction of travel: as the lanes outside junctions have it, if there are
/// any.
fn agreed(graph: &LaneGraph, joint: &LaneJoint) -> (DVec3, f64) {
    let outside: LaneJoint = joint.iter().copied().filter(|&(node, _)| graph.nodes[node].junction.is_none()).collect();
    let of = if outside.is_empty() { joint } else { &outside };
    let mut place = DVec3::ZERO;
    let (_, first) = end_of(graph, of[0]);
    let mut turn = 0.0;
    for &end in of {
        let (p, heading) = end_of(graph, end);
        place += p;
        turn += wrap_angle(heading - first);
    }
    let n = of.len() as f64;
    (place / n, first + turn / n)
}

fn end_of(graph: &LaneGraph, (node, at_end): (usize, bool)) -> (DVec3, f64) {
    let lane = &graph.nodes[node];
    if at_end {
        (lane.points[lane.points.len() - 1], lane.last_heading())
    } else {
        (lane.points[0], lane.first_heading())
    }
}

/// Moves an end to a place and turns it to a direction, with less and less effect along the lane. Tells how far the
/// end was moved.
fn pull(graph: &mut LaneGraph, node: usize, at_end: bool, place: DVec3, direction: f64) -> f64 {
    let (here, heading) = end_of(graph, (node, at_end));
    let shift = place - here;
    let kink = wrap_angle(direction - heading);
    if shift.length() < 1e-6 && kink.abs() < QUIET_KINK {
        return 0.0;
    }
    let lane = &mut graph.nodes[node];
    // Half the lane at most: the other half may be pulled from its other end.
    let reach = BEND_M.max(8.0 * shift.length()).min(0.5 * lane.length()).max(1e-3);
    if kink.abs() >= QUIET_KINK {
        refine(lane, at_end, reach);
    }
    let n = lane.points.len();
    let (sin, cos) = sin_cos(direction);
    let travel = DVec2::new(cos, sin) * if at_end { -1.0 } else { 1.0 };
    let order: Vec<usize> = if at_end { (0..n).rev().collect() } else { (0..n).collect() };
    let mut distance = 0.0;
    let mut last = lane.points[order[0]];
    for (k, &i) in order.iter().enumerate() {
        if k > 0 {
            distance += last.distance(lane.points[i]);
            last = lane.points[i];
        }
        if distance >= reach {
            break;
        }
        let t = distance / reach;
        // 1 at the end, 0 at the reach, level at both.
        let weight = 1.0 - t * t * (3.0 - 2.0 * t);
        let moved = lane.points[i] + shift * weight;
        // Close to the end the line follows the direction agreed; the blend has no kink either.
        let straight = place.truncate() + travel * distance;
        let bent = if kink.abs() >= QUIET_KINK {
            let weight = weight * weight;
            moved.truncate() + (straight - moved.truncate()) * weight
        } else {
            moved.truncate()
        };
        lane.points[i] = bent.extend(moved.z);
    }
    lane.points[order[0]] = place;
    shift.length()
}

/// Adds points near an end, so that it can bend.
fn refine(lane: &mut super::lanes::LaneNode, at_end: bool, reach: f64) {
    if at_end {
        lane.points.reverse();
        lane.widths.reverse();
    }
    let step = (reach / 12.0).max(0.1);
    let (mut points, mut widths) = (vec![lane.points[0]], vec![lane.widths[0]]);
    let mut distance = 0.0;
    for i in 1..lane.points.len() {
        let (a, b) = (lane.points[i - 1], lane.points[i]);
        let span = a.distance(b);
        if distance < reach && span > step {
            let near = span.min(reach - distance + step);
            let n = (near / step).ceil() as usize;
            for k in 1..=n {
                let share = near / span * k as f64 / n as f64;
                if share < 0.999 {
                    points.push(a.lerp(b, share));
                    widths.push(lane.widths[i - 1] + share * (lane.widths[i] - lane.widths[i - 1]));
                }
            }
        }
        points.push(b);
        widths.push(lane.widths[i]);
        distance += span;
    }
    (lane.points, lane.widths) = (points, widths);
    if at_end {
        lane.points.reverse();
        lane.widths.reverse();
    }
}
