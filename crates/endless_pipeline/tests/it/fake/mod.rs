//! A simulator that is fast and exact: coloured rectangles drive over a striped plain under a plain sky.
#![allow(dead_code, reason = "every test uses a part of it")]

use endless_dataset::{BuildIdentity, DatasetLayout, Recipe, Spawned};
use endless_pipeline::{
    Cameras, GenerateOptions, Generated, MapCatalog, RecipeDraft, Scene, Silent, Simulator, SimulatorError, Traffic,
    generate,
};
use endless_world::{
    Actor, CameraSite, ClassTag, FAR_PLANE_M, Image, InstanceId, InstancePixel, Motion, Mount, ObjectClass, Outfit,
    PersonRef, Pose, SceneSettings, SensorFrame, Stream, VehicleModelId, VehicleMotion, VehicleRef, WalkerMotion,
    WorldState,
};
use glam::Vec3;
use std::{
    collections::BTreeMap,
    fs,
    path::Path,
    sync::atomic::{AtomicU32, Ordering},
};

#[derive(Default)]
pub(crate) struct Fake {
    pub(crate) maps_loaded: AtomicU32,
    pub(crate) bakes: AtomicU32,
    pub(crate) renders: AtomicU32,
}

impl MapCatalog for Fake {
    fn maps(&self) -> Vec<String> {
        ["Town01", "Town02"].map(String::from).to_vec()
    }

    fn summary(&self, _map: &str) -> Result<String, SimulatorError> {
        Ok("a plain".into())
    }

    fn cameras(&self, _map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
        let site = |i: u8| CameraSite {
            name: format!("mast_{i}"),
            position: [f32::from(i), 0.0, 8.0],
            yaw_rad: f32::from(i) * 0.3,
            down_tilt_rad: 0.4,
            horizontal_fov_rad: 1.2,
            mount: Mount::Pole,
        };
        Ok((0..9).map(site).collect())
    }
}

impl Simulator for Fake {
    type Map = ();

    fn load_map(&self, _name: &str) -> Result<(), SimulatorError> {
        self.maps_loaded.fetch_add(1, Ordering::SeqCst);
        Ok(())
    }

    fn load_scene<'m>(&'m self, _map: &'m (), settings: &SceneSettings) -> Result<Scene<'m>, SimulatorError> {
        // The plain has room for twelve vehicles.
        let vehicles = settings.vehicles.min(12);
        let spawned = Spawned { vehicles, pedestrians: settings.pedestrians, parked: 1 };
        let parked = vec![Actor { parked: true, ..actor(1, ObjectClass::Van) }];
        let drive = || Drive { next: 0, fps: settings.fps, seed: settings.seed, spawned };
        Ok(Scene {
            spawned,
            parked,
            moving: drive().tick().actors,
            skin_tones: Default::default(),
            bodies: None,
            traffic: Box::new(drive()),
        })
    }

    fn bake<'m>(
        &'m self,
        _map: &'m (),
        settings: &SceneSettings,
        _moving: &[Actor],
    ) -> Result<Box<dyn Cameras + 'm>, SimulatorError> {
        self.bakes.fetch_add(1, Ordering::SeqCst);
        Ok(Box::new(Eyes { fake: self, settings: settings.clone() }))
    }
}

fn actor(id: u16, class: ObjectClass) -> Actor {
    let (motion, asset) = match class {
        ObjectClass::Pedestrian => {
            (Motion::Walker(WalkerMotion::default()), PersonRef { outfit: Outfit::Fair, seed: 0 }.into())
        }
        _ => (Motion::Vehicle(VehicleMotion::default()), VehicleRef { model: VehicleModelId(0), variant: 0 }.into()),
    };
    Actor {
        id: InstanceId(id),
        rider_id: None,
        class,
        asset,
        pose: Pose::level(Vec3::ZERO, 0.0),
        velocity_mps: Vec3::new(1.0, 0.0, 0.0),
        motion,
        parked: false,
    }
}

struct Drive {
    next: u32,
    fps: f64,
    seed: u64,
    spawned: Spawned,
}

impl Traffic for Drive {
    fn tick(&mut self) -> WorldState {
        let frame = self.next;
        self.next += 1;
        let count = (self.spawned.vehicles + self.spawned.pedestrians) as u16;
        let classes = [ObjectClass::Car, ObjectClass::Truck, ObjectClass::Bus, ObjectClass::Motorcycle];
        let actors = (0..count).map(|i| {
            let vehicle = u32::from(i) < self.spawned.vehicles;
            let class = if vehicle { classes[usize::from(i) % 4] } else { ObjectClass::Pedestrian };
            let mut actor = actor(2 + i, class);
            let mut stream = Stream::named(self.seed, "fake", &[u64::from(i)]);
            let speed = stream.range_f32(0.002, 0.02);
            let x = (stream.f32() + speed * frame as f32).fract();
            actor.pose.position = Vec3::new(x, stream.f32(), 10.0 + f32::from(i));
            actor
        });
        WorldState { frame, time_s: f64::from(frame) / self.fps, actors: actors.collect(), signals: Vec::new() }
    }
}

