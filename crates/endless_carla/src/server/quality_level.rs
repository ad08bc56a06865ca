//! CARLA's `-quality-level`.

use endless_render::PixelSamples;

/// How good the pictures of moving cameras are, as CARLA's servers ask it of whoever starts them. Cameras that stand still look
/// the same in both.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum QualityLevel {
    /// As fast as they can be had: edges of things and shadows have steps.
    Low,
    /// As cameras that stand still show it.
    #[default]
    Epic,
}

impl QualityLevel {
    /// All of them.
    pub const ALL: &[Self] = &[Self::Low, Self::Epic];

    /// As CARLA writes it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Low => "Low",
            Self::Epic => "Epic",
        }
    }

    pub(super) fn samples(self) -> PixelSamples {
        match self {
            Self::Low => PixelSamples::Centre,
            Self::Epic => PixelSamples::Four,
        }
    }
}
