//! The score of a view, from rays through its picture and from the places where traffic is expected.

use super::candidate::ViewKind;
use super::height_field::{HeightField, TopSurface};
use super::surroundings::TallProp;
use crate::geometry::unit;
use endless_road::RoadNetwork;
use endless_world::{CameraSite, ImageSize, PinholeCamera};
use glam::{DVec2, Vec3};

/// Pictures are judged at this size.
const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };
/// Rays across and down the picture.
const COLUMNS: u32 = 20;
const ROWS: u32 = 12;
/// Furthest distance at which something is told from the hills, metres.
const REACH_M: f32 = 140.0;
/// A wall nearer than this spoils a view, metres.
const WALL_M: f32 = 4.0;
/// Posts are not seen nearer than this, nor nearer than this in the middle of the picture, metres.
const NEAR_POST_M: f64 = 7.5;
const CENTRAL_POST_M: f64 = 13.0;
/// What lies this high above the road within this distance hides it; land may rise by this slope, metres.
const BRIDGE_HEIGHT_M: f32 = 2.6;
const BRIDGE_M: f32 = 45.0;
const STEEP: f32 = 0.12;
/// Places farther than this are not counted, metres.
const FAR_SPOT_M: f32 = 85.0;
/// The same two for long lenses.
const LONG_REACH_M: f32 = 320.0;
const LONG_SPOT_M: f32 = 220.0;
/// Least share of the picture on road, sidewalk or square.
pub(crate) const LEAST_PAVED: f32 = 0.32;
/// Least share on road or sidewalk.
pub(crate) const LEAST_STREET: f32 = 0.27;

/// Lane outside junctions with which a view counts whole, metres: two lanes for 100 m; and what counts without any.
const MUCH_LANE_M: f32 = 200.0;
const LEAST_LANES: f32 = 0.3;
/// Least weight of places of people in a picture of a square or a park.
const LEAST_PEOPLE: f32 = 2.5;

/// Contents of a picture: shares of its pixels, and expected objects.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct ViewContents {
    pub(crate) road: f32,
    pub(crate) junction: f32,
    pub(crate) walk: f32,
    pub(crate) ground: f32,
    pub(crate) green: f32,
    pub(crate) water: f32,
    pub(crate) solid: f32,
    /// Solid nearer than 10 m.
    pub(crate) solid_near: f32,
    pub(crate) sky: f32,
    /// The same as road and junction, of the picture's lower two thirds.
    pub(crate) paved_low: f32,
    /// Junction in the lowest third.
    pub(crate) junction_low: f32,
    /// Distance of the nearest place on a lane that is seen, metres.
    pub(crate) nearest_m: f32,
    /// Places of vehicles and people by how large they appear: below 32² pixels, up to 96², above.
    pub(crate) sizes: [f32; 3],
    /// Places of people.
    pub(crate) people: f32,
    /// Lane outside junctions, metres.
    pub(crate) lanes_m: f32,
}

impl ViewContents {
    /// Road, sidewalk and square.
    pub(crate) fn paved(&self) -> f32 {
        self.street() + self.ground
    }

    /// Road and sidewalk: yards are no view.
    pub(crate) fn street(&self) -> f32 {
        self.road + self.junction + self.walk
    }
}

/// A place where something is expected.
#[derive(Debug, Clone, Copy)]
struct ExpectedTraffic {
    at: Vec3,
    weight: f32,
    /// Typical width of what is there, metres.
    size: f32,
    person: bool,
    /// Lane outside junctions of which it is the place, metres.
    lane_m: f32,
}

/// Judges sites of one town.
pub(crate) struct ViewScorer<'a> {
    pub(crate) relief: &'a HeightField,
    expected: Vec<ExpectedTraffic>,
    posts: Vec<TallProp>,
    /// Furthest distances of what is told from the hills, and of places that count, metres.
    reach_m: f32,
    far_spot_m: f32,
}

impl<'a> ViewScorer<'a> {
    pub(crate) fn new(network: &RoadNetwork, relief: &'a HeightField, posts: Vec<TallProp>, parked: &[Vec3]) -> Self {
        let mut expected = Vec::new();
        for lane in &network.lanes {
            let busy = (lane.speed_limit_mps as f32 / 11.0).clamp(0.6, 1.4);
            let weight = if lane.junction.is_some() { 0.3 } else { busy };
            let steps = (lane.centerline.length() / 5.0).ceil() as usize;
            let along = (0..steps).map(|i| lane.centerline.at(5.0 * i as f64).position.as_vec3());
            let lane_m = if lane.junction.is_some() { 0.0 } else { 5.0 };
            expected.extend(along.map(|at| ExpectedTraffic { at, weight, size: 2.4, person: false, lane_m }));
        }
        for crossing in &network.crossings {
            let [a, b] = crossing.ends.map(glam::DVec3::as_vec3);
            expected.extend((0..4).map(|i| ExpectedTraffic {
                at: a.lerp(b, i as f32 / 3.0),
                weight: 0.8,
                size: 1.0,
                person: true,
                lane_m: 0.0,
            }));
        }
        let walkers = network.walk.nodes.iter().map(|n| n.as_vec3());
        expected.extend(walkers.map(|at| ExpectedTraffic { at, weight: 0.5, size: 1.0, person: true, lane_m: 0.0 }));
        expected.extend(parked.iter().map(|&at| ExpectedTraffic {
            at,
            weight: 1.2,
            size: 2.4,
            person: false,
            lane_m: 0.0,
        }));
        Self { relief, expected, posts, reach_m: REACH_M, far_spot_m: FAR_SPOT_M }
    }

