//! The report of one dataset.

mod boxes;
mod charts;
mod life;
mod scenes;

use super::format::{decimal, duration, hundredths, percent, whole, whole_or_dash};
use super::model::{HeatMapFigure, Item, Report, Section, Table, Tile};
use crate::{DatasetStatistics, distributions};
use charts::Charts;

/// Heat maps of so many views are shown, those with most boxes.
const VIEWS: usize = 48;

impl Report {
    /// What is told of one dataset.
    pub fn of_dataset(statistics: &DatasetStatistics) -> Self {
        let charts = Charts::new(distributions(statistics));
        let mut sections = vec![overview(statistics)];
        if let Some(world) = &statistics.world {
            sections.push(scenes::conditions(&world.scenes, &charts));
        }
        sections.push(boxes::boxes(statistics, &charts));
        sections.push(boxes::sizes(&charts));
        if statistics.world.is_some() {
            sections.push(boxes::seen(&charts));
        }
        sections.push(heat_maps(statistics));
        if let Some(world) = &statistics.world {
            sections.push(life::tracks(world, &charts));
            sections.push(life::motion(world, &charts));
            sections.push(life::people(world, &charts));
            sections.push(life::vehicles(&charts));
            sections.push(life::looks(&world.looks, &charts));
            sections.push(scenes::events(&world.scenes, &charts));
        }
        if let Some(coco) = &statistics.coco {
            sections.push(boxes::coco(coco));
        }
        sections.retain(|section| !section.items.is_empty());
        Self { title: format!("Statistics of {}", statistics.name()), subtitle: subtitle(statistics), sections }
    }
}

pub(super) fn subtitle(statistics: &DatasetStatistics) -> String {
    let totals = &statistics.totals;
    let frames = format!("{} camera frames, {} boxes", whole(totals.camera_frames), whole(totals.boxes));
    let stride =
        if statistics.stride > 1 { format!(", one frame of {} read", statistics.stride) } else { String::new() };
    match totals.videos {
        0 => format!("{frames}{stride}"),
        videos => format!("{} videos, {frames}{stride}", whole(videos)),
    }
}

fn overview(statistics: &DatasetStatistics) -> Section {
    let totals = &statistics.totals;
    let tile = |name: &str, value: String| Tile { name: name.into(), value };
    let boxes = &totals.boxes_per_frame;
    let mut tiles = Vec::new();
    if let Some(world) = &statistics.world {
        tiles.push(tile("videos", whole(totals.videos)));
        tiles.push(tile("camera views", whole(world.scenes.views.len() as u64)));
    }
    tiles.push(tile("camera frames", whole(totals.camera_frames)));
    if totals.sequence_ms > 0 {
        tiles.push(tile("of all cameras", duration(totals.sequence_ms)));
    }
    tiles.push(tile("boxes", whole(totals.boxes)));
    tiles.push(tile("boxes a frame (median)", decimal(boxes.median())));
    tiles.push(tile("boxes a frame (most)", whole_or_dash(boxes.max())));
    let empty = percent(totals.empty_frames, totals.camera_frames_read);
    tiles.push(tile("frames without a box", empty));
    let names = ["dataset", "videos", "not complete", "camera frames", "boxes", "max vehicles", "max pedestrians"];
    let mut table = Table {
        title: "Datasets (the paper's Table 2)".into(),
        columns: names.map(String::from).to_vec(),
        ..Table::default()
    };
    for set in &statistics.datasets {
        let numbers = [
            set.videos,
            set.incomplete_videos,
            Some(set.camera_frames),
            Some(set.boxes),
            set.max_vehicles,
            set.max_pedestrians,
        ];
        table.rows.push([set.name.clone()].into_iter().chain(numbers.map(whole_or_dash)).collect());
    }
    if statistics.datasets.len() > 1 {
        let sum = |of: fn(&crate::Miniset) -> Option<u64>| -> String {
            whole(statistics.datasets.iter().filter_map(of).sum())
        };
        let sums = [sum(|s| s.videos), sum(|s| s.incomplete_videos), whole(totals.camera_frames), whole(totals.boxes)];
        table.rows.push(["total".into()].into_iter().chain(sums).chain([String::new(), String::new()]).collect());
        table.sums = 1;
    }
    let mut pictures =
        Table { title: "Pictures".into(), columns: ["", ""].map(String::from).to_vec(), ..Table::default() };
    let mut row = |name: &str, value: String| pictures.rows.push(vec![name.into(), value]);
    let list = |numbers: &std::collections::BTreeMap<String, u64>| {
        let mut sorted: Vec<_> = numbers.iter().collect();
        sorted.sort_by_key(|(_, count)| std::cmp::Reverse(**count));
        let more = sorted.len().saturating_sub(4);
        let shown = sorted.iter().take(4).map(|(name, count)| format!("{name} ({})", whole(**count)));
        let more = (more > 0).then(|| format!("{} more", whole(more as u64)));
        shown.chain(more).collect::<Vec<_>>().join(", ")
    };
    row("sizes", list(&totals.sizes));
    if statistics.world.is_some() {
        row("frames a second", list(&totals.fps));
        row("scenes, length", duration(totals.scene_ms));
        row("cameras of videos", whole(totals.sequences));
    }
    row("boxes a frame, mean", hundredths(boxes.mean()));
    row("boxes a frame, least", whole_or_dash(boxes.min()));
    Section {
        title: "Overview".into(),
        note: String::new(),
        items: vec![Item::Tiles(tiles), Item::Table(table), Item::Table(pictures)],
    }
}

fn heat_maps(statistics: &DatasetStatistics) -> Section {
    let figure = |title: String, map: &crate::HeatMap| HeatMapFigure { title, map: map.clone() };
    let mut figures = vec![figure(format!("all: {} boxes", whole(statistics.heat_map.total())), &statistics.heat_map)];
    let mut note = "Where in the picture the middles of boxes lie; each map has its own scale.".to_owned();
    if let Some(world) = &statistics.world {
        let mut views: Vec<_> = world.scenes.views.iter().collect();
        // The sort keeps the order of names among equals.
        views.sort_by_key(|(_, view)| std::cmp::Reverse(view.filmed.boxes));
        if views.len() > VIEWS {
            note += &format!(" The {VIEWS} views with most boxes of {}.", whole(views.len() as u64));
        }
        let title = |name: &str, boxes| format!("{name}: {} boxes", whole(boxes));
        figures.extend(views.iter().take(VIEWS).map(|(name, v)| figure(title(name, v.filmed.boxes), &v.heat_map)));
    }
    Section { title: "Places in the picture".into(), note, items: vec![Item::HeatMaps(figures)] }
}
