//! Event cameras: pixels that have become brighter or darker.

use crate::stream::{SensorHeader, image_header};
use endless_sensor::EventCamera;
use endless_world::{EventCameraSettings, Image, ImageSize};

/// An event camera, and when it was shown its last picture.
pub(super) struct Events {
    camera: EventCamera,
    last_us: i64,
}

impl Events {
    pub(super) fn new(settings: &EventCameraSettings, size: ImageSize, seed: u64) -> Self {
        Self { camera: EventCamera::new(settings, size, seed), last_us: i64::MIN }
    }

    /// The events since the last picture: column, row, nanoseconds of the episode, and whether it became brighter. `None`
    /// where no time has passed.
    pub(super) fn message(&mut self, header: &SensorHeader, fov_deg: f32, image: &Image<[u8; 3]>) -> Option<Vec<u8>> {
        const BYTES: usize = 13;
        let now_us = (header.timestamp * 1e6).round() as i64;
        if now_us <= self.last_us {
            return None;
        }
        self.last_us = now_us;
        let events = self.camera.observe(now_us, image);
        let size = [image.size.width, image.size.height];
        let mut message = image_header(header, size, fov_deg, BYTES * events.len());
        for event in events {
            message.extend(event.x.to_le_bytes());
            message.extend(event.y.to_le_bytes());
            message.extend((event.t_us * 1000).to_le_bytes());
            message.push(u8::from(event.polarity));
        }
        Some(message)
    }
}
