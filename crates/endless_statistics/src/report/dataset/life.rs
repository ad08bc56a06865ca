//! Tracks, speeds, people, vehicles, looks.

use super::charts::Charts;
use crate::report::format::{decimal, hundredths, percent, whole, whole_or_dash};
use crate::report::model::{Item, Section, Table};
use crate::{LookStatistics, Looks, MotionStatistics, Represented, TrackStatistics, WorldStatistics};
use endless_world::TimeOfDay;

fn table(title: &str, columns: &[&str], rows: Vec<Vec<String>>) -> Item {
    let columns = columns.iter().map(|name| (*name).to_owned()).collect();
    Item::Table(Table { title: title.into(), columns, rows, sums: 0 })
}

/// How long things are seen.
pub(super) fn tracks(world: &WorldStatistics, charts: &Charts) -> Section {
    let row = |(class, of): (&endless_world::ObjectClass, &TrackStatistics)| {
        let seen = &of.frames_seen;
        vec![
            class.name().to_owned(),
            whole(of.tracks),
            whole_or_dash(seen.min()),
            decimal(seen.median()),
            whole_or_dash(seen.max()),
            hundredths(of.seconds_seen.mean()),
            percent(of.tracks_with_gaps, of.tracks),
            decimal(of.gap_frames.median()),
            whole(of.parked_tracks),
        ]
    };
    let columns =
        ["class", "tracks", "frames, least", "median", "most", "mean, s", "with gaps", "median gap, frames", "parked"];
    let rows: Vec<_> = world.tracks.iter().map(row).collect();
    if rows.is_empty() {
        return Section::default();
    }
    let mut items = vec![table("Tracks by class", &columns, rows)];
    items.extend(charts.of(&["seconds_seen"]));
    let note =
        "A track is one object seen by one camera. What stands parked for the whole video is in the last column only.";
    Section { title: "Tracks".into(), note: note.into(), items }
}

/// How things move.
pub(super) fn motion(world: &WorldStatistics, charts: &Charts) -> Section {
    let row = |name: &str, of: &MotionStatistics| {
        let all = of.parked + of.standing + of.moving;
        let shares = [of.parked, of.standing, of.moving].map(|part| percent(part, all));
        let mean = of.speed_mps.mean();
        let speeds = [hundredths(mean), decimal(mean.map(|mps| 3.6 * mps))];
        [name.to_owned(), whole(all)].into_iter().chain(shares).chain(speeds).collect()
    };
    let columns = ["", "boxes", "parked", "standing", "moving", "mean speed, m/s", "km/h"];
    let rows = vec![row("vehicles", &world.motion.vehicles), row("people", &world.motion.people)];
    let mut items = vec![table("Motion", &columns, rows)];
    items.extend(charts.of(&["vehicle_speed_mps", "walking_speed_mps"]));
    let note = "Box by box. Who is slower than 0.1 m/s stands; speeds are those of who moves.";
    Section { title: "Speeds".into(), note: note.into(), items }
}

/// Who is seen.
pub(super) fn people(world: &WorldStatistics, charts: &Charts) -> Section {
    let people = &world.people;
    if people.all.objects == 0 {
        return Section::default();
    }
    let all = people.all;
    let cells = |name: String, of: Represented| {
        let numbers =
            [whole(of.objects), percent(of.objects, all.objects), whole(of.boxes), percent(of.boxes, all.boxes)];
        [name].into_iter().chain(numbers).collect::<Vec<_>>()
    };
    let tone = |(tone, of): (&u8, &Represented)| {
        let at = |time: &TimeOfDay| {
            let boxes = people.boxes_by_time_and_skin_tone.get(time).and_then(|boxes| boxes.get(tone));
            whole(boxes.copied().unwrap_or_default())
        };
        cells(tone.to_string(), *of).into_iter().chain(TimeOfDay::ALL.iter().map(at)).collect()
    };
    let times = TimeOfDay::ALL.iter().map(|time| format!("boxes, {time}"));
    let columns =
        ["Monk scale", "people", "share", "boxes", "share of boxes"].map(String::from).into_iter().chain(times);
    let tones = Table {
        title: "Skin tones".into(),
        columns: columns.collect(),
        rows: people.skin_tone.iter().map(tone).collect(),
        sums: 0,
    };
    let ages = people.age_groups().map(|(word, of)| cells(word.to_owned(), of));
    let sexes = people.sex.iter().map(|(word, of)| cells(word.clone(), *of));
    let columns = ["", "people", "share", "boxes", "share of boxes"];
    let mut items = vec![Item::Table(tones)];
    items.extend(charts.of(&["skin_tone", "skin_tone_boxes"]));
    items.push(table("Ages and sexes", &columns, ages.chain(sexes).collect()));
    items.extend(charts.of(&["age_years"]));
    let note = format!(
        "{} people and riders who are seen, each once a video, and their {} boxes: whom a model learns from. Skin tones are \
         those of the Monk scale, from 1, the lightest, to 10.",
        whole(all.objects),
        whole(all.boxes)
    );
    Section { title: "People".into(), note, items }
}

/// Which vehicles are seen.
pub(super) fn vehicles(charts: &Charts) -> Section {
    let items = charts.of(&["color", "subclass"]).collect();
    let note = "Vehicles that are seen, each once a video, parked ones included.";
    Section { title: "Vehicles".into(), note: note.into(), items }
}

/// Who comes back.
pub(super) fn looks(looks: &Looks, charts: &Charts) -> Section {
    let row = |(name, of): (&str, &LookStatistics)| {
        let several = of.in_several_videos();
        vec![
            name.to_owned(),
            whole(of.objects()),
            whole(of.distinct()),
            whole(of.twins_within_videos()),
            percent(of.twins_within_videos(), of.objects()),
            whole(several),
            percent(several, of.distinct()),
        ]
    };
    let groups = [
        ("people", &looks.people),
        ("riders", &looks.riders),
        ("vehicles", &looks.vehicles),
        ("parked vehicles", &looks.parked_vehicles),
        ("persons, whatever they wear", &looks.persons),
    ];
    let rows: Vec<_> = groups.into_iter().filter(|(_, of)| of.objects() > 0).map(row).collect();
    if rows.is_empty() {
        return Section::default();
    }
    let columns =
        ["", "objects", "different looks", "twins in a video", "share", "looks in several videos", "share of looks"];
    let mut items = vec![table("Duplicates of look", &columns, rows)];
    items.extend(charts.of(&["people_met", "vehicles_met"]));
    let note = "Objects of one look have one reid. Twins are seen in the same video as another of their look. Parked vehicles \
                belong to a map and come back in all of its videos.";
    Section { title: "Duplicates of look".into(), note: note.into(), items }
}
