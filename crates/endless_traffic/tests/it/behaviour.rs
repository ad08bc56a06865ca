//! What vehicles show and how people walk: lights, steering, signals, gait, and the same states again.

use crate::grid::Grid;
use endless_road::{RoadNetwork, TrafficControl};
use endless_traffic::{DrivingCondition, Simulation, TrafficSettings};
use endless_world::math::f64::{sin_cos, wrap_angle};
use endless_world::{
    Actor, Condition, Gait, Motion, ObjectClass, SignalAspect, TimeOfDay, VehicleLights, VehicleMotion, Weather,
    WorldState,
};
use glam::DVec2;

const FPS: f64 = 30.0;

fn town() -> RoadNetwork {
    Grid { columns: 3, rows: 3, lanes: 1 }.network()
}

fn clear_afternoon() -> DrivingCondition {
    Condition::of(Weather::ClearSky, TimeOfDay::Afternoon).into()
}

fn simulation(network: &RoadNetwork, asked: [u32; 2], seed: u64, condition: DrivingCondition, fps: f64) -> Simulation {
    let specs = crate::watch::specs();
    let [vehicles, pedestrians] = asked;
    let settings = TrafficSettings { vehicles, pedestrians, seed, fps, condition, ..TrafficSettings::default() };
    crate::watch::simulation(network, &specs, &settings)
}

fn frames(network: &RoadNetwork, asked: [u32; 2], seconds: f64) -> Vec<WorldState> {
    let mut s = simulation(network, asked, 3, clear_afternoon(), FPS);
    let tick = |_| {
        s.tick();
        s.state()
    };
    (0..(seconds * FPS) as usize).map(tick).collect()
}

fn motion(actor: &Actor) -> Option<VehicleMotion> {
    match actor.motion {
        Motion::Vehicle(motion) => Some(motion),
        Motion::Walker(_) => None,
    }
}

/// Yaw gained between two frames.
fn turned(a: &Actor, b: &Actor) -> f64 {
    wrap_angle(f64::from(b.pose.yaw_rad - a.pose.yaw_rad))
}

#[test]
fn who_turns_has_indicated_to_that_side_and_not_to_the_other() {
    let frames = frames(&town(), [40, 0], 90.0);
    let (window, before) = (4 * FPS as usize, 3 * FPS as usize);
    let mut turns = 0;
    for k in 0..frames[0].actors.len() {
        if frames[0].actors[k].class == ObjectClass::Bicycle {
            continue;
        }
        let mut i = before;
        while i + window < frames.len() {
            let angle: f64 = (i..i + window).map(|f| turned(&frames[f].actors[k], &frames[f + 1].actors[k])).sum();
            if angle.abs() < 1.3 {
                i += 10;
                continue;
            }
            turns += 1;
            let lit = |bit| {
                let shown = |w: &WorldState| motion(&w.actors[k]).is_some_and(|m| m.lights.contains(bit));
                frames[i - before..i + window / 2].iter().any(shown)
            };
            let (left, right) = (lit(VehicleLights::LEFT_BLINKER), lit(VehicleLights::RIGHT_BLINKER));
            assert_eq!((left, right), (angle > 0.0, angle < 0.0), "vehicle {k} turns by {angle} in frame {i}");
            i += 2 * window;
        }
    }
    assert!(turns > 20, "{turns} turns seen");
}

#[test]
fn brake_lights_are_lit_by_braking_and_by_nothing_else() {
    let frames = frames(&town(), [40, 0], 40.0);
    let (mut braked, mut drove) = (0, 0);
    for triple in frames.windows(20) {
        for k in 0..triple[0].actors.len() {
            let at = |i: usize| motion(&triple[i].actors[k]).expect("vehicles only");
            if triple[0].actors[k].class == ObjectClass::Bicycle {
                continue;
            }
            let lit = at(19).lights.contains(VehicleLights::BRAKE);
            let change = |i: usize| f64::from(at(i).speed_mps - at(i - 1).speed_mps) * FPS;
            if change(19) < -1.0 {
                braked += 1;
                assert!(lit, "vehicle {k} brakes at {:.2} m/s² in the dark", change(19));
            } else if (1..20).all(|i| change(i) > 0.2) && at(0).speed_mps > 0.2 {
                drove += 1;
                assert!(!lit, "vehicle {k} speeds up with brake lights on");
            }
        }
    }
    assert!(braked > 100 && drove > 100, "{braked} {drove}");
}

