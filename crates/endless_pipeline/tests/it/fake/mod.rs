//! A simulator that is fast and exact: coloured rectangles drive over a striped plain under a plain sky.

mod live;

pub(crate) use live::{Fault, LiveFake};

use endless_annotate::{ActorRecord, SceneObjects};
use endless_dataset::{BuildIdentity, DatasetLayout, Recipe, RecipeDraft, SpawnCounts};
use endless_pipeline::{
    Capabilities, GenerateOptions, Generated, MapUse, RenderTask, SceneTruth, SilentProgress, SimulationSession,
    SimulationStep, Simulator, SimulatorError, generate, resolve_recipe,
};
use endless_world::{
    Actor, Behaviour, BodyKeypoints, CameraSite, ClassTag, FAR_PLANE_M, FlowPixel, Image, InstanceId, InstancePixel,
    LensModel, Motion, Mount, ObjectClass, Outfit, PersonRef, PinholeCamera, Pose, SceneSettings, SensorFrame,
    SensorLayers, Stream, VehicleModelId, VehicleMotion, VehicleRef, WalkerMotion, WorldState,
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

pub(crate) fn sites() -> Vec<CameraSite> {
    let site = |i: u8| CameraSite {
        name: format!("mast_{i}"),
        position: [f32::from(i), 0.0, 8.0],
        yaw_rad: f32::from(i) * 0.3,
        down_tilt_rad: 0.4,
        horizontal_fov_rad: 1.2,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    };
    (0..9).map(site).collect()
}

/// What both fakes know of maps: two, with the same masts.
macro_rules! two_maps {
    ($simulator:ty) => {
        impl endless_pipeline::MapSource for $simulator {
            fn maps(&self) -> Vec<String> {
                ["Town01", "Town02"].map(String::from).to_vec()
            }
        }

        impl endless_pipeline::MapCatalog for $simulator {
            fn cameras(&self, _map: &str) -> Result<Vec<endless_world::CameraSite>, endless_pipeline::SimulatorError> {
                Ok($crate::fake::sites())
            }
        }
    };
}

pub(crate) use two_maps;

two_maps!(Fake);

impl Simulator for Fake {
    type Map = ();

    fn capabilities(&self) -> Capabilities {
        Capabilities { random_access: true, repeatable: true, waits: false }
    }

    fn load_map(&self, _wanted: &MapUse<'_>) -> Result<(), SimulatorError> {
        self.maps_loaded.fetch_add(1, Ordering::SeqCst);
        Ok(())
    }

    fn open_session<'m>(
        &'m self,
        _map: &'m (),
        settings: &'m SceneSettings,
        _wanted: SensorLayers,
    ) -> Result<Box<dyn SimulationSession<'m> + 'm>, SimulatorError> {
        Ok(Box::new(Drive { fake: self, settings, next: 0 }))
    }
}

/// The plain has room for twelve vehicles.
pub(crate) fn placed(settings: &SceneSettings) -> SpawnCounts {
    SpawnCounts { vehicles: settings.vehicles.min(12), pedestrians: settings.pedestrians, parked: 1 }
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
        behaviour: Behaviour::default(),
        parked: false,
    }
}

/// The one vehicle that stands there all the time.
pub(crate) fn parked() -> Actor {
    Actor { parked: true, ..actor(1, ObjectClass::Van) }
}

/// The world at a frame, as a seed moves it.
pub(crate) fn world(settings: &SceneSettings, seed: u64, frame: u32) -> WorldState {
    let spawned = placed(settings);
    let count = (spawned.vehicles + spawned.pedestrians) as u16;
    let classes = [ObjectClass::Car, ObjectClass::Truck, ObjectClass::Bus, ObjectClass::Motorcycle];
    let actors = (0..count).map(|i| {
        let vehicle = u32::from(i) < spawned.vehicles;
        let class = if vehicle { classes[usize::from(i) % 4] } else { ObjectClass::Pedestrian };
        let mut actor = actor(2 + i, class);
        let mut stream = Stream::named(seed, "fake", &[u64::from(i)]);
        let speed = stream.range_f32(0.002, 0.02);
        let x = (stream.f32() + speed * frame as f32).fract();
        actor.pose.position = Vec3::new(x, stream.f32(), 10.0 + f32::from(i));
        actor
    });
    WorldState { frame, time_s: f64::from(frame) / settings.fps, actors: actors.collect(), signals: Vec::new() }
}

struct Drive<'m> {
    fake: &'m Fake,
    settings: &'m SceneSettings,
    next: u32,
}

impl<'m> SimulationSession<'m> for Drive<'m> {
    fn spawned(&self) -> SpawnCounts {
        placed(self.settings)
    }

    fn actors(&self) -> Option<Vec<ActorRecord>> {
        let moving = world(self.settings, self.settings.seed, 0).actors;
        Some(std::iter::once(&parked()).chain(&moving).map(|a| ActorRecord::new(a.id, a.class, a.parked)).collect())
    }

    fn prepare(&mut self) -> Result<(), SimulatorError> {
        self.fake.bakes.fetch_add(1, Ordering::SeqCst);
        Ok(())
    }

    fn tick(&mut self) -> Result<SimulationStep<'m>, SimulatorError> {
        let state = world(self.settings, self.settings.seed, self.next);
        self.next += 1;
        Ok(SimulationStep { state, task: Box::new(Eyes { fake: self.fake, settings: self.settings }) })
    }
}

