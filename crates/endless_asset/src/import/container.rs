//! The container of a `.glb` file (glTF 2.0, section 4.4), its document checked against the specification.

use super::error::ImportError;
use gltf::json::validation::{Checked, Error as Fault};

/// Reads an image file by its path relative to the model's file; `None` if there is none.
pub type ReadExternalFile<'a> = &'a dyn Fn(&str) -> Option<Vec<u8>>;

const HEADER: usize = 12;
const CHUNK_HEADER: usize = 8;

/// A checked document and the buffer that it speaks of.
pub(super) struct GlbFile<'a> {
    pub(super) document: gltf::Document,
    pub(super) buffer: &'a [u8],
    pub(super) read_external: ReadExternalFile<'a>,
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(at..at.checked_add(4)?)?.try_into().ok()?))
}

/// The chunk at a place: its kind, its content and where the next one begins.
fn chunk<'a>(bytes: &'a [u8], at: usize, part: &'static str) -> Result<(u32, &'a [u8], usize), ImportError> {
    let header = |k: usize| word(bytes, at + k);
    let (Some(length), Some(kind)) = (header(0), header(4)) else {
        return Err(ImportError::Truncated { part, expected: CHUNK_HEADER, actual: bytes.len().saturating_sub(at) });
    };
    let from = at + CHUNK_HEADER;
    let expected = length as usize;
    let content = from.checked_add(expected).and_then(|to| bytes.get(from..to));
    let actual = bytes.len() - from;
    let content = content.ok_or(ImportError::Truncated { part, expected, actual })?;
    Ok((kind, content, from + expected))
}

/// Opens a file.
///
/// # Errors
/// When it is no whole `.glb` file or its document contradicts itself.
pub(super) fn open<'a>(bytes: &'a [u8], read_external: ReadExternalFile<'a>) -> Result<GlbFile<'a>, ImportError> {
    if !bytes.starts_with(b"glTF") {
        return Err(ImportError::NotGlb);
    }
    let short = |expected| ImportError::Truncated { part: "it", expected, actual: bytes.len() };
    let (version, length) = word(bytes, 4).zip(word(bytes, 8)).ok_or_else(|| short(HEADER))?;
    if version != 2 {
        return Err(ImportError::Version { version });
    }
    let whole = bytes.get(..length as usize).filter(|b| b.len() >= HEADER).ok_or_else(|| short(length as usize))?;
    let (kind, text, next) = chunk(whole, HEADER, "its document")?;
    if kind != u32::from_le_bytes(*b"JSON") {
        return Err(ImportError::Damaged { what: "its first chunk is not the document".to_owned() });
    }
    let buffer = if next < whole.len() { chunk(whole, next, "its buffer")?.1 } else { &[] };
    let damaged = |what: String| ImportError::Damaged { what };
    let root: gltf::json::Root =
        gltf::json::deserialize::from_slice(text).map_err(|e| damaged(format!("its document is no glTF, {e}")))?;
    if let Some(name) = root.extensions_required.iter().find(|n| !known(n)) {
        return Err(ImportError::Extension { name: name.chars().take(60).collect() });
    }
    for (number, of) in root.buffers.iter().enumerate() {
        if let Some(uri) = &of.uri {
            return Err(ImportError::Outside { what: "a buffer", uri: uri.chars().take(60).collect() });
        }
        let (expected, actual) = (usize::try_from(of.byte_length.0).unwrap_or(usize::MAX), buffer.len());
        if number > 0 || expected > actual {
            return Err(ImportError::Truncated { part: "its buffer", expected, actual });
        }
    }
    consistent(&root)?;
    let document = gltf::Document::from_json(root).map_err(|e| damaged(described(&e)))?;
    Ok(GlbFile { document, buffer, read_external })
}

/// What the library that checks documents takes for granted.
fn consistent(root: &gltf::json::Root) -> Result<(), ImportError> {
    let damaged = |what: String| Err(ImportError::Damaged { what });
    let positions = Checked::Valid(gltf::Semantic::Positions);
    for (number, mesh) in root.meshes.iter().enumerate() {
        let places = mesh.primitives.iter().filter_map(|p| p.attributes.get(&positions));
        if places.into_iter().any(|index| index.value() >= root.accessors.len()) {
            return damaged(format!("mesh {number} points to vertices that are not there"));
        }
    }
    for (number, image) in root.images.iter().enumerate() {
        if image.uri.is_none() && (image.buffer_view.is_none() || image.mime_type.is_none()) {
            return damaged(format!("image {number} has no place or no type"));
        }
    }
    Ok(())
}

/// Extensions that change nothing of what is read, or that are understood.
fn known(extension: &str) -> bool {
    const HARMLESS: [&str; 8] = [
        "KHR_materials_unlit",
        "KHR_materials_transmission",
        "KHR_materials_ior",
        "KHR_materials_specular",
        "KHR_materials_volume",
        "KHR_materials_emissive_strength",
        "KHR_texture_transform",
        "KHR_lights_punctual",
    ];
    HARMLESS.contains(&extension)
}

fn described(error: &gltf::Error) -> String {
    match error {
        gltf::Error::Validation(faults) => faults.first().map_or_else(String::new, |(place, fault)| {
            let what = match fault {
                Fault::IndexOutOfBounds => "points to what is not there",
                Fault::Missing => "is missing",
                Fault::Unsupported => "is not supported",
                _ => "is not valid",
            };
            format!("{place} {what}")
        }),
        other => other.to_string(),
    }
}
