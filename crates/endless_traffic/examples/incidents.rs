//! Stages incidents in all towns, and compares their labels with what is detected in the trajectories alone:
//! `cargo run -p endless_traffic --release --example incidents -- [draws] [seconds] [kind ...]`.
//!
//! Each draw is the scene of two cameras. A line a kind: in how many of the draws one could be had, in how many the one who causes it was in sight of a camera when it
//! began, in how many the detector finds the same actor with begin and end within a frame, how many more incidents of the
//! kind it finds in the same videos, and how long it took to make the traffic and stage it. A second table has the draws. It exits with 1 if a label
//! does not agree.

#![expect(clippy::print_stdout, reason = "a report on standard output")]
use endless_asset::Catalogue;
use endless_road::{Lane, TrafficControl};
use endless_town::Town;
use endless_traffic::{
    DrivingCondition, Fleet, Focus, IncidentDetector, IncidentRequest, Simulation, TrafficMap, TrafficSettings, View,
};
use endless_world::{ImageSize, Incident, IncidentKind, PinholeCamera, VehicleSpec};
use glam::{Vec2, Vec3};
use std::{error::Error, process::ExitCode, time::Instant};

const FPS: f64 = 10.0;
const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };
const TOWNS: &[&str] = &["Town01", "Town02", "Town03", "Town04", "Town05", "Town06", "Town07", "Town10HD", "Altstadt"];

struct Place {
    town: Town,
    map: TrafficMap,
}

