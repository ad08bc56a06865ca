//! A scene of boxes: rendered with the cache, without it, and by a camera that moves.

use endless_render::{
    CameraBake, Footprint, FrameDescription, FrameScene, Gathering, Geometry, IndirectHits, IndirectLight, Instance,
    MovingCamera, MovingObject, NeighbourFrames, RenderSettings, RoamingCamera, RoamingLight, StaticScene,
};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{
    CameraSite, ClassTag, ImageSize, InstanceId, LensModel, Mount, PinholeCamera, SceneWeather, SensorFrame,
    SensorLayers, TimeOfDay, Weather,
};
use glam::{Affine3A, Vec2, Vec3};

const SIZE: ImageSize = ImageSize { width: 120, height: 68 };
/// A block that stands.
const STANDING: InstanceId = InstanceId(1);
/// One that moves.
const MOVING: InstanceId = InstanceId(3);

fn cuboid(half: Vec3, surface: Surface, color: [f32; 3], tag: ClassTag) -> Geometry {
    let mut builder = MeshBuilder::new();
    builder.cuboid(
        half * Vec3::new(-1.0, -1.0, 0.0),
        half * Vec3::new(1.0, 1.0, 2.0),
        Material::new(surface, color, tag),
    );
    Geometry::new(builder.finish())
}

fn block() -> Geometry {
    cuboid(Vec3::ONE, Surface::Painted, [0.5, 0.2, 0.1], ClassTag::Static)
}

fn at(x: f32, y: f32) -> Affine3A {
    Affine3A::from_translation(Vec3::new(x, y, 0.0))
}

/// A floor and a block.
fn still() -> StaticScene {
    let floor = cuboid(Vec3::new(60.0, 60.0, 0.05), Surface::Asphalt, [0.14; 3], ClassTag::Roads);
    let floor = Instance::new(&floor, Affine3A::from_translation(Vec3::NEG_Z * 0.1));
    StaticScene::new(vec![floor, Instance::new(&block(), at(14.0, -3.0)).with_id(STANDING, ClassTag::Static)], &[])
}

fn frame(x: f32) -> FrameScene {
    let world_from_object = at(x, 2.0);
    let instances = vec![Instance::new(&block(), world_from_object).with_id(MOVING, ClassTag::Dynamic)];
    let footprint = Footprint { world_from_object, ahead_m: 0.0, half_m: Vec2::ONE, height_m: 2.0 };
    FrameScene::new(FrameDescription {
        objects: vec![MovingObject { instances, footprint }],
        ..FrameDescription::default()
    })
}

fn site() -> CameraSite {
    CameraSite {
        name: "pole".to_owned(),
        position: [0.0, 0.0, 6.0],
        yaw_rad: 0.0,
        down_tilt_rad: 0.35,
        horizontal_fov_rad: 1.1,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
        roll_rad: 0.0,
    }
}

fn camera() -> PinholeCamera {
    PinholeCamera::new(&site(), SIZE)
}

fn settings(weather: Weather) -> RenderSettings {
    RenderSettings {
        gathering: Gathering::Interpolated { rays: 2 },
        keep_irradiance: true,
        layers: SensorLayers::ALL,
        ..RenderSettings::new(weather, TimeOfDay::Afternoon, 3, SIZE)
    }
}

fn pixels_of(id: InstanceId, frame: &SensorFrame) -> Vec<usize> {
    (0..SIZE.pixels()).filter(|&i| frame.instance.data[i].id == id).collect()
}

#[test]
fn the_cache_leaves_nothing_out() {
    for weather in [Weather::ClearSky, Weather::AfterRain] {
        let still = still();
        let bake = CameraBake::bake(&still, &settings(weather), &site());
        for x in [10.0, 16.0] {
            let frame = frame(x);
            let (cached, traced) = (bake.render(&still, &frame), bake.render_uncached(&still, &frame));
            assert!(cached == traced, "{weather}, {x} m");
            assert!(pixels_of(MOVING, &cached).len() > 30);
        }
    }
}

