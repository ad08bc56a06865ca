//! Films a town's middle from above, half a second a picture:
//! `cargo run -p endless_traffic --release --example film -- Town03 out/frame [pictures] [x y] [metres] [incident|none] [seed]
//! [people] [jaywalking] [groups]`. With the name of an incident, such as `collision`, it is staged there and filmed from two
//! seconds before it begins.
//! Lanes are grey, stop lines carry their signal's colour, crossings are white, vehicles are boxes with a light nose
//! (red tail: brake lights, yellow flank: indicator), parked ones grey, people are discs with a nose.

use endless_asset::Catalogue;
use endless_road::{TrafficControl, WalkKind};
use endless_town::Town;
use endless_traffic::{DrivingCondition, Fleet, Focus, IncidentRequest, Simulation, TrafficSettings, View};
use endless_world::math::{atan2, sin_cos};
use endless_world::{Actor, IncidentKind, Motion, SignalAspect, VehicleLights, WorldState};
use glam::Vec2;
use std::{error::Error, fs::File, io::BufWriter};

const SIDE: usize = 900;

struct Picture {
    pixels: Vec<[u8; 3]>,
    centre: Vec2,
    scale: f32,
}

impl Picture {
    fn pixel(&self, p: Vec2) -> Vec2 {
        let q = (p - self.centre) * self.scale;
        Vec2::new(q.x, -q.y) + Vec2::splat(SIDE as f32 / 2.0)
    }

    /// Fills a rectangle given by its middle, heading and half sizes, metres.
    fn rectangle(&mut self, middle: Vec2, yaw: f32, half: Vec2, color: [u8; 3]) {
        let (sin, cos) = sin_cos(yaw);
        let (along, across) = (Vec2::new(cos, sin), Vec2::new(-sin, cos));
        let step = 0.5 / self.scale;
        let n = (half / step).ceil();
        for i in -n.x as i32..=n.x as i32 {
            for j in -n.y as i32..=n.y as i32 {
                let at = Vec2::new(i as f32, j as f32) / n.max(Vec2::ONE) * half;
                let p = self.pixel(middle + along * at.x + across * at.y);
                if p.x >= 0.0 && p.y >= 0.0 && p.x < SIDE as f32 && p.y < SIDE as f32 {
                    self.pixels[p.y as usize * SIDE + p.x as usize] = color;
                }
            }
        }
    }

    fn line(&mut self, a: Vec2, b: Vec2, width: f32, color: [u8; 3]) {
        let yaw = atan2(b.y - a.y, b.x - a.x);
        self.rectangle((a + b) / 2.0, yaw, Vec2::new(a.distance(b), width) / 2.0, color);
    }

    fn save(&self, path: &str) -> Result<(), Box<dyn Error>> {
        let mut encoder = png::Encoder::new(BufWriter::new(File::create(path)?), SIDE as u32, SIDE as u32);
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        encoder.write_header()?.write_image_data(&self.pixels.concat())?;
        Ok(())
    }
}

fn draw_streets(picture: &mut Picture, town: &Town, state: &WorldState) {
    let network = &town.network;
    for lane in &network.lanes {
        for pair in lane.centerline.points().windows(2) {
            let [a, b] = [pair[0], pair[1]].map(|p| p.as_vec3().truncate());
            picture.line(a, b, lane.width_m as f32, [70, 72, 76]);
        }
    }
    for edge in &network.walk.edges {
        let [a, b] = edge.nodes.map(|n| network.walk.nodes[n.index()].as_vec3().truncate());
        let color = if edge.kind == WalkKind::Sidewalk { [150, 146, 138] } else { [120, 122, 126] };
        picture.line(a, b, edge.width_m as f32, color);
    }
    for lane in &network.lanes {
        let TrafficControl::Signal(signal) = lane.end_control else { continue };
        let end = lane.centerline.at(lane.centerline.length());
        let color = match state.signals[usize::from(signal.0)].aspect {
            SignalAspect::Red => [255, 40, 40],
            SignalAspect::Yellow => [255, 200, 0],
            _ => [40, 230, 60],
        };
        let half = Vec2::new(0.3, lane.width_m as f32 / 2.0 - 0.2);
        picture.rectangle(end.position.as_vec3().truncate(), end.heading_rad as f32, half, color);
    }
}

