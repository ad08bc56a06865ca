//! Roads: links, reference line, profiles.

use super::super::OpenDriveError;
use super::super::document::{Crossfall, Curve, End, Geometry, Road, RoadLink, RoadType, Shape};
use super::super::geometry::Piece;
use super::super::xml::Element;
use super::fields::{Fields, format_error, text};
use glam::DVec2;

/// Longer than this is no road, metres.
const LONGEST_M: f64 = 200_000.0;
/// A curve this many times as long as its file says is a mistake.
const MOST_STRETCH: f64 = 10.0;
/// Jumps of the reference line that are told, and those that make no road, metres.
const QUIET_JUMP_M: f64 = 0.2;
const MOST_JUMP_M: f64 = 100.0;
/// Sharper than this is no road, 1/m.
const SHARPEST: f64 = 10.0;

impl Fields {
    pub(super) fn road(&mut self, element: &Element) -> Result<Road, OpenDriveError> {
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
            predecessor: link.and_then(|l| l.first("predecessor")).and_then(|l| self.road_link(l, End::End)),
            successor: link.and_then(|l| l.first("successor")).and_then(|l| self.road_link(l, End::Start)),
            elevation: self.cubics(element.first("elevationProfile"), "elevation", "s")?,
            superelevation: self.cubics(lateral, "superelevation", "s")?,
            ..Road::default()
        };
        for kind in element.all("type") {
            let speed = kind.first("speed").and_then(|speed| self.speed(speed));
            road.types.push(RoadType { s: self.number_or(kind, "s", 0.0), kind: text(kind, "type"), speed });
        }
        road.types.sort_by(|a, b| a.s.total_cmp(&b.s));
        for shape in lateral.into_iter().flat_map(|profile| profile.all("shape")) {
            let (s, t) = (self.number(shape, "s")?, self.number(shape, "t")?);
            road.shapes.push(Shape { s, t, abcd: self.four(shape, ["a", "b", "c", "d"])? });
        }
        for crossfall in lateral.into_iter().flat_map(|profile| profile.all("crossfall")) {
            let sides = match crossfall.attribute("side") {
                Some("left") => [true, false],
                Some("right") => [false, true],
                _ => [true, true],
            };
            road.crossfalls.push(Crossfall { sides, angle: self.cubic(crossfall, "s")? });
        }
        road.crossfalls.sort_by(|a, b| a.angle.s.total_cmp(&b.angle.s));
        road.shapes.sort_by(|a, b| a.s.total_cmp(&b.s).then(a.t.total_cmp(&b.t)));
        self.read_plan_view(element, &mut road)?;
        let Some(lanes) = element.first("lanes") else {
            return Err(format_error(element, format!("{} has no <lanes>", road.id)));
        };
        road.lane_offset = self.cubics(Some(lanes), "laneOffset", "s")?;
        road.sections = self.lane_sections(lanes)?;
        self.read_signals(element, &mut road)?;
        self.read_objects(element, &mut road)?;
        Ok(road)
    }

    fn road_link(&mut self, element: &Element, default: End) -> Option<RoadLink> {
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

    fn read_plan_view(&mut self, element: &Element, road: &mut Road) -> Result<(), OpenDriveError> {
        for geometry in element.first("planView").into_iter().flat_map(|view| view.all("geometry")) {
            let length = self.number(geometry, "length")?;
            if length < 0.0 {
                return Err(format_error(geometry, format!("has the negative length {length}")));
            }
            // A piece without extent adds nothing, but its neighbours are good.
            if length < 1e-9 {
                continue;
            }
            let piece = Geometry {
                s: self.number(geometry, "s")?,
                x: self.number(geometry, "x")?,
                y: self.number(geometry, "y")?,
                heading: self.number(geometry, "hdg")?,
                length,
                shape: self.curve(geometry)?,
            };
            let stretch = if length > LONGEST_M { 1.0 } else { Piece::new(&piece).stretch() };
            if stretch > MOST_STRETCH {
                let what = format!("is {:.0} m long, but its length is given as {length}", stretch * length);
                return Err(format_error(geometry, what));
            }
            if (stretch - 1.0).abs() > 0.01 && (stretch - 1.0).abs() * length > 0.05 {
                self.note(geometry, format!("is {:.2} m long, but its length is given as {length}", stretch * length));
            }
            road.plan_view.push(piece);
        }
        road.plan_view.sort_by(|a, b| a.s.total_cmp(&b.s));
        self.check_joints(element, road)?;
        let Some(last) = road.plan_view.last() else {
            return Err(format_error(element, format!("{} has no reference line", road.id)));
        };
        road.length = last.s + last.length;
        if road.length > LONGEST_M {
            let what = format!("{} is {:.0} km long, which no road of a map is", road.id, road.length / 1000.0);
            return Err(format_error(element, what));
        }
        let stated = self.number_or(element, "length", road.length);
        if (stated - road.length).abs() > 0.01 {
            self.note(element, format!("length {stated} is not that of its reference line, {:.3}", road.length));
        }
        Ok(())
    }

    /// Pieces of the reference line begin where those before them end, or nearly so.
    fn check_joints(&mut self, element: &Element, road: &Road) -> Result<(), OpenDriveError> {
        let mut farthest = (0.0, 0.0);
        for pair in road.plan_view.windows(2).filter(|pair| pair[0].length < LONGEST_M) {
            let end = Piece::new(&pair[0]).pose(pair[0].length).position;
            let gap = end.distance(DVec2::new(pair[1].x, pair[1].y));
            if gap > farthest.0 {
                farthest = (gap, pair[1].s);
            }
        }
        let (gap, s) = farthest;
        let text = || format!("{} has a reference line that jumps by {gap:.2} m at s={s}", road.id);
        if gap > MOST_JUMP_M {
            return Err(format_error(element, text()));
        }
        if gap > QUIET_JUMP_M {
            self.note(element, text());
        }
        Ok(())
    }

    fn curve(&mut self, geometry: &Element) -> Result<Curve, OpenDriveError> {
        let gentle = |element: &Element, value: f64| {
            if value.abs() <= SHARPEST {
                Ok(value)
            } else {
                Err(format_error(element, format!("has the curvature {value}, sharper than {SHARPEST} per metre")))
            }
        };
        for child in &geometry.children {
            return Ok(match child.name.as_str() {
                "line" => Curve::Line,
                "arc" => Curve::Arc(gentle(child, self.number(child, "curvature")?)?),
                "spiral" => Curve::Spiral(
                    gentle(child, self.number(child, "curvStart")?)?,
                    gentle(child, self.number(child, "curvEnd")?)?,
                ),
                "poly3" => Curve::Poly3(self.four(child, ["a", "b", "c", "d"])?),
                "paramPoly3" => Curve::ParamPoly3 {
                    u: self.four(child, ["aU", "bU", "cU", "dU"])?,
                    v: self.four(child, ["aV", "bV", "cV", "dV"])?,
                    // The default of 1.4; later versions require it.
                    normalized: child.attribute("pRange") != Some("arcLength"),
                },
                _ => continue,
            });
        }
        Err(format_error(geometry, "has no line, arc, spiral, poly3 or paramPoly3"))
    }
}
