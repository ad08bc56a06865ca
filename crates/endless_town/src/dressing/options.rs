//! How a town is dressed otherwise than usual.

use endless_world::CameraSite;

/// Which of the towns that can be made of a road map.
#[derive(Debug, Clone, Copy, Default)]
pub struct DressOptions<'a> {
    /// Dressed anew by this seed: other buildings, colours, shops, trees and furniture on the same roads. `None`: as usual.
    pub seed: Option<u64>,
    /// Where its cameras come from.
    pub sites: TownSites<'a>,
}

/// Where a town's cameras come from.
#[derive(Debug, Clone, Copy, Default)]
pub enum TownSites<'a> {
    /// The best views of the town.
    #[default]
    Chosen,
    /// They hang where they do, and the town is built around them.
    Given(&'a [CameraSite]),
    /// They were drawn in the town as it is built ([`SiteDrawer`](crate::SiteDrawer)); what comes after buildings keeps
    /// out of their sight.
    Drawn(&'a [CameraSite]),
}

impl<'a> TownSites<'a> {
    /// Cameras that are not chosen.
    pub(super) fn given(self) -> Option<&'a [CameraSite]> {
        match self {
            Self::Chosen => None,
            Self::Given(cameras) | Self::Drawn(cameras) => Some(cameras),
        }
    }

    /// Cameras of which buildings keep clear.
    pub(super) fn built_around(self) -> &'a [CameraSite] {
        match self {
            Self::Given(cameras) => cameras,
            Self::Chosen | Self::Drawn(_) => &[],
        }
    }
}
