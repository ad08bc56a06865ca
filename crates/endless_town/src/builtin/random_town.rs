//! Towns that nobody has drawn: a plan of streets, squares and highways by a seed.
//!
//! ```text
//! grid     lines both ways, bent and turned; some blocks are joined; avenues of many lanes      ┌─┬──┬─┐
//! radial   a ring, streets from its market outwards, and streets between them                   │ ├──┤ │
//! highway  two carriageways past either, under bridges of its streets                           ╘═╧══╧═╛
//! ```

use super::layout::TownLayout;
use super::layout_geometry::{beside, hill, points, rect, smooth, smooth_ring};
use super::random_region::{RandomRegion, ZoneProfile};
use crate::dressing::{DrawnPreset, TownPreset};
use crate::geometry::unit;
use endless_road::RoadMap;
use endless_world::Stream;
use endless_world::math::f64::sin;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// Share of radial plans, and of plans with a highway beside them.
const RADIAL: f64 = 0.35;
const WITH_HIGHWAY: f64 = 0.5;
/// A highway passes so far beyond the last street, metres. It leaves the map so far beyond the town, where it is this many
/// times as long.
const HIGHWAY_BEYOND_M: [f64; 2] = [55.0, 110.0];
const BORDER_M: f64 = 90.0;
const LONGER: f64 = 1.6;
/// A lane of a highway, and half of its median, metres.
const HIGHWAY_LANE_M: f64 = 3.6;
const HALF_MEDIAN_M: [f64; 2] = [1.2, 6.0];
/// From a highway's middle to where a bridge over it begins, metres.
const BRIDGE_M: f64 = 34.0;
/// Streets over a highway end so far behind its middle, metres.
const OVER_M: f64 = 80.0;
/// Length of a street at the market of a radial plan, and of one from the market half-way to the ring, metres.
const MARKET_M: [f64; 2] = [58.0, 80.0];
const BLOCK_M: [f64; 2] = [75.0, 105.0];
/// From the middle of a street to a square beside it, whose edge its sidewalk must touch, metres.
const SQUARE_INSET_M: f64 = 9.2;
/// Streets that leave the town reach so far beyond it, metres.
const LEAVING_M: f64 = 70.0;

/// The layout of a number.
pub(super) fn make(number: u32) -> (RoadMap, TownPreset) {
    let mut random = Stream::named(u64::from(number), "town/random", &[]);
    let region = RandomRegion::draw(&mut random);
    let mut plan = RandomPlan::new(region, &mut random);
    if random.chance(RADIAL) {
        plan.radial(&mut random);
    } else {
        plan.grid(&mut random);
    }
    let highway = random.chance(WITH_HIGHWAY);
    if highway {
        plan.highway(&mut random);
    }
    plan.zones(&mut random);
    let preset = DrawnPreset::new(&region.preset(), random.next_u64()).preset;
    let summary =
        format!("Random town {number}: {} streets{}.", region.name, if highway { " beside a highway" } else { "" });
    let preset = TownPreset { summary, ..preset };
    // Bridges need level ground.
    let hilly = !highway && random.chance(0.4);
    let top = (random.range_f64(-200.0, 200.0), random.range_f64(-200.0, 200.0));
    let (slope, towards) = (random.range_f64(0.0, 0.03), unit(random.range_f64(0.0, TAU)));
    let height = move |p: DVec2| slope * towards.dot(p) + hill(p, top, 260.0, 7.0);
    plan.layout.build(hilly.then_some(&height as &dyn Fn(DVec2) -> f64), preset)
}

/// A layout with what later steps need to know of it.
struct RandomPlan {
    layout: TownLayout,
    region: RandomRegion,
    /// All lie within this distance of the middle, north and south, metres.
    half_m: DVec2,
    /// How the plan is turned and bent.
    turn: DVec2,
    bend_m: f64,
    phase: f64,
    /// Streets that may go on under or over a highway in the north: their places from west to east.
    northwards: Vec<f64>,
}

impl RandomPlan {
    fn new(region: RandomRegion, random: &mut Stream) -> Self {
        Self {
            layout: TownLayout::of(region.place),
            region,
            half_m: DVec2::ZERO,
            turn: unit(random.range_f64(-0.35, 0.35)),
            bend_m: if random.chance(0.5) { random.range_f64(4.0, 16.0) } else { 0.0 },
            phase: random.range_f64(0.0, TAU),
            northwards: Vec::new(),
        }
    }

