//! The reference line: curves as they are written, and what takes the place of those that no road can follow.

use super::super::document::{ContactPoint, GeometryType, PlanViewGeometry, Road, RoadLink};
use super::super::geometry::{PlanViewCurve, PlanViewPose};
use super::super::xml::XmlElement;
use super::fields::{ElementError, ElementFields};
use endless_world::math::f64::sin_cos;
use glam::DVec2;
use std::f64::consts::PI;

/// Longer than this is no road, metres.
const LONGEST_M: f64 = 200_000.0;
/// A curve this many times as long as its file says is a mistake.
const MOST_STRETCH: f64 = 10.0;
/// Jumps of the reference line that are told, and those that make no road, metres.
const QUIET_JUMP_M: f64 = 0.2;
const MOST_JUMP_M: f64 = 100.0;
/// Sharper than this is no road, 1/m.
const SHARPEST: f64 = 10.0;
/// In place of an impossible curve, a cubic leads to where the road goes on if that is between these shares of its
/// length away.
const BRIDGED: std::ops::Range<f64> = 0.2..1.05;

impl ElementFields {
    pub(super) fn read_plan_view(&mut self, element: &XmlElement, road: &mut Road) -> Result<(), ElementError> {
        let mut impossible = Vec::new();
        for geometry in element.first("planView").into_iter().flat_map(|view| view.all("geometry")) {
            let start = self.straight(geometry);
            // A piece without extent adds nothing, but its neighbours are good.
            let Some(start) = self.keep(start).filter(|start| start.length >= 1e-9) else { continue };
            match self.curved(geometry, start) {
                Ok(read) => road.plan_view.push(read),
                Err(error) => {
                    impossible.push((start.s, error));
                    road.plan_view.push(start);
                }
            }
        }
        road.plan_view.sort_by(|a, b| a.s.total_cmp(&b.s));
        for (s, error) in impossible {
            let at = road.plan_view.partition_point(|geometry| geometry.s < s);
            self.notes.push(error.note("a curve that can be driven takes its place"));
            match road.plan_view.get(at + 1) {
                Some(next) => road.plan_view[at].shape = bridge(&road.plan_view[at], beginning(next)),
                None => self.loose_end = true,
            }
        }
        self.check_joints(element, road)?;
        let Some(last) = road.plan_view.last() else {
            return Err(ElementError::new(element, format!("{} has no reference line", road.id)));
        };
        road.length = last.s + last.length;
        if road.length > LONGEST_M {
            let what = format!("{} is {:.0} km long, which no road of a map is", road.id, road.length / 1000.0);
            return Err(ElementError::new(element, what));
        }
        let stated = self.number_or(element, "length", road.length);
        if (stated - road.length).abs() > 0.01 {
            self.note(element, format!("length {stated} is not that of its reference line, {:.3}", road.length));
        }
        Ok(())
    }

    /// Where a geometry begins and how long it is, as if it were straight.
    fn straight(&self, geometry: &XmlElement) -> Result<PlanViewGeometry, ElementError> {
        let length = self.number(geometry, "length")?;
        if length < 0.0 {
            return Err(ElementError::new(geometry, format!("has the negative length {length}")));
        }
        if length > LONGEST_M {
            let what = format!("is {:.0} km long, which no road of a map is", length / 1000.0);
            return Err(ElementError::new(geometry, what));
        }
        Ok(PlanViewGeometry {
            s: self.number(geometry, "s")?,
            x: self.number(geometry, "x")?,
            y: self.number(geometry, "y")?,
            heading: self.number(geometry, "hdg")?,
            length,
            shape: GeometryType::Line,
        })
    }

    /// With the curve that it is.
    fn curved(&mut self, geometry: &XmlElement, straight: PlanViewGeometry) -> Result<PlanViewGeometry, ElementError> {
        let length = straight.length;
        let read = PlanViewGeometry { shape: self.curve(geometry)?, ..straight };
        let stretch = PlanViewCurve::new(&read).stretch();
        let text = || format!("is {:.2} m long, but its length is given as {length}", stretch * length);
        if stretch > MOST_STRETCH {
            return Err(ElementError::new(geometry, text()));
        }
        if (stretch - 1.0).abs() > 0.01 && (stretch - 1.0).abs() * length > 0.05 {
            self.note(geometry, text());
        }
        Ok(read)
    }

