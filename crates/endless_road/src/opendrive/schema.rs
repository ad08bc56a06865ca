//! The elements of the standard, and which of them are used: what a file has beyond them is reported.

use super::xml::XmlElement;
use crate::ImportNote;
use std::collections::BTreeMap;

/// What becomes of an element.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ElementUse {
    /// It shapes the map.
    Used,
    /// It is known and means nothing for a map of this kind; not reported.
    Needless,
    /// It is known and not used: reported once a file.
    Unused,
}

use ElementUse::{Needless, Unused, Used};

/// One element: parent and name, use, attributes that are used or needless. An element without a parent may stand
/// anywhere. All children of an element that is not `Used` are like it.
pub(crate) const ELEMENTS: &[(&str, &str, ElementUse, &str)] = &[
    ("", "userData", Needless, ""),
    ("", "include", Unused, ""),
    ("", "dataQuality", Needless, ""),
    ("", "OpenDRIVE", Used, "schemaLocation xsi xmlns xodr noNamespaceSchemaLocation"),
    ("OpenDRIVE", "header", Used, "revMajor revMinor name version date north south east west vendor"),
    ("header", "geoReference", Used, ""),
    ("header", "offset", Unused, ""),
    ("header", "license", Needless, ""),
    ("header", "defaultRegulations", Unused, ""),
    ("OpenDRIVE", "road", Used, "id name length junction rule"),
    ("OpenDRIVE", "controller", Used, "id name sequence"),
    ("controller", "control", Used, "signalId type"),
    ("OpenDRIVE", "junction", Used, "id name type"),
    ("OpenDRIVE", "junctionGroup", Needless, ""),
    ("OpenDRIVE", "station", Unused, ""),
    ("road", "link", Used, ""),
    ("link", "predecessor", Used, "elementType elementId contactPoint id layer"),
    ("link", "successor", Used, "elementType elementId contactPoint id layer"),
    ("link", "neighbor", Needless, ""),
    ("road", "type", Used, "s type country"),
    ("type", "speed", Used, "max unit"),
    ("road", "planView", Used, ""),
    ("planView", "geometry", Used, "s x y hdg length"),
    ("geometry", "line", Used, ""),
    ("geometry", "arc", Used, "curvature"),
    ("geometry", "spiral", Used, "curvStart curvEnd"),
    ("geometry", "poly3", Used, "a b c d"),
    ("geometry", "paramPoly3", Used, "aU bU cU dU aV bV cV dV pRange"),
    ("road", "elevationProfile", Used, ""),
    ("elevationProfile", "elevation", Used, "s a b c d"),
    ("road", "lateralProfile", Used, ""),
    ("lateralProfile", "superelevation", Used, "s a b c d"),
    ("lateralProfile", "shape", Used, "s t a b c d"),
    ("lateralProfile", "crossfall", Used, "side s a b c d"),
    ("lateralProfile", "crossSectionSurface", Unused, ""),
    ("road", "lanes", Used, ""),
    ("lanes", "laneOffset", Used, "s a b c d"),
    ("lanes", "laneSection", Used, "s singleSide"),
    ("laneSection", "left", Used, ""),
    ("laneSection", "center", Used, ""),
    ("laneSection", "right", Used, ""),
    ("left", "lane", Used, "id type level direction advisory dynamicLaneDirection dynamicLaneType roadWorks"),
    ("center", "lane", Used, "id type level direction advisory dynamicLaneDirection dynamicLaneType roadWorks"),
    ("right", "lane", Used, "id type level direction advisory dynamicLaneDirection dynamicLaneType roadWorks"),
    ("lane", "link", Used, ""),
    ("lane", "width", Used, "sOffset a b c d"),
    ("lane", "border", Used, "sOffset a b c d"),
    ("lane", "height", Used, "sOffset inner outer"),
    ("lane", "speed", Used, "sOffset max unit"),
    ("lane", "material", Used, "sOffset surface friction roughness"),
    ("lane", "access", Unused, ""),
    ("lane", "rule", Unused, ""),
    ("lane", "visibility", Needless, ""),
    ("lane", "roadMark", Used, "sOffset type weight color material width laneChange height"),
    ("roadMark", "type", Used, "name width"),
    ("roadMark", "explicit", Used, ""),
    ("roadMark", "sway", Unused, ""),
    ("type", "line", Used, "length space tOffset sOffset rule width color"),
    ("explicit", "line", Used, "length tOffset sOffset rule width"),
    ("road", "signals", Used, ""),
    (
        "signals",
        "signal",
        Used,
        "id name s t zOffset hOffset roll pitch orientation dynamic country countryRevision type subtype value unit text \
         height width length temporary",
    ),
    ("signals", "signalReference", Used, "id s t orientation"),
    ("signal", "validity", Used, "fromLane toLane"),
    ("signal", "dependency", Needless, ""),
    ("signal", "reference", Needless, ""),
    ("signal", "positionInertial", Used, "x y z hdg pitch roll"),
    ("signal", "positionRoad", Used, "roadId s t zOffset hOffset pitch roll"),
    ("signal", "semantics", Needless, ""),
    ("signalReference", "validity", Used, "fromLane toLane"),
    ("road", "objects", Used, ""),
    (
        "objects",
        "object",
        Used,
        "id name type subtype s t zOffset hdg roll pitch orientation length width height radius dynamic validLength perpToRoad",
    ),
    ("objects", "bridge", Used, "s length name id type"),
    ("objects", "tunnel", Unused, ""),
    ("objects", "objectReference", Unused, ""),
    ("object", "outline", Used, "id fillType closed outer laneType"),
    ("object", "outlines", Used, ""),
    ("outlines", "outline", Used, "id fillType closed outer laneType"),
    ("outline", "cornerLocal", Used, "u v z height id"),
    ("outline", "cornerRoad", Used, "s t dz height id"),
    (
        "object",
        "repeat",
        Used,
        "s length distance tStart tEnd zOffsetStart zOffsetEnd heightStart heightEnd widthStart widthEnd lengthStart \
         lengthEnd radiusStart radiusEnd detachFromReferenceLine",
    ),
    ("object", "validity", Needless, ""),
    ("object", "parkingSpace", Needless, ""),
    ("object", "material", Needless, ""),
    ("object", "markings", Unused, ""),
    ("object", "borders", Unused, ""),
    ("object", "surface", Unused, ""),
    ("object", "skeleton", Unused, ""),
    ("road", "surface", Unused, ""),
    ("road", "railroad", Unused, ""),
    ("junction", "connection", Used, "id type incomingRoad connectingRoad linkedRoad contactPoint connectionMaster"),
    ("connection", "laneLink", Used, "from to overlapZone"),
    ("connection", "predecessor", Unused, ""),
    ("connection", "successor", Unused, ""),
    ("junction", "priority", Used, "high low"),
    ("junction", "controller", Used, "id type sequence"),
    ("junction", "surface", Unused, ""),
    ("junction", "boundary", Unused, ""),
    ("junction", "elevationGrid", Unused, ""),
    ("junction", "roadSection", Unused, ""),
    ("junction", "crossPath", Unused, ""),
    ("junction", "trafficIsland", Unused, ""),
    ("junction", "planView", Needless, ""),
    ("junction", "objects", Unused, ""),
];

