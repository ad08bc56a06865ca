//! Datasets side by side, one of them in COCO form.

use crate::hand_made::{dataset, write};
use endless_statistics::{CocoClasses, Comparison, DatasetStatistics, GatherOptions, Report};
use endless_world::ObjectClass;
use serde_json::json;

fn ours() -> DatasetStatistics {
    let folder = dataset();
    DatasetStatistics::of_dataset(folder.path(), &GatherOptions::default()).expect("a dataset")
}

/// Four people and a car, all large, in one of two pictures.
fn coco() -> DatasetStatistics {
    let folder = tempfile::tempdir().expect("temp");
    let path = folder.path().join("instances.json");
    let person = |id: u32| {
        let bbox = [100.0 * f64::from(id), 100.0, 100.0, 200.0];
        json!({"id": id, "image_id": 1, "category_id": 1, "bbox": bbox, "area": 9000.0, "iscrowd": 0})
    };
    let car = json!({"id": 9, "image_id": 1, "category_id": 3, "bbox": [5.0, 5.0, 200.0, 100.0], "area": 15000.0});
    let text = json!({
        "images": [{"id": 1, "width": 640, "height": 480}, {"id": 2, "width": 640, "height": 480}],
        "annotations": [person(1), person(2), person(3), person(4), car],
        "categories": [{"id": 1, "name": "person"}, {"id": 3, "name": "car"}],
    });
    write(&path, &text.to_string());
    DatasetStatistics::of_coco(&path, &CocoClasses::default()).expect("a COCO file")
}

#[test]
fn a_dataset_is_as_itself() {
    let comparison = Comparison::new(vec![ours(), ours()]);
    assert!(comparison.distributions.len() > 25);
    assert!(comparison.distributions.iter().all(|table| table.distance() == 0.0));
    assert_eq!((comparison.hints.len(), comparison.classes_counted_as.len()), (0, 0));
    let text = Report::of_comparison(&comparison).text();
    assert!(text.contains("What is alike") && !text.contains("What differs"));
}

#[test]
fn what_coco_does_not_know_is_left_out_and_riders_are_people() {
    let comparison = Comparison::new(vec![ours(), coco()]);
    assert_eq!(comparison.classes_counted_as[&ObjectClass::Rider], ObjectClass::Pedestrian);
    assert_eq!(comparison.classes_counted_as[&ObjectClass::Van], ObjectClass::Car);
    let keys: Vec<&str> = comparison.distributions.iter().map(|table| table.key.as_str()).collect();
    assert!(keys.contains(&"classes") && keys.contains(&"sizes") && !keys.contains(&"distance_m"), "{keys:?}");
    let classes = comparison.distributions.iter().find(|table| table.key == "classes").expect("compared");
    // 3 cars, 3 bicycles, 7 people of ours; 1 car and 4 people of theirs.
    let share = |side: usize, label: &str| {
        let place = classes.labels.iter().position(|own| own == label).expect("a label");
        classes.shares[side].as_ref().expect("known")[place]
    };
    assert_eq!((share(0, "pedestrian"), share(1, "pedestrian"), share(1, "bicycle")), (7.0 / 13.0, 0.8, 0.0));
    let expected = 0.5 * ((3.0 / 13.0 - 0.2f64).abs() + 3.0 / 13.0 + (7.0 / 13.0 - 0.8f64).abs());
    assert!((classes.distance() - expected).abs() < 1e-12);
    // Most different first.
    assert!(comparison.distributions.is_sorted_by(|a, b| a.distance() >= b.distance()));
    let hints = comparison.hints.join("\n");
    assert!(hints.contains("A has no boxes larger than 96 \u{d7} 96 px; in B they are 100.0% of boxes."), "{hints}");
    assert!(hints.contains("B has 1.7 times as many boxes a frame as A: 2.5 against 1.4."), "{hints}");
}

#[test]
fn two_datasets_are_each_compared_with_the_real_one() {
    let comparison = Comparison::new(vec![ours(), ours(), coco()]);
    let letters: String = comparison.sides.iter().map(|side| side.letter).collect();
    assert_eq!(letters, "ABC");
    let both = |key: &str| comparison.distributions.iter().find(|table| table.key == key).expect("compared");
    assert_eq!((both("sizes").distances.len(), both("sizes").shares.len()), (2, 3));
    assert_eq!(both("sizes").distances[0], both("sizes").distances[1]);
    assert_eq!(both("maps").distances, [None, None], "the real one has no maps to compare with");
    let text = Report::of_comparison(&comparison).text();
    assert!(text.contains("A from C") && text.contains("B from C"));
}

/// `scripts/check_statistics.py --coco` counts this file by pycocotools.
#[test]
fn a_file_as_pycocotools_reads_it_is_counted() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/instances.json");
    let statistics = DatasetStatistics::of_coco(&path, &CocoClasses::default()).expect("a COCO file");
    let totals = &statistics.totals;
    assert_eq!((totals.camera_frames, totals.boxes, totals.empty_frames), (3, 6, 1));
    let boxes: Vec<(&str, u64)> = statistics.classes.iter().map(|(class, of)| (class.name(), of.boxes)).collect();
    let expected = [("car", 1), ("truck", 1), ("bus", 1), ("motorcycle", 0), ("bicycle", 1), ("pedestrian", 2)];
    assert_eq!(boxes, expected);
    // 32 × 32 is medium, 96 × 96 large.
    let sizes = statistics.boxes.sizes_by_box;
    assert_eq!((sizes.small, sizes.medium, sizes.large), (1, 3, 2));
    assert_eq!(statistics.boxes.at_edge, 2, "at the left edge, and within a pixel of the right one");
    let coco = statistics.coco.expect("a COCO file");
    assert_eq!((coco.crowd_boxes, coco.other_boxes.get("cat")), (1, Some(&1)));
}