#[derive(Default)]
struct Tally {
    drawn: u32,
    had: u32,
    in_sight: u32,
    agrees: u32,
    others: usize,
    seconds: f64,
}

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let mut args = std::env::args().skip(1);
    let draws: usize = args.next().map_or(Ok(20), |text| text.parse())?;
    let seconds: f64 = args.next().map_or(Ok(20.0), |text| text.parse())?;
    let mut kinds = args.map(|text| text.parse()).collect::<Result<Vec<IncidentKind>, _>>()?;
    if kinds.is_empty() {
        kinds.extend(IncidentKind::ALL);
    }
    let catalogue = Catalogue::builtin();
    let specs = catalogue.vehicle_specs();
    let mut places = Vec::new();
    for name in TOWNS {
        let town = endless_town::load(name, &catalogue)?;
        let map = TrafficMap::new(town.network.clone(), &specs);
        places.push(Place { town, map });
    }
    let mut tallies: Vec<(IncidentKind, Tally)> = Vec::new();
    for kind in kinds {
        let mut tally = Tally::default();
        for draw in 0..draws {
            let place = &places[draw % places.len()];
            stage(place, &specs, kind, draw, seconds, &mut tally)?;
        }
        tallies.push((kind, tally));
    }
    println!("\n{:<18} draws  had  in sight  agree ±1 frame  others found  s a draw", "kind");
    let mut agrees = true;
    for (kind, tally) in tallies {
        let Tally { drawn, had, in_sight, agrees: same, others, seconds } = tally;
        println!(
            "{:<18} {drawn:>5} {had:>4} {in_sight:>9} {same:>15} {others:>13} {:>9.1}",
            kind.to_string(),
            seconds / f64::from(drawn.max(1))
        );
        agrees &= same == had;
    }
    Ok(if agrees { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn stage(
    place: &Place,
    specs: &[VehicleSpec],
    kind: IncidentKind,
    draw: usize,
    seconds: f64,
    tally: &mut Tally,
) -> Result<(), Box<dyn Error>> {
    let Place { town, map } = place;
    let fleet = Fleet { vehicles: specs, pedestrian: &Catalogue::pedestrian_spec };
    // Lights can be run where the cameras see somebody who passes one.
    let needs_lights = kind == IncidentKind::RedLightRun;
    let scenes = (0..town.cameras.len()).map(|k| {
        let cameras = cameras(town, 2 * (draw / TOWNS.len()) + k);
        let views = cameras.clone().map(View::Camera);
        (cameras, Focus::new(&town.network, &views, 0.8, &|_, _| true))
    });
    let Some((cameras, focus)) = scenes.into_iter().find(|(_, focus)| !needs_lights || sees_a_light(town, focus))
    else {
        println!("{kind}, draw {draw}, {}: left out, its cameras see nobody who passes a light", town.name);
        return Ok(());
    };
    let seed = 1 + draw as u64;
    let settings =
        TrafficSettings { vehicles: 60, pedestrians: 20, seed, fps: FPS, focus: focus.clone(), ..Default::default() };
    let frames = (seconds * FPS) as u32;
    let condition = |_| DrivingCondition::default();
    let request = IncidentRequest { kinds: &[kind], frames, seed, sight: &focus, condition: &condition };
    let begin = Instant::now();
    let (mut traffic, staged) = Simulation::with_incidents(map, &fleet, &town.parked, &settings, None, &request)?;
    tally.seconds += begin.elapsed().as_secs_f64();
    tally.drawn += 1;
    let Some(incident) = staged.incidents.first() else {
        println!("{kind}, draw {draw}, {}: none", town.name);
        return Ok(());
    };
    tally.had += 1;
    let mut detector = IncidentDetector::new(&town.network, specs, FPS);
    let mut shown = false;
    for frame in 0..frames {
        if frame > 0 {
            traffic.tick();
        }
        let state = traffic.state();
        if frame == incident.begin_frame {
            let actor = state.actors.iter().find(|actor| actor.id == incident.actors[0]).ok_or("nobody there")?;
            let at = actor.pose.position + Vec3::Z;
            shown = cameras.iter().any(|camera| is_shown(camera, at));
        }
        detector.look(state);
    }
    let found = detector.detect(kind);
    let same = found.iter().filter(|found| found.actors == incident.actors);
    let near = same.map(|f| [f.begin_frame.abs_diff(incident.begin_frame), f.end_frame.abs_diff(incident.end_frame)]);
    let off = near.min_by_key(|[begin, end]| begin + end);
    let agrees = off.is_some_and(|[begin, end]| begin <= 1 && end <= 1);
    let Incident { actors, begin_frame, end_frame, time_to_collision_s, post_encroachment_s, .. } = incident;
    println!(
        "{kind}, draw {draw}, {}: frames {begin_frame} to {end_frame} of {frames}, actors {:?}, TTC {}, PET {}, {}{}",
        town.name,
        actors.iter().map(|id| id.0).collect::<Vec<_>>(),
        told(*time_to_collision_s),
        told(*post_encroachment_s),
        if shown { "in sight" } else { "OUT OF SIGHT" },
        if agrees { String::new() } else { format!(", DETECTED {found:?}") },
    );
    for other in found.iter().filter(|found| found.actors != incident.actors) {
        println!("    detected, too: {other:?}");
    }
    tally.in_sight += u32::from(shown);
    tally.agrees += u32::from(agrees);
    tally.others += found.len() - usize::from(off.is_some());
    Ok(())
}

/// Two cameras of a town, as a scene has them.
fn cameras(town: &Town, first: usize) -> [PinholeCamera; 2] {
    [first, first + 1].map(|number| PinholeCamera::new(&town.cameras[number % town.cameras.len()], SIZE))
}

/// Whether those are seen who wait at some light, and those who have passed it.
fn sees_a_light(town: &Town, focus: &Focus) -> bool {
    let lights = town.network.lanes.iter().filter(|lane| matches!(lane.end_control, TrafficControl::Signal(_)));
    let waits = |lane: &Lane| focus.on_lane(lane.id.index(), lane.centerline.length()) != 0;
    let passes = |lane: &Lane| lane.successors.iter().any(|way| focus.on_lane(way.index(), 0.0) != 0);
    lights.into_iter().any(|lane| waits(lane) && passes(lane))
}

/// Whether a place is in a picture, and near enough for a vehicle there to have a box.
fn is_shown(camera: &PinholeCamera, at: Vec3) -> bool {
    let inside = |p: Vec2| (0.0..SIZE.width as f32).contains(&p.x) && (0.0..SIZE.height as f32).contains(&p.y);
    camera.project(at).is_some_and(|(p, _)| inside(p)) && camera.position.distance(at) < 170.0
}

fn told(seconds: Option<f64>) -> String {
    seconds.map_or_else(|| "-".to_owned(), |seconds| format!("{seconds:.2} s"))
}
