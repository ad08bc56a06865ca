//! Values read from a peer that nobody trusts: depth, number of values and bytes have bounds, and memory is taken only for
//! what has arrived.

use rmp::Marker;
use rmp::decode::{self, RmpRead as _, ValueReadError};
use rmpv::{Utf8String, Value};
use std::io::{self, Read};

/// Deepest nesting.
const DEEPEST: u32 = 64;
/// Most values in one message: a batch of thousands of commands has tens of thousands.
const MOST_VALUES: u32 = 4_000_000;
/// Most bytes of text and `bin` in one message: maps and textures.
const MOST_BYTES: usize = 256 << 20;
/// Taken at once for what is announced and has not arrived.
const PIECE: usize = 64 << 10;

/// A message that is no msgpack, or beyond all bounds.
#[derive(Debug, thiserror::Error)]
pub enum DecodeError {
    /// The connection broke.
    #[error("the connection broke: {0}")]
    Io(#[from] io::Error),
    /// A byte that begins no value.
    #[error("byte 0x{0:02x} begins no msgpack value")]
    Marker(u8),
    /// Values in values in values.
    #[error("values are nested more than {DEEPEST} deep")]
    Depth,
    /// Too much of it.
    #[error("a message has more than {MOST_VALUES} values or {} MiB of text", MOST_BYTES >> 20)]
    Size,
}

impl DecodeError {
    /// Whether the peer has gone, in place of having sent something wrong.
    pub fn is_end(&self) -> bool {
        matches!(self, Self::Io(_))
    }
}

impl From<ValueReadError> for DecodeError {
    fn from(error: ValueReadError) -> Self {
        match error {
            ValueReadError::InvalidMarkerRead(error) | ValueReadError::InvalidDataRead(error) => Self::Io(error),
            ValueReadError::TypeMismatch(marker) => Self::Marker(marker.to_u8()),
        }
    }
}

/// Reads one value.
///
/// # Errors
/// When the connection breaks or what comes is no value within the bounds.
pub fn read_value(reader: &mut impl Read) -> Result<Value, DecodeError> {
    Decoder { reader, values: MOST_VALUES, bytes: MOST_BYTES }.value(DEEPEST)
}

struct Decoder<'a, R> {
    reader: &'a mut R,
    /// Left.
    values: u32,
    bytes: usize,
}

