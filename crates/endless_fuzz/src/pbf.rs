//! A small writer of `.osm.pbf`, raw blobs, so that the reader has something to read and fuzzing something to change.

use crate::mutate;
use endless_road::osm::{OsmExtract, OsmMemberKind, OsmTags};
use endless_world::Stream;

fn varint(mut value: u64, out: &mut Vec<u8>) {
    while value >= 0x80 {
        out.push(value as u8 | 0x80);
        value >>= 7;
    }
    out.push(value as u8);
}

fn number(field: u64, value: u64, out: &mut Vec<u8>) {
    varint(field << 3, out);
    varint(value, out);
}

fn bytes(field: u64, data: &[u8], out: &mut Vec<u8>) {
    varint((field << 3) | 2, out);
    varint(data.len() as u64, out);
    out.extend_from_slice(data);
}

fn zigzag(value: i64) -> u64 {
    ((value << 1) ^ (value >> 63)) as u64
}

fn list(field: u64, values: impl IntoIterator<Item = u64>, out: &mut Vec<u8>) {
    let mut packed = Vec::new();
    values.into_iter().for_each(|value| varint(value, &mut packed));
    bytes(field, &packed, out);
}

fn differences(values: impl IntoIterator<Item = i64>) -> Vec<u64> {
    let mut last = 0i64;
    let step = |value: i64| zigzag(value.wrapping_sub(std::mem::replace(&mut last, value)));
    values.into_iter().map(step).collect()
}

/// A blob with its header.
fn blob(kind: &str, content: &[u8]) -> Vec<u8> {
    let mut body = Vec::new();
    bytes(1, content, &mut body);
    let mut header = Vec::new();
    bytes(1, kind.as_bytes(), &mut header);
    number(3, body.len() as u64, &mut header);
    [&(header.len() as u32).to_be_bytes()[..], &header, &body].concat()
}

fn header() -> Vec<u8> {
    let mut header = Vec::new();
    bytes(4, b"OsmSchema-V0.6", &mut header);
    bytes(4, b"DenseNodes", &mut header);
    blob("OSMHeader", &header)
}

/// A `.osm.pbf` file that holds an extract, its blobs raw.
pub fn pbf_from_extract(extract: &OsmExtract) -> Vec<u8> {
    [header(), blob("OSMData", &block(extract))].concat()
}

#[derive(Default)]
struct Strings(Vec<String>);

impl Strings {
    fn place(&mut self, text: &str) -> u64 {
        let at = self.0.iter().position(|known| known == text).unwrap_or_else(|| {
            self.0.push(text.to_owned());
            self.0.len() - 1
        });
        at as u64
    }

    fn tags(&mut self, tags: &OsmTags) -> [Vec<u64>; 2] {
        let keys = tags.iter().map(|(key, _)| self.place(key)).collect();
        [keys, tags.iter().map(|(_, value)| self.place(value)).collect()]
    }
}

fn block(extract: &OsmExtract) -> Vec<u8> {
    let mut strings = Strings(vec![String::new()]);
    let mut group = Vec::new();
    let mut dense = Vec::new();
    let nano = |degrees: f64| (degrees * 1e7).round() as i64;
    list(1, differences(extract.nodes.keys().copied()), &mut dense);
    list(8, differences(extract.nodes.values().map(|n| nano(n.lat))), &mut dense);
    list(9, differences(extract.nodes.values().map(|n| nano(n.lon))), &mut dense);
    let mut keys_values = Vec::new();
    for node in extract.nodes.values() {
        for (key, value) in node.tags.iter() {
            keys_values.extend([strings.place(key), strings.place(value)]);
        }
        keys_values.push(0);
    }
    list(10, keys_values, &mut dense);
    bytes(2, &dense, &mut group);
    for way in &extract.ways {
        let mut out = Vec::new();
        number(1, way.id as u64, &mut out);
        let [keys, values] = strings.tags(&way.tags);
        list(2, keys, &mut out);
        list(3, values, &mut out);
        list(8, differences(way.nodes.iter().copied()), &mut out);
        bytes(3, &out, &mut group);
    }
    for relation in &extract.relations {
        let mut out = Vec::new();
        number(1, relation.id as u64, &mut out);
        let [keys, values] = strings.tags(&relation.tags);
        list(2, keys, &mut out);
        list(3, values, &mut out);
        list(8, relation.members.iter().map(|m| strings.place(&m.role)).collect::<Vec<_>>(), &mut out);
        list(9, differences(relation.members.iter().map(|m| m.id)), &mut out);
        let kind = |kind| match kind {
            OsmMemberKind::Node => 0,
            OsmMemberKind::Way => 1,
            OsmMemberKind::Relation => 2,
        };
        list(10, relation.members.iter().map(|m| kind(m.kind)), &mut out);
        bytes(4, &out, &mut group);
    }
    let mut table = Vec::new();
    strings.0.iter().for_each(|text| bytes(1, text.as_bytes(), &mut table));
    let mut block = Vec::new();
    bytes(1, &table, &mut block);
    bytes(2, &group, &mut block);
    block
}

/// A file as [`pbf_from_extract`] writes them with what is in its last blob changed, and all lengths around it right. Others are
/// changed anywhere.
pub(crate) fn changed(file: &[u8], stream: &mut Stream) -> Vec<u8> {
    let whole = header();
    let content = file.strip_prefix(&whole[..]).and_then(content);
    match content {
        Some(content) if stream.chance(0.7) => [whole, blob("OSMData", &mutate::binary(content, stream))].concat(),
        _ => mutate::binary(file, stream),
    }
}

/// What a raw blob holds.
fn content(blob: &[u8]) -> Option<&[u8]> {
    let header = u32::from_be_bytes(*blob.first_chunk()?) as usize;
    let body = blob.get(4 + header..)?;
    // The key, and a length of up to ten bytes.
    let digits = 1 + body.get(1..)?.iter().position(|byte| *byte < 0x80)?;
    body.get(1 + digits..)
}
