//! The standard's lane types in terms of a road map.

use crate::LaneType;

/// Whether traffic drives on a lane of this type.
pub(super) fn is_driven(kind: &str) -> bool {
    matches!(
        kind,
        "driving"
            | "entry"
            | "exit"
            | "onRamp"
            | "offRamp"
            | "connectingRamp"
            | "slipLane"
            | "mwyEntry"
            | "mwyExit"
            | "bus"
            | "taxi"
            | "HOV"
            | "shared"
    )
}

/// Whether people walk on it.
pub(super) fn is_walked(kind: &str) -> bool {
    matches!(kind, "sidewalk" | "walking")
}

/// The surface of a lane of this type; `None` for what is not paved.
pub(super) fn lane_type(kind: &str) -> Option<LaneType> {
    Some(match kind {
        kind if is_driven(kind) => LaneType::Driving,
        "bidirectional" => LaneType::Driving,
        kind if is_walked(kind) => LaneType::Sidewalk,
        "shoulder" | "border" | "stop" | "restricted" | "roadWorks" | "special1" | "special2" | "special3" => {
            LaneType::Shoulder
        }
        "parking" => LaneType::Parking,
        "biking" => LaneType::Biking,
        "median" => LaneType::Median,
        "curb" => LaneType::Curb,
        "tram" | "rail" => LaneType::Rail,
        _ => return None,
    })
}

/// The limit on a road of this type where none is stated, m/s.
pub(super) fn usual_speed(kind: &str) -> f64 {
    let kmh = match kind {
        "motorway" => 120.0,
        "rural" | "townExpressway" => 80.0,
        "lowSpeed" | "townPrivate" => 30.0,
        "pedestrian" | "townPlayStreet" => 15.0,
        _ => 50.0,
    };
    kmh / 3.6
}

/// Surfaces that are not paved.
pub(super) fn is_unpaved(material: &str) -> bool {
    let material = material.to_ascii_lowercase();
    ["gravel", "soil", "earth", "dirt", "grass", "sand", "mud"].iter().any(|word| material.contains(word))
}
