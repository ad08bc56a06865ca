//! Lamp posts, traffic lights and signs.

use super::dresser::{Dresser, Spot, arm_yaw, towards_road};
use crate::Lamp;
use crate::network::{Node, Rule};
use endless_asset::Prop;
use endless_world::math::f64::sin_cos;
use glam::{DVec2, Vec3};
use std::f64::consts::PI;

/// From the kerb's face to the middle of posts.
pub(crate) const POST_M: f64 = 0.55;
const POST_HALF: DVec2 = DVec2::splat(0.2);

/// Traffic lights and walk signals of every signalised junction, signs of the others.
pub(crate) fn add_signals(dresser: &mut Dresser<'_>) {
    let plan = dresser.plan;
    for node in &plan.nodes {
        for k in 0..node.arms.len() {
            if node.rule == Rule::Signals {
                add_vehicle_signal(dresser, node, k);
                add_walk_signals(dresser, node, k);
            } else {
                add_priority_sign(dresser, node, k);
            }
        }
    }
}

/// At the driver's right, beside the junction's edge, facing out along the arm.
fn add_vehicle_signal(dresser: &mut Dresser<'_>, node: &Node, k: usize) {
    let (plan, arm) = (dresser.plan, node.arms[k]);
    let cut = plan.arm_cut(arm);
    let profile = plan.arm_profile(arm);
    let spot = Spot::new(plan.arm_point(arm, cut - 0.05, profile.kerb() + POST_M), arm_yaw(plan, arm, cut));
    let prop = if profile.lanes > 1 { Prop::SignalMast } else { Prop::SignalPole };
    dresser.put(prop, spot, POST_HALF, Some(node.signals[k]));
    if profile.lanes == 1 {
        return;
    }
    // Wide roads show the aspect a second time on the far side, at the left.
    let far = Spot::new(plan.arm_point(arm, cut - 0.05, -(profile.kerb() + POST_M)), arm_yaw(plan, arm, cut));
    dresser.put(Prop::SignalPole, far, POST_HALF, Some(node.signals[k]));
}

/// On both ends of the arm's crossing, each facing the other.
fn add_walk_signals(dresser: &mut Dresser<'_>, node: &Node, k: usize) {
    let (plan, arm) = (dresser.plan, node.arms[k]);
    let Some(crossing) = plan.arm_crossing(arm) else { return };
    let street = &plan.streets[arm.street];
    let beyond = crossing.width / 2.0 + 0.95;
    let s = crossing.s + if arm.end == 0 { beyond } else { -beyond };
    for side in [1.0, -1.0] {
        let at = street.point(s, side * (street.profile.kerb() + POST_M));
        dresser.put(Prop::WalkSignal, Spot::new(at, towards_road(street, s, side)), POST_HALF, crossing.signal);
    }
}

fn add_priority_sign(dresser: &mut Dresser<'_>, node: &Node, k: usize) {
    let (plan, arm) = (dresser.plan, node.arms[k]);
    if node.main[k] {
        return;
    }
    let prop = if node.rule == Rule::Stop { Prop::StopSign } else { Prop::YieldSign };
    let stop = plan.arm_stop(arm) + 0.6;
    let at = plan.arm_point(arm, stop, plan.arm_profile(arm).kerb() + POST_M);
    dresser.put(prop, Spot::new(at, arm_yaw(plan, arm, stop)), POST_HALF, None);
}

/// Speed limits after junctions, and signs at crossings without signals.
pub(crate) fn add_signs(dresser: &mut Dresser<'_>) {
    let plan = dresser.plan;
    for node in &plan.nodes {
        for &arm in node.arms.iter().filter(|&&arm| plan.streets[arm.street].length() > 90.0) {
            let distance = plan.arm_stop(arm) + 14.0;
            let at = plan.arm_point(arm, distance, -(plan.arm_profile(arm).kerb() + POST_M));
            dresser.put(Prop::SpeedSign, Spot::new(at, arm_yaw(plan, arm, distance) + PI), POST_HALF, None);
        }
    }
    for street in &plan.streets {
        for crossing in street.crossings.iter().filter(|c| c.signal.is_none()) {
            // On the right of either direction, facing who comes.
            for side in [1.0, -1.0] {
                let s = crossing.s + side * (crossing.width / 2.0 + 1.0);
                let at = street.point(s, side * (street.profile.kerb() + POST_M));
                let yaw = street.heading(s) + if side > 0.0 { 0.0 } else { PI };
                dresser.put(Prop::CrossingSign, Spot::new(at, yaw), POST_HALF, None);
            }
        }
    }
}

/// Lamp posts on alternate sides, with their lights.
pub(crate) fn add_lamps(dresser: &mut Dresser<'_>) {
    let (plan, character) = (dresser.plan, dresser.character);
    for street in &plan.streets {
        let (from, to) = street.body();
        let count = ((to - from) / character.lamp_spacing_m).round().max(1.0);
        let spacing = (to - from) / count;
        let wide = street.profile.kerb() > 9.0;
        for k in 0..count as usize {
            let wanted = from + (k as f64 + 0.5) * spacing;
            let sides: &[f64] = if wide {
                &[1.0, -1.0]
            } else if k % 2 == 0 {
                &[1.0]
            } else {
                &[-1.0]
            };
            for &side in sides {
                // Next to what already stands there, if need be.
                let free = [0.0, 1.6, -1.6, 3.2, -3.2].into_iter().map(|step| wanted + step).find(|&s| {
                    !street.near_crossing(s, 1.6) && {
                        let at = street.point(s, side * (street.profile.kerb() + POST_M));
                        let spot = Spot::new(at, towards_road(street, s, side));
                        dresser.put(Prop::StreetLamp, spot, POST_HALF, None)
                    }
                });
                if let Some(s) = free {
                    let at = street.point(s, side * (street.profile.kerb() + POST_M));
                    let (sin, cos) = sin_cos(towards_road(street, s, side));
                    let lens = (at + DVec2::new(cos, sin) * 2.0).as_vec2().extend(0.0);
                    dresser.lamps.push(Lamp {
                        position: lens + Vec3::Z * (7.9 + 0.15),
                        color: character.lamp_color,
                        intensity_cd: character.lamp_cd,
                    });
                }
            }
        }
    }
}
