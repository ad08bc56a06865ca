//! Time by sensor.

use std::{
    sync::atomic::{AtomicU64, Ordering},
    time::{Duration, Instant},
};

/// What a camera or another sensor of all videos of a run took.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SensorTimes {
    /// The name of its folder.
    pub name: String,
    /// Frames at which it measured.
    pub measurements: u64,
    /// Points of a LiDAR, detections of a radar.
    pub points: u64,
    /// Thread-seconds from the world state to its files: measuring, labels, images and videos. What moves is posed by
    /// whoever needs it first.
    pub time: Duration,
}

/// Adds up what a stream takes over all threads.
#[derive(Debug, Default)]
pub(crate) struct StreamClock {
    nanos: AtomicU64,
    measurements: AtomicU64,
    points: AtomicU64,
}

impl StreamClock {
    pub(crate) fn time<R>(&self, work: impl FnOnce() -> R) -> R {
        let start = Instant::now();
        let result = work();
        self.add(start.elapsed());
        result
    }

    pub(crate) fn add(&self, time: Duration) {
        self.nanos.fetch_add(time.as_nanos() as u64, Ordering::Relaxed);
    }

    /// Notes a measurement of so many points.
    pub(crate) fn measured(&self, points: usize) {
        self.measurements.fetch_add(1, Ordering::Relaxed);
        self.points.fetch_add(points as u64, Ordering::Relaxed);
    }

    /// Adds it to what was taken before by the sensor of this name.
    pub(crate) fn add_to(&self, name: &str, sensors: &mut Vec<SensorTimes>) {
        let place = sensors.iter().position(|sensor| sensor.name == name).unwrap_or_else(|| {
            let none = SensorTimes { name: name.to_owned(), measurements: 0, points: 0, time: Duration::ZERO };
            sensors.push(none);
            sensors.len() - 1
        });
        let sensor = &mut sensors[place];
        sensor.measurements += self.measurements.load(Ordering::Relaxed);
        sensor.points += self.points.load(Ordering::Relaxed);
        sensor.time += Duration::from_nanos(self.nanos.load(Ordering::Relaxed));
    }
}
