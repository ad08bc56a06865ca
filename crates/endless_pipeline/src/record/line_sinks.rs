//! The lines of sensors that measure where they are and how they move.

use endless_dataset::{DatasetError, LinesWriter, PoseLine};
use endless_road::Georeference;
use endless_sensor::{Gnss, Imu};
use endless_world::{GnssRecord, GnssSettings, ImuRecord, ImuSettings, SensorPose, moving_to};
use glam::DVec3;
use std::path::Path;

/// What an IMU measures on its way, pose by pose.
pub(crate) struct ImuTrack {
    imu: Imu,
    period_s: f64,
    /// The first pose: its velocity is known with the second.
    first: Option<PoseLine>,
}

impl ImuTrack {
    pub(crate) fn new(settings: &ImuSettings, period_s: f64, seed: u64) -> Self {
        Self { imu: Imu::new(settings, period_s, seed), period_s, first: None }
    }

    /// The measurements that are known with this pose.
    pub(crate) fn push(&mut self, at: &PoseLine) -> Vec<ImuRecord> {
        if at.frame == 0 {
            self.first = Some(at.clone());
            return Vec::new();
        }
        let begun = self.first.take().map(|first| {
            let pose = moving_to(&first.pose(), &at.pose(), self.period_s);
            self.measure(&first, &pose)
        });
        begun.into_iter().chain([self.measure(at, &at.pose())]).collect()
    }

    /// The first measurement, where there is no second.
    pub(crate) fn last(&mut self) -> Option<ImuRecord> {
        self.first.take().map(|first| self.measure(&first, &first.pose()))
    }

    fn measure(&mut self, at: &PoseLine, pose: &SensorPose) -> ImuRecord {
        let measurement = self.imu.measure(pose);
        let velocity_mps = self.imu.velocity_mps();
        ImuRecord { frame: at.frame, time_s: at.time_s, measurement, velocity_mps }
    }
}

/// What a GNSS receiver measures on its way, pose by pose.
pub(crate) struct GnssTrack {
    gnss: Gnss,
    georeference: Georeference,
    sample: u64,
}

impl GnssTrack {
    pub(crate) fn new(settings: &GnssSettings, georeference: Georeference, seed: u64) -> Self {
        Self { gnss: Gnss::new(settings, seed), georeference, sample: 0 }
    }

    pub(crate) fn push(&mut self, at: &PoseLine) -> GnssRecord {
        let truth = self.georeference.wgs84(DVec3::from_array(at.position));
        let measurement = self.gnss.measure(self.sample, truth);
        self.sample += 1;
        GnssRecord { frame: at.frame, time_s: at.time_s, measurement }
    }
}

/// `imu.jsonl`.
pub(super) struct ImuSink {
    track: ImuTrack,
    file: LinesWriter<ImuRecord>,
}

impl ImuSink {
    pub(super) fn create(path: &Path, track: ImuTrack) -> Result<Self, DatasetError> {
        Ok(Self { track, file: LinesWriter::create(path)? })
    }

    pub(super) fn push(&mut self, at: &PoseLine) -> Result<(), DatasetError> {
        self.track.push(at).iter().try_for_each(|record| self.file.write(record))
    }

    pub(super) fn finish(mut self) -> Result<(), DatasetError> {
        if let Some(record) = self.track.last() {
            self.file.write(&record)?;
        }
        self.file.finish()
    }
}

/// `gnss.jsonl`.
pub(super) struct GnssSink {
    track: GnssTrack,
    file: LinesWriter<GnssRecord>,
}

impl GnssSink {
    pub(super) fn create(path: &Path, track: GnssTrack) -> Result<Self, DatasetError> {
        Ok(Self { track, file: LinesWriter::create(path)? })
    }

    pub(super) fn push(&mut self, at: &PoseLine) -> Result<(), DatasetError> {
        self.file.write(&self.track.push(at))
    }

    pub(super) fn finish(self) -> Result<(), DatasetError> {
        self.file.finish()
    }
}
