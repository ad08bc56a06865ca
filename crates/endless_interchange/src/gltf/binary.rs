//! The binary side of a glTF file: one buffer, its accessors, and the container (specification 2.0, sections 3.6, 4).

use serde_json::{Value, json};

const ARRAY_BUFFER: u32 = 34_962;
const ELEMENT_ARRAY_BUFFER: u32 = 34_963;
const FLOAT: u32 = 5126;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;

/// More than a `.glb` can hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct TooLarge;

/// The buffer with what lies in it.
#[derive(Debug, Default)]
pub(super) struct Binary {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Binary {
    /// Vectors of three floats, one a vertex; returns their accessor.
    pub(super) fn vectors(&mut self, vectors: impl Iterator<Item = [f32; 3]>) -> usize {
        let from = self.bytes.len();
        let (mut low, mut high, mut count) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3], 0);
        for vector in vectors {
            for (k, x) in vector.into_iter().enumerate() {
                low[k] = low[k].min(x);
                high[k] = high[k].max(x);
                self.bytes.extend(x.to_le_bytes());
            }
            count += 1;
        }
        self.view(from, ARRAY_BUFFER);
        self.accessor(json!({
            "componentType": FLOAT, "count": count, "type": "VEC3",
            "min": low.to_vec(), "max": high.to_vec(),
        }))
    }

    /// Vertex indices, in two bytes each where that is enough; returns their accessor.
    pub(super) fn indices(&mut self, indices: &[u32]) -> usize {
        let from = self.bytes.len();
        // The largest number of either width is no index.
        let short: Option<Vec<u16>> =
            indices.iter().map(|i| u16::try_from(*i).ok().filter(|i| *i < u16::MAX)).collect();
        let kind = match short {
            Some(short) => {
                self.bytes.extend(short.iter().flat_map(|i| i.to_le_bytes()));
                UNSIGNED_SHORT
            }
            None => {
                self.bytes.extend(indices.iter().flat_map(|i| i.to_le_bytes()));
                UNSIGNED_INT
            }
        };
        self.view(from, ELEMENT_ARRAY_BUFFER);
        self.accessor(json!({ "componentType": kind, "count": indices.len(), "type": "SCALAR" }))
    }

    fn view(&mut self, from: usize, target: u32) {
        let length = self.bytes.len() - from;
        // What comes next begins where numbers of four bytes may.
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views.push(json!({ "buffer": 0, "byteOffset": from, "byteLength": length, "target": target }));
    }

    /// On the view made last.
    fn accessor(&mut self, mut accessor: Value) -> usize {
        accessor["bufferView"] = json!(self.views.len() - 1);
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// The whole file around a document, to which buffer, views and accessors are added.
    ///
    /// # Errors
    /// [`TooLarge`] if lengths do not fit into 32 bits.
    pub(super) fn container(mut self, mut document: Value) -> Result<Vec<u8>, TooLarge> {
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        document["buffers"] = json!([{ "byteLength": self.bytes.len() }]);
        document["bufferViews"] = json!(self.views);
        document["accessors"] = json!(self.accessors);
        let mut text = document.to_string().into_bytes();
        text.resize(text.len().next_multiple_of(4), b' ');
        let length = |n: usize| u32::try_from(n).map(u32::to_le_bytes).ok().ok_or(TooLarge);
        let whole = length(12 + 8 + text.len() + 8 + self.bytes.len())?;
        let (text_length, bytes_length) = (length(text.len())?, length(self.bytes.len())?);
        Ok([
            b"glTF".as_slice(),
            &2u32.to_le_bytes(),
            &whole,
            &text_length,
            b"JSON",
            &text,
            &bytes_length,
            b"BIN\0",
            &self.bytes,
        ]
        .concat())
    }
}
