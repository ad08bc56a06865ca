//! Two-wheelers together with who rides them: what some detectors call one object.

use crate::{AmodalBox, Box3dRecord, CameraView, FrameObjects, ObjectRecord, ObjectShapes, PixelBox};
use endless_world::InstanceId;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A two-wheeler and its rider as one, as `objects.jsonl` has it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WithRider {
    /// Tight box of the visible pixels of both.
    pub bbox: PixelBox,
    /// Number of these pixels.
    pub pixels: u32,
    /// Box of what both would show if nothing hid them, also beyond the picture's edges.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub amodal_bbox: Option<AmodalBox>,
    /// The box around both, which stands as the two-wheeler does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub box3d: Option<Box3dRecord>,
}

impl FrameObjects {
    /// With the boxes of two-wheelers and riders as one.
    #[must_use]
    pub fn with_riders(mut self, shapes: Option<&dyn ObjectShapes>, view: &CameraView<'_>) -> Self {
        let riders: BTreeMap<InstanceId, ObjectRecord> =
            self.objects.iter().filter(|object| object.vehicle_id.is_some()).map(|o| (o.id, o.clone())).collect();
        for object in &mut self.objects {
            let Some(rider_id) = object.rider_id else { continue };
            let rider = riders.get(&rider_id);
            let box3d = shapes.and_then(|shapes| {
                let own = shapes.box3d(object.id)?;
                Some(shapes.box3d(rider_id).map_or(own, |rider| own.united(&rider)).record(view.camera))
            });
            let amodal = |object: &ObjectRecord| object.amodal.as_ref().map(|amodal| amodal.amodal_bbox);
            let own = amodal(object);
            object.with_rider = Some(WithRider {
                bbox: rider.map_or(object.bbox, |rider| object.bbox.united(rider.bbox)),
                pixels: object.pixels + rider.map_or(0, |rider| rider.pixels),
                amodal_bbox: own.map(|own| rider.and_then(amodal).map_or(own, |rider| own.united(rider))),
                box3d,
            });
        }
        self
    }
}
