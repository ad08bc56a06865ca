//! A camera of a scene: three of CARLA's at one place, whose pictures fit each other pixel by pixel.

use super::error::ClientError;
use super::fleet::described;
use super::picture::Picture;
use super::subscription::Subscription;
use super::world::{Snapshot, World};
use crate::frames;
use crate::wire::{ActorDefinition, ActorDescription, Transform};
use endless_world::{CameraSite, ImageSize, PinholeCamera};

/// What is recorded.
const KINDS: [&str; 3] = ["sensor.camera.rgb", "sensor.camera.depth", "sensor.camera.instance_segmentation"];
/// How far off a sensor may say that it is: metres and degrees.
const ROUNDING: f32 = 0.01;

/// A camera of a scene.
pub(super) struct SessionCamera {
    pub(super) camera: PinholeCamera,
    size: ImageSize,
    transform: Transform,
    /// One a sensor.
    streams: Vec<Subscription>,
}

/// Pictures of one instant.
pub(super) struct Pictures {
    pub(super) rgb: Picture,
    pub(super) depth: Picture,
    pub(super) instance: Picture,
}

/// The sensors of a site.
pub(super) fn sensors(
    definitions: &[ActorDefinition],
    site: &CameraSite,
    size: ImageSize,
) -> Result<Vec<(ActorDescription, Transform)>, ClientError> {
    let changed = [
        ("image_size_x", size.width.to_string()),
        ("image_size_y", size.height.to_string()),
        ("fov", site.horizontal_fov_rad.to_degrees().to_string()),
        ("sensor_tick", "0.0".to_owned()),
        // The picture shows one instant, as its labels do.
        ("motion_blur_intensity", "0.0".to_owned()),
        ("lens_flare_intensity", "0.0".to_owned()),
    ];
    let sensor = |id: &&str| {
        let missing = || ClientError::Unusable(format!("it has no {id}, which came with CARLA 0.9.14"));
        let definition = definitions.iter().find(|definition| definition.id == **id).ok_or_else(missing)?;
        Ok((described(definition, &changed), transform(site)))
    };
    KINDS.iter().map(sensor).collect()
}

/// Where a site's camera is.
fn transform(site: &CameraSite) -> Transform {
    let pose = endless_world::Pose {
        position: site.position.into(),
        yaw_rad: site.yaw_rad,
        pitch_rad: -site.down_tilt_rad,
        roll_rad: site.roll_rad,
    };
    frames::transform(&pose)
}

impl SessionCamera {
    /// Listens to the sensors of a site.
    pub(super) fn new(site: &CameraSite, size: ImageSize, streams: Vec<Subscription>) -> Self {
        Self { camera: PinholeCamera::new(site, size), size, transform: transform(site), streams }
    }

    /// The pictures of an instant.
    ///
    /// # Errors
    /// When one is lost, or is not of this instant and place.
    pub(super) fn pictures(&mut self, world: &World, snapshot: &Snapshot) -> Result<Pictures, ClientError> {
        let frame = snapshot.header.frame;
        let wait = world.frame_wait();
        let mut pictures = Vec::with_capacity(KINDS.len());
        for (stream, kind) in self.streams.iter_mut().zip(KINDS) {
            let lost = || ClientError::Unfit(format!("frame {frame} of {kind} was lost"));
            let message = stream.of_frame(frame, &wait)?.ok_or_else(lost)?;
            let header = &message.header;
            let of_another_time = (header.timestamp - snapshot.header.timestamp).abs() > 1e-6;
            if of_another_time || !is_near(&header.transform, &self.transform) {
                return Err(ClientError::Unfit(format!("a picture of {kind} is of another instant or place")));
            }
            pictures.push(Picture::new(message, self.size)?);
        }
        let mut pictures = pictures.into_iter();
        match [(); 3].map(|()| pictures.next()) {
            [Some(rgb), Some(depth), Some(instance)] => Ok(Pictures { rgb, depth, instance }),
            _ => Err(ClientError::Protocol("a camera has three pictures".to_owned())),
        }
    }
}

fn is_near(a: &Transform, b: &Transform) -> bool {
    let turned = |a: f32, b: f32| ((a - b + 180.0).rem_euclid(360.0) - 180.0).abs();
    let (l, m) = (&a.location, &b.location);
    let (r, s) = (&a.rotation, &b.rotation);
    [l.x - m.x, l.y - m.y, l.z - m.z, turned(r.pitch, s.pitch), turned(r.yaw, s.yaw), turned(r.roll, s.roll)]
        .iter()
        .all(|apart| apart.abs() < ROUNDING)
}
