//! What differs from country to country: the side of the road, usual speeds, paint, signs. Coarse boxes: who needs it
//! exact says so.

/// Traffic rules and road markings of a country.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct CountryRules {
    /// Traffic keeps to the left.
    pub(super) left_hand: bool,
    /// Yellow lines part opposite directions.
    pub(super) yellow_centre: bool,
    /// Junctions of equal roads have a stop sign on every arm.
    pub(super) all_way_stop: bool,
    /// Crossings at signals are painted with bars too.
    pub(super) bars_at_signals: bool,
    /// Limit where nothing is said, km/h: in built-up areas, on residential streets, outside, on motorways.
    pub(super) urban_kmh: f64,
    pub(super) residential_kmh: f64,
    pub(super) rural_kmh: f64,
    pub(super) motorway_kmh: f64,
}

/// South, west, north, east, degrees.
type GeoBox = [f64; 4];

/// Where traffic keeps to the left.
const LEFT: &[GeoBox] = &[
    // Britain and Ireland, Channel Islands, Malta, Cyprus.
    [50.0, -11.0, 51.3, 1.45],
    [51.3, -11.0, 61.0, 1.9],
    [49.1, -2.8, 49.8, -1.95],
    [35.7, 14.1, 36.1, 14.6],
    [34.5, 32.2, 35.8, 34.7],
    // Japan, Hong Kong, Macao.
    [30.0, 129.2, 34.9, 146.0],
    [34.9, 130.6, 42.0, 146.0],
    [42.0, 139.0, 45.6, 146.0],
    [24.0, 122.8, 30.0, 131.6],
    [22.1, 113.5, 22.53, 114.45],
    // Thailand, Malaysia, Singapore, Indonesia, Brunei, Papua, the Solomons.
    [5.6, 98.2, 13.0, 102.4],
    [13.0, 98.8, 17.9, 102.5],
    [14.4, 102.5, 17.3, 104.8],
    [17.9, 98.0, 20.4, 101.0],
    [0.8, 99.6, 6.7, 104.6],
    [-11.2, 95.0, 5.0, 141.0],
    [4.0, 113.5, 7.4, 119.3],
    [-12.0, 141.0, 0.0, 163.0],
    // Australia, New Zealand, Fiji.
    [-44.0, 112.0, -10.0, 154.0],
    [-48.0, 166.0, -34.0, 179.0],
    [-19.0, 177.0, -16.0, 180.0],
    // India, Sri Lanka, Nepal, Bhutan, Bangladesh, Pakistan.
    [5.8, 68.5, 30.0, 88.5],
    [30.0, 73.0, 36.5, 79.0],
    [20.5, 88.0, 28.2, 93.6],
    [24.0, 93.6, 28.5, 97.0],
    [24.0, 61.8, 30.9, 69.6],
    [30.9, 70.8, 36.0, 75.0],
    // Southern and eastern Africa, Mauritius.
    [-35.0, 11.7, -17.4, 41.0],
    [-17.4, 22.0, -12.3, 41.0],
    [-12.3, 28.6, -8.2, 41.0],
    [-8.2, 30.9, 4.2, 41.8],
    [-1.4, 29.6, 3.5, 30.9],
    [-20.6, 57.2, -19.9, 57.9],
    // Guyana, Suriname, islands of the Caribbean and the Atlantic.
    [1.8, -61.4, 8.6, -54.0],
    [17.6, -78.5, 18.6, -76.1],
    [20.9, -79.4, 27.3, -71.0],
    [10.0, -61.95, 11.4, -60.4],
    [11.9, -61.8, 14.15, -59.3],
    [15.1, -61.6, 15.7, -61.2],
    [16.9, -62.9, 17.8, -61.6],
    [17.6, -65.1, 18.8, -64.2],
    [19.2, -81.5, 19.8, -79.7],
    [32.2, -64.95, 32.45, -64.6],
    [-52.5, -61.5, -51.0, -57.6],
];

