//! The words for what people wear and carry, as files have them.

use super::appearance::{Beard, Carried, Glasses, Hair, Hat};
use super::clothes::{FabricPattern, ShoeKind};

impl Hat {
    pub(crate) const fn word(self) -> Option<&'static str> {
        Some(match self {
            Self::None => return None,
            Self::Cap => "cap",
            Self::Beanie => "beanie",
            Self::Brimmed => "sun_hat",
            Self::Fedora => "fedora",
            Self::Headscarf => "headscarf",
            Self::Turban => "turban",
            Self::SiteHelmet => "hard_hat",
            Self::PeakedCap => "peaked_cap",
            Self::Hood => "hood",
            Self::FullHelmet => "motorcycle_helmet",
            Self::Conical => "conical_hat",
            Self::OpenHelmet => "open_helmet",
            Self::CycleHelmet => "bicycle_helmet",
        })
    }
}

impl Glasses {
    pub(crate) const fn word(self) -> Option<&'static str> {
        match self {
            Self::None => None,
            Self::Clear => Some("glasses"),
            Self::Sun => Some("sunglasses"),
        }
    }
}

impl Carried {
    pub(crate) const fn word(self) -> Option<&'static str> {
        Some(match self {
            Self::Nothing => return None,
            Self::Backpack => "backpack",
            Self::Handbag => "handbag",
            Self::ShoulderBag => "shoulder_bag",
            Self::ShoppingBag => "shopping_bag",
            Self::Briefcase => "briefcase",
            Self::Phone | Self::Call => "phone",
            Self::Umbrella => "umbrella",
            Self::Pram => "pram",
            Self::Suitcase => "suitcase",
            Self::Cane => "cane",
            Self::Dog => "dog",
            Self::Wheelchair => "wheelchair",
        })
    }
}

impl Hair {
    pub(crate) const fn word(self) -> &'static str {
        match self {
            Self::Bald => "bald",
            Self::Balding => "balding",
            Self::Buzz => "buzz",
            Self::Short => "short",
            Self::Parted => "parted",
            Self::Curly => "curly",
            Self::Afro => "afro",
            Self::Bob => "bob",
            Self::Long => "long",
            Self::Ponytail => "ponytail",
            Self::Bun => "bun",
        }
    }
}

impl Beard {
    pub(crate) const fn word(self) -> Option<&'static str> {
        match self {
            Self::None => None,
            Self::Stubble => Some("stubble"),
            Self::Moustache => Some("moustache"),
            Self::Full => Some("full"),
        }
    }
}

impl ShoeKind {
    pub(crate) const fn word(self) -> &'static str {
        match self {
            Self::Trainers => "trainers",
            Self::Leather => "leather_shoes",
            Self::Boots => "boots",
            Self::Heels => "heels",
            Self::Sandals => "sandals",
        }
    }
}

impl FabricPattern {
    pub(crate) const fn word(self) -> Option<&'static str> {
        match self {
            Self::Plain => None,
            Self::Stripes => Some("stripes"),
            Self::Block => Some("block"),
            Self::Checks => Some("checks"),
            Self::HighVisibility => Some("high_visibility"),
            Self::Border => Some("border"),
        }
    }
}