#[test]
fn headlights_are_lit_by_night_in_rain_and_in_fog() {
    let network = town();
    for (weather, time, lit) in [
        (Weather::ClearSky, TimeOfDay::Afternoon, false),
        (Weather::Cloudy, TimeOfDay::Morning, false),
        (Weather::ClearSky, TimeOfDay::Night, true),
        (Weather::Rainy, TimeOfDay::Afternoon, true),
        (Weather::Foggy, TimeOfDay::Morning, true),
    ] {
        let state = simulation(&network, [12, 0], 1, Condition::of(weather, time).into(), FPS).state();
        for (actor, vehicle) in state.actors.iter().filter_map(|a| Some((a, motion(a)?))) {
            assert_eq!(
                vehicle.lights.contains(VehicleLights::LOW_BEAM | VehicleLights::POSITION),
                lit,
                "{weather} {time}"
            );
            let passengers = actor.class == ObjectClass::Bus;
            assert_eq!(vehicle.lights.contains(VehicleLights::INTERIOR), lit && passengers, "{weather} {time}");
        }
    }
}

#[test]
fn wheels_are_steered_to_the_side_of_the_bend_and_roll_with_the_road() {
    let frames = frames(&town(), [30, 0], 60.0);
    let mut bends = [0, 0];
    for pair in frames.windows(2) {
        for (a, b) in pair[0].actors.iter().zip(&pair[1].actors) {
            let (m, n) = (motion(a).expect("a vehicle"), motion(b).expect("a vehicle"));
            let rate = turned(a, b) * FPS;
            if rate.abs() > 0.25 {
                bends[usize::from(rate > 0.0)] += 1;
                assert!(f64::from(n.steer_rad) * rate > 0.0, "steered {} while turning at {rate}", n.steer_rad);
            }
            let rolled = n.rolled_m - m.rolled_m;
            assert!(rolled >= 0.0 && rolled < n.speed_mps.max(m.speed_mps) / FPS as f32 * 1.05 + 1e-3);
        }
    }
    assert!(bends.iter().all(|&n| n > 100), "{bends:?}");
}

