//! What of a map is looked at: the parts of its lanes and walks that cameras see.

use endless_road::RoadNetwork;
use endless_world::PinholeCamera;
use glam::{DVec3, Vec3};

/// Distance between the places of lanes and walks that are asked for, metres.
pub(crate) const STEP_M: f64 = 5.0;
/// Heights above the ground at which vehicles and people are looked for, metres: one of them must be seen.
const VEHICLE_M: [f64; 2] = [0.7, 1.4];
const PERSON_M: [f64; 2] = [0.9, 1.6];
/// Side of a square as large as what shows of a vehicle and of a person, metres, over the square root of the pixels that
/// they should have in a picture of [`WIDTH_PX`].
const VEHICLE_SHARE: f32 = 0.16;
const PERSON_SHARE: f32 = 0.08;
/// Width of the picture by which it is judged what is too small, pixels. Traffic is the same at all image sizes.
const WIDTH_PX: f32 = 1280.0;
/// Cameras see traffic at least and at most so far, metres.
const RANGE_M: [f32; 2] = [30.0, 170.0];

/// One who looks at the traffic.
#[derive(Debug, Clone, PartialEq)]
pub enum View {
    /// A camera: what its lens shows, as far as things are not too small.
    Camera(PinholeCamera),
    /// Somebody who looks all around.
    Around {
        /// Place in the world, metres.
        center: Vec3,
        /// Metres.
        reach_m: f32,
    },
}

impl View {
    /// A place that is seen all around, 70 m far.
    pub fn around(center: Vec3) -> Self {
        Self::Around { center, reach_m: 70.0 }
    }

    /// Whether it sees a place in the world on which somebody is so large.
    fn sees(&self, at: Vec3, share: f32, clear: &dyn Fn(Vec3, Vec3) -> bool) -> bool {
        match self {
            Self::Around { center, reach_m } => center.truncate().distance(at.truncate()) < *reach_m,
            Self::Camera(camera) => {
                let size = camera.size;
                let shown = camera.project(at).is_some_and(|(image, _)| {
                    (0.0..size.width as f32).contains(&image.x) && (0.0..size.height as f32).contains(&image.y)
                });
                let range = WIDTH_PX * camera.intrinsics.fx / size.width as f32 * share;
                let eye = camera.eye_for(at);
                shown && eye.distance(at) < range.clamp(RANGE_M[0], RANGE_M[1]) && clear(eye, at)
            }
        }
    }
}

/// The parts of a map's lanes and walks that are looked at, and how much of the traffic goes there. By default nothing is,
/// and traffic is spread over the whole map.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Focus {
    /// Share of the vehicles and people who come there, 0 to 1.
    share: f64,
    views: Vec<View>,
    /// By lane and by place, every [`STEP_M`]: a bit for each view that sees it.
    lanes: Vec<Vec<u32>>,
    /// The same of the edges of the walk network.
    walks: Vec<Vec<u32>>,
}

impl Focus {
    /// Views that count; more are left out.
    pub const MOST_VIEWS: usize = 32;

    /// Of these views. `share` of the vehicles and people come to what they see, 0 to 1. `clear` tells whether nothing stands
    /// between a lens and a place (world frame, metres).
    pub fn new(network: &RoadNetwork, views: &[View], share: f64, clear: &dyn Fn(Vec3, Vec3) -> bool) -> Self {
        let views = &views[..views.len().min(Self::MOST_VIEWS)];
        if views.is_empty() || share <= 0.0 {
            return Self::default();
        }
        let bits = |at: DVec3, up: [f64; 2], size: f32| {
            let at = up.map(|up| (at + DVec3::Z * up).as_vec3());
            let sees = |view: &View| at.iter().any(|&at| view.sees(at, size, clear));
            let seen = views.iter().enumerate().filter(|(_, view)| sees(view));
            seen.fold(0, |bits, (view, _)| bits | 1 << view)
        };
        let lane = |lane: &endless_road::Lane| -> Vec<u32> {
            let at = |s| lane.centerline.at(s).position;
            samples(lane.centerline.length()).map(|s| bits(at(s), VEHICLE_M, VEHICLE_SHARE)).collect()
        };
        let walk = |edge: &endless_road::WalkEdge| -> Vec<u32> {
            let [a, b] = edge.nodes.map(|node| network.walk.nodes[node.index()]);
            let length = a.distance(b);
            samples(length).map(|s| bits(a.lerp(b, s / length.max(1e-6)), PERSON_M, PERSON_SHARE)).collect()
        };
        Self {
            share: share.min(1.0),
            views: views.to_vec(),
            lanes: network.lanes.iter().map(lane).collect(),
            walks: network.walk.edges.iter().map(walk).collect(),
        }
    }

    /// Share of the vehicles and people who come there, 0 to 1.
    pub fn share(&self) -> f64 {
        self.share
    }

    /// Numbers of the views.
    pub(crate) fn views(&self) -> std::ops::Range<u32> {
        0..self.views.len() as u32
    }

    /// Whether a place in the world is in some picture, near enough for a vehicle or a person there to have a box, whatever
    /// stands before it.
    pub(crate) fn shows(&self, at: Vec3, on_foot: bool) -> bool {
        let share = if on_foot { PERSON_SHARE } else { VEHICLE_SHARE };
        self.views.iter().any(|view| view.sees(at, share, &|_, _| true))
    }

    /// Metres of lanes and of walks that each view sees.
    pub fn seen_m(&self) -> Vec<[f64; 2]> {
        let metres = |of: &[Vec<u32>], view: u32| {
            STEP_M * of.iter().flatten().filter(|bits| *bits >> view & 1 == 1).count() as f64
        };
        self.views().map(|view| [metres(&self.lanes, view), metres(&self.walks, view)]).collect()
    }

