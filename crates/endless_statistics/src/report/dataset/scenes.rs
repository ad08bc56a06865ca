//! Maps, conditions, events.

use super::charts::Charts;
use crate::report::format::{percent, whole};
use crate::report::model::{Item, Section, Table};
use crate::{Conditions, Filmed, SceneStatistics};
use endless_world::{TimeOfDay, Weather};
use std::collections::BTreeMap;

/// The paper's Figures 9 to 12.
pub(super) fn conditions(scenes: &SceneStatistics, charts: &Charts) -> Section {
    let mut items: Vec<Item> = charts.of(&["maps", "weathers", "times", "conditions"]).collect();
    for (item, figure) in items.iter_mut().zip(9..) {
        if let Item::Chart(chart) = item {
            chart.title = format!("{} (Figure {figure})", chart.title);
        }
    }
    items.push(Item::Table(matrix(scenes)));
    items.push(Item::Table(filmed("Maps", "map", &scenes.maps)));
    let views = scenes.views.iter().map(|(name, view)| (name.clone(), view.filmed)).collect();
    items.push(Item::Table(filmed("Camera views", "view", &views)));
    let note = "Videos by map, weather and time of day; of a video whose condition changes, the one in which it begins. \
                Frames and boxes are counted by the condition of the frame.";
    Section { title: "Maps and conditions".into(), note: note.into(), items }
}

fn filmed(title: &str, first: &str, of: &BTreeMap<String, Filmed>) -> Table {
    let columns = [first, "videos", "share", "camera frames", "boxes", "boxes a frame"].map(String::from).to_vec();
    let videos = of.values().map(|filmed| filmed.videos).sum();
    let row = |(name, filmed): (&String, &Filmed)| {
        let mean = filmed.boxes as f64 / filmed.camera_frames.max(1) as f64;
        vec![
            name.clone(),
            whole(filmed.videos),
            percent(filmed.videos, videos),
            whole(filmed.camera_frames),
            whole(filmed.boxes),
            format!("{mean:.1}"),
        ]
    };
    Table { title: title.into(), columns, rows: of.iter().map(row).collect(), sums: 0 }
}

/// Weather by time of day.
fn matrix(scenes: &SceneStatistics) -> Table {
    let total: u64 = scenes.conditions.values().map(|filmed| filmed.videos).sum();
    let cell = |videos: u64| format!("{} ({})", whole(videos), percent(videos, total));
    let times = TimeOfDay::ALL.iter().map(|time| time.name().to_owned());
    let row = |weather: &Weather| {
        let of_time = |time: &TimeOfDay| {
            let both = Conditions { weather: *weather, time_of_day: *time };
            cell(scenes.conditions.get(&both).map_or(0, |filmed| filmed.videos))
        };
        let sum = scenes.weathers.get(weather).map_or(0, |filmed| filmed.videos);
        let cells = TimeOfDay::ALL.iter().map(of_time).chain([cell(sum)]);
        [weather.name().to_owned()].into_iter().chain(cells).collect()
    };
    let sums = TimeOfDay::ALL.iter().map(|time| cell(scenes.times.get(time).map_or(0, |filmed| filmed.videos)));
    let last = ["all".to_owned()].into_iter().chain(sums).chain([cell(total)]).collect();
    Table {
        title: "Videos by weather and time of day".into(),
        columns: [String::new()].into_iter().chain(times).chain(["all".to_owned()]).collect(),
        rows: Weather::ALL.iter().map(row).chain([last]).collect(),
        sums: 1,
    }
}

/// Events, staged and others.
pub(super) fn events(scenes: &SceneStatistics, charts: &Charts) -> Section {
    let events = &scenes.events;
    let mut items: Vec<Item> = charts.of(&["staged", "events"]).collect();
    if !events.missed.is_empty() {
        let row = |(kind, count): (&String, &u64)| vec![kind.clone(), whole(*count)];
        let columns = ["kind", "videos"].map(String::from).to_vec();
        let title = "Asked for, but not to be had before the cameras".into();
        items.push(Item::Table(Table { title, columns, rows: events.missed.iter().map(row).collect(), sums: 0 }));
    }
    let note = "Staged events are those of --events. Events in traffic happen in the scene, seen by a camera or not.";
    Section { title: "Events".into(), note: note.into(), items }
}
