//! The one buffer of a glTF file and its accessors (specification 2.0, section 3.6).

use gltf::json::{
    Accessor, Buffer, Index, Root,
    accessor::{ComponentType, GenericComponentType, Type},
    buffer::{Target, View},
    validation::Checked::Valid,
};
use serde_json::{Value, json};

/// The bytes of all vertices and triangles.
#[derive(Debug, Default)]
pub(super) struct GltfBuffer {
    bytes: Vec<u8>,
}

/// What an accessor says of the numbers that it reads.
struct Elements {
    component: ComponentType,
    shape: Type,
    count: usize,
    /// Least and greatest of each component.
    bounds: Option<[Value; 2]>,
}

impl GltfBuffer {
    /// Vectors of three floats, one a vertex.
    pub(super) fn vectors(&mut self, root: &mut Root, vectors: impl Iterator<Item = [f32; 3]>) -> Index<Accessor> {
        let offset = self.bytes.len();
        let (mut low, mut high, mut count) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3], 0);
        for vector in vectors {
            for (k, x) in vector.into_iter().enumerate() {
                low[k] = low[k].min(x);
                high[k] = high[k].max(x);
                self.bytes.extend(x.to_le_bytes());
            }
            count += 1;
        }
        let bounds = Some([json!(low), json!(high)]);
        let elements = Elements { component: ComponentType::F32, shape: Type::Vec3, count, bounds };
        self.accessor(root, offset, Target::ArrayBuffer, elements)
    }

    /// Vertex indices, in two bytes each where that is enough.
    pub(super) fn indices(&mut self, root: &mut Root, indices: &[u32]) -> Index<Accessor> {
        let offset = self.bytes.len();
        // The largest number of either width is no index.
        let short: Option<Vec<u16>> =
            indices.iter().map(|i| u16::try_from(*i).ok().filter(|i| *i < u16::MAX)).collect();
        let component = match short {
            Some(short) => {
                self.bytes.extend(short.iter().flat_map(|i| i.to_le_bytes()));
                ComponentType::U16
            }
            None => {
                self.bytes.extend(indices.iter().flat_map(|i| i.to_le_bytes()));
                ComponentType::U32
            }
        };
        let elements = Elements { component, shape: Type::Scalar, count: indices.len(), bounds: None };
        self.accessor(root, offset, Target::ElementArrayBuffer, elements)
    }

    /// An accessor on a view of all bytes from `offset` on.
    fn accessor(&mut self, root: &mut Root, offset: usize, target: Target, elements: Elements) -> Index<Accessor> {
        let length = self.bytes.len() - offset;
        // What comes next begins where numbers of four bytes may.
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        let view = root.push(View {
            buffer: Index::new(0),
            byte_length: length.into(),
            byte_offset: Some(offset.into()),
            byte_stride: None,
            name: None,
            target: Some(Valid(target)),
            extensions: None,
            extras: None,
        });
        let [min, max] = elements.bounds.map_or([None, None], |bounds| bounds.map(Some));
        root.push(Accessor {
            buffer_view: Some(view),
            byte_offset: None,
            count: elements.count.into(),
            component_type: Valid(GenericComponentType(elements.component)),
            type_: Valid(elements.shape),
            min,
            max,
            name: None,
            normalized: false,
            sparse: None,
            extensions: None,
            extras: None,
        })
    }

    /// Ends the buffer, and names it in the document.
    pub(super) fn finish(self, root: &mut Root) -> Vec<u8> {
        root.push(Buffer {
            byte_length: self.bytes.len().into(),
            name: None,
            uri: None,
            extensions: None,
            extras: None,
        });
        self.bytes
    }
}
