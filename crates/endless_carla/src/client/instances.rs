//! What the ids in instance pictures stand for. CARLA keeps the last 16 bits of an actor's id there, gives ids to all things
//! of its maps, and paints a rider with the id of what they ride; here each object has an id of its own, and stuff none.

use super::body::ActorBody;
use super::boxes::{ROUNDING_M, between, box_on_ground, grown, in_box, is_near};
use super::error::ClientError;
use super::picture::{InstanceKey, Picture};
use super::still::StillObjects;
use crate::instance::instance_id;
use endless_annotate::Box3d;
use endless_world::{Actor, ClassTag, Image, InstanceId, InstancePixel, PinholeCamera, Pose};
use glam::Vec3;
use std::collections::BTreeMap;
use std::ops::Range;

/// How far pixels of an actor may lie beside its box, metres: arms, mirrors, and riders above what they ride.
const BESIDE_M: Vec3 = Vec3::new(1.0, 1.0, 1.3);
/// Of an actor's pixels, the share that may lie farther off: its outline, where depth and instances differ.
const STRAY: f64 = 0.1;
/// Fewer pixels than this say nothing.
const FEW: u32 = 24;

/// An actor that may be seen.
pub(super) struct SeenActor {
    pub(super) body: ActorBody,
    pub(super) id: InstanceId,
    pub(super) rider: Option<InstanceId>,
}

/// The objects of a session.
pub(super) struct InstanceTable {
    /// By the last 16 bits of their ids.
    actors: BTreeMap<u16, SeenActor>,
    stills: BTreeMap<InstanceKey, (InstanceId, Actor)>,
    /// Boxes at this frame: as the server tells them, grown to hold what is seen. CARLA's do not hold arms and legs.
    boxes: BTreeMap<InstanceId, Box3d>,
    objects: StillObjects,
    taken: BTreeMap<InstanceId, ()>,
}

impl InstanceTable {
    /// Of actors, by their ids, among things of a map.
    ///
    /// # Errors
    /// When two of them look alike in pictures.
    pub(super) fn new(bodies: BTreeMap<u32, ActorBody>, objects: StillObjects) -> Result<Self, ClientError> {
        let mut table = Self {
            actors: BTreeMap::new(),
            stills: BTreeMap::new(),
            boxes: BTreeMap::new(),
            objects,
            taken: [(InstanceId::STUFF, ())].into(),
        };
        for (actor, body) in bodies {
            let id = instance_id(actor);
            if table.taken.insert(id, ()).is_some() {
                return Err(ClientError::Unfit(format!(
                    "the id of actor {actor} has the same last 16 bits as another's, so that pictures cannot tell them apart"
                )));
            }
            table.actors.insert(id.0, SeenActor { body, id, rider: None });
        }
        for id in table.actors.keys().copied().collect::<Vec<_>>() {
            if !table.actors[&id].body.is_ridden {
                continue;
            }
            let rider = table.free_id()?;
            if let Some(actor) = table.actors.get_mut(&id) {
                actor.rider = Some(rider);
            }
        }
        Ok(table)
    }

    /// An id that nobody has, from the highest down.
    fn free_id(&mut self) -> Result<InstanceId, ClientError> {
        let free = (1..=u16::MAX).rev().map(InstanceId).find(|id| !self.taken.contains_key(id));
        let id = free.ok_or_else(|| ClientError::Unfit("there are more objects than ids of 16 bits".to_owned()))?;
        self.taken.insert(id, ());
        Ok(id)
    }

    /// An actor of the server.
    pub(super) fn actor(&self, id: u32) -> Option<&SeenActor> {
        self.actors.get(&instance_id(id).0)
    }

    /// Vehicles and people of the map that were seen until now.
    pub(super) fn stills(&self) -> Vec<Actor> {
        self.stills.values().map(|(_, actor)| *actor).collect()
    }

