//! Rates of tracing primary and shadow rays on a neutral scene, on one thread, and what hierarchies cost to build:
//! `cargo bench -p endless_render --bench traversal`.

mod street;

use divan::Bencher;
use divan::counter::ItemsCount;
use endless_render::{Blas, Ray, RayStream, Tlas};
use endless_scene::Mesh;
use endless_world::{ImageSize, PinholeCamera};
use glam::{Affine3A, Vec3A};
use std::sync::{Arc, LazyLock};

const SIZE: ImageSize = ImageSize { width: 320, height: 180 };

static MESHES: LazyLock<Vec<(Mesh, Vec<Affine3A>)>> = LazyLock::new(street::meshes);
static PLACED: LazyLock<Vec<(Arc<Blas>, Affine3A)>> = LazyLock::new(|| {
    let placed = |(mesh, places): &(Mesh, Vec<Affine3A>)| {
        let blas = Arc::new(Blas::build(&mesh.positions, &mesh.triangles));
        places.iter().map(|&place| (Arc::clone(&blas), place)).collect::<Vec<_>>()
    };
    MESHES.iter().flat_map(placed).collect()
});
static ACCEL: LazyLock<Tlas> = LazyLock::new(|| Tlas::build(PLACED.clone()));

/// Rays through 8 by 4 pixels, tile by tile.
static PRIMARY: LazyLock<Vec<[[Ray; 8]; 4]>> = LazyLock::new(|| {
    let camera = PinholeCamera::new(&street::site(), SIZE);
    let ray = |x: u32, y: u32| {
        let direction = Vec3A::from(camera.ray_through(x as f32 + 0.5, y as f32 + 0.5));
        Ray { origin: Vec3A::from(camera.position), direction, tmax: f32::MAX }
    };
    let tiles = (0..SIZE.height / 4).flat_map(|y| (0..SIZE.width / 8).map(move |x| (8 * x, 4 * y)));
    tiles.map(|(x, y)| [0, 1, 2, 3].map(|line| [0, 1, 2, 3, 4, 5, 6, 7].map(|i| ray(x + i, y + line)))).collect()
});

/// Towards the sun from where primary rays end; those that end nowhere start at the camera.
static SHADOW: LazyLock<Vec<[[Ray; 8]; 4]>> = LazyLock::new(|| {
    let direction = Vec3A::new(0.45, 0.3, 0.6).normalize();
    let shadow = |ray: Ray| {
        let t = ACCEL.closest(&ray).map_or(0.0, |hit| hit.t - 2e-3);
        Ray { origin: ray.origin + ray.direction * t, direction, tmax: f32::MAX }
    };
    PRIMARY.iter().map(|rays| rays.map(|line| line.map(shadow))).collect()
});

fn main() {
    divan::main();
}

fn rate(bencher: Bencher<'_, '_>, rays: &[[[Ray; 8]; 4]], trace: impl Fn(&[[Ray; 8]; 4]) -> u32 + Sync) {
    bencher.counter(ItemsCount::new(SIZE.pixels())).bench(|| rays.iter().map(&trace).sum::<u32>());
}

#[divan::bench]
fn closest(bencher: Bencher<'_, '_>) {
    rate(bencher, &PRIMARY, |rays| {
        rays.as_flattened().iter().filter(|ray| ACCEL.closest(ray).is_some()).count() as u32
    });
}

#[divan::bench]
fn closest8(bencher: Bencher<'_, '_>) {
    let hits = |rays: &[Ray; 8]| ACCEL.closest8(rays, u8::MAX).iter().flatten().count() as u32;
    rate(bencher, &PRIMARY, |rays| rays.iter().map(hits).sum());
}

#[divan::bench]
fn closest32(bencher: Bencher<'_, '_>) {
    rate(bencher, &PRIMARY, |rays| {
        let hits = ACCEL.closest32(&RayStream::of(rays), u32::MAX);
        (0..32).filter(|&lane| hits.get(lane).is_some()).count() as u32
    });
}

#[divan::bench]
fn occluded(bencher: Bencher<'_, '_>) {
    rate(bencher, &SHADOW, |rays| rays.as_flattened().iter().filter(|ray| ACCEL.occluded(ray)).count() as u32);
}

#[divan::bench]
fn occluded32(bencher: Bencher<'_, '_>) {
    rate(bencher, &SHADOW, |rays| ACCEL.occluded32(&RayStream::of(rays), u32::MAX).count_ones());
}

#[divan::bench]
fn build_blas(bencher: Bencher<'_, '_>) {
    let (mesh, _) = MESHES.last().expect("a bush");
    bencher.bench(|| Blas::build(&mesh.positions, &mesh.triangles));
}

#[divan::bench]
fn build_tlas(bencher: Bencher<'_, '_>) {
    bencher.with_inputs(|| PLACED.clone()).bench_values(Tlas::build);
}
