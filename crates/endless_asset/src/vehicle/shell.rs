//! The smooth skin of a car body: rings around the body from the sill up to the belt line, over bonnet and boot to the
//! foot of the cabin, up its pillars and over the roof.

use crate::shape::{MonotoneCubic, Sculpt};
use endless_scene::Material;
use endless_world::math;
use glam::{Vec2, Vec3};

/// A horizontal outline of the body, left half: a rounded rectangle with bowed ends.
#[derive(Debug, Clone, Copy)]
pub(crate) struct BodyOutline {
    /// x of the front at the centre line.
    pub(crate) front: f32,
    /// x of the rear at the centre line.
    pub(crate) rear: f32,
    /// Widest half width.
    pub(crate) half_width: f32,
    /// How far the front's and the rear's corners lie behind their middle.
    pub(crate) bow: [f32; 2],
    /// Radius of the front and rear corners in plan.
    pub(crate) corner: [f32; 2],
    /// How much narrower the body is at its front and rear corners.
    pub(crate) taper: [f32; 2],
}

/// Points along the half outline: end, corner, wing (ahead of the cabin), flank, and the same at the rear.
const END: usize = 6;
const CORNER: usize = 4;
const WING: usize = 7;
const FLANK: usize = 14;

impl BodyOutline {
    /// The same, smaller: at the sides, at the front, at the rear.
    pub(crate) fn inset(&self, side: f32, front: f32, rear: f32) -> Self {
        Self { half_width: self.half_width - side, front: self.front - front, rear: self.rear + rear, ..*self }
    }

    /// Between this (0) and another (1).
    fn mix(&self, other: &Self, t: f32) -> Self {
        let pair = |a: [f32; 2], b: [f32; 2]| [math::lerp(a[0], b[0], t), math::lerp(a[1], b[1], t)];
        Self {
            front: math::lerp(self.front, other.front, t),
            rear: math::lerp(self.rear, other.rear, t),
            half_width: math::lerp(self.half_width, other.half_width, t),
            bow: pair(self.bow, other.bow),
            corner: pair(self.corner, other.corner),
            taper: pair(self.taper, other.taper),
        }
    }

    /// x where the straight flank begins and ends.
    pub(crate) fn flank(&self) -> (f32, f32) {
        (self.front - self.bow[0] - self.corner[0], self.rear + self.bow[1] + self.corner[1])
    }

    /// Half width of the flank at x.
    fn width_at(&self, x: f32) -> f32 {
        let (front, rear) = self.flank();
        let middle = 0.5 * (front + rear);
        let (end, taper) = if x > middle { (front, self.taper[0]) } else { (rear, self.taper[1]) };
        let t = ((x - middle) / (end - middle)).clamp(0.0, 1.0);
        self.half_width - taper * t * t * t
    }

    /// One end from the centre line to the flank: `n` points along the edge, then the corner.
    fn end(&self, at: usize, n: usize) -> Vec<Vec2> {
        let (sign, tip) = if at == 0 { (1.0, self.front) } else { (-1.0, self.rear) };
        let (front, rear) = self.flank();
        let flank_x = if at == 0 { front } else { rear };
        let w = self.width_at(flank_x);
        let r = self.corner[at].min(w * 0.9);
        let mut out: Vec<Vec2> = (0..n)
            .map(|i| {
                let t = i as f32 / n as f32;
                Vec2::new(tip - sign * self.bow[at] * t * t, t * (w - r))
            })
            .collect();
        for i in 0..CORNER {
            let (sin, cos) = math::sin_cos(std::f32::consts::FRAC_PI_2 * i as f32 / CORNER as f32);
            out.push(Vec2::new(flank_x + sign * self.corner[at] * cos, w - r + r * sin));
        }
        out
    }

