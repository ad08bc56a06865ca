//! Which classes an export has: the dataset's own, COCO's, or those of a mapping.

use crate::ExportError;
use endless_dataset::DatasetError;
use endless_world::ObjectClass;
use serde::{Deserialize, Serialize};
use std::{collections::BTreeSet, fs, path::Path};

/// A class of the export.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ExportClass {
    /// Its name.
    pub name: String,
    /// Its number in formats that number classes freely, such as COCO; place + 1 where nothing else is said.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub id: Option<u32>,
    /// Classes of the dataset that belong to it.
    pub from: Vec<ObjectClass>,
}

/// The classes of an export, in order. Classes of the dataset that belong to none are left out.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct ClassMapping {
    /// Whether a user chose them: formats with classes of their own then take these names.
    pub chosen: bool,
    /// The classes.
    pub classes: Vec<ExportClass>,
}

impl Default for ClassMapping {
    fn default() -> Self {
        let own = |&class: &ObjectClass| ExportClass { name: class.name().into(), id: None, from: vec![class] };
        Self { chosen: false, classes: ObjectClass::ALL.iter().map(own).collect() }
    }
}

impl ClassMapping {
    /// COCO's names and numbers, for detectors that know COCO: people and riders are `person`, vans `car`.
    pub fn coco() -> Self {
        use ObjectClass::{Bicycle, Bus, Car, Motorcycle, Pedestrian, Rider, Truck, Van};
        let class = |name: &str, id: u32, from: &[ObjectClass]| ExportClass {
            name: name.into(),
            id: Some(id),
            from: from.to_vec(),
        };
        let classes = vec![
            class("person", 1, &[Pedestrian, Rider]),
            class("bicycle", 2, &[Bicycle]),
            class("car", 3, &[Car, Van]),
            class("motorcycle", 4, &[Motorcycle]),
            class("bus", 6, &[Bus]),
            class("truck", 8, &[Truck]),
        ];
        Self { chosen: true, classes }
    }

    /// The mapping in a TOML file:
    ///
    /// ```toml
    /// [[classes]]
    /// name = "vehicle"
    /// from = ["car", "van", "truck", "bus"]
    /// ```
    ///
    /// # Errors
    /// When the file cannot be read, is no mapping, or maps what does not exist or a class twice.
    pub fn read(path: &Path) -> Result<Self, ExportError> {
        let text = fs::read_to_string(path).map_err(|e| DatasetError::io("cannot read", path, e))?;
        Self::parse(&text).map_err(|reason| ExportError::Classes { reason, path: path.to_owned() })
    }

    fn parse(text: &str) -> Result<Self, String> {
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct File {
            classes: Vec<Entry>,
        }
        #[derive(Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Entry {
            name: String,
            id: Option<u32>,
            from: Vec<String>,
        }
        let file: File = toml::from_str(text).map_err(|e| format!("is no mapping of classes ({})", e.message()))?;
        let known = || ObjectClass::ALL.iter().map(|class| class.name()).collect::<Vec<_>>().join(", ");
        let (mut taken, mut names, mut ids) = (BTreeSet::new(), BTreeSet::new(), BTreeSet::new());
        let mut classes = Vec::new();
        for (place, Entry { name, id, from }) in file.classes.into_iter().enumerate() {
            let mut own = Vec::new();
            for word in &from {
                let class: ObjectClass =
                    word.parse().map_err(|_unknown| format!("maps the class {word:?}, there are {}", known()))?;
                if !taken.insert(class) {
                    return Err(format!("maps {word} twice"));
                }
                own.push(class);
            }
            if name.trim().is_empty() || name.chars().any(char::is_control) {
                return Err(format!("has a class without a name, entry {}", place + 1));
            }
            let number = id.unwrap_or(place as u32 + 1);
            if number == 0 || !ids.insert(number) || !names.insert(name.clone()) {
                return Err(format!("has the name {name:?} or the id {number} twice, or an id of 0"));
            }
            classes.push(ExportClass { name, id, from: own });
        }
        if classes.is_empty() {
            return Err("has no classes".into());
        }
        Ok(Self { chosen: true, classes })
    }

    /// Place of the class that a class of the dataset belongs to.
    pub fn place(&self, class: ObjectClass) -> Option<usize> {
        self.classes.iter().position(|own| own.from.contains(&class))
    }

    /// Number of a class, from its place.
    pub fn id(&self, place: usize) -> u32 {
        self.classes[place].id.unwrap_or(place as u32 + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_mapping_is_read_in_its_order() {
        let text = "[[classes]]\nname = \"vehicle\"\nfrom = [\"truck\", \"car\"]\n[[classes]]\nname = \"person\"\nid = 7\nfrom = [\"pedestrian\"]\n";
        let mapping = ClassMapping::parse(text).expect("a mapping");
        assert_eq!(mapping.place(ObjectClass::Car), Some(0));
        assert_eq!(mapping.place(ObjectClass::Pedestrian), Some(1));
        assert_eq!(mapping.place(ObjectClass::Bus), None);
        assert_eq!([mapping.id(0), mapping.id(1)], [1, 7]);
    }

    #[test]
    fn what_is_wrong_with_a_mapping_is_told() {
        let wrong = |text: &str| ClassMapping::parse(text).expect_err("no mapping");
        let class = |name: &str, from: &str| format!("[[classes]]\nname = \"{name}\"\nfrom = [\"{from}\"]\n");
        assert!(wrong(&class("a", "tram")).contains("\"tram\", there are car, van"), "{}", wrong(&class("a", "tram")));
        assert!(wrong(&(class("a", "car") + &class("b", "car"))).contains("car twice"));
        assert!(wrong(&(class("a", "car") + &class("a", "bus"))).contains("\"a\""));
        assert!(wrong("classes = []").contains("no classes"));
        assert!(wrong("colour = 1").contains("no mapping"));
    }

    #[test]
    fn cocos_classes_take_all_of_ours() {
        let mapping = ClassMapping::coco();
        assert!(ObjectClass::ALL.iter().all(|&class| mapping.place(class).is_some()));
    }

    proptest! {
        #[test]
        fn no_text_makes_it_panic(text in "\\PC{0,80}") {
            let _ = ClassMapping::parse(&text);
        }
    }
}
