//! An XML file as a tree whose every element knows its line.

use super::OpenDriveError;
use crate::LineNumbers;
use crate::error::one_line;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

/// Elements deeper than this are not a road network.
const DEEPEST: usize = 64;

/// One element.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct XmlElement {
    /// Name, without a namespace's prefix.
    pub(crate) name: String,
    /// Line in the file, from 1.
    pub(crate) line: usize,
    /// In the order of the file.
    pub(crate) attributes: Vec<(String, String)>,
    /// In the order of the file.
    pub(crate) children: Vec<XmlElement>,
    /// Text directly inside, trimmed.
    pub(crate) text: String,
}

impl XmlElement {
    /// The value of an attribute.
    pub(crate) fn attribute(&self, name: &str) -> Option<&str> {
        self.attributes.iter().find(|(key, _)| key == name).map(|(_, value)| value.as_str())
    }

    /// The children of this name.
    pub(crate) fn all<'a>(&'a self, name: &'a str) -> impl Iterator<Item = &'a XmlElement> {
        self.children.iter().filter(move |child| child.name == name)
    }

    /// The first child of this name.
    pub(crate) fn first(&self, name: &str) -> Option<&XmlElement> {
        self.children.iter().find(|child| child.name == name)
    }
}

/// The root element of a file.
pub(crate) fn tree(text: &str) -> Result<XmlElement, OpenDriveError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut reader = Reader::from_str(text);
    let mut lines = LineNumbers::new(text);
    let mut open: Vec<XmlElement> = Vec::new();
    loop {
        let line = lines.of(reader.buffer_position() as usize);
        let event = reader.read_event().map_err(|error| {
            let line = lines.of(reader.error_position() as usize);
            OpenDriveError::Xml { line, what: one_line(&error.to_string()) }
        })?;
        match event {
            Event::Start(start) => {
                if open.len() >= DEEPEST {
                    let what = format!("elements are nested deeper than {DEEPEST}");
                    return Err(OpenDriveError::Xml { line, what });
                }
                open.push(element(&start, lines.of(reader.buffer_position() as usize))?);
            }
            Event::Empty(start) => {
                let done = element(&start, lines.of(reader.buffer_position() as usize))?;
                match open.last_mut() {
                    Some(parent) => parent.children.push(done),
                    None => return Ok(done),
                }
            }
            Event::End(_) => {
                // The reader has checked that the names match, so there is one.
                let Some(done) = open.pop() else { continue };
                match open.last_mut() {
                    Some(parent) => parent.children.push(done),
                    None => return Ok(done),
                }
            }
            Event::Text(words) => append(&mut open, &words),
            Event::CData(words) => append(&mut open, &words),
            Event::Eof => {
                let what = match open.last() {
                    Some(element) => {
                        format!("the file ends inside <{}> of line {}", one_line(&element.name), element.line)
                    }
                    None => "there is no element in the file".to_owned(),
                };
                return Err(OpenDriveError::Xml { line, what });
            }
            _ => {}
        }
    }
}

fn append(open: &mut [XmlElement], words: &str) {
    if let Some(element) = open.last_mut() {
        element.text.push_str(words.trim());
    }
}

fn element(start: &BytesStart<'_>, line: usize) -> Result<XmlElement, OpenDriveError> {
    let mut attributes = Vec::new();
    for attribute in start.attributes() {
        let attribute = attribute.map_err(|error| OpenDriveError::Xml { line, what: one_line(&error.to_string()) })?;
        let raw = &attribute.value;
        let value = quick_xml::escape::unescape(raw).map_or_else(|_| raw.to_string(), std::borrow::Cow::into_owned);
        attributes.push((attribute.key.local_name().into_inner().to_owned(), value));
    }
    let name = start.local_name().into_inner().to_owned();
    Ok(XmlElement { name, line, attributes, children: Vec::new(), text: String::new() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn elements_know_their_lines() {
        let root =
            tree("<?xml version='1.0'?>\n<!-- a\nb -->\n<a x='1 &lt; 2'>\n <b/>\n t\n <c><d y=\"3\"/></c>\n</a>")
                .unwrap();
        assert_eq!(
            (root.name.as_str(), root.line, root.attribute("x"), root.text.as_str()),
            ("a", 4, Some("1 < 2"), "t")
        );
        assert_eq!(root.first("b").unwrap().line, 5);
        assert_eq!(root.first("c").unwrap().all("d").next().unwrap().line, 7);
    }

    #[test]
    fn broken_files_say_where() {
        for (text, words) in [
            ("", "no element"),
            ("<a>\n<b>\n</a>", "line 3"),
            ("<a>\n<b x=1/>", "line 2"),
            ("<a>\n<b>", "inside <b> of line 2"),
            ("just text", "no element"),
        ] {
            let error = tree(text).unwrap_err().to_string();
            assert!(error.contains(words), "{text:?}: {error}");
            assert!(!error.contains('\n'), "{error}");
        }
        assert!(tree(&"<a>".repeat(100)).unwrap_err().to_string().contains("deeper"));
    }
}
