//! Pedestrians as traffic knows them.

/// How a person moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Mobility {
    /// Walks, and runs if need be.
    #[default]
    Agile,
    /// Walks with a stick or draws a suitcase: does not run.
    Encumbered,
    /// Walks with both hands on a pram: does not run.
    Pram,
    /// Rolls in a wheelchair.
    Wheelchair,
}

/// A person's stature and way of walking.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PedestrianSpec {
    /// Standing height, metres.
    pub height_m: f32,
    /// Comfortable walking speed, m/s.
    pub walk_mps: f32,
    /// Place in the cycle of two steps at the beginning, 0 to 1, so that a crowd is out of step.
    pub step_phase: f32,
    /// How they move.
    pub mobility: Mobility,
    /// Whether they wear what people jog in, and have nothing in their hands.
    pub dressed_to_run: bool,
    /// Whether they sit down on benches: tall enough, and nothing about them that would be in the way.
    pub sits_down: bool,
}

impl PedestrianSpec {
    /// Whether they can run.
    pub fn can_run(&self) -> bool {
        self.mobility == Mobility::Agile
    }
}

impl Default for PedestrianSpec {
    /// A grown-up of average height.
    fn default() -> Self {
        Self {
            height_m: 1.72,
            walk_mps: 1.36,
            step_phase: 0.0,
            mobility: Mobility::Agile,
            dressed_to_run: false,
            sits_down: true,
        }
    }
}
