//! The area that a body sweeps while it follows a lane, its overhangs and the cutting-in of its rear included.

use super::design_vehicle::DesignVehicle;
use super::drawbar::{DRAWBAR, towed_heading};
use super::oriented_rectangle::OrientedRectangle;
use crate::{Lane, LaneId, Polyline, RoadNetwork};
use endless_world::VehicleSpec;
use endless_world::math::f64::{atan2, sin_cos};
use glam::{DVec2, DVec3};

/// Distance between the places at which bodies are compared, metres.
const STEP_M: f64 = 0.5;
/// Way on which a body comes to its posture before a lane begins, metres.
const RUN_UP_M: f64 = 12.0;
/// From the side of a body to its tyres, and what tyres may leave their lane by: the gutter, less what drivers stray.
const TYRE_M: f64 = 0.05;
const GUTTER_M: f64 = 0.25;
/// Bodies are apart where one is this much above the other, metres.
const STOREY_M: f64 = 3.0;

/// A rigid piece at a place: its axles are metres ahead of its own middle.
#[derive(Debug, Clone, Copy)]
struct PlacedBody {
    s: f64,
    print: OrientedRectangle,
    z: f64,
    axles: [f64; 2],
}

/// Where a body is, by the `s` of its origin on the lane; before its beginning and behind its end too.
#[derive(Debug, Clone)]
pub struct SweptPath {
    places: Vec<PlacedBody>,
    low: DVec2,
    high: DVec2,
    body: DesignVehicle,
}

/// A lane with what comes before it and after it.
struct ExtendedLane<'a> {
    before: Option<&'a Polyline>,
    lane: &'a Polyline,
    after: Option<&'a Polyline>,
}

impl ExtendedLane<'_> {
    fn at(&self, s: f64) -> DVec3 {
        let length = self.lane.length();
        let straight_on = |line: &Polyline, s: f64| {
            let on = line.position(s);
            let over = s - s.clamp(0.0, line.length());
            on + (line.direction(s) * over).extend(0.0)
        };
        match (self.before, self.after) {
            (Some(before), _) if s < 0.0 => straight_on(before, before.length() + s),
            (_, Some(after)) if s > length => straight_on(after, s - length),
            _ => straight_on(self.lane, s),
        }
    }
}

/// The piece that steers.
struct TowingBody {
    half: DVec2,
    /// Ahead of the body's origin, metres.
    middle: f64,
    axles: [f64; 2],
}

impl TowingBody {
    fn of(body: &DesignVehicle) -> Self {
        let rear = body.towed.map_or(-body.half.x, |d| d.towing_rear);
        let middle = 0.5 * (body.half.x + rear);
        let rear_axle = -body.rear_axle - middle;
        Self {
            half: DVec2::new(0.5 * (body.half.x - rear), body.half.y),
            middle,
            axles: [rear_axle + body.wheelbase, rear_axle],
        }
    }

    fn hitch(&self, pivot: DVec3, yaw: f64, pivot_x: f64, hitch_x: f64) -> DVec2 {
        let (sin, cos) = sin_cos(yaw);
        pivot.truncate() + DVec2::new(cos, sin) * (hitch_x - pivot_x)
    }
}

impl SweptPath {
    /// Along a lane from where the body begins to cover it to where it has left it.
    pub fn along(network: &RoadNetwork, lane: &Lane, body: DesignVehicle) -> Self {
        Self::between(network, lane, body, -body.half.x, lane.centerline.length() + body.half.x)
    }

    /// From one `s` of its origin to another.
    pub fn between(network: &RoadNetwork, lane: &Lane, body: DesignVehicle, from: f64, to: f64) -> Self {
        let line = |id: Option<&LaneId>| id.map(|&id| &network.lane(id).centerline);
        let course = ExtendedLane {
            before: line(lane.predecessors.first()),
            lane: &lane.centerline,
            after: line(lane.successors.first()),
        };
        let pivot_x = DRAWBAR * body.wheelbase - body.rear_axle;
        let steps = ((to - from + RUN_UP_M) / STEP_M).ceil().max(1.0) as usize;
        let begin = from - RUN_UP_M;
        let s_at = |k: usize| begin + (to - begin) * k as f64 / steps as f64;
        let mut pivot = course.at(s_at(0) + pivot_x);
        let first = course.at(s_at(0) + pivot_x + STEP_M) - pivot;
        let mut yaw = atan2(first.y, first.x);
        let rigid = TowingBody::of(&body);
        let mut trailer = body.towed.map(|d| (d, rigid.hitch(pivot, yaw, pivot_x, d.hitch), yaw));
        let mut places = Vec::with_capacity(steps + 1);
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for k in 0..=steps {
            let s = s_at(k);
            let next = course.at(s + pivot_x);
            let way = (next - pivot).truncate();
            if way.length_squared() > 1e-12 {
                yaw = towed_heading(yaw, atan2(way.y, way.x), way.length(), DRAWBAR * body.wheelbase);
            }
            pivot = next;
            if let Some((d, hitch, heading)) = &mut trailer {
                let next = rigid.hitch(pivot, yaw, pivot_x, d.hitch);
                let way = next - *hitch;
                if way.length_squared() > 1e-12 {
                    *heading = towed_heading(*heading, atan2(way.y, way.x), way.length(), d.hitch - d.axle);
                }
                *hitch = next;
            }
            if s < from - 1e-9 {
                continue;
            }
            let print = OrientedRectangle::of(rigid.half, pivot.truncate(), yaw).moved(rigid.middle - pivot_x);
            places.push(PlacedBody { s, print, z: pivot.z, axles: rigid.axles });
            if let Some((d, hitch, heading)) = trailer {
                // From the hitch to its middle.
                let middle = 0.5 * (d.front - body.half.x);
                let half = DVec2::new(0.5 * (d.front + body.half.x), body.half.y);
                let print = OrientedRectangle::of(half, hitch, heading).moved(middle - d.hitch);
                places.push(PlacedBody { s, print, z: pivot.z, axles: [d.axle - middle; 2] });
            }
        }
        for piece in &places {
            low = low.min(piece.print.center - body.reach());
            high = high.max(piece.print.center + body.reach());
        }
        Self { places, low, high, body }
    }

