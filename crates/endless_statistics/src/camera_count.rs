//! Counts what one camera of a video sees.

use crate::boxes::SeenBox;
use crate::label_line::{FrameLine, ObjectLine};
use crate::merge::Merge as _;
use crate::motion::Track;
use crate::{BoxStatistics, Conditions, Filmed, HeatMap, Motions, Tally, TrackStatistics};
use endless_world::{ObjectClass, Parking};
use std::collections::BTreeMap;

/// How an object shows in one camera's pictures.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct SeenObject {
    pub(crate) class: ObjectClass,
    pub(crate) parked: bool,
    /// Its boxes by the condition of the frame.
    pub(crate) boxes: BTreeMap<Conditions, u64>,
}

/// What one camera sees, frame by frame.
#[derive(Debug)]
pub(crate) struct CameraCount {
    /// Width and height, pixels.
    picture: [f64; 2],
    frames: u64,
    tracks: BTreeMap<u32, (ObjectClass, Track)>,
    pub(crate) objects: BTreeMap<u32, SeenObject>,
    pub(crate) boxes_per_frame: Tally,
    pub(crate) classes: BTreeMap<ObjectClass, BoxStatistics>,
    pub(crate) heat_map: HeatMap,
    pub(crate) motion: Motions,
    pub(crate) by_condition: BTreeMap<Conditions, Filmed>,
}

impl CameraCount {
    /// With nothing seen yet.
    pub(crate) fn new(width: u32, height: u32) -> Self {
        Self {
            picture: [f64::from(width), f64::from(height)],
            frames: 0,
            tracks: BTreeMap::new(),
            objects: BTreeMap::new(),
            boxes_per_frame: Tally::default(),
            classes: BTreeMap::new(),
            heat_map: HeatMap::default(),
            motion: Motions::default(),
            by_condition: BTreeMap::new(),
        }
    }

    /// Counts the next frame, filmed in this condition; tells what is wrong with it.
    pub(crate) fn add(&mut self, frame: &FrameLine, conditions: Conditions) -> Result<(), String> {
        for object in &frame.objects {
            self.add_object(object, conditions)?;
        }
        let boxes = frame.objects.len() as u64;
        self.boxes_per_frame.add(boxes);
        self.by_condition.entry(conditions).or_default().absorb(Filmed { videos: 0, camera_frames: 1, boxes });
        self.frames += 1;
        Ok(())
    }

    fn add_object(&mut self, object: &ObjectLine, conditions: Conditions) -> Result<(), String> {
        let bbox = object.bbox.map(f64::from);
        if bbox[2] == 0.0 || bbox[3] == 0.0 {
            return Err(format!("object {} has a box without area", object.id));
        }
        self.classes.entry(object.class).or_default().add(&SeenBox {
            bbox,
            picture: self.picture,
            pixels: Some(object.pixels.into()),
            at_edge: object.truncated,
            visibility: object.visibility,
            truncation: object.truncation,
            distance_m: object.distance_m,
        });
        self.heat_map.add(bbox, self.picture);
        let is_parked = object.parked || object.parking == Some(Parking::Parked);
        match object.class {
            ObjectClass::Rider => {}
            ObjectClass::Pedestrian => self.motion.people.add(is_parked, object.speed_mps),
            _ => self.motion.vehicles.add(is_parked, object.speed_mps),
        }
        let seen = self.objects.entry(object.id).or_insert_with(|| SeenObject {
            class: object.class,
            parked: object.parked,
            boxes: BTreeMap::new(),
        });
        *seen.boxes.entry(conditions).or_default() += 1;
        let frame = self.frames;
        self.tracks
            .entry(object.id)
            .and_modify(|(_, track)| track.see(frame))
            .or_insert_with(|| (object.class, Track::begin(frame, object.parked)));
        Ok(())
    }

    /// The tracks, which are over; a second has so many of the frames that were counted.
    pub(crate) fn tracks(&self, fps: f64) -> BTreeMap<ObjectClass, TrackStatistics> {
        let mut of_classes: BTreeMap<ObjectClass, TrackStatistics> = BTreeMap::new();
        for (class, track) in self.tracks.values() {
            of_classes.entry(*class).or_default().add(track, fps);
        }
        of_classes
    }
}
