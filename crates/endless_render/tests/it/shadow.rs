//! The layer of shadows: where a ray to the sun is free, tested with boxes alone.

use endless_render::{
    CameraBake, Footprint, FrameDescription, FrameScene, Geometry, Instance, MovingObject, RenderSettings, StaticScene,
};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{
    CameraLook, CameraSite, ClassTag, ImageSize, InstanceId, LensModel, Mount, PinholeCamera, SceneWeather,
    SensorFrame, SensorLayers, TimeOfDay, Weather, math,
};
use glam::{Affine3A, Vec2, Vec3};

const SIZE: ImageSize = ImageSize { width: 241, height: 135 };
const SEED: u64 = 3;
/// What stands: low and high corner.
const WALL: [Vec3; 2] = [Vec3::new(12.0, -8.0, 0.0), Vec3::new(12.5, -2.0, 3.0)];
/// What moves.
const BLOCK: [Vec3; 2] = [Vec3::new(9.0, 1.0, 0.0), Vec3::new(11.0, 3.0, 2.0)];

fn cuboid([low, high]: [Vec3; 2], tag: ClassTag) -> Instance {
    let mut builder = MeshBuilder::new();
    builder.cuboid(low, high, Material::new(Surface::Concrete, [0.4; 3], tag));
    Instance::new(&Geometry::new(builder.finish()), Affine3A::IDENTITY)
}

fn still() -> StaticScene {
    let floor = [Vec3::new(-60.0, -60.0, -0.1), Vec3::new(60.0, 60.0, 0.0)];
    StaticScene::new(vec![cuboid(floor, ClassTag::Roads), cuboid(WALL, ClassTag::Walls)], &[])
}

fn frame() -> FrameScene {
    let instances = vec![cuboid(BLOCK, ClassTag::Dynamic).with_id(InstanceId(1), ClassTag::Dynamic)];
    let footprint =
        Footprint { world_from_object: Affine3A::IDENTITY, ahead_m: 10.0, half_m: Vec2::ONE, height_m: 2.0 };
    FrameScene::new(FrameDescription {
        objects: vec![MovingObject { instances, footprint }],
        ..FrameDescription::default()
    })
}

fn rendered(weather: Weather, time_of_day: TimeOfDay) -> (PinholeCamera, SensorFrame) {
    let settings = RenderSettings {
        layers: SensorLayers { shadow: true, ..SensorLayers::default() },
        look: CameraLook::CLEAN,
        keep_irradiance: true,
        ..RenderSettings::new(weather, time_of_day, SEED, SIZE)
    };
    let site = CameraSite {
        name: "pole".to_owned(),
        position: [0.0, 0.0, 6.0],
        yaw_rad: 0.0,
        down_tilt_rad: 0.35,
        roll_rad: 0.0,
        horizontal_fov_rad: 1.1,
        lens: LensModel::Pinhole,
        mount: Mount::Pole,
    };
    let still = still();
    let bake = CameraBake::bake(&still, &settings, &site);
    let image = bake.render(&still, &frame());
    assert!(image == bake.render_uncached(&still, &frame()), "{weather} {time_of_day}");
    (bake.camera().clone(), image)
}

/// Whether a ray meets a box that is larger by a margin on all sides.
fn meets(origin: Vec3, direction: Vec3, [low, high]: [Vec3; 2], margin: f32) -> bool {
    let (a, b) = ((low - margin - origin) / direction, (high + margin - origin) / direction);
    let (near, far) = (a.min(b).max_element(), a.max(b).min_element());
    near <= far && far > 0.0
}

#[test]
fn the_mask_says_where_rays_to_the_sun_are_free() {
    for time_of_day in [TimeOfDay::Morning, TimeOfDay::Afternoon] {
        let (camera, image) = rendered(Weather::ClearSky, time_of_day);
        let shadow = image.shadow.as_ref().expect("wanted");
        let drawn = SceneWeather::new(Weather::ClearSky, time_of_day, SEED);
        let (sin, cos) = math::sin_cos(drawn.sun_azimuth_rad);
        let (up, along) = math::sin_cos(drawn.sun_altitude_rad);
        let sun = Vec3::new(cos * along, sin * along, up);
        let (mut dark, mut lit, mut sums) = (0, 0, [(0.0f64, 0u32); 2]);
        for (pixel, (&value, seen)) in shadow.data.iter().zip(&image.instance.data).enumerate() {
            if seen.tag == ClassTag::Sky {
                assert_eq!(value, 0);
                continue;
            }
            let (x, y) = (pixel as u32 % SIZE.width, pixel as u32 / SIZE.width);
            let ray = camera.ray_through(x as f32 + 0.5, y as f32 + 0.5);
            let depth = image.depth.data[pixel] / ray.dot(camera.world_from_camera.z_axis);
            let point = camera.position + ray * depth;
            if seen.tag != ClassTag::Roads {
                continue;
            }
            // The disc is half a degree wide: at its edge a shadow is soft.
            let origin = point + Vec3::Z * 0.01;
            let soft = 0.25;
            if [WALL, BLOCK].iter().any(|solid| meets(origin, sun, *solid, -soft)) {
                assert_eq!(value, 255, "pixel {x}, {y} at {point}, {time_of_day}");
                dark += 1;
            } else if ![WALL, BLOCK].iter().any(|solid| meets(origin, sun, *solid, soft)) {
                assert_eq!(value, 0, "pixel {x}, {y} at {point}, {time_of_day}");
                lit += 1;
            }
            if depth < 25.0 && (value == 0 || value == 255) {
                let (sum, count) = &mut sums[usize::from(value == 255)];
                *sum += f64::from(image.rgb.data[pixel][1]);
                *count += 1;
            }
        }
        assert!(dark > 80 && lit > 4000, "{dark} dark, {lit} lit");
        let [light, shade] = sums.map(|(sum, count)| sum / f64::from(count));
        assert!(shade < 0.7 * light, "{shade} in the shadow, {light} in the light");
        // A block turns some of its sides away from the sun, or all that are seen.
        let own = |i: &usize| image.instance.data[*i].id == InstanceId(1);
        let values: Vec<u8> = (0..SIZE.pixels()).filter(own).map(|i| shadow.data[i]).collect();
        assert!(values.len() > 300 && values.iter().all(|v| [0, 255].contains(v)));
        let top = values.iter().filter(|v| **v == 0).count();
        assert!(top > 50, "{top} pixels of the block's top are lit");
    }
}

#[test]
fn where_no_sun_shines_there_are_no_shadows() {
    for (weather, time_of_day) in [(Weather::Rainy, TimeOfDay::Afternoon), (Weather::ClearSky, TimeOfDay::Night)] {
        let (_, image) = rendered(weather, time_of_day);
        assert!(image.shadow.expect("wanted").data.iter().all(|value| *value == 0), "{weather} {time_of_day}");
    }
}
