//! Models written by `assets export` and read again are the same things, and drive.

use endless_asset::{AssetManifest, Catalogue, ImportedAsset, VehicleModel};
use endless_city::{ActorModels, TownScene};
use endless_interchange::{AssetFolder, MapLibrary, asset_gltf};
use endless_render::{CameraBake, RenderSettings};
use endless_scene::Mesh;
use endless_traffic::{Fleet, Simulation, TrafficSettings};
use endless_world::{
    Actor, Behaviour, CameraLook, CameraSite, Condition, Image, ImageSize, InstanceId, InstancePixel, LensModel,
    Motion, Mount, ObjectClass, Pose, TimeOfDay, VehicleModelId, VehicleMotion, VehicleRef, VehicleSpec, Weather,
    WorldState,
};
use glam::Vec3;
use std::{fs, path::Path};

/// What a manifest says of one of the catalogue's own vehicles.
fn described(spec: &VehicleSpec, file: &str, more: &str) -> String {
    let rider = if spec.ridden {
        "rider = { seat = [0.0, 0.0, 0.8], grip = [0.4, 0.3, 1.0], foot = [0.0, 0.2, 0.3] }"
    } else {
        ""
    };
    format!(
        "[[asset]]\nfile = \"{file}\"\nclass = \"{}\"\nforward = \"+x\"\nsize = [{}, {}, {}]\naxles = [{}, {}]\n{rider}\n{more}\n",
        spec.class, spec.length_m, spec.width_m, spec.height_m, spec.front_axle_m, spec.rear_axle_m,
    )
}

fn apart(a: &Mesh, b: &Mesh) -> f32 {
    let ((a, b), (c, d)) = (a.bounds(), b.bounds());
    (a - c).abs().max((b - d).abs()).max_element()
}

fn again(catalogue: &Catalogue, own: &VehicleModel) -> VehicleModel {
    let bytes = asset_gltf(catalogue, own.name(), 0).expect("it can be written");
    let text = described(&own.spec, "it.glb", "");
    let entry = AssetManifest::parse(&text).expect("a manifest").assets.remove(0);
    match entry.import(&bytes, &|_| None) {
        Ok(ImportedAsset::Vehicle(vehicle)) => vehicle,
        other => panic!("{}: {other:?}", own.name()),
    }
}

#[test]
fn every_vehicle_comes_back_as_it_was() {
    let catalogue = Catalogue::builtin();
    for kind in Catalogue::vehicle_designs() {
        let own = Catalogue::draw_vehicle(kind.name, 0).expect("a design");
        if own.spec.ridden {
            // Riders are written, too, and are not the vehicle's.
            continue;
        }
        let read = again(&catalogue, &own);
        let name = kind.name;
        let sizes = |s: &VehicleSpec| Vec3::new(s.length_m, s.width_m, s.height_m);
        let off = (sizes(&own.spec) - sizes(&read.spec)).abs().max_element();
        assert!(off < 2e-3, "{name}: {:?} is not {:?}", read.spec, own.spec);
        assert!(apart(&own.whole(), &read.whole()) < 2e-3, "{name}");
        // What is drawn comes back as a part of the body.
        let drawn = own.trailer().map_or(0, |t| t.wheels.len());
        assert_eq!(own.wheels().len() + drawn, read.wheels().len(), "{name}");
        assert_eq!(own.headlights().len(), read.headlights().len(), "{name}");
        let near = |a: &[Vec3], b: &[Vec3]| a.iter().all(|p| b.iter().any(|q| p.distance(*q) < 0.4));
        assert!(near(own.headlights(), read.headlights()), "{name}: {:?} {:?}", own.headlights(), read.headlights());
    }
}

/// The instance image of one vehicle on an empty square.
fn seen(catalogue: &Catalogue, model: VehicleModelId, class: ObjectClass) -> Image<InstancePixel> {
    let town = endless_town::Town::default();
    let motion = VehicleMotion { speed_mps: 8.0, rolled_m: 3.0, steer_rad: 0.2, ..VehicleMotion::default() };
    let actor = Actor {
        id: InstanceId(7),
        rider_id: None,
        class,
        asset: VehicleRef { model, variant: 0 }.into(),
        pose: Pose::level(Vec3::new(14.0, 1.0, 0.0), 0.7),
        velocity_mps: Vec3::ZERO,
        motion: Motion::Vehicle(motion),
        behaviour: Behaviour::default(),
        parked: false,
    };
    let site = CameraSite {
        name: "pole".to_owned(),
        position: [0.0, 0.0, 6.0],
        yaw_rad: 0.0,
        down_tilt_rad: 0.4,
        horizontal_fov_rad: 0.7,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    };
    let size = ImageSize { width: 480, height: 270 };
    let settings =
        RenderSettings { look: CameraLook::CLEAN, ..RenderSettings::new(Weather::Cloudy, TimeOfDay::Morning, 0, size) };
    let town_scene = TownScene::load(&town, catalogue).expect("nothing is parked");
    let still = town_scene.static_scene();
    let state = WorldState { frame: 0, time_s: 0.0, actors: vec![actor], signals: Vec::new() };
    let models = ActorModels::new(catalogue, &state.actors);
    CameraBake::bake(still, &settings, &site).render(still, &models.frame_scene(&state)).instance
}

