//! Cameras behind other lenses than a pinhole: they see what pinholes see, and their labels are theirs.

use crate::{
    city::city,
    fake::{assert_same, options},
    seen::Seen,
};
use endless_dataset::{
    CameraRecord, DatasetLayout, Layer, RecipeDraft, UserCamera, VideoLayout, check, read_json, read_objects,
};
use endless_interchange::MapLibrary;
use endless_pipeline::{Generated, SilentProgress, generate, resolve_recipe};
use endless_world::{
    CameraSite, ClassTag, DepthMeasure, FAR_PLANE_M, InstanceId, InstancePixel, LensModel, PinholeCamera,
};
use glam::{Vec2, Vec3};
use serde_json::{Value, json};
use std::path::Path;

const TOWN: &str = "Town03";

fn draft() -> RecipeDraft {
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    RecipeDraft {
        videos: Some(1),
        maps: words(&[TOWN]),
        weathers: words(&["cloudy"]),
        times: words(&["afternoon"]),
        size: Some("256x144".to_owned()),
        fps: Some(10.0),
        duration: Some(0.2),
        vehicles: Some(40),
        pedestrians: Some(20),
        cameras_per_scene: Some(0),
        min_pixels: Some(1),
        layers: words(&["rgb", "depth", "instance", "normals"]),
        mp4: Some(Vec::new()),
        camera_look: Some("clean".to_owned()),
        ..RecipeDraft::default()
    }
}

fn make(draft: RecipeDraft, out: &Path) -> (Generated, VideoLayout) {
    let recipe = resolve_recipe(draft, city()).expect("a recipe");
    let made = generate(city(), &recipe, out, &options(2), &SilentProgress).expect("a dataset");
    let video = DatasetLayout::new(out).video(&made.plan.scenes[0]);
    (made, video)
}

/// Over the middle of the largest junction.
fn above_junction(name: &str, yaw: f64, pitch: f64, height: f64, change: &Value) -> Value {
    let mount = json!({"on": "pose", "from": "junction", "at": [0.0, 0.0, height], "yaw": yaw, "pitch": pitch});
    let mut sensor = json!({"name": name, "type": "camera", "mount": mount});
    for (key, value) in change.as_object().expect("an object") {
        sensor[key] = value.clone();
    }
    sensor
}

/// A camera of the rig that stands still.
fn seen_by(made: &Generated, video: &VideoLayout, name: &str) -> Seen {
    let sensor = made.plan.scenes[0].sensors.iter().find(|sensor| sensor.name == name).expect("of the rig");
    let (fixed, size) = (sensor.fixed_camera().expect("it stands"), sensor.model.camera().expect("a lens").size);
    Seen::read(&video.sensor(name), PinholeCamera::new(&fixed.site, size))
}

