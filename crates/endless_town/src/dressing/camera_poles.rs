//! Chooses camera sites and puts up their poles.

use crate::camera::{self, BuildingPrism, CameraSurroundings, HeightField, OpenSpace, PropOcclusion};
use crate::dressing::assembly::{PropPose, TownAssembly};
use endless_asset::Prop;
use endless_road::RoadNetwork;
use endless_world::CameraSite;
use glam::{DVec2, DVec3, Vec3};

/// Height of [`Prop::CameraPole`] as it is made, metres.
const CAMERA_POLE_M: f32 = 6.0;

/// Poles stand further than this from the middle of every lane, metres.
const CLEAR_M: f64 = 1.3;
/// Nor this near to the edge of one beside it.
const EDGE_M: f64 = 0.25;
/// Share of a picture that things near the lens may take.
const MOST_HIDDEN: f32 = 0.03;
/// Lanes this much higher or lower pass over or under.
const OTHER_LEVEL_M: f64 = 2.5;

/// Chooses camera sites among what stands already, and puts up their poles.
pub(crate) fn set_up_cameras(
    assembly: &mut TownAssembly<'_>,
    network: &RoadNetwork,
    relief: &HeightField,
    solids: &[BuildingPrism],
    open: &[OpenSpace],
) -> Vec<CameraSite> {
    let props = PropOcclusion::new(assembly.catalogue, &assembly.placements);
    let surroundings = CameraSurroundings {
        network,
        relief,
        solids,
        open,
        posts: props.posts(),
        parked: assembly.parked.iter().map(|p| p.pose.position).collect(),
    };
    camera::choose(surroundings, &mut |candidate| {
        if props.hide(&candidate.site) > MOST_HIDDEN {
            return false;
        }
        let Some((foot, ground)) = candidate.pole else { return true };
        if blocks_lane(network, foot.extend(ground)) {
            return false;
        }
        let height = f64::from(candidate.site.position[2]) - ground;
        let scale = Vec3::new(1.0, 1.0, (height as f32 + 0.1) / CAMERA_POLE_M);
        let spot = PropPose { z: ground, scale, ..PropPose::new(foot, f64::from(candidate.site.yaw_rad)) };
        assembly.put(Prop::CameraPole, spot, DVec2::splat(0.2), None)
    })
}

/// Whether something drives by so near that a pole would be hit. Lanes that widen or narrow run where the surface
/// alone does not tell.
fn blocks_lane(network: &RoadNetwork, foot: DVec3) -> bool {
    network.lanes.iter().any(|lane| {
        let (s, t) = lane.centerline.project(foot.truncate());
        let nearest = lane.centerline.position(s);
        let distance = nearest.truncate().distance(foot.truncate());
        let beside = distance < t.abs() + 0.1;
        let clear = if beside { CLEAR_M.max(lane.width_m / 2.0 + EDGE_M) } else { CLEAR_M };
        distance < clear && (nearest.z - foot.z).abs() < OTHER_LEVEL_M
    })
}
