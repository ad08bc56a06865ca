//! What our client makes of our server's pictures, and what the built-in renderer shows of the same scene.

use crate::client::{MAP, serve};
use crate::dataset::settings;
use endless_asset::Catalogue;
use endless_carla::client::CarlaSimulator;
use endless_city::{ActorModels, TownScene};
use endless_interchange::MapLibrary;
use endless_pipeline::{MapCatalog, MapUse, Simulator};
use endless_render::render_labels;
use endless_world::{
    ActorDensity, CameraLook, ClassTag, ImageSize, InstanceId, PinholeCamera, SceneCamera, SceneSettings, SensorFrame,
    SensorLayers, TimeOfDay, TrafficProfile, Weather,
};
use std::collections::BTreeMap;

const SIZE: ImageSize = ImageSize { width: 640, height: 360 };

/// What a picture shows of one object.
#[derive(Debug)]
struct SeenObject {
    tag: ClassTag,
    /// Left, top, right, bottom.
    bounds: [u32; 4],
    pixels: u32,
}

fn boxes(frame: &SensorFrame) -> BTreeMap<InstanceId, SeenObject> {
    let mut boxes = BTreeMap::new();
    for (i, pixel) in frame.instance.data.iter().enumerate().filter(|(_, pixel)| pixel.id != InstanceId::STUFF) {
        let (x, y) = (i as u32 % SIZE.width, i as u32 / SIZE.width);
        let new = || SeenObject { tag: pixel.tag, bounds: [x, y, x, y], pixels: 0 };
        let object = boxes.entry(pixel.id).or_insert_with(new);
        let [left, top, right, bottom] = object.bounds;
        object.bounds = [left.min(x), top.min(y), right.max(x), bottom.max(y)];
        object.pixels += 1;
    }
    boxes
}

/// Intersection over union.
fn iou(a: [u32; 4], b: [u32; 4]) -> f64 {
    let along = |k: usize| f64::from((a[k + 2].min(b[k + 2]) + 1).saturating_sub(a[k].max(b[k])));
    let area = |r: [u32; 4]| f64::from(r[2] + 1 - r[0]) * f64::from(r[3] + 1 - r[1]);
    let both = along(0) * along(1);
    both / (area(a) + area(b) - both)
}

#[test]
fn labels_are_those_of_the_built_in_renderer() {
    let simulator = CarlaSimulator::connect(settings(serve())).expect("a server");
    let sites = simulator.cameras(MAP).expect("sites");
    let scene = SceneSettings {
        video: 0,
        map: MAP.to_owned(),
        town_seed: None,
        drawn_sites: false,
        weather: Weather::Cloudy,
        time_of_day: TimeOfDay::Afternoon,
        sun_elevation_deg: None,
        changing_to: None,
        cameras: sites.iter().take(2).map(|site| SceneCamera { site: site.clone(), look: CameraLook::CLEAN }).collect(),
        sensors: Vec::new(),
        vehicles: 40,
        pedestrians: 60,
        density: ActorDensity::default(),
        focus: 0.2,
        profile: TrafficProfile::default(),
        jaywalking: 0.0,
        groups: 0.0,
        events: Vec::new(),
        size: SIZE,
        fps: 10.0,
        frames: 10,
        seed: 5,
        randomised: None,
        playback: None,
    };
    let map = simulator.load_map(&MapUse { name: MAP, cameras: &sites, videos: &[&scene] }).expect("a map");
    let mut session = simulator.open_session(&map, &scene, SensorLayers::default()).expect("a session");
    let catalogue = Catalogue::builtin();
    let town = MapLibrary::builtin().town(MAP).expect("a town");
    let built_in = TownScene::load(&town, &catalogue).expect("a scene");
    let (mut vehicles, mut people, mut apart) = (0, 0, 0);
    for _ in 0..scene.frames {
        let step = session.tick().expect("a frame");
        let seen = step.task.render(&step.state).expect("pictures");
        let models = ActorModels::in_town(&built_in, &catalogue, &step.state.actors);
        let frame = models.frame_scene(&step.state);
        for (camera, seen) in scene.cameras.iter().zip(&seen) {
            let camera = PinholeCamera::new(&camera.site, SIZE);
            let shown = render_labels(built_in.static_scene(), &frame, &camera, SensorLayers::default());
            let told = boxes(seen);
            for (id, expected) in boxes(&shown).iter().filter(|(_, object)| object.pixels >= 50) {
                let told = told.get(id).unwrap_or_else(|| panic!("{id:?} {expected:?} is not told of"));
                assert_eq!(told.tag, expected.tag);
                // A pose has other digits in degrees: now and then a pixel at an edge falls to the other side, which is much of
                // a small box.
                let near = told.bounds.iter().zip(expected.bounds).all(|(a, b)| a.abs_diff(b) <= 1);
                assert!(near, "{id:?} {told:?} {expected:?}");
                apart += u32::from(iou(told.bounds, expected.bounds) < 0.98);
                let is_person = matches!(expected.tag, ClassTag::Pedestrians | ClassTag::Rider);
                (vehicles, people) = (vehicles + u32::from(!is_person), people + u32::from(is_person));
            }
            agree(seen, &shown);
        }
    }
    assert!(vehicles > 60 && people > 12, "{vehicles} vehicles and {people} people were compared");
    assert!(apart * 50 <= vehicles + people, "{apart} of {vehicles} vehicles and {people} people have other boxes");
}

/// Depths are the same to the centimetre, but for single pixels at edges and wheels that turn.
fn agree(told: &SensorFrame, expected: &SensorFrame) {
    let (mut still, mut moving) = ([0usize; 2], [0usize; 2]);
    for i in 0..SIZE.pixels() {
        // Depth images end at a kilometre.
        let [a, b] = [told, expected].map(|frame| frame.depth.data[i].min(1000.0));
        let apart = usize::from((a - b).abs() > 0.01 || told.instance.data[i] != expected.instance.data[i]);
        let counted = if expected.instance.data[i].id != InstanceId::STUFF { &mut moving } else { &mut still };
        *counted = [counted[0] + 1, counted[1] + apart];
    }
    assert!(still[1] * 10_000 < still[0], "{still:?} pixels of what stands still");
    assert!(moving[1] * 50 < moving[0], "{moving:?} pixels of vehicles and people");
}
