//! What a method gives back, in CARLA's wrappers.

use crate::wire::{Wire, WireError};
use rmpv::Value;

/// What a method gives back.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer {
    /// Of methods that give something.
    Value(Value),
    /// Of methods that give nothing.
    Void,
    /// Without a wrapper: `apply_batch` alone.
    Bare(Value),
    /// The client raises it as a `RuntimeError` of this text.
    Failure(String),
}

impl Answer {
    /// A value.
    pub fn of(value: &impl Wire) -> Self {
        Self::Value(value.to_value())
    }

    /// A message of a response: `[1, call id, nil, result]`.
    pub fn into_message(self, call_id: u32) -> Vec<u8> {
        let result = match self {
            Self::Value(value) => success(value),
            Self::Void => Value::Array(vec![Value::Array(vec![Value::Boolean(false)])]),
            Self::Bare(value) => value,
            Self::Failure(text) => failure(&text),
        };
        let message = Value::Array(vec![Value::from(1), Value::from(call_id), Value::Nil, result]);
        let mut bytes = Vec::new();
        // Nothing can go wrong in memory.
        let _ = rmpv::encode::write_value(&mut bytes, &message);
        bytes
    }
}

impl From<WireError> for Answer {
    fn from(error: WireError) -> Self {
        Self::Failure(error.to_string())
    }
}

/// `Response<T>`: `[[1, value]]`.
pub(crate) fn success(value: Value) -> Value {
    Value::Array(vec![Value::Array(vec![Value::from(1), value])])
}

/// `[[0, [text]]]`, which clients understand in every place.
pub(crate) fn failure(text: &str) -> Value {
    Value::Array(vec![Value::Array(vec![Value::from(0), Value::Array(vec![Value::from(text)])])])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn answers_are_those_that_the_official_client_understands() {
        let version = Answer::of(&"0.9.16".to_owned()).into_message(7);
        assert_eq!(version, [&[0x94, 1, 7, 0xc0, 0x91, 0x92, 1, 0xa6][..], b"0.9.16"].concat());
        assert_eq!(Answer::of(&false).into_message(7), [0x94, 1, 7, 0xc0, 0x91, 0x92, 1, 0xc2]);
        assert_eq!(Answer::Void.into_message(7), [0x94, 1, 7, 0xc0, 0x91, 0x91, 0xc2]);
        let failed = Answer::Failure("no".to_owned()).into_message(7);
        assert_eq!(failed, [0x94, 1, 7, 0xc0, 0x91, 0x92, 0, 0x91, 0xa2, b'n', b'o']);
    }
}
