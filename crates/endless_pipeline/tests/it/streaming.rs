//! What is handed over is what would be written, to the byte.

use crate::{
    city::city,
    fake::{Fake, LiveFake, draft, make, options, recipe},
    rig,
};
use endless_dataset::{DatasetLayout, FrameFolder, Layer, Recipe, RecipeDraft, RgbFormat, VideoLayout, read_rgb};
use endless_pipeline::{
    Measurement, Progress, ProgressEvent, Shard, SilentProgress, Simulator, StreamEnd, StreamOptions, StreamOrder,
    StreamedCamera, StreamedFrame, StreamedSensor, generate, resolve_recipe, stream,
};
use serde::Serialize;
use std::{
    collections::BTreeMap,
    fs,
    ops::ControlFlow,
    path::Path,
    sync::atomic::{AtomicU64, Ordering},
};

fn from_frame(first_frame: u64) -> StreamOptions {
    StreamOptions { threads: 2, first_frame, ..StreamOptions::default() }
}

/// All frames from one on.
fn streamed<S: Simulator>(simulator: &S, recipe: &Recipe, options: &StreamOptions) -> Vec<StreamedFrame> {
    let mut frames = Vec::new();
    let end = stream(simulator, recipe, options, &SilentProgress, &mut |frame| {
        frames.push(frame);
        ControlFlow::Continue(())
    });
    assert_eq!(end.expect("a stream"), StreamEnd::Complete);
    frames
}

/// Lines of a file, by the frames' numbers.
fn lines(path: &Path) -> BTreeMap<u64, String> {
    let number = |line: &str| {
        let value: serde_json::Value = serde_json::from_str(line).expect("JSON");
        value["frame"].as_u64().expect("a frame")
    };
    fs::read_to_string(path).expect("a file").lines().map(|line| (number(line), line.to_owned())).collect()
}

fn line(value: &impl Serialize) -> String {
    serde_json::to_string(value).expect("JSON")
}

/// The files of a dataset beside what is handed over; counts what is compared.
struct Files<'a> {
    video: VideoLayout,
    recipe: &'a Recipe,
    compared: usize,
}

impl Files<'_> {
    fn camera(&mut self, frame: u32, camera: &StreamedCamera) {
        let files = self.video.sensor(&camera.name);
        assert_eq!(lines(&files.objects())[&u64::from(frame)], line(&camera.objects));
        for (layer, image) in &camera.layers {
            let format = layer.format(self.recipe.rgb_format);
            let stored = read_rgb(&files.frame(*layer, frame, self.recipe.rgb_format), format).expect("an image");
            assert!(stored == *image, "{layer} of {} at frame {frame}", camera.name);
            self.compared += 1;
        }
    }

    fn sensor(&mut self, frame: u32, sensor: &StreamedSensor) {
        let files = self.video.sensor(&sensor.name);
        assert_eq!(lines(&files.poses())[&u64::from(frame)], line(&sensor.pose));
        let bytes = |folder| fs::read(files.frame_file(folder, frame)).expect("a file");
        let of_file = |name: &str| lines(&files.folder().join(name));
        match &sensor.measurement {
            Measurement::Camera(camera) => self.camera(frame, camera),
            Measurement::Lidar(sweep) => {
                assert_eq!(FrameFolder::Points.of_sweep(sweep), Some(bytes(FrameFolder::Points)));
            }
            Measurement::Radar(scan) => assert_eq!(FrameFolder::Scans.of_scan(scan), Some(bytes(FrameFolder::Scans))),
            Measurement::Events(events) => assert!(FrameFolder::of_events(events) == bytes(FrameFolder::Events)),
            Measurement::Imu(records) => {
                let file = of_file("imu.jsonl");
                records.iter().for_each(|record| assert_eq!(file[&u64::from(record.frame)], line(record)));
            }
            Measurement::Gnss(record) => assert_eq!(of_file("gnss.jsonl")[&u64::from(record.frame)], line(record)),
            Measurement::Collisions(events) => {
                let file = fs::read_to_string(files.folder().join("collisions.jsonl")).expect("a file");
                assert!(events.iter().all(|event| file.contains(&line(event))));
            }
            Measurement::LaneInvasion(event) => {
                let file = fs::read_to_string(files.folder().join("lane_invasions.jsonl")).expect("a file");
                assert!(event.iter().all(|event| file.contains(&line(event))));
            }
        }
        self.compared += 1;
    }
}

/// How many images and measurements are the same in files and in frames.
fn compare(out: &Path, recipe: &Recipe, frames: &[StreamedFrame]) -> usize {
    let mut compared = 0;
    for frame in frames {
        let video = DatasetLayout::new(out).video(&frame.video.settings);
        let mut files = Files { video, recipe, compared: 0 };
        if let Some(scene) = &frame.scene {
            assert_eq!(lines(&files.video.frames())[&u64::from(frame.frame)], line(scene));
        }
        frame.cameras.iter().for_each(|camera| files.camera(frame.frame, camera));
        frame.sensors.iter().for_each(|sensor| files.sensor(frame.frame, sensor));
        compared += files.compared;
    }
    compared
}

