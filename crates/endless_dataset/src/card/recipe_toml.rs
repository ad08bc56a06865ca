//! A resolved recipe as a file that makes it again.

use crate::{Recipe, RecipeDraft, UserCamera};
use serde_json::{Map, Value, json};

/// The TOML file whose recipe this is. What lies in other files is told in comments: imported maps, models and recorded motion.
pub fn recipe_toml(recipe: &Recipe) -> String {
    let mut text = String::new();
    for (name, hash) in &recipe.map_files {
        text += &format!("# Needs the map {name}, imported from the file with BLAKE3 hash {hash}.\n");
    }
    if !recipe.asset_files.is_empty() {
        text += "# Needs assets = \"FOLDER\" with files of these BLAKE3 hashes:\n";
        text.extend(recipe.asset_files.iter().map(|(name, hash)| format!("#   {name}: {hash}\n")));
    }
    if let Some(hash) = &recipe.traffic_file {
        text += &format!("# Needs traffic = \"FILE\", the file with BLAKE3 hash {hash}.\n");
    }
    let mut draft = draft(recipe);
    if draft.seed.is_some_and(|seed| i64::try_from(seed).is_err()) {
        draft.seed = None;
        text += &format!("# No number of TOML: --seed {}\n", recipe.seed);
    }
    text + &toml::to_string(&draft).expect("numbers, words and tables of them")
}

/// The options that give this recipe, all of them told.
fn draft(recipe: &Recipe) -> RecipeDraft {
    let Ok(Value::Object(mut fields)) = serde_json::to_value(recipe) else {
        unreachable!("a recipe is a plain struct")
    };
    for files in ["map_files", "asset_files", "traffic_file", "cameras"] {
        fields.remove(files);
    }
    put_density(recipe, &mut fields);
    // What a recipe leaves out is clean, and what a draft leaves out is natural.
    fields.insert("camera_look".into(), json!(recipe.camera_look));
    let mut draft: RecipeDraft =
        serde_json::from_value(Value::Object(fields)).expect("fields are options of the same names");
    if !recipe.cameras.is_empty() {
        draft.cameras = Some(user_cameras(recipe));
    }
    draft
}

/// How busy the streets are, where no numbers are asked for.
fn put_density(recipe: &Recipe, fields: &mut Map<String, Value>) {
    let density = &recipe.density;
    if density.vehicles.is_some() {
        fields.remove("vehicles");
    }
    if density.pedestrians.is_some() {
        fields.remove("pedestrians");
    }
    if let Some(word) = density.vehicles.or(density.pedestrians) {
        fields.insert("density".into(), json!(word));
    }
}

/// Cameras in metres and degrees that come back to the same single-precision numbers.
fn user_cameras(recipe: &Recipe) -> Vec<UserCamera> {
    let sites = recipe.cameras.iter().flat_map(|(map, sites)| sites.iter().map(move |site| (map, site)));
    sites
        .map(|(map, site)| UserCamera {
            map: map.clone(),
            name: site.name.clone(),
            position: site.position.map(|metres| shortest(metres.into(), |short| short as f32 == metres)),
            yaw: degrees(site.yaw_rad),
            down: degrees(site.down_tilt_rad),
            fov: Some(degrees(site.horizontal_fov_rad)),
            lens: site.lens,
        })
        .collect()
}

fn degrees(rad: f32) -> f64 {
    shortest(f64::from(rad).to_degrees(), |short| short.to_radians() as f32 == rad)
}

/// The number with the fewest digits that is as good.
fn shortest(exact: f64, is_as_good: impl Fn(f64) -> bool) -> f64 {
    let rounded = |digits: i32| (exact * 10f64.powi(digits)).round() / 10f64.powi(digits);
    (0..12).map(rounded).find(|short| is_as_good(*short)).unwrap_or(exact)
}
