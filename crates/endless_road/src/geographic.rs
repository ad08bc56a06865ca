//! From a map's metres back to degrees, where its file says where on Earth it lies: PROJ strings of transverse Mercator,
//! UTM, Mercator and the equirectangular projection on the WGS 84 ellipsoid, as OpenDRIVE headers and our own imports
//! have them.

use crate::osm::{FLATTENING, RADIUS_M, transverse_mercator};
use endless_world::GnssMeasurement;
use endless_world::math::f64::{acos, atan, cos, exp, ln, sin};
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;

/// The position of a map's local frame on Earth. By default that of CARLA for maps that do not say where they lie: 42° N,
/// 2° E, by a transverse Mercator projection.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Georeference {
    method: Method,
    lat_0: f64,
    lon_0: f64,
    scale: f64,
    /// The local coordinates of the projection's origin, metres.
    origin: DVec2,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Method {
    TransverseMercator,
    /// From the equator; `scale` is that of PROJ's `k_0`.
    Mercator,
    /// On a sphere as large as the equator, as PROJ has it; `scale` is the cosine of the true latitude, for x alone.
    Equirectangular,
}

impl Default for Georeference {
    fn default() -> Self {
        let origin = DVec2::ZERO;
        Self { method: Method::TransverseMercator, lat_0: 42.0, lon_0: 2.0, scale: 1.0, origin }
    }
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
        let lat_0 = || or(number("lat_0"), 0.0).filter(|lat| lat.abs() < 89.0);
        let true_lat = || or(number("lat_ts"), 0.0).filter(|lat| lat.abs() < 89.0);
        let scale = || or(number("k").or(number("k_0")), 1.0).filter(|k| *k > 0.0);
        let origin = || Some(DVec2::new(or(number("x_0"), 0.0)?, or(number("y_0"), 0.0)?));
        let lon_0 = || or(number("lon_0"), 0.0);
        // A sphere of its own, as web maps have it, is none of these.
        let sphere = ["R", "a", "b"].into_iter().any(|key| word(key).is_some());
        match word("proj")? {
            "tmerc" | "etmerc" => Some(Self {
                method: Method::TransverseMercator,
                lat_0: lat_0()?,
                lon_0: lon_0()?,
                scale: scale()?,
                origin: origin()?,
            }),
            "utm" => {
                let zone = number("zone")?.filter(|zone| (1.0..=60.0).contains(zone))?;
                let south = text.split_whitespace().any(|w| w == "+south");
                let origin = DVec2::new(500_000.0, if south { 10_000_000.0 } else { 0.0 });
                let (lon_0, scale) = (zone * 6.0 - 183.0, 0.9996);
                Some(Self { method: Method::TransverseMercator, lat_0: 0.0, lon_0, scale, origin })
            }
            "merc" if !sphere => {
                let scale = match number("lat_ts") {
                    Some(lat) => mercator_scale(lat.filter(|lat| lat.abs() < 89.0)?),
                    None => scale()?,
                };
                Some(Self { method: Method::Mercator, lat_0: 0.0, lon_0: lon_0()?, scale, origin: origin()? })
            }
            "eqc" if !sphere => Some(Self {
                method: Method::Equirectangular,
                lat_0: lat_0()?,
                lon_0: lon_0()?,
                scale: cos(true_lat()?.to_radians()),
                origin: origin()?,
            }),
            _ => None,
        }
    }

    /// As a PROJ string, from which [`parse`](Self::parse) makes the same again.
    pub fn proj(&self) -> String {
        let Self { method, lat_0, lon_0, scale, origin: DVec2 { x, y } } = *self;
        let projection = match method {
            Method::TransverseMercator => format!("tmerc +lat_0={lat_0} +lon_0={lon_0} +k={scale}"),
            Method::Mercator => format!("merc +lon_0={lon_0} +k={scale}"),
            Method::Equirectangular => {
                let lat_ts = acos(scale).to_degrees();
                format!("eqc +lat_ts={lat_ts} +lat_0={lat_0} +lon_0={lon_0}")
            }
        };
        format!("+proj={projection} +x_0={x} +y_0={y} +datum=WGS84 +units=m +no_defs")
    }

    /// Where on Earth a place in the local frame is; heights stay as they are.
    pub fn wgs84(&self, place: DVec3) -> GnssMeasurement {
        let [longitude_deg, latitude_deg] = self.lon_lat(place.truncate());
        GnssMeasurement { latitude_deg, longitude_deg, altitude_m: place.z }
    }

    /// Longitude and latitude of a place in the local frame, degrees.
    pub fn lon_lat(&self, place: DVec2) -> [f64; 2] {
        let from_origin = (place - self.origin) / RADIUS_M;
        match self.method {
            Method::TransverseMercator => self.lon_lat_of_transverse(place),
            Method::Mercator => {
                let DVec2 { x, y } = from_origin / self.scale;
                [self.lon_0 + x.to_degrees(), latitude_rad(y).to_degrees()]
            }
            Method::Equirectangular => {
                [self.lon_0 + (from_origin.x / self.scale).to_degrees(), self.lat_0 + from_origin.y.to_degrees()]
            }
        }
    }

    /// Metres in the local frame of a transverse Mercator projection of a place in degrees.
    fn transverse_metres(&self, lat: f64, lon: f64) -> DVec2 {
        let equator = DVec2::new(0.0, transverse_mercator(self.lat_0, 0.0).y);
        (transverse_mercator(lat, lon - self.lon_0) - equator) * self.scale + self.origin
    }

    fn lon_lat_of_transverse(&self, place: DVec2) -> [f64; 2] {
        const METRES_A_DEGREE: f64 = 111_195.0;
        let (mut lat, mut lon) = (self.lat_0, self.lon_0);
        // Newton's method with the sphere's derivatives: the ellipsoid's differ by less than a hundredth, so that each
        // step leaves less than a hundredth of the error; away from the meridian's direction it needs more.
        for _ in 0..24 {
            let error = place - self.transverse_metres(lat, lon);
            let narrow = cos(lat.to_radians()).max(0.02);
            lat = (lat + error.y / METRES_A_DEGREE / self.scale).clamp(-89.9, 89.9);
            lon = (lon + error.x / (METRES_A_DEGREE * narrow) / self.scale).clamp(self.lon_0 - 80.0, self.lon_0 + 80.0);
            if error.length_squared() < 1e-12 {
                break;
            }
        }
        [lon, lat]
    }
}

