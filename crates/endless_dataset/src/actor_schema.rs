//! The schema of `actors.json`, written to every dataset.

use crate::object_fields::FieldLabel;
use endless_world::ColorName;
use serde::{Deserialize, Serialize};

/// Meaning of the fields of `actors.json`.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct ActorSchema {
    /// Changes when a field changes its meaning; 0 of datasets without such files.
    pub version: u32,
    /// Words for colours.
    pub colors: Vec<String>,
    /// The fields, those of nested objects by their path.
    pub fields: Vec<FieldLabel>,
}

/// A garment, a bag, a hat.
const PIECE: &str = "{piece, color: {name, rgb}, pattern, second_color}";

/// Path and meaning.
const FIELDS: &[(&str, &str)] = &[
    ("id", "as in objects.jsonl and the instance images"),
    ("class", "as in objects.jsonl"),
    ("parked", "parked for the whole video"),
    ("reid", "identity of the look, 16 hexadecimal digits: equal for what looks the same, in all videos of all maps"),
    ("vehicle_id", "of a rider: the two-wheeler ridden"),
    ("rider_id", "of a two-wheeler: who rides it"),
    ("vehicle.model", "design in the catalogue, or name of an imported model"),
    ("vehicle.draw", "which draw of the design; those of one draw have one form and size"),
    ("vehicle.subclass", "what it is used for where that can be seen (taxi, police, delivery), else its body (sedan)"),
    ("vehicle.color", "{name, rgb}: paint of body or frame, sRGB before light falls on it"),
    ("vehicle.size", "[length, width, height] in metres: trailer included, mirrors and rider not"),
    ("vehicle.trailer", "whether it draws a trailer"),
    ("vehicle.wheels", "number of wheels, those of the trailer included"),
    ("vehicle.base_type", "CARLA's: car, van, truck, bus, motorcycle, bicycle"),
    ("vehicle.special_type", "CARLA's: emergency, taxi"),
    ("occupants.driver", "whether somebody is seen at the wheel: of all that drive, of none that are parked"),
    ("occupants.passengers", "how many sit on the other seats, in buses none of those who might stand"),
    ("person.identity", "the person, 16 hexadecimal digits: equal where only clothes differ"),
    ("person.age_years", "full years"),
    ("person.age_group", "child (to 12), teenager (to 17), adult (to 64), senior"),
    ("person.sex", "female, male"),
    ("person.height_m", "standing height without hair and headgear, metres"),
    ("person.skin_tone", "Monk Skin Tone, 1 (lightest) to 10"),
    ("person.outfit", "casual, office, suit, sports, high_visibility, uniform, regional"),
    ("person.hair", "{style, color: {name, rgb}}; absent where headgear covers it"),
    ("person.beard", "stubble, moustache, full"),
    ("person.glasses", "glasses, sunglasses"),
    ("person.hat", PIECE),
    ("person.garments", "what is worn on the trunk, from the inside out: a list of pieces as person.hat"),
    ("person.legs", "trousers, shorts or stockings, as person.hat; absent where legs are bare"),
    ("person.shoes", PIECE),
    ("person.carries", "what is carried, pushed, led or sat in: a list of pieces as person.hat"),
];

impl ActorSchema {
    /// The schema of this version.
    pub fn current() -> Self {
        let field = |(name, meaning): &(&str, &str)| FieldLabel { name: (*name).into(), meaning: (*meaning).into() };
        Self {
            version: 1,
            colors: ColorName::ALL.iter().map(|color| color.name().to_owned()).collect(),
            fields: FIELDS.iter().map(field).collect(),
        }
    }

    /// The same of datasets that play recorded tracks.
    #[must_use]
    pub fn with_tracks(mut self) -> Self {
        let meaning =
            "of what plays a recorded track: the track's name in its file; a rider has that of the two-wheeler";
        self.fields.push(FieldLabel { name: "track".into(), meaning: meaning.into() });
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_annotate::ActorRecord;
    use endless_world::{
        AgeGroup, ColorName, ColoredPiece, Hairdo, InstanceId, NamedColor, ObjectClass, Occupants, PersonAttributes,
        Reid, Sex, VehicleAttributes,
    };
    use std::collections::BTreeSet;

    /// An entry with every field.
    fn full() -> ActorRecord {
        let (reid, word) = (Reid::new("any", &[]), std::borrow::Cow::from("any"));
        let color = NamedColor { name: ColorName::Red, rgb: [200, 0, 0] };
        let piece = ColoredPiece::plain("any", color);
        let person = PersonAttributes {
            identity: reid,
            age_years: 30,
            age_group: AgeGroup::Adult,
            sex: Sex::Female,
            height_m: 1.7,
            skin_tone: 5,
            outfit: word.clone(),
            hair: Some(Hairdo { style: word.clone(), color: Some(color) }),
            beard: Some(word.clone()),
            glasses: Some(word.clone()),
            hat: Some(piece.clone()),
            garments: vec![piece.clone()],
            legs: Some(piece.clone()),
            shoes: piece.clone(),
            carries: vec![piece],
        };
        let vehicle = VehicleAttributes {
            model: word.clone(),
            draw: Some(1),
            subclass: Some(word.clone()),
            color: Some(color),
            size: [4.0, 1.8, 1.5],
            trailer: false,
            wheels: 4,
            base_type: word.clone(),
            special_type: Some(word),
        };
        ActorRecord {
            reid: Some(reid),
            vehicle_id: Some(InstanceId(1)),
            rider_id: Some(InstanceId(2)),
            vehicle: Some(vehicle),
            occupants: Some(Occupants { driver: true, passengers: 1 }),
            person: Some(person),
            track: Some("car0".to_owned()),
            ..ActorRecord::new(InstanceId(3), ObjectClass::Car, false)
        }
    }

    #[test]
    fn every_field_is_described_and_nothing_else() {
        let entry = serde_json::to_value(full()).expect("plain data");
        let mut names = BTreeSet::new();
        for (name, value) in entry.as_object().expect("an object") {
            match value.as_object().filter(|_| ["vehicle", "occupants", "person"].contains(&name.as_str())) {
                Some(inner) => names.extend(inner.keys().map(|key| format!("{name}.{key}"))),
                None => drop(names.insert(name.clone())),
            }
        }
        let described: BTreeSet<String> =
            ActorSchema::current().with_tracks().fields.into_iter().map(|f| f.name).collect();
        assert_eq!(described, names);
    }
}
