//! How Rust values become msgpack values and back.
//!
//! CARLA's peers are lenient, and so is this: arrays may be shorter than a struct (what is missing has its default) or longer
//! (what is too much is ignored), numbers may have any width, bytes may come as text.

use rmpv::Value;
use std::fmt;

/// What CARLA's wire can carry.
pub trait Wire: Sized {
    /// As msgpack.
    fn to_value(&self) -> Value;

    /// From msgpack.
    ///
    /// # Errors
    /// When the value has another shape.
    fn from_value(value: &Value) -> Result<Self, WireError>;
}

/// A value has another shape than it must have.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub struct WireError {
    /// What was expected.
    pub expected: String,
    /// What was there, shortened.
    pub actual: String,
}

impl fmt::Display for WireError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected {}, got {}", self.expected, self.actual)
    }
}

impl WireError {
    /// Tells what was there in place of what was expected.
    pub fn new(expected: impl Into<String>, actual: &Value) -> Self {
        Self { expected: expected.into(), actual: kind(actual).to_owned() }
    }
}

fn kind(value: &Value) -> &'static str {
    match value {
        Value::Nil => "nil",
        Value::Boolean(_) => "a bool",
        Value::Integer(_) => "an integer",
        Value::F32(_) | Value::F64(_) => "a float",
        Value::String(_) => "a string",
        Value::Binary(_) => "bytes",
        Value::Array(_) => "an array",
        Value::Map(_) => "a map",
        Value::Ext(..) => "an extension",
    }
}

/// The elements of an array.
pub(crate) fn array<'a>(value: &'a Value, of: &str) -> Result<&'a [Value], WireError> {
    value.as_array().map(Vec::as_slice).ok_or_else(|| WireError::new(format!("an array ({of})"), value))
}

/// An array's element that must be there.
pub(crate) fn element<'a>(values: &'a [Value], index: usize, of: &str) -> Result<&'a Value, WireError> {
    let missing = || WireError { expected: format!("element {index} of {of}"), actual: "a shorter array".to_owned() };
    values.get(index).ok_or_else(missing)
}

macro_rules! wire_integer {
    ($($type:ty),*) => {$(
        impl Wire for $type {
            fn to_value(&self) -> Value {
                Value::from(*self)
            }

            fn from_value(value: &Value) -> Result<Self, WireError> {
                let number = value.as_i64().map(i128::from).or_else(|| value.as_u64().map(i128::from));
                let wrong = || WireError::new(concat!("an integer (", stringify!($type), ")"), value);
                number.and_then(|number| Self::try_from(number).ok()).ok_or_else(wrong)
            }
        }
    )*};
}
wire_integer!(u8, u16, u32, u64, i32, i64);

impl Wire for f32 {
    fn to_value(&self) -> Value {
        Value::F32(*self)
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        f64::from_value(value).map(|number| number as f32)
    }
}

impl Wire for f64 {
    fn to_value(&self) -> Value {
        Value::F64(*self)
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        value.as_f64().ok_or_else(|| WireError::new("a number", value))
    }
}

impl Wire for bool {
    fn to_value(&self) -> Value {
        Value::Boolean(*self)
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        value.as_bool().ok_or_else(|| WireError::new("a bool", value))
    }
}

impl Wire for String {
    fn to_value(&self) -> Value {
        Value::from(self.as_str())
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        value.as_str().map(str::to_owned).ok_or_else(|| WireError::new("a string", value))
    }
}

/// Bytes: `bin`, or text where somebody sends that.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Bytes(pub Vec<u8>);

impl Wire for Bytes {
    fn to_value(&self) -> Value {
        Value::Binary(self.0.clone())
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        match value {
            Value::Binary(bytes) => Ok(Self(bytes.clone())),
            Value::String(text) => Ok(Self(text.as_bytes().to_vec())),
            _ => Err(WireError::new("bytes", value)),
        }
    }
}

impl<T: Wire> Wire for Box<T> {
    fn to_value(&self) -> Value {
        self.as_ref().to_value()
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        T::from_value(value).map(Self::new)
    }
}

impl<T: Wire> Wire for Vec<T> {
    fn to_value(&self) -> Value {
        Value::Array(self.iter().map(Wire::to_value).collect())
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        array(value, "list")?.iter().map(T::from_value).collect()
    }
}

/// `optional<T>`: `[false]`, or `[true, value]`.
impl<T: Wire> Wire for Option<T> {
    fn to_value(&self) -> Value {
        Value::Array(match self {
            None => vec![Value::Boolean(false)],
            Some(own) => vec![Value::Boolean(true), own.to_value()],
        })
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        let values = array(value, "optional")?;
        match bool::from_value(element(values, 0, "an optional")?)? {
            true => T::from_value(element(values, 1, "an optional")?).map(Some),
            false => Ok(None),
        }
    }
}

/// `pair<A, B>`.
impl<A: Wire, B: Wire> Wire for (A, B) {
    fn to_value(&self) -> Value {
        Value::Array(vec![self.0.to_value(), self.1.to_value()])
    }

    fn from_value(value: &Value) -> Result<Self, WireError> {
        let values = array(value, "pair")?;
        Ok((A::from_value(element(values, 0, "a pair")?)?, B::from_value(element(values, 1, "a pair")?)?))
    }
}

/// Declares structs of the wire: arrays of their fields in the order of declaration.
macro_rules! wire_structs {
    ($($(#[$meta:meta])* $name:ident { $($(#[$field_meta:meta])* $field:ident: $type:ty = $default:expr),* $(,)? })*) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq)]
        pub struct $name {
            $($(#[$field_meta])* pub $field: $type,)*
        }

        impl Default for $name {
            fn default() -> Self {
                Self { $($field: $default,)* }
            }
        }

        impl $crate::wire::Wire for $name {
            fn to_value(&self) -> rmpv::Value {
                rmpv::Value::Array(vec![$($crate::wire::Wire::to_value(&self.$field)),*])
            }

            fn from_value(value: &rmpv::Value) -> Result<Self, $crate::wire::WireError> {
                let mut values = $crate::wire::array(value, stringify!($name))?.iter();
                Ok(Self {
                    $($field: match values.next() {
                        Some(value) => $crate::wire::Wire::from_value(value)?,
                        None => $default,
                    },)*
                })
            }
        }
    )*};
}
pub(crate) use wire_structs;
