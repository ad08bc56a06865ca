//! Lamp posts, traffic lights and signs.

use super::dresser::{Dresser, Spot, arm_yaw, towards_road};
use crate::character::Character;
use crate::network::{Node, Rule};
use endless_asset::Prop;
use endless_scene::StreetLamp;
use endless_world::math::f64::sin_cos;
use glam::{DVec2, Vec3};
use std::f64::consts::PI;

/// From the kerb's face to the middle of posts.
pub(crate) const POST_M: f64 = 0.55;
const POST_HALF: DVec2 = DVec2::splat(0.2);

/// What a sign says, whatever its code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Says {
    Works,
    Parking,
    NoParking,
    Children,
    LightsAhead,
    MainRoad,
}

/// Whose signs a town has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Customs {
    Vienna,
    Mutcd,
}

impl Customs {
    /// Where lines in the middle of roads are yellow, signs are those of the MUTCD.
    pub(crate) fn of(character: &Character) -> Self {
        if character.yellow_centre { Self::Mutcd } else { Self::Vienna }
    }

    /// The sign that says something.
    pub(crate) fn sign(self, says: Says) -> (Prop, u32) {
        let mutcd = self == Self::Mutcd;
        let code = match says {
            Says::Works if mutcd => "W20-1",
            Says::Works => "A,16",
            Says::Parking if mutcd => "R7-1",
            Says::Parking => "E,14",
            Says::NoParking if mutcd => "R7-1",
            Says::NoParking => "C,19",
            Says::Children if mutcd => "S1-1",
            Says::Children => "A,13",
            Says::LightsAhead if mutcd => "W3-3",
            Says::LightsAhead => "A,17a",
            Says::MainRoad if mutcd => "W2-1",
            Says::MainRoad => "B,3",
        };
        coded(code)
    }

    /// The sign of a speed limit.
    fn limit(self, speed_mps: f64) -> (Prop, u32) {
        match self {
            Self::Mutcd => coded("R2-1"),
            Self::Vienna if speed_mps < 9.0 => (Prop::SpeedSign, 1),
            Self::Vienna if speed_mps < 12.0 => (Prop::SpeedSign, 2),
            Self::Vienna => (Prop::SpeedSign, 0),
        }
    }
}

fn coded(code: &str) -> (Prop, u32) {
    let codes = endless_asset::Catalogue::sign_codes();
    (Prop::TrafficSign, codes.iter().position(|c| *c == code).unwrap_or(0) as u32)
}

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
    let customs = Customs::of(dresser.character);
    for node in &plan.nodes {
        for &arm in node.arms.iter().filter(|&&arm| plan.streets[arm.street].length() > 90.0) {
            let distance = plan.arm_stop(arm) + 14.0;
            let at = plan.arm_point(arm, distance, -(plan.arm_profile(arm).kerb() + POST_M));
            let spot = Spot::new(at, arm_yaw(plan, arm, distance) + PI);
            dresser.put_variant(customs.limit(plan.arm_profile(arm).speed_mps), spot, POST_HALF);
            let distance = plan.arm_stop(arm) + 48.0;
            if node.rule == Rule::Signals && plan.streets[arm.street].length() > 120.0 {
                let at = plan.arm_point(arm, distance, plan.arm_profile(arm).kerb() + POST_M);
                let spot = Spot::new(at, arm_yaw(plan, arm, distance));
                dresser.put_variant(customs.sign(Says::LightsAhead), spot, POST_HALF);
            }
        }
        add_street_name(dresser, node);
    }
    for (i, street) in plan.streets.iter().enumerate() {
        let mut stream = dresser.stream(8000 + i as u64);
        let (from, to) = street.lane_range();
        let says = [Says::NoParking, Says::Parking, Says::NoParking, Says::Children, Says::MainRoad];
        let mut s = from + stream.range_f64(18.0, 40.0);
        while s < to - 15.0 {
            let side = if stream.chance(0.5) { 1.0 } else { -1.0 };
            let at = street.point(s, side * (street.profile.kerb() + POST_M));
            let yaw = street.heading(s) + if side > 0.0 { 0.0 } else { PI };
            if !street.near_crossing(s, 2.0) {
                dresser.put_variant(customs.sign(*stream.pick(&says)), Spot::new(at, yaw), POST_HALF);
            }
            s += stream.range_f64(25.0, 55.0);
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

/// The names of two streets where they meet, at the corner of the first arm that has room.
fn add_street_name(dresser: &mut Dresser<'_>, node: &Node) {
    let plan = dresser.plan;
    for &arm in node.arms.iter().filter(|_| node.arms.len() > 2) {
        let cut = plan.arm_cut(arm);
        let beyond = plan.arm_profile(arm).kerb() + POST_M + 0.5;
        let spot = Spot::new(plan.arm_point(arm, cut + 0.3, -beyond), arm_yaw(plan, arm, cut));
        let clear = !plan.streets[arm.street].near_crossing(plan.arm_s(arm, cut + 0.3), 1.6);
        if clear && dresser.put(Prop::StreetName, spot, POST_HALF, None) {
            return;
        }
    }
}

/// Lamp posts on alternate sides, with their lights.
pub(crate) fn add_lamps(dresser: &mut Dresser<'_>) {
    let (plan, character) = (dresser.plan, dresser.character);
    // A town buys its lamps all at once.
    let lamp = (Prop::StreetLamp, (character.seed % 3) as u32);
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
                        dresser.put_variant(lamp, spot, POST_HALF)
                    }
                });
                if let Some(s) = free {
                    let at = street.point(s, side * (street.profile.kerb() + POST_M));
                    let (sin, cos) = sin_cos(towards_road(street, s, side));
                    let lens = (at + DVec2::new(cos, sin) * 2.0).as_vec2().extend(0.0);
                    dresser.lamps.push(StreetLamp {
                        position: lens + Vec3::Z * (7.9 + 0.15),
                        color: character.lamp_color,
                        intensity_cd: character.lamp_cd,
                    });
                }
            }
        }
    }
}
