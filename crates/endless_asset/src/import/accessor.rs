//! Numbers from the buffer (glTF 2.0, section 3.6): every offset is checked, whatever the document says.

use super::ImportError;
use super::container::GlbFile;
use gltf::Accessor;
use gltf::accessor::{DataType, Dimensions};

fn damaged(what: impl Into<String>) -> ImportError {
    ImportError::Damaged { what: what.into() }
}

/// The bytes of each element, `size` long.
fn elements<'a>(
    opened: &GlbFile<'a>,
    accessor: &Accessor<'_>,
    size: usize,
) -> Result<impl Iterator<Item = &'a [u8]> + use<'a>, ImportError> {
    if accessor.sparse().is_some() {
        return Err(damaged("it has sparse accessors, which are not read"));
    }
    let view = accessor.view().ok_or_else(|| damaged(format!("accessor {} has no data", accessor.index())))?;
    let beyond = || damaged(format!("accessor {} reaches beyond the buffer", accessor.index()));
    let (count, stride) = (accessor.count(), view.stride().unwrap_or(size).max(size));
    let view_end = view.offset().checked_add(view.length()).ok_or_else(beyond)?;
    let view_bytes = opened.buffer.get(view.offset()..view_end).ok_or_else(beyond)?;
    let bytes = view_bytes.get(accessor.offset()..).ok_or_else(beyond)?;
    let needed = count.saturating_sub(1).checked_mul(stride).and_then(|n| n.checked_add(size)).ok_or_else(beyond)?;
    if count > 0 && needed > bytes.len() {
        return Err(beyond());
    }
    Ok((0..count).map(move |i| &bytes[i * stride..i * stride + size]))
}

fn component_size(kind: DataType) -> usize {
    match kind {
        DataType::I8 | DataType::U8 => 1,
        DataType::I16 | DataType::U16 => 2,
        DataType::U32 | DataType::F32 => 4,
    }
}

/// A component as a number; integers stand for −1 to 1 or 0 to 1.
fn number(bytes: &[u8], kind: DataType) -> f32 {
    let two = || [bytes[0], bytes[1]];
    let four = || [bytes[0], bytes[1], bytes[2], bytes[3]];
    match kind {
        DataType::F32 => f32::from_le_bytes(four()),
        DataType::U8 => f32::from(bytes[0]) / 255.0,
        DataType::I8 => f32::from(bytes[0] as i8) / 127.0,
        DataType::U16 => f32::from(u16::from_le_bytes(two())) / 65_535.0,
        DataType::I16 => f32::from(i16::from_le_bytes(two())) / 32_767.0,
        DataType::U32 => u32::from_le_bytes(four()) as f32,
    }
}

/// Vectors of at most `N` components; those that are missing are 1.
pub(super) fn vectors<const N: usize>(
    opened: &GlbFile<'_>,
    accessor: &Accessor<'_>,
) -> Result<Vec<[f32; N]>, ImportError> {
    let components = match accessor.dimensions() {
        Dimensions::Scalar => 1,
        Dimensions::Vec2 => 2,
        Dimensions::Vec3 => 3,
        Dimensions::Vec4 => 4,
        _ => return Err(damaged(format!("accessor {} holds matrices", accessor.index()))),
    };
    let kind = accessor.data_type();
    let size = component_size(kind);
    let of = |bytes: &[u8]| {
        let mut vector = [1.0; N];
        for (k, component) in bytes.chunks_exact(size).take(N).enumerate() {
            vector[k] = number(component, kind);
        }
        vector
    };
    Ok(elements(opened, accessor, size * components)?.map(of).collect())
}

/// Indices of vertices.
pub(super) fn indices(opened: &GlbFile<'_>, accessor: &Accessor<'_>) -> Result<Vec<u32>, ImportError> {
    let kind = accessor.data_type();
    let of = |bytes: &[u8]| match *bytes {
        [a] => u32::from(a),
        [a, b] => u32::from(u16::from_le_bytes([a, b])),
        [a, b, c, d] => u32::from_le_bytes([a, b, c, d]),
        _ => u32::MAX,
    };
    if accessor.dimensions() != Dimensions::Scalar || !matches!(kind, DataType::U8 | DataType::U16 | DataType::U32) {
        return Err(damaged(format!("accessor {} holds no indices", accessor.index())));
    }
    Ok(elements(opened, accessor, component_size(kind))?.map(of).collect())
}
