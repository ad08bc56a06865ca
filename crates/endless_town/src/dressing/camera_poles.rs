//! Chooses camera sites and puts up their poles.

use crate::camera::{self, BuildingPrism, CameraSurroundings, HeightField, OpenSpace, PropOcclusion};
use crate::dressing::assembly::{PropPose, TownAssembly};
use crate::geometry::unit;
use endless_asset::Prop;
use endless_road::RoadNetwork;
use endless_world::{CameraSite, Mount};
use glam::{DVec2, Vec3};

/// Height of [`Prop::CameraPole`] as it is made, metres.
const CAMERA_POLE_M: f32 = 6.0;

/// Share of a picture that things near the lens may take.
const MOST_HIDDEN: f32 = 0.03;
/// Lenses hang so far before their poles, metres.
const BEHIND_LENS_M: f64 = 0.4;

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
        if camera::blocks_lane(network, foot.extend(ground)) {
            return false;
        }
        let height = f64::from(candidate.site.position[2]) - ground;
        let scale = Vec3::new(1.0, 1.0, (height as f32 + 0.1) / CAMERA_POLE_M);
        let spot = PropPose { z: ground, scale, ..PropPose::new(foot, f64::from(candidate.site.yaw_rad)) };
        assembly.put(Prop::CameraPole, spot, DVec2::splat(0.2), None)
    })
}

/// Puts up the poles of cameras that are given, where there is room: right behind their lenses.
pub(crate) fn put_up_poles(assembly: &mut TownAssembly<'_>, relief: &HeightField, cameras: &[CameraSite]) {
    for camera in cameras.iter().filter(|camera| camera.mount == Mount::Pole) {
        let [x, y, z] = camera.position.map(f64::from);
        let yaw = f64::from(camera.yaw_rad);
        let foot = DVec2::new(x, y) - unit(yaw) * BEHIND_LENS_M;
        let ground = f64::from(relief.at(foot).0);
        let scale = Vec3::new(1.0, 1.0, ((z - ground) as f32 + 0.1).max(0.5) / CAMERA_POLE_M);
        assembly.put(
            Prop::CameraPole,
            PropPose { z: ground, scale, ..PropPose::new(foot, yaw) },
            DVec2::splat(0.2),
            None,
        );
    }
}
