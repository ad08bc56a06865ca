//! The hand-made dataset is counted as by hand.

use crate::hand_made::{HOSTILE, dataset};
use endless_statistics::{Conditions, DatasetStatistics, Filmed, GatherOptions, Represented, Sizes};
use endless_world::{ObjectClass, TimeOfDay, Weather};
use rayon::ThreadPoolBuilder;
use std::{collections::BTreeMap, sync::Mutex};

fn counted(stride: u32) -> DatasetStatistics {
    let folder = dataset();
    let options = GatherOptions { stride, progress: None };
    DatasetStatistics::of_dataset(folder.path(), &options).expect("a dataset")
}

#[test]
fn totals_are_those_of_the_files() {
    let statistics = counted(1);
    let totals = &statistics.totals;
    assert_eq!((totals.videos, totals.sequences, totals.instants, totals.camera_frames), (2, 3, 6, 9));
    assert_eq!((totals.scene_ms, totals.sequence_ms, totals.boxes, totals.empty_frames), (600, 900, 13, 2));
    let per_frame = &totals.boxes_per_frame;
    assert_eq!((per_frame.min(), per_frame.median(), per_frame.max()), (Some(0), Some(2.0), Some(3)));
    assert_eq!(totals.sizes, BTreeMap::from([("100x50".to_owned(), 9)]));
    let set = &statistics.datasets[0];
    assert_eq!((set.max_vehicles, set.max_pedestrians, set.incomplete_videos), (Some(5), Some(2), Some(0)));
}

#[test]
fn figures_9_to_12_count_videos_and_frames_by_their_own_condition() {
    let scenes = counted(1).world.expect("a dataset of ours").scenes;
    assert_eq!(scenes.maps["Town01"], Filmed { videos: 1, camera_frames: 6, boxes: 6 });
    assert_eq!(scenes.maps[HOSTILE], Filmed { videos: 1, camera_frames: 3, boxes: 7 });
    assert_eq!(scenes.weathers[&Weather::Rainy], Filmed { videos: 1, camera_frames: 6, boxes: 6 });
    assert_eq!(scenes.weathers.len(), 5, "also those of which there is nothing");
    // A video that begins in the morning, and one frame of its afternoon.
    assert_eq!(scenes.times[&TimeOfDay::Morning], Filmed { videos: 1, camera_frames: 2, boxes: 4 });
    assert_eq!(scenes.times[&TimeOfDay::Afternoon], Filmed { videos: 0, camera_frames: 1, boxes: 3 });
    let clear = |time_of_day| scenes.conditions[&Conditions { weather: Weather::ClearSky, time_of_day }].camera_frames;
    assert_eq!((scenes.conditions.len(), clear(TimeOfDay::Morning), clear(TimeOfDay::Night)), (15, 2, 0));
    // Cameras of one name on two maps are two views.
    let views: Vec<u64> = scenes.views.values().map(|view| view.filmed.boxes).collect();
    assert_eq!(views, [7, 5, 1]);
    assert_eq!(scenes.events.staged, BTreeMap::from([("near_miss".to_owned(), 2)]));
    assert_eq!(scenes.events.missed, BTreeMap::from([("collision".to_owned(), 2)]));
    assert_eq!(scenes.events.happened, BTreeMap::from([("stop".to_owned(), 2)]));
}

#[test]
fn boxes_are_counted_by_class() {
    let statistics = counted(1);
    let car = &statistics.classes[&ObjectClass::Car];
    // 40 × 30 pixels, and 600 of the object.
    assert_eq!((car.boxes, car.at_edge, car.sizes_by_box.medium, car.sizes_by_pixels.small), (3, 3, 3, 3));
    assert_eq!((car.distance_m.mean(), car.visibility.mean()), (Some(25.0), Some(0.5)));
    assert_eq!(statistics.classes[&ObjectClass::Bus].boxes, 0, "told, though there is none");
    assert_eq!(statistics.boxes.sizes_by_box, Sizes { small: 10, medium: 3, large: 0 });
    assert_eq!(statistics.boxes.aspect_ratio.total(), 13);
    // The walker's middle is at 82 of 100 and 44 of 50: column 26, row 15.
    assert_eq!((statistics.heat_map.counts[15 * 32 + 26], statistics.heat_map.total()), (4, 13));
}