struct Eyes<'m> {
    fake: &'m Fake,
    settings: &'m SceneSettings,
}

impl<'m> RenderTask<'m> for Eyes<'_> {
    fn truth(&self, state: &WorldState) -> SceneTruth<'m> {
        let people = state.actors.iter().filter(|a| a.class == ObjectClass::Pedestrian);
        SceneTruth {
            objects: SceneObjects::new(state, &[parked()]),
            bodies: people.map(|a| (a.id, body(self.settings, a))).collect(),
            shapes: None,
        }
    }

    fn render(self: Box<Self>, state: &WorldState) -> Result<Vec<SensorFrame>, SimulatorError> {
        self.fake.renders.fetch_add(1, Ordering::SeqCst);
        Ok((0..self.settings.cameras.len() as u32).map(|camera| paint(self.settings, state, camera)).collect())
    }
}

/// Top-left corner of an actor's rectangle, and its depth.
fn rectangle(settings: &SceneSettings, actor: &Actor, camera: u32) -> ([u32; 2], f32) {
    let (w, h) = (settings.size.width as f32, settings.size.height);
    let x = (actor.pose.position.x + 0.1 * camera as f32) * w;
    let y = h / 3 + (actor.pose.position.y * h as f32 * 0.5) as u32;
    ([x as u32, y], 10.0 + f32::from(actor.id.0) * 0.1)
}

/// Keypoints within the rectangle of the first camera, every other one far behind it.
fn body(settings: &SceneSettings, actor: &Actor) -> BodyKeypoints {
    let camera = PinholeCamera::new(&settings.cameras[0].site, settings.size);
    let ([x, y], depth) = rectangle(settings, actor, 0);
    let k = camera.intrinsics;
    let point = |i: usize| {
        let z = depth + if i.is_multiple_of(2) { 0.0 } else { 3.0 };
        let at = Vec3::new((x as f32 + 2.5 - k.cx) / k.fx, (y as f32 + 2.5 - k.cy) / k.fy, 1.0);
        camera.position + camera.world_from_camera * (at * z)
    };
    BodyKeypoints { body: std::array::from_fn(point), feet: std::array::from_fn(point) }
}

/// What a camera sees.
pub(crate) fn paint(settings: &SceneSettings, state: &WorldState, camera: u32) -> SensorFrame {
    let size = settings.size;
    let (w, h) = (size.width, size.height);
    let sky = InstancePixel { tag: ClassTag::Sky, id: InstanceId::STUFF };
    let mut frame = SensorFrame {
        frame: state.frame,
        rgb: Image::filled(size, [120, 160, 220]),
        depth: Image::filled(size, FAR_PLANE_M),
        instance: Image::filled(size, sky),
        normals: Some(Image::filled(size, [0; 3])),
        albedo: Some(Image::filled(size, [0; 3])),
        shadow: Some(Image::filled(size, 0)),
        body_parts: Some(Image::filled(size, 0)),
        flow: Some(Image::filled(size, FlowPixel::STILL.encoded())),
        flow_backward: Some(Image::filled(size, FlowPixel::STILL.encoded())),
    };
    for y in h / 3..h {
        for x in 0..w {
            let i = (y * w + x) as usize;
            frame.rgb.data[i] = [(x * 7 + camera * 50) as u8, (y * 3) as u8, (x ^ y) as u8];
            frame.depth.data[i] = 30.0 + 300.0 / (1 + y) as f32;
            frame.instance.data[i].tag = ClassTag::Roads;
            frame.normals.iter_mut().for_each(|image| image.data[i] = [32_768, 0, 32_768]);
        }
    }
    for actor in state.actors.iter().chain([&parked()]) {
        let ([x0, y0], depth) = rectangle(settings, actor, camera);
        for y in y0..(y0 + h / 8 + 1).min(h) {
            for x in x0..(x0 + w / 8 + 1).min(w) {
                let i = (y * w + x) as usize;
                let bits = actor.id.0.wrapping_mul(40_503).to_le_bytes();
                frame.rgb.data[i] = [bits[0], bits[1], 200];
                frame.depth.data[i] = depth;
                frame.normals.iter_mut().for_each(|image| image.data[i] = [32_768, 32_768, 0]);
                frame.albedo.iter_mut().for_each(|image| image.data[i] = [bits[0], bits[1], 7]);
                let person = actor.class.tag() == ClassTag::Pedestrians;
                frame.body_parts.iter_mut().for_each(|image| image.data[i] = u8::from(person));
                frame.instance.data[i] = InstancePixel { tag: actor.class.tag(), id: actor.id };
            }
        }
    }
    frame
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
    resolve_recipe(draft, &Fake::default()).expect("valid")
}

pub(crate) fn make<S: Simulator>(fake: &S, recipe: &Recipe, out: &Path, threads: usize) -> Generated {
    generate(fake, recipe, out, &options(threads), &SilentProgress).expect("makes the dataset")
}

/// How the tests' one build runs.
pub(crate) fn options(threads: usize) -> GenerateOptions {
    GenerateOptions { build: build("fake"), allow_other_build: false, threads, plan_only: false, shard: None }
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
