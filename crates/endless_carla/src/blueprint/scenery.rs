//! What is neither a vehicle, a walker, a sensor nor a prop.

use super::attribute::{floats, role_name};
use super::entry::Blueprint;
use super::kind::BlueprintKind;
use crate::wire::{ActorAttribute, BoundingBox, Vector3D};
use endless_world::ClassTag;

/// What clients may spawn.
pub(super) fn spawnable() -> Vec<Blueprint> {
    vec![
        plain("controller.ai.walker", BlueprintKind::WalkerController, Vec::new()),
        friction(),
        plain("util.actor.empty", BlueprintKind::Empty, Vec::new()),
    ]
}

/// What only a server spawns: clients see it as actors, not as blueprints.
pub(super) fn of_the_server() -> Vec<Blueprint> {
    let sign = |id: &str| plain(id, BlueprintKind::TrafficSign, vec![ClassTag::TrafficSigns]);
    let mut blueprints = vec![
        plain("spectator", BlueprintKind::Spectator, Vec::new()),
        plain("traffic.traffic_light", BlueprintKind::TrafficLight, vec![ClassTag::TrafficLight]),
        sign("traffic.stop"),
        sign("traffic.yield"),
        sign("traffic.unknown"),
    ];
    // Kilometres an hour.
    blueprints.extend((1..=13).map(|tens| sign(&format!("traffic.speed_limit.{}", 10 * tens))));
    blueprints
}

fn plain(id: &str, kind: BlueprintKind, tags: Vec<ClassTag>) -> Blueprint {
    Blueprint::new(id, vec![role_name(&["default"])], kind, BoundingBox::default(), tags)
}

/// A box in which tyres grip otherwise; its extents, centimetres, are in the attributes.
fn friction() -> Blueprint {
    let mut attributes: Vec<ActorAttribute> = vec![role_name(&["default"])];
    attributes.extend(floats(&["friction"], "3.5"));
    attributes.extend(floats(&["extent_x", "extent_y", "extent_z"], "1.0"));
    let extent = Vector3D { x: 1.0, y: 1.0, z: 1.0 };
    let bounding_box = BoundingBox { extent, ..BoundingBox::default() };
    Blueprint::new("static.trigger.friction", attributes, BlueprintKind::FrictionTrigger, bounding_box, Vec::new())
}
