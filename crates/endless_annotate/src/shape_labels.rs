//! Labels that follow from the shapes of objects: boxes in space, amodal ones, two-wheelers with their riders.

use crate::amodal::HiddenPixels;
use crate::{CameraView, FrameObjects, ObjectRecord, ObjectShapes, Spatial, WithRider};
use endless_world::InstanceId;
use glam::Vec3;
use std::collections::BTreeMap;

impl FrameObjects {
    /// With the boxes around the objects.
    #[must_use]
    pub fn with_boxes3d(mut self, shapes: &dyn ObjectShapes, view: &CameraView<'_>) -> Self {
        for object in &mut self.objects {
            let velocity = Vec3::from_array(object.velocity_mps.map(|v| v as f32));
            object.spatial = shapes.box3d(object.id).map(|around| Spatial::new(&around, velocity, view));
        }
        self
    }

    /// With what is hidden of the objects; masks of amodal pixels only where asked for.
    #[must_use]
    pub fn with_amodal(mut self, shapes: &dyn ObjectShapes, view: &CameraView<'_>, masks: bool) -> Self {
        for object in &mut self.objects {
            let id = object.id;
            object.amodal = shapes.covered(view, id).map(|covered| {
                let hidden = HiddenPixels { id, bbox: object.bbox, pixels: object.pixels, covered: &covered };
                hidden.record(view, || shapes.image_bounds(view, id), masks)
            });
        }
        self
    }

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