    fn side(&self, from: f32, to: f32, n: usize) -> impl Iterator<Item = Vec2> + '_ {
        (0..n).map(move |i| {
            let x = math::lerp(from, to, i as f32 / n as f32);
            Vec2::new(x, self.width_at(x))
        })
    }

    /// The left half from the front's middle to the rear's. `cabin` says where the flank beside the cabin lies; a ring
    /// of the cabin itself has none.
    fn outline(&self, cabin: Option<(f32, f32)>) -> Vec<Vec2> {
        let (front, rear) = self.flank();
        let mut back;
        let mut out;
        if let Some((from, to)) = cabin {
            let (from, to) = (from.min(front - 1e-3), to.max(rear + 1e-3));
            out = self.end(0, END);
            out.extend(self.side(front, from, WING));
            out.extend(self.side(from, to, FLANK));
            back = self.end(1, END);
            back.extend(self.side(rear, to, WING));
            back.push(Vec2::new(to, self.width_at(to)));
        } else {
            out = self.end(0, END + WING);
            out.extend(self.side(front, rear, FLANK));
            back = self.end(1, END + WING);
            back.push(Vec2::new(rear, self.width_at(rear)));
        }
        back.reverse();
        out.extend(back);
        out
    }
}

/// One row of the section from the sill (t = 0) to the belt line (t = 1), and how far it lies inside the largest
/// outline at the sides, the nose and the tail.
pub(crate) type SectionRow = (f32, f32, f32, f32);

/// The greenhouse: windows, pillars and roof above the belt line.
#[derive(Debug, Clone)]
pub(crate) struct Greenhouse {
    /// Outline at its foot.
    pub(crate) foot: BodyOutline,
    /// Outline at the roof's edge.
    pub(crate) top: BodyOutline,
    /// Height of the roof's centre line along x.
    pub(crate) roof: MonotoneCubic,
    /// How far the roof's edge lies below its centre line.
    pub(crate) edge_drop: f32,
    /// How far the glass bulges outward at half height.
    pub(crate) bulge: f32,
}

/// A whole body skin.
#[derive(Debug, Clone)]
pub(crate) struct Shell {
    /// Largest outline.
    pub(crate) outline: BodyOutline,
    /// Section from sill to belt.
    pub(crate) section: Vec<SectionRow>,
    /// Height of the lower edge along x.
    pub(crate) sill: MonotoneCubic,
    /// Height of the belt line along x.
    pub(crate) belt: MonotoneCubic,
    /// Height of bonnet and boot on the centre line along x.
    pub(crate) deck: MonotoneCubic,
    /// Windows, pillars and roof.
    pub(crate) cabin: Greenhouse,
    /// Wheel arches: x and z of the centre, radius, swelling of the lip.
    pub(crate) arches: Vec<Arch>,
}

/// A wheel arch.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Arch {
    /// x of the axle.
    pub(crate) x: f32,
    /// Height of the axle.
    pub(crate) z: f32,
    /// Radius of the opening.
    pub(crate) radius: f32,
    /// How far the lip swells out of the body side.
    pub(crate) flare: f32,
}

impl Arch {
    fn swell(&self, p: Vec3) -> f32 {
        let r = Vec2::new(p.x - self.x, p.z - self.z).length() - self.radius;
        let t = if r < 0.0 { 1.0 } else { 1.0 - math::smoothstep(0.02, 0.20, r) };
        self.flare * t
    }
}

impl Shell {
    /// Height of the upper side of bonnet and boot.
    fn deck_z(&self, p: Vec2) -> f32 {
        let w = (p.y / self.outline.half_width).abs().min(1.0);
        math::lerp(self.deck.at(p.x), self.belt.at(p.x), w * w * w)
    }

    /// Height of the belt beside the cabin at x.
    pub(crate) fn belt_z(&self, x: f32) -> f32 {
        self.belt.at(x)
    }

    /// Height of the roof's edge at x.
    pub(crate) fn roof_edge_z(&self, x: f32) -> f32 {
        self.cabin.roof.at(x) - self.cabin.edge_drop
    }