/// The United States and Canada.
const NORTH_AMERICA: &[GeoBox] =
    &[[32.6, -168.0, 72.0, -52.0], [24.4, -106.0, 32.6, -79.4], [18.8, -161.0, 22.5, -154.0]];
const LATIN_AMERICA: &[GeoBox] = &[[-56.0, -92.0, 12.6, -34.0], [7.0, -118.0, 32.6, -59.0]];

fn inside(boxes: &[GeoBox], lat: f64, lon: f64) -> bool {
    boxes.iter().any(|&[s, w, n, e]| (s..n).contains(&lat) && (w..e).contains(&lon))
}

impl CountryRules {
    /// At a place, degrees.
    pub(super) fn at(lat: f64, lon: f64) -> Self {
        let left_hand = inside(LEFT, lat, lon);
        let world = Self {
            left_hand,
            yellow_centre: false,
            all_way_stop: false,
            bars_at_signals: false,
            urban_kmh: 50.0,
            residential_kmh: 30.0,
            rural_kmh: 90.0,
            motorway_kmh: 120.0,
        };
        if inside(NORTH_AMERICA, lat, lon) {
            return Self {
                yellow_centre: true,
                all_way_stop: true,
                bars_at_signals: true,
                urban_kmh: 56.0,
                residential_kmh: 40.0,
                rural_kmh: 88.0,
                motorway_kmh: 104.0,
                ..world
            };
        }
        if inside(LATIN_AMERICA, lat, lon) && !left_hand {
            return Self {
                yellow_centre: true,
                bars_at_signals: true,
                residential_kmh: 40.0,
                motorway_kmh: 100.0,
                ..world
            };
        }
        world
    }
}

#[cfg(test)]
mod tests {
    use super::CountryRules;

    #[test]
    fn cities_drive_on_their_side() {
        let left = [
            ("London", 51.5, -0.12),
            ("Dublin", 53.35, -6.26),
            ("Tokyo", 35.68, 139.76),
            ("Sydney", -33.87, 151.2),
            ("Mumbai", 19.07, 72.88),
            ("Delhi", 28.6, 77.2),
            ("Karachi", 24.86, 67.0),
            ("Dhaka", 23.8, 90.4),
            ("Bangkok", 13.75, 100.5),
            ("Singapore", 1.35, 103.8),
            ("Jakarta", -6.2, 106.8),
            ("Nairobi", -1.29, 36.8),
            ("Johannesburg", -26.2, 28.0),
            ("Kingston", 18.0, -76.8),
            ("Hong Kong", 22.3, 114.17),
            ("Auckland", -36.85, 174.76),
            ("Lusaka", -15.4, 28.3),
            ("Kampala", 0.32, 32.58),
        ];
        let right = [
            ("Paris", 48.86, 2.35),
            ("Berlin", 52.47, 13.44),
            ("Callao", -12.05, -77.14),
            ("New York", 40.7, -74.0),
            ("Miami", 25.77, -80.19),
            ("São Paulo", -23.5, -46.6),
            ("Cairo", 30.0, 31.2),
            ("Seoul", 37.57, 127.0),
            ("Busan", 35.18, 129.07),
            ("Vladivostok", 43.1, 131.9),
            ("Shenzhen", 22.54, 114.06),
            ("Manila", 14.6, 121.0),
            ("Hanoi", 21.0, 105.8),
            ("Phnom Penh", 11.55, 104.92),
            ("Kabul", 34.5, 69.2),
            ("Luanda", -8.8, 13.2),
            ("Kinshasa", -4.3, 15.3),
            ("Kigali", -1.95, 30.06),
            ("Calais", 50.95, 1.86),
            ("Dubai", 25.2, 55.3),
        ];
        for (name, lat, lon) in left {
            assert!(CountryRules::at(lat, lon).left_hand, "{name}");
        }
        for (name, lat, lon) in right {
            assert!(!CountryRules::at(lat, lon).left_hand, "{name}");
        }
    }
}
