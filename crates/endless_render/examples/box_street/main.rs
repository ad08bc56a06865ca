//! A street of 108 boxes on which renderers are compared, from nothing but the renderer's public types: RGB, depth and ids
//! at 1280×720 for a camera that moves, and for one that is fixed while the cars drive. Prints what a frame costs; with a
//! folder, writes pictures there:
//! `cargo run --release -p endless_render --example box_street -- [FOLDER]`.
#![expect(clippy::print_stdout, reason = "it says what it measured")]

use endless_render::{
    CameraBake, Footprint, FrameDescription, FrameScene, Geometry, IndirectLight, Instance, MovingCamera, MovingObject,
    RenderSettings, RigidVelocity, StaticScene,
};
use endless_scene::{Material, MeshBuilder, Surface};
use endless_world::{
    CameraSite, ClassTag, FAR_PLANE_M, ImageSize, InstanceId, LensModel, Mount, PinholeCamera, SceneWeather,
    SensorFrame, TimeOfDay, Weather, math,
};
use glam::{Affine3A, Quat, Vec2, Vec3, Vec3A};
use serde::Deserialize;
use std::{error::Error, f32::consts::FRAC_PI_2, fs::File, path::Path, time::Instant};

/// The scene, and what it is for.
const STREET: &str = include_str!("street.json");

/// Frames of which the median is told.
const FRAMES: u32 = 15;
/// Frames a second.
const FPS: f32 = 30.0;
/// Height of the road, metres.
const ROAD_M: f32 = 0.03;
/// How far the moving camera and the cars come from frame to frame, metres.
const STEP_M: f32 = 0.5;

/// The scene's file.
#[derive(Deserialize)]
struct BoxStreet {
    width: u32,
    height: u32,
    horizontal_fov_deg: f32,
    /// Where the camera is, and what it looks at.
    eye: [f32; 3],
    target: [f32; 3],
    /// Towards the sun.
    light_direction: [f32; 3],
    boxes: Vec<StreetBox>,
}

/// One box.
#[derive(Deserialize)]
struct StreetBox {
    centre: [f32; 3],
    size: [f32; 3],
    /// Counter-clockwise about z, radians.
    yaw: f32,
    /// Linear.
    colour: [f32; 3],
    id: u16,
}

impl StreetBox {
    /// Boxes of this size are the bodies of cars.
    fn is_car_body(&self) -> bool {
        self.size == [1.8, 4.4, 0.8]
    }

    /// Boxes of this size are their cabins: each comes after its body.
    fn is_cabin(&self) -> bool {
        self.size == [1.6, 2.2, 0.6]
    }

    fn is_car(&self) -> bool {
        self.is_car_body() || self.is_cabin()
    }

    fn geometry(&self, class: ClassTag) -> Geometry {
        let half = Vec3::from(self.size) * 0.5;
        let mut builder = MeshBuilder::new();
        builder.cuboid(-half, half, Material::new(Surface::Plastic, self.colour, class));
        Geometry::new(builder.finish())
    }

    /// Where it stands after it has driven so far along the street.
    fn world_from_object(&self, driven_m: f32) -> Affine3A {
        let along = if self.centre[0] > 0.0 { driven_m } else { -driven_m };
        let rotation = Quat::from_rotation_z(self.yaw);
        Affine3A::from_rotation_translation(rotation, Vec3::from(self.centre) + Vec3::Y * along)
    }

    fn class(&self) -> ClassTag {
        match self.id {
            1 => ClassTag::Ground,
            2 => ClassTag::Roads,
            3 | 4 => ClassTag::Sidewalks,
            _ if self.is_car() => ClassTag::Car,
            _ if self.size[0] > 5.0 => ClassTag::Buildings,
            _ if self.size[2] < 3.0 => ClassTag::Pedestrians,
            _ => ClassTag::Poles,
        }
    }

    fn instance(&self, geometry: &Geometry, driven_m: f32) -> Instance {
        Instance::new(geometry, self.world_from_object(driven_m)).with_id(InstanceId(self.id), self.class())
    }
}

/// A car, body and cabin, that has driven so far.
fn car([body, cabin]: [(&StreetBox, &Geometry); 2], driven_m: f32) -> MovingObject {
    let linear_mps = Vec3A::Y * (FPS * STEP_M * body.0.centre[0].signum());
    let velocity = RigidVelocity { linear_mps, ..RigidVelocity::ZERO };
    let instance =
        |(part, geometry): (&StreetBox, &Geometry)| part.instance(geometry, driven_m).with_velocity(velocity);
    let [width, length, height] = body.0.size;
    let top = body.0.centre[2] + 0.5 * height;
    let footprint = Footprint {
        // Forward is along the street, where the box has its y.
        world_from_object: body.0.world_from_object(driven_m)
            * Affine3A::from_rotation_translation(
                Quat::from_rotation_z(FRAC_PI_2),
                Vec3::Z * (ROAD_M - body.0.centre[2]),
            ),
        ahead_m: 0.0,
        half_m: Vec2::new(length, width) * 0.5,
        height_m: top - ROAD_M,
    };
    MovingObject { instances: vec![instance(body), instance(cabin)], footprint }
}

