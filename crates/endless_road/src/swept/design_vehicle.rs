//! The bodies for which swept paths are drawn.

use endless_world::VehicleSpec;
use glam::DVec2;

/// A typical body: the largest of those that go somewhere.
#[derive(Debug, Clone, Copy)]
pub struct DesignVehicle {
    /// Half its length and half its width, metres.
    pub half: DVec2,
    pub(super) wheelbase: f64,
    pub(super) rear_axle: f64,
    /// What it draws.
    pub(super) towed: Option<TowedBody>,
}

/// A piece behind a hitch: x in the frame of the whole body while it goes straight on, metres.
#[derive(Debug, Clone, Copy)]
pub(super) struct TowedBody {
    pub(super) hitch: f64,
    pub(super) axle: f64,
    pub(super) front: f64,
    /// Rearmost point of the piece that draws it.
    pub(super) towing_rear: f64,
}

impl TowedBody {
    fn of(spec: &VehicleSpec) -> Option<Self> {
        let t = spec.trailer?;
        let [hitch, axle, front, towing_rear] = [t.hitch_m, t.axle_m, t.front_m, t.towing_rear_m].map(f64::from);
        Some(Self { hitch, axle, front, towing_rear })
    }
}

impl DesignVehicle {
    /// That holds every one of these, `aside` metres beside the middle of the lane.
    pub fn around<'a>(specs: impl IntoIterator<Item = &'a VehicleSpec>, aside: f64) -> Self {
        let mut body = Self { half: DVec2::new(2.2, 0.9), wheelbase: 2.6, rear_axle: 1.3, towed: None };
        for spec in specs {
            let half = DVec2::new(f64::from(spec.length_m), f64::from(spec.width_m)) / 2.0;
            if half.x > body.half.x {
                body.wheelbase = f64::from(spec.front_axle_m - spec.rear_axle_m);
                body.rear_axle = f64::from(-spec.rear_axle_m);
                body.towed = TowedBody::of(spec);
            }
            body.half = body.half.max(half);
        }
        body.half.y += aside;
        body
    }

    pub(super) fn reach(&self) -> f64 {
        self.half.length()
    }
}