struct Eyes<'a> {
    fake: &'a Fake,
    settings: SceneSettings,
}

impl Cameras for Eyes<'_> {
    fn render(&self, state: &WorldState) -> Vec<SensorFrame> {
        self.fake.renders.fetch_add(1, Ordering::SeqCst);
        (0..self.settings.cameras.len() as u32).map(|camera| self.one(state, camera)).collect()
    }
}

impl Eyes<'_> {
    fn one(&self, state: &WorldState, camera: u32) -> SensorFrame {
        let size = self.settings.size;
        let (w, h) = (size.width, size.height);
        let sky = InstancePixel { tag: ClassTag::Sky, id: InstanceId::STUFF };
        let mut frame = SensorFrame {
            frame: state.frame,
            rgb: Image::filled(size, [120, 160, 220]),
            depth: Image::filled(size, FAR_PLANE_M),
            instance: Image::filled(size, sky),
        };
        for y in h / 3..h {
            for x in 0..w {
                let i = (y * w + x) as usize;
                frame.rgb.data[i] = [(x * 7 + camera * 50) as u8, (y * 3) as u8, (x ^ y) as u8];
                frame.depth.data[i] = 30.0 + 300.0 / (1 + y) as f32;
                frame.instance.data[i].tag = ClassTag::Roads;
            }
        }
        let parked = actor(1, ObjectClass::Van);
        for actor in state.actors.iter().chain([&parked]) {
            let shift = 0.1 * camera as f32;
            let x0 = ((actor.pose.position.x + shift) * w as f32) as u32;
            let y0 = h / 3 + (actor.pose.position.y * h as f32 * 0.5) as u32;
            for y in y0..(y0 + h / 8 + 1).min(h) {
                for x in x0..(x0 + w / 8 + 1).min(w) {
                    let i = (y * w + x) as usize;
                    let bits = actor.id.0.wrapping_mul(40_503).to_le_bytes();
                    frame.rgb.data[i] = [bits[0], bits[1], 200];
                    frame.depth.data[i] = 10.0 + f32::from(actor.id.0) * 0.1;
                    frame.instance.data[i] = InstancePixel { tag: actor.class.tag(), id: actor.id };
                }
            }
        }
        frame
    }
}

pub(crate) fn draft() -> RecipeDraft {
    RecipeDraft {
        videos: Some(3),
        vehicles: Some(6),
        pedestrians: Some(4),
        size: Some("97x63".into()),
        fps: Some(10.0),
        duration: Some(2.0),
        min_pixels: Some(20),
        ..Default::default()
    }
}

pub(crate) fn recipe(draft: RecipeDraft) -> Recipe {
    draft.resolve(&Fake::default()).expect("valid")
}

pub(crate) fn make(fake: &Fake, recipe: &Recipe, out: &Path, threads: usize) -> Generated {
    generate(fake, recipe, out, &options(threads), &Silent).expect("makes the dataset")
}

/// How the tests' one build runs.
pub(crate) fn options(threads: usize) -> GenerateOptions {
    GenerateOptions { build: build("fake"), allow_other_build: false, threads, plan_only: false }
}

/// A build of these sources.
pub(crate) fn build(sources: &str) -> BuildIdentity {
    BuildIdentity { version: "0.0.0".into(), commit: None, sources: sources.into() }
}

/// Every file and its bytes.
pub(crate) fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    gather(folder, folder, &mut files);
    files
}

fn gather(root: &Path, folder: &Path, files: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            gather(root, &path, files);
        } else {
            let name = path.strip_prefix(root).expect("below").to_string_lossy().into_owned();
            files.insert(name, fs::read(&path).expect("a file"));
        }
    }
}

/// Fails with the first names that differ, not with megabytes of bytes.
pub(crate) fn assert_same(a: &Path, b: &Path) {
    let (a, b) = (contents(a), contents(b));
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&a), names(&b), "the same files");
    let differ: Vec<&String> = a.iter().filter(|(name, bytes)| b[*name] != **bytes).map(|(name, _)| name).collect();
    assert!(differ.is_empty(), "these files differ: {differ:?}");
}

/// The first video's layout.
pub(crate) fn first_video(out: &Path) -> endless_dataset::VideoLayout {
    let layout = DatasetLayout::new(out);
    let settings: SceneSettings = endless_dataset::read_json(&layout.scene(0)).expect("planned");
    layout.video(&settings)
}
