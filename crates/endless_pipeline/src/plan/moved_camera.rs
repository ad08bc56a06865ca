//! Cameras that hang and look a little otherwise in each video.

use crate::{MapCatalog, SimulatorError};
use endless_world::{CameraSite, LensModel, RandomisedPart, SceneRandomisation, SceneSettings, Stream};

/// Draws of a camera, each nearer to the usual place than the one before: the first that sees enough is taken.
const DRAWS: u64 = 8;

/// Moves the cameras of those scenes of a map that randomise them. A camera of which no draw sees enough stays.
pub(super) fn move_cameras(
    scenes: &mut [&mut SceneSettings],
    map: &str,
    catalog: &dyn MapCatalog,
) -> Result<(), SimulatorError> {
    let mut draws: Vec<[CameraSite; 2]> = Vec::new();
    for scene in scenes.iter() {
        let Some(randomised) = moving(scene) else { continue };
        for (number, camera) in (0..).zip(&scene.cameras) {
            draws.extend((0..DRAWS).map(|draw| [camera.site.clone(), moved(&camera.site, randomised, number, draw)]));
        }
    }
    if draws.is_empty() {
        return Ok(());
    }
    let good = catalog.see_as_well(map, &draws)?;
    let mut chosen = draws.chunks(DRAWS as usize).zip(good.chunks(DRAWS as usize)).map(|(draws, good)| {
        let first = draws.iter().zip(good).find(|(_, good)| **good);
        first.map_or(&draws[0][0], |([_, moved], _)| moved)
    });
    for scene in scenes.iter_mut().filter(|scene| moving(scene).is_some()) {
        let mut usual = Vec::new();
        for (camera, site) in scene.cameras.iter_mut().zip(&mut chosen) {
            usual.push(std::mem::replace(&mut camera.site, site.clone()));
        }
        if let Some(randomised) = &mut scene.randomised {
            randomised.usual_cameras = usual;
        }
    }
    Ok(())
}

/// What a scene randomises, if that moves its cameras.
fn moving(scene: &SceneSettings) -> Option<&SceneRandomisation> {
    scene.randomised.as_ref().filter(|randomised| randomised.varies(RandomisedPart::Camera))
}

/// A draw of a camera of a scene, by its place there.
fn moved(site: &CameraSite, randomised: &SceneRandomisation, camera: u64, draw: u64) -> CameraSite {
    let mut random = Stream::named(randomised.seed, "randomised camera", &[camera, draw]);
    let reach = randomised.strength * (1.0 - draw as f32 / DRAWS as f32);
    let mut within = |most: f32| random.range_f32(-most, most) * reach;
    let [x, y, z] = site.position;
    CameraSite {
        position: [x + within(1.8), y + within(1.8), z + within(1.6)],
        yaw_rad: site.yaw_rad + within(14.0).to_radians(),
        down_tilt_rad: site.down_tilt_rad + within(7.0).to_radians(),
        roll_rad: site.roll_rad + within(5.0).to_radians(),
        horizontal_fov_rad: match site.lens {
            LensModel::Pinhole => (site.horizontal_fov_rad * (1.0 + within(0.22))).min(2.4),
            // A fisheye has the circle that it has.
            _ => site.horizontal_fov_rad,
        },
        ..site.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Plan, resolve_recipe, test_catalog::ThreeTowns};
    use endless_dataset::{Recipe, RecipeDraft};

    fn plan(strength: f64, seed: u64, balance: bool) -> Vec<SceneSettings> {
        let draft = RecipeDraft {
            videos: Some(12),
            seed: Some(seed),
            balance: Some(balance),
            randomise: Some(vec!["camera".into()]),
            randomise_strength: Some(strength),
            ..RecipeDraft::default()
        };
        let recipe: Recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
        Plan::new(&recipe, &ThreeTowns).expect("plannable").scenes
    }

    #[test]
    fn cameras_hang_near_their_sites_and_elsewhere_in_each_video() {
        for balance in [false, true] {
            let (usual, moved) = (plan(0.0, 3, balance), plan(1.0, 3, balance));
            for (usual, moved) in usual.iter().zip(&moved) {
                assert_eq!((&usual.map, usual.weather, usual.seed), (&moved.map, moved.weather, moved.seed));
                let kept = &moved.randomised.as_ref().expect("asked for").usual_cameras;
                assert!(usual.cameras.iter().map(|camera| &camera.site).eq(kept));
                for (a, b) in usual.cameras.iter().zip(&moved.cameras) {
                    assert_eq!(a.site.name, b.site.name);
                    assert!(a.site != b.site && a.look != b.look);
                    let apart = a.site.position.iter().zip(b.site.position).map(|(p, q)| (p - q).abs());
                    assert!(apart.into_iter().all(|m| m <= 1.8));
                    assert!((a.site.yaw_rad - b.site.yaw_rad).abs() < 0.25 && b.site.roll_rad.abs() < 0.09);
                }
            }
            let again = plan(1.0, 3, balance);
            assert_eq!(moved, again);
            assert_ne!(moved, plan(1.0, 4, balance));
        }
    }

    /// Refuses all but what hangs where it did.
    struct Blind;

    impl MapCatalog for Blind {
        fn cameras(&self, map: &str) -> Result<Vec<CameraSite>, SimulatorError> {
            ThreeTowns.cameras(map)
        }

        fn see_as_well(&self, _map: &str, moved: &[[CameraSite; 2]]) -> Result<Vec<bool>, SimulatorError> {
            Ok(vec![false; moved.len()])
        }
    }

    #[test]
    fn a_camera_that_sees_nothing_elsewhere_stays() {
        let draft = RecipeDraft { randomise: Some(vec!["camera".into()]), ..RecipeDraft::default() };
        let recipe = resolve_recipe(draft, &ThreeTowns).expect("valid");
        let sites = |scenes: &[SceneSettings]| -> Vec<CameraSite> {
            scenes.iter().flat_map(|s| s.cameras.iter().map(|c| c.site.clone())).collect()
        };
        let blind = Plan::new(&recipe, &Blind).expect("plannable").scenes;
        let usual = Recipe { randomise: Vec::new(), ..recipe };
        assert_eq!(sites(&blind), sites(&Plan::new(&usual, &ThreeTowns).expect("plannable").scenes));
    }
}
