//! Garments, and bare skin, sewn from sections of the body: trunk, sleeves and legs as one smooth sheet.

use super::body::{ARMPIT, Body, CROTCH, LIMB, TRUNK};
use super::cage::Cage;
use super::clothes::GarmentTop;
use super::skeleton::Side;
use super::skin::{Skin, Weights};
use endless_scene::Material;
use endless_world::math::{self, lerp, smoothstep};
use glam::{Vec2, Vec3};

/// Where on the body a piece of cloth lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum BodyRegion {
    /// By height over the body's.
    Trunk,
    /// By distance from the shoulder over the arm's length.
    Arm,
    /// From ankle (0) over knee (1) to hip (2).
    Leg,
}

/// The pattern of a garment.
pub(crate) struct GarmentShape<'a> {
    /// Height of the hem over the body's; ignored with legs.
    pub(crate) hem: f32,
    pub(crate) upper: GarmentTop,
    /// Length of the sleeves over the arm's; 0: none, and the openings are filled by nothing.
    pub(crate) sleeve: f32,
    /// Where legs end, if there are any.
    pub(crate) legs: Option<f32>,
    /// Half width of the opening in front, over the stature, at the hem and at the neck.
    pub(crate) gap: Option<(f32, f32)>,
    /// Distance from the skin over the stature.
    pub(crate) ease: &'a dyn Fn(BodyRegion, f32) -> f32,
    /// Material by place and column.
    pub(crate) color: &'a dyn Fn(BodyRegion, f32, usize) -> Material,
    /// Depth of folds, 0 for skin.
    pub(crate) folds: f32,
    /// Only what can be seen between the edges of an open coat.
    pub(crate) front: bool,
    /// How far in the edge of a hem is turned, over the stature.
    pub(crate) rim: f32,
}

/// Columns of a trunk's section between which the left arm's opening lies.
const OPENING: [usize; 2] = [2, 6];

