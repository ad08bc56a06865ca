//! What a road is made of from kerb to kerb, and beside it.

use super::class::{RoadClass, metres};
use super::extract::OsmTags;

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
    fn parse(text: &str) -> Option<Self> {
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

/// What is known of a road from its tags.
pub(super) struct RoadTags<'a> {
    pub(super) tags: &'a OsmTags,
    pub(super) class: RoadClass,
    pub(super) link: bool,
    pub(super) oneway: bool,
    pub(super) roundabout: bool,
    /// In a town: sidewalks where nothing is said.
    pub(super) built_up: bool,
}

fn count(tags: &OsmTags, key: &str) -> Option<usize> {
    let n = tags.get(key)?.split(';').next()?.trim().parse::<f64>().ok()?;
    (n >= 0.5).then_some((n.round() as usize).clamp(1, 10))
}

/// Lanes forward, in the middle for both, and back.
fn lane_counts(said: &RoadTags<'_>) -> (usize, usize, usize) {
    let arrows = |key: &str| said.tags.get(key).filter(|v| v.contains('|')).map(|v| v.split('|').count().min(10));
    let total = count(said.tags, "lanes");
    if said.oneway {
        let lanes =
            total.or(count(said.tags, "lanes:forward")).or(arrows("turn:lanes")).or(arrows("turn:lanes:forward"));
        let usual = if said.link || said.roundabout { 1 } else { said.class.lanes(true) };
        return (lanes.unwrap_or(usual), 0, 0);
    }
    let both = count(said.tags, "lanes:both_ways").unwrap_or(0).min(1);
    let forward = count(said.tags, "lanes:forward").or(arrows("turn:lanes:forward"));
    let backward = count(said.tags, "lanes:backward").or(arrows("turn:lanes:backward"));
    let usual = said.class.lanes(false);
    let rest = |known: usize| total.map_or(usual, |t| t.saturating_sub(known + both).max(1));
    match (forward, backward) {
        (Some(f), Some(b)) => (f, both, b),
        (Some(f), None) => (f, both, rest(f)),
        (None, Some(b)) => (rest(b), both, b),
        (None, None) => {
            let t = total.map_or(2 * usual, |t| t.saturating_sub(both)).max(2);
            (t.div_ceil(2), both, t / 2)
        }
    }
}

/// Tags such as `cycleway:left`, `cycleway:both`, `cycleway`, by side.
fn by_side<'a>(tags: &'a OsmTags, key: &str, side: usize) -> Option<&'a str> {
    let own = ["left", "right"][side];
    tags.get(&format!("{key}:{own}")).or_else(|| tags.get(&format!("{key}:both"))).or_else(|| tags.get(key))
}

fn parking_m(said: &RoadTags<'_>, side: usize) -> f64 {
    let tags = said.tags;
    let place = by_side(tags, "parking", side);
    let old = by_side(tags, "parking:lane", side);
    let orientation = tags
        .get(&format!("parking:{}:orientation", ["left", "right"][side]))
        .or_else(|| tags.get("parking:both:orientation"))
        .or(old)
        .unwrap_or("parallel");
    let there = place.is_some_and(|v| matches!(v, "lane" | "street_side" | "yes" | "half_on_kerb"))
        || old.is_some_and(|v| matches!(v, "parallel" | "diagonal" | "perpendicular" | "marked"));
    if !there {
        return 0.0;
    }
    match orientation {
        "perpendicular" => 5.0,
        "diagonal" => 4.4,
        _ => 2.1,
    }
}

/// Whether anything is said about parking beside the road.
fn parking_said(tags: &OsmTags) -> bool {
    tags.iter().any(|(k, _)| k.starts_with("parking:"))
}

fn bike_m(said: &RoadTags<'_>, side: usize) -> f64 {
    let own = ["left", "right"][side];
    let explicit = said.tags.get(&format!("cycleway:{own}")).or_else(|| said.tags.get("cycleway:both"));
    // A plain `cycleway` on a one-way road lies on its right.
    let plain = said.tags.get("cycleway").filter(|_| side == 1 || !said.oneway);
    if explicit.or(plain) != Some("lane") {
        return 0.0;
    }
    let width = said.tags.get(&format!("cycleway:{own}:width")).or_else(|| said.tags.get("cycleway:both:width"));
    width.and_then(metres).unwrap_or(1.5).clamp(1.0, 2.5)
}

fn sidewalk_m(said: &RoadTags<'_>, side: usize) -> f64 {
    let own = ["left", "right"][side];
    let width = said.tags.get(&format!("sidewalk:{own}:width")).or_else(|| said.tags.get("sidewalk:both:width"));
    let usual = width.and_then(metres).unwrap_or_else(|| said.class.sidewalk_m().max(1.8)).clamp(1.2, 6.0);
    let word = said.tags.get(&format!("sidewalk:{own}")).or_else(|| said.tags.get("sidewalk:both"));
    if let Some(word) = word {
        return if matches!(word, "no" | "none") { 0.0 } else { usual };
    }
    match said.tags.get("sidewalk") {
        Some("both" | "yes" | "separate") => usual,
        Some("no" | "none") => 0.0,
        Some(word) if word == own => usual,
        Some("left" | "right") => 0.0,
        _ if said.built_up && !said.link && said.class.sidewalk_m() > 0.0 && !(said.roundabout && side == 0) => {
            said.class.sidewalk_m()
        }
        _ => 0.0,
    }
}

