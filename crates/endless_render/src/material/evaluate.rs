//! From materials to BSDFs: what a surface is made of gets its procedural detail, and water where it rains.

use super::pixel_group::{EightPixels, OnePixel};
use super::{Bsdf, building, ground, object, wet, window};
use crate::light::Environment;
use crate::scene::SurfaceInteraction;
use crate::variation::VariedSurface;
use endless_scene::Surface;
use glam::Vec3A;
use wide::f32x8;

/// Fewest of eight pixels for which it pays to find a pattern of all eight together.
const FEWEST_TOGETHER: usize = 3;

/// The BSDF of a point. `footprint_m` is the width of the pixel on the surface; `jitter` is uniform in [0, 1) and
/// differs between the pixel's samples.
pub(crate) fn evaluate_bsdf(
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    footprint_m: f32,
    jitter: f32,
) -> Bsdf {
    let mut bsdf;
    if let Some(variation) = &environment.surfaces {
        let varied = variation.of(point);
        bsdf = dry_bsdf(&varied.point(point), environment, footprint_m * varied.scale());
        bsdf.albedo = varied.albedo(point, bsdf.albedo, footprint_m);
    } else {
        bsdf = dry_bsdf(point, environment, footprint_m);
    }
    let film = || wet::film_look(&OnePixel { point, footprint_m }, environment);
    finish(&mut bsdf, point, environment, film, jitter);
    bsdf
}

