//! A picture after the lens, before the sensor.

use super::bake::CameraBake;
use super::moving_centre::MovingCentre;
use crate::film::mix_rgb;
use crate::pixel_layers::LayerImages;
use endless_world::SensorFrame;

/// A picture before sensor and recorder have added theirs, its labels, and where what moves covers its pixels' centres.
pub(super) struct DevelopedFrame {
    pub(super) frame: u32,
    pub(super) rgb: Vec<[u8; 3]>,
    pub(super) layers: LayerImages,
    /// None where no layer needs them.
    pub(super) centres: Vec<MovingCentre>,
}

impl DevelopedFrame {
    /// The same instant in a light that is this share of the way to that of another picture.
    pub(super) fn mixed(mut self, other: &Self, share: f32) -> Self {
        mix_rgb(&mut self.rgb, &other.rgb, share);
        Self { layers: self.layers.mixed(&other.layers, share), ..self }
    }

    /// What the sensor sees and the recorder keeps of it, without flow; and the centres.
    pub(super) fn recorded(mut self, bake: &CameraBake) -> (SensorFrame, Vec<MovingCentre>) {
        if let Some(post) = &bake.film.response.post_process {
            post.record(self.frame, &mut self.rgb);
        }
        (self.layers.into_sensor_frame(self.frame, bake.camera.size, self.rgb), self.centres)
    }
}
