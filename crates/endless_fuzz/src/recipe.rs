//! Recipes and lists of cameras: what is meant, in full, or an error of one line.

use crate::mutate;
use crate::target::{FuzzTarget, one_line};
use endless_dataset::{RecipeDraft, UserCamera};
use endless_pipeline::{MapSource, RecipeError, cameras_from_text, recipe_from_text, resolve_recipe};
use std::path::Path;

/// A recipe's TOML file.
pub const RECIPE: FuzzTarget = FuzzTarget { name: "recipe", judge: recipe, mutate: mutate::text };
/// A list of cameras, read as TOML and as JSON.
pub const CAMERAS: FuzzTarget = FuzzTarget { name: "cameras", judge: cameras, mutate: mutate::text };

/// Two maps that need not be loaded.
struct TwoMaps;

impl MapSource for TwoMaps {
    fn maps(&self) -> Vec<String> {
        ["Town01", "Town02"].map(str::to_owned).to_vec()
    }
}

fn recipe(bytes: &[u8]) -> Result<(), String> {
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(()) };
    recipe_from_text(text, Path::new("recipe.toml")).map_or_else(|error| told(&error), resolve)
}

fn cameras(bytes: &[u8]) -> Result<(), String> {
    let Ok(text) = std::str::from_utf8(bytes) else { return Ok(()) };
    ["cameras.toml", "cameras.json"].into_iter().try_for_each(|name| {
        let hang = |cameras: Vec<UserCamera>| resolve(RecipeDraft { cameras: Some(cameras), ..RecipeDraft::default() });
        cameras_from_text(text, Path::new(name)).map_or_else(|error| told(&error), hang)
    })
}

/// A recipe in full says the same when it is written and read again.
fn resolve(draft: RecipeDraft) -> Result<(), String> {
    let recipe = match resolve_recipe(draft, &TwoMaps) {
        Ok(recipe) => recipe,
        Err(error) => return told(&error),
    };
    let text = serde_json::to_string(&recipe).map_err(|error| format!("cannot be written: {error}"))?;
    let again = serde_json::from_str(&text).map_err(|error| format!("as written: {error}"))?;
    if recipe == again { Ok(()) } else { Err(format!("another recipe as written: {text}")) }
}

fn told(error: &RecipeError) -> Result<(), String> {
    one_line(error)
}
