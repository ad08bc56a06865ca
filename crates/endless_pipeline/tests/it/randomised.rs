//! Randomised videos: the same scene in other looks, and labels that stay true.

use crate::{
    city::{city, town as shared},
    fake::{assert_same, options},
};
use endless_annotate::{ActorRecord, SceneFrame};
use endless_dataset::{Recipe, RecipeDraft, check, read_actors};
use endless_interchange::MapLibrary;
use endless_pipeline::{
    BakeCache, BuiltinMap, BuiltinSimulator, Plan, SilentProgress, Simulator, generate, resolve_recipe,
};
use endless_world::{
    ClassTag, ImageSize, InstanceId, RandomisedPart, SceneSettings, SensorFrame, SensorLayers, srgb_from_linear,
};
use std::{collections::BTreeMap, fs};

/// One camera of a town, one video.
fn recipe(town: &str, time: &str, parts: &[RandomisedPart], strength: f64) -> Recipe {
    let words = |word: &str| Some(vec![word.to_owned()]);
    let draft = RecipeDraft {
        videos: Some(1),
        maps: words(town),
        weathers: words("clear_sky"),
        times: words(time),
        cameras_per_scene: Some(1),
        vehicles: Some(60),
        pedestrians: Some(60),
        size: Some("160x90".into()),
        fps: Some(5.0),
        duration: Some(0.4),
        min_pixels: Some(10),
        seed: Some(5),
        layers: Some(["rgb", "depth", "instance", "albedo"].map(str::to_owned).to_vec()),
        randomise: Some(parts.iter().map(ToString::to_string).collect()),
        randomise_strength: Some(strength),
        ..RecipeDraft::default()
    };
    resolve_recipe(draft, city()).expect("a recipe")
}

/// What is rendered and told of the first frame of a video.
struct Shown {
    settings: SceneSettings,
    frame: SensorFrame,
    actors: Vec<ActorRecord>,
    scene: SceneFrame,
}

fn shown(map: &BuiltinMap, recipe: &Recipe) -> Shown {
    let plan = Plan::new(recipe, city()).expect("plannable");
    let settings = &plan.scenes[0];
    let layers = SensorLayers { albedo: true, ..SensorLayers::default() };
    let mut session = city().open_session(map, settings, layers).expect("a scene");
    let step = session.tick().expect("a frame");
    let scene = step.task.scene_frame(&step.state).expect("known");
    let frame = step.task.render(&step.state).expect("rendered").remove(0);
    Shown { frame, actors: session.actors().expect("known"), scene, settings: settings.clone() }
}

const LOOKS: [RandomisedPart; 3] = [RandomisedPart::Colours, RandomisedPart::Textures, RandomisedPart::Light];

#[test]
fn looks_leave_geometry_and_ids_alone() {
    let map = shared("Town10HD");
    for time in ["afternoon", "night"] {
        let of = |parts: &[RandomisedPart], strength| shown(map, &recipe("Town10HD", time, parts, strength));
        let usual = of(&[], 0.5);
        let mut choices = vec![&LOOKS[..]];
        if time == "afternoon" {
            let asked_for_nothing = of(&LOOKS, 0.0);
            assert!(usual.frame.rgb.data == asked_for_nothing.frame.rgb.data && usual.settings.randomised.is_none());
            assert_eq!(usual.actors, asked_for_nothing.actors);
            choices.extend([&LOOKS[..1], &LOOKS[1..2], &LOOKS[2..]]);
        }
        for parts in choices {
            let other = of(parts, 0.9);
            assert!(usual.frame.depth.data == other.frame.depth.data, "{parts:?} moves something");
            assert!(usual.frame.instance.data == other.frame.instance.data, "{parts:?} changes ids or classes");
            let pixels = usual.frame.rgb.data.iter().zip(&other.frame.rgb.data);
            let differ = pixels.filter(|(a, b)| a != b).count();
            assert!(differ * 2 > usual.frame.rgb.data.len(), "{parts:?} changes {differ} pixels");
            let lit = parts.contains(&RandomisedPart::Light);
            let same_albedo = usual.frame.albedo == other.frame.albedo;
            assert_eq!(same_albedo, parts == &LOOKS[2..], "{parts:?}: light alone leaves albedo");
            assert_eq!(usual.scene.light.sun != other.scene.light.sun, lit, "{parts:?}: the sun is told");
        }
    }
}

/// In which cars have many pixels.
const LARGE: ImageSize = ImageSize { width: 320, height: 180 };

/// Linear value of 8-bit sRGB.
fn linear(srgb: u8) -> f32 {
    let c = f32::from(srgb) / 255.0;
    if c <= 0.040_45 { c / 12.92 } else { endless_world::math::pow((c + 0.055) / 1.055, 2.4) }
}

/// The albedo that shows of a paint under a share of dust and its clear coat, sRGB.
fn painted(rgb: [u8; 3], dust: f32) -> [u8; 3] {
    let coat = 0.045 * (1.0 - 0.6 * dust);
    let dusty = |k: usize| linear(rgb[k]) * (1.0 - dust) + [0.20, 0.17, 0.14][k] * dust;
    srgb_from_linear([0, 1, 2].map(|k| dusty(k) * (1.0 - coat) + coat))
}