    /// The boxes around all objects at this frame.
    pub(super) fn boxes(&self) -> &BTreeMap<InstanceId, Box3d> {
        &self.boxes
    }

    /// A frame begins at which actors stand so, by the last 16 bits of their ids.
    pub(super) fn begin_frame(&mut self, poses: &BTreeMap<u16, Pose>) {
        for (id, pose) in poses {
            if let Some(actor) = self.actors.get(id) {
                self.boxes.insert(actor.id, actor.body.box3d(pose));
            }
        }
    }

    /// Looks at a picture, and makes sure that actors are where the world has them: what its pixels are that show objects.
    ///
    /// # Errors
    /// When pixels of an actor lie where it is not: ids are used twice, or the picture is of another instant.
    pub(super) fn look(
        &mut self,
        picture: &Picture,
        depth: &Picture,
        camera: &PinholeCamera,
        poses: &BTreeMap<u16, Pose>,
    ) -> Result<SeenObjects, ClientError> {
        let mut places = Places { camera, depth, of_objects: BTreeMap::new(), unknown: BTreeMap::new() };
        let mut seen = SeenObjects::default();
        for (key, run) in picture.runs() {
            if !is_thing(class(key)) {
                continue;
            }
            let (pixel, place) = self.pixel(key, poses);
            match place {
                Place::Object { id, grows } => {
                    if let Some(own) = self.boxes.get(&id) {
                        places.of_object(id, own, run, grows);
                    }
                }
                Place::Unknown => places.of_unknown(key, run),
            }
            seen.0.insert(key, pixel);
        }
        places.judge()?;
        self.boxes.extend(places.grown());
        for (key, points) in std::mem::take(&mut places.unknown) {
            let pixel = self.add_still(key, &points)?;
            seen.0.insert(key, pixel);
        }
        Ok(seen)
    }

    /// What a pixel shows, and what is to be made sure of it.
    fn pixel(&self, key: InstanceKey, poses: &BTreeMap<u16, Pose>) -> (InstancePixel, Place) {
        let tag = class(key);
        if let Some((id, actor)) = self.stills.get(&key) {
            return (InstancePixel { tag: actor.class.tag(), id: *id }, Place::Object { id: *id, grows: true });
        }
        if let Some(actor) = self.actors.get(&key.id).filter(|_| poses.contains_key(&key.id)) {
            let own = InstancePixel { tag: actor.body.class.tag(), id: actor.id };
            return match actor.rider.filter(|_| tag == ClassTag::Rider) {
                Some(rider) => (InstancePixel { tag, id: rider }, Place::Object { id: actor.id, grows: false }),
                None => (own, Place::Object { id: actor.id, grows: true }),
            };
        }
        (InstancePixel { tag, id: InstanceId::STUFF }, Place::Unknown)
    }

    /// Something of the map that is seen for the first time, at these places.
    fn add_still(&mut self, key: InstanceKey, points: &[Vec3]) -> Result<InstancePixel, ClientError> {
        let wanted = InstanceId(key.id);
        let id = if self.taken.insert(wanted, ()).is_none() { wanted } else { self.free_id()? };
        let (actor, size) = self.objects.describe(key.label, id, points);
        self.boxes.insert(id, grown(&box_on_ground(&actor.pose, size), points, BESIDE_M));
        self.stills.insert(key, (id, actor));
        Ok(InstancePixel { tag: actor.class.tag(), id })
    }
}

/// What the pixels of a picture are that show objects.
#[derive(Debug, Default)]
pub(super) struct SeenObjects(BTreeMap<InstanceKey, InstancePixel>);

impl SeenObjects {
    /// What all pixels are.
    pub(super) fn instance(&self, picture: &Picture) -> Image<InstancePixel> {
        let mut data = Vec::with_capacity(picture.size().pixels());
        for (key, run) in picture.runs() {
            let stuff = || InstancePixel { tag: class(key), id: InstanceId::STUFF };
            let pixel = self.0.get(&key).copied().unwrap_or_else(stuff);
            data.extend(std::iter::repeat_n(pixel, run.len()));
        }
        Image { size: picture.size(), data }
    }
}

