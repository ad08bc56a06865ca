//! How tyres grip where they are.

use super::actor::Body;
use super::episode::Episode;

impl Episode {
    /// Vehicles that have come into a box, or have left it, grip otherwise. Of two boxes the newer one counts.
    pub(super) fn feel_friction(&mut self) {
        let boxes = self.actors.values().filter_map(|actor| match &actor.body {
            Body::FrictionTrigger(trigger) => Some((trigger.outline(&actor.transform), trigger.friction())),
            _ => None,
        });
        let boxes: Vec<_> = boxes.collect();
        for actor in self.actors.values_mut() {
            if let Body::Vehicle(vehicle) = &mut actor.body {
                let outline = vehicle.body.outline();
                let here = boxes.iter().rev().find(|(bounds, _)| outline.touches(bounds));
                vehicle.body.set_friction_here(here.map(|(_, friction)| *friction));
            }
        }
    }
}
