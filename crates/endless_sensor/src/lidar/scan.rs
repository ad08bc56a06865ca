//! In which order a LiDAR measures which directions.

use endless_world::math::f64::sin_cos;
use endless_world::{LidarSettings, ScanPattern};
use glam::DVec3;
use std::ops::Range;

/// The grid of directions of one sweep: channels by columns.
#[derive(Debug, Clone)]
pub(super) struct Scan {
    pattern: ScanPattern,
    pub(super) channels: u32,
    pub(super) columns: u32,
    /// Sine and cosine of elevation and of azimuth of each channel.
    beams: Vec<[(f64, f64); 2]>,
    /// Sine and cosine of the azimuth of each column.
    headings: Vec<(f64, f64)>,
}

/// Directions that one worker measures one after another, in time.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct ScanGroup {
    pub(super) channels: Range<u32>,
    pub(super) columns: Range<u32>,
}

impl ScanGroup {
    pub(super) fn len(&self) -> usize {
        self.channels.len() * self.columns.len()
    }

    /// Where in the order of time a direction stands.
    pub(super) fn place(&self, channel: u32, column: u32) -> usize {
        (column - self.columns.start) as usize * self.channels.len() + (channel - self.channels.start) as usize
    }

    /// All of them as (channel, column), in bundles of at most 32 that lie beside each other.
    pub(super) fn bundles(&self) -> impl Iterator<Item = Vec<(u32, u32)>> {
        let (tall, wide) = if self.channels.len() < 8 { (1, 32) } else { (8, 4) };
        let (channels, columns) = (self.channels.clone(), self.columns.clone());
        let corners = self
            .columns
            .clone()
            .step_by(wide)
            .flat_map(move |column| channels.clone().step_by(tall).map(move |channel| (channel, column)));
        let end = (self.channels.end, columns.end);
        corners.map(move |(channel, column)| {
            let tall = channel..(channel + tall as u32).min(end.0);
            let wide = column..(column + wide as u32).min(end.1);
            wide.flat_map(|column| tall.clone().map(move |channel| (channel, column))).collect()
        })
    }
}

impl Scan {
    /// Of a sweep of this duration that ends at a frame.
    pub(super) fn new(settings: &LidarSettings, sweep_s: f64, frame: u32) -> Self {
        let per_channel = f64::from(settings.points_per_second) * sweep_s / f64::from(settings.channels);
        let columns = per_channel.round().clamp(1.0, 1e6) as u32;
        let turns = match settings.rotation_frequency {
            0.0 => 1.0,
            frequency => f64::from(frequency) * sweep_s,
        };
        // Whole turns begin at the same place every time, whatever rounding makes of them.
        let turns = if (turns - turns.round()).abs() < 1e-6 { turns.round() } else { turns };
        let view = f64::from(settings.horizontal_fov).to_radians();
        let headings = (0..columns).map(|column| {
            let turned = turns * (f64::from(frame) + (f64::from(column) + 0.5) / f64::from(columns));
            sin_cos(view * (0.5 - turned.fract()))
        });
        let beams = settings.beams().into_iter().map(|beam| [sin_cos(beam.elevation_rad), sin_cos(beam.azimuth_rad)]);
        Self {
            pattern: settings.scan,
            channels: settings.channels,
            columns,
            beams: beams.collect(),
            headings: headings.collect(),
        }
    }

    /// All directions, in groups, in the order of time.
    pub(super) fn groups(&self) -> Vec<ScanGroup> {
        /// Columns whose rays are traced together.
        const TOGETHER: u32 = 4;
        match self.pattern {
            ScanPattern::Rotating => (0..self.columns)
                .step_by(TOGETHER as usize)
                .map(|first| ScanGroup {
                    channels: 0..self.channels,
                    columns: first..(first + TOGETHER).min(self.columns),
                })
                .collect(),
            ScanPattern::Raster | ScanPattern::Flash => (0..self.channels)
                .rev()
                .map(|channel| ScanGroup { channels: channel..channel + 1, columns: 0..self.columns })
                .collect(),
        }
    }

    /// When a direction is measured, as a share of the sweep, above 0 and at most 1.
    pub(super) fn time(&self, channel: u32, column: u32) -> f64 {
        let columns = f64::from(self.columns);
        match self.pattern {
            ScanPattern::Rotating => (f64::from(column) + 1.0) / columns,
            ScanPattern::Raster => {
                let line = self.channels - 1 - channel;
                (f64::from(line) * columns + f64::from(column) + 1.0) / (columns * f64::from(self.channels))
            }
            ScanPattern::Flash => 1.0,
        }
    }

