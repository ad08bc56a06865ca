//! All distributions of a dataset.

use crate::{
    BoxStatistics, DatasetStatistics, Distribution, Filmed, HeatMap, Histogram, MotionStatistics, Represented,
    SceneStatistics, Tally, WorldStatistics,
};
use endless_world::ObjectClass;
use std::collections::BTreeMap;

/// All shares that are known of a dataset: those of which nothing was counted are left out.
pub fn distributions(statistics: &DatasetStatistics) -> Vec<Distribution> {
    let mut all = Vec::new();
    if let Some(world) = &statistics.world {
        all.extend(of_scenes(&world.scenes));
    }
    all.extend(of_boxes(statistics));
    if let Some(world) = &statistics.world {
        all.extend(of_world(world));
    }
    all.retain(|distribution| distribution.total() > 0);
    all
}

fn of_scenes(scenes: &SceneStatistics) -> Vec<Distribution> {
    fn videos<K: ToString>(filmed: &BTreeMap<K, Filmed>) -> impl Iterator<Item = (String, u64)> {
        filmed.iter().map(|(name, filmed)| (name.to_string(), filmed.videos))
    }
    let views = scenes.views.iter().map(|(name, view)| (name.clone(), view.filmed.camera_frames));
    let events = |events: &BTreeMap<String, u64>| events.clone().into_iter();
    vec![
        Distribution::of_kinds(["maps", "Maps", "videos", "map"], videos(&scenes.maps)),
        Distribution::of_kinds(["weathers", "Weather", "videos", "weather"], videos(&scenes.weathers)),
        Distribution::of_kinds(["times", "Time of day", "videos", "time of day"], videos(&scenes.times)),
        Distribution::of_kinds(["conditions", "Conditions", "videos", "condition"], videos(&scenes.conditions)),
        Distribution::of_kinds(["views", "Camera views", "camera frames", "view"], views).largest_first(),
        Distribution::of_kinds(["staged", "Staged events", "events", "kind"], events(&scenes.events.staged))
            .largest_first(),
        Distribution::of_kinds(["events", "Events in traffic", "events", "kind"], events(&scenes.events.happened))
            .largest_first(),
    ]
}

fn of_boxes(statistics: &DatasetStatistics) -> Vec<Distribution> {
    let boxes = &statistics.boxes;
    let sizes = |boxes: &BoxStatistics| {
        let sizes = boxes.sizes_by_box;
        [("small", sizes.small), ("medium", sizes.medium), ("large", sizes.large)]
    };
    let classes = statistics.classes.iter().map(|(class, boxes)| (class.name(), boxes.boxes));
    let size_parts = |class: (&ObjectClass, &BoxStatistics)| {
        (class.0.name().to_owned(), sizes(class.1).map(|(_, count)| count).to_vec())
    };
    let quantity = |words: [&'static str; 4], of: fn(&BoxStatistics) -> &Histogram| {
        let parts = statistics.classes.iter().map(|(class, boxes)| (class.name().to_owned(), of(boxes).by_label()));
        Distribution::of_histogram(words, of(boxes)).with_parts(parts)
    };
    let edge = [("at an edge", boxes.at_edge), ("inside", boxes.boxes - boxes.at_edge)];
    vec![
        Distribution::of_kinds(["classes", "Classes", "boxes", "class"], classes),
        boxes_per_frame(&statistics.totals.boxes_per_frame),
        Distribution::of_kinds(["sizes", "Box sizes after COCO", "boxes", "size"], sizes(boxes))
            .in_order()
            .with_parts(statistics.classes.iter().map(size_parts)),
        quantity(["side_px", "Box size", "boxes", "root of the box's area"], |boxes| &boxes.side_px),
        quantity(
            ["side_percent", "Box size in the picture", "boxes", "root of the box's area over the picture's"],
            |boxes| &boxes.side_percent,
        ),
        quantity(["aspect_ratio", "Shape of boxes", "boxes", "width / height"], |boxes| &boxes.aspect_ratio),
        Distribution::of_kinds(["at_edge", "Boxes at the picture's edge", "boxes", "place"], edge),
        places(&statistics.heat_map),
        quantity(["visibility", "Visibility", "boxes", "visible share of the object"], |boxes| &boxes.visibility),
        quantity(["truncation", "Truncation", "boxes", "share of the object's box outside the picture"], |boxes| {
            &boxes.truncation
        }),
        quantity(["distance_m", "Distance", "boxes", "distance from the camera"], |boxes| &boxes.distance_m),
    ]
}

