//! How people sit on a two-wheeler or a three-wheeler.

use endless_world::Outfit;
use glam::Vec3;

/// Where a rider touches the vehicle: left side, object frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RiderFit {
    /// Top of the seat; of the deck for who stands.
    pub(crate) seat: Vec3,
    /// Middle of the left grip.
    pub(crate) grip: Vec3,
    /// Sole of the left foot, under the ball.
    pub(crate) foot: Vec3,
    /// How much higher the right foot is (pedals) and further ahead.
    pub(crate) right_foot: Vec3,
    /// Forward lean of the trunk, radians.
    pub(crate) lean_rad: f32,
    /// How likely a helmet is worn.
    pub(crate) helmet: f64,
    /// Which one.
    pub(crate) helmets: HelmetKind,
    /// The weather that riders of it are dressed for.
    pub(crate) outfit: Outfit,
    /// Whether one stands on it.
    pub(crate) standing: bool,
    /// Who may sit behind.
    pub(crate) pillion: Option<PillionFit>,
}

/// Helmets of those who ride a vehicle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum HelmetKind {
    /// Around the whole head, as motorcyclists have.
    Full,
    /// Motorcycle helmets of which half leave the face open.
    Open,
    /// Of cyclists.
    Cycle,
}

/// The second seat: what a passenger touches there, left side, object frame.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PillionFit {
    /// How many riders have somebody behind them.
    pub(crate) share: f64,
    /// Top of the seat.
    pub(crate) seat: Vec3,
    /// Sole of the left foot, under the ball.
    pub(crate) foot: Vec3,
    /// How likely a helmet is worn behind.
    pub(crate) helmet: f64,
}

impl RiderFit {
    /// Somewhere else: each place moved, what lies between two places stretched.
    pub(crate) fn moved(self, place: impl Fn(Vec3) -> Vec3) -> Self {
        let pillion = self.pillion.map(|p| PillionFit { seat: place(p.seat), foot: place(p.foot), ..p });
        Self { seat: place(self.seat), grip: place(self.grip), foot: place(self.foot), pillion, ..self }
    }

    /// The passenger's: they hold on to the rider's waist.
    pub(crate) fn behind(&self) -> Option<Self> {
        let pillion = self.pillion?;
        let waist = self.seat + Vec3::new(-0.03, 0.165, 0.235);
        Some(Self {
            seat: pillion.seat,
            grip: waist,
            foot: pillion.foot,
            right_foot: Vec3::ZERO,
            lean_rad: 0.5 * self.lean_rad,
            helmet: pillion.helmet,
            pillion: None,
            ..*self
        })
    }
}
