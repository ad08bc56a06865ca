//! The last steps of making any town: cameras on their poles, and everything put together.

use crate::camera::{self, Open, Relief, Scene, Solid, Things};
use crate::dressing::{Spot, Stage};
use crate::{Placement, Town, What};
use endless_asset::Prop;
use endless_road::RoadNetwork;
use endless_scene::Mesh;
use endless_world::CameraSite;
use glam::{Affine3A, DVec2, DVec3, Vec3};

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
    stage: &mut Stage<'_>,
    network: &RoadNetwork,
    relief: &Relief,
    solids: &[Solid],
    open: &[Open],
) -> Vec<CameraSite> {
    let things = Things::new(stage.catalogue, &stage.placements);
    let scene = Scene {
        network,
        relief,
        solids,
        open,
        posts: things.posts(),
        parked: stage.parked.iter().map(|p| p.pose.position).collect(),
    };
    camera::choose(scene, &mut |candidate| {
        if things.hide(&candidate.site) > MOST_HIDDEN {
            return false;
        }
        let Some((foot, ground)) = candidate.pole else { return true };
        if in_the_way(network, foot.extend(ground)) {
            return false;
        }
        let height = f64::from(candidate.site.position[2]) - ground;
        let scale = Vec3::new(1.0, 1.0, (height as f32 + 0.1) / CAMERA_POLE_M);
        let spot = Spot { z: ground, scale, ..Spot::new(foot, f64::from(candidate.site.yaw_rad)) };
        stage.put(Prop::CameraPole, spot, DVec2::splat(0.2), None)
    })
}

/// Whether something drives by so near that a pole would be hit. Lanes that widen or narrow run where the surface
/// alone does not tell.
fn in_the_way(network: &RoadNetwork, foot: DVec3) -> bool {
    network.lanes.iter().any(|lane| {
        let (s, t) = lane.centerline.project(foot.truncate());
        let nearest = lane.centerline.position(s);
        let distance = nearest.truncate().distance(foot.truncate());
        let beside = distance < t.abs() + 0.1;
        let clear = if beside { CLEAR_M.max(lane.width_m / 2.0 + EDGE_M) } else { CLEAR_M };
        distance < clear && (nearest.z - foot.z).abs() < OTHER_LEVEL_M
    })
}

/// A town of its own meshes and of what was put down.
pub(crate) fn assemble(
    name: &str,
    summary: &str,
    network: RoadNetwork,
    own: Vec<(Mesh, Affine3A)>,
    mut stage: Stage<'_>,
    cameras: Vec<CameraSite>,
) -> Town {
    let mut placements: Vec<Placement> = own
        .iter()
        .enumerate()
        .map(|(i, &(_, world_from_object))| Placement { what: What::Own(i as u32), world_from_object, signal: None })
        .collect();
    placements.append(&mut stage.placements);
    Town {
        name: name.to_owned(),
        summary: summary.to_owned(),
        network,
        meshes: own.into_iter().map(|(mesh, _)| mesh.into()).collect(),
        placements,
        parked: stage.parked,
        lamps: stage.lamps,
        cameras,
    }
}
