//! Trailers: the axle follows the hitch without slipping sideways.

use endless_road::swept::towed_heading;
use endless_world::VehicleSpec;
use endless_world::math::f64::{atan2, sin_cos};
use glam::DVec2;

/// A trailer on its way.
#[derive(Debug, Clone, Copy)]
pub(crate) struct TrailerState {
    /// Of the hitch ahead of the vehicle's origin, metres.
    hitch_m: f64,
    /// From the hitch to the axle, metres.
    bar_m: f64,
    hitch: DVec2,
    pub(crate) yaw: f64,
}

impl TrailerState {
    /// Of a vehicle that draws one.
    pub(crate) fn of(spec: &VehicleSpec) -> Option<Self> {
        let trailer = spec.trailer?;
        let (hitch_m, bar_m) = (f64::from(trailer.hitch_m), f64::from(trailer.hitch_m - trailer.axle_m));
        Some(Self { hitch_m, bar_m, hitch: DVec2::ZERO, yaw: 0.0 })
    }

    /// In line with a vehicle that stands here.
    pub(crate) fn settle(&mut self, origin: DVec2, yaw: f64) {
        (self.hitch, self.yaw) = (self.hitch_of(origin, yaw), yaw);
    }

    /// After the vehicle that draws it has come here.
    pub(crate) fn follow(&mut self, origin: DVec2, yaw: f64) {
        let hitch = self.hitch_of(origin, yaw);
        let way = hitch - self.hitch;
        if way.length_squared() > 1e-12 {
            self.yaw = towed_heading(self.yaw, atan2(way.y, way.x), way.length(), self.bar_m);
        }
        self.hitch = hitch;
    }

    /// The middle of its axles.
    #[cfg(test)]
    pub(crate) fn axle(&self) -> DVec2 {
        let (sin, cos) = sin_cos(self.yaw);
        self.hitch - DVec2::new(cos, sin) * self.bar_m
    }

    fn hitch_of(&self, origin: DVec2, yaw: f64) -> DVec2 {
        let (sin, cos) = sin_cos(yaw);
        origin + DVec2::new(cos, sin) * self.hitch_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_asset::Catalogue;
    use endless_world::math::f64::{atan, wrap_angle};
    use std::f64::consts::FRAC_PI_2;

    fn trailer(name: &str) -> TrailerState {
        let vehicle = Catalogue::draw_vehicle(name, 0).expect("a design");
        TrailerState::of(&vehicle.spec).expect("it draws something")
    }

    #[test]
    fn a_trailer_comes_round_in_a_circle_and_straightens_on_a_straight() {
        for name in ["truck.semi", "bus.articulated", "car.trailer"] {
            let mut t = trailer(name);
            let radius = 22.0;
            t.settle(DVec2::new(radius, 0.0), FRAC_PI_2);
            let mut yaw = FRAC_PI_2;
            for k in 1..2000 {
                let angle = f64::from(k) * 0.01;
                let (sin, cos) = sin_cos(angle);
                yaw = FRAC_PI_2 + angle;
                t.follow(DVec2::new(cos, sin) * radius, yaw);
            }
            // The hitch goes round on a circle of its own; the axle on one that its bar touches.
            let axle = (t.hitch.length_squared() - t.bar_m * t.bar_m).sqrt();
            assert!((t.axle().length() - axle).abs() < 0.02, "{name}: {} not {axle}", t.axle().length());
            assert!(wrap_angle(t.yaw - yaw) < -0.05, "{name}: it lags behind");
            let (sin, cos) = sin_cos(yaw);
            let from = t.hitch - DVec2::new(cos, sin) * t.hitch_m;
            for k in 1..600 {
                t.follow(from + DVec2::new(cos, sin) * f64::from(k) * 0.1, yaw);
            }
            assert!(wrap_angle(t.yaw - yaw).abs() < 0.002, "{name}: straight again");
        }
    }

    #[test]
    fn steps_of_any_length_lead_to_the_same_place() {
        let run = |n: u32| {
            let mut t = trailer("truck.semi");
            t.settle(DVec2::ZERO, 0.0);
            for k in 1..=n {
                let x = 60.0 * f64::from(k) / f64::from(n);
                t.follow(DVec2::new(x, 0.004 * x * x), atan(0.008 * x));
            }
            t.yaw
        };
        assert!((run(200) - run(4000)).abs() < 0.003, "{} {}", run(200), run(4000));
    }
}
