//! From a map's metres back to degrees, where its file says where on Earth it lies: PROJ strings of transverse Mercator
//! and UTM on the WGS 84 ellipsoid, as OpenDRIVE headers and our own imports have them.

use crate::osm::mercator;
use glam::DVec2;

/// The position of a map's local frame on Earth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Georeference {
    lat_0: f64,
    lon_0: f64,
    scale: f64,
    /// The local coordinates of the projection's origin, metres.
    origin: DVec2,
}

impl Georeference {
    /// From a PROJ string; `None` for projections that are not supported.
    pub fn parse(text: &str) -> Option<Self> {
        let word = |key: &str| {
            let mut words = text.split_whitespace().filter_map(|w| w.strip_prefix('+'));
            words.find_map(|w| w.strip_prefix(key)?.strip_prefix('='))
        };
        let number = |key: &str| word(key).map(|value| value.parse::<f64>().ok().filter(|x| x.is_finite()));
        let or = |given: Option<Option<f64>>, usual: f64| given.unwrap_or(Some(usual));
        if word("units").is_some_and(|units| units != "m") {
            return None;
        }
        match word("proj")? {
            "tmerc" | "etmerc" => Some(Self {
                lat_0: or(number("lat_0"), 0.0).filter(|lat| lat.abs() < 89.0)?,
                lon_0: or(number("lon_0"), 0.0)?,
                scale: or(number("k").or(number("k_0")), 1.0).filter(|k| *k > 0.0)?,
                origin: DVec2::new(or(number("x_0"), 0.0)?, or(number("y_0"), 0.0)?),
            }),
            "utm" => {
                let zone = number("zone")?.filter(|zone| (1.0..=60.0).contains(zone))?;
                let south = text.split_whitespace().any(|w| w == "+south");
                let origin = DVec2::new(500_000.0, if south { 10_000_000.0 } else { 0.0 });
                Some(Self { lat_0: 0.0, lon_0: zone * 6.0 - 183.0, scale: 0.9996, origin })
            }
            _ => None,
        }
    }

    /// Metres in the local frame of a place in degrees.
    fn metres(&self, lat: f64, lon: f64) -> DVec2 {
        let equator = DVec2::new(0.0, mercator(self.lat_0, 0.0).y);
        (mercator(lat, lon - self.lon_0) - equator) * self.scale + self.origin
    }

    /// Longitude and latitude of a place in the local frame, degrees.
    pub fn lon_lat(&self, place: DVec2) -> [f64; 2] {
        const METRES_A_DEGREE: f64 = 111_195.0;
        let (mut lat, mut lon) = (self.lat_0, self.lon_0);
        // Newton's method with the sphere's derivatives: the ellipsoid's differ by less than a hundredth, so that each
        // step leaves less than a hundredth of the error; away from the meridian's direction it needs more.
        for _ in 0..24 {
            let error = place - self.metres(lat, lon);
            let narrow = endless_world::math::f64::cos(lat.to_radians()).max(0.02);
            lat = (lat + error.y / METRES_A_DEGREE / self.scale).clamp(-89.9, 89.9);
            lon = (lon + error.x / (METRES_A_DEGREE * narrow) / self.scale).clamp(self.lon_0 - 80.0, self.lon_0 + 80.0);
            if error.length_squared() < 1e-12 {
                break;
            }
        }
        [lon, lat]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn files_say_where_they_lie() {
        let header = "+proj=tmerc +lat_0=29.4224112902818 +lon_0=-98.48788928598394 +k=1 +x_0=0 +y_0=0 +datum=WGS84 \
                      +units=m +geoidgrids=egm96_15.gtx +vunits=m +no_defs ";
        let [lon, lat] = Georeference::parse(header).expect("known").lon_lat(DVec2::ZERO);
        assert!((lon + 98.487_889).abs() < 1e-6 && (lat - 29.422_411).abs() < 1e-6);
        // On the central meridian the 45th parallel is 4,984,944.378 m from the equator (WGS 84), times 0.9996.
        let [lon, lat] = Georeference::parse("+proj=utm +zone=32 +datum=WGS84")
            .expect("known")
            .lon_lat(DVec2::new(500_000.0, 4_982_950.4));
        assert!((lon - 9.0).abs() < 1e-9 && (lat - 45.0).abs() < 1e-5, "{lon} {lat}");
        assert_eq!(Georeference::parse("+proj=lcc +lat_1=33"), None);
        assert_eq!(Georeference::parse("EPSG:25832"), None);
        assert_eq!(Georeference::parse("+proj=tmerc +lat_0=x"), None);
    }

    proptest! {
        #[test]
        fn degrees_become_the_same_metres(
            lat_0 in -70.0..70.0f64, lon_0 in -170.0..170.0f64, x in -20_000.0..20_000.0f64, y in -20_000.0..20_000.0f64,
        ) {
            let frame = Georeference { lat_0, lon_0, scale: 0.9996, origin: DVec2::new(10.0, -20.0) };
            let [lon, lat] = frame.lon_lat(DVec2::new(x, y));
            prop_assert!(frame.metres(lat, lon).distance(DVec2::new(x, y)) < 1e-4);
        }
    }
}
