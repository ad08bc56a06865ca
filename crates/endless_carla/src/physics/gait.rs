//! What is seen of a person's legs.

use super::WalkerBody;
use endless_world::{Gait, WalkerMotion};

/// Slower than this is standing, metres a second.
const STANDS_MPS: f64 = 0.1;
/// Faster than this is hurrying, and then running.
const HURRIES_MPS: f64 = 1.9;
const RUNS_MPS: f64 = 2.4;

impl WalkerBody {
    /// What is seen of it at a time of the episode, seconds. Which foot is in front goes by the way that it has walked since it
    /// was made: who knows where it was put knows this, too.
    pub fn motion(&self, time_s: f64) -> WalkerMotion {
        let speed_mps = self.walking_mps();
        let gait = match speed_mps {
            ..STANDS_MPS => Gait::Stand,
            ..HURRIES_MPS => Gait::Walk,
            ..RUNS_MPS => Gait::Hurry,
            _ => Gait::Run,
        };
        WalkerMotion {
            speed_mps: speed_mps as f32,
            gait,
            walked_m: self.walked_m() as f32,
            time_s: time_s as f32,
            footing: None,
            ..WalkerMotion::default()
        }
    }
}