/// Bins that double: 0, 1, 2, 3–4, 5–8, …
fn boxes_per_frame(tally: &Tally) -> Distribution {
    let mut bins = vec![("0".to_owned(), tally.of(0)), ("1".to_owned(), tally.of(1)), ("2".to_owned(), tally.of(2))];
    for power in 1..7 {
        let (low, high) = ((1 << power) + 1, 2 << power);
        let count = tally.iter().filter(|(boxes, _)| (low..=high).contains(boxes)).map(|(_, frames)| frames).sum();
        bins.push((format!("{low}\u{2013}{high}"), count));
    }
    let many = tally.iter().filter(|(boxes, _)| *boxes > 128).map(|(_, frames)| frames).sum();
    bins.push(("> 128".to_owned(), many));
    let words = ["boxes_per_frame", "Boxes in a frame", "camera frames", "boxes in the frame"];
    Distribution { mean: tally.mean(), ..Distribution::of_kinds(words, bins).in_order() }
}

/// Coarser than the heat map, in which few boxes are far from their neighbours by chance.
fn places(map: &HeatMap) -> Distribution {
    let (columns, rows) = (8, 6);
    let mut counts = vec![0; columns * rows];
    for (cell, count) in map.counts.iter().enumerate() {
        let (column, row) = (cell % map.columns * columns / map.columns, cell / map.columns * rows / map.rows);
        counts[row * columns + column] += count;
    }
    let name = |cell: usize| format!("column {} row {}", cell % columns + 1, cell / columns + 1);
    let cells = counts.into_iter().enumerate().map(|(cell, count)| (name(cell), count));
    Distribution::of_kinds(["places", "Places in the picture (8 \u{d7} 6)", "boxes", "place"], cells)
}

fn of_world(world: &WorldStatistics) -> Vec<Distribution> {
    let state = |words, motion: &MotionStatistics| {
        let states = [("parked", motion.parked), ("standing", motion.standing), ("moving", motion.moving)];
        Distribution::of_kinds(words, states)
    };
    let seen = |track: &crate::TrackStatistics| track.seconds_seen.clone();
    let mut tracks: Option<Histogram> = None;
    for of_class in world.tracks.values() {
        use crate::merge::Merge as _;
        tracks.absorb(Some(seen(of_class)));
    }
    let parts = world.tracks.iter().map(|(class, track)| (class.name().to_owned(), seen(track).by_label()));
    let words = ["seconds_seen", "Track lengths", "tracks", "time seen by one camera"];
    let tracks = tracks.map(|all| Distribution::of_histogram(words, &all).with_parts(parts));
    let objects = |words, kinds: &BTreeMap<String, Represented>| {
        let kinds = kinds.iter().map(|(word, number)| (word.clone(), number.objects));
        Distribution::of_kinds(words, kinds).largest_first()
    };
    let people = &world.people;
    let tones = |of: fn(&Represented) -> u64| {
        people.skin_tone.iter().map(move |(tone, number)| (tone.to_string(), of(number))).collect::<Vec<_>>()
    };
    let by_time = people.boxes_by_time_and_skin_tone.iter().map(|(time, boxes)| {
        let of_tone = |tone: &u8| boxes.get(tone).copied().unwrap_or_default();
        (time.to_string(), people.skin_tone.keys().map(of_tone).collect())
    });
    let ages = people.age_groups().map(|(word, number)| (word.to_owned(), number.objects));
    let meets = |words, looks: &crate::LookStatistics| {
        let numbers = looks.looks_by_videos().into_iter().map(|(videos, looks)| (videos.to_string(), looks));
        Distribution::of_kinds(words, numbers.collect::<Vec<_>>()).in_order()
    };
    let motion = &world.motion;
    let others = vec![
        state(["vehicle_states", "What vehicles do", "boxes", "state"], &motion.vehicles),
        Distribution::of_histogram(
            ["vehicle_speed_mps", "Speed of vehicles that move", "boxes", "speed"],
            &motion.vehicles.speed_mps,
        ),
        state(["people_states", "What people do", "boxes", "state"], &motion.people),
        Distribution::of_histogram(
            ["walking_speed_mps", "Speed of people who move", "boxes", "speed"],
            &motion.people.speed_mps,
        ),
        Distribution::of_kinds(["skin_tone", "Skin tones of people", "people", "Monk scale"], tones(|n| n.objects))
            .in_order(),
        Distribution::of_kinds(["skin_tone_boxes", "Skin tones of boxes", "boxes", "Monk scale"], tones(|n| n.boxes))
            .in_order()
            .with_parts(by_time),
        Distribution::of_kinds(["age_group", "Age groups", "people", "age group"], ages).in_order(),
        Distribution::of_histogram(["age_years", "Ages", "people", "age"], &people.age_years),
        objects(["sex", "Sexes", "people", "sex"], &people.sex),
        objects(["color", "Colours of vehicles", "vehicles", "paint"], &world.vehicles.color),
        objects(["subclass", "Kinds of vehicles", "vehicles", "kind"], &world.vehicles.subclass),
        meets(["people_met", "How often a look of people comes back", "looks", "videos"], &world.looks.people),
        meets(["vehicles_met", "How often a look of vehicles comes back", "looks", "videos"], &world.looks.vehicles),
    ];
    tracks.into_iter().chain(others).collect()
}
