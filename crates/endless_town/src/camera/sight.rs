//! What can be seen from a place: lanes, crossings and sidewalks as points, buildings as prisms.

use crate::building::Lot;
use crate::plot::Rect;
use endless_road::RoadNetwork;
use endless_world::{CameraSite, ImageSize, PinholeCamera};
use glam::{DVec2, Vec3};

/// Pictures are judged at this size.
const SIZE: ImageSize = ImageSize { width: 1280, height: 720 };

/// Nearest and furthest distance that counts, metres.
const NEAR_M: f32 = 8.0;
const FAR_M: f32 = 60.0;

/// Points worth seeing, and what hides them.
pub(crate) struct Sights {
    points: Vec<(Vec3, f32)>,
    solids: Vec<(Rect, f64)>,
    posts: Vec<DVec2>,
}

impl Sights {
    pub(crate) fn new(network: &RoadNetwork, lots: &[Lot], posts: Vec<DVec2>) -> Self {
        let mut points = Vec::new();
        for lane in &network.lanes {
            let weight = if lane.junction.is_some() { 0.7 } else { 1.0 };
            let steps = (lane.centerline.length() / 4.0).ceil() as usize;
            let along = (0..steps).map(|i| lane.centerline.at(4.0 * i as f64).position.as_vec3());
            points.extend(along.map(|p| (p, weight)));
        }
        for crossing in &network.crossings {
            let [a, b] = crossing.ends.map(glam::DVec3::as_vec3);
            points.extend((0..5).map(|i| (a.lerp(b, i as f32 / 4.0), 2.5)));
        }
        points.extend(network.walk.nodes.iter().map(|n| (n.as_vec3(), 0.8)));
        // Roofs may rise above the walls; 3 m more is on the safe side.
        let solids = lots.iter().map(|lot| (lot.footprint, 3.8 * f64::from(lot.measures.storeys) + 4.0)).collect();
        Self { points, solids, posts }
    }

    /// How much of the street life a camera sees, nearer counting more; `None` if its view is blocked close by.
    pub(crate) fn score(&self, site: &CameraSite) -> Option<f32> {
        let camera = PinholeCamera::new(site, SIZE);
        let lens = camera.position;
        let here = lens.truncate().as_dvec2();
        let in_picture = |p: Vec3| {
            camera.project(p).is_some_and(|(image, _)| {
                image.x > 0.0 && image.y > 0.0 && image.x < SIZE.width as f32 && image.y < SIZE.height as f32
            })
        };
        // A lamp post or mast right before the lens spoils the picture.
        let blocked = self.posts.iter().any(|&post| {
            let distance = post.distance(here);
            let seen = [3.0, 5.0, 7.0].iter().any(|&z| in_picture(post.as_vec2().extend(z)));
            let ahead = camera.world_from_camera.z_axis.truncate().as_dvec2().dot(post - here) > 0.0;
            (distance < 7.0 && seen) || (distance < 1.8 && ahead)
        });
        if blocked || self.solids.iter().any(|(rect, _)| rect.grown(0.3).contains(here)) {
            return None;
        }
        let near: Vec<&(Rect, f64)> =
            self.solids.iter().filter(|(rect, _)| rect.centre.distance(here) < f64::from(FAR_M) + 25.0).collect();
        let mut total = 0.0;
        for &(point, weight) in &self.points {
            let distance = point.distance(lens);
            if !(NEAR_M..FAR_M).contains(&distance) || !in_picture(point) {
                continue;
            }
            if !near.iter().any(|(rect, height)| hides(rect, *height, lens, point)) {
                total += weight / (1.0 + distance / 20.0);
            }
        }
        Some(total)
    }
}

/// Whether a prism stands between the lens and a point on the ground.
pub(crate) fn hides(rect: &Rect, height: f64, lens: Vec3, point: Vec3) -> bool {
    let (a, b) = (lens.truncate().as_dvec2(), point.truncate().as_dvec2());
    // The part of the ray that is lower than the roof.
    let from_height = ((f64::from(lens.z) - height) / f64::from(lens.z - point.z)).clamp(0.0, 1.0);
    rect.cut_by(a.lerp(b, from_height), b)
}