#[test]
fn a_fisheye_and_a_panorama_see_what_pinholes_see_from_there() {
    let square = |fov: f64| json!({"size": "241x241", "fov": fov});
    let pinhole = |name: &str, yaw: f64| above_junction(name, yaw, -12.0, 6.0, &square(90.0));
    let sensors = json!([
        pinhole("north", 90.0),
        pinhole("west", 180.0),
        pinhole("south", 270.0),
        pinhole("east", 0.0),
        above_junction("fisheye", 90.0, -12.0, 6.0, &json!({"size": "321x321", "fov": 180.0, "lens": "fisheye"})),
        above_junction(
            "bent",
            90.0,
            -12.0,
            6.0,
            &json!({"size": "321x321", "fov": 190.0, "lens": {"model": "fisheye", "k": [0.02, -0.004, 0.0, 0.0]}})
        ),
        above_junction("panorama", 40.0, 0.0, 6.0, &json!({"size": "640x320", "lens": "equirectangular"})),
    ]);
    let out = tempfile::tempdir().expect("temp");
    let draft = RecipeDraft { sensor: serde_json::from_value(sensors).ok(), vehicles: Some(90), ..draft() };
    let (made, video) = make(draft, out.path());
    let seen = |name: &str| seen_by(&made, &video, name);
    let panorama = seen("panorama");
    for name in ["fisheye", "bent"] {
        let (north, fisheye) = (seen("north"), seen(name));
        let [asked, objects, unlike, apart] = north.compare(&fisheye);
        println!("{name}: {asked} directions, {objects} of objects, {unlike} unlike, {apart} apart");
        assert!(asked > 12_000 && objects > 50, "{asked} directions, {objects} of objects");
        assert!(unlike * 1000 <= asked && apart * 1000 <= asked, "{unlike} unlike, {apart} apart of {asked}");
        // Beyond the image circle there is nothing.
        for (x, y) in [(0, 0), (320, 0), (3, 317)] {
            let nothing = InstancePixel { tag: ClassTag::Unlabeled, id: InstanceId::STUFF };
            assert_eq!((*fisheye.instance.at(x, y), *fisheye.rgb.at(x, y)), (nothing, [0; 3]));
            assert!(*fisheye.depth.at(x, y) > FAR_PLANE_M - 0.01);
        }
        let [asked, _, unlike, apart] = fisheye.compare(&panorama);
        println!("{name} and panorama: {asked} directions, {unlike} unlike, {apart} apart");
        assert!(asked > 30_000 && unlike * 1000 <= asked && apart * 1000 <= asked, "{unlike} and {apart} of {asked}");
    }
    for name in ["north", "west", "south", "east"] {
        let [asked, _, unlike, apart] = seen(name).compare(&panorama);
        println!("{name}: {asked} directions, {unlike} unlike, {apart} apart");
        assert!(asked > 12_000 && unlike * 1000 <= asked && apart * 1000 <= asked, "{unlike} and {apart} of {asked}");
    }
    let record: CameraRecord = read_json(&video.sensor("bent").camera()).expect("a record");
    assert_eq!((record.lens.model.as_str(), record.lens.depth), ("opencv_fisheye", DepthMeasure::Distance));
    assert_eq!(check(out.path()).expect("readable").findings, []);
}

#[test]
fn from_above_objects_are_where_the_world_has_them() {
    let lens = json!({"size": "480x480", "lens": {"model": "orthographic", "width": 80.0}});
    let sensors = json!([above_junction("above", 90.0, -90.0, 60.0, &lens)]);
    let out = tempfile::tempdir().expect("temp");
    let draft = RecipeDraft { sensor: serde_json::from_value(sensors).ok(), vehicles: Some(90), ..draft() };
    let (made, video) = make(draft, out.path());
    let camera = seen_by(&made, &video, "above").camera;
    // North is up: a metre is six pixels.
    let [middle, east, north] = [Vec3::ZERO, Vec3::X, Vec3::Y]
        .map(|way| camera.project(camera.position + way - Vec3::Z * 50.0).expect("below").0);
    assert!((middle - Vec2::splat(240.0)).length() < 0.01, "{middle}");
    assert!(
        (east - middle - Vec2::new(6.0, 0.0)).length() < 0.01
            && (north - middle - Vec2::new(0.0, -6.0)).length() < 0.01
    );
    let mut asked = 0;
    for line in read_objects(&video.sensor("above").objects()).expect("objects") {
        for object in &line.objects {
            let (Some(spatial), Some(amodal)) = (&object.spatial, &object.amodal) else { continue };
            let b = amodal.amodal_bbox;
            if amodal.visibility < 0.95 || amodal.truncation > 0.0 || object.truncated || object.pixels < 60 {
                continue;
            }
            let [x, y, _] = spatial.box3d.center.map(|value| value as f32);
            let place = Vec2::new(x - camera.position.x, camera.position.y - y) * 6.0 + 240.0;
            let shown = Vec2::new(b.x as f32 + b.w as f32 / 2.0, b.y as f32 + b.h as f32 / 2.0);
            assert!((place - shown).abs().max_element() < 3.0, "{place} {shown} {object:?}");
            // Its box in the picture is as large as in the world, whatever its height.
            let corners = spatial.box3d.corners.map(|corner| corner.expect("all are ahead"));
            assert!((corners[0][0] - corners[4][0]).abs() < 0.1 && (corners[0][1] - corners[4][1]).abs() < 0.1);
            asked += 1;
        }
    }
    assert!(asked > 5, "{asked} objects");
    assert_eq!(check(out.path()).expect("readable").findings, []);
}

