//! Programs of traffic lights: opposite arms together, people while nobody drives straight over them.

use super::curve::angle;
use super::graph::StreetSegmentEnd;
use super::movement::Movement;
use super::plan::StreetPlan;
use crate::yellow::yellow_s;
use crate::{SignalPhase, SignalProgram, TrafficControl, Turn};
use endless_world::math::f64::wrap_angle;
use endless_world::{SignalAspect, SignalId, Stream};

/// Seconds.
const ALL_RED_S: f64 = 2.0;
const WALK_S: f64 = 7.0;
const MAIN_GREEN_S: f64 = 20.0;
const MINOR_GREEN_S: f64 = 12.0;
/// Speed for which clearance is reckoned.
const CLEARANCE_MPS: f64 = 1.25;

/// Numbers the lights for people at all crossings of signalised intersections.
pub(super) fn number_walks(plan: &mut StreetPlan, groups: &mut usize) {
    for intersection in 0..plan.intersections.len() {
        if !plan.intersections[intersection].signals {
            continue;
        }
        for arm in plan.intersections[intersection].arms.clone() {
            for crossing in plan.streets[arm.stretch].crossings.iter_mut().filter(|c| c.end == Some(arm.end)) {
                crossing.signal = Some(SignalId((*groups).min(usize::from(u16::MAX)) as u16));
                *groups += 1;
            }
        }
    }
}

/// An arm with its groups.
struct SignalApproach {
    arm: StreetSegmentEnd,
    vehicles: Option<SignalId>,
    people: Option<SignalId>,
    width_m: f64,
    speed_mps: f64,
    heading: f64,
    main: bool,
}

/// The program of an intersection; `None` if nothing there has a light.
pub(super) fn program(plan: &StreetPlan, intersection: usize, movements: &[Movement]) -> Option<SignalProgram> {
    if !plan.intersections[intersection].signals {
        return None;
    }
    let highest = plan.intersections[intersection].arms.iter().map(|&a| plan.street(a).class).max();
    let approaches: Vec<SignalApproach> = plan.intersections[intersection]
        .arms
        .iter()
        .map(|&arm| {
            let street = plan.street(arm);
            let vehicles = match street.control[arm.end] {
                TrafficControl::Signal(id) => Some(id),
                _ => None,
            };
            SignalApproach {
                arm,
                vehicles,
                people: street.crossings.iter().find(|c| c.end == Some(arm.end)).and_then(|c| c.signal),
                width_m: street.section.width_m(),
                speed_mps: street.speed_mps,
                heading: angle(-plan.arm_direction(arm, plan.cut(arm))),
                main: Some(street.class) == highest,
            }
        })
        .collect();
    let stages = stages(&approaches);
    let mut phases = Vec::new();
    let mut walked = vec![false; approaches.len()];
    for stage in &stages {
        let walks: Vec<bool> =
            approaches.iter().map(|a| a.people.is_some() && may_walk(a, stage, &approaches, movements)).collect();
        walked.iter_mut().zip(&walks).for_each(|(done, w)| *done |= w);
        phases.extend(stage_phases(&approaches, stage, &walks));
    }
    // Who never may walk beside traffic gets a stage of their own.
    let waiting: Vec<bool> = approaches.iter().zip(&walked).map(|(a, done)| a.people.is_some() && !done).collect();
    if waiting.contains(&true) {
        let all: Vec<bool> = approaches.iter().map(|a| a.people.is_some()).collect();
        phases.extend(stage_phases(&approaches, &[], &all));
    }
    if phases.is_empty() || phases[0].aspects.is_empty() {
        return None;
    }
    let cycle: f64 = phases.iter().map(|p| p.duration_s).sum();
    let key = plan.intersections[intersection].nodes.iter().min().copied().unwrap_or(0) as u64;
    let offset_s = Stream::named(0, "osm/signal", &[key]).range_f64(0.0, cycle).floor();
    Some(SignalProgram { phases, offset_s })
}

/// Approaches that are green together: opposite ones, and the carriageways of one direction; main roads first.
fn stages(approaches: &[SignalApproach]) -> Vec<Vec<usize>> {
    let mut order: Vec<usize> = (0..approaches.len()).filter(|&i| approaches[i].vehicles.is_some()).collect();
    order.sort_by_key(|&i| !approaches[i].main);
    let mut stages: Vec<Vec<usize>> = Vec::new();
    for i in order {
        let along = |j: usize| {
            let off = wrap_angle(approaches[i].heading - approaches[j].heading).abs();
            !(0.6..2.5).contains(&off)
        };
        match stages.iter_mut().find(|s| s.iter().all(|&j| along(j))) {
            Some(stage) => stage.push(i),
            None => stages.push(vec![i]),
        }
    }
    stages
}

/// Whether people may cross an arm in a stage: it is red there, and nobody drives onto it but who turns.
fn may_walk(crossed: &SignalApproach, stage: &[usize], approaches: &[SignalApproach], movements: &[Movement]) -> bool {
    stage.iter().all(|&i| {
        let from = approaches[i].arm;
        from != crossed.arm
            && !movements.iter().any(|m| m.from == from && m.to == crossed.arm && m.turn == Turn::Straight)
    })
}

fn stage_phases(approaches: &[SignalApproach], stage: &[usize], walks: &[bool]) -> Vec<SignalPhase> {
    let longest = approaches.iter().zip(walks).filter(|(_, w)| **w).map(|(a, _)| a.width_m).fold(0.0, f64::max);
    let clearance = (longest / CLEARANCE_MPS).ceil();
    let main = stage.iter().any(|&i| approaches[i].main);
    let least = if stage.is_empty() {
        0.0
    } else if main {
        MAIN_GREEN_S
    } else {
        MINOR_GREEN_S
    };
    let walk = if walks.contains(&true) { WALK_S } else { 0.0 };
    let green = least.max(walk + clearance);
    let phase = |duration_s: f64, vehicles: SignalAspect, people: SignalAspect| SignalPhase {
        duration_s,
        aspects: approaches
            .iter()
            .enumerate()
            .filter_map(|(i, a)| {
                a.vehicles.map(|id| (id, if stage.contains(&i) { vehicles } else { SignalAspect::Red }))
            })
            .chain(
                approaches
                    .iter()
                    .zip(walks)
                    .filter_map(|(a, &w)| a.people.map(|id| (id, if w { people } else { SignalAspect::Red }))),
            )
            .collect(),
    };
    let mut phases = vec![phase(green - clearance, SignalAspect::Green, SignalAspect::Green)];
    if clearance > 0.0 {
        phases.push(phase(clearance, SignalAspect::Green, SignalAspect::Yellow));
    }
    if !stage.is_empty() {
        let fastest = stage.iter().map(|&i| approaches[i].speed_mps).fold(0.0, f64::max);
        phases.push(phase(yellow_s(fastest), SignalAspect::Yellow, SignalAspect::Red));
    }
    phases.push(phase(ALL_RED_S, SignalAspect::Red, SignalAspect::Red));
    phases
}
