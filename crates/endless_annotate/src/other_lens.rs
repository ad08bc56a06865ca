//! Lines, areas and boxes of the world as lenses show them that are not perspective: a straight line is a curve there, and
//! a picture of all directions ends at a seam, where its left and right edges meet.

use crate::image_shape::{ImageLine, image_point, world_point};
use crate::lens_projection::{LensProjection, MOST_DEVIATION_PX, distance_to_segment};
use crate::polygon::cut;
use crate::way_inside::WayInside;
use endless_world::{Fisheye, Lens, math::f64 as math};
use glam::{DVec2, DVec3};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// A fisheye, an equirectangular lens, or one of parallel rays.
pub(crate) struct OtherLens<'a> {
    pub(crate) lens: &'a LensProjection,
    pub(crate) other: &'a Lens,
    /// Nothing deeper is told of, metres.
    pub(crate) far_m: f64,
}

/// What is nearer is not told of, metres.
const NEAR_M: f64 = 0.1;
/// Lines end this much within the image circle, radians: who projects them in single precision still finds them there.
const RIM_RAD: f64 = 1e-4;
/// Largest angle between neighbouring points of a line, as the lens sees it, radians.
const STEP_RAD: f64 = 0.03;
const MOST_HALVINGS: u32 = 14;
/// Sides of the polygon that stands for the image circle.
const CIRCLE_SIDES: u32 = 256;

/// A point of the camera's frame and its pixel.
type Placed = (DVec3, DVec2);

