//! Counts one video: its scene, its cameras one by one, and whom they see.

use crate::camera_count::{CameraCount, SeenObject};
use crate::label_line::{ActorFile, CameraFile, FrameLine, SceneFile, SceneLine, Spawned};
use crate::line_reader::each_line;
use crate::merge::Merge as _;
use crate::people::{self, Represented};
use crate::{BoxStatistics, Conditions, DatasetStatistics, Filmed, PeopleStatistics, StatisticsError, WorldStatistics};
use endless_dataset::{
    CameraLayout, DatasetError, DatasetLayout, ModelSpec, Recipe, VideoEntry, VideoLayout, read_json,
};
use endless_world::{ObjectClass, Reid};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// What is counted of one video.
pub(crate) struct VideoCount {
    pub(crate) statistics: DatasetStatistics,
    pub(crate) spawned: Spawned,
}

/// Counts a complete video, one frame of `stride`; `progress` is told of camera frames.
pub(crate) fn count_video(
    layout: &DatasetLayout,
    recipe: &Recipe,
    entry: &VideoEntry,
    stride: u32,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<VideoCount, StatisticsError> {
    let video = layout.video_named(&entry.name);
    let scene: SceneFile = read_json(&video.scene())?;
    if !(scene.fps.is_finite() && scene.fps > 0.0) {
        return Err(DatasetError::malformed(video.scene(), "has no frames a second").into());
    }
    let begins = Conditions { weather: entry.weather, time_of_day: entry.time_of_day };
    let mut world = WorldStatistics::default();
    let changes = read_frames(&video, entry, begins, &mut world)?;
    let cameras = cameras(&video, recipe, entry);
    let counted: Vec<Result<(String, CameraFile, CameraCount, u64), DatasetError>> = cameras
        .into_par_iter()
        .map(|(view, files)| {
            let camera = read_camera(&files)?;
            let mut count = CameraCount::new(camera.size.width, camera.size.height);
            let lines = each_line(&files.objects(), stride.into(), |_, line| {
                let frame: FrameLine = serde_json::from_slice(line).map_err(|e| e.to_string())?;
                count.add(&frame, changes.get(&frame.frame).copied().unwrap_or(begins))
            })?;
            progress(lines);
            Ok((view, camera, count, lines))
        })
        .collect();

    let mut statistics = DatasetStatistics { stride, ..DatasetStatistics::default() };
    let mut seen: BTreeMap<u32, (SeenObject, u64)> = BTreeMap::new();
    for camera in counted {
        let (view, camera, count, lines) = camera?;
        add_camera(&mut statistics, &mut world, &view, &camera, &count, lines);
        add_seen(&mut seen, count.objects);
    }
    let totals = &mut statistics.totals;
    totals.videos = 1;
    totals.instants = entry.frames.into();
    totals.scene_ms = milliseconds(totals.instants, scene.fps);
    let once = Filmed { videos: 1, ..Filmed::default() };
    world.scenes.add(begins, once);
    let all = Filmed { camera_frames: totals.camera_frames_read, boxes: totals.boxes, ..once };
    world.scenes.maps.entry(entry.map.clone()).or_default().absorb(all);
    add_events(&mut world, &scene);
    add_actors(&mut world, &video, &seen)?;
    statistics.world = Some(world);
    Ok(VideoCount { statistics, spawned: scene.spawned })
}

/// The cameras that label what they see: those of the scene, then those of the rig; with the name of each one's view.
fn cameras(video: &VideoLayout, recipe: &Recipe, entry: &VideoEntry) -> Vec<(String, CameraLayout)> {
    let view = |name: &str| format!("{}/{name}", entry.map);
    let most = endless_dataset::MAX_CAMERAS as usize;
    let of_scene = entry.cameras.iter().take(most).zip(video.cameras(entry.cameras.len().min(most)));
    let of_rig = recipe.sensor.iter().filter(|sensor| matches!(sensor.model, ModelSpec::Camera(_)));
    of_scene
        .map(|(name, files)| (view(name), files))
        .chain(of_rig.map(|sensor| (view(&sensor.name), video.sensor(&sensor.name))))
        .collect()
}

fn read_camera(files: &CameraLayout) -> Result<CameraFile, DatasetError> {
    let camera: CameraFile = read_json(&files.camera())?;
    if camera.size.width == 0 || camera.size.height == 0 || !(camera.fps.is_finite() && camera.fps > 0.0) {
        return Err(DatasetError::malformed(files.camera(), "has no size or no frames a second"));
    }
    Ok(camera)
}

/// Counts what happens in the scene; the frames whose condition is another than that in which the video begins.
fn read_frames(
    video: &VideoLayout,
    entry: &VideoEntry,
    begins: Conditions,
    world: &mut WorldStatistics,
) -> Result<BTreeMap<u32, Conditions>, DatasetError> {
    let mut changes = BTreeMap::new();
    // Simulators that do not know their scenes write no such file.
    if !video.frames().is_file() {
        return Ok(changes);
    }
    each_line(&video.frames(), 1, |_, line| {
        let line: SceneLine<'_> = serde_json::from_slice(line).map_err(|e| e.to_string())?;
        let conditions = Conditions { weather: line.weather.name, time_of_day: line.light.time_of_day };
        if conditions != begins && line.frame < entry.frames {
            changes.insert(line.frame, conditions);
        }
        for event in line.events {
            *world.scenes.events.happened.entry(event.kind.into_owned()).or_default() += 1;
        }
        Ok(())
    })?;
    Ok(changes)
}

fn add_camera(
    statistics: &mut DatasetStatistics,
    world: &mut WorldStatistics,
    view: &str,
    camera: &CameraFile,
    count: &CameraCount,
    lines: u64,
) {
    let mut filmed = Filmed { videos: 1, ..Filmed::default() };
    for (conditions, of_condition) in &count.by_condition {
        world.scenes.add(*conditions, *of_condition);
        filmed.absorb(*of_condition);
    }
    let totals = &mut statistics.totals;
    totals.sequences += 1;
    totals.camera_frames += lines;
    totals.camera_frames_read += filmed.camera_frames;
    totals.sequence_ms += milliseconds(lines, camera.fps);
    totals.boxes += filmed.boxes;
    totals.empty_frames += count.boxes_per_frame.of(0);
    totals.boxes_per_frame.absorb(count.boxes_per_frame.clone());
    *totals.sizes.entry(format!("{}x{}", camera.size.width, camera.size.height)).or_default() += lines;
    *totals.fps.entry(camera.fps.to_string()).or_default() += lines;
    statistics.classes.absorb(count.classes.clone());
    statistics.heat_map.absorb(count.heat_map.clone());
    let of_view = world.scenes.views.entry(view.to_owned()).or_default();
    of_view.filmed.absorb(filmed);
    of_view.heat_map.absorb(count.heat_map.clone());
    world.tracks.absorb(count.tracks(camera.fps / f64::from(statistics.stride)));
    world.motion.absorb(count.motion.clone());
}

fn add_seen(seen: &mut BTreeMap<u32, (SeenObject, u64)>, by_camera: BTreeMap<u32, SeenObject>) {
    for (id, object) in by_camera {
        match seen.get_mut(&id) {
            Some((known, cameras)) => {
                known.boxes.absorb(object.boxes);
                *cameras += 1;
            }
            None => {
                seen.insert(id, (object, 1));
            }
        }
    }
}

fn add_events(world: &mut WorldStatistics, scene: &SceneFile) {
    let events = &mut world.scenes.events;
    for incident in &scene.incidents {
        *events.staged.entry(incident.kind.clone()).or_default() += 1;
    }
    for kind in &scene.missed_events {
        *events.missed.entry(kind.clone()).or_default() += 1;
    }
}

/// Counts those who are seen by what stays the same of them, where the simulator knows it.
fn add_actors(
    world: &mut WorldStatistics,
    video: &VideoLayout,
    seen: &BTreeMap<u32, (SeenObject, u64)>,
) -> Result<(), DatasetError> {
    for (object, cameras) in seen.values() {
        let of_class = world.objects.entry(object.class).or_default();
        of_class.seen += 1;
        of_class.seen_by_several_cameras += u64::from(*cameras > 1);
    }
    if !video.actors().is_file() {
        return Ok(());
    }
    let actors: Vec<ActorFile> = read_json(&video.actors())?;
    let mut looks: [Vec<Reid>; 5] = Default::default();
    for actor in &actors {
        let Some((object, _)) = seen.get(&actor.id) else { continue };
        let boxes = object.boxes.values().sum();
        let one = Represented { objects: 1, boxes };
        let group = match (object.class, object.parked) {
            (ObjectClass::Pedestrian, _) => 0,
            (ObjectClass::Rider, _) => 1,
            (_, false) => 2,
            (_, true) => 3,
        };
        looks[group].extend(actor.reid);
        if let Some(person) = &actor.person {
            looks[4].push(person.identity);
            add_person(&mut world.people, person, object, one);
        }
        if let Some(vehicle) = &actor.vehicle {
            people::add(&mut world.vehicles.model, &vehicle.model, one);
            if let Some(color) = &vehicle.color {
                people::add(&mut world.vehicles.color, &color.name, one);
            }
            if let Some(subclass) = &vehicle.subclass {
                people::add(&mut world.vehicles.subclass, subclass, one);
            }
        }
    }
    let [people, riders, vehicles, parked_vehicles, persons] = looks;
    world.looks.people.add_video(people);
    world.looks.riders.add_video(riders);
    world.looks.vehicles.add_video(vehicles);
    world.looks.parked_vehicles.add_video(parked_vehicles);
    world.looks.persons.add_video(persons);
    Ok(())
}

fn add_person(
    people: &mut PeopleStatistics,
    person: &crate::label_line::PersonFile,
    object: &SeenObject,
    one: Represented,
) {
    people.all.absorb(one);
    people.skin_tone.entry(person.skin_tone).or_default().absorb(one);
    for (conditions, boxes) in &object.boxes {
        let of_time = people.boxes_by_time_and_skin_tone.entry(conditions.time_of_day).or_default();
        *of_time.entry(person.skin_tone).or_default() += boxes;
    }
    people::add(&mut people.age_group, &person.age_group, one);
    people::add(&mut people.sex, &person.sex, one);
    people.age_years.add(person.age_years.into());
}

/// Length of so many frames.
fn milliseconds(frames: u64, fps: f64) -> u64 {
    (1000.0 * frames as f64 / fps).round() as u64
}

/// All classes, those without a box among them.
pub(crate) fn all_classes() -> BTreeMap<ObjectClass, BoxStatistics> {
    ObjectClass::ALL.iter().map(|class| (*class, BoxStatistics::default())).collect()
}