/// The cross-section of a road, from its tags and from what is usual.
pub(super) fn of(said: &RoadTags<'_>) -> CrossSection {
    let (forward, both, backward) = lane_counts(said);
    let lanes = (forward + both + backward) as f64;
    let mut parking = [0, 1].map(|side| parking_m(said, side));
    let bikes = [0, 1].map(|side| bike_m(said, side));
    let told = said.tags.get("width:carriageway").or_else(|| said.tags.get("width")).and_then(metres);
    let beside: f64 = parking.iter().sum::<f64>() + bikes.iter().sum::<f64>();
    let usual = said.class.lane_m() + if said.roundabout || (said.link && lanes < 1.5) { 1.0 } else { 0.0 };
    let mut lane_m = usual;
    if let Some(width) = told.filter(|w| (2.0..60.0).contains(w)) {
        if beside > 0.0 && width - beside < 2.2 * lanes {
            // The bays lie outside of what was measured.
            lane_m = width / lanes;
        } else {
            lane_m = (width - beside) / lanes;
        }
        let left_over = (lane_m - 3.9) * lanes;
        if !parking_said(said.tags) && beside == 0.0 && left_over > 1.2 && said.class <= RoadClass::Secondary {
            // Wider than its lanes need: people park there.
            lane_m = usual.min(lane_m);
            let spare = width - lane_m * lanes;
            parking =
                if spare > 3.6 && !said.roundabout { [2.1f64.min(spare / 2.0); 2] } else { [0.0, 2.1f64.min(spare)] };
            if said.roundabout || spare < 1.8 {
                parking = [0.0; 2];
                lane_m = width / lanes;
            } else {
                lane_m = ((width - parking.iter().sum::<f64>()) / lanes).clamp(2.4, 4.5);
            }
        }
        lane_m = lane_m.clamp(2.3, 5.5);
    } else if lanes < 2.5 && count(said.tags, "lanes") == Some(1) && !said.oneway {
        lane_m = 2.5;
    } else if said.oneway
        && said.class == RoadClass::Residential
        && !parking_said(said.tags)
        && said.built_up
        && !said.roundabout
    {
        parking[1] = 2.1;
    }
    assemble(said, lane_m, (forward, both, backward), parking, bikes)
}

/// How many lanes of a one-way road lie to the left of its line: `placement=right_of:2`.
fn lanes_left_of_line(placement: &str) -> Option<f64> {
    let (side, lane) = placement.split_once(':')?;
    let lane = lane.trim().parse::<u32>().ok().filter(|lane| (1..=10).contains(lane))?;
    let aside = match side.trim() {
        "left_of" => 1.0,
        "middle_of" => 0.5,
        "right_of" => 0.0,
        _ => return None,
    };
    Some(f64::from(lane) - aside)
}

fn assemble(
    said: &RoadTags<'_>,
    lane_m: f64,
    (forward, both, backward): (usize, usize, usize),
    parking: [f64; 2],
    bikes: [f64; 2],
) -> CrossSection {
    let mut bands = Vec::new();
    let mut push = |what: LaneUse, width_m: f64| {
        if width_m > 0.0 {
            bands.push(LaneBand { what, width_m });
        }
    };
    let arrows = |forward: bool| -> Vec<Option<TurnArrows>> {
        let key = if forward { "turn:lanes:forward" } else { "turn:lanes:backward" };
        let text = said.tags.get(key).or_else(|| said.tags.get("turn:lanes").filter(|_| said.oneway && forward));
        text.map(|t| t.split('|').map(TurnArrows::parse).collect()).unwrap_or_default()
    };
    let shoulder = match said.class {
        RoadClass::Motorway if !said.link => [0.8, 2.6],
        RoadClass::Motorway | RoadClass::Trunk => [0.5, 1.2],
        _ => [0.0, 0.0],
    };
    let shoulder = if said.oneway || shoulder[1] == 0.0 { shoulder } else { [shoulder[1]; 2] };
    push(LaneUse::Parking, parking[0]);
    push(LaneUse::Bike, bikes[0]);
    push(LaneUse::Shoulder, shoulder[0]);
    let (ahead, back) = (arrows(true), arrows(false));
    for k in (0..backward).rev() {
        let arrows = if back.len() == backward { back[k] } else { None };
        push(LaneUse::Lane { forward: false, arrows }, lane_m);
    }
    push(LaneUse::Shoulder, both as f64 * lane_m);
    for k in 0..forward {
        let arrows = if ahead.len() == forward { ahead[k] } else { None };
        push(LaneUse::Lane { forward: true, arrows }, lane_m);
    }
    push(LaneUse::Shoulder, shoulder[1]);
    push(LaneUse::Bike, bikes[1]);
    push(LaneUse::Parking, parking[1]);
    // The way's line runs in the middle of the lanes' asphalt.
    let half = 0.5 * lane_m * (forward + both + backward) as f64;
    let left = half + parking[0] + bikes[0] + shoulder[0];
    let width: f64 = bands.iter().map(|b| b.width_m).sum();
    let placed = said.tags.get("placement").filter(|_| said.tags.get("width").is_none());
    let left = match placed {
        None => width / 2.0,
        Some(word) => match lanes_left_of_line(word).filter(|_| said.oneway) {
            Some(lanes) => left + (lanes - 0.5 * forward as f64) * lane_m,
            None => left,
        },
    };
    let unpaved = said.tags.is(
        "surface",
        &[
            "unpaved",
            "gravel",
            "fine_gravel",
            "ground",
            "dirt",
            "earth",
            "grass",
            "sand",
            "mud",
            "compacted",
            "pebblestone",
        ],
    );
    let sidewalks = [0, 1].map(|side| sidewalk_m(said, side));
    CrossSection { bands, kerbs: [left, left - width], sidewalks, unpaved }
}
