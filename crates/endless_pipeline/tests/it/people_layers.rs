//! The layers of people's parts and of shadows in a town agree with the other layers and with keypoints.

use crate::{city::city, fake::options};
use endless_annotate::Visibility;
use endless_dataset::{CameraLayout, DatasetLayout, Layer, RecipeDraft, RgbFormat, check, read_objects, read_rgb};
use endless_pipeline::{SilentProgress, generate, resolve_recipe};
use endless_world::{BodyPart, ClassTag, ImageSize, KEYPOINTS};
use std::collections::BTreeSet;

const SIZE: ImageSize = ImageSize { width: 960, height: 540 };

fn image(camera: &CameraLayout, layer: Layer, frame: u32) -> Vec<[u8; 3]> {
    let path = camera.layer(layer).join(format!("{frame:06}.png"));
    read_rgb(&path, RgbFormat::Png).expect("an image").rgb8().expect("8 bits").data.clone()
}

/// Parts beside which a keypoint lies.
fn parts_beside(keypoint: &str) -> &'static [BodyPart] {
    use BodyPart::{
        Head, LeftFoot, LeftForearm, LeftHand, LeftShin, LeftThigh, LeftUpperArm, RightFoot, RightForearm, RightHand,
        RightShin, RightThigh, RightUpperArm, Torso,
    };
    match keypoint {
        "left_shoulder" => &[LeftUpperArm, Torso],
        "right_shoulder" => &[RightUpperArm, Torso],
        "left_elbow" => &[LeftUpperArm, LeftForearm],
        "right_elbow" => &[RightUpperArm, RightForearm],
        "left_wrist" => &[LeftForearm, LeftHand],
        "right_wrist" => &[RightForearm, RightHand],
        "left_hip" => &[LeftThigh, Torso],
        "right_hip" => &[RightThigh, Torso],
        "left_knee" => &[LeftThigh, LeftShin],
        "right_knee" => &[RightThigh, RightShin],
        "left_ankle" => &[LeftShin, LeftFoot],
        "right_ankle" => &[RightShin, RightFoot],
        _ => &[Head],
    }
}

#[test]
fn parts_are_those_of_people_and_where_their_keypoints_are() {
    let words = |words: &[&str]| Some(words.iter().map(|&word| word.to_owned()).collect());
    let out = tempfile::tempdir().expect("temp");
    let draft = RecipeDraft {
        videos: Some(2),
        maps: words(&["Town10HD", "Town03"]),
        weathers: words(&["clear_sky"]),
        times: words(&["afternoon"]),
        vehicles: Some(120),
        pedestrians: Some(200),
        size: Some(SIZE.to_string()),
        fps: Some(1.0),
        duration: Some(2.0),
        cameras_per_scene: Some(1),
        layers: words(&["depth", "instance", "shadow", "body_parts"]),
        mp4: words(&["body_parts"]),
        ..RecipeDraft::default()
    };
    let recipe = resolve_recipe(draft, city()).expect("a recipe");
    let made = generate(city(), &recipe, out.path(), &options(2), &SilentProgress).expect("a dataset");
    assert_eq!(check(out.path()).expect("a dataset").findings, []);
    let layout = DatasetLayout::new(out.path());
    let (mut seen, mut asked, mut beside) = (BTreeSet::new(), 0, 0);
    let (mut lit, mut dark) = (0, 0);
    for scene in &made.plan.scenes {
        let camera = layout.video(scene).camera(0);
        for line in read_objects(&camera.objects()).expect("lines") {
            let parts = image(&camera, Layer::BodyParts, line.frame);
            let instance = image(&camera, Layer::Instance, line.frame);
            let people = [ClassTag::Pedestrians.value(), ClassTag::Rider.value()];
            for (part, label) in parts.iter().zip(&instance) {
                assert_eq!(part[0] != 0, people.contains(&label[0]), "{part:?} of {label:?}");
                seen.insert(part[0]);
            }
            for shadow in image(&camera, Layer::Shadow, line.frame) {
                lit += usize::from(shadow == [0; 3]);
                dark += usize::from(shadow == [255; 3]);
            }
            for object in &line.objects {
                let Some(keypoints) = &object.keypoints else { continue };
                for (name, keypoint) in KEYPOINTS.iter().zip(&keypoints.0) {
                    if keypoint.visibility != Visibility::Visible {
                        continue;
                    }
                    let [low, high] = object.id.0.to_le_bytes();
                    // A joint lies under skin and cloth: at the edge of a limb, the pixel beside it is the limb's.
                    let reach = 1 + (object.bbox.h / 60) as i64;
                    let near = (-reach..=reach).flat_map(|dy| (-reach..=reach).map(move |dx| (dx, dy)));
                    let found = near
                        .map(|(dx, dy)| (keypoint.x as i64 + dx, keypoint.y as i64 + dy))
                        .filter(|(x, y)| {
                            (0..i64::from(SIZE.width)).contains(x) && (0..i64::from(SIZE.height)).contains(y)
                        })
                        .map(|(x, y)| (y * i64::from(SIZE.width) + x) as usize)
                        .filter(|&i| instance[i][1..] == [low, high])
                        .filter_map(|i| BodyPart::from_value(parts[i][0]))
                        .any(|part| parts_beside(name).contains(&part));
                    asked += 1;
                    beside += u32::from(found);
                }
            }
        }
    }
    println!("{beside} of {asked} keypoints lie at their parts; {lit} pixels are lit, {dark} in the shadow; {seen:?}");
    assert!(asked > 200, "{asked} keypoints");
    assert!(f64::from(beside) > 0.97 * f64::from(asked), "{beside} of {asked}");
    assert!((0..=14).all(|part| seen.contains(&part)), "{seen:?}");
    assert!(lit > 100_000 && dark > 100_000, "{lit} lit, {dark} dark");
}
