//! Counts a detection dataset in COCO form: `images`, `annotations`, `categories`
//! (<https://cocodataset.org/#format-data>). Outlines and masks are passed over unread.

use crate::boxes::SeenBox;
use crate::gather::name_of;
use crate::{BoxStatistics, CocoClasses, CocoStatistics, DatasetStatistics, Miniset, StatisticsError, Tally, Totals};
use endless_world::ObjectClass;
use serde::Deserialize;
use std::{collections::BTreeMap, fs::File, io::BufReader, path::Path};

#[derive(Deserialize)]
struct CocoFile {
    images: Vec<CocoImage>,
    annotations: Vec<CocoAnnotation>,
    categories: Vec<CocoCategory>,
}

#[derive(Deserialize)]
struct CocoImage {
    id: i64,
    width: u32,
    height: u32,
}

#[derive(Deserialize)]
struct CocoAnnotation {
    image_id: i64,
    category_id: i64,
    bbox: [f64; 4],
    #[serde(default)]
    area: Option<f64>,
    #[serde(default)]
    iscrowd: Option<YesOrNo>,
}

/// COCO writes 0 and 1, others words.
#[derive(Deserialize)]
#[serde(untagged)]
enum YesOrNo {
    Number(u8),
    Word(bool),
}

#[derive(Deserialize)]
struct CocoCategory {
    id: i64,
    name: String,
}

impl DatasetStatistics {
    /// Counts a file of detection labels in COCO form. Memory holds 100 bytes a box.
    ///
    /// # Errors
    /// When it cannot be read or is no such file, or has none of our classes.
    pub fn of_coco(path: &Path, classes: &CocoClasses) -> Result<Self, StatisticsError> {
        let refuse = |reason: String| StatisticsError::Coco { reason, path: path.to_owned() };
        let file = File::open(path).map_err(|e| refuse(format!("cannot read: {e}")))?;
        let file: CocoFile = serde_json::from_reader(BufReader::with_capacity(1 << 18, file))
            .map_err(|e| refuse(format!("is not what it should be ({e})")))?;
        count(&file, classes, name_of(path)).map_err(refuse)
    }
}

fn count(file: &CocoFile, classes: &CocoClasses, name: String) -> Result<DatasetStatistics, String> {
    if file.images.is_empty() {
        return Err("lists no images".into());
    }
    if let Some(image) = file.images.iter().find(|image| image.width == 0 || image.height == 0) {
        return Err(format!("image {} has no size", image.id));
    }
    let words: BTreeMap<i64, &str> = file.categories.iter().map(|c| (c.id, c.name.as_str())).collect();
    let mut coco = CocoStatistics::default();
    for category in &file.categories {
        if let Some(class) = classes.class(&category.name) {
            coco.categories.insert(category.name.clone(), class);
        }
    }
    if coco.categories.is_empty() {
        return Err("has no category that is one of our classes (--coco-classes tells which are)".into());
    }
    let of_words = coco.categories.values().map(|class| (*class, BoxStatistics::default()));
    let mut statistics = DatasetStatistics {
        format: DatasetStatistics::FORMAT,
        stride: 1,
        classes: of_words.collect(),
        ..DatasetStatistics::default()
    };
    let mut images: BTreeMap<i64, ([f64; 2], u64)> = BTreeMap::new();
    for image in &file.images {
        if images.insert(image.id, ([image.width.into(), image.height.into()], 0)).is_some() {
            return Err(format!("lists image {} twice", image.id));
        }
        *statistics.totals.sizes.entry(format!("{}x{}", image.width, image.height)).or_default() += 1;
    }
    for annotation in &file.annotations {
        let Some(word) = words.get(&annotation.category_id) else {
            return Err(format!("has a box of category {}, which it does not list", annotation.category_id));
        };
        let of_image = images.get_mut(&annotation.image_id);
        let Some(class) = coco.categories.get(*word).copied() else {
            *coco.other_boxes.entry((*word).to_owned()).or_default() += 1;
            continue;
        };
        if matches!(annotation.iscrowd, Some(YesOrNo::Number(1..) | YesOrNo::Word(true))) {
            coco.crowd_boxes += 1;
            continue;
        }
        match of_image.filter(|_| has_area(annotation.bbox)) {
            Some((picture, boxes)) => {
                *boxes += 1;
                add_box(&mut statistics, class, annotation, *picture);
            }
            None => coco.broken_boxes += 1,
        }
    }
    let mut boxes_per_frame = Tally::default();
    images.values().for_each(|(_, boxes)| boxes_per_frame.add(*boxes));
    let pictures = images.len() as u64;
    let boxes = images.values().map(|(_, boxes)| boxes).sum();
    statistics.totals = Totals {
        camera_frames: pictures,
        camera_frames_read: pictures,
        boxes,
        empty_frames: boxes_per_frame.of(0),
        boxes_per_frame,
        ..statistics.totals
    };
    statistics.datasets = vec![Miniset {
        name,
        videos: None,
        incomplete_videos: None,
        camera_frames: pictures,
        boxes,
        max_vehicles: None,
        max_pedestrians: None,
    }];
    statistics.coco = Some(coco);
    Ok(statistics.finish())
}

