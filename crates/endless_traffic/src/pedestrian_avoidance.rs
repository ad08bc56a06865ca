//! Collision avoidance of pedestrians: they turn and slow down for one another.

use super::walk_strip::{BODY_M, DirectedEdge, unit_vector};
use super::walker::Walker;
use glam::DVec2;

/// The more people are nearer than this, the less room is kept, metres.
const CROWD_M: f64 = 2.0;
/// Room that people like to keep between bodies, metres.
const SHY_M: f64 = 0.15;

impl Walker {
    /// The velocity nearest to the wanted one that meets nobody in the next seconds (sampled velocity obstacles,
    /// Fiorini and Shiller 1998) and stays on the strip.
    pub(super) fn avoid(
        &self,
        wanted: DVec2,
        near: &[(DVec2, DVec2)],
        strip: &DirectedEdge,
        next: Option<&DirectedEdge>,
    ) -> DVec2 {
        let outside = |p: DVec2| strip.outside(p).min(next.map_or(f64::INFINITY, |n| n.outside(p)));
        let here = outside(self.position);
        // Who has been stuck squeezes past, shoulder to shoulder.
        let crowd = near.iter().filter(|(at, _)| at.distance_squared(self.position) < CROWD_M * CROWD_M).count();
        let shy = if self.stuck.1 == 0.0 { SHY_M / (1.0 + 0.25 * crowd as f64) } else { 0.1 * SHY_M };
        let mut best = (f64::INFINITY, DVec2::ZERO);
        for (turn, share) in [
            (0.0, 1.0),
            (-0.3, 1.0),
            (0.3, 1.0),
            (-0.7, 0.9),
            (0.7, 0.9),
            (0.0, 0.75),
            (0.0, 0.5),
            (-1.3, 0.6),
            (1.3, 0.6),
            (0.0, 0.25),
            (0.0, 0.0),
        ] {
            let candidate = unit_vector(turn).rotate(wanted) * share;
            let mut cost = (candidate - wanted).length() + if turn > 0.0 { 0.05 } else { 0.0 };
            for &(position, velocity) in near {
                cost += threat(position - self.position, velocity - candidate, shy);
            }
            let over = outside(self.position + candidate * 0.5) - here;
            if over > 0.0 {
                cost += 6.0 * over;
            }
            if cost < best.0 {
                best = (cost, candidate);
            }
            if near.is_empty() && turn == 0.0 {
                break;
            }
        }
        best.1
    }
}

/// How much a neighbour at a relative place with a relative velocity is in the way of somebody who likes to keep `shy`
/// metres away.
fn threat(relative: DVec2, velocity: DVec2, shy: f64) -> f64 {
    let apart = 2.0 * BODY_M + shy;
    let distance = relative.length();
    let closing = -relative.dot(velocity);
    // Who comes slowly nearer in a crowd troubles nobody.
    let closing_mps = closing / distance.max(1e-6);
    let mut cost = if distance < apart + 1.3 * shy && closing > 0.0 { 2.0 * (closing_mps / 0.6).min(1.0) } else { 0.0 };
    // Time until the discs touch: |relative + velocity t| = apart.
    let a = velocity.length_squared();
    let b = -closing;
    let c = relative.length_squared() - apart * apart;
    let discriminant = b * b - a * c;
    if closing > 0.0 && discriminant > 0.0 && a > 1e-6 && c > 0.0 {
        let time = (-b - discriminant.sqrt()) / a;
        if time < 3.0 {
            cost += 0.9 / (time + 0.15) - 0.28;
        }
    }
    cost
}
