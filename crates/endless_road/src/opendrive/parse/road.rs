//! Roads: links, profiles.

use super::super::document::{ContactPoint, Crossfall, LateralShape, Road, RoadLink, RoadType};
use super::super::xml::XmlElement;
use super::fields::{ElementError, ElementFields, text};

impl ElementFields {
    pub(super) fn road(&mut self, element: &XmlElement) -> Result<Road, ElementError> {
        let link = element.first("link");
        let lateral = element.first("lateralProfile");
        let mut road = Road {
            id: text(element, "id"),
            line: element.line,
            name: text(element, "name"),
            junction: element
                .attribute("junction")
                .map(str::trim)
                .filter(|id| !matches!(*id, "-1" | ""))
                .map(str::to_owned),
            left_hand: element.attribute("rule").is_some_and(|rule| rule.trim() == "LHT"),
            predecessor: link.and_then(|l| l.first("predecessor")).and_then(|l| self.road_link(l, ContactPoint::End)),
            successor: link.and_then(|l| l.first("successor")).and_then(|l| self.road_link(l, ContactPoint::Start)),
            elevation: self.cubics(element.first("elevationProfile"), "elevation", "s"),
            superelevation: self.cubics(lateral, "superelevation", "s"),
            ..Road::default()
        };
        for kind in element.all("type") {
            let speed = kind.first("speed").and_then(|speed| self.speed(speed));
            road.types.push(RoadType { s: self.number_or(kind, "s", 0.0), kind: text(kind, "type"), speed });
        }
        road.types.sort_by(|a, b| a.s.total_cmp(&b.s));
        for shape in lateral.into_iter().flat_map(|profile| profile.all("shape")) {
            let read = self.shape(shape);
            road.shapes.extend(self.keep(read));
        }
        for crossfall in lateral.into_iter().flat_map(|profile| profile.all("crossfall")) {
            let sides = match crossfall.attribute("side") {
                Some("left") => [true, false],
                Some("right") => [false, true],
                _ => [true, true],
            };
            let read = self.cubic(crossfall, "s");
            road.crossfalls.extend(self.keep(read).map(|angle| Crossfall { sides, angle }));
        }
        road.crossfalls.sort_by(|a, b| a.angle.s.total_cmp(&b.angle.s));
        road.shapes.sort_by(|a, b| a.s.total_cmp(&b.s).then(a.t.total_cmp(&b.t)));
        self.read_plan_view(element, &mut road)?;
        let Some(lanes) = element.first("lanes") else {
            return Err(ElementError::new(element, format!("{} has no <lanes>", road.id)));
        };
        road.lane_offset = self.cubics(Some(lanes), "laneOffset", "s");
        road.sections = self.lane_sections(lanes)?;
        self.read_signals(element, &mut road);
        self.read_objects(element, &mut road);
        Ok(road)
    }

    fn shape(&self, element: &XmlElement) -> Result<LateralShape, ElementError> {
        let (s, t) = (self.number(element, "s")?, self.number(element, "t")?);
        Ok(LateralShape { s, t, abcd: self.four(element, ["a", "b", "c", "d"])? })
    }

    fn road_link(&mut self, element: &XmlElement, default: ContactPoint) -> Option<RoadLink> {
        let id = text(element, "elementId");
        match element.attribute("elementType") {
            Some("junction") => Some(RoadLink::Junction { id }),
            Some("road") | None => Some(RoadLink::Road { id, contact: self.contact(element, default) }),
            Some(_) => {
                self.note(element, "elementType is neither road nor junction".to_owned());
                None
            }
        }
    }
}
