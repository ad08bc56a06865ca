//! Event cameras: settings and events.

use super::noise_check::at_least_0;
use serde::{Deserialize, Serialize};

/// The least threshold that noise leaves.
const LEAST_THRESHOLD: f64 = 0.01;

/// An event camera (dynamic vision sensor), under the names, in the units and with the defaults of CARLA's attributes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct EventCameraSettings {
    /// Change of level upwards that makes an event.
    pub positive_threshold: f64,
    /// Change of level downwards that makes an event, a positive number.
    pub negative_threshold: f64,
    /// Standard deviation of the positive threshold, from pixel to pixel and from frame to frame.
    pub sigma_positive_threshold: f64,
    /// Standard deviation of the negative threshold.
    pub sigma_negative_threshold: f64,
    /// A pixel gives no event sooner after its last one, nanoseconds.
    pub refractory_period_ns: u64,
    /// Whether levels are logarithms of the intensity, rather than the intensity itself from 0 to 255.
    pub use_log: bool,
    /// Added to the intensity from 0 to 1 before its logarithm is taken.
    pub log_eps: f64,
}

impl Default for EventCameraSettings {
    fn default() -> Self {
        Self {
            positive_threshold: 0.3,
            negative_threshold: 0.3,
            sigma_positive_threshold: 0.0,
            sigma_negative_threshold: 0.0,
            refractory_period_ns: 0,
            use_log: true,
            log_eps: 0.001,
        }
    }
}

impl EventCameraSettings {
    /// The least threshold that noise leaves, as in CARLA.
    pub const LEAST_THRESHOLD: f64 = LEAST_THRESHOLD;

    /// Fails with one line on the first setting that cannot be.
    ///
    /// # Errors
    /// When a threshold is below [`Self::LEAST_THRESHOLD`], a deviation below 0, `log_eps` not above 0, or a number not
    /// finite.
    pub fn check(&self) -> Result<(), String> {
        for (name, value) in
            [("positive_threshold", self.positive_threshold), ("negative_threshold", self.negative_threshold)]
        {
            if !(value.is_finite() && value >= LEAST_THRESHOLD) {
                return Err(format!("{name} is {value}: use a number of at least {LEAST_THRESHOLD}"));
            }
        }
        if !(self.log_eps.is_finite() && self.log_eps >= 1e-9) {
            return Err(format!("log_eps is {}: use a number of at least 1e-9", self.log_eps));
        }
        at_least_0(&[
            ("sigma_positive_threshold", self.sigma_positive_threshold),
            ("sigma_negative_threshold", self.sigma_negative_threshold),
        ])
    }
}

/// A pixel has become brighter or darker by a threshold. (What happens in a scene is another kind of event:
/// `endless_annotate::Event`.)
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct PixelEvent {
    /// When, microseconds since frame 0.
    pub t_us: i64,
    /// Row, from the top.
    pub y: u16,
    /// Column, from the left.
    pub x: u16,
    /// Whether it became brighter.
    pub polarity: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_settings_are_named() {
        let good = EventCameraSettings::default();
        assert_eq!(good.check(), Ok(()));
        let wrong = EventCameraSettings { negative_threshold: 0.0, ..good };
        assert_eq!(wrong.check(), Err("negative_threshold is 0: use a number of at least 0.01".to_owned()));
        assert!(EventCameraSettings { log_eps: 0.0, ..good }.check().is_err());
        assert!(EventCameraSettings { sigma_positive_threshold: -1.0, ..good }.check().is_err());
    }
}