/// [`evaluate_bsdf`] of eight points, each with the width of its pixel there and its jitter; to the bit.
pub(crate) fn evaluate_bsdfs(
    points: &[Option<&SurfaceInteraction<'_>>; 8],
    environment: &Environment,
    footprints_m: &[f32; 8],
    jitters: &[f32; 8],
) -> [Option<Bsdf>; 8] {
    let mut bsdfs = [const { None }; 8];
    if let Some(variation) = &environment.surfaces {
        let varied = points.map(|point| point.map(|point| variation.of(point)));
        let places: [Option<SurfaceInteraction<'_>>; 8] =
            std::array::from_fn(|i| Some(varied[i].as_ref()?.point(points[i]?)));
        let scales = varied.each_ref().map(|varied| varied.as_ref().map_or(1.0, VariedSurface::scale));
        let scaled_m = std::array::from_fn(|i| footprints_m[i] * scales[i]);
        dry_bsdfs(&places.each_ref().map(Option::as_ref), environment, &scaled_m, &mut bsdfs);
        for (i, bsdf) in bsdfs.iter_mut().enumerate() {
            if let (Some(bsdf), Some(point), Some(varied)) = (bsdf, points[i], &varied[i]) {
                bsdf.albedo = varied.albedo(point, bsdf.albedo, footprints_m[i]);
            }
        }
    } else {
        dry_bsdfs(points, environment, footprints_m, &mut bsdfs);
    }
    let films = films(points, environment, footprints_m);
    for (i, bsdf) in bsdfs.iter_mut().enumerate() {
        if let (Some(bsdf), Some(point)) = (bsdf, points[i]) {
            finish(bsdf, point, environment, || films.map(|number| number[i]), jitters[i]);
        }
    }
    bsdfs
}

/// What [`wet::film_look`] finds for each of eight points, as far as it is wet and bears a film.
fn films(
    points: &[Option<&SurfaceInteraction<'_>>; 8],
    environment: &Environment,
    footprints_m: &[f32; 8],
) -> [[f32; 8]; 4] {
    let bears_film = |point: &SurfaceInteraction<'_>| wet::bears_film(point.material.surface);
    let wet = points.map(|point| environment.wetness > 0.0 && point.is_some_and(bears_film));
    let mut films = [[0.0; 8]; 4];
    if let Some(pixels) = EightPixels::of(points, footprints_m, &wet) {
        films = wet::film_look(&pixels, environment).map(f32x8::to_array);
    }
    films
}

/// Adds water where it rains, and keeps to what no surface exceeds.
fn finish(
    bsdf: &mut Bsdf,
    point: &SurfaceInteraction<'_>,
    environment: &Environment,
    film: impl FnOnce() -> [f32; 4],
    jitter: f32,
) {
    if environment.wetness > 0.0 {
        wet::wet(bsdf, point, environment, film, jitter);
    }
    bsdf.albedo = bsdf.albedo.clamp(Vec3A::splat(0.004), Vec3A::splat(0.9));
}

/// [`dry_bsdf`] of eight points: those that share a kind of surface are seen together.
fn dry_bsdfs(
    points: &[Option<&SurfaceInteraction<'_>>; 8],
    environment: &Environment,
    footprints_m: &[f32; 8],
    bsdfs: &mut [Option<Bsdf>; 8],
) {
    for first in 0..8 {
        let Some(point) = points[first].filter(|_| bsdfs[first].is_none()) else { continue };
        let surface = point.material.surface;
        let alike: [bool; 8] =
            std::array::from_fn(|i| i >= first && points[i].is_some_and(|point| point.material.surface == surface));
        if alike.iter().filter(|alike| **alike).count() >= FEWEST_TOGETHER {
            let Some(pixels) = EightPixels::of(points, footprints_m, &alike) else { continue };
            if together(&pixels, surface, &alike, bsdfs) {
                continue;
            }
        }
        for i in (first..8).filter(|i| alike[*i]) {
            bsdfs[i] = points[i].map(|point| dry_bsdf(point, environment, footprints_m[i]));
        }
    }
}

/// BSDFs of those wanted of eight pixels that see the same kind of surface; whether this kind has a pattern that is
/// found together.
fn together(pixels: &EightPixels<'_, '_>, surface: Surface, wanted: &[bool; 8], bsdfs: &mut [Option<Bsdf>; 8]) -> bool {
    macro_rules! each {
        ($surface:path, $look:path) => {{
            let look = $look(pixels).map(f32x8::to_array);
            for i in (0..8).filter(|i| wanted[*i]) {
                let point = pixels.points[i];
                let base = Vec3A::from_array(point.material.base_color);
                bsdfs[i] = Some($surface(point, base, look.map(|number| number[i])));
            }
        }};
    }
    match surface {
        Surface::Asphalt => each!(ground::asphalt, ground::asphalt_look),
        Surface::RoadPaint => each!(ground::road_paint, ground::road_paint_look),
        Surface::Paving => each!(ground::stones, ground::paving_look),
        Surface::Cobbles => each!(ground::stones, ground::cobbles_look),
        Surface::Kerb => each!(ground::stones, ground::kerb_look),
        Surface::Concrete => each!(ground::concrete, ground::concrete_look),
        Surface::Grass => each!(ground::grass, ground::grass_look),
        Surface::Soil | Surface::Gravel => each!(ground::loose, ground::loose_look),
        Surface::Brick => each!(building::brick, building::brick_look),
        Surface::Plaster => each!(building::plaster, building::plaster_look),
        Surface::Stone => each!(building::stone, building::stone_look),
        Surface::Cladding => each!(building::cladding, building::cladding_look),
        Surface::FlatRoof => each!(building::flat_roof, building::flat_roof_look),
        _ => return false,
    }
    true
}

/// Of the surface and its detail.
fn dry_bsdf(point: &SurfaceInteraction<'_>, environment: &Environment, footprint_m: f32) -> Bsdf {
    let base = Vec3A::from_array(point.material.base_color);
    let at = OnePixel { point, footprint_m };
    match point.material.surface {
        Surface::Asphalt => ground::asphalt(point, base, ground::asphalt_look(&at)),
        Surface::RoadPaint => ground::road_paint(point, base, ground::road_paint_look(&at)),
        Surface::Paving => ground::stones(point, base, ground::paving_look(&at)),
        Surface::Cobbles => ground::stones(point, base, ground::cobbles_look(&at)),
        Surface::Kerb => ground::stones(point, base, ground::kerb_look(&at)),
        Surface::Concrete => ground::concrete(point, base, ground::concrete_look(&at)),
        Surface::Grass => ground::grass(point, base, ground::grass_look(&at)),
        Surface::Soil | Surface::Gravel => ground::loose(point, base, ground::loose_look(&at)),
        Surface::Brick => building::brick(point, base, building::brick_look(&at)),
        Surface::Plaster => building::plaster(point, base, building::plaster_look(&at)),
        Surface::Stone => building::stone(point, base, building::stone_look(&at)),
        Surface::Cladding => building::cladding(point, base, building::cladding_look(&at)),
        Surface::RoofTile => building::roof_tile(point, base, footprint_m),
        Surface::FlatRoof => building::flat_roof(point, base, building::flat_roof_look(&at)),
        Surface::Wood => building::wood(point, base, footprint_m),
        Surface::WindowGlass => window::window(point, base, environment, false),
        Surface::ShopGlass => window::window(point, base, environment, true),
        Surface::LitSign => object::lit_sign(point, base, environment),
        Surface::CarPaint => object::car_paint(point, base, environment),
        Surface::CarGlass => object::car_glass(point, base, environment),
        Surface::Rubber => Bsdf { roughness: 0.75, specular: 0.035, ..Bsdf::matte(base, point.normal) },
        Surface::Plastic => Bsdf { roughness: 0.45, specular: 0.04, ..Bsdf::matte(base, point.normal) },
        Surface::Metal => object::metal(point, base, 0.35),
        Surface::Chrome => object::metal(point, base, 0.85),
        Surface::Painted => Bsdf::matte(base * object::grime(point), point.normal).coated(0.5, 0.035, 0.35),
        Surface::Cloth | Surface::Hair => Bsdf { roughness: 0.9, specular: 0.02, ..Bsdf::matte(base, point.normal) },
        Surface::Skin => Bsdf { roughness: 0.5, specular: 0.03, ..Bsdf::matte(base, point.normal) },
        Surface::Leather => Bsdf { roughness: 0.45, specular: 0.04, ..Bsdf::matte(base, point.normal) },
        Surface::Bark => object::bark(point, base, footprint_m),
        Surface::Foliage => object::foliage(point, base),
        Surface::Water => Bsdf::matte(base, point.normal).coated(1.0, 0.02, 0.05),
        Surface::Plate => Bsdf::matte(base, point.normal).coated(0.4, 0.04, 0.3),
        Surface::VehicleLight(slot) => object::vehicle_light(point, base, slot, environment),
        // What a lens shows changes with the signal: its light is added frame by frame.
        Surface::SignalLens(_) => Bsdf::matte(base * 0.12, point.normal).coated(0.6, 0.04, 0.2),
        Surface::LampLens => object::lamp_lens(point, base, environment),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Geometry, Instance};
    use crate::settings::RenderSettings;
    use crate::variation::SurfaceVariation;
    use endless_scene::{Material, MeshBuilder};
    use endless_world::{ClassTag, ImageSize, RandomisedPart, SceneRandomisation, TimeOfDay, Weather};
    use glam::{Affine3A, Vec2, Vec3};
    use proptest::prelude::*;
    use std::sync::LazyLock;

    /// Those whose patterns are found together, and two of which each pixel is seen alone.
    const SURFACES: [Surface; 16] = [
        Surface::Asphalt,
        Surface::RoadPaint,
        Surface::Paving,
        Surface::Cobbles,
        Surface::Kerb,
        Surface::Concrete,
        Surface::Grass,
        Surface::Soil,
        Surface::Gravel,
        Surface::Brick,
        Surface::Plaster,
        Surface::Stone,
        Surface::Cladding,
        Surface::FlatRoof,
        Surface::RoofTile,
        Surface::Rubber,
    ];

    /// Dry, raining and drying, each as it is made and as a video varies it.
    static ENVIRONMENTS: LazyLock<Vec<Environment>> = LazyLock::new(|| {
        let parts = [RandomisedPart::Colours, RandomisedPart::Textures];
        let varied = SceneRandomisation::new(&parts, 0.8, TimeOfDay::Afternoon, 7).expect("something varies");
        let mut all = Vec::new();
        for weather in [Weather::ClearSky, Weather::Rainy, Weather::AfterRain] {
            let size = ImageSize { width: 16, height: 9 };
            let plain = Environment::new(&RenderSettings::new(weather, TimeOfDay::Afternoon, 5, size), 0.0);
            all.push(Environment { surfaces: SurfaceVariation::new(&varied), ..plain.clone() });
            all.push(plain);
        }
        all
    });

    static INSTANCE: LazyLock<Instance> = LazyLock::new(|| {
        let mut builder = MeshBuilder::new();
        let material = Material::new(Surface::Concrete, [0.4; 3], ClassTag::Ground);
        builder.cuboid(Vec3::splat(-1.0), Vec3::ONE, material);
        Instance::new(&Geometry::new(builder.finish()), Affine3A::IDENTITY)
    });

    fn point_at(material: &Material, position: Vec3A, uv: Vec2, normal: Vec3A) -> SurfaceInteraction<'_> {
        SurfaceInteraction {
            instance: &INSTANCE,
            triangle: 0,
            material,
            position,
            geometric_normal: if normal.z > 0.9 { Vec3A::Z } else { normal },
            normal,
            object_position: position,
            uv,
            distance: 10.0,
            direction: -normal,
            ambient_occlusion: 1.0,
            from_behind: false,
        }
    }

    /// Every bit of a BSDF.
    fn bits(bsdf: &Bsdf) -> Vec<u32> {
        let vectors = [bsdf.albedo, bsdf.normal, bsdf.coat_f0, bsdf.coat_normal, bsdf.emission];
        let numbers = [bsdf.roughness, bsdf.specular, bsdf.coat, bsdf.coat_roughness, bsdf.translucency];
        vectors.iter().flat_map(Vec3A::to_array).chain(numbers).map(f32::to_bits).collect()
    }

    /// Eight pixels: the middle, the width of a pixel, then of each which of two surfaces it sees, its place and its normal.
    /// A material, position, texture coordinates and normal of each of eight pixels.
    type Pixels = Vec<(Material, Vec3A, Vec2, Vec3A)>;

    /// With the widths of the pixels.
    fn pixels() -> impl Strategy<Value = (Pixels, [f32; 8])> {
        let surfaces = (prop::array::uniform2(0..SURFACES.len()), 0.0f32..1.0, any::<bool>());
        let middle = (-300f32..300.0, -300f32..300.0, 0f32..6.0, -3f32..3.0);
        let pixel = (0.0f32..1.0, -4f32..4.0, -4f32..4.0, -1f32..1.0, -1f32..1.0, 0.5f32..1.5);
        (surfaces, middle, -7.5f32..1.2, prop::collection::vec(pixel, 8)).prop_map(
            |((surfaces, share, ground), (x, y, z, along), finest, pixels)| {
                let footprint = endless_world::math::exp(finest);
                let tag = if ground { ClassTag::Ground } else { ClassTag::Static };
                let all = pixels.iter().map(|(which, dx, dy, nx, ny, _)| {
                    let material = Material::new(
                        SURFACES[surfaces[usize::from(*which > share)]],
                        [0.3, 0.25 + 0.1 * which, 0.2],
                        tag,
                    );
                    let aside = Vec2::new(*dx, *dy) * footprint;
                    let position = Vec3A::new(x + aside.x, y + aside.y, z * which);
                    let uv = Vec2::new(along * 20.0, along) + aside;
                    (material, position, uv, Vec3A::new(*nx, *ny, if ground { 3.0 } else { 0.3 }).normalize())
                });
                let footprints = std::array::from_fn(|i| footprint * pixels[i].5);
                (all.collect(), footprints)
            },
        )
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]
        #[test]
        fn eight_pixels_look_as_one_after_another(
            (seen, footprints_m) in pixels(), there in any::<u8>(), which in 0..6usize, jitters in prop::array::uniform8(0f32..1.0),
        ) {
            let environment = &ENVIRONMENTS[which];
            let points: Vec<_> = seen.iter().map(|(material, p, uv, normal)| point_at(material, *p, *uv, *normal)).collect();
            let eight = std::array::from_fn(|i| (there >> i & 1 == 1).then_some(&points[i]));
            let bsdfs = evaluate_bsdfs(&eight, environment, &footprints_m, &jitters);
            for i in 0..8 {
                let expected = eight[i].map(|point| evaluate_bsdf(point, environment, footprints_m[i], jitters[i]));
                prop_assert_eq!(bsdfs[i].as_ref().map(bits), expected.as_ref().map(bits));
            }
        }
    }
}
