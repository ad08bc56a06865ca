//! The work to do again in a tile of a frame.

use crate::scene::{FrameScene, StaticScene};

/// What must be done again in a tile.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct TileWork {
    /// Moving surfaces may be seen.
    pub(super) primary: bool,
    /// Sunlight may be blocked.
    pub(super) sun: bool,
    /// Mirrors may show something that moves.
    pub(super) mirror: bool,
    /// A traffic light's lens is in view.
    pub(super) lens: bool,
    /// Objects that may darken the ground at their feet, ascending.
    pub(super) contacts: Vec<u16>,
    /// Lamps whose light may be blocked, by index.
    pub(super) lamps: Vec<u16>,
    /// Vehicle lights that may reach it, ascending.
    pub(super) beams: Vec<BeamSweep>,
}

/// A vehicle light that may reach a tile.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct BeamSweep {
    pub(super) beam: u16,
    /// Something that moves may stand in its way.
    pub(super) crossed: bool,
}

impl TileWork {
    /// Everything, for the frame made without the cache.
    pub(super) fn everything(night: bool, still: &StaticScene, frame: &FrameScene) -> Self {
        let all = |n: usize| (0..n).map(|i| i as u16).collect();
        Self {
            primary: true,
            sun: true,
            lamps: all(still.lamps.all().len()),
            mirror: true,
            lens: true,
            contacts: all(frame.objects.len()),
            beams: (0..frame.beams.len() as u16)
                .filter(|_| night)
                .map(|beam| BeamSweep { beam, crossed: true })
                .collect(),
        }
    }

    /// Whether rays must look for what moves.
    pub(super) fn needs_rays(&self) -> bool {
        self.primary || self.sun || self.mirror
    }

    /// Nothing but what rays find: pixels whose rays find nothing are as they were.
    pub(super) fn only_found(&self) -> bool {
        !self.lens && self.contacts.is_empty() && self.lamps.is_empty() && self.beams.is_empty()
    }

    /// Nothing to do.
    pub(super) fn is_none(&self) -> bool {
        self.only_found() && !self.needs_rays()
    }
}