#[test]
fn frames_are_those_of_the_files_for_any_threads_and_order() {
    let all: Vec<String> = Layer::ALL.iter().map(ToString::to_string).collect();
    for format in [RgbFormat::Png, RgbFormat::Jpg] {
        let draft = RecipeDraft { layers: Some(all.clone()), rgb_format: Some(format.to_string()), ..draft() };
        let recipe = recipe(RecipeDraft { mp4: Some(Vec::new()), ..draft });
        let out = tempfile::tempdir().expect("temp");
        make(&Fake::default(), &recipe, out.path(), 2);
        let frames = streamed(&Fake::default(), &recipe, &from_frame(0));
        assert_eq!(compare(out.path(), &recipe, &frames), 3 * 20 * 2 * Layer::ALL.len());
        assert!(frames.iter().map(|frame| frame.index).eq(0..60));
        let alone = StreamOptions { threads: 1, ..from_frame(0) };
        assert!(streamed(&Fake::default(), &recipe, &alone) == frames);
        let by_number = StreamOptions { order: StreamOrder::ByNumber, ..from_frame(0) };
        let frames = streamed(&Fake::default(), &recipe, &by_number);
        assert!(frames.iter().map(|frame| frame.video.settings.video).is_sorted());
        assert_eq!(compare(out.path(), &recipe, &frames), 3 * 20 * 2 * Layer::ALL.len());
    }
}

#[test]
fn a_stream_begins_at_any_frame_and_loads_nothing_before_it() {
    let recipe = recipe(draft());
    let whole = streamed(&Fake::default(), &recipe, &from_frame(0));
    for first in [1, 19, 20, 21, 39, 40, 59, 60, 1000] {
        let fake = Fake::default();
        let frames = streamed(&fake, &recipe, &from_frame(first));
        assert!(frames == whole[whole.len().min(first as usize)..], "from frame {first}");
        assert!(fake.renders.into_inner() as usize == frames.len(), "frames before {first} are not rendered");
    }
}

#[test]
fn shards_share_the_frames() {
    let recipe = recipe(RecipeDraft { videos: Some(5), ..draft() });
    let whole = streamed(&Fake::default(), &recipe, &from_frame(0));
    let mut parts = Vec::new();
    for number in 1..=3 {
        let shard = Some(Shard::new(number, 3).expect("a shard"));
        let part = streamed(&Fake::default(), &recipe, &StreamOptions { shard, ..from_frame(0) });
        assert!(part.iter().map(|frame| frame.index).eq(0..part.len() as u64));
        parts.extend(part);
    }
    let unnumbered = |frames: Vec<StreamedFrame>| {
        frames.into_iter().map(|frame| StreamedFrame { index: 0, ..frame }).collect::<Vec<_>>()
    };
    assert!(unnumbered(parts) == unnumbered(whole));
}

#[test]
fn whoever_takes_the_frames_ends_the_stream() {
    for stop in [0, 1, 25] {
        let mut taken = 0;
        let recipe = recipe(draft());
        let end = stream(&Fake::default(), &recipe, &from_frame(0), &SilentProgress, &mut |frame| {
            assert_eq!(frame.index, taken);
            taken += 1;
            if frame.index == stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert_eq!((end.expect("a stream"), taken), (StreamEnd::Stopped, stop + 1));
    }
}

#[test]
fn simulators_elsewhere_give_their_frames_in_order() {
    let recipe = resolve_recipe(draft(), &LiveFake::default()).expect("a recipe");
    let frames = streamed(&LiveFake::default(), &recipe, &from_frame(0));
    assert!(frames.iter().map(|frame| frame.index).eq(0..60) && frames.iter().all(|frame| frame.cameras.len() == 2));
}

/// What was announced, and what came.
#[derive(Default)]
struct Counted {
    announced: AtomicU64,
    came: AtomicU64,
}

impl Progress for Counted {
    fn event(&self, event: &ProgressEvent<'_>) {
        match event {
            ProgressEvent::Video { camera_frames, .. } => self.announced.fetch_add(*camera_frames, Ordering::Relaxed),
            ProgressEvent::Frame { cameras, .. } => self.came.fetch_add(u64::from(*cameras), Ordering::Relaxed),
            _ => 0,
        };
    }
}

#[test]
fn as_much_comes_as_is_announced() {
    let recipe = resolve_recipe(rig::draft(rig::everything()), city()).expect("a recipe");
    for first_frame in [0, 5] {
        let counted = Counted::default();
        let end = stream(city(), &recipe, &from_frame(first_frame), &counted, &mut |_| ControlFlow::Continue(()));
        assert_eq!(end.expect("a stream"), StreamEnd::Complete);
        assert_eq!(counted.announced.into_inner(), counted.came.into_inner(), "from frame {first_frame}");
    }
}

#[test]
fn the_city_with_every_sensor() {
    let recipe = resolve_recipe(rig::draft(rig::everything()), city()).expect("a recipe");
    let out = tempfile::tempdir().expect("temp");
    generate(city(), &recipe, out.path(), &options(2), &SilentProgress).expect("a dataset");
    let frames = streamed(city(), &recipe, &from_frame(0));
    assert!(compare(out.path(), &recipe, &frames) > 60);
    assert!(frames[0].video.actors.as_ref().is_some_and(|actors| actors.len() > 20));
    let late = streamed(city(), &recipe, &from_frame(5));
    // IMUs tell of frame 0 at frame 1, and of others at once.
    assert!(late[..] == frames[5..], "what sensors remember does not depend on the first frame");
}
