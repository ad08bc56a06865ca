//! What a road is made of from kerb to kerb, and beside it.

/// Ways that the arrows on a lane allow.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) struct TurnArrows {
    pub(super) left: bool,
    pub(super) through: bool,
    pub(super) right: bool,
    pub(super) back: bool,
}

impl TurnArrows {
    /// From a lane's part of `turn:lanes`; `None` without arrows.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let mut arrows = Self::default();
        for word in text.split(';') {
            match word.trim() {
                "left" | "sharp_left" => arrows.left = true,
                "slight_left" => (arrows.left, arrows.through) = (true, true),
                "slight_right" => (arrows.right, arrows.through) = (true, true),
                "through" | "merge_to_left" | "merge_to_right" => arrows.through = true,
                "right" | "sharp_right" => arrows.right = true,
                "reverse" => arrows.back = true,
                _ => {}
            }
        }
        (arrows != Self::default()).then_some(arrows)
    }
}

/// What a band of the carriageway is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum LaneUse {
    /// A lane; along the road or against it.
    Lane { forward: bool, arrows: Option<TurnArrows> },
    /// Cycle lane.
    Bike,
    /// Kerbside parking.
    Parking,
    /// Asphalt that nobody drives on.
    Shoulder,
}

/// A band of the carriageway.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct LaneBand {
    pub(super) what: LaneUse,
    pub(super) width_m: f64,
}

/// A cross-section. `t` is positive to the left of the way's line, metres.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct CrossSection {
    /// From left to right.
    pub(super) bands: Vec<LaneBand>,
    /// `t` of the left and right kerbs.
    pub(super) kerbs: [f64; 2],
    /// Width of the sidewalk on the left and right, kerb stone included; 0 for none.
    pub(super) sidewalks: [f64; 2],
    pub(super) unpaved: bool,
}

impl CrossSection {
    /// The same road seen from its other end.
    pub(super) fn reversed(&self) -> Self {
        let bands = self.bands.iter().rev().map(|band| match band.what {
            LaneUse::Lane { forward, arrows } => {
                LaneBand { what: LaneUse::Lane { forward: !forward, arrows }, ..*band }
            }
            _ => *band,
        });
        Self {
            bands: bands.collect(),
            kerbs: [-self.kerbs[1], -self.kerbs[0]],
            sidewalks: [self.sidewalks[1], self.sidewalks[0]],
            unpaved: self.unpaved,
        }
    }

    /// Numbers of the lanes of a direction, from left to right for who drives there.
    pub(super) fn lanes(&self, forward: bool) -> Vec<usize> {
        let own = |i: &usize| matches!(self.bands[*i].what, LaneUse::Lane { forward: f, .. } if f == forward);
        let mut lanes: Vec<usize> = (0..self.bands.len()).filter(own).collect();
        if !forward {
            lanes.reverse();
        }
        lanes
    }

    /// `t` of a band's left and right edges.
    pub(super) fn edges(&self, band: usize) -> [f64; 2] {
        let left = self.kerbs[0] - self.bands[..band].iter().map(|b| b.width_m).sum::<f64>();
        [left, left - self.bands[band].width_m]
    }

    /// `t` of a band's middle.
    pub(super) fn middle(&self, band: usize) -> f64 {
        let [left, right] = self.edges(band);
        0.5 * (left + right)
    }

    /// Kerb to kerb, metres.
    pub(super) fn width_m(&self) -> f64 {
        self.kerbs[0] - self.kerbs[1]
    }

    /// `t` of the middle of the sidewalk on the left (0) or right (1); beside the kerb where there is none.
    pub(super) fn walk_line(&self, side: usize) -> f64 {
        let out = if self.sidewalks[side] > 0.0 { 0.5 * (self.sidewalks[side] + KERB_M) } else { 0.9 };
        self.kerbs[side] + if side == 0 { out } else { -out }
    }

    /// `t` of the outer edge of the sidewalk, or of the kerb.
    pub(super) fn back(&self, side: usize) -> f64 {
        self.kerbs[side] + if side == 0 { self.sidewalks[side] } else { -self.sidewalks[side] }
    }

    /// Whether two sections can follow one another as one road.
    pub(super) fn continues(&self, other: &Self) -> bool {
        self.unpaved == other.unpaved
            && self.bands.len() == other.bands.len()
            && self.bands.iter().zip(&other.bands).all(|(a, b)| a.what == b.what && (a.width_m - b.width_m).abs() < 0.3)
            && (0..2).all(|s| {
                (self.kerbs[s] - other.kerbs[s]).abs() < 0.3 && (self.sidewalks[s] - other.sidewalks[s]).abs() < 0.3
            })
    }
}

/// Width of the kerb stone, metres.
pub(super) const KERB_M: f64 = 0.15;
