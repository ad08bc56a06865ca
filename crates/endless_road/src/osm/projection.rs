//! From degrees to metres: transverse Mercator around a centre (Krüger 1912, series in the third flattening to its
//! third power), exact to a millimetre within a hundred kilometres.

use endless_world::math::f64::{atan2, cos, exp, ln, sin, sin_cos};
use glam::DVec2;

/// Equatorial radius of WGS 84, metres.
pub(crate) const RADIUS_M: f64 = 6_378_137.0;
/// Of WGS 84.
pub(crate) const FLATTENING: f64 = 1.0 / 298.257_223_563;

/// A local frame: x east, y north, metres.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Projection {
    lat: f64,
    lon: f64,
    north_m: f64,
}

fn sinh(x: f64) -> f64 {
    0.5 * (exp(x) - exp(-x))
}

fn cosh(x: f64) -> f64 {
    0.5 * (exp(x) + exp(-x))
}

fn atanh(x: f64) -> f64 {
    0.5 * ln((1.0 + x) / (1.0 - x))
}

impl Projection {
    /// Around a place, degrees.
    pub(super) fn around(lat: f64, lon: f64) -> Self {
        let lat = lat.clamp(-89.0, 89.0);
        let north_m = raw(lat, 0.0).y;
        Self { lat, lon, north_m }
    }

    /// A place in the frame.
    pub(super) fn project(&self, lat: f64, lon: f64) -> DVec2 {
        let mut east = lon - self.lon;
        east -= 360.0 * (east / 360.0).round();
        raw(lat.clamp(-89.9, 89.9), east.clamp(-80.0, 80.0)) - DVec2::new(0.0, self.north_m)
    }

    /// Degrees north and east of a place in the frame, to a millimetre within a few kilometres.
    pub(super) fn unproject(&self, p: DVec2) -> [f64; 2] {
        let (mut lat, mut lon) = (self.lat, self.lon);
        for _ in 0..4 {
            let off = p - self.project(lat, lon);
            lat += off.y / 111_132.0;
            lon += off.x / (111_320.0 * cos(lat.to_radians()));
        }
        [lat, lon]
    }

    /// In PROJ's words.
    pub(super) fn georeference(&self) -> String {
        let (lat, lon) = (self.lat, self.lon);
        format!("+proj=tmerc +lat_0={lat} +lon_0={lon} +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs")
    }
}

/// From the equator, at `east` degrees from the central meridian.
pub(crate) fn raw(lat: f64, east: f64) -> DVec2 {
    let n = FLATTENING / (2.0 - FLATTENING);
    let (n2, n3) = (n * n, n * n * n);
    let scale = RADIUS_M / (1.0 + n) * (1.0 + n2 / 4.0 + n2 * n2 / 64.0);
    let alpha = [n / 2.0 - 2.0 * n2 / 3.0 + 5.0 * n3 / 16.0, 13.0 * n2 / 48.0 - 3.0 * n3 / 5.0, 61.0 * n3 / 240.0];
    let e = 2.0 * n.sqrt() / (1.0 + n);
    let sine = sin(lat.to_radians());
    let t = sinh(atanh(sine) - e * atanh(e * sine));
    let (sin_east, cos_east) = sin_cos(east.to_radians());
    let xi = atan2(t, cos_east);
    let eta = atanh(sin_east / (1.0 + t * t).sqrt());
    let mut place = DVec2::new(eta, xi);
    for (j, a) in alpha.into_iter().enumerate() {
        let k = 2.0 * (j + 1) as f64;
        place += a * DVec2::new(cos(k * xi) * sinh(k * eta), sin(k * xi) * cosh(k * eta));
    }
    scale * place
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_proj() {
        // cs2cs +proj=utm +zone=32 without its scale and offsets: 48.25° N, 11.65° E.
        let utm = Projection { lat: 0.0, lon: 9.0, north_m: 0.0 };
        let p = utm.project(48.25, 11.65) * 0.9996 + DVec2::new(500_000.0, 0.0);
        assert!((p - DVec2::new(696_784.0, 5_347_343.0)).length() < 5_000.0, "{p}");
        // A degree of latitude and of longitude near the centre, by the ellipsoid's radii of curvature.
        let local = Projection::around(45.0, 7.0);
        let step = local.project(45.001, 7.001) - local.project(45.0, 7.0);
        assert!((step.x - 78.846).abs() < 0.01 && (step.y - 111.132).abs() < 0.01, "{step}");
        assert!(local.project(45.0, 7.0).length() < 1e-6);
        let p = DVec2::new(731.0, -462.0);
        let [lat, lon] = local.unproject(p);
        assert!(local.project(lat, lon).distance(p) < 1e-4);
    }
}