#[test]
fn layers_show_what_is_asked_for_and_change_nothing_else() {
    let (still, frame, settings) = (still(), frame(12.0), settings(Weather::ClearSky));
    let all = CameraBake::bake(&still, &settings, &site()).render(&still, &frame);
    let none = RenderSettings { layers: SensorLayers::default(), ..settings };
    let plain = CameraBake::bake(&still, &none, &site()).render(&still, &frame);
    assert!(plain.normals.is_none() && plain.albedo.is_none());
    assert!(plain.rgb == all.rgb && plain.depth == all.depth && plain.instance == all.instance);
    let (normals, albedo) = (all.normals.expect("asked for"), all.albedo.expect("asked for"));
    // Up and towards the camera, which looks down by 0.35 rad; both blocks turn a side and their tops to it.
    let (sin, cos) = (0.342_898, 0.939_373);
    let code = |n: f32| ((n + 1.0) * 32_767.5).round() as u16;
    let up = [code(0.0), code(-cos), code(-sin)];
    let ahead = [code(0.0), code(sin), code(-cos)];
    let sees = |pixel: [u16; 3], wanted: [u16; 3]| (0..3).all(|axis| pixel[axis].abs_diff(wanted[axis]) <= 1);
    for (i, label) in all.instance.data.iter().enumerate() {
        let (normal, color) = (normals.data[i], albedo.data[i]);
        match (label.tag, label.id) {
            (ClassTag::Sky, _) => assert_eq!((normal, color), ([0; 3], [0; 3])),
            (ClassTag::Roads, _) => assert!(sees(normal, up), "{normal:?}"),
            (_, MOVING) => assert!(color[0] > color[1] && color[1] > color[2], "{color:?} of red-brown paint"),
            _ => {}
        }
    }
    for id in [STANDING, MOVING] {
        let pixels = pixels_of(id, &plain);
        let facing = |wanted| pixels.iter().filter(|&&i| sees(normals.data[i], wanted)).count();
        assert!(facing(up) > 5 && facing(ahead) > 5, "{} up, {} ahead", facing(up), facing(ahead));
    }
}

#[test]
fn a_camera_is_baked_as_well_with_what_another_condition_kept() {
    let still = still();
    let (_, hits) = CameraBake::bake_keeping(&still, &settings(Weather::ClearSky), &site());
    assert!(hits.memory_bytes() > 8 * SIZE.pixels());
    let read = IndirectHits::from_bytes(&hits.to_bytes()).expect("as it was written");
    for (weather, time_of_day) in [(Weather::ClearSky, TimeOfDay::Afternoon), (Weather::AfterRain, TimeOfDay::Night)] {
        let settings =
            RenderSettings { weather: SceneWeather::new(weather, time_of_day, 8), seed: 8, ..settings(weather) };
        let plain = CameraBake::bake(&still, &settings, &site());
        let reusing = CameraBake::bake_reusing(&still, &settings, &site(), &read);
        // What says nothing is traced.
        let strange = IndirectHits::default();
        let frame = frame(12.0);
        assert!(plain.render(&still, &frame) == reusing.render(&still, &frame), "{weather} {time_of_day}");
        let traced = CameraBake::bake_reusing(&still, &settings, &site(), &strange);
        assert!(plain.render(&still, &frame) == traced.render(&still, &frame), "{weather} {time_of_day}");
    }
}

#[test]
fn scenes_are_told_apart_by_what_rays_can_meet() {
    let written = |still: &StaticScene| {
        let mut bytes = Vec::new();
        still.write_geometry(&mut bytes).expect("memory");
        bytes
    };
    let block = block();
    let scene =
        |x: f32| StaticScene::new(vec![Instance::new(&block, at(12.0, 5.0)), Instance::new(&block, at(x, 0.0))], &[]);
    assert_eq!(written(&scene(1.0)), written(&scene(1.0)));
    assert_ne!(written(&scene(1.0)), written(&scene(2.0)));
    assert_ne!(written(&still()), written(&scene(1.0)));
}

#[test]
fn a_moving_camera_sees_what_a_fixed_one_sees() {
    let (still, frame) = (still(), frame(12.0));
    // Pixels are rendered by eights: also where some of them lie beyond the picture.
    for (width, height) in [(120, 68), (117, 67)] {
        let size = ImageSize { width, height };
        let camera = PinholeCamera::new(&site(), size);
        let settings = RenderSettings { size, ..settings(Weather::ClearSky) };
        let fixed = CameraBake::bake(&still, &settings, &site()).render(&still, &frame);
        let way = std::slice::from_ref(&camera);
        for (indirect, most) in [(IndirectLight::OpenSky, 6.0), (IndirectLight::Probes, 2.0)] {
            let moving = MovingCamera::new(&still, &settings, indirect, way).render(&still, &frame, &camera);
            assert_eq!(moving.instance, fixed.instance);
            assert_eq!(moving.depth, fixed.depth);
            let channels = moving.rgb.data.as_flattened().iter().zip(fixed.rgb.data.as_flattened());
            let apart: f64 = channels.map(|(&a, &b)| f64::from(a.abs_diff(b))).sum();
            let mean = apart / (3 * size.pixels()) as f64;
            assert!(mean < most, "{indirect:?}: {mean:.2} levels apart");
        }
    }
}