fn class(key: InstanceKey) -> ClassTag {
    ClassTag::from_value(key.label).unwrap_or(ClassTag::Unlabeled)
}

/// What is to be made sure of a pixel.
enum Place {
    /// It shall lie in the box of this object, or so near that the box grows.
    Object {
        id: InstanceId,
        grows: bool,
    },
    Unknown,
}

/// Whether pixels of a class belong to objects that are annotated.
fn is_thing(tag: ClassTag) -> bool {
    matches!(
        tag,
        ClassTag::Pedestrians
            | ClassTag::Rider
            | ClassTag::Car
            | ClassTag::Truck
            | ClassTag::Bus
            | ClassTag::Motorcycle
            | ClassTag::Bicycle
    )
}

/// Where pixels are in the world.
struct Places<'a> {
    camera: &'a PinholeCamera,
    depth: &'a Picture,
    of_objects: BTreeMap<InstanceId, SeenBox>,
    unknown: BTreeMap<InstanceKey, Vec<Vec3>>,
}

/// A box and its pixels.
struct SeenBox {
    told: Box3d,
    /// Corners of the box in its own frame, which grows.
    low: Vec3,
    high: Vec3,
    pixels: u32,
    /// Of them, those that lie elsewhere.
    elsewhere: u32,
}

impl Places<'_> {
    fn point(&self, at: usize) -> Vec3 {
        let width = self.camera.size.width as usize;
        let (x, y) = ((at % width) as f32 + 0.5, (at / width) as f32 + 0.5);
        let direction = self.camera.ray_through(x, y);
        let forward = self.camera.world_from_camera.z_axis;
        self.camera.position + direction * (self.depth.depth_at(at) / direction.dot(forward))
    }

    fn of_object(&mut self, id: InstanceId, told: &Box3d, run: Range<usize>, grows: bool) {
        let half = 0.5 * told.size;
        let new = SeenBox { told: *told, low: -half, high: half, pixels: 0, elsewhere: 0 };
        let mut seen = self.of_objects.remove(&id).unwrap_or(new);
        seen.pixels += run.len() as u32;
        for at in run {
            let own = in_box(told, self.point(at));
            if !is_near(told, own, BESIDE_M) {
                seen.elsewhere += 1;
            } else if grows {
                (seen.low, seen.high) = (seen.low.min(own - ROUNDING_M), seen.high.max(own + ROUNDING_M));
            }
        }
        self.of_objects.insert(id, seen);
    }

    fn of_unknown(&mut self, key: InstanceKey, run: Range<usize>) {
        const ENOUGH: usize = 4096;
        let known = self.unknown.get(&key).map_or(0, Vec::len);
        let points: Vec<Vec3> = run.take(ENOUGH.saturating_sub(known)).map(|at| self.point(at)).collect();
        self.unknown.entry(key).or_default().extend(points);
    }

    fn judge(&self) -> Result<(), ClientError> {
        let strays = |seen: &SeenBox| seen.pixels >= FEW && f64::from(seen.elsewhere) > STRAY * f64::from(seen.pixels);
        match self.of_objects.iter().find(|(_, seen)| strays(seen)) {
            Some((id, SeenBox { pixels, elsewhere, .. })) => Err(ClientError::Unfit(format!(
                "{elsewhere} of {pixels} pixels with the id {id} lie where no such actor is: the id is used twice, or the \
                 picture is of another instant"
            ))),
            None => Ok(()),
        }
    }

    /// Boxes that hold what is seen.
    fn grown(&self) -> impl Iterator<Item = (InstanceId, Box3d)> {
        self.of_objects.iter().map(|(id, seen)| (*id, between(&seen.told, seen.low, seen.high)))
    }
}
