//! How long lights are yellow.

/// Seconds of yellow before which vehicles drive at this limit, m/s: 3 s up to 50 km/h, 4 s up to 60 km/h, 5 s above (RiLSA, FGSV
/// 2015, "Richtlinien für Lichtsignalanlagen", section 2.7): with less, who is too near to stop would come at red.
pub(crate) fn yellow_s(limit_mps: f64) -> f64 {
    let limit_kmh = 3.6 * limit_mps;
    if limit_kmh < 50.5 {
        3.0
    } else if limit_kmh < 60.5 {
        4.0
    } else {
        5.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fast_roads_have_long_yellows() {
        let seconds = [30.0, 50.0, 60.0, 70.0, 100.0].map(|kmh| yellow_s(kmh / 3.6));
        assert_eq!(seconds, [3.0, 3.0, 4.0, 5.0, 5.0]);
    }
}
