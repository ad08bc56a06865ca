//! A street's cross-section by its tags.

use super::class::{RoadClass, metres};
use super::extract::OsmTags;
use super::section::{CrossSection, LaneBand, LaneUse, TurnArrows};

/// What is known of a road from its tags.
pub(super) struct RoadTags<'a> {
    pub(super) tags: &'a OsmTags,
    pub(super) class: RoadClass,
    pub(super) link: bool,
    pub(super) oneway: bool,
    pub(super) roundabout: bool,
    /// In a town: sidewalks where tags say nothing.
    pub(super) built_up: bool,
}

fn count(tags: &OsmTags, key: &str) -> Option<usize> {
    let n = tags.get(key)?.split(';').next()?.trim().parse::<f64>().ok()?;
    (n >= 0.5).then_some((n.round() as usize).clamp(1, 10))
}

/// Lanes forward, in the middle for both, and back.
fn lane_counts(road: &RoadTags<'_>) -> (usize, usize, usize) {
    let arrows = |key: &str| road.tags.get(key).filter(|v| v.contains('|')).map(|v| v.split('|').count().min(10));
    let total = count(road.tags, "lanes");
    if road.oneway {
        let lanes =
            total.or(count(road.tags, "lanes:forward")).or(arrows("turn:lanes")).or(arrows("turn:lanes:forward"));
        let usual = if road.link || road.roundabout { 1 } else { road.class.lanes(true) };
        return (lanes.unwrap_or(usual), 0, 0);
    }
    let both = count(road.tags, "lanes:both_ways").unwrap_or(0).min(1);
    let forward = count(road.tags, "lanes:forward").or(arrows("turn:lanes:forward"));
    let backward = count(road.tags, "lanes:backward").or(arrows("turn:lanes:backward"));
    let usual = road.class.lanes(false);
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

fn parking_m(road: &RoadTags<'_>, side: usize) -> f64 {
    let tags = road.tags;
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

/// Whether any tag tells of parking beside the road.
fn has_parking_tags(tags: &OsmTags) -> bool {
    tags.iter().any(|(k, _)| k.starts_with("parking:"))
}

fn bike_m(road: &RoadTags<'_>, side: usize) -> f64 {
    let own = ["left", "right"][side];
    let explicit = road.tags.get(&format!("cycleway:{own}")).or_else(|| road.tags.get("cycleway:both"));
    // A plain `cycleway` on a one-way road lies on its right.
    let plain = road.tags.get("cycleway").filter(|_| side == 1 || !road.oneway);
    if explicit.or(plain) != Some("lane") {
        return 0.0;
    }
    let width = road.tags.get(&format!("cycleway:{own}:width")).or_else(|| road.tags.get("cycleway:both:width"));
    width.and_then(metres).unwrap_or(1.5).clamp(1.0, 2.5)
}

fn sidewalk_m(road: &RoadTags<'_>, side: usize) -> f64 {
    let own = ["left", "right"][side];
    let width = road.tags.get(&format!("sidewalk:{own}:width")).or_else(|| road.tags.get("sidewalk:both:width"));
    let usual = width.and_then(metres).unwrap_or_else(|| road.class.sidewalk_m().max(1.8)).clamp(1.2, 6.0);
    let word = road.tags.get(&format!("sidewalk:{own}")).or_else(|| road.tags.get("sidewalk:both"));
    if let Some(word) = word {
        return if matches!(word, "no" | "none") { 0.0 } else { usual };
    }
    match road.tags.get("sidewalk") {
        Some("both" | "yes" | "separate") => usual,
        Some("no" | "none") => 0.0,
        Some(word) if word == own => usual,
        Some("left" | "right") => 0.0,
        _ if road.built_up && !road.link && road.class.sidewalk_m() > 0.0 && !(road.roundabout && side == 0) => {
            road.class.sidewalk_m()
        }
        _ => 0.0,
    }
}

/// The cross-section of a road, from its tags and from what is usual.
pub(super) fn of(road: &RoadTags<'_>) -> CrossSection {
    let (forward, both, backward) = lane_counts(road);
    let lanes = (forward + both + backward) as f64;
    let mut parking = [0, 1].map(|side| parking_m(road, side));
    let bikes = [0, 1].map(|side| bike_m(road, side));
    let told = road.tags.get("width:carriageway").or_else(|| road.tags.get("width")).and_then(metres);
    let beside: f64 = parking.iter().sum::<f64>() + bikes.iter().sum::<f64>();
    let usual = road.class.lane_m() + if road.roundabout || (road.link && lanes < 1.5) { 1.0 } else { 0.0 };
    let mut lane_m = usual;
    if let Some(width) = told.filter(|w| (2.0..60.0).contains(w)) {
        if beside > 0.0 && width - beside < 2.2 * lanes {
            // The bays lie outside of what was measured.
            lane_m = width / lanes;
        } else {
            lane_m = (width - beside) / lanes;
        }
        let left_over = (lane_m - 3.9) * lanes;
        if !has_parking_tags(road.tags) && beside == 0.0 && left_over > 1.2 && road.class <= RoadClass::Secondary {
            // Wider than its lanes need: people park there.
            lane_m = usual.min(lane_m);
            let spare = width - lane_m * lanes;
            parking =
                if spare > 3.6 && !road.roundabout { [2.1f64.min(spare / 2.0); 2] } else { [0.0, 2.1f64.min(spare)] };
            if road.roundabout || spare < 1.8 {
                parking = [0.0; 2];
                lane_m = width / lanes;
            } else {
                lane_m = ((width - parking.iter().sum::<f64>()) / lanes).clamp(2.4, 4.5);
            }
        }
        lane_m = lane_m.clamp(2.3, 5.5);
    } else if lanes < 2.5 && count(road.tags, "lanes") == Some(1) && !road.oneway {
        lane_m = 2.5;
    } else if road.oneway
        && road.class == RoadClass::Residential
        && !has_parking_tags(road.tags)
        && road.built_up
        && !road.roundabout
    {
        parking[1] = 2.1;
    }
    assemble(road, lane_m, (forward, both, backward), parking, bikes)
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
    road: &RoadTags<'_>,
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
        let text = road.tags.get(key).or_else(|| road.tags.get("turn:lanes").filter(|_| road.oneway && forward));
        text.map(|t| t.split('|').map(TurnArrows::parse).collect()).unwrap_or_default()
    };
    let shoulder = match road.class {
        RoadClass::Motorway if !road.link => [0.8, 2.6],
        RoadClass::Motorway | RoadClass::Trunk => [0.5, 1.2],
        _ => [0.0, 0.0],
    };
    let shoulder = if road.oneway || shoulder[1] == 0.0 { shoulder } else { [shoulder[1]; 2] };
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
    let placed = road.tags.get("placement").filter(|_| road.tags.get("width").is_none());
    let left = match placed {
        None => width / 2.0,
        Some(word) => match lanes_left_of_line(word).filter(|_| road.oneway) {
            Some(lanes) => left + (lanes - 0.5 * forward as f64) * lane_m,
            None => left,
        },
    };
    let unpaved = road.tags.is(
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
    let sidewalks = [0, 1].map(|side| sidewalk_m(road, side));
    CrossSection { bands, kerbs: [left, left - width], sidewalks, unpaved }
}