impl OtherLens<'_> {
    /// The pixel of a point of the camera's frame; `None` where the lens does not show it.
    pub(crate) fn place(&self, p: DVec3) -> Option<DVec2> {
        let shown = match self.other {
            Lens::Fisheye(fisheye) => angle(p) <= f64::from(fisheye.max_angle_rad()) - RIM_RAD,
            _ => self.other.is_central() || p.z > NEAR_M,
        };
        shown.then(|| self.anywhere(p, 0.0))
    }

    /// The same of every point: that of a fisheye goes on beyond its image circle. What lies right behind an equirectangular
    /// lens is shown at the `side`, −1 or 1, if that is given.
    fn anywhere(&self, p: DVec3, side: f64) -> DVec2 {
        let place = match self.other {
            Lens::Fisheye(fisheye) => {
                let across = p.truncate().length();
                p.truncate() * (radius(fisheye, angle(p)) / across.max(1e-12))
            }
            Lens::Equirectangular => {
                let behind = p.x.abs() < 1e-9 && p.z < 0.0 && side != 0.0;
                let longitude = if behind { PI * side } else { math::atan2(p.x, p.z) };
                DVec2::new(longitude, latitude(p))
            }
            Lens::Perspective(_) | Lens::Orthographic => p.truncate(),
        };
        self.lens.pixel(place)
    }

    /// The pixel of a point that the picture shows, no deeper than is told of.
    fn seen(&self, p: DVec3) -> Option<DVec2> {
        let depth = if self.other.is_central() { p.length() } else { p.z };
        let told = (NEAR_M..=self.far_m).contains(&depth);
        self.place(p).filter(|place| told && self.lens.shows(*place))
    }

    /// Whether the way between two points goes across the seam.
    fn crosses_seam(&self, a: DVec3, b: DVec3) -> bool {
        *self.other == Lens::Equirectangular && a.x * b.x < 0.0 && a.lerp(b, a.x / (a.x - b.x)).z < 0.0
    }

    /// The parts of a line of the world that the picture shows.
    pub(crate) fn line(&self, line: &[DVec3]) -> Vec<ImageLine> {
        let mut parts: Vec<Vec<Placed>> = vec![Vec::new()];
        for pair in line.windows(2) {
            let points = self.samples([self.lens.to_camera(pair[0]), self.lens.to_camera(pair[1])]);
            for piece in points.windows(2) {
                self.add_piece([piece[0], piece[1]], &mut parts);
            }
        }
        let lines = parts.iter().filter(|part| part.len() > 1).map(|part| {
            let kept = simplified(part);
            let inside = |p: DVec2| p.clamp(DVec2::ZERO, self.lens.size);
            ImageLine {
                world: kept.iter().map(|(p, _)| world_point(self.lens.to_world(*p))).collect(),
                image: kept.iter().map(|(_, place)| image_point(inside(*place))).collect(),
            }
        });
        lines.collect()
    }

    /// Adds what the picture shows of a short piece.
    fn add_piece(&self, [a, b]: [DVec3; 2], parts: &mut Vec<Vec<Placed>>) {
        let mut push = |from: Placed, to: Placed| {
            let open = parts.last_mut().expect("there is one");
            if open.last().is_some_and(|last| *last != from) {
                parts.push(vec![from, to]);
            } else {
                if open.is_empty() {
                    open.push(from);
                }
                open.push(to);
            }
        };
        match (self.seen(a), self.seen(b)) {
            (Some(from), Some(to)) if self.crosses_seam(a, b) => {
                let seam = a.lerp(b, a.x / (a.x - b.x));
                push((a, from), (seam, self.anywhere(seam.with_x(0.0), a.x.signum())));
                push((seam, self.anywhere(seam.with_x(0.0), b.x.signum())), (b, to));
            }
            (Some(from), Some(to)) => push((a, from), (b, to)),
            (Some(from), None) => push((a, from), self.border(a, b)),
            (None, Some(to)) => push(self.border(b, a), (b, to)),
            (None, None) => {
                if let Some(between) = self.seen_between([a, b]) {
                    self.add_piece([a, between], parts);
                    self.add_piece([between, b], parts);
                }
            }
        }
    }

    /// A point that is shown of a short piece whose ends are not: some lead through a corner of the picture, or just touch the
    /// image circle.
    fn seen_between(&self, ends: [DVec3; 2]) -> Option<DVec3> {
        let [a, b] = ends;
        if self.crosses_seam(a, b) {
            return None;
        }
        let places = ends.map(|p| self.anywhere(p, 0.0));
        let inside = WayInside::ALL.in_picture(places, self.lens.size);
        let inside = match self.other {
            Lens::Fisheye(fisheye) => {
                let middle = self.lens.pixel(DVec2::ZERO);
                inside.in_circle(
                    places,
                    middle,
                    (self.lens.pixel(DVec2::X) - middle).x * f64::from(fisheye.max_radius()),
                )
            }
            Lens::Orthographic => inside.between([a.z, b.z], [NEAR_M, self.far_m]),
            Lens::Perspective(_) | Lens::Equirectangular => inside,
        };
        let share = inside.middle()?;
        // A way's halves in the picture are seen under the same angle; its nearer end takes up more of it.
        let far = if self.other.is_central() { a.length() / b.length() } else { 1.0 };
        let between = a.lerp(b, share * far / (share * far + 1.0 - share));
        self.seen(between).map(|_| between)
    }

    /// Where the way from a point that is shown to one that is not leaves the picture.
    fn border(&self, mut inside: DVec3, mut outside: DVec3) -> Placed {
        let mut place = self.seen(inside).expect("it is shown");
        for _ in 0..40 {
            let middle = inside.midpoint(outside);
            match self.seen(middle) {
                Some(there) if !self.crosses_seam(inside, middle) => (inside, place) = (middle, there),
                _ => outside = middle,
            }
        }
        (inside, place)
    }

    /// Points along a segment, so near to each other that the lens shows almost straight lines between them.
    fn samples(&self, ends: [DVec3; 2]) -> Vec<DVec3> {
        let mut points = vec![ends[0]];
        if self.other.is_central() {
            self.add_samples(ends, MOST_HALVINGS, &mut points);
        } else {
            // Straight lines stay straight; where they leave the picture must be found.
            points.extend((1..64).map(|i| ends[0].lerp(ends[1], f64::from(i) / 64.0)));
            points.push(ends[1]);
        }
        points
    }

    /// Halves a segment, as the lens sees it, until its ends are near to each other and the picture shows it almost straight:
    /// near its poles an equirectangular lens bends much.
    fn add_samples(&self, ends: [DVec3; 2], halvings: u32, points: &mut Vec<DVec3>) {
        let [a, b] = ends;
        // The bisector of an angle divides the opposite side as the other two.
        let middle = a.lerp(b, a.length() / (a.length() + b.length()));
        let is_long = || math::atan2(a.cross(b).length(), a.dot(b)) > STEP_RAD;
        if halvings > 0 && (is_long() || self.is_bent(a, middle, b)) {
            self.add_samples([a, middle], halvings - 1, points);
            self.add_samples([middle, b], halvings - 1, points);
        } else {
            points.push(b);
        }
    }

    fn is_bent(&self, a: DVec3, middle: DVec3, b: DVec3) -> bool {
        if *self.other != Lens::Equirectangular || self.crosses_seam(a, b) {
            return false;
        }
        let [from, between, to] = [a, middle, b].map(|p| self.anywhere(p, 0.0));
        distance_to_segment(between, from, to) > MOST_DEVIATION_PX
    }

    /// The outlines of the parts of a flat area that the picture shows: two where it lies across the seam.
    pub(crate) fn outlines(&self, outline: &[DVec3]) -> Vec<Vec<DVec2>> {
        let mut corners: Vec<DVec3> = outline.iter().map(|&p| self.lens.to_camera(p)).collect();
        let lerp = |a: &DVec3, b: &DVec3, share: f64| a.lerp(*b, share);
        let towards = match self.other.is_central() {
            true => corners.iter().sum::<DVec3>().normalize_or_zero(),
            false => DVec3::Z,
        };
        corners = cut(&corners, |p| self.far_m - p.dot(towards), lerp);
        if !self.other.is_central() {
            corners = cut(&corners, |p| p.z - NEAR_M, lerp);
            return vec![self.lens.cut_to_picture(corners.iter().map(|&p| self.anywhere(p, 0.0)).collect())];
        }
        let edges = || (0..corners.len()).map(|i| [corners[i], corners[(i + 1) % corners.len()]]);
        let behind = |[a, b]: [DVec3; 2]| a.x * b.x < 0.0 && a.lerp(b, a.x / (a.x - b.x)).z < 0.0;
        if !edges().any(behind) {
            return vec![self.cut_to_shown(self.curve(&corners, 0.0))];
        }
        let half = |side: f64| self.cut_to_shown(self.curve(&cut(&corners, |p| side * p.x, lerp), side));
        vec![half(-1.0), half(1.0)]
    }

    /// The places along a polygon of the camera's frame that lies to one side of the plane behind it, or not across it.
    fn curve(&self, corners: &[DVec3], side: f64) -> Vec<DVec2> {
        let mut places = Vec::new();
        for i in 0..corners.len() {
            let points = self.samples([corners[i], corners[(i + 1) % corners.len()]]);
            for piece in points.windows(2) {
                places.push(self.anywhere(piece[0], side));
                places.extend(self.around([piece[0], piece[1]], side).into_iter().flatten());
            }
        }
        places
    }

    /// Places to go round by, where an edge in the plane behind the lens leads through a pole, or through what lies right
    /// behind a fisheye.
    fn around(&self, [a, b]: [DVec3; 2], side: f64) -> Option<[DVec2; 2]> {
        let in_plane = side != 0.0 && a.x.abs() < 1e-9 && b.x.abs() < 1e-9;
        match self.other {
            Lens::Equirectangular if in_plane && a.z * b.z < 0.0 => {
                let pole = FRAC_PI_2.copysign(a.y);
                let at = |z: f64| self.lens.pixel(DVec2::new(if z < 0.0 { PI * side } else { 0.0 }, pole));
                Some([at(a.z), at(b.z)])
            }
            Lens::Fisheye(_) if in_plane && a.z < 0.0 && b.z < 0.0 && a.y * b.y < 0.0 => {
                Some([a.y, b.y].map(|y| self.lens.pixel(DVec2::new(side, y.signum()) * 2.0 * TAU)))
            }
            _ => None,
        }
    }

    /// The part of a polygon that lies in the picture and in the image circle.
    fn cut_to_shown(&self, image: Vec<DVec2>) -> Vec<DVec2> {
        let mut image = self.lens.cut_to_picture(image);
        if let Lens::Fisheye(fisheye) = self.other {
            let middle = self.lens.pixel(DVec2::ZERO);
            let rim = (self.lens.pixel(DVec2::X) - middle).x * f64::from(fisheye.max_radius());
            for i in 0..CIRCLE_SIDES {
                let (sin, cos) = math::sin_cos(TAU * f64::from(i) / f64::from(CIRCLE_SIDES));
                let outwards = DVec2::new(cos, sin);
                image = cut(&image, |p| rim - (*p - middle).dot(outwards), |a, b, share| a.lerp(*b, share));
            }
        }
        image
    }

    /// The rectangle around the places of points, all of which the lens must show, no deeper than is told of: the whole
    /// width, where they lie on both sides of the seam.
    pub(crate) fn rectangle(&self, points: &[DVec3]) -> Option<(DVec2, DVec2)> {
        let (mut low, mut high) = (DVec2::INFINITY, DVec2::NEG_INFINITY);
        for &p in points {
            let depth = if self.other.is_central() { p.length() } else { p.z };
            let place = self.place(p).filter(|_| (NEAR_M..=self.far_m).contains(&depth))?;
            (low, high) = (low.min(place), high.max(place));
        }
        let across = points.iter().any(|&a| points.iter().any(|&b| self.crosses_seam(a, b)));
        // A little more than the picture, so that it is told to be cut.
        Some(if across { (low.with_x(-1.0), high.with_x(self.lens.size.x + 1.0)) } else { (low, high) })
    }
}

