//! Where both carriageways of a road end inside an extract, a loop joins them: traffic that leaves comes back.

use super::dual_carriageway::widest_m;
use super::plan::StreetPlan;

/// Carriageways further apart than this are not joined, metres.
const MOST_M: f64 = 60.0;

/// Joins dead ends of one-way roads, those that leave with those that arrive, nearest first.
pub(super) fn join_dead_ends(plan: &mut StreetPlan) {
    let mut leaving = Vec::new();
    let mut arriving = Vec::new();
    for (k, intersection) in plan.intersections.iter().enumerate() {
        if let [arm] = intersection.arms[..]
            && !intersection.open
        {
            let street = plan.street(arm);
            if street.oneway() && !street.roundabout && street.length() > 15.0 {
                let list = if arm.end == 1 { &mut leaving } else { &mut arriving };
                list.push((k, plan.arm_point(arm, 0.0, 0.0).truncate(), plan.arm_direction(arm, 1.0), street.class));
            }
        }
    }
    let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
    for (k, p, u, class) in &leaving {
        for (l, q, v, other) in &arriving {
            let apart = p.distance(*q);
            // The way back lies on the left.
            let near = apart < MOST_M.min(2.0 * widest_m(*class) + 8.0);
            if near && class == other && u.dot(*v) > 0.6 && (-*u).perp_dot(*q - *p) > 0.0 {
                pairs.push((apart, *k, *l));
            }
        }
    }
    pairs.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2).cmp(&(b.1, b.2))));
    for (_, k, l) in pairs {
        if plan.intersections[k].arms.len() == 1 && plan.intersections[l].arms.len() == 1 {
            super::trim::join(plan, k, l);
            plan.intersections[k].turnaround = true;
        }
    }
}