    /// Where a place of the straight plan is.
    fn bent(&self, p: DVec2) -> DVec2 {
        let wave = |along: f64| self.bend_m * sin(along * PI / 170.0 + self.phase);
        self.turn.rotate(p + DVec2::new(wave(p.y), wave(p.x + 90.0)))
    }

    /// A straight line of the plan, as it runs.
    fn line(&self, from: DVec2, to: DVec2) -> Vec<DVec2> {
        let steps = if self.bend_m > 0.0 { (from.distance(to) / 24.0).ceil().max(1.0) as usize } else { 1 };
        (0..=steps).map(|k| self.bent(from.lerp(to, k as f64 / steps as f64))).collect()
    }

    fn grid(&mut self, random: &mut Stream) {
        let columns = grid_lines(4 + random.below(3), random);
        let rows = grid_lines(4 + random.below(2), random);
        self.half_m = DVec2::new(columns[columns.len() - 1], rows[rows.len() - 1]);
        let avenue = [1 + random.below(columns.len() - 2), 1 + random.below(rows.len() - 2)];
        let second = random.chance(0.5);
        for (k, &x) in columns.iter().enumerate() {
            let wide = k == avenue[0];
            self.grid_line(wide, &rows, &|y| DVec2::new(x, y), random);
        }
        for (k, &y) in rows.iter().enumerate() {
            let wide = second && k == avenue[1];
            self.grid_line(wide, &columns, &|x| DVec2::new(x, y), random);
        }
        for (i, &x) in columns.iter().enumerate() {
            for (j, &y) in rows.iter().enumerate() {
                let inner = (i > 0 && i + 1 < columns.len()) || (j > 0 && j + 1 < rows.len());
                let wide = i == avenue[0] || second && j == avenue[1];
                self.crossing(self.bent(DVec2::new(x, y)), if wide { 0.85 } else { 0.3 }, inner, random);
            }
        }
        self.blocks(&columns, &rows, random);
        // The avenue goes on by itself.
        self.northwards = columns;
        self.northwards.remove(avenue[0]);
    }

    /// A street from end to end of a grid, without some of its blocks; avenues go on beyond both ends.
    fn grid_line(&mut self, wide: bool, across: &[f64], at: &dyn Fn(f64) -> DVec2, random: &mut Stream) {
        let (first, last) = (across[0], across[across.len() - 1]);
        if wide {
            let line = self.line(at(first - LEAVING_M), at(last + LEAVING_M));
            let words = random.pick(self.region.avenues);
            self.layout.road(words, &line);
            return;
        }
        let words = random.pick(self.region.streets);
        let turned = random.chance(0.5);
        let mut from = first;
        for (k, pair) in across.windows(2).enumerate() {
            let inner = k > 0 && k + 2 < across.len();
            let gap = inner && random.chance(0.14);
            if gap && pair[0] > from {
                self.street(words, turned, at(from), at(pair[0]));
            }
            if gap {
                from = pair[1];
            }
        }
        self.street(words, turned, at(from), at(last));
    }

    fn street(&mut self, words: &str, turned: bool, from: DVec2, to: DVec2) {
        let mut line = self.line(from, to);
        if turned {
            line.reverse();
        }
        self.layout.road(words, &line);
    }

    fn crossing(&mut self, at: DVec2, lights: f64, inner: bool, random: &mut Stream) {
        if inner && random.chance(lights) {
            self.layout.lights(at);
        } else if random.chance(0.35) {
            self.layout.zebra(at);
        }
    }

    /// Parks, squares and car parks in some blocks of a grid.
    fn blocks(&mut self, columns: &[f64], rows: &[f64], random: &mut Stream) {
        for x in columns.windows(2) {
            for y in rows.windows(2) {
                let kind = random.below(14);
                let inset = if kind == 1 { SQUARE_INSET_M } else { 14.0 };
                let corners = [
                    (x[0], y[0], 1.0, 1.0),
                    (x[1], y[0], -1.0, 1.0),
                    (x[1], y[1], -1.0, -1.0),
                    (x[0], y[1], 1.0, -1.0),
                ];
                let outline = corners.map(|(x, y, dx, dy)| self.bent(DVec2::new(x + dx * inset, y + dy * inset)));
                match kind {
                    0 => self.layout.park(&outline),
                    1 => self.layout.square(&outline),
                    2 => self.layout.land("amenity=parking", &outline),
                    _ => {}
                }
            }
        }
    }

