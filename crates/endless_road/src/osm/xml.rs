//! Reading `.osm` XML (API 0.6, Overpass, JOSM).

use super::OsmError;
use super::extract::{OsmBounds, OsmExtract, OsmMember, OsmMemberKind, OsmNode, OsmRelation, OsmTags, OsmWay};
use crate::error::one_line;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// An element being read.
enum OpenElement {
    Node(i64, Option<OsmNode>),
    Way(OsmWay),
    Relation(OsmRelation),
    /// Deleted in an editor: read, and forgotten.
    Deleted,
}

struct TextSource<'a> {
    bytes: &'a [u8],
    reader: Reader<&'a [u8]>,
}

impl TextSource<'_> {
    fn error(&self, reason: impl Into<String>) -> OsmError {
        let at = (self.reader.error_position().max(self.reader.buffer_position()) as usize).min(self.bytes.len());
        let before = &self.bytes[..at];
        let line = before.iter().filter(|&&b| b == b'\n').count() + 1;
        let column = before.iter().rev().take_while(|&&b| b != b'\n').count() + 1;
        OsmError::Xml { line, column, reason: one_line(&reason.into()) }
    }
}

/// The attributes that any element may have.
#[derive(Default)]
struct Attributes {
    id: Option<i64>,
    lat: Option<f64>,
    lon: Option<f64>,
    reference: Option<i64>,
    kind: Option<String>,
    role: Option<String>,
    key: Option<String>,
    value: Option<String>,
    deleted: bool,
    bounds: [Option<f64>; 4],
}

/// Reads a file.
///
/// # Errors
/// [`OsmError::Xml`] with line and column.
pub(super) fn read(bytes: &[u8]) -> Result<OsmExtract, OsmError> {
    let mut source = TextSource { bytes, reader: Reader::from_reader(bytes) };
    let mut extract = OsmExtract::default();
    let mut open: Option<OpenElement> = None;
    let mut depth = 0usize;
    let mut seen_root = false;
    loop {
        let event = match source.reader.read_event() {
            Ok(event) => event,
            Err(error) => return Err(source.error(error.to_string())),
        };
        match event {
            Event::Start(element) => {
                depth += 1;
                if !seen_root && !matches!(element.name().as_ref(), "osm" | "osmChange") {
                    return Err(source.error("the root element is not <osm>"));
                }
                seen_root = true;
                begin(&source, &element, &mut extract, &mut open)?;
            }
            Event::Empty(element) => {
                begin(&source, &element, &mut extract, &mut open)?;
                end(element.name().as_ref(), &mut extract, &mut open);
            }
            Event::End(element) => {
                depth = depth.saturating_sub(1);
                end(element.name().as_ref(), &mut extract, &mut open);
            }
            Event::Eof if depth > 0 || !seen_root => return Err(source.error("the file ends too early")),
            Event::Eof => break,
            _ => {}
        }
    }
    extract.put_in_order();
    Ok(extract)
}

fn begin(
    source: &TextSource<'_>,
    element: &BytesStart<'_>,
    extract: &mut OsmExtract,
    open: &mut Option<OpenElement>,
) -> Result<(), OsmError> {
    let name = element.name();
    let name = name.as_ref();
    if !matches!(name, "node" | "way" | "relation" | "tag" | "nd" | "member" | "bounds") {
        return Ok(());
    }
    let a = attributes(source, element)?;
    let id = |a: &Attributes| a.id.ok_or_else(|| source.error("an element without id"));
    match name {
        "node" | "way" | "relation" if a.deleted => *open = Some(OpenElement::Deleted),
        "node" => {
            let place = a.lat.zip(a.lon).filter(|(lat, lon)| lat.abs() <= 90.0 && lon.abs() <= 180.0);
            let node = place.map(|(lat, lon)| OsmNode { lat, lon, tags: OsmTags::default() });
            *open = Some(OpenElement::Node(id(&a)?, node));
        }
        "way" => *open = Some(OpenElement::Way(OsmWay { id: id(&a)?, nodes: Vec::new(), tags: OsmTags::default() })),
        "relation" => {
            *open =
                Some(OpenElement::Relation(OsmRelation { id: id(&a)?, members: Vec::new(), tags: OsmTags::default() }));
        }
        "tag" => {
            let tags = match open {
                Some(OpenElement::Node(_, Some(node))) => &mut node.tags,
                Some(OpenElement::Way(way)) => &mut way.tags,
                Some(OpenElement::Relation(relation)) => &mut relation.tags,
                _ => return Ok(()),
            };
            if let (Some(key), Some(value)) = (a.key, a.value) {
                tags.set(key, value);
            }
        }
        "nd" => {
            if let (Some(OpenElement::Way(way)), Some(node)) = (open, a.reference) {
                way.nodes.push(node);
            }
        }
        "member" => {
            let kind = match a.kind.as_deref() {
                Some("node") => OsmMemberKind::Node,
                Some("way") => OsmMemberKind::Way,
                _ => OsmMemberKind::Relation,
            };
            if let (Some(OpenElement::Relation(relation)), Some(id)) = (open, a.reference) {
                relation.members.push(OsmMember { kind, id, role: a.role.unwrap_or_default() });
            }
        }
        _ => {
            if let [Some(south), Some(west), Some(north), Some(east)] = a.bounds {
                extract.bounds = Some(OsmBounds { low: [south, west], high: [north, east] });
            }
        }
    }
    Ok(())
}