#[test]
fn tracks_have_gaps_and_parked_ones_stand_apart() {
    let world = counted(1).world.expect("a dataset of ours");
    let walkers = &world.tracks[&ObjectClass::Pedestrian];
    assert_eq!((walkers.tracks, walkers.tracks_with_gaps), (3, 1));
    assert_eq!(walkers.frames_seen.iter().collect::<Vec<_>>(), [(1, 2), (2, 1)]);
    assert_eq!(walkers.gap_frames.iter().collect::<Vec<_>>(), [(1, 1)]);
    let cars = &world.tracks[&ObjectClass::Car];
    assert_eq!((cars.tracks, cars.parked_tracks), (0, 1));
    let seen = &world.objects[&ObjectClass::Pedestrian];
    assert_eq!((seen.seen, seen.seen_by_several_cameras), (2, 1));
    let vehicles = &world.motion.vehicles;
    assert_eq!((vehicles.parked, vehicles.standing, vehicles.moving), (3, 0, 3));
    assert_eq!((vehicles.speed_mps.mean(), world.motion.people.speed_mps.mean()), (Some(5.5), Some(1.25)));
}

#[test]
fn people_and_looks_are_those_who_are_seen() {
    let world = counted(1).world.expect("a dataset of ours");
    let people = &world.people;
    assert_eq!(people.all, Represented { objects: 3, boxes: 7 });
    assert_eq!(people.skin_tone[&7], Represented { objects: 2, boxes: 4 });
    assert_eq!((people.skin_tone.len(), people.skin_tone[&1].boxes), (10, 0));
    assert_eq!(people.boxes_by_time_and_skin_tone[&TimeOfDay::Afternoon], BTreeMap::from([(2, 1), (7, 1)]));
    assert_eq!(people.sex["male"], Represented::default());
    // Of two equal cars one is seen, so that it has no twin.
    let parked = &world.looks.parked_vehicles;
    assert_eq!((parked.objects(), parked.distinct(), parked.twins_within_videos()), (1, 1, 0));
    assert_eq!((world.looks.people.objects(), world.looks.people.distinct()), (2, 1));
    assert_eq!(world.looks.people.in_several_videos(), 1);
    // The rider is the same person in other clothes.
    assert_eq!((world.looks.persons.distinct(), world.looks.persons.twins_within_videos()), (1, 2));
    assert_eq!(world.vehicles.color["white"], Represented { objects: 1, boxes: 3 });
}

#[test]
fn of_every_second_frame_the_rest_is_left_out() {
    let statistics = counted(2);
    assert_eq!((statistics.totals.camera_frames, statistics.totals.camera_frames_read), (9, 6));
    assert_eq!((statistics.stride, statistics.totals.boxes), (2, 4 + 1 + 5));
    let world = statistics.world.expect("a dataset of ours");
    let walkers = &world.tracks[&ObjectClass::Pedestrian];
    // Seen in both of the frames that were read: two fifths of a second.
    assert_eq!((walkers.tracks_with_gaps, walkers.frames_seen.max()), (0, Some(2)));
    assert_eq!(world.scenes.events.happened["stop"], 2, "events are not left out");
}

#[test]
fn threads_change_nothing_and_two_datasets_add_up() {
    let folder = dataset();
    let count = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        let seen = Mutex::new(Vec::new());
        let progress = |done, total| seen.lock().expect("no panic").push((done, total));
        let options = GatherOptions { stride: 1, progress: Some(&progress) };
        let counted = pool.install(|| DatasetStatistics::of_dataset(folder.path(), &options)).expect("a dataset");
        let mut seen = seen.into_inner().expect("no panic");
        seen.sort_unstable();
        assert_eq!(seen, [(3, 9), (6, 9), (9, 9)]);
        counted
    };
    let (one, four) = (count(1), count(4));
    let json = |of: &DatasetStatistics| serde_json::to_string(of).expect("plain");
    assert_eq!(json(&one), json(&four));
    let both = one.clone().and(four);
    assert_eq!((both.datasets.len(), both.totals.boxes, both.boxes.boxes), (2, 26, 26));
    let looks = both.world.expect("ours").looks.people;
    assert_eq!((looks.objects(), looks.distinct()), (4, 1), "looks are the same in all datasets");
}
