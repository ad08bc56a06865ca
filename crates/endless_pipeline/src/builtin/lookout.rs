//! What a scene's cameras see of its streets, so that traffic goes there; and where its people have something to do.

use super::map::BuiltinMap;
use endless_asset::Prop;
use endless_render::{FrameDescription, FrameScene, Ray, RayCaster, StaticScene};
use endless_town::{PlacedObject, Town};
use endless_traffic::{Focus, View};
use endless_world::{CameraSite, ImageSize, PinholeCamera, SceneSettings, SensorMount};
use glam::{Vec3, Vec3A};

/// A ray that ends so near to a place has come to it.
const ARRIVED: f32 = 0.985;

/// The lanes and walks that the cameras of a scene see, where no house, wall or tree stands before them.
pub(super) fn focus(map: &BuiltinMap, settings: &SceneSettings) -> Focus {
    let nobody = settings.vehicles == 0 && settings.pedestrians == 0 && settings.density.is_nothing();
    if nobody || settings.focus == 0.0 {
        return Focus::default();
    }
    let still = map.town_scene.static_scene();
    let empty = FrameScene::new(FrameDescription::default());
    let clear = |eye, at| sees(still, &empty, eye, at);
    Focus::new(map.traffic.network(), &views(settings), settings.focus, &clear)
}

/// All that the cameras of a scene see, whatever share of the traffic comes there.
pub(super) fn sight(map: &BuiltinMap, settings: &SceneSettings) -> Focus {
    focus(map, &SceneSettings { focus: 1.0, ..settings.clone() })
}

fn sees(still: &StaticScene, empty: &FrameScene, eye: Vec3, at: Vec3) -> bool {
    let ray = Ray { origin: eye.into(), direction: Vec3A::from(at - eye), tmax: ARRIVED };
    RayCaster::new(still, empty).closest(&ray).is_none()
}

/// All who look at a scene's traffic and do not move.
fn views(settings: &SceneSettings) -> Vec<View> {
    let camera = |site: &CameraSite, size| View::Camera(PinholeCamera::new(site, judged(size)));
    let cameras = settings.usual_sites().map(|site| camera(site, settings.size));
    let sensors = settings.sensors.iter().filter_map(|sensor| match (&sensor.mount, sensor.fixed_camera()) {
        (SensorMount::Still { .. }, Some(fixed)) => {
            Some(camera(&fixed.site, sensor.model.camera().map_or(settings.size, |camera| camera.size)))
        }
        (SensorMount::Still { at }, None) => Some(View::around(at.origin().as_vec3())),
        _ => None,
    });
    cameras.chain(sensors).collect()
}

/// One size for all pictures of the same shape: the same traffic passes before small and large ones.
fn judged(size: ImageSize) -> ImageSize {
    const WIDTH: u32 = 1280;
    let height = (f64::from(WIDTH) * f64::from(size.height) / f64::from(size.width)).round();
    ImageSize { width: WIDTH, height: (height as u32).max(1) }
}

/// Stops and kiosks and the tables of cafes.
pub(super) fn errands(town: &Town) -> Vec<Vec3> {
    let place = |placement: &endless_town::Placement| match placement.object {
        PlacedObject::Prop(Prop::BusShelter | Prop::Kiosk | Prop::CafeTable, _) => {
            Some(placement.world_from_object.translation.into())
        }
        _ => None,
    };
    town.placements.iter().filter_map(place).collect()
}
