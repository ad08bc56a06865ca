//! What nuScenes says of an object.

use crate::Label;
use endless_annotate::{Action, ActorRecord, Box3dRecord};
use endless_world::{AgeGroup, ObjectClass};

/// Names and descriptions of categories, in the order of `category.json`.
pub(super) const CATEGORIES: [&str; 8] = [
    "vehicle.car",
    "vehicle.truck",
    "vehicle.bus.rigid",
    "vehicle.motorcycle",
    "vehicle.bicycle",
    "human.pedestrian.adult",
    "human.pedestrian.child",
    "human.pedestrian.personal_mobility",
];

/// Attributes, in the order of `attribute.json`.
pub(super) const ATTRIBUTES: [&str; 8] = [
    "vehicle.moving",
    "vehicle.stopped",
    "vehicle.parked",
    "cycle.with_rider",
    "cycle.without_rider",
    "pedestrian.sitting_lying_down",
    "pedestrian.standing",
    "pedestrian.moving",
];

/// Slower than this it stands, m/s.
const STANDS_MPS: f64 = 0.2;

/// The category of an object.
pub(super) fn category(label: &Label, actor: Option<&ActorRecord>) -> &'static str {
    match label.object.class {
        ObjectClass::Car | ObjectClass::Van => "vehicle.car",
        ObjectClass::Truck => "vehicle.truck",
        ObjectClass::Bus => "vehicle.bus.rigid",
        ObjectClass::Motorcycle => "vehicle.motorcycle",
        ObjectClass::Bicycle => "vehicle.bicycle",
        ObjectClass::Rider => "human.pedestrian.personal_mobility",
        ObjectClass::Pedestrian => {
            let child = actor.and_then(|a| a.person.as_ref()).is_some_and(|p| p.age_group == AgeGroup::Child);
            if child { "human.pedestrian.child" } else { "human.pedestrian.adult" }
        }
    }
}

/// What it is doing.
pub(super) fn attribute(label: &Label) -> &'static str {
    let object = &label.object;
    let moves = object.speed_mps > STANDS_MPS;
    match object.class {
        ObjectClass::Motorcycle | ObjectClass::Bicycle if object.rider_id.is_some() => "cycle.with_rider",
        ObjectClass::Motorcycle | ObjectClass::Bicycle => "cycle.without_rider",
        ObjectClass::Pedestrian | ObjectClass::Rider => match object.activity.action {
            Some(Action::Sitting) => "pedestrian.sitting_lying_down",
            _ if moves => "pedestrian.moving",
            _ => "pedestrian.standing",
        },
        _ if object.parked => "vehicle.parked",
        _ if moves => "vehicle.moving",
        _ => "vehicle.stopped",
    }
}

/// Bin of what can be seen: to 40, 60, 80 and 100 %.
pub(super) fn visibility_level(visibility: f64) -> &'static str {
    match visibility {
        v if v <= 0.4 => "1",
        v if v <= 0.6 => "2",
        v if v <= 0.8 => "3",
        _ => "4",
    }
}

/// The box of an object; of a two-wheeler with its rider that of both.
pub(super) fn box_in_world(label: &Label) -> Option<&Box3dRecord> {
    let both = label.object.with_rider.as_ref().and_then(|both| both.box3d.as_ref());
    both.or(label.object.spatial.as_ref().map(|spatial| &spatial.box3d))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn visibility_has_four_bins() {
        assert_eq!(
            [0.0, 0.4, 0.41, 0.6, 0.7, 0.8, 0.81, 1.0].map(visibility_level),
            ["1", "1", "2", "2", "3", "3", "4", "4"]
        );
    }
}