/// Elements and attributes of a file that are not used, each kind once with its first place and how often it occurs.
pub(crate) fn unknown_parts(root: &XmlElement) -> Vec<ImportNote> {
    let mut table: BTreeMap<(&str, &str), (ElementUse, &str)> = BTreeMap::new();
    for &(parent, name, using, attributes) in ELEMENTS {
        table.insert((parent, name), (using, attributes));
    }
    // What, first line, how often; in the order of the file.
    let mut found: Vec<(String, usize, usize)> = Vec::new();
    let mut place: BTreeMap<String, usize> = BTreeMap::new();
    let mut report = |what: String, line: usize| match place.get(&what) {
        Some(&at) => found[at].2 += 1,
        None => {
            place.insert(what.clone(), found.len());
            found.push((what, line, 1));
        }
    };
    let mut open: Vec<(&XmlElement, &str)> = vec![(root, "")];
    while let Some((element, parent)) = open.pop() {
        let entry = table.get(&(parent, element.name.as_str())).or_else(|| table.get(&("", element.name.as_str())));
        let inside = if parent.is_empty() { String::new() } else { format!(" in <{parent}>") };
        match entry {
            None => report(format!("<{}>{inside} is not known", clip(&element.name)), element.line),
            Some((Unused, _)) => report(format!("<{}>{inside} is not used", element.name), element.line),
            Some((Needless, _)) => {}
            Some((Used, attributes)) => {
                for (name, _) in &element.attributes {
                    if !attributes.split(' ').any(|known| known == name) {
                        report(format!("attribute {} of <{}> is not known", clip(name), element.name), element.line);
                    }
                }
                open.extend(element.children.iter().rev().map(|child| (child, element.name.as_str())));
            }
        }
    }
    let note = |(what, line, times): (String, usize, usize)| {
        let more = if times > 1 { format!(", {times} times") } else { String::new() };
        ImportNote { place: format!("line {line}"), text: format!("{what}{more}") }
    };
    found.into_iter().map(note).collect()
}

fn clip(name: &str) -> &str {
    name.char_indices().nth(60).map_or(name, |(at, _)| &name[..at])
}

#[cfg(test)]
mod tests {
    use super::super::xml::tree;
    use super::*;

    #[test]
    fn strangers_are_reported_once_with_their_place() {
        let text = "<OpenDRIVE>\n<road id='1' mood='glad'>\n<hat/>\n<hat/>\n<userData><any/></userData>\n<railroad/></road></OpenDRIVE>";
        let notes = unknown_parts(&tree(text).unwrap());
        let lines: Vec<String> = notes.iter().map(|n| format!("{}: {}", n.place, n.text)).collect();
        assert_eq!(
            lines,
            [
                "line 2: attribute mood of <road> is not known",
                "line 3: <hat> in <road> is not known, 2 times",
                "line 6: <railroad> in <road> is not used"
            ]
        );
    }

    #[test]
    fn the_table_in_the_docs_is_true() {
        let text = include_str!("../../../../docs/opendrive.md");
        for &(parent, name, using, attributes) in ELEMENTS {
            let parent = if parent.is_empty() { "any" } else { parent };
            let (attributes, word) = match using {
                Used if name == "OpenDRIVE" => ("", "read"),
                Used => (attributes, "read"),
                Needless => ("", "means nothing here"),
                Unused => ("", "reported"),
            };
            let row = format!("| {parent} | `{name}` | {attributes} | {word} |");
            assert!(text.contains(&row), "docs/opendrive.md lacks {row}");
        }
        assert_eq!(text.matches("\n| ").count(), ELEMENTS.len() + 1);
    }
}
