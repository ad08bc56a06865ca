//! The models on an empty square in daylight, as a camera on a mast sees it: one vehicle of every design, or sixty people.
//! `cargo run --release -p endless_city --example lot -- vehicles|people OUT.jpg`.

use endless_asset::Catalogue;
use endless_city::ActorModels;
use endless_render::{CameraBake, Geometry, Instance, RenderSettings, StaticScene};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{
    Actor, AssetRef, Behaviour, CameraSite, ClassTag, Gait, ImageSize, InstanceId, LensModel, Motion, Mount,
    ObjectClass, Outfit, PersonRef, Pose, TimeOfDay, VehicleModelId, VehicleMotion, VehicleRef, WalkerMotion, Weather,
    WorldState,
};
use glam::{Affine3A, Vec2, Vec3};
use std::error::Error;

/// JPEG quality.
const QUALITY: u8 = 88;
const SIZE: ImageSize = ImageSize { width: 1920, height: 1200 };

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [what, out] = arguments.as_slice() else { return Err("usage: lot vehicles|people OUT.jpg".into()) };
    let catalogue = Catalogue::builtin();
    let (actors, height) = if what == "people" { (people(&catalogue), 8.7) } else { (vehicles(&catalogue), 36.0) };
    let still = square();
    let site = CameraSite {
        name: "mast".to_owned(),
        position: [0.0, -1.25 * height, height],
        yaw_rad: std::f32::consts::FRAC_PI_2,
        down_tilt_rad: 0.69,
        horizontal_fov_rad: 0.95,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    };
    let settings = RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, 1, SIZE);
    let state = WorldState { frame: 0, time_s: 0.0, actors, signals: Vec::new() };
    let models = ActorModels::new(&catalogue, &state.actors);
    let image = CameraBake::bake(&still, &settings, &site).render(&still, &models.frame_scene(&state)).rgb;
    let encoder = jpeg_encoder::Encoder::new_file(out, QUALITY)?;
    encoder.encode(image.data.as_flattened(), SIZE.width as u16, SIZE.height as u16, jpeg_encoder::ColorType::Rgb)?;
    Ok(())
}

fn actor(number: usize, class: ObjectClass, asset: AssetRef, pose: Pose, motion: Motion) -> Actor {
    let ridden = class.two_wheeled();
    Actor {
        id: InstanceId(2 * number as u16 + 1),
        rider_id: ridden.then_some(InstanceId(2 * number as u16 + 2)),
        class,
        asset,
        pose,
        velocity_mps: Vec3::ZERO,
        motion,
        behaviour: Behaviour::default(),
        parked: false,
    }
}

/// The first draw of each design, side by side in rows; long ones behind.
fn vehicles(catalogue: &Catalogue) -> Vec<Actor> {
    let mut names: Vec<(&str, VehicleModelId)> = Vec::new();
    for (i, model) in catalogue.vehicles().iter().enumerate() {
        if names.iter().all(|n| n.0 != model.spec.name) {
            names.push((model.spec.name, VehicleModelId::from_index(i)));
        }
    }
    let length = |&(_, i): &(&str, VehicleModelId)| catalogue.vehicles()[i.index()].spec.length_m;
    names.sort_by(|a, b| length(a).total_cmp(&length(b)));
    let mut actors = Vec::new();
    let mut y = -22.0;
    for row in names.chunks(12) {
        let deep = row.iter().map(length).fold(0.0, f32::max);
        y += 0.5 * deep + 0.8;
        let step = 40.0 / row.len() as f32 * (1.0 + 0.012 * (y + 22.0));
        for (k, &(_, model)) in row.iter().enumerate() {
            let x = step * (k as f32 - 0.5 * (row.len() - 1) as f32);
            let turn = -std::f32::consts::FRAC_PI_2 + 0.5 + 0.25 * ((k * 7 % 5) as f32 - 2.0) * 0.2;
            let spec = &catalogue.vehicles()[model.index()].spec;
            let pose = Pose::level(Vec3::new(x, y, 0.0), turn);
            let asset = VehicleRef { model, variant: u64::from(model.0) * 31 + 5 }.into();
            // What draws something is shown in a bend.
            let hitch_rad = if spec.trailer.is_some() { 0.3 } else { 0.0 };
            let motion = VehicleMotion { hitch_rad, ..VehicleMotion::default() };
            actors.push(actor(actors.len(), spec.class, asset, pose, Motion::Vehicle(motion)));
        }
        y += 0.5 * deep + 0.8;
    }
    actors
}

/// Sixty people who stand, wait, talk, walk, hurry, run, push, sit.
fn people(catalogue: &Catalogue) -> Vec<Actor> {
    const GAITS: [Gait; 12] = [
        Gait::Walk,
        Gait::Idle,
        Gait::Walk,
        Gait::Talk,
        Gait::Hurry,
        Gait::Walk,
        Gait::Wait,
        Gait::Walk,
        Gait::Run,
        Gait::Walk,
        Gait::Stand,
        Gait::Walk,
    ];
    // Rare things are shown, too.
    let mut shown: Vec<u64> = Vec::new();
    for wanted in ["pram", "dog", "wheelchair", "suitcase", "cane", "briefcase", "phone", "handbag"] {
        shown.extend((100..).find(|&v| catalogue.person(v).traits.carries == wanted));
    }
    for wanted in ["uniform", "high_visibility", "suit"] {
        shown.extend((100..).find(|&v| catalogue.person(v).traits.outfit == wanted));
    }
    for wanted in ["sari", "abaya"] {
        shown.extend((100..).find(|&v| catalogue.person(v).traits.wears.contains(&wanted)));
    }
    (0..60u64)
        .map(|i| {
            // One in eight is dressed for rain.
            let outfit = if i % 8 == 3 { Outfit::Rain } else { Outfit::Fair };
            let rare = (i % 4 == 1).then(|| shown.get(i as usize / 4)).flatten();
            let named = PersonRef { outfit, seed: rare.copied().unwrap_or(i) };
            let row = i / 12;
            let spread = 0.93 + 0.115 * row as f32;
            let at = Vec3::new(((i % 12) as f32 - 5.5) * spread, row as f32 * 1.95 - 3.1, 0.0);
            let person = catalogue.dressed_person(named);
            let gait = GAITS[(i as usize * 5 + row as usize) % 12];
            let speed_mps = match gait {
                Gait::Walk | Gait::Push => person.walk_mps,
                Gait::Hurry => 1.35 * person.walk_mps,
                Gait::Run => 3.0,
                _ => 0.0,
            };
            let motion = WalkerMotion {
                speed_mps,
                gait,
                walked_m: 0.37 * i as f32,
                time_s: 1.7 * i as f32,
                ..WalkerMotion::default()
            };
            let pose = Pose::level(at, -1.57 + 0.55 * ((i * 13 % 7) as f32 - 3.0));
            actor(i as usize, ObjectClass::Pedestrian, named.into(), pose, Motion::Walker(motion))
        })
        .collect()
}

fn square() -> StaticScene {
    let ground = Material::new(Surface::Concrete, [0.33, 0.33, 0.32], ClassTag::Ground);
    let mut mesh = MeshBuilder::new();
    let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| Vec3::new(x, y, 0.0) * 300.0);
    mesh.quad(corners, corners.map(|c| Vec2::new(c.x, c.y)), ground);
    StaticScene::new(vec![Instance::new(&Geometry::new(mesh.finish()), Affine3A::IDENTITY)], &[])
}