    /// Metres of lanes outside junctions that each view sees: inside, lanes cross, and whoever is on one is on others.
    pub fn roads_seen_m(&self, network: &RoadNetwork) -> Vec<f64> {
        let mut metres = vec![0.0; self.views.len()];
        for lane in network.lanes.iter().filter(|lane| lane.junction.is_none()) {
            let places = self.lane_places(lane.id.index());
            let piece_m = lane.centerline.length() / places.len().max(1) as f64;
            for (view, metres) in metres.iter_mut().enumerate() {
                *metres += piece_m * places.iter().filter(|bits| **bits >> view & 1 == 1).count() as f64;
            }
        }
        metres
    }

    /// The views that see a place of a lane, metres from its beginning, a bit each.
    pub fn on_lane(&self, lane: usize, s: f64) -> u32 {
        self.lanes.get(lane).map_or(0, |bits| nearest(bits, s))
    }

    /// The views that see a place of an edge of the walk network, metres from its first node.
    pub(crate) fn on_walk(&self, edge: usize, along: f64) -> u32 {
        self.walks.get(edge).map_or(0, |bits| nearest(bits, along))
    }

    /// The places of a lane, and the views that see each.
    pub(crate) fn lane_places(&self, lane: usize) -> &[u32] {
        self.lanes.get(lane).map_or(&[], Vec::as_slice)
    }

    /// The places of an edge of the walk network, and the views that see each.
    pub(crate) fn walk_places(&self, edge: usize) -> &[u32] {
        self.walks.get(edge).map_or(&[], Vec::as_slice)
    }
}

/// The middles of equal pieces of about [`STEP_M`].
pub(crate) fn samples(length: f64) -> impl Iterator<Item = f64> {
    let n = (length / STEP_M).ceil().max(1.0) as usize;
    (0..n).map(move |i| length * (i as f64 + 0.5) / n as f64)
}

fn nearest(bits: &[u32], along: f64) -> u32 {
    let place = (along / STEP_M).max(0.0) as usize;
    bits.get(place.min(bits.len().saturating_sub(1))).copied().unwrap_or(0)
}

/// Counts somebody in each of these views.
pub(crate) fn count_in(counts: &mut [f64], views: u32) {
    for (view, count) in counts.iter_mut().enumerate() {
        *count += f64::from(views >> view & 1);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use endless_road::{Lane, LaneId, Polyline};
    use endless_world::{CameraSite, ImageSize, LensModel, Mount};
    use proptest::prelude::*;

    const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };
    const FOV_RAD: f32 = 1.2;

    /// A lane from west to east, from x = −300 m to 300 m.
    fn street() -> RoadNetwork {
        let line = Polyline::new((-30..=30).map(|k| DVec3::new(10.0 * f64::from(k), 0.0, 0.0)));
        RoadNetwork { lanes: vec![Lane::new(LaneId(0), line, 3.5, 13.9)], ..RoadNetwork::default() }
    }

    fn camera(yaw_rad: f32) -> View {
        let site = CameraSite {
            name: "pole".to_owned(),
            position: [0.0, 0.0, 7.0],
            yaw_rad,
            down_tilt_rad: 0.25,
            horizontal_fov_rad: FOV_RAD,
            lens: LensModel::Pinhole,
            mount: Mount::Pole,
            roll_rad: 0.0,
        };
        View::Camera(PinholeCamera::new(&site, SIZE))
    }

    #[test]
    fn lanes_inside_junctions_are_no_road() {
        let mut network = street();
        let focus = Focus::new(&network, &[View::around(Vec3::ZERO)], 1.0, &|_, _| true);
        assert!((focus.roads_seen_m(&network)[0] - 140.0).abs() < 6.0, "{:?}", focus.roads_seen_m(&network));
        network.lanes[0].junction = Some(endless_road::JunctionId(0));
        assert_eq!(focus.roads_seen_m(&network), [0.0]);
    }

    fn seen_at(focus: &Focus) -> Vec<f64> {
        let places = samples(600.0).zip(focus.lane_places(0));
        places.filter(|(_, bits)| **bits != 0).map(|(s, _)| s - 300.0).collect()
    }

    proptest! {
        #[test]
        fn what_is_seen_lies_before_the_camera_and_not_too_far(yaw in -3.1f32..3.1) {
            let seen = seen_at(&Focus::new(&street(), &[camera(yaw)], 1.0, &|_, _| true));
            for x in &seen {
                let off = if *x > 0.0 { yaw.abs() } else { std::f32::consts::PI - yaw.abs() };
                // The corners of the picture look a little further aside.
                prop_assert!(off < 0.5 * FOV_RAD + 0.15, "{x} m, {off} rad aside");
                prop_assert!(x.abs() < f64::from(RANGE_M[1]));
            }
            prop_assert!(yaw.abs() > 0.4 || seen.len() > 15, "{} places", seen.len());
        }
    }

    #[test]
    fn each_view_has_its_bit() {
        let views = [camera(0.0), View::around(Vec3::new(40.0, 5.0, 0.0))];
        let focus = Focus::new(&street(), &views, 0.7, &|_, _| true);
        assert_eq!((focus.share(), focus.views()), (0.7, 0..2));
        assert_eq!([0.0, 340.0, 410.0].map(|s| focus.on_lane(0, s)), [0, 0b11, 0b01]);
        let [[camera_m, _], [around_m, _]] = focus.seen_m()[..] else { panic!("two views") };
        assert!(camera_m > 80.0 && (135.0..=145.0).contains(&around_m), "{camera_m} {around_m}");
    }
}
