//! The events of an event camera: those between one picture and the next.

use super::streams::Stream;
use endless_dataset::{CameraLayout, DatasetError, FrameFolder, PoseLine, write_atomic};
use endless_sensor::EventCamera;
use endless_world::{EventCameraSettings, Image, ImageSize};

/// An event camera and its folder.
pub(super) struct EventSink {
    camera: EventCamera,
    files: CameraLayout,
}

impl EventSink {
    pub(super) fn new(stream: &Stream<'_>, settings: &EventCameraSettings, size: ImageSize) -> Self {
        Self { camera: EventCamera::new(settings, size, stream.seed), files: stream.files.clone() }
    }

    pub(super) fn push(&mut self, at: &PoseLine, picture: &Image<[u8; 3]>) -> Result<(), DatasetError> {
        let time_us = (at.time_s * 1e6).round() as i64;
        let events = self.camera.observe(time_us, picture);
        write_atomic(&self.files.frame_file(FrameFolder::Events, at.frame), &FrameFolder::of_events(&events))
    }
}
