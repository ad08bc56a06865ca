//! One block of nodes, ways and relations.

use super::wire::{ProtobufMessage, WireValue, packed, signed, summed};
use crate::osm::OsmError;
use crate::osm::extract::{OsmExtract, OsmMember, OsmMemberKind, OsmNode, OsmRelation, OsmTags, OsmWay};

/// What the block's numbers mean.
struct BlockScale<'a> {
    strings: Vec<&'a [u8]>,
    granularity: i64,
    lat_offset: i64,
    lon_offset: i64,
}

impl BlockScale<'_> {
    fn text(&self, index: u64) -> Result<String, OsmError> {
        let bytes = usize::try_from(index).ok().and_then(|i| self.strings.get(i));
        let bytes = bytes.ok_or_else(|| error(format!("string {index} does not exist")))?;
        Ok(String::from_utf8_lossy(bytes).into_owned())
    }

    fn tags(&self, keys: &[u64], values: &[u64]) -> Result<OsmTags, OsmError> {
        let mut tags = OsmTags::default();
        for (&key, &value) in keys.iter().zip(values) {
            tags.set(self.text(key)?, self.text(value)?);
        }
        Ok(tags)
    }

    fn add_node(&self, extract: &mut OsmExtract, id: i64, lat: i64, lon: i64, tags: OsmTags) {
        let degrees = |offset: i64, v: i64| 1e-9 * (offset as f64 + self.granularity as f64 * v as f64);
        let (lat, lon) = (degrees(self.lat_offset, lat), degrees(self.lon_offset, lon));
        if lat.abs() <= 90.0 && lon.abs() <= 180.0 {
            extract.nodes.insert(id, OsmNode { lat, lon, tags });
        }
    }
}

fn error(reason: String) -> OsmError {
    OsmError::Pbf { offset: 0, reason }
}

pub(super) fn read(bytes: &[u8], extract: &mut OsmExtract) -> Result<(), OsmError> {
    let mut frame = BlockScale { strings: Vec::new(), granularity: 100, lat_offset: 0, lon_offset: 0 };
    let mut groups = Vec::new();
    let mut message = ProtobufMessage::new(bytes);
    while let Some((field, value)) = message.field()? {
        match (field, value) {
            (1, WireValue::Bytes(table)) => {
                let mut table = ProtobufMessage::new(table);
                while let Some((field, value)) = table.field()? {
                    if let (1, WireValue::Bytes(text)) = (field, value) {
                        frame.strings.push(text);
                    }
                }
            }
            (2, WireValue::Bytes(group)) => groups.push(group),
            (17, WireValue::Varint(v)) => frame.granularity = v as i64,
            (19, WireValue::Varint(v)) => frame.lat_offset = v as i64,
            (20, WireValue::Varint(v)) => frame.lon_offset = v as i64,
            _ => {}
        }
    }
    for group in groups {
        let mut group = ProtobufMessage::new(group);
        while let Some((field, value)) = group.field()? {
            match (field, value) {
                (1, WireValue::Bytes(bytes)) => plain_node(&frame, bytes, extract)?,
                (2, WireValue::Bytes(bytes)) => dense_nodes(&frame, bytes, extract)?,
                (3, WireValue::Bytes(bytes)) => way(&frame, bytes, extract)?,
                (4, WireValue::Bytes(bytes)) => relation(&frame, bytes, extract)?,
                _ => {}
            }
        }
    }
    Ok(())
}

fn plain_node(frame: &BlockScale<'_>, bytes: &[u8], extract: &mut OsmExtract) -> Result<(), OsmError> {
    let (mut id, mut lat, mut lon, mut keys, mut values) = (0, 0, 0, Vec::new(), Vec::new());
    let mut message = ProtobufMessage::new(bytes);
    while let Some((field, value)) = message.field()? {
        match (field, value) {
            (1, WireValue::Varint(v)) => id = signed(v),
            (2, WireValue::Bytes(b)) => keys = packed(b)?,
            (3, WireValue::Bytes(b)) => values = packed(b)?,
            (8, WireValue::Varint(v)) => lat = signed(v),
            (9, WireValue::Varint(v)) => lon = signed(v),
            _ => {}
        }
    }
    let tags = frame.tags(&keys, &values)?;
    frame.add_node(extract, id, lat, lon, tags);
    Ok(())
}