    /// Pieces of the reference line begin where those before them end, or nearly so.
    fn check_joints(&mut self, element: &XmlElement, road: &Road) -> Result<(), ElementError> {
        let mut farthest = (0.0, 0.0);
        for pair in road.plan_view.windows(2) {
            let end = PlanViewCurve::new(&pair[0]).pose(pair[0].length).position;
            let gap = end.distance(DVec2::new(pair[1].x, pair[1].y));
            if gap > farthest.0 {
                farthest = (gap, pair[1].s);
            }
        }
        let (gap, s) = farthest;
        let text = || format!("{} has a reference line that jumps by {gap:.2} m at s={s}", road.id);
        if gap > MOST_JUMP_M {
            return Err(ElementError::new(element, text()));
        }
        if gap > QUIET_JUMP_M {
            self.note(element, text());
        }
        Ok(())
    }

    fn curve(&self, geometry: &XmlElement) -> Result<GeometryType, ElementError> {
        let gentle = |element: &XmlElement, value: f64| {
            if value.abs() <= SHARPEST {
                Ok(value)
            } else {
                let what = format!("has the curvature {value}, sharper than {SHARPEST} per metre");
                Err(ElementError::new(element, what))
            }
        };
        for child in &geometry.children {
            return Ok(match child.name.as_str() {
                "line" => GeometryType::Line,
                "arc" => GeometryType::Arc(gentle(child, self.number(child, "curvature")?)?),
                "spiral" => GeometryType::Spiral(
                    gentle(child, self.number(child, "curvStart")?)?,
                    gentle(child, self.number(child, "curvEnd")?)?,
                ),
                "poly3" => GeometryType::Poly3(self.four(child, ["a", "b", "c", "d"])?),
                "paramPoly3" => GeometryType::ParamPoly3 {
                    u: self.four(child, ["aU", "bU", "cU", "dU"])?,
                    v: self.four(child, ["aV", "bV", "cV", "dV"])?,
                    // The default of 1.4; later versions require it.
                    normalized: child.attribute("pRange") != Some("arcLength"),
                },
                _ => continue,
            });
        }
        Err(ElementError::new(geometry, "has no line, arc, spiral, poly3 or paramPoly3"))
    }
}

/// Leads the last geometry of a road, which was impossible, to where the next road begins.
pub(super) fn close_end_gap(roads: &mut [Road], place: usize) {
    let Some(RoadLink::Road { id, contact }) = &roads[place].successor else { return };
    let Some(next) = roads.iter().find(|road| road.id == *id && road.id != roads[place].id) else { return };
    let there = match (contact, next.plan_view.first(), next.plan_view.last()) {
        (ContactPoint::Start, Some(first), _) => beginning(first),
        (ContactPoint::End, _, Some(last)) => {
            let end = PlanViewCurve::new(last).pose(last.length);
            PlanViewPose { heading: end.heading + PI, ..end }
        }
        _ => return,
    };
    if let Some(last) = roads[place].plan_view.last_mut() {
        last.shape = bridge(last, there);
    }
}

fn beginning(geometry: &PlanViewGeometry) -> PlanViewPose {
    PlanViewPose { position: DVec2::new(geometry.x, geometry.y), heading: geometry.heading }
}

/// Hermite's cubic from where a geometry begins to where the road goes on, if that can be reached within its length; a
/// straight line otherwise.
fn bridge(geometry: &PlanViewGeometry, next: PlanViewPose) -> GeometryType {
    let way = next.position - DVec2::new(geometry.x, geometry.y);
    let chord = way.length();
    if !BRIDGED.contains(&(chord / geometry.length)) {
        return GeometryType::Line;
    }
    let (sin, cos) = sin_cos(geometry.heading);
    let end = DVec2::new(cos * way.x + sin * way.y, cos * way.y - sin * way.x);
    let (sin, cos) = sin_cos(next.heading - geometry.heading);
    let (from, to) = (DVec2::new(chord, 0.0), DVec2::new(cos, sin) * chord);
    let [b, c, d] = [from, 3.0 * end - 2.0 * from - to, from + to - 2.0 * end];
    GeometryType::ParamPoly3 { u: [0.0, b.x, c.x, d.x], v: [0.0, b.y, c.y, d.y], normalized: true }
}