    /// One that looks further, as long lenses do.
    pub(crate) fn looking_far(self) -> Self {
        Self { reach_m: LONG_REACH_M, far_spot_m: LONG_SPOT_M, ..self }
    }

    /// What a site that is aimed at a level shows; `None` if it stands in something, or something stands close before it.
    pub(crate) fn look(&self, site: &CameraSite, level: f64) -> Option<ViewContents> {
        let camera = PinholeCamera::new(site, SIZE);
        let lens = camera.position;
        let here = lens.truncate().as_dvec2();
        if self.is_enclosed(&camera, here) {
            return None;
        }
        let mut seen = ViewContents::default();
        let share = 1.0 / (COLUMNS * ROWS) as f32;
        for row in 0..ROWS {
            for column in 0..COLUMNS {
                let u = (column as f32 + 0.5) / COLUMNS as f32 * SIZE.width as f32;
                let v = (row as f32 + 0.5) / ROWS as f32 * SIZE.height as f32;
                let k = camera.intrinsics;
                let ray = Vec3::new((u - k.cx) / k.fx, (v - k.cy) / k.fy, 1.0).normalize();
                let direction = (camera.world_from_camera * ray).normalize();
                let hit = self.relief.cast(lens, direction, self.reach_m);
                let (distance, mut top) = hit.unwrap_or((self.reach_m, TopSurface::Beyond));
                // What passes over the road near by is a wall before it.
                let above = lens.z + direction.z * distance - level as f32;
                if distance < BRIDGE_M && above > BRIDGE_HEIGHT_M + STEEP * distance && top != TopSurface::Beyond {
                    top = TopSurface::Solid;
                }
                if top == TopSurface::Solid && distance < WALL_M {
                    return None;
                }
                seen.count(top, distance, direction.z, row, share);
            }
        }
        self.count_spots(&camera, &mut seen);
        Some(seen)
    }

    /// A lamp post or mast right before the lens, or a wall around or close ahead of it.
    fn is_enclosed(&self, camera: &PinholeCamera, here: DVec2) -> bool {
        let forward = camera.world_from_camera.z_axis.truncate().as_dvec2().normalize_or(DVec2::X);
        let post = self.posts.iter().any(|post| {
            let between = post.foot.truncate().as_dvec2() - here;
            let distance = between.length();
            let ahead = forward.dot(between);
            // Within a share of the picture's width around its middle.
            let seen = |share: f32| {
                let aside = (1.0 - share) / 2.0 * SIZE.width as f32;
                (1..=(2.0 * post.height) as u32).any(|k| {
                    camera.project(post.foot + Vec3::Z * (0.5 * k as f32)).is_some_and(|(image, _)| {
                        (aside..SIZE.width as f32 - aside).contains(&image.x)
                            && (0.0..SIZE.height as f32).contains(&image.y)
                    })
                })
            };
            (distance < 1.8 && ahead > -0.3)
                || (distance < NEAR_POST_M && ahead > 0.0 && seen(1.0))
                || (distance < CENTRAL_POST_M && ahead > 0.0 && seen(0.5))
        });
        let lens = camera.position;
        let inside = |p: DVec2| {
            let (z, top) = self.relief.at(p);
            top == TopSurface::Beyond || (top == TopSurface::Solid && z > lens.z - 4.5)
        };
        // All over the field of view, and a little beyond its sides.
        let half = 0.5 * SIZE.width as f32 / camera.intrinsics.fx;
        let half = f64::from(endless_world::math::atan(half)) + 0.1;
        let fan = (-4..=4).any(|i| {
            let ahead = unit(half * f64::from(i) / 4.0).rotate(forward);
            (1..=8).any(|k| inside(here + ahead * (0.5 * f64::from(k))))
        });
        post || inside(here) || fan
    }

    fn count_spots(&self, camera: &PinholeCamera, seen: &mut ViewContents) {
        seen.nearest_m = f32::INFINITY;
        for (_, spot, depth) in self.spots_seen(camera) {
            let pixels = spot.size * camera.intrinsics.fx / depth;
            let class = usize::from(pixels > 32.0) + usize::from(pixels > 96.0);
            seen.sizes[class] += spot.weight;
            seen.lanes_m += spot.lane_m;
            if spot.person {
                seen.people += spot.weight;
            } else {
                seen.nearest_m = seen.nearest_m.min(spot.at.distance(camera.position));
            }
        }
    }