#[test]
fn vehicles_wear_the_paint_that_is_told() {
    let (mut large, mut repainted) = (0, 0);
    for town in ["Town03", "Town10HD"] {
        let map = shared(town);
        let of =
            |parts: &[RandomisedPart]| shown(map, &Recipe { size: LARGE, ..recipe(town, "afternoon", parts, 1.0) });
        let (usual, other) = (of(&[]), of(&[RandomisedPart::Colours]));
        let mut seen: BTreeMap<InstanceId, Vec<[u8; 3]>> = BTreeMap::new();
        let albedo = &other.frame.albedo.as_ref().expect("asked for").data;
        for (pixel, albedo) in other.frame.instance.data.iter().zip(albedo) {
            seen.entry(pixel.id).or_default().push(*albedo);
        }
        for (record, before) in other.actors.iter().zip(&usual.actors) {
            assert!(record.id == before.id && record.reid != before.reid);
            let Some(color) = record.vehicle.as_ref().and_then(|vehicle| vehicle.color) else { continue };
            let Some(pixels) = seen.get(&record.id).filter(|pixels| pixels.len() > 150) else { continue };
            if record.vehicle.as_ref().is_some_and(|vehicle| vehicle.base_type != "car") {
                continue;
            }
            large += 1;
            repainted += usize::from(before.vehicle.as_ref().and_then(|vehicle| vehicle.color) != Some(color));
            let near = |albedo: &&[u8; 3]| {
                (0..12).any(|step| {
                    let expected = painted(color.rgb, 0.02 + 0.035 * step as f32);
                    albedo.iter().zip(expected).all(|(a, b)| a.abs_diff(b) <= 5)
                })
            };
            let told = pixels.iter().filter(near).count();
            assert!(told * 5 > pixels.len(), "{town} {}: {told} of {} are {color:?}", record.id, pixels.len());
        }
    }
    assert!(large >= 4 && repainted + 1 >= large, "{large} cars, {repainted} in other paint: too few to mean anything");
}

#[test]
fn clutter_stands_there_without_ids() {
    let map = shared("Town03");
    let of = |parts: &[RandomisedPart]| shown(map, &recipe("Town03", "afternoon", parts, 1.0));
    let (usual, other) = (of(&[]), of(&[RandomisedPart::Clutter]));
    assert_eq!(usual.actors, other.actors);
    let mut more = 0;
    let pixels = usual.frame.instance.data.iter().zip(&other.frame.instance.data);
    for ((before, now), (near, far)) in pixels.zip(other.frame.depth.data.iter().zip(&usual.frame.depth.data)) {
        if before != now {
            more += 1;
            let stuff = [ClassTag::Static, ClassTag::Dynamic, ClassTag::Vegetation, ClassTag::Terrain];
            assert!(now.id == InstanceId::STUFF && stuff.contains(&now.tag), "{now:?}");
            assert!(near < far, "clutter stands before what was there");
        }
    }
    assert!(more * 400 > usual.frame.rgb.data.len(), "{more} pixels of clutter");
}

#[test]
fn moved_cameras_see_mostly_the_same() {
    for town in ["Town03", "Altstadt"] {
        let map = shared(town);
        let of = |parts: &[RandomisedPart]| shown(map, &recipe(town, "afternoon", parts, 1.0));
        let (usual, moved) = (of(&[]), of(&[RandomisedPart::Camera]));
        assert_eq!(usual.actors, moved.actors, "{town}: the same traffic");
        let [a, b] = [&usual, &moved].map(|shown| &shown.settings.cameras[0].site);
        assert!(a != b && moved.settings.randomised.as_ref().is_some_and(|r| r.usual_cameras == [a.clone()]), "{town}");
        let street = |shown: &Shown| {
            let tags = shown.frame.instance.data.iter().map(|pixel| pixel.tag);
            tags.filter(|tag| matches!(tag, ClassTag::Roads | ClassTag::RoadLines | ClassTag::Sidewalks)).count()
        };
        let (before, now) = (street(&usual), street(&moved));
        assert!(now * 2 > before, "{town}: {now} pixels of street, {before} before");
    }
}

#[test]
fn a_randomised_dataset_is_sound_and_the_same_again() {
    let folders = [(); 2].map(|()| tempfile::tempdir().expect("temp"));
    let one = recipe("Town02", "night", RandomisedPart::ALL, 0.8);
    let recipe = Recipe { videos: 2, ..one };
    let make = |simulator: &BuiltinSimulator, folder: &std::path::Path, threads| {
        generate(simulator, &recipe, folder, &options(threads), &SilentProgress).expect("a dataset")
    };
    let made = make(city(), folders[0].path(), 2);
    assert_eq!(check(folders[0].path()).expect("readable").findings, []);
    let cache = tempfile::tempdir().expect("temp");
    let caching = || {
        let cache = BakeCache::default().in_folder(cache.path(), "one").expect("writable");
        BuiltinSimulator::new(MapLibrary::builtin()).with_bake_cache(cache)
    };
    make(&caching(), folders[1].path(), 1);
    assert_same(folders[0].path(), folders[1].path());
    assert_eq!(fs::read_dir(cache.path()).expect("there").count(), 2, "each video's clutter makes another scene");
    // Some of a video is lost: it comes back, with what the folder keeps.
    let layout = endless_dataset::DatasetLayout::new(folders[1].path());
    let video = layout.video(&made.plan.scenes[1]);
    fs::remove_file(video.scene()).expect("complete");
    fs::remove_file(video.camera(0).frame(recipe.layers[0], 1, recipe.rgb_format)).expect("an image");
    make(&caching(), folders[1].path(), 2);
    assert_same(folders[0].path(), folders[1].path());
    let [a, b] = [0, 1].map(|n| layout.video(&made.plan.scenes[n]));
    assert_ne!(read_actors(&a.actors()).expect("readable"), read_actors(&b.actors()).expect("readable"));
    let randomised = made.plan.scenes.iter().map(|scene| scene.randomised.clone().expect("all are"));
    let light: Vec<_> = randomised.map(|randomised| randomised.light).collect();
    assert!(light[0].is_some() && light[0] != light[1], "each video draws its own");
}
