//! Whether a vehicle can carry the sensors of a rig: they look out of its body, not into it.

use endless_render::{FrameScene, Ray, RayCaster, StaticScene};
use endless_world::{Actor, LensModel, PinholeCamera, SceneSensor, SensorModel, SensorMount, carried};
use glam::{Vec3, Vec3A};

/// A sensor is inside a body that it meets in this share of all directions; on a roof, in half of them.
const INSIDE: f32 = 0.8;
/// The largest share of a camera's picture that the body may cover.
const MOST_COVERED: f32 = 0.3;
/// The same of a picture of all directions, half of which are below a roof.
const MOST_COVERED_AROUND: f32 = 0.5;
/// Directions that are asked.
const DIRECTIONS: u32 = 128;
/// Rays of a picture along each axis.
const ACROSS: u32 = 24;

/// The body of one vehicle: the meshes that pictures show, with what it draws and who rides it.
pub(super) struct CarrierBody<'a> {
    nothing: StaticScene,
    actor: &'a Actor,
    drawn: FrameScene,
}

impl<'a> CarrierBody<'a> {
    /// Of an actor that is drawn alone.
    pub(super) fn new(actor: &'a Actor, drawn: FrameScene) -> Self {
        Self { nothing: StaticScene::new(Vec::new(), &[]), actor, drawn }
    }

    /// Whether a sensor that it carries looks out.
    pub(super) fn lets_see(&self, sensor: &SceneSensor) -> bool {
        let SensorMount::Carried { at, .. } = &sensor.mount else { return true };
        if !looks_out(&sensor.model) {
            return true;
        }
        let pose = carried(self.actor, at.position, [at.yaw_rad, at.pitch_rad, at.roll_rad], None);
        if self.met(directions().map(|direction| (pose.position.as_vec3(), direction))) > INSIDE {
            return false;
        }
        sensor.model.camera().is_none_or(|camera| {
            let most = if camera.lens == LensModel::Equirectangular { MOST_COVERED_AROUND } else { MOST_COVERED };
            self.met(picture_rays(&camera.at(&sensor.mount, &pose, 0.0))) <= most
        })
    }

    /// The share of rays, given by origin and unit direction, that meet it; 0 of none.
    fn met(&self, rays: impl Iterator<Item = (Vec3, Vec3)>) -> f32 {
        let caster = RayCaster::new(&self.nothing, &self.drawn);
        let (mut met, mut all) = (0.0, 0.0f32);
        for (origin, direction) in rays {
            let ray = Ray { origin: origin.into(), direction: Vec3A::from(direction), tmax: f32::MAX };
            met += if caster.closest(&ray).is_some() { 1.0 } else { 0.0 };
            all += 1.0;
        }
        met / all.max(1.0)
    }
}

/// Whether a body around it spoils what a sensor measures. A radar looks through the bumper behind which it sits.
pub(super) fn looks_out(model: &SensorModel) -> bool {
    matches!(model, SensorModel::Camera(_) | SensorModel::EventCamera(_) | SensorModel::Lidar(_))
}

/// Evenly all around (a Fibonacci lattice).
fn directions() -> impl Iterator<Item = Vec3> {
    (0..DIRECTIONS).map(|i| {
        let z = 1.0 - (2.0 * i as f32 + 1.0) / DIRECTIONS as f32;
        let (sin, cos) = endless_world::math::sin_cos(i as f32 * 2.399_963_2);
        let level = (1.0 - z * z).sqrt();
        Vec3::new(cos * level, sin * level, z)
    })
}

/// Rays all over a picture, as far as the lens shows anything there.
fn picture_rays(camera: &PinholeCamera) -> impl Iterator<Item = (Vec3, Vec3)> {
    let (width, height) = (camera.size.width as f32, camera.size.height as f32);
    let middle = |i: u32, side: f32| (i as f32 + 0.5) * side / ACROSS as f32;
    let places = (0..ACROSS).flat_map(move |y| (0..ACROSS).map(move |x| (middle(x, width), middle(y, height))));
    places.filter_map(|(x, y)| camera.ray(x, y).map(|ray| (ray.origin, ray.direction)))
}