    /// Whether the tyres of the vehicle that is swept stay on these lanes, the middle one of which is followed.
    pub fn keeps_to(&self, spec: &VehicleSpec, way: &[&Lane]) -> bool {
        let across = 0.5 * f64::from(spec.width_m) - TYRE_M;
        let on_lane = |p: DVec2| {
            let places = way.iter().map(|lane| (lane.centerline.project(p), lane));
            let beside = places.filter(|((s, _), lane)| *s > 0.0 && *s < lane.centerline.length());
            let nearest = beside.min_by(|a, b| a.0.1.abs().total_cmp(&b.0.1.abs()));
            nearest.is_none_or(|((_, t), lane)| t.abs() < 0.5 * lane.width_m + GUTTER_M)
        };
        let tyres = |piece: &PlacedBody| {
            piece.axles.iter().all(|&x| [across, -across].iter().all(|&y| on_lane(piece.print.place(x, y))))
        };
        self.places.iter().all(tyres)
    }

    /// The footprints of all pieces of the body on the way, each with its height, metres.
    pub fn footprints(&self) -> impl Iterator<Item = (&OrientedRectangle, f64)> {
        self.places.iter().map(|place| (&place.print, place.z))
    }

    /// The ranges of `s` of the origin on both lanes within which two bodies can touch.
    pub fn touch(&self, other: &Self) -> Option<((f64, f64), (f64, f64))> {
        if self.low.cmpgt(other.high).any() || other.low.cmpgt(self.high).any() {
            return None;
        }
        let near = (self.body.reach() + other.body.reach()) * (self.body.reach() + other.body.reach());
        let mut found: Option<((f64, f64), (f64, f64))> = None;
        for PlacedBody { s, print, z, .. } in &self.places {
            for PlacedBody { s: t, print: theirs, z: their_z, .. } in &other.places {
                let close = print.center.distance_squared(theirs.center) < near && (z - their_z).abs() < STOREY_M;
                if !close || !print.overlaps(theirs) {
                    continue;
                }
                let (a, b) = found.unwrap_or(((*s, *s), (*t, *t)));
                found = Some(((a.0.min(*s), a.1.max(*s)), (b.0.min(*t), b.1.max(*t))));
            }
        }
        found
    }

    /// The same as ranges of arc length for bumpers: a front bumper enters at the first of each pair, a rear bumper
    /// has left at the second, which may be less.
    pub fn conflict(&self, other: &Self) -> Option<((f64, f64), (f64, f64))> {
        let (a, b) = self.touch(other)?;
        let bumpers = |r: (f64, f64), body: &DesignVehicle| ((r.0 + body.half.x).max(0.0), r.1 - body.half.x);
        Some((bumpers(a, &self.body), bumpers(b, &other.body)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lane(id: u32, points: &[(f64, f64)]) -> Lane {
        Lane::new(LaneId(id), Polyline::new(points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0))), 3.0, 14.0)
    }

    fn touch(a: &[(f64, f64)], b: &[(f64, f64)]) -> Option<((f64, f64), (f64, f64))> {
        let body = DesignVehicle { half: DVec2::new(2.5, 1.0), wheelbase: 2.8, rear_axle: 1.4, towed: None };
        let network = RoadNetwork { lanes: vec![lane(0, a), lane(1, b)], ..RoadNetwork::default() };
        let sweep = |k: usize| SweptPath::along(&network, &network.lanes[k], body);
        sweep(0).conflict(&sweep(1))
    }

    #[test]
    fn bodies_that_cross_meet_where_their_sides_do() {
        let ((from, to), _) = touch(&[(-20.0, 0.0), (20.0, 0.0)], &[(0.0, -20.0), (0.0, 20.0)]).expect("they cross");
        // The front bumper enters a metre before the other's middle, the rear leaves a metre behind it.
        assert!((from - 19.0).abs() < 0.6 && (to - 21.0).abs() < 0.6, "{from} {to}");
    }

    #[test]
    fn bodies_side_by_side_do_not_meet_unless_one_turns() {
        let straight = [(-20.0, 0.0), (20.0, 0.0)];
        assert!(touch(&straight, &[(20.0, 2.4), (-20.0, 2.4)]).is_none());
        assert!(touch(&straight, &[(20.0, 1.9), (-20.0, 1.9)]).is_some());
        // A bend whose middle stays 2.4 m away: the body in it swings nearer.
        let bend: Vec<(f64, f64)> = (0..=30)
            .map(|k| {
                let (sin, cos) = endless_world::math::f64::sin_cos(f64::from(k) * 0.1);
                (5.0 * cos, 7.4 - 5.0 * sin)
            })
            .collect();
        assert!(touch(&straight, &bend).is_some());
    }
}
