//! The JSON schema of recipes, from the declaration of their options.

use super::{
    option::{OptionDefault, OptionKind, RecipeOption},
    options::RecipeDraft,
    rig::{ModelSpec, MountSpec},
};
use endless_world::LensModel;
use serde_json::{Value, json};

/// The schema of a recipe (JSON Schema, draft 2020-12): editors complete and check TOML files by it.
pub fn recipe_schema() -> Value {
    let defaults = serde_json::to_value(RecipeDraft::defaults()).expect("numbers and words");
    let properties: serde_json::Map<String, Value> = RecipeDraft::OPTIONS
        .iter()
        .map(|option| {
            let mut schema = kind_schema(option);
            schema["description"] = match option.default {
                OptionDefault::Value(_) => json!(option.help),
                OptionDefault::Described(text) => json!(format!("{} Default: {text}.", option.help)),
            };
            if let Some(default) = defaults.get(option.key) {
                schema["default"] = default.clone();
            }
            (option.key.to_owned(), schema)
        })
        .collect();
    json!({
        "$schema": "https://json-schema.org/draft/2020-12/schema",
        "title": "Recipe of an ENDLESS dataset",
        "type": "object",
        "additionalProperties": false,
        "properties": properties,
    })
}

fn lens_schema() -> Value {
    json!({"anyOf": [{"enum": LensModel::NAMES}, {
        "type": "object",
        "additionalProperties": false,
        "required": ["model"],
        "properties": {
            "model": {"enum": LensModel::NAMES},
            "k": {"type": "array", "items": {"type": "number"}, "minItems": 4, "maxItems": 4},
            "width": {"type": "number", "minimum": 0.1, "maximum": 10_000},
        },
    }]})
}

fn kind_schema(option: &RecipeOption) -> Value {
    match option.kind {
        OptionKind::Whole { least, most } => json!({"type": "integer", "minimum": least, "maximum": most}),
        OptionKind::Number { least, most } => json!({"type": "number", "minimum": least, "maximum": most}),
        OptionKind::Size { .. } => json!({"type": "string", "pattern": "^[1-9][0-9]{0,3}x[1-9][0-9]{0,3}$"}),
        OptionKind::Word(vocabulary) => json!({"enum": (vocabulary.words)()}),
        OptionKind::Words(vocabulary) => {
            json!({"type": "array", "items": {"enum": (vocabulary.words)()}, "minItems": 1})
        }
        OptionKind::WordsOrNone(vocabulary) => {
            let words: Vec<&str> = (vocabulary.words)().into_iter().chain(["none"]).collect();
            json!({"type": "array", "items": {"enum": words}})
        }
        OptionKind::Maps => json!({"type": "array", "items": {"type": "string"}, "minItems": 1}),
        OptionKind::Cameras => json!({"type": "array", "items": {
            "type": "object",
            "additionalProperties": false,
            "required": ["map", "name", "position", "yaw", "down"],
            "properties": {
                "map": {"type": "string"},
                "name": {"type": "string", "pattern": "^[A-Za-z0-9_-]{1,64}$"},
                "position": {"type": "array", "items": {"type": "number"}, "minItems": 3, "maxItems": 3},
                "yaw": {"type": "number", "minimum": -360, "maximum": 360},
                "down": {"type": "number", "minimum": -10, "maximum": 90},
                "fov": {"type": "number", "minimum": 1, "maximum": 360},
                "lens": lens_schema(),
            },
        }}),
        OptionKind::Rig => json!({"type": "array", "items": {
            "type": "object",
            "required": ["name", "type", "mount"],
            "properties": {
                "name": {"type": "string", "pattern": "^[A-Za-z0-9_-]{1,64}$"},
                "type": {"enum": ModelSpec::TYPES},
                "rate": {"type": "number", "exclusiveMinimum": 0},
                "mount": {
                    "type": "object",
                    "required": ["on"],
                    "properties": {"on": {"enum": MountSpec::WORDS}},
                },
            },
        }}),
        OptionKind::Lines => {
            let place = json!({"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2});
            json!({"type": "array", "items": {
                "type": "object",
                "additionalProperties": false,
                "required": ["map", "name", "from", "to"],
                "properties": {"map": {"type": "string"}, "name": {"type": "string"}, "from": place, "to": place},
            }})
        }
        OptionKind::Place => json!({"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}),
        OptionKind::Folder | OptionKind::File | OptionKind::Text => json!({"type": "string"}),
        OptionKind::Switch => json!({"type": "boolean"}),
    }
}