    fn radial(&mut self, random: &mut Stream) {
        let arms = 4 + random.below(4);
        let near = (arms as f64 * random.range_f64(MARKET_M[0], MARKET_M[1])) / TAU;
        let radius = near + 2.0 * random.range_f64(BLOCK_M[0], BLOCK_M[1]);
        let begin = random.range_f64(0.0, TAU);
        let angles: Vec<f64> =
            (0..arms).map(|k| begin + (k as f64 + random.range_f64(-0.18, 0.18)) * TAU / arms as f64).collect();
        self.half_m = DVec2::splat(radius + LEAVING_M);
        let round = |radius: f64, random: &mut Stream| -> Vec<(f64, f64)> {
            angles.iter().map(|&a| unit(a) * radius * random.range_f64(0.95, 1.05)).map(|p| (p.x, p.y)).collect()
        };
        let (ring, market) = (round(radius, random), round(near, random));
        let avenue = *random.pick(self.region.avenues);
        let around = if random.chance(0.5) { avenue } else { *random.pick(self.region.streets) };
        self.layout.road(around, &smooth_ring(&ring));
        let mut around = points(&market);
        around.push(around[0]);
        self.layout.road("residential lanes=2 sidewalk=both maxspeed=30", &around);
        let spokes: Vec<Vec<DVec2>> = (0..arms)
            .map(|k| {
                let beyond = unit(angles[k]) * (radius + LEAVING_M);
                let aside = unit(angles[k]).perp() * random.range_f64(-14.0, 14.0);
                let middle = DVec2::from(market[k]).lerp(DVec2::from(ring[k]), 0.5) + aside;
                smooth(&[market[k], (middle.x, middle.y), ring[k], (beyond.x, beyond.y)])
            })
            .collect();
        for (k, spoke) in spokes.iter().enumerate() {
            let words = random.pick(if k % 2 == 0 { self.region.streets } else { self.region.avenues });
            let words = words.replace("oneway=yes", "");
            self.layout.road(&words, spoke);
            self.crossing(DVec2::from(ring[k]), 0.6, true, random);
        }
        // Streets between spokes meet where these are half-way out.
        let half_way = |line: &[DVec2]| line[(line.len() - 1) / 3];
        for k in 0..arms {
            let words = random.pick(self.region.streets);
            self.layout.road(words, &[half_way(&spokes[k]), half_way(&spokes[(k + 1) % arms])]);
        }
        let inset = 1.0 - SQUARE_INSET_M / (near * sin(PI / 2.0 - PI / arms as f64));
        let inset: Vec<DVec2> = market.iter().map(|&p| DVec2::from(p) * inset).collect();
        if random.chance(0.7) {
            self.layout.square(&inset);
        } else {
            self.layout.land("leisure=park", &inset);
        }
    }

    /// Two carriageways north of the town, with bridges of some of its streets over them.
    fn highway(&mut self, random: &mut Stream) {
        let lanes = 2 + random.below(4);
        let speed = *random.pick(&[70, 80, 100, 110]);
        let half_median = random.range_f64(HALF_MEDIAN_M[0], HALF_MEDIAN_M[1]);
        let out = half_median + HIGHWAY_LANE_M * lanes as f64 / 2.0 + 1.0;
        let reach = self.half_m.y.max(self.half_m.x);
        let y = reach
            + out
            + HIGHWAY_LANE_M * lanes as f64 / 2.0
            + random.range_f64(HIGHWAY_BEYOND_M[0], HIGHWAY_BEYOND_M[1]);
        let sag = random.range_f64(-60.0, 60.0);
        let border = y + BORDER_M;
        self.layout.border_m = Some(border);
        let at = |k: f64| (k * LONGER * border, y + sag * k * k);
        let middle: Vec<DVec2> = smooth(&[-1.0, -0.5, 0.0, 0.5, 1.0].map(at));
        let middle: Vec<DVec2> = middle.into_iter().map(|p| self.turn.rotate(p)).collect();
        let class = if speed > 80 { "motorway" } else { "trunk" };
        let words = format!("{class} oneway=yes lanes={lanes} sidewalk=no maxspeed={speed}");
        self.layout.road(&words, &beside(&middle, -out));
        let mut back = beside(&middle, out);
        back.reverse();
        self.layout.road(&words, &back);
        let places = self.northwards.clone();
        for &x in places.iter().filter(|_| random.chance(0.4)) {
            let (from, to) = (self.bent(DVec2::new(x, self.half_m.y)), self.turn.rotate(DVec2::new(x, y + OVER_M)));
            let over = from.lerp(to, (y - self.half_m.y) / (y + OVER_M - self.half_m.y));
            let words = "secondary lanes=2 sidewalk=both maxspeed=50";
            self.layout.road_with_bridges(words, &[from, over, to], &[(over, BRIDGE_M)]);
        }
    }

