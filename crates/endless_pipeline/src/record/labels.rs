//! The labels of what a camera sees.

use super::{recording::Recording, times::Stage};
use crate::SceneTruth;
use endless_annotate::{AnnotateError, CameraView, FrameObjects, ObjectShapes, annotate, visible_objects};
use endless_dataset::CameraOutput;

/// All that is told of the objects that a camera sees.
pub(crate) fn labels(
    recording: &Recording<'_>,
    frame: u32,
    truth: &SceneTruth<'_>,
    view: &CameraView<'_>,
    output: &CameraOutput,
) -> Result<FrameObjects, AnnotateError> {
    let Recording { settings, recipe, clock, .. } = *recording;
    let shapes = truth.shapes.as_deref().map(|shapes| shapes as &dyn ObjectShapes);
    let line = clock.time(Stage::Boxes, || {
        let visible = visible_objects(view.instance);
        let time_s = f64::from(frame) / settings.fps;
        let line = annotate(frame, time_s, &visible, &truth.objects, output.size, output.min_pixels)?;
        Ok::<_, AnnotateError>(line.with_keypoints(&truth.bodies, view))
    })?;
    let line = match shapes {
        Some(shapes) => {
            let line = clock.time(Stage::Amodal, || line.with_amodal(shapes, view, recipe.amodal_masks));
            clock.time(Stage::Boxes, || line.with_boxes3d(shapes, view))
        }
        None => line,
    };
    Ok(clock.time(Stage::Boxes, || line.with_riders(shapes, view)))
}
