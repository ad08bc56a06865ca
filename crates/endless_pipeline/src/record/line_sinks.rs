//! The lines of sensors that measure where they are and how they move.

use endless_dataset::{DatasetError, LinesWriter, PoseLine};
use endless_road::Georeference;
use endless_sensor::{Gnss, Imu};
use endless_world::{GnssRecord, GnssSettings, ImuRecord, ImuSettings, moving_to};
use glam::DVec3;
use std::path::Path;

/// `imu.jsonl`.
pub(super) struct ImuSink {
    imu: Imu,
    period_s: f64,
    file: LinesWriter<ImuRecord>,
    /// The first pose: its velocity is known with the second.
    first: Option<PoseLine>,
}

impl ImuSink {
    pub(super) fn create(path: &Path, settings: &ImuSettings, period_s: f64, seed: u64) -> Result<Self, DatasetError> {
        let file = LinesWriter::create(path)?;
        Ok(Self { imu: Imu::new(settings, period_s, seed), period_s, file, first: None })
    }

    pub(super) fn push(&mut self, at: &PoseLine) -> Result<(), DatasetError> {
        if at.frame == 0 {
            self.first = Some(at.clone());
            return Ok(());
        }
        if let Some(first) = self.first.take() {
            let begun = moving_to(&first.pose(), &at.pose(), self.period_s);
            self.write(&first, &begun)?;
        }
        self.write(at, &at.pose())
    }

    fn write(&mut self, at: &PoseLine, pose: &endless_world::SensorPose) -> Result<(), DatasetError> {
        let measurement = self.imu.measure(pose);
        let velocity_mps = self.imu.velocity_mps();
        self.file.write(&ImuRecord { frame: at.frame, time_s: at.time_s, measurement, velocity_mps })
    }

    pub(super) fn finish(mut self) -> Result<(), DatasetError> {
        // There was no second.
        if let Some(first) = self.first.take() {
            self.write(&first, &first.pose())?;
        }
        self.file.finish()
    }
}

/// `gnss.jsonl`.
pub(super) struct GnssSink {
    gnss: Gnss,
    georeference: Georeference,
    file: LinesWriter<GnssRecord>,
    sample: u64,
}

impl GnssSink {
    pub(super) fn create(
        path: &Path,
        settings: &GnssSettings,
        georeference: Georeference,
        seed: u64,
    ) -> Result<Self, DatasetError> {
        Ok(Self { gnss: Gnss::new(settings, seed), georeference, file: LinesWriter::create(path)?, sample: 0 })
    }

    pub(super) fn push(&mut self, at: &PoseLine) -> Result<(), DatasetError> {
        let truth = self.georeference.wgs84(DVec3::from_array(at.position));
        let measurement = self.gnss.measure(self.sample, truth);
        self.sample += 1;
        self.file.write(&GnssRecord { frame: at.frame, time_s: at.time_s, measurement })
    }

    pub(super) fn finish(self) -> Result<(), DatasetError> {
        self.file.finish()
    }
}
