//! The annotations of one frame of one camera: visible objects, joined with their attributes.

use crate::rounding::thousandths;
use crate::{CameraView, ObjectRecord, SceneObjects, VisibleObject, WorldKeypoints};
use endless_world::{ClassTag, ImageSize, InstanceId, ObjectClass};
use glam::Vec3;
use serde::{Deserialize, Serialize};

/// One line of `objects.jsonl`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrameObjects {
    /// Simulation frame.
    pub frame: u32,
    /// Seconds since frame 0.
    pub time_s: f64,
    /// Objects with enough visible pixels, by ascending id.
    pub objects: Vec<ObjectRecord>,
}

impl FrameObjects {
    /// With the keypoints of those whose bodies are known.
    #[must_use]
    pub fn with_keypoints(mut self, bodies: &WorldKeypoints, picture: &CameraView<'_>) -> Self {
        for object in &mut self.objects {
            let Some(body) = bodies.get(&object.id) else { continue };
            let keypoints = picture.keypoints(object.id, &body.body);
            object.num_keypoints = Some(keypoints.labelled());
            object.keypoints = Some(keypoints);
            object.foot_kpts = Some(picture.foot_keypoints(object.id, &body.feet));
            object.keypoints_3d = Some(places(&body.body));
            object.foot_kpts_3d = Some(places(&body.feet));
        }
        self
    }
}

/// World positions, metres.
fn places<const N: usize>(points: &[Vec3; N]) -> Vec<[f64; 3]> {
    points.iter().map(|point| point.to_array().map(thousandths)).collect()
}

/// The instance image shows what the scene does not hold: a fault of the simulator.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum AnnotateError {
    /// Pixels of an id that nothing in the scene has.
    #[error("frame {frame}: the instance image shows id {id}, which no object of the scene has")]
    UnknownId {
        /// Simulation frame.
        frame: u32,
        /// The id.
        id: InstanceId,
    },
    /// Pixels of an object bear another class's tag.
    #[error(
        "frame {frame}: object {id} is a {class}, but its pixels have the tag {} instead of {}",
        actual.name(), class.tag().name()
    )]
    WrongTag {
        /// Simulation frame.
        frame: u32,
        /// The object.
        id: InstanceId,
        /// Its class.
        class: ObjectClass,
        /// A tag that its pixels have.
        actual: ClassTag,
    },
}

