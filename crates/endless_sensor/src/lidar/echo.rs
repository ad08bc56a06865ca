//! Echoes.

/// Light that comes back from one distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Echo {
    /// Metres.
    pub(super) distance: f32,
    /// What comes back, of what a white surface there that faces the sensor sends back through clear air.
    pub(super) strength: f32,
}

impl Echo {
    /// The signal that it makes, of that of a white surface at 1 m.
    pub(super) fn power(&self) -> f32 {
        self.strength / (self.distance * self.distance)
    }
}