fn end(name: &str, extract: &mut OsmExtract, open: &mut Option<OpenElement>) {
    if !matches!(name, "node" | "way" | "relation") {
        return;
    }
    match open.take() {
        Some(OpenElement::Node(id, Some(node))) => {
            extract.nodes.insert(id, node);
        }
        Some(OpenElement::Way(way)) => extract.ways.push(way),
        Some(OpenElement::Relation(relation)) => extract.relations.push(relation),
        _ => {}
    }
}

fn attributes(source: &TextSource<'_>, element: &BytesStart<'_>) -> Result<Attributes, OsmError> {
    let mut a = Attributes::default();
    for attribute in element.attributes() {
        let attribute = attribute.map_err(|error| source.error(error.to_string()))?;
        let value = quick_xml::escape::unescape(&attribute.value).map_err(|error| source.error(error.to_string()))?;
        let number = || {
            let parsed = value.trim().parse::<f64>().ok().filter(|v| v.is_finite());
            parsed.ok_or_else(|| source.error(format!("{value:?} is not a number")))
        };
        let whole =
            || value.trim().parse::<i64>().map_err(|error| source.error(format!("{value:?} is not an id: {error}")));
        match attribute.key.as_ref() {
            "id" => a.id = Some(whole()?),
            "ref" => a.reference = Some(whole()?),
            "lat" => a.lat = Some(number()?),
            "lon" => a.lon = Some(number()?),
            "minlat" => a.bounds[0] = Some(number()?),
            "minlon" => a.bounds[1] = Some(number()?),
            "maxlat" => a.bounds[2] = Some(number()?),
            "maxlon" => a.bounds[3] = Some(number()?),
            "type" => a.kind = Some(value.into_owned()),
            "role" => a.role = Some(value.into_owned()),
            "k" => a.key = Some(value.into_owned()),
            "v" => a.value = Some(value.into_owned()),
            "action" => a.deleted = value == "delete",
            "visible" => a.deleted |= value == "false",
            _ => {}
        }
    }
    Ok(a)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_what_is_there() {
        let text = br#"<?xml version='1.0'?><osm version="0.6"><bounds minlat="1" minlon="2" maxlat="3" maxlon="4"/>
            <node id="1" lat="1.5" lon="2.5"><tag k="name" v="A &amp; B"/></node><node id="2" action="delete"/>
            <way id="7"><nd ref="1"/><nd ref="9"/><tag k="highway" v="residential"/></way>
            <relation id="3"><member type="way" ref="7" role="from"/><tag k="type" v="restriction"/></relation></osm>"#;
        let extract = read(text).expect("well formed");
        assert_eq!(extract.nodes.len(), 1);
        assert_eq!(extract.nodes[&1].tags.get("name"), Some("A & B"));
        assert_eq!(extract.ways[0].nodes, [1, 9]);
        assert_eq!(extract.relations[0].members[0].role, "from");
        assert_eq!(extract.bounds.expect("given").high, [3.0, 4.0]);
    }

    #[test]
    fn errors_say_where() {
        let error = read(b"<osm>\n<node id='x' lat='1' lon='1'/></osm>").expect_err("no id");
        assert!(matches!(error, OsmError::Xml { line: 2, .. }), "{error}");
        assert!(matches!(read(b"<osm><node id='1'"), Err(OsmError::Xml { .. })));
        assert!(read(b"<kml></kml>").is_err());
    }
}