fn own_camera(name: &str, lens: LensModel, change: impl Fn(&mut CameraSite)) -> UserCamera {
    let mut site = MapLibrary::builtin().cameras(TOWN).expect("a town").swap_remove(0);
    change(&mut site);
    UserCamera {
        map: TOWN.to_owned(),
        name: name.to_owned(),
        position: site.position.map(f64::from),
        yaw: f64::from(site.yaw_rad).to_degrees(),
        down: f64::from(site.down_tilt_rad).to_degrees(),
        fov: None,
        lens,
    }
}

/// Three lenses instead of a map's own cameras.
fn own_cameras() -> RecipeDraft {
    RecipeDraft {
        cameras_per_scene: Some(3),
        cameras: Some(vec![
            own_camera("fisheye", LensModel::Fisheye { k: [0.0; 4] }, |_| ()),
            own_camera("round", LensModel::Equirectangular, |site| site.down_tilt_rad = 0.0),
            own_camera("above", LensModel::Orthographic { width_m: 50.0 }, |site| {
                site.position[2] += 30.0;
                site.down_tilt_rad = 1.2;
            }),
        ]),
        layers: Some(Layer::ALL.iter().map(|layer| layer.name().to_owned()).collect()),
        amodal_masks: Some(true),
        camera_look: Some("cctv".to_owned()),
        ..draft()
    }
}

#[test]
fn all_layers_and_labels_of_other_lenses_agree() {
    let out = [0, 1].map(|_| tempfile::tempdir().expect("temp"));
    let (_, video) = make(own_cameras(), out[0].path());
    let report = check(out[0].path()).expect("readable");
    assert_eq!(report.findings, []);
    assert!(report.boxes > 30, "{} boxes", report.boxes);
    for (number, lines) in [(0, 10), (1, 10), (2, 3)] {
        let map: endless_annotate::CameraMap = read_json(&video.camera(number).map()).expect("a map");
        let shown: usize = map.lanes.iter().map(|lane| lane.center.len()).sum();
        assert!(shown >= lines, "camera {number}: {shown} lines");
        let record: CameraRecord = read_json(&video.camera(number).camera()).expect("a record");
        // A look bends perspective lenses only; and no matrix tells of the ground here.
        assert!(record.ground_plane.is_none() && record.lens.model != "opencv");
    }
    let (_, _) = make(own_cameras(), out[1].path());
    assert_same(out[0].path(), out[1].path());
}

#[test]
fn lenses_that_cannot_be_are_told_in_one_line() {
    let told = |change: Value| {
        let sensors = json!([above_junction("eye", 0.0, 0.0, 6.0, &change)]);
        let sensors: Result<Vec<endless_dataset::SensorSpec>, _> = serde_json::from_value(sensors);
        let error = match sensors {
            Err(error) => error.to_string(),
            Ok(sensors) => {
                let draft = RecipeDraft { sensor: Some(sensors), ..draft() };
                resolve_recipe(draft, city()).expect_err("refused").to_string()
            }
        };
        assert_eq!(error.lines().count(), 1, "{error}");
        error
    };
    let fisheye = told(json!({"lens": "fisheye", "fov": 230}));
    assert!(fisheye.contains("sensor eye: fov is 230: write a number from 1 to 220 for a fisheye lens"), "{fisheye}");
    assert!(told(json!({"fov": 151})).contains("from 1 to 150 for a pinhole lens"));
    assert!(told(json!({"lens": "fish"})).contains("'fish' is no lens: write one of pinhole, fisheye"));
    assert!(
        told(json!({"lens": {"model": "fisheye", "k": [-0.3, 0, 0, 0]}}))
            .contains("folds back: write a fov of at most")
    );
    assert!(
        told(json!({"lens": {"model": "orthographic", "width": 0}})).contains("width is 0: write the picture's width")
    );
    assert!(told(json!({"lens": {"model": "orthographic", "k": [0, 0, 0, 0]}})).contains("has no k"));
}
