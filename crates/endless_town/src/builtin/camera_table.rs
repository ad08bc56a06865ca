//! Camera sites of the built-in towns, as [`super::load`] finds them with the built-in catalogue: plans need no town then.
//! A test compares both; `UPDATE_CAMERAS=1 cargo test -p endless_town` writes the file anew.

use endless_world::CameraSite;
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// By name of the town.
static TOWNS: LazyLock<BTreeMap<String, Vec<CameraSite>>> =
    LazyLock::new(|| serde_json::from_str(include_str!("cameras.json")).unwrap_or_default());

/// Camera sites of a built-in town with the built-in catalogue, without making the town; `None` of others.
pub fn known_cameras(name: &str) -> Option<Vec<CameraSite>> {
    TOWNS.get(&super::canonical_name(name).ok()?).cloned()
}
