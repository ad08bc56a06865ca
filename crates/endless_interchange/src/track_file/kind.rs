//! Classes by the names that simulators and data sets give to their types.

use endless_world::ObjectClass;

/// What a name of a type says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// A class that there is.
    Known(ObjectClass),
    /// Something of which there are no models.
    NoModels,
    /// Nothing that is understood.
    Unknown,
}

/// Words by what they mean: SUMO's vehicle classes, and what data sets say.
const WORDS: &[(Kind, &[&str])] = &[
    (
        Kind::NoModels,
        &[
            "rail",
            "railway",
            "train",
            "tram",
            "subway",
            "cable",
            "ship",
            "boat",
            "aircraft",
            "drone",
            "container",
            "railtype",
        ],
    ),
    (
        Kind::Known(ObjectClass::Pedestrian),
        &["pedestrian", "pedestrians", "ped", "person", "people", "walker", "human", "pedtype", "wheelchair"],
    ),
    (
        Kind::Known(ObjectClass::Bicycle),
        &["bicycle", "bike", "cyclist", "biker", "cycle", "scooter", "biketype", "escooter"],
    ),
    (Kind::Known(ObjectClass::Motorcycle), &["motorcycle", "motorbike", "moped", "motorcyclist", "mc"]),
    (Kind::Known(ObjectClass::Bus), &["bus", "coach", "trolleybus"]),
    (
        Kind::Known(ObjectClass::Truck),
        &["truck", "lorry", "trailer", "hgv", "semi", "heavy", "tractor", "tanker", "firebrigade"],
    ),
    (Kind::Known(ObjectClass::Van), &["van", "delivery", "minibus", "transporter", "lcv", "ambulance"]),
    (
        Kind::Known(ObjectClass::Car),
        &[
            "car",
            "passenger",
            "taxi",
            "taxitype",
            "vehtype",
            "veh",
            "vehicle",
            "auto",
            "suv",
            "sedan",
            "hatchback",
            "pickup",
            "private",
            "hov",
            "evehicle",
            "emergency",
            "police",
            "authority",
            "army",
            "vip",
            "custom1",
            "custom2",
        ],
    ),
];

/// What the name of a type says: by its words, which come in the order of [`WORDS`] if there are several ("bicycle_person").
pub(super) fn kind_of(name: &str) -> Kind {
    let words = words(name);
    let known = WORDS.iter().find(|(_, known)| words.iter().any(|word| known.contains(&word.as_str())));
    known.map_or(Kind::Unknown, |(kind, _)| *kind)
}

/// The words of a name in lower case: `DEFAULT_VEHTYPE`, `veh-passenger3` and `HeavyTruck` have two each; figures at a
/// word's end are left out.
fn words(name: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut before = ' ';
    for c in name.chars() {
        let begins = c.is_uppercase() && before.is_lowercase();
        if begins || !c.is_alphanumeric() {
            words.push(String::new());
        }
        if let (true, Some(word)) = (c.is_alphanumeric(), words.last_mut()) {
            word.extend(c.to_lowercase());
        }
        before = c;
    }
    words.iter().map(|word| word.trim_end_matches(|c: char| c.is_ascii_digit()).to_owned()).collect()
}

/// Lengths that are usual, metres.
const LENGTHS: [(ObjectClass, f64); 7] = [
    (ObjectClass::Pedestrian, 0.4),
    (ObjectClass::Bicycle, 1.7),
    (ObjectClass::Motorcycle, 2.2),
    (ObjectClass::Car, 4.4),
    (ObjectClass::Van, 5.6),
    (ObjectClass::Truck, 8.5),
    (ObjectClass::Bus, 12.0),
];

/// The class whose usual length is nearest.
pub(super) fn class_of_length(length_m: f64) -> ObjectClass {
    let off = |usual: f64| (usual - length_m).abs();
    LENGTHS.iter().fold(LENGTHS[0], |best, &class| if off(class.1) < off(best.1) { class } else { best }).0
}

#[cfg(test)]
mod tests {
    use super::*;
    use ObjectClass::{Bicycle, Bus, Car, Motorcycle, Pedestrian, Truck, Van};

    #[test]
    fn names_are_understood() {
        for (name, class) in [
            ("passenger", Car),
            ("DEFAULT_VEHTYPE", Car),
            ("DEFAULT_PEDTYPE", Pedestrian),
            ("DEFAULT_BIKETYPE", Bicycle),
            ("car_passenger", Car),
            ("veh-bus3", Bus),
            ("HeavyTruck", Truck),
            ("truck.semi", Truck),
            ("van.ambulance", Van),
            ("moped", Motorcycle),
            ("bicycle_person", Pedestrian),
            ("delivery@v12", Van),
        ] {
            assert_eq!(kind_of(name), Kind::Known(class), "{name}");
        }
        assert_eq!(kind_of("tram_line_4"), Kind::NoModels);
        for name in ["", "t0", "zebra", "carpet", "äöü"] {
            assert_eq!(kind_of(name), Kind::Unknown, "{name}");
        }
    }

    #[test]
    fn lengths_choose_a_class() {
        for (length_m, class) in [(0.2, Pedestrian), (1.6, Bicycle), (4.0, Car), (5.9, Van), (7.5, Truck), (18.0, Bus)]
        {
            assert_eq!(class_of_length(length_m), class, "{length_m} m");
        }
    }
}