/// From the optical axis.
fn angle(p: DVec3) -> f64 {
    math::atan2(p.truncate().length(), p.z)
}

fn latitude(p: DVec3) -> f64 {
    math::atan2(p.y, DVec2::new(p.x, p.z).length())
}

/// Of an angle, in focal lengths; beyond the image circle as far again as the angle.
fn radius(fisheye: &Fisheye, angle: f64) -> f64 {
    let most = f64::from(fisheye.max_angle_rad());
    let [k1, k2, k3, k4] = fisheye.k().map(f64::from);
    let within = angle.min(most);
    let a2 = within * within;
    within * (1.0 + a2 * (k1 + a2 * (k2 + a2 * (k3 + a2 * k4)))) + (angle - within)
}

/// Without the points that lie on straight lines between others.
fn simplified(part: &[Placed]) -> Vec<Placed> {
    let mut kept = vec![part[0]];
    let mut from = 0;
    while from + 1 < part.len() {
        let straight = |to: usize| {
            let between = &part[from + 1..to];
            between.iter().all(|(_, p)| distance_to_segment(*p, part[from].1, part[to].1) < 0.5 * MOST_DEVIATION_PX)
        };
        let to = (from + 2..part.len()).take_while(|&to| straight(to)).last().unwrap_or(from + 1);
        kept.push(part[to]);
        from = to;
    }
    kept
}
