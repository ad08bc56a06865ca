//! Protocol buffers' wire format, as much of it as PBF needs
//! (<https://protobuf.dev/programming-guides/encoding/>).

use crate::osm::OsmError;

/// A field's value.
#[derive(Debug, Clone, Copy)]
pub(super) enum WireValue<'a> {
    Varint(u64),
    Bytes(&'a [u8]),
    /// Fixed 32 or 64 bits: PBF has none that matter.
    Fixed,
}

/// A message being read.
#[derive(Debug, Clone)]
pub(super) struct ProtobufMessage<'a> {
    bytes: &'a [u8],
    at: usize,
}

impl<'a> ProtobufMessage<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0 }
    }

    pub(super) fn error(&self, reason: impl Into<String>) -> OsmError {
        OsmError::Pbf { offset: self.at, reason: reason.into() }
    }

    fn varint(&mut self) -> Result<u64, OsmError> {
        let mut value = 0u64;
        for shift in (0..64).step_by(7) {
            let Some(&byte) = self.bytes.get(self.at) else { return Err(self.error("a number is cut off")) };
            self.at += 1;
            value |= u64::from(byte & 0x7f) << shift;
            if byte < 0x80 {
                return Ok(value);
            }
        }
        Err(self.error("a number has more than ten bytes"))
    }

    fn take(&mut self, length: u64) -> Result<&'a [u8], OsmError> {
        let left = self.bytes.len() - self.at;
        if length > left as u64 {
            return Err(self.error(format!("a field of {length} bytes where {left} are left")));
        }
        let from = self.at;
        self.at += length as usize;
        Ok(&self.bytes[from..self.at])
    }

    /// The next field's number and value; `None` at the end.
    pub(super) fn field(&mut self) -> Result<Option<(u64, WireValue<'a>)>, OsmError> {
        if self.at == self.bytes.len() {
            return Ok(None);
        }
        let key = self.varint()?;
        let value = match key & 7 {
            0 => WireValue::Varint(self.varint()?),
            1 => {
                self.take(8)?;
                WireValue::Fixed
            }
            2 => {
                let length = self.varint()?;
                WireValue::Bytes(self.take(length)?)
            }
            5 => {
                self.take(4)?;
                WireValue::Fixed
            }
            other => return Err(self.error(format!("wire type {other} is not known"))),
        };
        Ok(Some((key >> 3, value)))
    }
}

/// A packed list of numbers.
pub(super) fn packed(bytes: &[u8]) -> Result<Vec<u64>, OsmError> {
    let mut message = ProtobufMessage::new(bytes);
    let mut values = Vec::new();
    while message.at < bytes.len() {
        values.push(message.varint()?);
    }
    Ok(values)
}

/// Zigzag: small numbers of either sign in few bytes.
pub(super) fn signed(value: u64) -> i64 {
    (value >> 1) as i64 ^ -((value & 1) as i64)
}

/// A packed list of differences, summed up.
pub(super) fn summed(bytes: &[u8]) -> Result<Vec<i64>, OsmError> {
    let mut sum = 0i64;
    Ok(packed(bytes)?
        .into_iter()
        .map(|d| {
            sum = sum.wrapping_add(signed(d));
            sum
        })
        .collect())
}
