//! Camera sites on a server's map: places that our dressing of the same roads finds, looked at through the server's eyes.

use super::error::ClientError;
use super::world::World;
use crate::frames;
use endless_asset::Catalogue;
use endless_road::{RoadMap, RoadNetwork};
use endless_town::dress_map;
use endless_world::{CameraSite, ImageSize, PinholeCamera};
use glam::Vec3;

/// Sites that a town gets, as in the paper.
const WANTED: usize = 5;
/// The road is looked at from so near to so far, metres.
const LOOKED_AT_M: [f32; 2] = [6.0, 55.0];
/// Between places that are looked at, metres.
const STEP_M: f64 = 3.0;
/// Most places that are looked at from a site.
const MOST: usize = 24;
/// Of these, the share that must be seen.
const SEEN: f64 = 0.6;
/// Above the road: what stands there is seen, metres.
const ABOVE_M: f32 = 0.8;

/// Sites on the map that a server has loaded.
pub(super) fn sites(
    world: &mut World,
    name: &str,
    map: &RoadMap,
    catalogue: &Catalogue,
) -> Result<Vec<CameraSite>, ClientError> {
    let town = dress_map(name, map, catalogue)
        .map_err(|error| ClientError::Unusable(format!("its map {name} has no places for cameras: {error}")))?;
    let mut found = Vec::new();
    for site in town.cameras {
        if found.len() < WANTED && sees_the_road(world, &site, &map.network)? {
            found.push(site);
        }
    }
    if found.len() < 2 {
        return Err(ClientError::Unusable(format!(
            "its map {name} has {} places from which a camera sees the road: give them with --cameras FILE",
            found.len()
        )));
    }
    Ok(found)
}

/// Whether nothing stands between a site and most of the road before it.
fn sees_the_road(world: &mut World, site: &CameraSite, network: &RoadNetwork) -> Result<bool, ClientError> {
    let places = road_before(site, network);
    if places.is_empty() {
        return Ok(false);
    }
    let eye = Vec3::from_array(site.position);
    let mut seen = 0;
    for place in &places {
        let way = *place - eye;
        let hits = world.cast_ray(&frames::to_carla(eye), &frames::to_carla(*place))?;
        let blocked = hits.iter().any(|hit| frames::from_carla(&hit.location).distance(eye) < 0.97 * way.length());
        seen += usize::from(!blocked);
    }
    Ok(seen as f64 >= SEEN * places.len() as f64)
}

/// Places on lanes in a site's picture, spread over all that it shows.
fn road_before(site: &CameraSite, network: &RoadNetwork) -> Vec<Vec3> {
    let size = ImageSize { width: 1280, height: 720 };
    let camera = PinholeCamera::new(site, size);
    let [near, far] = LOOKED_AT_M;
    let in_picture = |place: &Vec3| {
        let shown = camera.project(*place).is_some_and(|(at, _)| {
            (0.0..size.width as f32).contains(&at.x) && (0.0..size.height as f32).contains(&at.y)
        });
        shown && (near..far).contains(&camera.position.distance(*place))
    };
    let of_lane = |lane: &endless_road::Lane| {
        let count = (lane.centerline.length() / STEP_M) as usize + 1;
        let place = |k: usize| lane.centerline.position(k as f64 * STEP_M).as_vec3() + Vec3::Z * ABOVE_M;
        (0..count).map(place).filter(in_picture).collect::<Vec<_>>()
    };
    let all: Vec<Vec3> = network.lanes.iter().flat_map(of_lane).collect();
    let stride = all.len().div_ceil(MOST).max(1);
    all.into_iter().step_by(stride).collect()
}
