//! What frames cost on a neutral scene: of a fixed camera with the cache, by the number of cars that drive, and of a camera
//! that moves: `cargo bench -p endless_render --bench frame`.

mod street;

use divan::Bencher;
use endless_render::{
    CameraBake, FrameDescription, FrameScene, Gathering, Geometry, IndirectLight, MovingCamera, RenderSettings,
    StaticScene,
};
use endless_world::{ImageSize, TimeOfDay, Weather};
use std::sync::LazyLock;

static STILL: LazyLock<StaticScene> = LazyLock::new(street::still);
static CAR: LazyLock<Geometry> = LazyLock::new(street::car);
static BAKE: LazyLock<CameraBake> = LazyLock::new(|| CameraBake::bake(&STILL, &settings(), &street::site()));

fn main() {
    divan::main();
}

fn settings() -> RenderSettings {
    let size = ImageSize { width: 1280, height: 720 };
    RenderSettings {
        gathering: Gathering::Interpolated { rays: 2 },
        ..RenderSettings::new(Weather::ClearSky, TimeOfDay::Afternoon, 0, size)
    }
}

fn frame(cars: u16) -> FrameScene {
    FrameScene::new(FrameDescription { objects: street::cars(&CAR, cars, 3.0), ..FrameDescription::default() })
}

#[divan::bench(args = [0, 5, 20])]
fn fixed_camera(bencher: Bencher<'_, '_>, cars: u16) {
    let frame = frame(cars);
    LazyLock::force(&BAKE);
    bencher.bench(|| BAKE.render(&STILL, &frame));
}

#[divan::bench(args = [IndirectLight::OpenSky, IndirectLight::Probes])]
fn moving_camera(bencher: Bencher<'_, '_>, indirect: IndirectLight) {
    let camera = MovingCamera::new(&STILL, &settings(), indirect, &[street::camera()]);
    let frame = frame(20);
    bencher.bench(|| camera.render(&STILL, &frame, &street::camera()));
}

#[divan::bench(args = [20, 100])]
fn frame_scene(bencher: Bencher<'_, '_>, cars: u16) {
    bencher.bench(|| frame(cars));
}
