//! Labels of objects agree with one another in every town and behind every lens, also when a run is resumed.

use crate::{city::city, fake::options};
use endless_annotate::{AmodalBox, FrameObjects, ObjectRecord, mask_pixels};
use endless_dataset::{DatasetLayout, Manifest, RecipeDraft, VideoLayout, check, read_objects};
use endless_pipeline::{MapSource, SilentProgress, generate, resolve_recipe};
use endless_world::{ImageSize, InstanceId};
use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::Path,
};

const SIZE: ImageSize = ImageSize { width: 288, height: 162 };

/// Two frames of two cameras of a town, through some lens; under clouds, as no label depends on light.
fn draft(town: &str) -> RecipeDraft {
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    RecipeDraft {
        videos: Some(1),
        maps: words(&[town]),
        weathers: words(&["cloudy"]),
        times: words(&["afternoon"]),
        vehicles: Some(60),
        pedestrians: Some(60),
        size: Some(SIZE.to_string()),
        fps: Some(5.0),
        duration: Some(0.4),
        min_pixels: Some(10),
        layers: words(&["depth", "instance"]),
        camera_look: Some("random".into()),
        amodal_masks: Some(true),
        ..RecipeDraft::default()
    }
}

fn make(draft: RecipeDraft, out: &Path) -> VideoLayout {
    let recipe = resolve_recipe(draft, city()).expect("a recipe");
    let made = generate(city(), &recipe, out, &options(2), &SilentProgress).expect("a dataset");
    DatasetLayout::new(out).video(&made.plan.scenes[0])
}

fn lines(video: &VideoLayout, camera: usize) -> Vec<FrameObjects> {
    read_objects(&video.camera(camera).objects()).expect("labels")
}

/// How far an amodal box reaches out of the corners of the box in space, pixels; `None` if these are not all seen.
fn outside(object: &ObjectRecord) -> Option<f64> {
    let corners: Vec<[f64; 2]> = object.spatial.as_ref()?.box3d.corners.into_iter().collect::<Option<_>>()?;
    let AmodalBox { x, y, w, h } = object.amodal.as_ref()?.amodal_bbox;
    // From the middles of the outermost pixels.
    let reach = [[x, x + w - 1], [y, y + h - 1]].map(|ends| ends.map(|pixel| f64::from(pixel) + 0.5));
    let over = reach.iter().enumerate().map(|(axis, [first, last])| {
        let along = || corners.iter().map(|corner| corner[axis]);
        let (low, high) = (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max));
        (low - first).max(last - high)
    });
    over.reduce(f64::max)
}

#[test]
fn boxes_lie_in_one_another_in_every_town() {
    let (mut objects, mut worst, mut hidden) = (0, f64::NEG_INFINITY, 0);
    for town in city().maps() {
        let out = tempfile::tempdir().expect("temp");
        let one_frame = RecipeDraft { cameras_per_scene: Some(1), duration: Some(0.2), ..draft(&town) };
        let video = make(one_frame, out.path());
        // Everything that `endless check` looks at: boxes, shares, masks, places, depths.
        assert_eq!(check(out.path()).expect("readable").findings, [], "{town}");
        for object in lines(&video, 0).iter().flat_map(|line| &line.objects) {
            objects += 1;
            let amodal = object.amodal.as_ref().expect("known shapes");
            let mask = mask_pixels(amodal.amodal_mask.as_deref().expect("asked for"), SIZE).expect("a mask");
            assert_eq!(mask.len(), amodal.amodal_pixels as usize, "{town}: {}", object.id);
            hidden += usize::from(!amodal.occluders.is_empty());
            if let Some(over) = outside(object) {
                assert!(over <= 1.0, "{town}: the amodal box of {} leaves its box in space by {over} px", object.id);
                worst = worst.max(over);
            }
        }
    }
    println!("{objects} objects, {hidden} partly hidden, out of their boxes in space by at most {worst:.2} px");
    assert!(objects > 100 && hidden > 20, "{objects} objects, {hidden} hidden: too few to mean anything");
}

/// Every field that is written is told of in the dataset.
fn fields_are_told_of(out: &Path, written: &[FrameObjects]) {
    let manifest = Manifest::read(&DatasetLayout::new(out).manifest()).expect("a manifest");
    let told: BTreeSet<String> = manifest.labels.object_fields.into_iter().map(|field| field.name).collect();
    let mut names = BTreeSet::new();
    for line in written {
        let line = serde_json::to_value(&line.objects).expect("plain data");
        let objects = line.as_array().expect("objects").iter().filter_map(|object| object.as_object());
        names.extend(objects.flat_map(|object| object.keys().cloned()));
    }
    assert_eq!(names.difference(&told).collect::<Vec<_>>(), Vec::<&String>::new());
    assert!(names.len() > 30, "{names:?}");
}

#[test]
fn cameras_agree_and_a_resumed_run_says_the_same() {
    let out = tempfile::tempdir().expect("temp");
    let video = make(draft("Town03"), out.path());
    let [a, b] = [0, 1].map(|camera| lines(&video, camera));
    fields_are_told_of(out.path(), &[&a[..], &b[..]].concat());
    for (a, b) in a.iter().zip(&b) {
        let known: BTreeMap<InstanceId, &ObjectRecord> = a.objects.iter().map(|object| (object.id, object)).collect();
        assert_eq!(known.len(), a.objects.iter().map(|object| object.id).collect::<BTreeSet<_>>().len());
        for (other, own) in b.objects.iter().filter_map(|other| Some((other, known.get(&other.id)?))) {
            assert_eq!((own.class, own.position, own.velocity_mps), (other.class, other.position, other.velocity_mps));
            let place = |object: &ObjectRecord| {
                let around = &object.spatial.as_ref().expect("known shapes").box3d;
                (around.center, around.size, around.rotation)
            };
            assert_eq!(place(own), place(other), "object {}", own.id);
        }
    }
    // Labels of frames that are there are made of their images, without rendering.
    let files = [0, 1].map(|camera| video.camera(camera).objects());
    let before = files.each_ref().map(|file| fs::read(file).expect("labels"));
    fs::remove_file(video.scene()).expect("complete");
    fs::remove_file(&files[1]).expect("labels");
    make(draft("Town03"), out.path());
    assert!(before == files.each_ref().map(|file| fs::read(file).expect("labels")));
}
