//! From the tree of elements to an [`OpenDriveDocument`].

mod fields;
mod junction;
mod lane;
mod object;
mod plan_view;
mod road;

use super::document::OpenDriveDocument;
use super::xml::{self, XmlElement};
use super::{OpenDriveError, schema};
use fields::ElementFields;
pub(super) use fields::FARTHEST_M;

impl OpenDriveDocument {
    /// Reads a file's text. An element that makes no sense is mended or left out, with a note: the rest of the map is
    /// good.
    ///
    /// # Errors
    /// If it is not well-formed XML, with the line, or another kind of file.
    pub fn parse(text: &str) -> Result<Self, OpenDriveError> {
        let root = xml::tree(text)?;
        if root.name != "OpenDRIVE" {
            let what = "is not <OpenDRIVE>: this is another kind of file".to_owned();
            return Err(OpenDriveError::Format { line: root.line, element: root.name, what });
        }
        let mut fields = ElementFields::default();
        let mut document = OpenDriveDocument::default();
        if let Some(header) = root.first("header") {
            read_header(header, &mut fields, &mut document);
        }
        let mut loose_ends = Vec::new();
        for element in root.all("road") {
            fields.loose_end = false;
            match fields.road(element) {
                Ok(road) => {
                    loose_ends.extend(fields.loose_end.then_some(document.roads.len()));
                    document.roads.push(road);
                }
                Err(error) => document.roads_left_out.push(error.note("the road was left out")),
            }
        }
        for place in loose_ends {
            plan_view::close_end_gap(&mut document.roads, place);
        }
        document.junctions = root.all("junction").map(|element| fields.junction(element)).collect();
        document.controllers = root.all("controller").map(|element| fields.controller(element)).collect();
        document.notes = schema::unknown_parts(&root);
        document.notes.extend(fields.notes);
        Ok(document)
    }
}

fn read_header(header: &XmlElement, fields: &mut ElementFields, document: &mut OpenDriveDocument) {
    let revision = |name: &str| header.attribute(name).and_then(|v| v.trim().parse().ok()).unwrap_or(0);
    document.revision = (revision("revMajor"), revision("revMinor"));
    if document.revision.0 != 1 {
        fields.note(header, format!("revision {} is read as if it were 1", document.revision.0));
    }
    document.lanes_end_at_stops = header
        .all("userData")
        .any(|data| data.attribute("code") == Some("laneEnds") && data.attribute("value") == Some("stop"));
    document.name = header.attribute("name").unwrap_or_default().to_owned();
    document.georeference = header.first("geoReference").map(|g| g.text.clone()).filter(|text| !text.is_empty());
    if header.first("offset").is_some() {
        let what = "the offset is not added: coordinates stay as the file has them";
        fields.note(header, what.to_owned());
    }
}
