//! Street lamps, lit at night.

use glam::Vec3;

/// A street lamp's light: as luminaires over roads are, with more light aside than straight down and none upwards.
#[derive(Debug, Clone, PartialEq)]
pub struct StreetLamp {
    /// Centre of the lens, world frame, metres; the light shines downwards from here.
    pub position: Vec3,
    /// Linear colour, brightest channel 1.
    pub color: [f32; 3],
    /// Luminous intensity straight down, candela.
    pub intensity_cd: f32,
}
