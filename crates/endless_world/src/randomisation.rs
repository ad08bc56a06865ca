//! Domain randomisation: what a video varies beside its scene, so that networks do not learn the looks of one renderer
//! (Tobin et al. 2017; Tremblay et al. 2018).

use crate::{CameraSite, ColorVariation, LightVariation, TimeOfDay, UnknownName};
use serde::{Deserialize, Serialize};
use strum::VariantArray as _;

/// What can be randomised, each by itself.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[derive(strum::Display, strum::EnumString, strum::IntoStaticStr, strum::VariantArray)]
#[serde(rename_all = "snake_case")]
#[strum(serialize_all = "snake_case", parse_err_ty = UnknownName, parse_err_fn = Self::unknown)]
pub enum RandomisedPart {
    /// Paints of vehicles, clothes, colours of buildings, ground and plants.
    Colours,
    /// Patterns of ground, walls and roofs.
    Textures,
    /// Sun, sky, lamps, air and exposure.
    Light,
    /// Things that stand beside the road and hide some of it.
    Clutter,
    /// Where the camera hangs and looks, its lens and its white balance.
    Camera,
}

impl RandomisedPart {
    /// All of them.
    pub const ALL: &[Self] = Self::VARIANTS;

    fn unknown(given: &str) -> UnknownName {
        UnknownName::new("part to randomise", given, Self::ALL)
    }
}

/// What one video randomises.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneRandomisation {
    /// The parts, in the order of [`RandomisedPart::ALL`].
    pub parts: Vec<RandomisedPart>,
    /// How far, above 0 to 1.
    pub strength: f32,
    /// Seed of what is drawn for each surface and each thing.
    pub seed: u64,
    /// The light that was drawn, where light is randomised.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub light: Option<LightVariation>,
    /// The sites of the cameras before they were moved, where cameras are randomised.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub usual_cameras: Vec<CameraSite>,
}

impl SceneRandomisation {
    /// What the seed of a scene draws; `None` where nothing is to be varied.
    pub fn new(parts: &[RandomisedPart], strength: f32, time_of_day: TimeOfDay, seed: u64) -> Option<Self> {
        let light = parts.contains(&RandomisedPart::Light).then(|| LightVariation::new(strength, time_of_day, seed));
        (strength > 0.0 && !parts.is_empty()).then(|| Self {
            parts: parts.to_vec(),
            strength,
            seed,
            light,
            usual_cameras: Vec::new(),
        })
    }

    /// Whether a part varies.
    pub fn varies(&self, part: RandomisedPart) -> bool {
        self.parts.contains(&part)
    }

    /// How colours vary, if they do.
    pub fn colors(&self) -> Option<ColorVariation> {
        self.varies(RandomisedPart::Colours).then(|| ColorVariation::new(self.seed, self.strength))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_varied_at_no_strength() {
        let of = |parts: &[RandomisedPart], strength| SceneRandomisation::new(parts, strength, TimeOfDay::Night, 4);
        assert_eq!(of(RandomisedPart::ALL, 0.0), None);
        assert_eq!(of(&[], 1.0), None);
        let light = of(&[RandomisedPart::Light], 0.3).expect("something");
        assert!(light.light.is_some() && light.colors().is_none());
    }
}
