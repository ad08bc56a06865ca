//! Settings as tables of JSON, to and fro.

use serde::{Serialize, de::DeserializeOwned};
use serde_json::{Map, Value};

/// A value of settings, or what is wrong with it on one line.
pub(super) fn value<T: DeserializeOwned>(given: impl Into<Value>) -> Result<T, String> {
    serde_json::from_value(given.into()).map_err(|wrong| wrong.to_string().replace('\n', " "))
}

/// A plain struct as the table that it is written as; what is not given is left out.
pub(super) fn fields(of: &impl Serialize) -> Map<String, Value> {
    match serde_json::to_value(of) {
        Ok(Value::Object(fields)) => fields.into_iter().filter(|(_, value)| !value.is_null()).collect(),
        _ => unreachable!("settings are plain structs"),
    }
}