#[test]
fn the_box_of_a_sedan_read_again_is_that_of_the_sedan() {
    let own = Catalogue::draw_vehicle("car.sedan", 0).expect("a design");
    let catalogue = Catalogue::builtin();
    let read = again(&catalogue, &own);
    let place = catalogue.vehicles().iter().position(|v| v.name() == "car.sedan").expect("a sedan");
    let added = catalogue.vehicles().len();
    let catalogue = catalogue.with([ImportedAsset::Vehicle(read)]);
    assert_eq!(catalogue.imported_vehicles().len(), 1);
    let images = [place, added].map(|i| seen(&catalogue, VehicleModelId::from_index(i), ObjectClass::Car));
    let [a, b] = images.each_ref().map(endless_annotate::visible_objects);
    assert_eq!(a.len(), 1);
    assert!(a[0].pixels > 4000);
    assert_eq!(a[0].bbox, b[0].bbox);
    assert!(a[0].pixels.abs_diff(b[0].pixels) < 5, "{} {}", a[0].pixels, b[0].pixels);
}

fn write_folder(folder: &Path) {
    let catalogue = Catalogue::builtin();
    let write = |name: &str, file: &str| {
        let bytes = asset_gltf(&catalogue, name, 0).expect("it can be written");
        fs::write(folder.join(file), bytes).expect("writable");
    };
    write("car.sedan", "sedan.glb");
    write("bench", "bench.glb");
    write("building.cottage", "cottage.glb");
    let sedan = Catalogue::draw_vehicle("car.sedan", 0).expect("a design");
    let mut manifest = described(&sedan.spec, "sedan.glb", "frequency = 100000.0");
    let size = |mesh: &Mesh, forward: &str| {
        let (low, high) = mesh.bounds();
        let d = high - low;
        let [l, w] = if forward == "+x" { [d.x, d.y] } else { [d.y, d.x] };
        format!("forward = \"{forward}\"\nsize = [{l}, {w}, {}]\nshare = 1.0\n", d.z)
    };
    let bench = size(&catalogue.prop(endless_asset::Prop::Bench, 0), "+x");
    let cottage = size(&endless_town::sample_building("cottage", 0).expect("a style"), "+z");
    manifest += &format!("[[asset]]\nfile = \"bench.glb\"\nclass = \"bench\"\n{bench}");
    manifest += &format!("[[asset]]\nfile = \"cottage.glb\"\nclass = \"building\"\n{cottage}");
    fs::write(folder.join("assets.toml"), manifest).expect("writable");
}

#[test]
fn imported_vehicles_drive_and_things_stand_where_their_class_does() {
    let folder = tempfile::tempdir().expect("a folder");
    write_folder(folder.path());
    let read = AssetFolder::read(folder.path(), false).expect("whole");
    assert_eq!(
        read.files.keys().map(String::as_str).collect::<Vec<_>>(),
        ["assets.toml", "bench.glb", "cottage.glb", "sedan.glb"]
    );
    let plain = MapLibrary::builtin();
    let library = MapLibrary::builtin().with_assets(read);
    assert_eq!(library.asset_files().len(), 4);

    let (before, after) = (plain.town("Town07").expect("a town"), library.town("Town07").expect("a town"));
    assert_eq!(before.placements.len(), after.placements.len());
    let benches = |town: &endless_town::Town| {
        let is = |p: &&endless_town::Placement| {
            matches!(p.object, endless_town::PlacedObject::Prop(endless_asset::Prop::Bench, _))
        };
        town.placements.iter().filter(is).count()
    };
    assert!(benches(&before) > 0 && benches(&after) == 0, "{} {}", benches(&before), benches(&after));
    assert_eq!(after.meshes.len(), before.meshes.len() + 2, "a bench and a cottage, each once");
    let changed = before.placements.iter().zip(&after.placements).filter(|(a, b)| a != b);
    let cottages = changed.filter(|(a, _)| matches!(a.object, endless_town::PlacedObject::TownMesh(_))).count();
    assert!(cottages > 0, "no cottage found a lot");

    let condition = Condition::of(Weather::Cloudy, TimeOfDay::Morning).into();
    let specs = library.catalogue().vehicle_specs();
    let fleet = Fleet { vehicles: &specs, pedestrian: &Catalogue::pedestrian_spec };
    let settings = TrafficSettings { vehicles: 12, pedestrians: 0, seed: 3, condition, ..TrafficSettings::default() };
    let mut traffic = Simulation::new(&after.network, &fleet, &after.parked, &settings).expect("few enough");
    let built_in = VehicleModelId::from_index(Catalogue::builtin().vehicles().len());
    let begin = traffic.state();
    let imported = |a: &Actor| a.asset.vehicle().is_some_and(|v| v.model == built_in);
    assert!(!begin.actors.is_empty() && begin.actors.iter().all(imported), "all are imported");
    for _ in 0..30 {
        traffic.tick();
    }
    let later = traffic.state();
    let moved = begin.actors.iter().zip(&later.actors).filter(|(a, b)| a.pose.position.distance(b.pose.position) > 5.0);
    assert!(moved.count() >= 6, "they drive");
}