#[test]
fn signals_keep_their_program_and_nobody_runs_a_red_light() {
    let network = town();
    let specs = crate::watch::specs();
    let frames = frames(&network, [40, 0], 120.0);
    let mut red_for = vec![0.0; usize::from(network.signal_groups)];
    let mut passed = 0;
    for pair in frames.windows(2) {
        let (before, now) = (&pair[0], &pair[1]);
        for program in network.junctions.iter().filter_map(|j| j.program.as_ref()) {
            let cycle: f64 = program.phases.iter().map(|p| p.duration_s).sum();
            let mut left = (now.time_s + program.offset_s) % cycle;
            let phase = program.phases.iter().find(|p| {
                left -= p.duration_s;
                left < 0.0
            });
            // At the instant of a change either is right.
            if left > -1e-6 || phase.is_none_or(|p| p.duration_s + left < 1e-6) {
                continue;
            }
            for &(signal, aspect) in &phase.expect("checked").aspects {
                assert_eq!(now.signals[usize::from(signal.0)].aspect, aspect, "at {} s", now.time_s);
            }
        }
        for (g, red) in red_for.iter_mut().enumerate() {
            *red = if now.signals[g].aspect == SignalAspect::Red { *red + 1.0 / FPS } else { 0.0 };
            let skipped = before.signals[g].aspect == SignalAspect::Green && *red > 0.0;
            let walks = network.crossings.iter().any(|c| c.signal.is_some_and(|s| usize::from(s.0) == g));
            assert!(!skipped || walks, "signal {g} turns from green to red without yellow");
        }
        for lane in &network.lanes {
            let TrafficControl::Signal(signal) = lane.end_control else { continue };
            let line = lane.centerline.at(lane.centerline.length());
            let (sin, cos) = sin_cos(line.heading_rad);
            let along = DVec2::new(cos, sin);
            let place = |a: &Actor| {
                let (sin, cos) = sin_cos(f64::from(a.pose.yaw_rad));
                let half = 0.5 * f64::from(specs[a.asset.vehicle().expect("a vehicle").model.index()].length_m);
                let front = a.pose.position.as_dvec3().truncate() + DVec2::new(cos, sin) * half;
                let d = front - line.position.truncate();
                (d.dot(along), along.perp_dot(d))
            };
            for (a, b) in before.actors.iter().zip(&now.actors) {
                let ((from, _), (to, side)) = (place(a), place(b));
                if from <= 0.0 && to > 0.0 && side.abs() < 1.5 {
                    passed += 1;
                    let red = red_for[usize::from(signal.0)];
                    // Who waited at the line to turn left clears the junction when the light has changed.
                    assert!(red < 4.0, "at {:.1} s a vehicle passes a light red for {red:.1} s", now.time_s);
                }
            }
        }
    }
    assert!(passed > 30, "{passed} vehicles passed a light");
}

#[test]
fn feet_keep_pace_with_the_ground() {
    let frames = frames(&town(), [10, 40], 40.0);
    let mut walked = 0.0;
    for pair in frames.windows(2) {
        for (a, b) in pair[0].actors.iter().zip(&pair[1].actors) {
            let (Motion::Walker(m), Motion::Walker(n)) = (a.motion, b.motion) else { continue };
            let moved = a.pose.position.truncate().distance(b.pose.position.truncate());
            assert!((n.walked_m - m.walked_m - moved).abs() < 2e-3, "{moved} m on {} m of steps", n.walked_m);
            assert!((n.speed_mps - moved * FPS as f32).abs() < 0.05, "{} m/s", n.speed_mps);
            match n.gait {
                Gait::Stand | Gait::Idle | Gait::Wait | Gait::Talk => assert!(n.speed_mps < 0.1),
                Gait::Walk | Gait::Hurry | Gait::Push => assert!(n.speed_mps > 0.05 && n.speed_mps < 2.2),
                Gait::Sit => assert!(n.speed_mps < 2.2),
                Gait::Run => assert!(n.speed_mps > 2.0),
            }
            walked += moved;
        }
    }
    assert!(walked > 500.0, "{walked} m");
}

#[test]
fn states_repeat_bit_for_bit_and_hardly_depend_on_the_frame_rate() {
    let network = town();
    let after_four_seconds = |fps: f64| {
        let mut s = simulation(&network, [30, 20], 9, clear_afternoon(), fps);
        (0..(4.0 * fps) as usize).for_each(|_| s.tick());
        s.state()
    };
    for fps in [30.0, 10.0, 24.0] {
        assert_eq!(after_four_seconds(fps), after_four_seconds(fps), "{fps} frames a second");
    }
    // 30 and 10 frames a second take the same steps of 1/30 s.
    let (fast, slow) = (after_four_seconds(30.0), after_four_seconds(10.0));
    assert_eq!(fast.time_s, slow.time_s);
    let mut apart: Vec<f32> =
        fast.actors.iter().zip(&slow.actors).map(|(a, b)| a.pose.position.distance(b.pose.position)).collect();
    apart.sort_by(f32::total_cmp);
    assert!(apart[apart.len() * 9 / 10] < 0.01, "{apart:?}");
}
