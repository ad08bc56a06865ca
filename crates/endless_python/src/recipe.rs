//! The options of a recipe, as Python gives them: a JSON object of keys and values.

use crate::errors::RecipeError;
use endless_dataset::{OptionKind, RecipeDraft, RecipeOption};
use pyo3::PyResult;
use serde_json::{Map, Value};

/// A draft of these options. One word stands for a list of it, two numbers for a size.
pub(crate) fn draft(json: &str) -> PyResult<RecipeDraft> {
    let options: Map<String, Value> =
        serde_json::from_str(json).map_err(|error| RecipeError::new_err(format!("the recipe: {error}")))?;
    let mut draft = RecipeDraft::default();
    for (key, value) in options {
        let Some(option) = RecipeDraft::OPTIONS.iter().find(|option| option.key == key) else {
            let known: Vec<&str> = RecipeDraft::OPTIONS.iter().map(|option| option.key).collect();
            let message = format!("a recipe has no option '{key}': use some of {}", known.join(", "));
            return Err(RecipeError::new_err(message));
        };
        if value.is_null() {
            continue;
        }
        let given = Value::Object(Map::from_iter([(key.clone(), usual(option, value))]));
        let one: RecipeDraft = serde_json::from_value(given)
            .map_err(|error| RecipeError::new_err(format!("{key}: {error}: {}", option.help_with_words())))?;
        draft = draft.or(one);
    }
    Ok(draft)
}

/// A value as recipes have it.
fn usual(option: &RecipeOption, value: Value) -> Value {
    match (option.kind, value) {
        (OptionKind::Words(_) | OptionKind::WordsOrNone(_) | OptionKind::Maps, Value::String(words)) => {
            words.split(',').map(|word| Value::from(word.trim())).collect()
        }
        (OptionKind::Size { .. }, Value::Array(sides)) if sides.len() == 2 => {
            format!("{}x{}", sides[0], sides[1]).into()
        }
        // 30 frames a second, or 30.0; 3 videos, or 3.0.
        (OptionKind::Whole { .. }, Value::Number(number)) => match number.as_f64() {
            Some(whole) if number.is_f64() && whole.fract() == 0.0 && whole.abs() < 9e15 => (whole as i64).into(),
            _ => Value::Number(number),
        },
        (_, value) => value,
    }
}
