//! A video over time: how many objects of each class its cameras see, what happens, and where each object appears.

use crate::{
    camera_files::CameraFiles, folder::DatasetFolder, line_reader::LineReader, refusal::Refusal, video::Video,
};
use endless_annotate::PixelBox;
use endless_world::{InstanceId, ObjectClass};
use serde::{Deserialize, Serialize};
use std::{
    borrow::Cow,
    collections::{BTreeMap, BTreeSet},
};

/// What is known of a video when all its lines are read.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct Timeline {
    /// Of which `counts` has a row each.
    pub(crate) classes: Vec<ObjectClass>,
    /// For each class and frame, the objects that any of the cameras sees.
    pub(crate) counts: Vec<Vec<u32>>,
    /// What happens, in order.
    pub(crate) events: Vec<TimelineEvent>,
    /// All objects that are ever seen, by id.
    pub(crate) objects: Vec<ObjectAppearances>,
}

/// Something that happens.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct TimelineEvent {
    pub(crate) frame: u32,
    pub(crate) kind: String,
    /// To whom.
    pub(crate) ids: Vec<InstanceId>,
}

/// When and where an object is seen.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct ObjectAppearances {
    pub(crate) id: InstanceId,
    pub(crate) class: ObjectClass,
    /// Of each camera that sees it.
    pub(crate) cameras: Vec<CameraAppearance>,
}

/// When one camera sees an object.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct CameraAppearance {
    /// Its number.
    pub(crate) camera: usize,
    /// First and last frame of each piece without a gap.
    pub(crate) ranges: Vec<[u32; 2]>,
    /// Frames in which it is seen.
    pub(crate) boxes: u32,
    /// Where most of it is seen.
    pub(crate) best: BestView,
}

/// The frame with the most pixels of an object.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct BestView {
    pub(crate) frame: u32,
    pub(crate) bbox: PixelBox,
    pub(crate) pixels: u32,
}

#[derive(Deserialize)]
struct ObjectsLine {
    frame: u32,
    objects: Vec<SeenObject>,
}

#[derive(Deserialize)]
struct SeenObject {
    id: InstanceId,
    class: ObjectClass,
    bbox: PixelBox,
    pixels: u32,
}

#[derive(Deserialize)]
struct FrameLine<'l> {
    frame: u32,
    #[serde(default, borrow)]
    events: Vec<EventLine<'l>>,
}

#[derive(Deserialize)]
struct EventLine<'l> {
    #[serde(borrow)]
    kind: Cow<'l, str>,
    id: Option<InstanceId>,
    #[serde(default)]
    ids: Vec<InstanceId>,
}

impl Timeline {
    /// Reads all lines of all cameras side by side: memory holds one of each.
    pub(crate) fn read(folder: &DatasetFolder, video: &Video) -> Result<Self, Refusal> {
        let mut readers = Vec::new();
        for (number, camera) in video.cameras.iter().enumerate() {
            let path = camera.layout.objects();
            // A camera of a rig may store no labels, and a video that is not complete has none yet.
            if let Ok(file) = folder.open(&path) {
                readers.push((number, camera, LineReader::new(&path, file)));
            }
        }
        let mut found = Gathered::default();
        for frame in 0..video.settings.frames {
            found.begin_frame();
            let mut lines = 0;
            for (number, camera, reader) in &mut readers {
                if !frame.is_multiple_of(camera.every) {
                    continue;
                }
                let Some(line) = reader.next::<ObjectsLine>()? else { continue };
                lines += 1;
                found.note(*number, camera, &line);
            }
            if lines == 0 && readers.iter().any(|(_, camera, _)| frame.is_multiple_of(camera.every)) {
                found.forget_frame();
                break;
            }
        }
        let events = events(folder, video)?;
        Ok(found.timeline(events))
    }
}

#[derive(Debug, Default)]
struct Gathered {
    /// Of each frame, by class.
    counts: Vec<[u32; CLASSES]>,
    seen: BTreeSet<InstanceId>,
    objects: BTreeMap<InstanceId, ObjectAppearances>,
}

const CLASSES: usize = ObjectClass::ALL.len();

impl Gathered {
    fn begin_frame(&mut self) {
        self.counts.push([0; CLASSES]);
        self.seen.clear();
    }

    fn forget_frame(&mut self) {
        self.counts.pop();
    }

    fn note(&mut self, number: usize, camera: &CameraFiles, line: &ObjectsLine) {
        for object in &line.objects {
            if let (true, Some(counts)) = (self.seen.insert(object.id), self.counts.last_mut()) {
                counts[object.class as usize] += 1;
            }
            let appearances = self.objects.entry(object.id).or_insert_with(|| ObjectAppearances {
                id: object.id,
                class: object.class,
                cameras: Vec::new(),
            });
            appearances.note(number, camera.every, line.frame, object);
        }
    }

    fn timeline(self, events: Vec<TimelineEvent>) -> Timeline {
        let present = |class: &ObjectClass| self.objects.values().any(|object| object.class == *class);
        let classes: Vec<ObjectClass> = ObjectClass::ALL.iter().copied().filter(present).collect();
        let counts = classes.iter().map(|&class| self.counts.iter().map(|frame| frame[class as usize]).collect());
        Timeline { counts: counts.collect(), classes, events, objects: self.objects.into_values().collect() }
    }
}

impl ObjectAppearances {
    fn note(&mut self, number: usize, every: u32, frame: u32, object: &SeenObject) {
        let view = BestView { frame, bbox: object.bbox, pixels: object.pixels };
        let camera = match self.cameras.iter_mut().position(|camera| camera.camera == number) {
            Some(place) => &mut self.cameras[place],
            None => {
                self.cameras.push(CameraAppearance { camera: number, ranges: Vec::new(), boxes: 0, best: view });
                let last = self.cameras.len() - 1;
                &mut self.cameras[last]
            }
        };
        camera.boxes += 1;
        if view.pixels > camera.best.pixels {
            camera.best = view;
        }
        match camera.ranges.last_mut() {
            Some(range) if frame.checked_sub(every) == Some(range[1]) => range[1] = frame,
            _ => camera.ranges.push([frame, frame]),
        }
    }
}

fn events(folder: &DatasetFolder, video: &Video) -> Result<Vec<TimelineEvent>, Refusal> {
    let path = video.layout.frames();
    let Ok(file) = folder.open(&path) else { return Ok(Vec::new()) };
    let mut reader = LineReader::new(&path, file);
    let mut events = Vec::new();
    while let Some(line) = reader.next::<FrameLine<'_>>()? {
        let event = |event: EventLine<'_>| TimelineEvent {
            frame: line.frame,
            kind: event.kind.into_owned(),
            ids: event.id.into_iter().chain(event.ids).collect(),
        };
        events.extend(line.events.into_iter().map(event));
    }
    Ok(events)
}