/// At night light spreads over the whole picture, and rain falls in front of it: none of it is that of a frame before.
#[test]
fn a_moving_camera_sees_nothing_of_where_it_was() {
    let (still, frame) = (still(), frame(12.0));
    let here = camera();
    let there = PinholeCamera { position: here.position + Vec3::new(3.0, 1.0, 0.0), ..here.clone() };
    for (weather, time) in [(Weather::Rainy, TimeOfDay::Afternoon), (Weather::ClearSky, TimeOfDay::Night)] {
        let settings = RenderSettings { weather: SceneWeather::new(weather, time, 5), ..settings(weather) };
        let camera = || MovingCamera::new(&still, &settings, IndirectLight::OpenSky, &[here.clone(), there.clone()]);
        let (goes, comes) = (camera(), camera());
        goes.render(&still, &frame, &here);
        assert_eq!(
            goes.render(&still, &frame, &there).rgb,
            comes.render(&still, &frame, &there).rgb,
            "{weather} {time}"
        );
    }
}

/// A camera that goes anywhere sees what one sees that knew its way, and finds the same light when it comes back.
#[test]
fn a_roaming_camera_sees_what_a_moving_one_sees() {
    let (still, frame, settings) = (still(), frame(12.0), settings(Weather::ClearSky));
    let here = camera();
    let render = |light: &mut RoamingLight, camera: &PinholeCamera| {
        let around = light.around(&still, camera.position);
        RoamingCamera::new(&settings).render(&still, &frame, &around, camera, NeighbourFrames::default(), 0.05)
    };
    let light = || RoamingLight::new(&still, &settings, 0.0);
    let seen = render(&mut light(), &here);
    let known = MovingCamera::new(&still, &settings, IndirectLight::Probes, std::slice::from_ref(&here));
    let known = known.render(&still, &frame, &here);
    assert_eq!((&seen.instance, &seen.depth), (&known.instance, &known.depth));
    let channels = seen.rgb.data.as_flattened().iter().zip(known.rgb.data.as_flattened());
    let apart: f64 = channels.map(|(&a, &b)| f64::from(a.abs_diff(b))).sum();
    let mean = apart / (3 * SIZE.pixels()) as f64;
    assert!(mean < 2.0, "{mean:.2} levels apart");
    // Away, and back again.
    let mut roaming = light();
    render(&mut roaming, &here);
    let away = PinholeCamera { position: here.position + Vec3::new(40.0, 0.0, 0.0), ..here.clone() };
    render(&mut roaming, &away);
    assert_eq!(render(&mut roaming, &here).rgb, seen.rgb);
}

#[test]
fn the_sun_stands_where_it_is_told_to() {
    let (still, nothing) = (still(), FrameScene::new(FrameDescription::default()));
    let seen = |sun_direction| {
        let settings = settings(Weather::ClearSky);
        let settings = RenderSettings { weather: settings.weather.with_sun(Vec3::from(sun_direction)), ..settings };
        MovingCamera::new(&still, &settings, IndirectLight::OpenSky, &[camera()]).render(&still, &nothing, &camera())
    };
    // The block's shadow falls to the other side: to the right of it in the picture, or to the left.
    let [left, right] = [[0.0, 1.0, 0.7], [0.0, -1.0, 0.7]].map(seen);
    let block = pixels_of(STANDING, &left);
    let (row, width) = (block[block.len() - 1] / SIZE.width as usize, SIZE.width as usize);
    let columns: Vec<usize> = block.iter().filter(|&&i| i / width == row).map(|i| i % width).collect();
    let (before, after) = (row * width + columns[0] - 3, row * width + columns[columns.len() - 1] + 3);
    let light = |frame: &SensorFrame, i: usize| frame.rgb.data[i].map(i32::from).iter().sum::<i32>();
    assert!(light(&left, after) + 40 < light(&left, before));
    assert!(light(&right, before) + 40 < light(&right, after));
}
