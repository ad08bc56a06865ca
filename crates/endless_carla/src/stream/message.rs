//! The header of all messages of streams, little-endian.

use crate::wire::{Rotation, Transform, Vector3D};
use rmpv::Value;

/// The type of messages that are snapshots, in 0.9.16.
pub const WORLD_OBSERVER: u64 = 17;

/// What begins a message.
#[derive(Debug, Clone, PartialEq)]
pub struct SensorHeader {
    /// What the payload is.
    pub type_id: u64,
    /// The frame.
    pub frame: u64,
    /// Seconds since the episode began.
    pub timestamp: f64,
    /// Where the sensor was.
    pub transform: Transform,
}

impl SensorHeader {
    /// Its size, bytes.
    pub const SIZE: usize = 48;

    /// From its bytes.
    pub fn read(bytes: &[u8; Self::SIZE]) -> Self {
        let mut bytes = ByteReader(bytes);
        let (type_id, frame, timestamp) = (bytes.u64(), bytes.u64(), bytes.f64());
        Self { type_id, frame, timestamp, transform: bytes.transform() }
    }

    /// A message of this header, with room for a payload of so many bytes.
    pub fn begin(&self, payload: usize) -> Vec<u8> {
        let mut message = Vec::with_capacity(Self::SIZE + payload);
        message.extend(self.type_id.to_le_bytes());
        message.extend(self.frame.to_le_bytes());
        message.extend(self.timestamp.to_le_bytes());
        push_transform(&mut message, &self.transform);
        message
    }

    /// A message of this header whose payload is msgpack.
    pub fn with_msgpack(&self, payload: &Value) -> Vec<u8> {
        let mut message = self.begin(64);
        // Nothing can go wrong in memory.
        let _ = rmpv::encode::write_value(&mut message, payload);
        message
    }
}

/// Place, then pitch, yaw and roll.
pub(super) fn push_transform(message: &mut Vec<u8>, transform: &Transform) {
    let Transform { location, rotation } = transform;
    push_floats(message, &[location.x, location.y, location.z, rotation.pitch, rotation.yaw, rotation.roll]);
}

pub(super) fn push_floats(message: &mut Vec<u8>, numbers: &[f32]) {
    message.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
}

/// Reads numbers one after the other; beyond the end they are 0.
pub(super) struct ByteReader<'a>(pub(super) &'a [u8]);

impl ByteReader<'_> {
    pub(super) fn take<const N: usize>(&mut self) -> [u8; N] {
        match self.0.split_first_chunk::<N>() {
            Some((chunk, rest)) => {
                self.0 = rest;
                *chunk
            }
            None => [0; N],
        }
    }

    pub(super) fn u32(&mut self) -> u32 {
        u32::from_le_bytes(self.take())
    }

    pub(super) fn u64(&mut self) -> u64 {
        u64::from_le_bytes(self.take())
    }

    pub(super) fn f32(&mut self) -> f32 {
        f32::from_le_bytes(self.take())
    }

    pub(super) fn f64(&mut self) -> f64 {
        f64::from_le_bytes(self.take())
    }

    pub(super) fn vector(&mut self) -> Vector3D {
        Vector3D { x: self.f32(), y: self.f32(), z: self.f32() }
    }

    pub(super) fn transform(&mut self) -> Transform {
        let location = self.vector();
        Transform { location, rotation: Rotation { pitch: self.f32(), yaw: self.f32(), roll: self.f32() } }
    }
}