/// First eccentricity of WGS 84.
fn eccentricity() -> f64 {
    (FLATTENING * (2.0 - FLATTENING)).sqrt()
}

/// Scale at the equator of a Mercator projection that is true at a latitude, degrees.
fn mercator_scale(true_lat: f64) -> f64 {
    let e = eccentricity() * sin(true_lat.to_radians());
    cos(true_lat.to_radians()) / (1.0 - e * e).sqrt()
}

/// The latitude of an isometric latitude, radians: Snyder 1987, equation 7-9, where each step leaves less than a hundredth of
/// the error.
fn latitude_rad(isometric: f64) -> f64 {
    let e = eccentricity();
    let mut lat = 0.0;
    for _ in 0..12 {
        let x = e * sin(lat);
        lat = 2.0 * atan(exp(isometric + 0.5 * e * ln((1.0 + x) / (1.0 - x)))) - FRAC_PI_2;
    }
    lat
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
        assert_eq!(Georeference::parse("+proj=merc +a=6378137 +b=6378137 +lat_ts=0"), None, "web Mercator");
        assert_eq!(Georeference::parse("+proj=merc +lat_ts=90"), None);
    }

    /// Places as PROJ 9.5.1 gives them, to a tenth of a millimetre: 1e-9 degrees.
    #[test]
    fn agrees_with_proj() {
        let ours = "+proj=tmerc +lat_0=42 +lon_0=2 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs";
        let local = "+proj=eqc +lat_ts=48 +lat_0=48 +lon_0=11 +datum=WGS84";
        let mercator = "+proj=merc +lon_0=8 +k=1 +x_0=100 +y_0=-50 +datum=WGS84";
        for (text, place, lat_lon) in [
            (ours, [350.5, -812.25], [41.9926871778, 2.0042300139]),
            (ours, [12_000.0, 9_000.0], [42.0809353811, 2.1450226408]),
            ("+proj=utm +zone=32 +datum=WGS84", [696_784.0, 5_347_343.0], [48.2487257589, 11.6508871263]),
            (mercator, [100.0, -50.0], [0.0, 8.0]),
            (mercator, [1_234.5, 6_274_861.394], [49.1906343041, 8.0101913869]),
            ("+proj=merc +lat_ts=49 +lon_0=8 +datum=WGS84", [345.25, 4_129_000.5], [49.2301842406, 8.0047183482]),
            (local, [1_500.5, -2_750.25], [47.9752940839, 11.0201443795]),
            ("+proj=eqc +lon_0=11 +datum=WGS84", [1_500.5, 5_316_000.0], [47.7544405038, 11.0134792208]),
        ] {
            let reference = Georeference::parse(text).expect("known");
            let at = reference.wgs84(DVec2::from_array(place).extend(7.5));
            let off = [at.latitude_deg - lat_lon[0], at.longitude_deg - lat_lon[1]];
            assert!(off.iter().all(|degrees| degrees.abs() < 1e-9), "{text}: {at:?}");
            assert_eq!(at.altitude_m, 7.5);
        }
        assert_eq!(Some(Georeference::default()), Georeference::parse(ours), "maps that do not say");
    }

    #[test]
    fn what_is_written_is_read() {
        for text in [
            "+proj=tmerc +lat_0=29.4224112902818 +lon_0=-98.48788928598394 +k=1 +x_0=3 +y_0=-4.5",
            "+proj=utm +zone=32 +south",
            "+proj=merc +lon_0=8 +k=0.99 +x_0=100 +y_0=-50",
        ] {
            let reference = Georeference::parse(text).expect("known");
            assert_eq!(Georeference::parse(&reference.proj()), Some(reference), "{}", reference.proj());
        }
        let local = Georeference::parse("+proj=eqc +lat_ts=48 +lat_0=48 +lon_0=11").expect("known");
        let again = Georeference::parse(&local.proj()).expect("known");
        assert!((again.scale - local.scale).abs() < 1e-15 && Georeference { scale: local.scale, ..again } == local);
        let usual = "+proj=tmerc +lat_0=42 +lon_0=2 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs";
        assert_eq!(Georeference::default().proj(), usual);
    }

    proptest! {
        #[test]
        fn degrees_become_the_same_metres(
            lat_0 in -70.0..70.0f64, lon_0 in -170.0..170.0f64, x in -20_000.0..20_000.0f64, y in -20_000.0..20_000.0f64,
        ) {
            let origin = DVec2::new(10.0, -20.0);
            let frame = Georeference { lat_0, lon_0, scale: 0.9996, origin, ..Georeference::default() };
            let [lon, lat] = frame.lon_lat(DVec2::new(x, y));
            prop_assert!(frame.transverse_metres(lat, lon).distance(DVec2::new(x, y)) < 1e-4);
        }
    }
}
