//! Reading `.osm.pbf` (<https://wiki.openstreetmap.org/wiki/PBF_Format>): blobs, raw or packed with zlib.

mod block;
mod wire;

use super::OsmError;
use super::extract::{OsmBounds, OsmExtract};
use wire::{ProtobufMessage, WireValue, signed};

/// The format's own limits, bytes.
const MOST_HEADER: usize = 64 << 10;
const MOST_BLOB: usize = 32 << 20;

/// Whether the bytes begin as PBF does: a short header that calls itself `OSMHeader`.
pub(super) fn looks_like(bytes: &[u8]) -> bool {
    bytes.len() > 15 && bytes[..3] == [0, 0, 0] && &bytes[4..15] == b"\x0a\x09OSMHeader"
}

/// Reads a file.
///
/// # Errors
/// [`OsmError::Pbf`] with the byte.
pub(super) fn read(bytes: &[u8]) -> Result<OsmExtract, OsmError> {
    let mut extract = OsmExtract::default();
    let mut at = 0;
    while at < bytes.len() {
        let error = |reason: &str| OsmError::Pbf { offset: at, reason: reason.into() };
        let Some(prefix) = bytes[at..].first_chunk::<4>() else { return Err(error("a blob's header is cut off")) };
        let header_size = u32::from_be_bytes(*prefix) as usize;
        if header_size > MOST_HEADER {
            return Err(error("a blob's header is larger than 64 KiB"));
        }
        let Some(header) = bytes[at + 4..].get(..header_size) else { return Err(error("a blob's header is cut off")) };
        let (kind, size) = blob_header(header).map_err(|error| in_blob(error, at + 4))?;
        if size > MOST_BLOB {
            return Err(error("a blob is larger than 32 MiB"));
        }
        let from = at + 4 + header_size;
        let inside = |error| in_blob(error, from);
        let Some(blob) = bytes[from..].get(..size) else { return Err(error("a blob is cut off")) };
        match kind.as_slice() {
            b"OSMHeader" => {
                let block = unpacked(blob, from).map_err(inside)?;
                extract.bounds = header_block(&block).map_err(inside)?;
            }
            b"OSMData" => {
                let block = unpacked(blob, from).map_err(inside)?;
                block::read(&block, &mut extract).map_err(inside)?;
            }
            _ => {}
        }
        at = from + size;
    }
    extract.put_in_order();
    Ok(extract)
}

/// What is wrong inside a blob, with the place of the blob in the file: its own bytes may be packed.
fn in_blob(error: OsmError, offset: usize) -> OsmError {
    match error {
        OsmError::Pbf { reason, .. } => {
            OsmError::Pbf { offset, reason: format!("in the blob that begins here: {reason}") }
        }
        other => other,
    }
}

fn blob_header(bytes: &[u8]) -> Result<(Vec<u8>, usize), OsmError> {
    let mut message = ProtobufMessage::new(bytes);
    let (mut kind, mut size) = (Vec::new(), None);
    while let Some((field, value)) = message.field()? {
        match (field, value) {
            (1, WireValue::Bytes(name)) => kind = name.to_vec(),
            (3, WireValue::Varint(n)) => size = usize::try_from(n).ok(),
            _ => {}
        }
    }
    let size = size.ok_or_else(|| message.error("a blob without a size"))?;
    Ok((kind, size))
}

fn unpacked(blob: &[u8], offset: usize) -> Result<Vec<u8>, OsmError> {
    let mut message = ProtobufMessage::new(blob);
    let error = |reason: String| OsmError::Pbf { offset, reason };
    while let Some((field, value)) = message.field()? {
        match (field, value) {
            (1, WireValue::Bytes(raw)) => return Ok(raw.to_vec()),
            (3, WireValue::Bytes(packed)) => {
                return miniz_oxide::inflate::decompress_to_vec_zlib_with_limit(packed, MOST_BLOB)
                    .map_err(|e| error(format!("a blob does not unpack: {e}")));
            }
            (4..=7, WireValue::Bytes(_)) => {
                return Err(error(
                    "a blob is packed with something else than zlib; repack the file with osmium".into(),
                ));
            }
            _ => {}
        }
    }
    Err(error("a blob without data".into()))
}

fn header_block(bytes: &[u8]) -> Result<Option<OsmBounds>, OsmError> {
    let mut message = ProtobufMessage::new(bytes);
    let mut bounds = None;
    while let Some((field, value)) = message.field()? {
        match (field, value) {
            (1, WireValue::Bytes(bbox)) => {
                // Left, right, top, bottom, in units of a nano-degree.
                let mut edges = [0.0; 4];
                let mut inner = ProtobufMessage::new(bbox);
                while let Some((field, value)) = inner.field()? {
                    if let (1..=4, WireValue::Varint(v)) = (field, value) {
                        edges[field as usize - 1] = signed(v) as f64 * 1e-9;
                    }
                }
                let [left, right, top, bottom] = edges;
                bounds = Some(OsmBounds { low: [bottom, left], high: [top, right] });
            }
            (4, WireValue::Bytes(feature)) if !matches!(feature, b"OsmSchema-V0.6" | b"DenseNodes") => {
                let name = String::from_utf8_lossy(feature).into_owned();
                return Err(message.error(format!("the file requires {name:?}, which is not known")));
            }
            _ => {}
        }
    }
    Ok(bounds)
}

#[cfg(test)]
mod tests;
