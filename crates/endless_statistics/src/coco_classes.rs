//! Which of our classes the categories of a COCO file are.

use crate::StatisticsError;
use endless_world::ObjectClass;
use std::{collections::BTreeMap, fs, path::Path};

/// What common datasets call our classes, besides our own words: COCO and BDD100K, Cityscapes, VisDrone, KITTI.
const USUAL: [(&str, ObjectClass); 14] = [
    ("person", ObjectClass::Pedestrian),
    ("people", ObjectClass::Pedestrian),
    ("person_sitting", ObjectClass::Pedestrian),
    ("cyclist", ObjectClass::Rider),
    ("motorcyclist", ObjectClass::Rider),
    ("bike", ObjectClass::Bicycle),
    ("cycle", ObjectClass::Bicycle),
    ("motor", ObjectClass::Motorcycle),
    ("motorbike", ObjectClass::Motorcycle),
    ("scooter", ObjectClass::Motorcycle),
    ("minivan", ObjectClass::Van),
    ("minibus", ObjectClass::Van),
    ("lorry", ObjectClass::Truck),
    ("coach", ObjectClass::Bus),
];

/// The word for categories that are left out.
const NONE: &str = "none";

/// Classes by name of the category.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CocoClasses(BTreeMap<String, Option<ObjectClass>>);

impl CocoClasses {
    /// Reads a TOML file of lines as `"delivery van" = "van"` or `"train" = "none"`; categories that it does not name have
    /// their usual classes.
    ///
    /// # Errors
    /// When it cannot be read, or names a class that there is not.
    pub fn read(path: &Path) -> Result<Self, StatisticsError> {
        let refuse = |reason: String| StatisticsError::Classes { reason, path: path.to_owned() };
        let text = fs::read_to_string(path).map_err(|e| refuse(format!("cannot read: {e}")))?;
        Self::parse(&text).map_err(refuse)
    }

    fn parse(text: &str) -> Result<Self, String> {
        let words: BTreeMap<String, String> = toml::from_str(text).map_err(|e| {
            let line = e.span().map_or(1, |span| text[..span.start.min(text.len())].matches('\n').count() + 1);
            format!("line {line}: {}: write lines as \"delivery van\" = \"van\"", e.message())
        })?;
        let class = |(category, word): (String, String)| {
            if word == NONE {
                return Ok((category, None));
            }
            let class = ObjectClass::ALL.iter().copied().find(|class| class.name() == word);
            let known = || ObjectClass::ALL.iter().map(|class| class.name()).collect::<Vec<_>>().join(", ");
            let class = class.ok_or_else(|| format!("there is no class '{word}': write one of {}, {NONE}", known()))?;
            Ok((category, Some(class)))
        };
        words.into_iter().map(class).collect::<Result<_, _>>().map(Self)
    }

    /// The class of a category, if it is one of ours.
    pub fn class(&self, category: &str) -> Option<ObjectClass> {
        if let Some(told) = self.0.get(category) {
            return *told;
        }
        let plain = category.trim().to_lowercase().replace([' ', '-'], "_");
        let own = ObjectClass::ALL.iter().copied().find(|class| class.name() == plain);
        own.or_else(|| USUAL.iter().find(|(word, _)| *word == plain).map(|(_, class)| *class))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn categories_have_their_usual_class_unless_a_file_says_otherwise() {
        let usual = CocoClasses::default();
        assert_eq!(usual.class("person"), Some(ObjectClass::Pedestrian));
        assert_eq!(usual.class("Person sitting"), Some(ObjectClass::Pedestrian));
        assert_eq!(usual.class("truck"), Some(ObjectClass::Truck));
        assert_eq!(usual.class("toothbrush"), None);
        let told = CocoClasses::parse("person = \"rider\"\n\"delivery van\" = \"van\"\ncar = \"none\"\n");
        let told = told.expect("a mapping");
        assert_eq!(told.class("person"), Some(ObjectClass::Rider));
        assert_eq!(told.class("delivery van"), Some(ObjectClass::Van));
        assert_eq!((told.class("car"), told.class("bus")), (None, Some(ObjectClass::Bus)));
    }

    #[test]
    fn what_is_no_mapping_is_refused() {
        let message = CocoClasses::parse("person = \"human\"").expect_err("no class");
        assert!(message.contains("no class 'human'") && message.contains("pedestrian"), "{message}");
        let message = CocoClasses::parse("a = \"car\"\nb = 3").expect_err("no word");
        assert!(message.starts_with("line 2: "), "{message}");
        assert!(CocoClasses::parse("= =").is_err());
    }
}