    /// A direction in the sensor's frame, of unit length.
    pub(super) fn direction(&self, channel: u32, column: u32) -> DVec3 {
        let [(sin_up, cos_up), (sin_aside, cos_aside)] = self.beams[channel as usize];
        let (sin, cos) = self.headings[column as usize];
        let ahead = cos * cos_aside - sin * sin_aside;
        let left = sin * cos_aside + cos * sin_aside;
        DVec3::new(ahead * cos_up, left * cos_up, sin_up)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::LidarPreset;
    use endless_world::math::f64::atan2;

    fn azimuth_deg(scan: &Scan, column: u32) -> f64 {
        let direction = scan.direction(0, column);
        atan2(direction.y, direction.x).to_degrees()
    }

    #[test]
    fn a_head_turns_clockwise_from_behind_once_a_sweep() {
        let scan = Scan::new(&LidarSettings::of(LidarPreset::Vlp16), 0.1, 5);
        assert_eq!((scan.channels, scan.columns), (16, 1808));
        assert!(azimuth_deg(&scan, 0) > 179.8 && azimuth_deg(&scan, 1807) < -179.8);
        assert!((azimuth_deg(&scan, 452) - 90.0).abs() < 0.2);
        assert_eq!(scan.time(3, 1807), 1.0);
        assert!(scan.time(3, 0) > 0.0 && scan.time(3, 0) < 0.001);
    }

    #[test]
    fn a_slow_head_goes_on_in_the_next_sweep() {
        let settings = LidarSettings { rotation_frequency: 5.0, ..LidarSettings::of(LidarPreset::Vlp16) };
        let [first, second, third] = [0, 1, 2].map(|frame| Scan::new(&settings, 0.1, frame));
        let last = first.columns - 1;
        assert!(azimuth_deg(&first, 0) > 179.8 && azimuth_deg(&first, last).abs() < 0.2);
        assert!(azimuth_deg(&second, 0).abs() < 0.2 && azimuth_deg(&second, last) < -179.8);
        assert!((azimuth_deg(&third, 7) - azimuth_deg(&first, 7)).abs() < 1e-9);
    }

    #[test]
    fn groups_hold_every_direction_once_in_the_order_of_time() {
        for preset in [LidarPreset::Hdl32e, LidarPreset::SolidState] {
            let settings = LidarSettings { points_per_second: 33_000, ..LidarSettings::of(preset) };
            let scan = Scan::new(&settings, 0.1, 0);
            let (mut seen, mut last) = (0, 0.0);
            for group in scan.groups() {
                let mut bundled: Vec<_> =
                    group.bundles().inspect(|bundle| assert!(bundle.len() <= 32)).flatten().collect();
                bundled.sort_by_key(|&(channel, column)| group.place(channel, column));
                assert_eq!(bundled.len(), group.len());
                assert!((0..).zip(&bundled).all(|(i, &(channel, column))| group.place(channel, column) == i));
                let mut places = vec![None; group.len()];
                for channel in group.channels.clone() {
                    for column in group.columns.clone() {
                        assert_eq!(places[group.place(channel, column)].replace(scan.time(channel, column)), None);
                        assert!((scan.direction(channel, column).length() - 1.0).abs() < 1e-12);
                    }
                }
                for time in places {
                    let time = time.expect("each place is taken");
                    assert!(time >= last && time <= 1.0);
                    last = time;
                    seen += 1;
                }
            }
            assert_eq!((seen, last), (scan.channels * scan.columns, 1.0));
        }
    }

    #[test]
    fn beams_that_look_aside_do_so_at_every_heading() {
        let settings = LidarSettings::of(LidarPreset::Vls128);
        let scan = Scan::new(&settings, 0.1, 0);
        for column in [0, 500, 1200] {
            for (channel, beam) in (0u32..).zip(settings.beams()) {
                let direction = scan.direction(channel, column);
                let heading = 180.0 - 360.0 * (f64::from(column) + 0.5) / f64::from(scan.columns);
                let aside = atan2(direction.y, direction.x).to_degrees() - heading - beam.azimuth_rad.to_degrees();
                assert!((aside - 360.0 * (aside / 360.0).round()).abs() < 1e-9);
                assert!((direction.z - endless_world::math::f64::sin(beam.elevation_rad)).abs() < 1e-12);
            }
        }
    }
}