/// Joins what an image shows with the objects of the scene; leaves out those with fewer than `min_pixels` pixels.
///
/// # Errors
/// When the image shows an object that the scene does not hold, or under a wrong tag.
pub fn annotate(
    frame: u32,
    time_s: f64,
    visible: &[VisibleObject],
    scene: &SceneObjects,
    size: ImageSize,
    min_pixels: u32,
) -> Result<FrameObjects, AnnotateError> {
    let mut objects = Vec::new();
    for shown in visible {
        let object = scene.find(shown.id).ok_or(AnnotateError::UnknownId { frame, id: shown.id })?;
        if !shown.one_tag || shown.tag != object.class.tag() {
            return Err(AnnotateError::WrongTag { frame, id: shown.id, class: object.class, actual: shown.tag });
        }
        if shown.pixels >= min_pixels {
            let b = shown.bbox;
            let truncated = b.x == 0 || b.y == 0 || b.x + b.w == size.width || b.y + b.h == size.height;
            objects.push(object.record(b, shown.pixels, truncated));
        }
    }
    Ok(FrameObjects { frame, time_s, objects })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{PixelBox, visible_objects};
    use endless_world::{
        Actor, AssetRef, Behaviour, Image, InstancePixel, Motion, Outfit, PersonRef, Pose, VehicleModelId,
        VehicleMotion, VehicleRef, WalkerMotion, WorldState,
    };
    use glam::Vec3;

    const SIZE: ImageSize = ImageSize { width: 8, height: 6 };
    const CAR: AssetRef = AssetRef::Vehicle(VehicleRef { model: VehicleModelId(0), variant: 0 });
    const PERSON: AssetRef = AssetRef::Person(PersonRef { outfit: Outfit::Fair, seed: 0 });

    fn actor(id: u16, rider: Option<u16>, class: ObjectClass) -> Actor {
        let vehicle = class != ObjectClass::Pedestrian;
        Actor {
            id: InstanceId(id),
            rider_id: rider.map(InstanceId),
            class,
            asset: if vehicle { CAR } else { PERSON },
            pose: Pose::level(Vec3::new(1.0, 2.0, 0.0), 0.5),
            velocity_mps: Vec3::new(3.0, 4.0, 0.0),
            motion: if vehicle {
                Motion::Vehicle(VehicleMotion::default())
            } else {
                Motion::Walker(WalkerMotion::default())
            },
            behaviour: Behaviour::default(),
            parked: false,
        }
    }

    fn scene() -> SceneObjects {
        let parked = Actor { parked: true, velocity_mps: Vec3::ZERO, ..actor(1, None, ObjectClass::Car) };
        let actors = vec![actor(5, Some(6), ObjectClass::Motorcycle), actor(7, None, ObjectClass::Pedestrian)];
        SceneObjects::new(&WorldState { frame: 3, time_s: 0.1, actors, signals: Vec::new() }, &[parked])
    }

    fn paint(image: &mut Image<InstancePixel>, id: u16, tag: ClassTag, [x, y, w, h]: [u32; 4]) {
        for row in y..y + h {
            for column in x..x + w {
                image.data[(row * SIZE.width + column) as usize] = InstancePixel { tag, id: InstanceId(id) };
            }
        }
    }

    fn blank() -> Image<InstancePixel> {
        Image::filled(SIZE, InstancePixel { tag: ClassTag::Roads, id: InstanceId::STUFF })
    }

    #[test]
    fn joins_pixels_with_the_scene() {
        let mut image = blank();
        paint(&mut image, 1, ClassTag::Car, [0, 0, 3, 2]);
        paint(&mut image, 6, ClassTag::Rider, [4, 1, 2, 2]);
        paint(&mut image, 5, ClassTag::Motorcycle, [4, 3, 2, 2]);
        paint(&mut image, 7, ClassTag::Pedestrians, [7, 5, 1, 1]);
        let line = annotate(3, 0.1, &visible_objects(&image), &scene(), SIZE, 2).expect("consistent");
        assert_eq!(
            line.objects.iter().map(|o| (o.id.0, o.class, o.pixels, o.truncated, o.parked)).collect::<Vec<_>>(),
            [
                (1, ObjectClass::Car, 6, true, true),
                (5, ObjectClass::Motorcycle, 4, false, false),
                (6, ObjectClass::Rider, 4, false, false),
            ],
            "the pedestrian's single pixel is below the limit"
        );
        assert_eq!(line.objects[1].rider_id, Some(InstanceId(6)));
        assert_eq!(line.objects[2].vehicle_id, Some(InstanceId(5)));
        assert_eq!(line.objects[2].bbox, PixelBox { x: 4, y: 1, w: 2, h: 2 });
        assert_eq!(line.objects[1].speed_mps, 5.0);
        let tones = [(InstanceId(6), 4)].into();
        let line =
            annotate(3, 0.1, &visible_objects(&image), &scene().with_skin_tones(&tones), SIZE, 2).expect("consistent");
        assert_eq!(line.objects.iter().map(|o| o.skin_tone).collect::<Vec<_>>(), [None, None, Some(4)]);
    }

    #[test]
    fn the_line_has_the_contract_s_fields() {
        let mut image = blank();
        paint(&mut image, 7, ClassTag::Pedestrians, [2, 1, 2, 3]);
        let line = annotate(123, 4.1, &visible_objects(&image), &scene(), SIZE, 1).expect("consistent");
        let text = serde_json::to_string(&line).expect("plain data");
        assert!(
            text.starts_with(
                r#"{"frame":123,"time_s":4.1,"objects":[{"id":7,"class":"pedestrian","bbox":[2,1,2,3],"pixels":6,"#
            ),
            "{text}"
        );
        assert_eq!(serde_json::from_str::<FrameObjects>(&text).expect("own output"), line);
    }

    #[test]
    fn refuses_what_the_scene_does_not_hold() {
        let mut image = blank();
        paint(&mut image, 99, ClassTag::Car, [1, 1, 1, 1]);
        let unknown = annotate(3, 0.1, &visible_objects(&image), &scene(), SIZE, 1);
        assert_eq!(unknown, Err(AnnotateError::UnknownId { frame: 3, id: InstanceId(99) }));
        let mut image = blank();
        paint(&mut image, 1, ClassTag::Bus, [1, 1, 1, 1]);
        let wrong = annotate(3, 0.1, &visible_objects(&image), &scene(), SIZE, 1);
        assert_eq!(
            wrong.expect_err("a car is no bus").to_string(),
            "frame 3: object 1 is a car, but its pixels have the tag Bus instead of Car"
        );
    }
}
