//! Boxes: classes, sizes, visibility, distance.

use super::charts::Charts;
use crate::report::format::{decimal, hundredths, percent, whole};
use crate::report::model::{Item, Section, Table};
use crate::{BoxStatistics, CocoStatistics, DatasetStatistics};

/// How many there are of each class.
pub(super) fn boxes(statistics: &DatasetStatistics, charts: &Charts) -> Section {
    let classes = statistics.classes.iter().filter(|(_, boxes)| boxes.boxes > 0);
    let classes: Vec<(&str, &BoxStatistics)> = classes.map(|(class, boxes)| (class.name(), boxes)).collect();
    let all = &statistics.boxes;
    let mut columns = ["class", "boxes", "share", "small", "medium", "large", "mean size, px", "at an edge"].to_vec();
    let world = statistics.world.as_ref();
    if world.is_some() {
        columns.extend(["objects", "mean visibility", "mean distance, m"]);
    }
    let row = |name: &str, boxes: &BoxStatistics, objects: u64| {
        let sizes = boxes.sizes_by_box;
        let mut cells = vec![name.to_owned(), whole(boxes.boxes), percent(boxes.boxes, all.boxes)];
        cells.extend([sizes.small, sizes.medium, sizes.large].map(|size| percent(size, boxes.boxes)));
        cells.extend([decimal(boxes.side_px.mean()), percent(boxes.at_edge, boxes.boxes)]);
        if world.is_some() {
            cells.extend([whole(objects), hundredths(boxes.visibility.mean()), decimal(boxes.distance_m.mean())]);
        }
        cells
    };
    let objects = |name: Option<&str>| {
        let classes = world.iter().flat_map(|world| &world.objects);
        let wanted = classes.filter(|(class, _)| name.is_none_or(|name| class.name() == name));
        wanted.map(|(_, objects)| objects.seen).sum()
    };
    let rows = classes.iter().map(|(name, boxes)| row(name, boxes, objects(Some(name))));
    let table = Table {
        title: "Boxes by class".into(),
        columns: columns.into_iter().map(String::from).collect(),
        rows: rows.chain([row("all", all, objects(None))]).collect(),
        sums: 1,
    };
    let mut items = vec![Item::Table(table)];
    items.extend(charts.of(&["classes", "boxes_per_frame"]));
    let note = "Sizes are those of COCO by the area of the box: small to 32 × 32, medium to 96 × 96 pixels. An object is \
                counted once a video, however many cameras see it.";
    Section { title: "Boxes".into(), note: note.into(), items }
}

/// How large they are, and of what shape.
pub(super) fn sizes(charts: &Charts) -> Section {
    let items = charts.of(&["sizes", "side_px", "side_percent", "aspect_ratio"]).collect();
    let note = "The size of a box is the root of its area: the side of the square that is as large.";
    Section { title: "Sizes and shapes".into(), note: note.into(), items }
}

/// How much of them is seen, from where.
pub(super) fn seen(charts: &Charts) -> Section {
    let items = charts.of(&["visibility", "truncation", "distance_m"]).collect();
    let note = "Visibility is the share of an object's pixels in the picture that nothing hides; truncation the share of its \
                box that lies outside the picture.";
    Section { title: "Visibility and distance".into(), note: note.into(), items }
}

/// What a COCO file has that is not counted.
pub(super) fn coco(coco: &CocoStatistics) -> Section {
    let mapped = coco.categories.iter().map(|(category, class)| vec![category.clone(), class.name().into()]);
    let table = |title: &str, columns: [&str; 2], rows: Vec<Vec<String>>| {
        Item::Table(Table { title: title.into(), columns: columns.map(String::from).to_vec(), rows, sums: 0 })
    };
    let mut others: Vec<_> = coco.other_boxes.iter().collect();
    others.sort_by_key(|(_, boxes)| std::cmp::Reverse(**boxes));
    let mut left_out = vec![
        vec!["around crowds (iscrowd)".to_owned(), whole(coco.crowd_boxes)],
        vec!["without area or picture".to_owned(), whole(coco.broken_boxes)],
    ];
    left_out.extend(others.iter().take(10).map(|(category, boxes)| vec![(*category).clone(), whole(**boxes)]));
    let more: u64 = others.iter().skip(10).map(|(_, boxes)| **boxes).sum();
    if more > 0 {
        left_out.push(vec![format!("{} other categories", others.len() - 10), whole(more)]);
    }
    let items = vec![
        table("Categories that are classes", ["category", "class"], mapped.collect()),
        table("Boxes that are left out", ["category", "boxes"], left_out),
    ];
    Section { title: "The COCO file".into(), note: String::new(), items }
}
