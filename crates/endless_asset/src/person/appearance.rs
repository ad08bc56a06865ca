//! How a person looks: age, sex, height, build, skin, hair; what they wear and carry.

use super::clothes::{Garment, Legs, Shoes};
use endless_scene::Material;

/// What grows on the head.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
pub(crate) enum Hair {
    Bald,
    Balding,
    Buzz,
    Short,
    Parted,
    Curly,
    Afro,
    Bob,
    Long,
    Ponytail,
    Bun,
}

/// What grows on the chin.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
pub(crate) enum Beard {
    None,
    Stubble,
    Moustache,
    Full,
}

/// What is worn on the head.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
pub(crate) enum Hat {
    None,
    Cap,
    Beanie,
    Brimmed,
    Fedora,
    Headscarf,
    Turban,
    SiteHelmet,
    PeakedCap,
    Hood,
    /// Of straw, a cone as wide as the shoulders.
    Conical,
    /// Motorcycle helmet.
    FullHelmet,
    /// Motorcycle helmet that leaves the face open.
    OpenHelmet,
    /// Bicycle helmet.
    CycleHelmet,
}

/// What is worn before the eyes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
pub(crate) enum Glasses {
    None,
    Clear,
    Sun,
}

/// What is carried, pushed, led, or sat in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, strum::IntoStaticStr)]
pub(crate) enum Carried {
    Nothing,
    Backpack,
    Handbag,
    ShoulderBag,
    ShoppingBag,
    Briefcase,
    /// Looked at.
    Phone,
    /// Held to the ear.
    Call,
    Umbrella,
    Pram,
    Suitcase,
    Cane,
    Dog,
    Wheelchair,
}

/// How a person looks: body, skin, hair, clothes and what is carried.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Appearance {
    /// Years.
    pub(crate) age: f32,
    pub(crate) female: bool,
    /// Standing height, metres.
    pub(crate) height: f32,
    /// Girth over the average's.
    pub(crate) girth: f32,
    /// Shoulder breadth over the average's.
    pub(crate) shoulder: f32,
    /// Where folds lie.
    pub(crate) folds: f32,
    /// Monk Skin Tone, 0 to 9.
    pub(crate) tone: usize,
    pub(crate) skin: Material,
    pub(crate) hair: Hair,
    pub(crate) hair_color: Material,
    pub(crate) beard: Beard,
    pub(crate) glasses: Glasses,
    pub(crate) hat: Hat,
    pub(crate) hat_color: Material,
    /// From the inside out.
    pub(crate) garments: Vec<Garment>,
    pub(crate) legs: Legs,
    pub(crate) shoes: Shoes,
    pub(crate) carried: Carried,
    pub(crate) bag_color: Material,
    /// What kind of outfit it is.
    pub(crate) outfit: &'static str,
}

impl Appearance {
    /// Below this age people count as children.
    pub(crate) fn child(&self) -> bool {
        self.age < 13.0
    }
}
