//! The fifteen fields of an object.

use crate::{
    ClassMapping, Label, LabelledFrame,
    camera::{Camera, rotation},
};
use endless_annotate::{Action, Box3dRecord, PixelBox};
use endless_world::{
    ObjectClass,
    math::f64::{atan2, wrap_angle},
};
use glam::DVec3;

/// An object as KITTI has it. Lengths in metres, angles in radians, the level camera's frame.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct KittiLabel {
    pub(super) track: u16,
    kind: String,
    truncation: f64,
    visibility: f64,
    bbox: PixelBox,
    /// Height, width, length.
    size: [f64; 3],
    /// Middle of the box's bottom.
    location: DVec3,
    rotation_y: f64,
}

/// KITTI's name of a class. A bicycle with its rider is one object.
fn kind(label: &Label, with_rider: bool, classes: &ClassMapping) -> String {
    if classes.chosen {
        return classes.classes[label.class].name.clone();
    }
    let name = match label.object.class {
        ObjectClass::Car => "Car",
        ObjectClass::Van => "Van",
        ObjectClass::Truck => "Truck",
        ObjectClass::Pedestrian if label.object.activity.action == Some(Action::Sitting) => "Person_sitting",
        ObjectClass::Pedestrian => "Pedestrian",
        ObjectClass::Bicycle if with_rider => "Cyclist",
        ObjectClass::Bus | ObjectClass::Motorcycle | ObjectClass::Bicycle | ObjectClass::Rider => "Misc",
    };
    name.into()
}

/// The objects of a frame that have a box in space. Two-wheelers come with their riders, unless classes were chosen.
pub(super) fn kitti_labels(frame: &LabelledFrame<'_>, camera: &Camera, classes: &ClassMapping) -> Vec<KittiLabel> {
    let with_riders = !classes.chosen;
    let ridden = |label: &Label| with_riders && label.object.with_rider.is_some();
    let carried = |label: &Label| {
        let vehicle = label.object.vehicle_id;
        with_riders && vehicle.is_some_and(|id| frame.labels.iter().any(|l| l.object.id == id && ridden(l)))
    };
    let labels = frame.labels.iter().filter(|label| !carried(label));
    labels.filter_map(|label| KittiLabel::new(label, ridden(label), camera, classes)).collect()
}

impl KittiLabel {
    fn new(label: &Label, ridden: bool, camera: &Camera, classes: &ClassMapping) -> Option<Self> {
        let object = &label.object;
        let both = object.with_rider.as_ref().filter(|_| ridden);
        let box3d: &Box3dRecord =
            both.and_then(|both| both.box3d.as_ref()).or(object.spatial.as_ref().map(|spatial| &spatial.box3d))?;
        let level = camera.level_from_world();
        let center = level * (DVec3::from(box3d.center) - camera.position);
        let ahead = level * rotation(box3d.rotation).x_axis;
        let [length, width, height] = box3d.size;
        Some(Self {
            track: object.id.0,
            kind: kind(label, ridden, classes),
            truncation: object.amodal.as_ref().map_or(0.0, |amodal| amodal.truncation),
            visibility: label.visibility(),
            bbox: both.map_or(object.bbox, |both| both.bbox),
            size: [height, width, length],
            location: center + DVec3::new(0.0, 0.5 * height, 0.0),
            rotation_y: atan2(-ahead.z, ahead.x),
        })
    }

    /// 0 to be seen, 1 partly, 2 largely hidden.
    fn occluded(&self) -> u8 {
        match self.visibility {
            seen if seen >= 0.9 => 0,
            seen if seen >= 0.5 => 1,
            _ => 2,
        }
    }

    fn alpha(&self) -> f64 {
        wrap_angle(self.rotation_y - atan2(self.location.x, self.location.z))
    }

    /// A line of the object benchmark.
    pub(super) fn line(&self) -> String {
        format!("{} {:.2} {} {}\n", self.kind, self.truncation, self.occluded(), self.rest())
    }

    /// A line of the tracking benchmark; its frames are counted from 0.
    pub(super) fn tracking_line(&self, frame: usize) -> String {
        let truncated = match self.truncation {
            outside if outside < 0.05 => 0,
            outside if outside < 0.5 => 1,
            _ => 2,
        };
        // The tracking benchmark's files call those who sit so, whatever its page says.
        let kind = if self.kind == "Person_sitting" { "Person" } else { &self.kind };
        format!("{frame} {} {kind} {truncated} {} {}\n", self.track, self.occluded(), self.rest())
    }

    fn rest(&self) -> String {
        let [x, y, w, h] = <[u32; 4]>::from(self.bbox);
        let [height, width, length] = self.size;
        let [lx, ly, lz] = self.location.to_array();
        format!(
            "{:.6} {x} {y} {} {} {height:.3} {width:.3} {length:.3} {lx:.3} {ly:.3} {lz:.3} {:.6}",
            self.alpha(),
            x + w - 1,
            y + h - 1,
            self.rotation_y
        )
    }
}