impl<R: Read> Decoder<'_, R> {
    fn value(&mut self, depth: u32) -> Result<Value, DecodeError> {
        let depth = depth.checked_sub(1).ok_or(DecodeError::Depth)?;
        self.values = self.values.checked_sub(1).ok_or(DecodeError::Size)?;
        let marker = decode::read_marker(self.reader).map_err(|error| DecodeError::Io(error.0))?;
        Ok(match marker {
            Marker::Null => Value::Nil,
            Marker::True => Value::Boolean(true),
            Marker::False => Value::Boolean(false),
            Marker::FixPos(number) => Value::from(number),
            Marker::FixNeg(number) => Value::from(number),
            Marker::U8 => Value::from(self.reader.read_data_u8()?),
            Marker::U16 => Value::from(self.reader.read_data_u16()?),
            Marker::U32 => Value::from(self.reader.read_data_u32()?),
            Marker::U64 => Value::from(self.reader.read_data_u64()?),
            Marker::I8 => Value::from(self.reader.read_data_i8()?),
            Marker::I16 => Value::from(self.reader.read_data_i16()?),
            Marker::I32 => Value::from(self.reader.read_data_i32()?),
            Marker::I64 => Value::from(self.reader.read_data_i64()?),
            Marker::F32 => Value::F32(self.reader.read_data_f32()?),
            Marker::F64 => Value::F64(self.reader.read_data_f64()?),
            Marker::FixStr(length) => self.text(length.into())?,
            Marker::Str8 => self.sized(1, Self::text)?,
            Marker::Str16 => self.sized(2, Self::text)?,
            Marker::Str32 => self.sized(4, Self::text)?,
            Marker::Bin8 => self.sized(1, Self::bin)?,
            Marker::Bin16 => self.sized(2, Self::bin)?,
            Marker::Bin32 => self.sized(4, Self::bin)?,
            Marker::FixArray(length) => self.array(length.into(), depth)?,
            Marker::Array16 => self.sized(2, |own, length| own.array(length, depth))?,
            Marker::Array32 => self.sized(4, |own, length| own.array(length, depth))?,
            Marker::FixMap(length) => self.map(length.into(), depth)?,
            Marker::Map16 => self.sized(2, |own, length| own.map(length, depth))?,
            Marker::Map32 => self.sized(4, |own, length| own.map(length, depth))?,
            // CARLA has no extensions.
            other => return Err(DecodeError::Marker(other.to_u8())),
        })
    }

    /// Reads a length of so many bytes, and what has it.
    fn sized(
        &mut self,
        bytes: u32,
        read: impl FnOnce(&mut Self, usize) -> Result<Value, DecodeError>,
    ) -> Result<Value, DecodeError> {
        let length = match bytes {
            1 => self.reader.read_data_u8()?.into(),
            2 => self.reader.read_data_u16()?.into(),
            _ => self.reader.read_data_u32()? as usize,
        };
        read(self, length)
    }

    fn raw(&mut self, length: usize) -> Result<Vec<u8>, DecodeError> {
        self.bytes = self.bytes.checked_sub(length).ok_or(DecodeError::Size)?;
        let mut bytes = Vec::with_capacity(length.min(PIECE));
        let read = self.reader.take(length as u64).read_to_end(&mut bytes)?;
        if read < length { Err(io::Error::from(io::ErrorKind::UnexpectedEof).into()) } else { Ok(bytes) }
    }

    fn text(&mut self, length: usize) -> Result<Value, DecodeError> {
        Ok(match String::from_utf8(self.raw(length)?) {
            Ok(text) => Value::String(Utf8String::from(text)),
            Err(error) => Value::Binary(error.into_bytes()),
        })
    }

    fn bin(&mut self, length: usize) -> Result<Value, DecodeError> {
        self.raw(length).map(Value::Binary)
    }

    fn array(&mut self, length: usize, depth: u32) -> Result<Value, DecodeError> {
        let mut values = Vec::with_capacity(length.min(PIECE / size_of::<Value>()));
        for _ in 0..length {
            values.push(self.value(depth)?);
        }
        Ok(Value::Array(values))
    }

    fn map(&mut self, length: usize, depth: u32) -> Result<Value, DecodeError> {
        let mut pairs = Vec::new();
        for _ in 0..length {
            pairs.push((self.value(depth)?, self.value(depth)?));
        }
        Ok(Value::Map(pairs))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn any_value() -> impl Strategy<Value = Value> {
        let leaf = prop_oneof![
            Just(Value::Nil),
            any::<bool>().prop_map(Value::from),
            any::<i64>().prop_map(Value::from),
            any::<u64>().prop_map(Value::from),
            any::<f32>().prop_filter("NaN is unlike itself", |x| !x.is_nan()).prop_map(Value::from),
            any::<f64>().prop_filter("NaN is unlike itself", |x| !x.is_nan()).prop_map(Value::from),
            ".{0,40}".prop_map(Value::from),
            prop::collection::vec(any::<u8>(), 0..40).prop_map(Value::Binary),
        ];
        leaf.prop_recursive(5, 60, 6, |inner| prop::collection::vec(inner, 0..6).prop_map(Value::Array))
    }

    proptest! {
        #[test]
        fn what_was_written_is_read(value in any_value()) {
            let mut bytes = Vec::new();
            rmpv::encode::write_value(&mut bytes, &value).unwrap();
            prop_assert_eq!(read_value(&mut &bytes[..]).unwrap(), value);
        }

        #[test]
        fn any_bytes_are_a_value_or_an_error(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let _ = read_value(&mut &bytes[..]);
        }
    }

    #[test]
    fn bombs_are_errors() {
        let nested = [0x91; 10_000];
        assert!(matches!(read_value(&mut &nested[..]), Err(DecodeError::Depth)));
        // Four thousand million values are announced, and do not come.
        assert!(matches!(read_value(&mut &[0xdd, 0xff, 0xff, 0xff, 0xff][..]), Err(DecodeError::Io(_))));
        assert!(matches!(read_value(&mut &[0xc6, 0xff, 0xff, 0xff, 0xff][..]), Err(DecodeError::Size)));
        let many = [&[0xdd, 0xff, 0xff, 0xff, 0xff][..], &vec![0xc0; 5_000_000]].concat();
        assert!(matches!(read_value(&mut &many[..]), Err(DecodeError::Size)));
    }
}