    /// Numbers of the places that a site sees, ascending: the same numbers for all sites.
    pub(crate) fn places_seen(&self, site: &CameraSite) -> Vec<u32> {
        self.spots_seen(&PinholeCamera::new(site, SIZE)).map(|(number, ..)| number).collect()
    }

    /// The places in view and not too far, their numbers and depths.
    fn spots_seen<'s>(
        &'s self,
        camera: &'s PinholeCamera,
    ) -> impl Iterator<Item = (u32, &'s ExpectedTraffic, f32)> + 's {
        const MARGIN: f32 = 20.0;
        (0..).zip(&self.expected).filter_map(move |(number, spot)| {
            if spot.at.distance_squared(camera.position) > self.far_spot_m * self.far_spot_m {
                return None;
            }
            let (image, depth) = camera.project(spot.at + Vec3::Z * 0.7)?;
            let inside = (MARGIN..SIZE.width as f32 - MARGIN).contains(&image.x)
                && (MARGIN..SIZE.height as f32 - MARGIN).contains(&image.y);
            (inside && self.relief.sees(camera.position, spot.at + Vec3::Z * 1.2)).then_some((number, spot, depth))
        })
    }
}

impl ViewContents {
    fn count(&mut self, top: TopSurface, distance: f32, up: f32, row: u32, share: f32) {
        let low = row >= ROWS / 3;
        match top {
            TopSurface::Road => self.road += share,
            TopSurface::Junction => {
                self.junction += share;
                if row >= ROWS * 2 / 3 {
                    self.junction_low += share * 3.0;
                }
            }
            TopSurface::Walk => self.walk += share,
            TopSurface::Ground => self.ground += share,
            TopSurface::Green => self.green += share,
            TopSurface::Water => self.water += share,
            TopSurface::Solid => {
                self.solid += share;
                self.solid_near += if distance < 10.0 { share } else { 0.0 };
            }
            TopSurface::Beyond if up > 0.0 => self.sky += share,
            TopSurface::Beyond => self.green += share,
        }
        if low && matches!(top, TopSurface::Road | TopSurface::Junction | TopSurface::Walk | TopSurface::Ground) {
            self.paved_low += share * 1.5;
        }
    }

    /// Quality from about 0 to 10; `None` for views that must not be used.
    pub(crate) fn quality(&self, view: ViewKind) -> Option<f32> {
        let wall_to_wall = self.solid_near > 0.2;
        let shows_traffic = self.street() > LEAST_STREET && self.nearest_m < 28.0;
        let shows_people = view.is_on_foot() && self.people > LEAST_PEOPLE;
        if self.paved() < LEAST_PAVED || wall_to_wall || !(shows_traffic || shows_people) {
            return None;
        }
        // Each size class counts until there is enough of it.
        let enough = |x: f32, of: f32| (x / of).min(1.0);
        let [small, middle, large] = self.sizes;
        let traffic = 1.2 * enough(small, 6.0) + 2.4 * enough(middle, 16.0) + 2.0 * enough(large, 4.5);
        let people = if view.is_on_foot() { 3.0 } else { 1.2 } * enough(self.people, 8.0);
        let filled = 2.0 * (self.paved_low / 0.75).min(1.0);
        let near = if (7.0..20.0).contains(&self.nearest_m) { 0.6 } else { 0.0 };
        // Some sky or horizon gives depth; much of it wastes the picture.
        let sky = 0.8 * enough(self.sky, 0.06) - 4.0 * (self.sky - 0.2).max(0.0);
        let surroundings = 0.7 * enough(self.solid + 0.4 * self.green, 0.15);
        let walk = 0.8 * enough(self.walk, 0.1);
        let empty = 8.0 * (self.junction_low - 0.2).max(0.0) + 7.0 * (self.junction - 0.22).max(0.0);
        let hidden = 5.0 * self.solid_near + 3.0 * (self.solid - 0.4).max(0.0);
        let whole = traffic + people + filled + near + sky + surroundings + walk - empty - hidden;
        // What sees a glimpse of a street shows little of its traffic.
        let lanes = LEAST_LANES + (1.0 - LEAST_LANES) * enough(self.lanes_m, MUCH_LANE_M);
        Some((whole * lanes).max(0.05))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn more_street_is_worth_more_until_there_is_much() {
        let worth = |lanes_m| {
            let seen =
                ViewContents { road: 0.4, walk: 0.2, nearest_m: 10.0, sizes: [6.0, 16.0, 4.0], ..Default::default() };
            ViewContents { lanes_m, ..seen }.quality(ViewKind::Street).expect("a view of a street")
        };
        let [none, some, much, more] = [0.0, 100.0, MUCH_LANE_M, 2.0 * MUCH_LANE_M].map(worth);
        assert!(none < some && some < much && much == more, "{none} {some} {much} {more}");
        assert!((none / much - LEAST_LANES).abs() < 1e-4, "a glimpse of a street: {none} of {much}");
    }
}
