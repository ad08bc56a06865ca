//! Labels are the same whichever layers are stored, and whether a run was resumed.

use crate::fake::{Fake, draft, first_video, make, recipe};
use endless_annotate::Visibility;
use endless_dataset::RecipeDraft;
use endless_dataset::{Layer, read_objects};
use std::fs;

#[test]
fn labels_do_not_depend_on_what_is_stored() {
    let names = ["rgb", "depth", "instance"];
    let mut reference: Option<[Vec<u8>; 2]> = None;
    for subset in (1..8u8).rev() {
        let layers: Vec<String> = (0..3).filter(|i| subset >> i & 1 == 1).map(|i| names[i].to_owned()).collect();
        let recipe = recipe(RecipeDraft { layers: Some(layers.clone()), videos: Some(1), ..draft() });
        let out = tempfile::tempdir().expect("temp");
        make(&Fake::default(), &recipe, out.path(), 2);
        let video = first_video(out.path());
        let labels = || [0, 1].map(|camera| fs::read(video.camera(camera).objects()).expect("labels"));
        let reference = reference.get_or_insert_with(labels);
        assert!(labels() == *reference, "{layers:?}");
        // Some frames and the labels are lost.
        for frame in [2, 9] {
            fs::remove_file(video.camera(1).frame(recipe.layers[0], frame, recipe.rgb_format)).expect("stored");
        }
        fs::remove_file(video.camera(0).objects()).expect("stored");
        let fake = Fake::default();
        make(&fake, &recipe, out.path(), 2);
        assert!(labels() == *reference, "{layers:?}, resumed");
        let lossless = recipe.layers.contains(&Layer::Depth) && recipe.layers.contains(&Layer::Instance);
        assert_eq!(fake.renders.into_inner(), if lossless { 2 } else { 20 }, "{layers:?}");
    }
}

#[test]
fn depth_decides_which_joints_are_hidden() {
    let recipe = recipe(RecipeDraft { layers: Some(vec!["rgb".into()]), videos: Some(1), ..draft() });
    let out = tempfile::tempdir().expect("temp");
    make(&Fake::default(), &recipe, out.path(), 2);
    let lines = read_objects(&first_video(out.path()).camera(0).objects()).expect("labels");
    let keypoints = lines.iter().flat_map(|l| &l.objects).filter_map(|o| o.keypoints);
    let told =
        |v: Visibility| keypoints.clone().any(|k| k.0[0].visibility == v && k.0[1].visibility == Visibility::Hidden);
    assert!(told(Visibility::Visible), "what lies on the body is seen, what lies behind it is not");
}
