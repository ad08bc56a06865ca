//! The table of the built-in towns' cameras.

use super::towns;
use endless_town::known_cameras;
use endless_world::CameraSite;
use std::{collections::BTreeMap, fs, path::Path};

#[test]
fn the_table_has_the_cameras_that_towns_have() {
    if std::env::var_os("UPDATE_CAMERAS").is_some() {
        let table: BTreeMap<&str, &[CameraSite]> = towns().iter().map(|t| (t.name.as_str(), &*t.cameras)).collect();
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/builtin/cameras.json");
        fs::write(path, serde_json::to_string_pretty(&table).expect("numbers and names") + "\n").expect("writable");
        return;
    }
    for town in towns() {
        let advice = "cameras have changed: UPDATE_CAMERAS=1 cargo test -p endless_town";
        assert_eq!(known_cameras(&town.name).as_ref(), Some(&town.cameras), "{advice}");
    }
    assert_eq!(known_cameras("Town01_Opt"), known_cameras("Town01"));
    assert_eq!(known_cameras("Atlantis"), None);
}
