//! Camera sites of the built-in towns, as [`super::load`] finds them with the built-in catalogue: plans need no town then.
//! A test compares both; `UPDATE_CAMERAS=1 cargo test -p endless_town` writes the file anew.

use endless_world::CameraSite;
use std::collections::BTreeMap;

const FILE: &str = include_str!("cameras.json");

/// Camera sites of a built-in town with the built-in catalogue, without making the town; `None` of others.
pub fn known_cameras(name: &str) -> Option<Vec<CameraSite>> {
    let mut towns: BTreeMap<String, Vec<CameraSite>> = serde_json::from_str(FILE).ok()?;
    towns.remove(super::canonical_name(name).ok()?)
}