    /// The skin, both halves, all of one material, with open wheel arches still closed.
    pub(crate) fn sculpt(&self, material: Material) -> Sculpt {
        let mut rows = self.side_rows();
        rows.extend(self.deck_rows());
        rows.extend(self.cabin_rows());
        let mut half = Sculpt::new();
        // Front to rear along the left side is left to right for who looks at it.
        half.grid(&rows, false, material);
        half.both_sides().smooth(32.0)
    }

    fn cabin_span(&self) -> Option<(f32, f32)> {
        Some(self.cabin.foot.flank())
    }

    fn belt_ring(&self) -> BodyOutline {
        let &(_, side, nose, tail) = self.section.last().expect("a section has rows");
        self.outline.inset(side, nose, tail)
    }

    fn side_rows(&self) -> Vec<Vec<Vec3>> {
        let belt: Vec<f32> = self.belt_ring().outline(self.cabin_span()).iter().map(|&p| self.deck_z(p)).collect();
        let mut rows = Vec::new();
        let floor: Vec<Vec3> = {
            let &(_, side, nose, tail) = &self.section[0];
            let ring = self.outline.inset(side, nose, tail).outline(self.cabin_span());
            ring.iter().map(|p| Vec3::new(p.x, 0.0, self.sill.at(p.x))).collect()
        };
        rows.push(floor);
        for &(t, side, nose, tail) in &self.section {
            let ring = self.outline.inset(side, nose, tail).outline(self.cabin_span());
            rows.push(
                ring.iter()
                    .zip(&belt)
                    .map(|(p, &top)| {
                        let mut q = Vec3::new(p.x, p.y, math::lerp(self.sill.at(p.x), top, t));
                        let across = math::smoothstep(0.6, 0.9, p.y / self.outline.half_width);
                        q.y += across * self.arches.iter().map(|a| a.swell(q)).fold(0.0, f32::max);
                        q
                    })
                    .collect(),
            );
        }
        rows
    }

    fn deck_rows(&self) -> Vec<Vec<Vec3>> {
        let from = self.belt_ring().outline(self.cabin_span());
        let to = self.cabin.foot.outline(None);
        [0.06f32, 0.25, 0.5, 0.78, 1.0]
            .iter()
            .map(|&t| {
                from.iter()
                    .zip(&to)
                    .map(|(a, b)| {
                        let p = a.lerp(*b, t);
                        p.extend(self.deck_z(p))
                    })
                    .collect()
            })
            .collect()
    }

    fn cabin_rows(&self) -> Vec<Vec<Vec3>> {
        let Greenhouse { foot, top, roof, edge_drop, bulge } = &self.cabin;
        let low: Vec<Vec3> = foot.outline(None).iter().map(|&p| p.extend(self.deck_z(p))).collect();
        let high: Vec<Vec3> = top.outline(None).iter().map(|&p| p.extend(roof.at(p.x) - edge_drop)).collect();
        let mut rows: Vec<Vec<Vec3>> = Vec::new();
        for t in [0.2f32, 0.45, 0.7, 0.92] {
            let blueprint = foot.mix(top, t).outline(None);
            rows.push(
                low.iter()
                    .zip(&high)
                    .zip(&blueprint)
                    .map(|((a, b), p)| {
                        let out = bulge * 4.0 * t * (1.0 - t);
                        let straight = a.lerp(*b, t);
                        Vec3::new(p.x, p.y + out * (p.y / foot.half_width), straight.z)
                    })
                    .collect(),
            );
        }
        for s in [0.0f32, 0.04, 0.1, 0.2, 0.45, 1.0] {
            rows.push(
                high.iter()
                    .map(|p| {
                        let reach = (top.front - top.rear) * 0.5 - top.half_width * 0.7;
                        let middle = 0.5 * (top.front + top.rear);
                        let spine = middle + (p.x - middle).clamp(-reach.max(0.1), reach.max(0.1));
                        let x = math::lerp(p.x, spine, s);
                        let k = 1.0 - s;
                        let z = roof.at(x) - edge_drop * k * k * k * k * k;
                        Vec3::new(x, p.y * k, if s == 0.0 { p.z } else { z })
                    })
                    .collect(),
            );
        }
        rows
    }
}
