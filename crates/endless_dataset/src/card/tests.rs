//! Cards of the small datasets that come with the sources; `scripts/judge_card.py` reads them as catalogues do.

use super::{Card, CardFacts};
use crate::{DatasetLayout, Layer, Manifest, SensorSpec, SharedFiles, VideoState};
use serde_json::Value;
use std::{collections::BTreeSet, fs, path::Path};

fn manifest() -> Manifest {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../endless_fuzz/datasets/all_layers");
    Manifest::read(&DatasetLayout::new(root).manifest()).expect("a dataset")
}

fn croissant(manifest: &Manifest) -> Value {
    let [_, croissant] = Card::all(manifest);
    serde_json::from_str(&croissant.text).expect("JSON")
}

fn ids(of: &Value) -> BTreeSet<String> {
    of.as_array().expect("a list").iter().map(|entry| entry["@id"].as_str().expect("an id").to_owned()).collect()
}

#[test]
fn each_layer_has_files_and_records() {
    let card = croissant(&manifest());
    let (files, records) = (ids(&card["distribution"]), ids(&card["recordSet"]));
    assert_eq!(files.len(), card["distribution"].as_array().map_or(0, Vec::len), "ids are unique");
    for layer in Layer::ALL {
        assert!(files.contains(&format!("{layer}_files")) && records.contains(layer.name()), "{layer}");
    }
    // Every source is a set of files that there is.
    for source in
        card["recordSet"].as_array().expect("a list").iter().flat_map(|set| set["field"].as_array().expect("a list"))
    {
        let of = source["source"]["fileSet"]["@id"].as_str();
        assert!(of.is_none_or(|id| files.contains(id)), "{source}");
    }
}

#[test]
fn sensors_of_a_rig_have_files() {
    let mut manifest = manifest();
    let sensor = r#"[
        {"name": "front", "type": "camera", "layers": ["rgb"], "mount": {"on": "vehicle", "number": 0, "at": [0, 0, 2]}},
        {"name": "top", "type": "lidar", "mount": {"on": "vehicle", "number": 0, "at": [0, 0, 2]}}]"#;
    manifest.recipe.sensor = serde_json::from_str::<Vec<SensorSpec>>(sensor).expect("a rig");
    let before = CardFacts::new(&manifest);
    let card = croissant(&manifest);
    let of = |id: &str| {
        let sets = card["distribution"].as_array().expect("a list");
        sets.iter().find(|set| set["@id"] == id).map(|set| set["includes"].to_string())
    };
    assert!(of("rgb_files").is_some_and(|patterns| patterns.contains("videos/*/front/rgb/*.png")));
    assert!(of("depth_files").is_some_and(|patterns| !patterns.contains("front")));
    assert!(of("top_points_files").is_some_and(|patterns| patterns.contains("videos/*/top/points/*.bin")));
    manifest.recipe.sensor.clear();
    assert_eq!(before.camera_frames - CardFacts::new(&manifest).camera_frames, u64::from(manifest.recipe.frames()));
}

#[test]
fn what_is_imported_has_licences_of_its_own() {
    let mut manifest = manifest();
    let [readme, _] = Card::all(&manifest);
    assert!(readme.text.contains("\nlicense: [mit, apache-2.0]\n"));
    manifest.recipe.map_files.insert("my_town".into(), "0123".into());
    let [readme, croissant] = Card::all(&manifest);
    assert!(
        readme.text.contains("\nlicense: other\n")
            && readme.text.contains("licences of its own: imported maps (my_town)")
    );
    assert!(croissant.text.contains("imported maps (my_town)"));
}

#[test]
fn cards_follow_the_manifest_until_somebody_changes_them() {
    let folder = tempfile::tempdir().expect("temp");
    let layout = DatasetLayout::new(folder.path());
    let mut manifest = manifest();
    let text = |name: &str| fs::read_to_string(folder.path().join(name)).expect("a card");
    let write = |manifest: &Manifest| Card::write_all(&layout, manifest, &SharedFiles::alone()).expect("writable");
    write(&manifest);
    assert!(Card::all(&manifest).iter().all(|card| text(card.name) == card.text));
    manifest.videos[0].state = VideoState::Planned;
    write(&manifest);
    assert!(text("README.md").contains("ENDLESS: 1 video (0 complete), each"));
    let mine = "---\nlicense: cc-by-4.0\n---\nMine.\n";
    fs::write(folder.path().join("README.md"), mine).expect("writable");
    write(&manifest);
    assert_eq!(text("README.md"), mine);
    assert!(!Card::is_ours(&folder.path().join("README.md")) && Card::is_ours(&folder.path().join("croissant.json")));
    // As a power failure leaves it.
    fs::write(folder.path().join("README.md"), "").expect("writable");
    write(&manifest);
    assert!(text("README.md").starts_with("---\n"));
}
