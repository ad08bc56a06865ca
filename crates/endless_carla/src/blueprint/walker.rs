//! Walkers.

use super::attribute::{choice, fixed, restricted, role_name, switch, word};
use super::entry::Blueprint;
use super::kind::{BlueprintKind, WalkerBlueprint};
use crate::wire::{ActorAttribute, AttributeType, BoundingBox, Vector3D};
use endless_asset::Catalogue;
use endless_world::{ClassTag, Outfit, PersonRef, Sex};

/// CARLA's figures of a walker.
struct Facts {
    child: bool,
    /// Half of the box, metres.
    extent: [f32; 3],
    speeds_mps: [f32; 3],
    generation: u8,
}

/// Of `walker.pedestrian.` and this number.
const fn facts(number: u32) -> Facts {
    let child = matches!(number, 9..=14 | 48 | 49);
    let extent = match number {
        9..=11 | 48 | 49 => [0.25, 0.25, 0.55],
        12..=14 => [0.187_679, 0.187_679, 0.65],
        _ => [0.187_679, 0.187_679, 0.93],
    };
    let speeds_mps = match number {
        9..=14 | 48..=50 => [0.0, 1.1, 2.0],
        51 => [0.0, 0.85, 2.0],
        1 | 5..=8 | 15 => [0.0, 1.8, 4.0],
        _ => [0.0, 1.7, 4.0],
    };
    // CARLA tells the generation only to its clients; scripts ask for one of the two, and get some of either here.
    Facts { child, extent, speeds_mps, generation: if number <= 14 { 1 } else { 2 } }
}

/// CARLA's walkers that have a body here: all of them.
pub(super) fn blueprints() -> impl Iterator<Item = Blueprint> {
    let (_, walkers) = Catalogue::carla_ids();
    walkers.into_iter().filter_map(|id| blueprint(&id))
}

fn blueprint(id: &str) -> Option<Blueprint> {
    let facts = facts(id.rsplit('.').next()?.parse().ok()?);
    let person = Catalogue::carla_walker(id)?;
    let walker = WalkerBlueprint {
        person,
        person_in_wheelchair: Catalogue::carla_walker_in_wheelchair(id),
        sex: Catalogue::person_attributes(PersonRef { outfit: Outfit::Fair, seed: person }).sex,
        child: facts.child,
        speeds_mps: facts.speeds_mps,
        origin_height_m: facts.extent[2],
    };
    let [x, y, z] = facts.extent;
    let bounding_box = BoundingBox { extent: Vector3D { x, y, z }, ..BoundingBox::default() };
    let attributes = attributes(&walker, facts.generation);
    Some(Blueprint::new(id, attributes, BlueprintKind::Walker(walker), bounding_box, vec![ClassTag::Pedestrians]))
}

fn attributes(walker: &WalkerBlueprint, generation: u8) -> Vec<ActorAttribute> {
    use AttributeType::{Bool, Float, Int, String};
    let speeds = walker.speeds_mps.map(|speed| format!("{speed:?}"));
    let sex = match walker.sex {
        Sex::Female => "female",
        Sex::Male => "male",
    };
    let wheelchair = walker.person_in_wheelchair.is_some();
    vec![
        role_name(&["pedestrian"]),
        choice("speed", Float, &speeds.each_ref().map(std::string::String::as_str)),
        switch("is_invincible", true),
        fixed("gender", String, sex),
        fixed("age", String, if walker.child { "child" } else { "adult" }),
        fixed("generation", Int, generation.to_string()),
        fixed("can_use_wheelchair", Bool, word(wheelchair)),
        restricted("use_wheelchair", Bool, if wheelchair { &["false", "true"] } else { &["false"] }),
    ]
}