impl Body<'_> {
    /// Sews a garment.
    pub(crate) fn sew(&self, skin: &mut Skin, cut: &GarmentShape<'_>) {
        let mut cage = Cage::default();
        let trunk_ease = |t: f32| (cut.ease)(BodyRegion::Trunk, t);
        let low = if cut.legs.is_some() { CROTCH } else { cut.hem };
        let top = match cut.upper {
            GarmentTop::Waist(t) => t,
            GarmentTop::Neck { .. } => ARMPIT,
        };
        let steps = ((top - low) / 0.054).ceil().max(1.0) as usize;
        let mut heights: Vec<f32> = (0..=steps).map(|i| lerp(low, top, i as f32 / steps as f32)).collect();
        let mut rows: Vec<Vec<Vec3>> = heights.iter().map(|&t| self.trunk_ring(t, trunk_ease(t)).to_vec()).collect();
        let shoulder = rows.len() - 1;
        if let GarmentTop::Neck { dip, wide } = cut.upper {
            rows.extend(self.bust_rows(dip, wide, &trunk_ease)[1..].iter().map(|r| r.to_vec()));
            heights.extend([0.776, 0.81, 0.835]);
        }
        if let Some((at_hem, at_neck)) = cut.gap {
            let last = rows.len() - 1;
            for (i, row) in rows.iter_mut().enumerate() {
                let half = (lerp(at_hem, at_neck, i as f32 / last as f32) * self.h).min(0.7 * row[1].y);
                row.push(row[0] - Vec3::Y * half);
                row[0].y += half;
            }
        }
        // Turned edges.
        let inner = |row: &[Vec3]| -> Vec<Vec3> {
            let centre = row.iter().copied().sum::<Vec3>() / row.len() as f32;
            row.iter().map(|&p| p - (p - centre).normalize_or_zero() * cut.rim * self.h).collect()
        };
        let closed = cut.gap.is_none();
        let bust = |p: Vec3| self.bust_weights(p);
        let trunk = |p: Vec3| self.trunk_weights(p);
        let numbers: Vec<Vec<u32>> = rows
            .iter()
            .enumerate()
            .map(
                |(i, r)| {
                    if i >= shoulder && rows.len() > shoulder + 1 { cage.row(r, bust) } else { cage.row(r, trunk) }
                },
            )
            .collect();
        if cut.legs.is_none() && cut.rim > 0.0 && !cut.front {
            let edge = cage.row(&inner(&rows[0]), trunk);
            cage.strip(&edge, &numbers[0], closed, false, |j| (cut.color)(BodyRegion::Trunk, low, j));
        }
        for (i, pair) in numbers.windows(2).enumerate() {
            let t = 0.5 * (heights[i] + heights[i + 1]);
            let n = pair[0].len();
            for j in 0..if closed { n } else { n - 1 } {
                let mirrored = if j < TRUNK / 2 { j } else { TRUNK - 1 - j };
                if i >= shoulder && i < shoulder + 2 && (OPENING[0]..OPENING[1]).contains(&mirrored) {
                    continue;
                }
                if cut.front && mirrored > 2 {
                    continue;
                }
                let k = (j + 1) % n;
                cage.quad(
                    [pair[0][j], pair[0][k], pair[1][k], pair[1][j]],
                    false,
                    (cut.color)(BodyRegion::Trunk, t, j),
                );
            }
        }
        if cut.rim > 0.0 && !cut.front {
            let (last, t) = (numbers.len() - 1, heights[heights.len() - 1]);
            let edge =
                cage.row(&inner(&rows[last]), if shoulder < last { &bust } else { &trunk as &dyn Fn(Vec3) -> Weights });
            cage.strip(&numbers[last], &edge, closed, false, |j| (cut.color)(BodyRegion::Trunk, t, j));
        }
        if matches!(cut.upper, GarmentTop::Neck { .. }) && cut.sleeve > 0.0 {
            for side in Side::BOTH {
                let at = |row: usize, k: usize| numbers[shoulder + row][if side == Side::Left { k } else { TRUNK - k }];
                let hole =
                    [(2, 4), (2, 3), (2, 2), (1, 2), (0, 2), (0, 3), (0, 4), (0, 5), (0, 6), (1, 6), (2, 6), (2, 5)];
                let hole = hole.map(|(row, k)| at(row, k));
                self.sleeve(&mut cage, side, Some(&hole), [0.10, cut.sleeve], cut);
            }
        }
        if let Some(end) = cut.legs {
            self.crotch(&mut cage, &numbers[0], end, cut);
        }
        self.finish(skin, &cage, cut.folds);
    }

    /// A tube around an arm from one place to another, joined to the trunk's opening if there is one.
    fn sleeve(
        &self,
        cage: &mut Cage,
        side: Side,
        hole: Option<&[u32; LIMB]>,
        [from, to]: [f32; 2],
        cut: &GarmentShape<'_>,
    ) {
        let flipped = side == Side::Right;
        let steps = ((to - from) / 0.22).ceil().max(1.0) as usize;
        let mut before: Option<Vec<u32>> = hole.map(|h| h.to_vec());
        let mut last = from;
        for i in 0..=steps {
            let d = lerp(from, to, i as f32 / steps as f32);
            let ring = self.arm_ring(side, d, (cut.ease)(BodyRegion::Arm, d));
            let row = cage.row(&ring, |_| self.arm_weights(side, d));
            if let Some(before) = before {
                cage.strip(&before, &row, true, flipped, |j| (cut.color)(BodyRegion::Arm, 0.5 * (last + d), j));
            }
            before = Some(row);
            last = d;
        }
        if let Some(before) = before.filter(|_| cut.rim > 0.0) {
            let ring = self.arm_ring(side, to - 0.01, (cut.ease)(BodyRegion::Arm, to) - cut.rim);
            let row = cage.row(&ring, |_| self.arm_weights(side, to));
            cage.strip(&before, &row, true, flipped, |j| (cut.color)(BodyRegion::Arm, to, j));
        }
    }

    /// A tube around a leg between two places of it, joined to the ring above if there is one.
    fn leg(&self, cage: &mut Cage, side: Side, above: Option<Vec<u32>>, [from, to]: [f32; 2], cut: &GarmentShape<'_>) {
        let flipped = side == Side::Right;
        let steps = ((from - to) / 0.40).ceil().max(1.0) as usize;
        let mut above = above;
        let mut last = from;
        let weights = |p: Vec3| self.leg_weights(side, p);
        for i in 0..=steps {
            let t = lerp(from, to, i as f32 / steps as f32);
            let ease = (cut.ease)(BodyRegion::Leg, t);
            let row = cage.row(&self.leg_ring(side, t, Vec2::splat(ease)), weights);
            if let Some(above) = above {
                cage.strip(&row, &above, true, flipped, |j| (cut.color)(BodyRegion::Leg, 0.5 * (last + t), j));
            }
            above = Some(row);
            last = t;
        }
        if let Some(above) = above.filter(|_| cut.rim > 0.0) {
            let ease = (cut.ease)(BodyRegion::Leg, to) - cut.rim;
            let row = cage.row(&self.leg_ring(side, to + 0.02, Vec2::splat(ease)), weights);
            cage.strip(&row, &above, true, flipped, |j| (cut.color)(BodyRegion::Leg, to, j));
        }
    }

    /// Joins two legs to the lowest section of the trunk.
    fn crotch(&self, cage: &mut Cage, ring: &[u32], end: f32, cut: &GarmentShape<'_>) {
        let (front, back) = (cage.points[ring[0] as usize], cage.points[ring[TRUNK / 2] as usize]);
        let seam: Vec<Vec3> = [0.25, 0.5, 0.75]
            .map(|t| back.lerp(front, t) - Vec3::Z * (0.012 * self.h * if t == 0.5 { 1.0 } else { 0.7 }))
            .to_vec();
        let seam = cage.row(&seam, |p| self.trunk_weights(p));
        for side in Side::BOTH {
            let half: Vec<u32> =
                (0..=TRUNK / 2).map(|k| ring[if side == Side::Left { k } else { (TRUNK - k) % TRUNK }]).collect();
            let above: Vec<u32> = half.into_iter().chain(seam.iter().copied()).collect();
            self.leg(cage, side, Some(above), [1.66, end], cut);
        }
    }

    /// Bare arms between two places.
    pub(crate) fn bare_arms(&self, skin: &mut Skin, from: f32, skin_color: Material) {
        let color = |_: BodyRegion, _: f32, _: usize| skin_color;
        let cut = GarmentShape { color: &color, ..self.bare_cut() };
        for side in Side::BOTH {
            let mut cage = Cage::default();
            self.sleeve(&mut cage, side, None, [from.max(0.12), 1.03], &cut);
            self.finish(skin, &cage, 0.0);
        }
    }

    /// Bare legs, or legs in stockings, up to a place.
    pub(crate) fn bare_legs(&self, skin: &mut Skin, up_to: f32, color: &dyn Fn(BodyRegion, f32, usize) -> Material) {
        let cut = GarmentShape { color, ..self.bare_cut() };
        for side in Side::BOTH {
            let mut cage = Cage::default();
            self.leg(&mut cage, side, None, [up_to, -0.05], &cut);
            self.finish(skin, &cage, 0.0);
        }
    }

    /// Bare shoulders, arms and upper chest, for tops without sleeves.
    pub(crate) fn bare_shoulders(&self, skin: &mut Skin, skin_color: Material) {
        let color = |_: BodyRegion, _: f32, _: usize| skin_color;
        let upper = GarmentTop::Neck { dip: 0.0, wide: 0.0 };
        self.sew(skin, &GarmentShape { color: &color, hem: 0.69, upper, sleeve: 1.03, ..self.bare_cut() });
    }

    fn bare_cut(&self) -> GarmentShape<'static> {
        GarmentShape {
            hem: 0.0,
            upper: GarmentTop::Waist(0.0),
            sleeve: 0.0,
            legs: None,
            gap: None,
            ease: &|_, _| 0.0,
            color: &|_, _, _| unreachable!("bare parts bring their colour"),
            folds: 0.0,
            front: false,
            rim: 0.0,
        }
    }

    /// Neck and the part of the chest that necklines show.
    pub(crate) fn neck(&self, skin: &mut Skin, color: Material) {
        let mut cage = Cage::default();
        let [_, low, yoke, base] = self.bust_rows(0.0, 0.0, &|_| -0.003);
        // Narrower than the shoulders, so that no sleeve or strap is pierced.
        let narrow = |row: [Vec3; TRUNK], most: f32| {
            row.map(|p| Vec3::new(p.x, p.y.clamp(-most * self.h, most * self.h), p.z - 0.002 * self.h)).to_vec()
        };
        let rows = [
            narrow(low, 0.040),
            narrow(yoke, 0.045),
            base.to_vec(),
            self.neck_ring(0.6, 0.0).to_vec(),
            self.neck_ring(1.3, 0.0).to_vec(),
            self.neck_ring(2.0, -0.002).to_vec(),
        ];
        let numbers: Vec<Vec<u32>> =
            rows.iter().enumerate().map(|(i, r)| cage.row(r, |p| self.neck_weights(p, i >= 3))).collect();
        for pair in numbers.windows(2) {
            cage.strip(&pair[0], &pair[1], true, false, |_| color);
        }
        cage.add_to(skin, |_, _| 0.0, |_| Vec3::ZERO);
    }

    fn neck_weights(&self, p: Vec3, up: bool) -> Weights {
        use super::skeleton::Bone;
        if up {
            let (low, high) = (0.845 * self.b, 0.885 * self.b);
            return super::skin::two(Bone::Neck, Bone::Head, smoothstep(low, high, p.z));
        }
        self.trunk_weights(p)
    }

    /// Subdivides, shapes and adds a sheet.
    fn finish(&self, skin: &mut Skin, cage: &Cage, folds: f32) {
        let refined = cage.refined();
        let phase = self.appearance.folds;
        refined.add_to(
            skin,
            |p, n| self.curves(p) * n.x.abs() + folds * 0.0022 * wave(p, phase),
            |p| wave_slope(p, phase) * (0.11 * folds),
        );
    }
}

/// Directions of folds (1/m) and their depth.
const WAVES: [(Vec3, f32); 4] = [
    (Vec3::new(31.0, 22.0, 47.0), 1.0),
    (Vec3::new(-26.0, 37.0, 39.0), 0.8),
    (Vec3::new(58.0, -33.0, 21.0), 0.6),
    (Vec3::new(17.0, 64.0, -29.0), 0.6),
];

fn wave(p: Vec3, phase: f32) -> f32 {
    WAVES.iter().enumerate().map(|(i, (k, a))| a * math::sin(k.dot(p) + phase * (1.0 + i as f32))).sum()
}

fn wave_slope(p: Vec3, phase: f32) -> Vec3 {
    let slope = |(i, (k, a)): (usize, &(Vec3, f32))| {
        // Finer folds than the mesh can hold.
        let fine = *k * 1.7;
        -*k / 60.0 * *a * math::cos(fine.dot(p) + phase * (2.0 + i as f32))
    };
    WAVES.iter().enumerate().map(slope).sum()
}