fn has_area([x, y, w, h]: [f64; 4]) -> bool {
    [x, y, w, h].iter().all(|number| number.is_finite()) && w > 0.0 && h > 0.0
}

fn add_box(statistics: &mut DatasetStatistics, class: ObjectClass, annotation: &CocoAnnotation, picture: [f64; 2]) {
    let [x, y, w, h] = annotation.bbox;
    // Boxes of people's hand end within a pixel of the edge where objects go on beyond it.
    let at_edge = x < 1.0 || y < 1.0 || x + w > picture[0] - 1.0 || y + h > picture[1] - 1.0;
    let seen = SeenBox {
        bbox: annotation.bbox,
        picture,
        pixels: annotation.area.filter(|area| *area > 0.0),
        at_edge,
        visibility: None,
        truncation: None,
        distance_m: None,
    };
    statistics.classes.entry(class).or_default().add(&seen);
    statistics.heat_map.add(annotation.bbox, picture);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counted(json: &str) -> Result<DatasetStatistics, String> {
        let file: CocoFile = serde_json::from_str(json).map_err(|e| e.to_string())?;
        count(&file, &CocoClasses::default(), "test".into())
    }

    /// Two pictures, a person, a car, a crowd, a toothbrush, a box without width, one of no picture.
    const SMALL: &str = r#"{"info": {"year": 2017}, "images": [{"id": 7, "width": 640, "height": 480, "file_name": "a.jpg"},
        {"id": 8, "width": 500, "height": 375, "file_name": "b.jpg"}],
        "annotations": [
        {"id": 1, "image_id": 7, "category_id": 1, "bbox": [10.5, 20.25, 30.0, 60.0], "area": 900.5, "iscrowd": 0,
         "segmentation": [[10.5, 20.25, 40.5, 20.25, 40.5, 80.25]]},
        {"id": 2, "image_id": 7, "category_id": 3, "bbox": [0, 100, 200, 100], "area": 15000, "iscrowd": 0},
        {"id": 3, "image_id": 7, "category_id": 1, "bbox": [1, 1, 9, 9], "area": 80, "iscrowd": 1,
         "segmentation": {"counts": [5, 3], "size": [480, 640]}},
        {"id": 4, "image_id": 7, "category_id": 90, "bbox": [1, 1, 9, 9], "area": 80, "iscrowd": 0},
        {"id": 5, "image_id": 7, "category_id": 3, "bbox": [1, 1, 0, 9], "area": 0},
        {"id": 6, "image_id": 9, "category_id": 3, "bbox": [1, 1, 9, 9]}],
        "categories": [{"id": 1, "name": "person", "supercategory": "person"}, {"id": 3, "name": "car"},
        {"id": 90, "name": "toothbrush"}]}"#;

    #[test]
    fn only_boxes_of_our_classes_are_counted() {
        let statistics = counted(SMALL).expect("counted");
        assert_eq!((statistics.totals.camera_frames, statistics.totals.boxes), (2, 2));
        assert_eq!((statistics.totals.empty_frames, statistics.totals.boxes_per_frame.max()), (1, Some(2)));
        let person = &statistics.classes[&ObjectClass::Pedestrian];
        assert_eq!(
            (person.boxes, person.at_edge, person.sizes_by_box.medium, person.sizes_by_pixels.small),
            (1, 0, 1, 1)
        );
        let car = &statistics.classes[&ObjectClass::Car];
        assert_eq!((car.boxes, car.at_edge, car.sizes_by_box.large), (1, 1, 1));
        assert!(car.visibility.is_empty() && statistics.world.is_none());
        let coco = statistics.coco.expect("a COCO file");
        assert_eq!((coco.crowd_boxes, coco.broken_boxes), (1, 2));
        assert_eq!(coco.other_boxes, BTreeMap::from([("toothbrush".to_owned(), 1)]));
        assert_eq!(statistics.totals.sizes, BTreeMap::from([("500x375".to_owned(), 1), ("640x480".to_owned(), 1)]));
    }

    #[test]
    fn what_is_no_detection_dataset_is_refused() {
        let refused = |json: &str| counted(json).expect_err(json);
        assert!(refused("{}").contains("images"));
        assert!(refused(r#"{"images": [], "annotations": [], "categories": []}"#).contains("no images"));
        assert!(refused(&SMALL.replace("\"id\": 90", "\"id\": 91")).contains("category 90"));
        assert!(refused(&SMALL.replace("\"id\": 8", "\"id\": 7")).contains("twice"));
        assert!(refused(&SMALL.replace("500", "0")).contains("no size"));
        let only = SMALL.replace("person\", \"super", "cat\", \"super").replace("\"car\"", "\"dog\"");
        assert!(refused(&only).contains("--coco-classes"));
    }
}
