//! Lists in files of their own, TOML or JSON: cameras, rigs.

use crate::{RecipeError, text_position::line_and_column};
use serde::de::DeserializeOwned;
use std::{fs, path::Path};

/// Reads a file that has a rig, or whatever it is: JSON if its name ends so, else TOML.
///
/// # Errors
/// [`RecipeError::Unreadable`], or [`RecipeError::Malformed`] with the place.
pub(crate) fn read<T: DeserializeOwned>(path: &Path, what: &'static str) -> Result<T, RecipeError> {
    let unreadable = |cause| RecipeError::Unreadable { what, path: path.to_owned(), cause };
    let text = fs::read_to_string(path).map_err(unreadable)?;
    from_text(&text, path)
}

/// Reads the text of a file at this path.
///
/// # Errors
/// [`RecipeError::Malformed`] with the place.
pub(crate) fn from_text<T: DeserializeOwned>(text: &str, path: &Path) -> Result<T, RecipeError> {
    let wrong =
        |(line, column, message): ParseFailure| RecipeError::Malformed { path: path.to_owned(), line, column, message };
    let json = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("json"));
    parse(text, json).map_err(wrong)
}

/// What a text of JSON or TOML says.
pub(crate) fn parse<T: DeserializeOwned>(text: &str, json: bool) -> Result<T, ParseFailure> {
    if json { from_json(text) } else { from_toml(text) }
}

/// Line and column, from 1, and what is wrong there.
pub(crate) type ParseFailure = (usize, usize, String);

fn from_json<T: DeserializeOwned>(text: &str) -> Result<T, ParseFailure> {
    serde_json::from_str(text).map_err(|e| {
        // The message ends with the place.
        let message = e.to_string();
        let message = message.split(" at line ").next().unwrap_or_default().replace('\n', " ");
        (e.line().max(1), e.column().max(1), message)
    })
}

fn from_toml<T: DeserializeOwned>(text: &str) -> Result<T, ParseFailure> {
    toml::from_str(text).map_err(|e: toml::de::Error| {
        let (line, column) = line_and_column(text, e.span().map_or(0, |s| s.start));
        (line, column, e.message().lines().collect::<Vec<_>>().join(", "))
    })
}
