//! Values as recordings store them.

use crate::wire::{Vector2D, Vector3D};

/// Why a file is no recording.
#[derive(Debug, thiserror::Error)]
pub enum RecordingError {
    /// It cannot be read.
    #[error("cannot read it: {0}")]
    Io(#[from] std::io::Error),
    /// It does not begin as recordings do.
    #[error("File is not a CARLA recorder")]
    NoRecording,
    /// A packet is shorter than what it holds.
    #[error("a packet ends before what it holds")]
    Short,
    /// A packet larger than any is.
    #[error("a packet of {0} bytes")]
    Packet(u32),
    /// More is to be told than fits into an answer.
    #[error("the file has more to tell than {0} MiB of text")]
    Text(usize),
}

/// What can be stored.
pub(super) trait Stored: Sized {
    fn write(&self, out: &mut Vec<u8>);

    /// Takes it from the beginning of `bytes`.
    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError>;
}

/// The first bytes, which are taken away.
fn take<'a>(bytes: &mut &'a [u8], count: usize) -> Result<&'a [u8], RecordingError> {
    let (first, rest) = bytes.split_at_checked(count).ok_or(RecordingError::Short)?;
    *bytes = rest;
    Ok(first)
}

macro_rules! stored_numbers {
    ($($type:ty),*) => {$(
        impl Stored for $type {
            fn write(&self, out: &mut Vec<u8>) {
                out.extend(self.to_le_bytes());
            }

            fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
                let own = take(bytes, size_of::<Self>())?;
                own.try_into().map(Self::from_le_bytes).map_err(|_short| RecordingError::Short)
            }
        }
    )*};
}
stored_numbers!(u8, u16, u32, u64, i32, i64, f32, f64);

impl Stored for bool {
    fn write(&self, out: &mut Vec<u8>) {
        u8::from(*self).write(out);
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        Ok(u8::read(bytes)? != 0)
    }
}

impl<const N: usize> Stored for [f32; N] {
    fn write(&self, out: &mut Vec<u8>) {
        self.iter().for_each(|number| number.write(out));
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        let mut own = [0.0; N];
        for number in &mut own {
            *number = f32::read(bytes)?;
        }
        Ok(own)
    }
}

impl Stored for Vector2D {
    fn write(&self, out: &mut Vec<u8>) {
        [self.x, self.y].write(out);
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        <[f32; 2]>::read(bytes).map(|[x, y]| Self { x, y })
    }
}

impl Stored for Vector3D {
    fn write(&self, out: &mut Vec<u8>) {
        [self.x, self.y, self.z].write(out);
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        <[f32; 3]>::read(bytes).map(|[x, y, z]| Self { x, y, z })
    }
}

/// With its length before it; what is longer than can be told is cut off.
impl Stored for String {
    fn write(&self, out: &mut Vec<u8>) {
        let mut end = self.len().min(u16::MAX.into());
        while !self.is_char_boundary(end) {
            end -= 1;
        }
        (end as u16).write(out);
        out.extend(&self.as_bytes()[..end]);
    }

    fn read(bytes: &mut &[u8]) -> Result<Self, RecordingError> {
        let length = u16::read(bytes)?;
        Ok(Self::from_utf8_lossy(take(bytes, length.into())?).into_owned())
    }
}

/// One value after the other, without their number.
pub(super) fn write_list<T: Stored>(list: &[T], out: &mut Vec<u8>) {
    list.iter().for_each(|one| one.write(out));
}

/// So many values; memory is taken only for what is there.
pub(super) fn read_list<T: Stored>(count: usize, bytes: &mut &[u8]) -> Result<Vec<T>, RecordingError> {
    let mut list = Vec::new();
    for _ in 0..count {
        list.push(T::read(bytes)?);
    }
    Ok(list)
}

/// Declares records: their fields one after the other.
macro_rules! records {
    ($($(#[$meta:meta])* $name:ident { $($(#[$field_meta:meta])* $field:ident: $type:ty),* $(,)? })*) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, PartialEq, Default)]
        pub struct $name {
            $($(#[$field_meta])* pub $field: $type,)*
        }

        impl $crate::recording::bytes::Stored for $name {
            fn write(&self, out: &mut Vec<u8>) {
                $($crate::recording::bytes::Stored::write(&self.$field, out);)*
            }

            fn read(bytes: &mut &[u8]) -> Result<Self, $crate::recording::RecordingError> {
                Ok(Self { $($field: $crate::recording::bytes::Stored::read(bytes)?,)* })
            }
        }
    )*};
}
pub(super) use records;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn strings_have_their_length_before_them() {
        let mut out = Vec::new();
        "Town06".to_owned().write(&mut out);
        assert_eq!(out, [6, 0, b'T', b'o', b'w', b'n', b'0', b'6']);
        assert_eq!(String::read(&mut &out[..]).unwrap(), "Town06");
        assert!(matches!(String::read(&mut &out[..5]), Err(RecordingError::Short)));
        let mut long = Vec::new();
        "ä".repeat(40_000).write(&mut long);
        assert_eq!(String::read(&mut &long[..]).unwrap(), "ä".repeat(32_767));
    }
}