fn dense_nodes(frame: &BlockScale<'_>, bytes: &[u8], extract: &mut OsmExtract) -> Result<(), OsmError> {
    let (mut ids, mut lats, mut lons, mut tags) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut message = ProtobufMessage::new(bytes);
    while let Some((field, value)) = message.field()? {
        match (field, value) {
            (1, WireValue::Bytes(b)) => ids = summed(b)?,
            (8, WireValue::Bytes(b)) => lats = summed(b)?,
            (9, WireValue::Bytes(b)) => lons = summed(b)?,
            (10, WireValue::Bytes(b)) => tags = packed(b)?,
            _ => {}
        }
    }
    if ids.len() != lats.len() || ids.len() != lons.len() {
        let (n, a, b) = (ids.len(), lats.len(), lons.len());
        return Err(error(format!("{n} dense nodes with {a} latitudes and {b} longitudes")));
    }
    // Keys and values in turn, a 0 after each node's.
    let mut rest = tags.iter().copied();
    for ((id, lat), lon) in ids.into_iter().zip(lats).zip(lons) {
        let mut own = OsmTags::default();
        while let Some(key) = rest.next().filter(|&k| k != 0) {
            let value = rest.next().ok_or_else(|| error("a key without value".into()))?;
            own.set(frame.text(key)?, frame.text(value)?);
        }
        frame.add_node(extract, id, lat, lon, own);
    }
    Ok(())
}

fn way(frame: &BlockScale<'_>, bytes: &[u8], extract: &mut OsmExtract) -> Result<(), OsmError> {
    let (mut id, mut nodes, mut keys, mut values) = (0, Vec::new(), Vec::new(), Vec::new());
    let mut message = ProtobufMessage::new(bytes);
    while let Some((field, value)) = message.field()? {
        match (field, value) {
            (1, WireValue::Varint(v)) => id = v as i64,
            (2, WireValue::Bytes(b)) => keys = packed(b)?,
            (3, WireValue::Bytes(b)) => values = packed(b)?,
            (8, WireValue::Bytes(b)) => nodes = summed(b)?,
            _ => {}
        }
    }
    extract.ways.push(OsmWay { id, nodes, tags: frame.tags(&keys, &values)? });
    Ok(())
}

fn relation(frame: &BlockScale<'_>, bytes: &[u8], extract: &mut OsmExtract) -> Result<(), OsmError> {
    let (mut id, mut keys, mut values) = (0, Vec::new(), Vec::new());
    let (mut roles, mut ids, mut kinds) = (Vec::new(), Vec::new(), Vec::new());
    let mut message = ProtobufMessage::new(bytes);
    while let Some((field, value)) = message.field()? {
        match (field, value) {
            (1, WireValue::Varint(v)) => id = v as i64,
            (2, WireValue::Bytes(b)) => keys = packed(b)?,
            (3, WireValue::Bytes(b)) => values = packed(b)?,
            (8, WireValue::Bytes(b)) => roles = packed(b)?,
            (9, WireValue::Bytes(b)) => ids = summed(b)?,
            (10, WireValue::Bytes(b)) => kinds = packed(b)?,
            _ => {}
        }
    }
    let mut members = Vec::new();
    for ((&role, id), kind) in roles.iter().zip(ids).zip(kinds) {
        let kind = match kind {
            0 => OsmMemberKind::Node,
            1 => OsmMemberKind::Way,
            _ => OsmMemberKind::Relation,
        };
        members.push(OsmMember { kind, id, role: frame.text(role)? });
    }
    extract.relations.push(OsmRelation { id, members, tags: frame.tags(&keys, &values)? });
    Ok(())
}
