//! Road users and signals on the map, from above.

use endless_asset::Catalogue;
use endless_road::TrafficControl;
use endless_town::{Town, top_view_of, whole_town};
use endless_world::math::sin_cos;
use endless_world::{
    Actor, Image, ImageSize, Motion, ObjectClass, SignalAspect, VehicleLights, VehicleSpec, WorldState,
};
use glam::Vec2;

/// Half of the least length and width in which somebody is drawn, pixels.
const LEAST: f32 = 1.5;
/// Half a person's breadth, and radius of a signal's dot, metres.
const PERSON_M: f32 = 0.35;
const SIGNAL_M: f32 = 0.9;
const NOSE: [u8; 3] = [250, 250, 255];
const BRAKES: [u8; 3] = [255, 40, 30];

/// A town as a plan on which instants are drawn.
#[derive(Debug)]
pub struct TopView {
    plan: Image<[u8; 3]>,
    middle: Vec2,
    /// Pixels a metre.
    scale: f32,
    specs: Vec<VehicleSpec>,
    /// Ends of lanes that signals govern, with their signal group.
    lights: Vec<(Vec2, usize)>,
}

impl TopView {
    /// Of a whole town, on `pixels` by `pixels`.
    pub fn new(town: &Town, catalogue: &Catalogue, pixels: u32) -> Self {
        let (middle, metres) = whole_town(town);
        let size = ImageSize { width: pixels, height: pixels };
        let lights = town.network.lanes.iter().filter_map(|lane| {
            let TrafficControl::Signal(signal) = lane.end_control else { return None };
            let end = lane.centerline.position(lane.centerline.length());
            Some((end.as_vec3().truncate(), usize::from(signal.0)))
        });
        Self {
            plan: Image { size, data: top_view_of(town, catalogue, pixels, middle, metres) },
            middle,
            scale: pixels as f32 / metres,
            specs: catalogue.vehicle_specs(),
            lights: lights.collect(),
        }
    }

    /// An instant: vehicles in a colour for each class, with a bright nose and brake lights, people as dots, and signals.
    ///
    /// # Panics
    /// If a vehicle's model is not in the catalogue.
    pub fn draw(&self, state: &WorldState) -> Image<[u8; 3]> {
        let mut image = self.plan.clone();
        for &(at, signal) in &self.lights {
            let color = match state.signals[signal].aspect {
                SignalAspect::Red => [255, 40, 40],
                SignalAspect::Green => [60, 230, 70],
                SignalAspect::Yellow | SignalAspect::RedYellow => [255, 200, 0],
            };
            self.fill(&mut image, at, Vec2::X, Vec2::splat(SIGNAL_M), color);
        }
        state.actors.iter().for_each(|actor| self.draw_actor(&mut image, actor));
        image
    }

    fn draw_actor(&self, image: &mut Image<[u8; 3]>, actor: &Actor) {
        let at = actor.pose.position.truncate();
        let (sin, cos) = sin_cos(actor.pose.yaw_rad);
        let ahead = Vec2::new(cos, sin);
        let (Some(vehicle), Motion::Vehicle(motion)) = (actor.asset.vehicle(), actor.motion) else {
            self.fill(image, at, ahead, Vec2::splat(PERSON_M), color_of(actor.class));
            return;
        };
        let spec = &self.specs[vehicle.model.index()];
        let half = Vec2::new(spec.length_m, spec.width_m) * 0.5;
        self.fill(image, at, ahead, half, color_of(actor.class));
        let end = Vec2::new(0.12 * half.x, half.y);
        self.fill(image, at + ahead * (half.x - end.x), ahead, end, NOSE);
        if motion.lights.contains(VehicleLights::BRAKE) {
            self.fill(image, at - ahead * (half.x - end.x), ahead, end, BRAKES);
        }
    }

    /// Fills a rectangle around a place, with its half sizes along and across a unit vector, metres.
    fn fill(&self, image: &mut Image<[u8; 3]>, at: Vec2, ahead: Vec2, half: Vec2, color: [u8; 3]) {
        let side = image.size.width as f32;
        let middle = (at - self.middle) * self.scale;
        let (x, y) = (0.5 * side + middle.x, 0.5 * side - middle.y);
        let half = (half * self.scale).max(Vec2::splat(LEAST));
        let reach = half.length();
        let range = |from: f32| {
            let (low, high) = ((from - reach).floor().max(0.0), (from + reach).ceil().min(side - 1.0));
            low as usize..(high + 1.0).max(low) as usize
        };
        for row in range(y) {
            for column in range(x) {
                // Rows go south.
                let beside = Vec2::new(column as f32 + 0.5 - x, y - row as f32 - 0.5);
                let across = Vec2::new(beside.dot(ahead), beside.dot(ahead.perp()));
                if across.abs().cmple(half).all() {
                    image.data[row * image.size.width as usize + column] = color;
                }
            }
        }
    }
}

fn color_of(class: ObjectClass) -> [u8; 3] {
    match class {
        ObjectClass::Car => [70, 150, 255],
        ObjectClass::Van => [120, 110, 255],
        ObjectClass::Truck => [255, 140, 40],
        ObjectClass::Bus => [255, 215, 50],
        ObjectClass::Motorcycle => [240, 70, 200],
        ObjectClass::Bicycle => [60, 235, 190],
        ObjectClass::Rider | ObjectClass::Pedestrian => [255, 90, 120],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_world::{AssetRef, Behaviour, InstanceId, Outfit, PersonRef, Pose, WalkerMotion};
    use glam::Vec3;

    #[test]
    fn somebody_is_drawn_where_they_are() {
        let catalogue = Catalogue::builtin();
        let town = endless_town::load("Town02", &catalogue).expect("a town");
        let view = TopView::new(&town, &catalogue, 200);
        let person = |at: Vec3| Actor {
            id: InstanceId(1),
            rider_id: None,
            class: ObjectClass::Pedestrian,
            asset: AssetRef::from(PersonRef { outfit: Outfit::Fair, seed: 0 }),
            pose: Pose::level(at, 0.0),
            velocity_mps: Vec3::ZERO,
            motion: Motion::Walker(WalkerMotion::default()),
            behaviour: Behaviour::default(),
            parked: false,
        };
        let signals = Vec::from([endless_world::SignalState { aspect: SignalAspect::Red }; 1])
            .repeat(usize::from(town.network.signal_groups));
        let draw =
            |actors: Vec<Actor>| view.draw(&WorldState { frame: 0, time_s: 0.0, actors, signals: signals.clone() });
        let (without, with) =
            (draw(Vec::new()), draw(vec![person(view.middle.extend(0.0) + Vec3::new(0.0, 10.0, 0.0))]));
        let changed: Vec<usize> = (0..without.data.len()).filter(|&i| without.data[i] != with.data[i]).collect();
        let north = 100.0 - 10.0 * view.scale;
        assert!(!changed.is_empty() && changed.len() < 30, "{} pixels", changed.len());
        for pixel in changed {
            let (x, y) = ((pixel % 200) as f32 + 0.5, (pixel / 200) as f32 + 0.5);
            assert!((x - 100.0).abs() < 3.0 && (y - north).abs() < 3.0, "({x}, {y})");
        }
        // Far outside there is nothing to draw on.
        assert_eq!(draw(vec![person(Vec3::new(1e6, -1e6, 0.0))]), without);
    }
}
