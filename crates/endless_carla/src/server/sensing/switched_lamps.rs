//! Street lamps as clients have switched them, in pictures.

use endless_render::StaticScene;
use std::collections::BTreeMap;

/// What becomes of the light of some of a map's lamps, by their places in its list, linear channels.
pub(super) type LampFactors = BTreeMap<usize, [f32; 3]>;

/// The map's scene with the light of its lamps as it is now; none while nobody has changed any.
#[derive(Default)]
pub(super) struct SwitchedLamps(Option<(LampFactors, StaticScene)>);

impl SwitchedLamps {
    /// Takes note of the lamps; whether they shine otherwise than before.
    pub(super) fn follow(&mut self, factors: LampFactors, usual: &StaticScene) -> bool {
        let is_same = match &self.0 {
            Some((known, _)) => *known == factors,
            None => factors.is_empty(),
        };
        if !is_same {
            let scene = usual.with_lamp_factors(|lamp| factors.get(&lamp).copied().unwrap_or([1.0; 3]));
            self.0 = Some((factors, scene));
        }
        !is_same
    }

    /// What stands still, in the light of these lamps.
    pub(super) fn scene<'a>(&'a self, usual: &'a StaticScene) -> &'a StaticScene {
        self.0.as_ref().map_or(usual, |(_, scene)| scene)
    }
}