fn draw_actor(picture: &mut Picture, catalogue: &Catalogue, actor: &Actor) {
    let at = actor.pose.position.truncate();
    let (sin, cos) = sin_cos(actor.pose.yaw_rad);
    let (ahead, left) = (Vec2::new(cos, sin), Vec2::new(-sin, cos));
    let yaw = actor.pose.yaw_rad;
    match actor.motion {
        Motion::Vehicle(motion) => {
            let spec =
                &catalogue.vehicles()[actor.asset.vehicle().expect("what drives is a vehicle").model.index()].spec;
            let half = Vec2::new(spec.length_m, spec.width_m) / 2.0;
            let body = if actor.parked { [95, 100, 110] } else { [60, 120, 220] };
            picture.rectangle(at, yaw, half, body);
            picture.rectangle(at + ahead * (half.x - 0.3), yaw, Vec2::new(0.3, half.y), [230, 235, 255]);
            if motion.lights.contains(VehicleLights::BRAKE) {
                picture.rectangle(at - ahead * (half.x - 0.3), yaw, Vec2::new(0.3, half.y), [255, 30, 30]);
            }
            for (bit, side) in [(VehicleLights::LEFT_BLINKER, 1.0), (VehicleLights::RIGHT_BLINKER, -1.0)] {
                if motion.lights.contains(bit) {
                    let corner = at + ahead * (half.x - 0.8) + left * side * (half.y - 0.2);
                    picture.rectangle(corner, yaw, Vec2::new(0.6, 0.25), [255, 190, 0]);
                }
            }
        }
        Motion::Walker(_) => {
            for k in 0..4 {
                picture.rectangle(at, yaw + k as f32 * 0.4, Vec2::splat(0.4), [240, 80, 200]);
            }
            picture.rectangle(at + ahead * 0.5, yaw, Vec2::splat(0.18), [255, 255, 255]);
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let name = args.first().map_or("Town03", String::as_str);
    let stem = args.get(1).map_or("topview", String::as_str);
    let number = |i: usize, default: f32| args.get(i).and_then(|a| a.parse().ok()).unwrap_or(default);
    let mut centre = Vec2::new(number(3, 0.0), number(4, 0.0));
    let scale = SIDE as f32 / number(5, 130.0);
    let catalogue = Catalogue::builtin();
    let town = endless_town::load(name, &catalogue)?;
    let specs = catalogue.vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let settings = TrafficSettings {
        vehicles: 60,
        seed: number(7, 1.0) as u64,
        pedestrians: number(8, 40.0) as u32,
        jaywalking: f64::from(number(9, 0.0)),
        groups: f64::from(number(10, 0.0)),
        bus_stops: town.bus_stops(),
        bench_seats: town.bench_seats(),
        parking_bays: town.parking_bays.clone(),
        focus: Focus::new(&town.network, &[View::around(centre.extend(0.0))], 0.8, &|_, _| true),
        ..TrafficSettings::default()
    };
    let mut simulation = Simulation::new(&town.network, &fleet, &town.parked, &settings)?;
    if let Some(kind) = args.get(6).filter(|kind| *kind != "none") {
        let kind: IncidentKind = kind.parse()?;
        let condition = |_| DrivingCondition::default();
        let (seed, sight) = (settings.seed, &settings.focus);
        let request = IncidentRequest { kinds: &[kind], frames: 300, seed, sight, condition: &condition };
        let staged = simulation.stage(&request);
        let incident = staged.incidents.first().ok_or("it could not be had there")?;
        centre = glam::Vec3::from(incident.position).truncate();
        (20..incident.begin_frame).for_each(|_| simulation.tick());
    }
    for i in 0..number(2, 20.0) as usize {
        let state = simulation.state();
        let mut picture = Picture { pixels: vec![[44, 58, 40]; SIDE * SIDE], centre, scale };
        draw_streets(&mut picture, &town, &state);
        for actor in simulation.parked().iter().chain(&state.actors) {
            draw_actor(&mut picture, &catalogue, actor);
        }
        picture.save(&format!("{stem}_{i:03}.png"))?;
        (0..5).for_each(|_| simulation.tick());
    }
    Ok(())
}
