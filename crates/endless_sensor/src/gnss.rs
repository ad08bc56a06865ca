//! A satellite navigation receiver.

use endless_world::{GnssMeasurement, GnssSettings, Stream};

/// A receiver; each sample has noise of its own.
#[derive(Debug, Clone)]
pub struct Gnss {
    settings: GnssSettings,
    seed: u64,
}

impl Gnss {
    /// With noise of this seed.
    pub fn new(settings: &GnssSettings, seed: u64) -> Self {
        Self { settings: *settings, seed }
    }

    /// What it measures at a sample, where it truly is there: a bias and white noise are added, as in CARLA. Longitudes stay
    /// within ±180°, latitudes within ±90°.
    pub fn measure(&self, sample: u64, truth: GnssMeasurement) -> GnssMeasurement {
        let mut random = Stream::named(self.seed, "gnss", &[sample]);
        let mut noise = |bias: f64, stddev: f64| bias + stddev * random.normal();
        let set = &self.settings;
        let latitude = truth.latitude_deg + noise(set.noise_lat_bias, set.noise_lat_stddev);
        let longitude = truth.longitude_deg + noise(set.noise_lon_bias, set.noise_lon_stddev);
        let turns = ((longitude + 180.0) / 360.0).floor();
        GnssMeasurement {
            latitude_deg: latitude.clamp(-90.0, 90.0),
            longitude_deg: if turns == 0.0 { longitude } else { longitude - 360.0 * turns },
            altitude_m: truth.altitude_m + noise(set.noise_alt_bias, set.noise_alt_stddev),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TRUTH: GnssMeasurement = GnssMeasurement { latitude_deg: 48.1, longitude_deg: 179.9999999, altitude_m: 3.5 };

    #[test]
    fn without_noise_it_is_the_truth() {
        assert_eq!(Gnss::new(&GnssSettings::default(), 5).measure(9, TRUTH), TRUTH);
    }

    #[test]
    fn noise_is_as_large_as_asked_and_the_same_again() {
        let settings = GnssSettings {
            noise_lat_stddev: 1e-5,
            noise_lon_bias: 1e-6,
            noise_alt_stddev: 2.0,
            ..GnssSettings::default()
        };
        let gnss = Gnss::new(&settings, 5);
        let measured: Vec<GnssMeasurement> = (0..4000).map(|sample| gnss.measure(sample, TRUTH)).collect();
        assert_eq!(measured[17], gnss.measure(17, TRUTH));
        assert_ne!(measured[17], Gnss::new(&settings, 6).measure(17, TRUTH));
        let spread = |of: &dyn Fn(&GnssMeasurement) -> f64| {
            (measured.iter().map(|m| of(m) * of(m)).sum::<f64>() / 4000.0).sqrt()
        };
        assert!((spread(&|m| m.latitude_deg - 48.1) / 1e-5 - 1.0).abs() < 0.05);
        assert!((spread(&|m| m.altitude_m - 3.5) / 2.0 - 1.0).abs() < 0.05);
        // Past the antimeridian.
        assert!(measured.iter().all(|m| (m.longitude_deg + 179.9999991).abs() < 1e-9));
    }
}