    /// A denser middle, and what is around it.
    fn zones(&mut self, random: &mut Stream) {
        let zone = |layout: &mut TownLayout, size: f64, profile: &ZoneProfile, random: &mut Stream| {
            let outline = rect((0.0, 0.0), (size, size), 0.0);
            layout.zone(outline, profile.kinds, profile.storeys, profile.open * random.range_f64(0.6, 1.6));
        };
        let middle = random.pick(self.region.middle);
        let outside = random.pick(self.region.outside);
        let size = self.half_m.max_element() * random.range_f64(0.8, 1.7);
        zone(&mut self.layout, size, middle, random);
        zone(&mut self.layout, 3000.0, outside, random);
    }
}

/// Places of a grid's lines, around 0, metres.
fn grid_lines(count: usize, random: &mut Stream) -> Vec<f64> {
    let mut lines = vec![0.0];
    for _ in 1..count {
        lines.push(lines[lines.len() - 1] + random.range_f64(66.0, 128.0));
    }
    let half = lines[lines.len() - 1] / 2.0;
    lines.into_iter().map(|x| x - half).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_is_a_town_of_its_own_with_room_for_traffic() {
        let lengths: Vec<f64> = (0..24)
            .map(|number| {
                let (map, _) = make(number);
                let used = map.network.lanes_in_use(&map.network.borders());
                let length = |lane: &endless_road::Lane| lane.centerline.length();
                let usable: f64 = map.network.lanes.iter().filter(|l| used[l.id.index()]).map(length).sum();
                let all: f64 = map.network.lanes.iter().map(length).sum();
                assert!(usable > 0.8 * all && usable > 2000.0, "{number}: {usable:.0} of {all:.0} m");
                all
            })
            .collect();
        assert!(lengths.windows(2).all(|pair| pair[0] != pair[1]));
        assert_eq!(make(3).0.network.lanes.len(), make(3).0.network.lanes.len());
    }

    #[test]
    fn junctions_have_room_between_them() {
        for number in (0..80).chain([950_088, 380_787]) {
            let (map, _) = make(number);
            let lengths = |inside: bool| {
                let lanes = map.network.lanes.iter().filter(move |lane| lane.junction.is_some() == inside);
                lanes.map(|lane| lane.centerline.length())
            };
            let (shortest, longest) = (lengths(false).fold(f64::MAX, f64::min), lengths(true).fold(0.0, f64::max));
            assert!(
                shortest > 8.0 && longest < 90.0,
                "{number}: a street of {shortest:.1} m, a path of {longest:.1} m"
            );
        }
    }

    #[test]
    fn people_can_walk_on_squares() {
        let squares = (0..40).flat_map(|number| {
            let (map, _) = make(number);
            let walk = map.network.walk;
            map.areas.into_iter().filter(|area| area.kind == endless_road::LandUse::Plaza).map(move |area| {
                let on_it = |p: &&glam::DVec3| crate::geometry::inside(&area.outline, p.truncate());
                (number, walk.nodes.iter().filter(on_it).count())
            })
        });
        let (walked, empty): (Vec<_>, Vec<_>) = squares.partition(|square| square.1 > 8);
        assert!(walked.len() > 8 * empty.len(), "{walked:?}, nobody on those of {empty:?}");
    }
}