impl BoxStreet {
    /// The camera, so far along the street.
    fn site(&self, driven_m: f32) -> CameraSite {
        let [eye, target] = [self.eye, self.target].map(Vec3::from);
        let forward = target - eye;
        CameraSite {
            name: "street".to_owned(),
            position: (eye + Vec3::Y * driven_m).to_array(),
            yaw_rad: math::atan2(forward.y, forward.x),
            down_tilt_rad: math::atan2(-forward.z, forward.truncate().length()),
            horizontal_fov_rad: self.horizontal_fov_deg.to_radians(),
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        }
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args().nth(1);
    let street: BoxStreet = serde_json::from_str(STREET)?;
    let size = ImageSize { width: street.width, height: street.height };
    let settings = RenderSettings {
        weather: SceneWeather::new(Weather::ClearSky, TimeOfDay::Afternoon, 0).with_sun(street.light_direction.into()),
        ..RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, 0, size)
    };
    let geometry: Vec<Geometry> = street.boxes.iter().map(|b| b.geometry(b.class())).collect();
    let boxes = || street.boxes.iter().zip(&geometry);
    let save = |name: &str, frame: &SensorFrame| match &folder {
        Some(folder) => write(Path::new(folder), name, frame),
        None => Ok(()),
    };

    // A camera that moves: nothing is kept from frame to frame.
    let all = StaticScene::new(boxes().map(|(b, geometry)| b.instance(geometry, 0.0)).collect(), &[]);
    let way: Vec<PinholeCamera> =
        (0..FRAMES).map(|frame| PinholeCamera::new(&street.site(frame as f32 * STEP_M), size)).collect();
    let empty = FrameScene::new(FrameDescription::default());
    for (name, indirect) in [("direct", IndirectLight::OpenSky), ("indirect", IndirectLight::Probes)] {
        let camera = MovingCamera::new(&all, &settings, indirect, &way);
        let cost = median_ms(|frame| camera.render(&all, &empty, &way[frame as usize]));
        println!("camera that moves, {name} light, without cache: {cost:.1} ms a frame");
        save(name, &camera.render(&all, &empty, &way[0]))?;
    }

    // A fixed camera: what stands still is shaded once, the cars drive.
    let standing = boxes().filter(|(b, _)| !b.is_car()).map(|(b, geometry)| b.instance(geometry, 0.0));
    let still = StaticScene::new(standing.collect(), &[]);
    let begin = Instant::now();
    let bake = CameraBake::bake(&still, &settings, &street.site(0.0));
    println!("fixed camera: {:.1} s once", begin.elapsed().as_secs_f64());
    let cars = |frame: u32| {
        let driven = frame as f32 * STEP_M;
        let pairs = boxes().zip(boxes().skip(1)).filter(|((body, _), _)| body.is_car_body());
        let objects = pairs.map(|(body, cabin)| car([body, cabin], driven)).collect();
        FrameScene::new(FrameDescription { frame, objects, ..FrameDescription::default() })
    };
    let cost = median_ms(|_| bake.render(&still, &empty));
    println!("fixed camera, nothing moves: {cost:.1} ms a frame");
    let cost = median_ms(|frame| bake.render(&still, &cars(frame)));
    println!(
        "fixed camera, {} cars drive: {cost:.1} ms a frame, on one thread",
        boxes().filter(|b| b.0.is_car_body()).count()
    );
    save("fixed", &bake.render(&still, &cars(4)))
}

/// The median of what frames take, milliseconds.
fn median_ms(mut render: impl FnMut(u32) -> SensorFrame) -> f64 {
    let mut times: Vec<f64> = (0..FRAMES)
        .map(|frame| {
            let begin = Instant::now();
            std::hint::black_box(render(frame));
            begin.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// Writes a frame's RGB, its depth (black is near, white 200 m) and its ids in colours of their own.
fn write(folder: &Path, name: &str, frame: &SensorFrame) -> Result<(), Box<dyn Error>> {
    let grey = |d: &f32| [(d.min(200.0) / 200.0 * 255.0) as u8; 3];
    let depth = frame.depth.data.iter().map(|d| if *d < FAR_PLANE_M { grey(d) } else { [255; 3] }).collect::<Vec<_>>();
    let color = |id: u16| [37u16, 91, 151].map(|k| (id.wrapping_mul(k) % 223) as u8 + 32);
    let ids = frame.instance.data.iter().map(|p| if p.id.0 == 0 { [0; 3] } else { color(p.id.0) }).collect::<Vec<_>>();
    for (layer, pixels) in [("rgb", &frame.rgb.data), ("depth", &depth), ("ids", &ids)] {
        let file = File::create(folder.join(format!("{name}_{layer}.png")))?;
        let mut encoder = png::Encoder::new(file, frame.rgb.size.width, frame.rgb.size.height);
        encoder.set_color(png::ColorType::Rgb);
        encoder.write_header()?.write_image_data(pixels.as_flattened())?;
    }
    Ok(())
}
