//! Classes of roads and what is usual for each.

use super::country::CountryRules;
use super::extract::OsmTags;

/// What a way is for vehicles, from the least to the most important.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) enum RoadClass {
    /// Driveways, yards, alleys.
    Service,
    /// Shared by all at walking speed.
    Living,
    /// Homes.
    Residential,
    /// Between villages, and streets without a class.
    Unclassified,
    /// Links districts.
    Tertiary,
    /// Links towns.
    Secondary,
    /// Main road.
    Primary,
    /// Nearly a motorway.
    Trunk,
    /// Motorway.
    Motorway,
}

impl RoadClass {
    /// Of a way that vehicles may use; with whether it is a ramp.
    pub(super) fn of(tags: &OsmTags) -> Option<(Self, bool)> {
        let highway = tags.get("highway")?;
        let (name, link) = highway.strip_suffix("_link").map_or((highway, false), |name| (name, true));
        let class = match name {
            "motorway" => Self::Motorway,
            "trunk" => Self::Trunk,
            "primary" => Self::Primary,
            "secondary" => Self::Secondary,
            "tertiary" => Self::Tertiary,
            "unclassified" | "road" | "minor" => Self::Unclassified,
            "residential" => Self::Residential,
            "living_street" => Self::Living,
            "service" | "services" | "rest_area" | "busway" | "bus_guideway" => Self::Service,
            _ => return None,
        };
        let closed = ["motor_vehicle", "vehicle", "motorcar"].iter().any(|key| tags.is(key, &["no"]))
            || tags.is("area", &["yes"])
            || (tags.is("access", &["no"]) && !tags.is("motor_vehicle", &["yes", "designated", "permissive"]));
        (!closed).then_some((class, link))
    }

    /// Usual width of a lane, metres.
    pub(super) fn lane_m(self) -> f64 {
        match self {
            Self::Motorway | Self::Trunk => 3.6,
            Self::Primary => 3.4,
            Self::Secondary => 3.25,
            Self::Tertiary | Self::Unclassified => 3.1,
            Self::Residential => 3.0,
            Self::Living => 2.8,
            Self::Service => 2.7,
        }
    }

    /// Usual number of lanes in one direction.
    pub(super) fn lanes(self, oneway: bool) -> usize {
        match self {
            Self::Motorway | Self::Trunk | Self::Primary | Self::Secondary if oneway => 2,
            _ => 1,
        }
    }

    /// Usual width of sidewalks in built-up areas, metres; 0 for none.
    pub(super) fn sidewalk_m(self) -> f64 {
        match self {
            Self::Motorway | Self::Trunk | Self::Service | Self::Living => 0.0,
            Self::Primary | Self::Secondary => 2.8,
            Self::Tertiary => 2.4,
            Self::Unclassified | Self::Residential => 2.0,
        }
    }

    /// Radius of kerbs where it meets others, metres.
    pub(super) fn corner_m(self) -> f64 {
        match self {
            Self::Motorway | Self::Trunk => 12.0,
            Self::Primary | Self::Secondary => 7.0,
            Self::Tertiary | Self::Unclassified => 5.5,
            Self::Residential | Self::Living => 4.5,
            Self::Service => 3.0,
        }
    }

    /// Usual limit, km/h.
    pub(super) fn kmh(self, link: bool, country: &CountryRules) -> f64 {
        let through = match self {
            Self::Motorway => country.motorway_kmh,
            Self::Trunk => country.rural_kmh.min(90.0),
            Self::Primary | Self::Secondary | Self::Tertiary => country.urban_kmh,
            Self::Unclassified => country.urban_kmh.min(50.0),
            Self::Residential => country.residential_kmh,
            Self::Living => 12.0,
            Self::Service => 15.0,
        };
        if link { through.min(60.0) } else { through }
    }
}

/// The limit in the `maxspeed` tag or the usual one, m/s.
pub(super) fn speed_mps(tags: &OsmTags, class: RoadClass, link: bool, country: &CountryRules) -> f64 {
    let said = ["maxspeed", "maxspeed:forward", "maxspeed:backward", "zone:maxspeed", "maxspeed:advisory"]
        .iter()
        .find_map(|key| tags.get(key).and_then(|v| parse_kmh(v, country)));
    (said.unwrap_or_else(|| class.kmh(link, country)) / 3.6).clamp(1.5, 55.0)
}

fn parse_kmh(value: &str, country: &CountryRules) -> Option<f64> {
    let value = value.split(';').next()?.trim();
    let (number, factor) = if let Some(n) = value.strip_suffix("mph") {
        (n, 1.609_344)
    } else if let Some(n) = value.strip_suffix("intersections") {
        (n, 1.852)
    } else {
        (value.strip_suffix("km/h").or(value.strip_suffix("kmh")).unwrap_or(value), 1.0)
    };
    if let Ok(n) = number.trim().parse::<f64>() {
        return (n.is_finite() && n > 0.0).then_some(n * factor);
    }
    // `DE:urban`, `RO:zone30`, `walk`, `none`.
    let zone = value.rsplit(':').next().unwrap_or(value);
    match zone {
        "urban" => Some(country.urban_kmh),
        "rural" => Some(country.rural_kmh),
        "motorway" => Some(country.motorway_kmh),
        "none" => Some(130.0),
        "walk" | "living_street" => Some(8.0),
        _ => zone.trim_start_matches("zone").parse::<f64>().ok().filter(|n| *n > 0.0 && n.is_finite()),
    }
}

/// A length with its unit, metres: `3.5`, `3.5 m`, `12'`, `12 ft`, `11'6"`.
pub(super) fn metres(value: &str) -> Option<f64> {
    let value = value.split(';').next()?.trim().replace(',', ".");
    let number = |text: &str| text.trim().parse::<f64>().ok();
    let metres = if let Some((feet, inches)) = value.split_once('\'') {
        let inches = inches.trim().trim_end_matches('"');
        number(feet)? * 0.3048 + if inches.is_empty() { 0.0 } else { number(inches)? * 0.0254 }
    } else if let Some(feet) = value.strip_suffix("ft").or(value.strip_suffix("feet")) {
        number(feet)? * 0.3048
    } else if let Some(km) = value.strip_suffix("km") {
        number(km)? * 1000.0
    } else {
        number(value.strip_suffix('m').unwrap_or(&value))?
    };
    (metres.is_finite() && metres > 0.0).then_some(metres)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn speeds_and_lengths_have_units() {
        let usual = CountryRules::at(48.0, 11.0);
        for (text, kmh) in [
            ("50", 50.0),
            ("30 mph", 48.28),
            ("DE:urban", 50.0),
            ("DE:zone:30", 30.0),
            ("RO:zone30", 30.0),
            ("none", 130.0),
        ] {
            assert!((parse_kmh(text, &usual).expect(text) - kmh).abs() < 0.01, "{text}");
        }
        assert_eq!(parse_kmh("signals", &usual), None);
        assert_eq!(parse_kmh("-5", &usual), None);
        for (text, m) in [("3.5", 3.5), ("3,5 m", 3.5), ("10'", 3.048), ("11'6\"", 3.5052), ("12 ft", 3.6576)] {
            assert!((metres(text).expect(text) - m).abs() < 1e-4, "{text}");
        }
        assert_eq!(metres("wide"), None);
        assert_eq!(metres("-2"), None);
    }
}
